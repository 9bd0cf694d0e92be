/* Peaks of the continuous history, read from the polynomials of a segment. */
#include <math.h>
#include <string.h>

#include "core/double_pair.h"
#include "core/poly.h"
#include "core/run_private.h"

static void raise_peak(struct thud_run *run, struct thud_peak *peak, const double *p, int n, double s_end)
{
    double where;
    double value = thud_poly_peak(p, n, s_end, peak->value, &where);
    if (value > peak->value) {
        peak->value = value;
        peak->time_s = thud_state_now(&run->state) + where * run->seg.h_s;
    }
}

/* Coefficients of a floor's value from those of the modes, out (terms). */
static void floor_polynomial(const struct thud_model_structure *p, int floor, const double *modal, int nmodes,
                             int terms, double *out)
{
    const double *row = p->phi + floor * p->modes;
    for (int k = 0; k < terms; k++)
        out[k] = thud_dot(p->modes, row, modal + k * nmodes + p->first_mode);
}

struct thud_peak *thud_floor_peak(struct thud_run *run, int structure, int floor, int quantity)
{
    struct thud_floor_result *r = &run->result.structure[structure].floor[floor];
    struct thud_peak *peak[] = {&r->displacement, &r->velocity, &r->acceleration, &r->drift};
    return peak[quantity];
}

/* The same from the equations of motion: the polynomials of a stepping method have the state that the method gives, but
 * their second derivative strays between the ends of the step by as much as the acceleration changes in it. */
static void acceleration_by_forces(struct thud_run *run)
{
    const struct thud_model *m = run->state.model;
    const struct thud_segment *seg = &run->seg;
    int n = m->nmodes;
    for (int k = 0; k + 2 < seg->terms; k++) {
        double *out = run->scratch + k * n, rate = (k + 1) / seg->h_s, *qd = run->scratch + seg->terms * n;
        for (int j = 0; j < n; j++)
            qd[j] = rate * seg->q[(k + 1) * n + j];
        thud_model_acceleration(m, seg->q + k * n, qd, 0, out);
        thud_model_apply_contact_forces(m, seg->force + k * m->ncontacts, out);
    }
}

void thud_peaks_prepare(struct thud_run *run)
{
    if (run->method->order > 0) {
        acceleration_by_forces(run);
        return;
    }
    double *out = run->scratch;
    const struct thud_model *m = run->state.model;
    const struct thud_segment *seg = &run->seg;
    double inverse = 1 / (seg->h_s * seg->h_s);
    for (int k = 0; k + 2 < seg->terms; k++) {
        double scale = (k + 1) * (k + 2) * inverse, ground = k == 0 ? seg->a0 : k == 1 ? seg->a1 : 0;
        for (int j = 0; j < m->nmodes; j++)
            out[k * m->nmodes + j] = scale * seg->q[(k + 2) * m->nmodes + j] + m->gamma[j] * ground;
    }
}

/* Bounds of the second derivatives of each mode's displacement, velocity and acceleration in the segment, times s^2/8:
 * how far a value inside may lie above those at its ends. out (3 x nmodes). */
static void modal_margins(const struct thud_run *run, const double *acceleration, double s_end, double *out)
{
    const struct thud_segment *seg = &run->seg;
    int n = run->state.model->nmodes;
    double eighth = s_end * s_end / 8;
    memset(out, 0, 3 * (size_t)n * sizeof *out);
    for (int k = 2; k < seg->terms; k++) {
        double second = k * (k - 1) * eighth, third = (k - 2) * second / seg->h_s;
        const double *q = seg->q + k * n, *a = acceleration + k * n;
        for (int j = 0; j < n; j++) {
            double size = fabs(q[j]);
            out[j] += second * size;
            out[n + j] += third * size;
        }
        for (int j = 0; j < n && k + 2 < seg->terms; j++)
            out[2 * n + j] += second * fabs(a[j]);
    }
}

/* The same for the structure's worst floor. */
static void structure_margins(const struct thud_run *run, const struct thud_model_structure *p, const double *modal,
                              double margin[THUD_FLOOR_QUANTITIES])
{
    int n = run->state.model->nmodes;
    double sum[THUD_FLOOR_QUANTITIES] = {0};
    for (int j = p->first_mode; j < p->first_mode + p->modes; j++) {
        sum[THUD_FLOOR_DISPLACEMENT] += run->bounds.mode_max[j] * modal[j];
        sum[THUD_FLOOR_VELOCITY] += run->bounds.mode_max[j] * modal[n + j];
        sum[THUD_FLOOR_ACCELERATION] += run->bounds.mode_max[j] * modal[2 * n + j];
        sum[THUD_FLOOR_DRIFT] += run->bounds.mode_max[n + j] * modal[j];
    }
    memcpy(margin, sum, sizeof sum);
}

/* The same for one floor. */
static double floor_margin(const struct thud_model_structure *p, int floor, int quantity, int nmodes,
                           const double *modal)
{
    const double *row = p->phi + floor * p->modes,
                 *below = floor > 0 && quantity == THUD_FLOOR_DRIFT ? row - p->modes : NULL;
    const double *b = modal + (quantity == THUD_FLOOR_DRIFT ? 0 : quantity) * nmodes + p->first_mode;
    double sum = 0;
    for (int j = 0; j < p->modes; j++)
        sum += fabs(row[j] - (below ? below[j] : 0)) * b[j];
    return sum;
}

/* Modal total acceleration at s, out (nmodes). */
static void modal_acceleration(const struct thud_run *run, const double *acceleration, double s, double *out)
{
    int n = run->state.model->nmodes;
    memset(out, 0, (size_t)n * sizeof *out);
    for (int k = run->seg.terms - 3; k >= 0; k--)
        for (int j = 0; j < n; j++)
            out[j] = out[j] * s + acceleration[k * n + j];
}

/* A floor's displacement, velocity and acceleration at both ends of the segment, from modal values: six sums over one
 * row. */
static void floor_values(const struct thud_model_structure *p, int floor, int nmodes, const double *start,
                         const double *end, double a[3], double b[3])
{
    enum { N = THUD_FLOOR_ACCELERATION + 1 };
    const double *row = p->phi + floor * p->modes;
    thud_pair sum[2 * N] = {0};
    int j = 0;
    for (; j + 2 <= p->modes; j += 2)
        for (int x = 0; x < N; x++) {
            sum[x] += thud_pair_at(row + j) * thud_pair_at(start + x * nmodes + p->first_mode + j);
            sum[N + x] += thud_pair_at(row + j) * thud_pair_at(end + x * nmodes + p->first_mode + j);
        }
    for (int x = 0; x < N; x++) {
        a[x] = sum[x][0] + sum[x][1];
        b[x] = sum[N + x][0] + sum[N + x][1];
        if (j < p->modes) {
            a[x] += row[j] * start[x * nmodes + p->first_mode + j];
            b[x] += row[j] * end[x * nmodes + p->first_mode + j];
        }
    }
}

void thud_peaks_floor(struct thud_run *run, int structure, int floor, int quantity, double s_end)
{
    const struct thud_segment *seg = &run->seg;
    const struct thud_model_structure *p = &run->state.model->structure[structure];
    struct thud_peak *peak = thud_floor_peak(run, structure, floor, quantity);
    double x[THUD_SEGMENT_TERMS] = {0}, u[THUD_SEGMENT_TERMS] = {0};
    int n = seg->terms, nmodes = run->state.model->nmodes;
    if (quantity == THUD_FLOOR_ACCELERATION) {
        floor_polynomial(p, floor, run->scratch, nmodes, n - 2, x);
        raise_peak(run, peak, x, n - 2, s_end);
        return;
    }
    floor_polynomial(p, floor, seg->q, nmodes, n, x);
    if (quantity == THUD_FLOOR_VELOCITY)
        for (int k = 0; k + 1 < n; k++)
            x[k] = (k + 1) / seg->h_s * x[k + 1];
    if (quantity == THUD_FLOOR_DRIFT && floor > 0) {
        floor_polynomial(p, floor - 1, seg->q, nmodes, n, u);
        for (int k = 0; k < n; k++)
            x[k] -= u[k];
    }
    raise_peak(run, peak, x, quantity == THUD_FLOOR_VELOCITY ? n - 1 : n, s_end);
}

static void structure_peaks(struct thud_run *run, int index, double s_end, const struct thud_response_bound *reach,
                            const double *start, const double *end, const double *modal)
{
    const struct thud_model_structure *p = &run->state.model->structure[index];
    double margin[THUD_FLOOR_QUANTITIES], a[THUD_FLOOR_QUANTITIES], b[THUD_FLOOR_QUANTITIES], a_below = 0, b_below = 0;
    int nmodes = run->state.model->nmodes, below = -1; /* the floor whose displacements a_below and b_below are */
    structure_margins(run, p, modal, margin);
    for (int i = 0; i < p->n; i++) {
        if (!thud_response_bound_floor(run, index, i, reach))
            continue;
        if (below != i - 1) {
            floor_values(p, i - 1, nmodes, start, end, a, b);
            a_below = a[THUD_FLOOR_DISPLACEMENT];
            b_below = b[THUD_FLOOR_DISPLACEMENT];
        }
        floor_values(p, i, nmodes, start, end, a, b);
        a[THUD_FLOOR_DRIFT] = a[THUD_FLOOR_DISPLACEMENT] - a_below;
        b[THUD_FLOOR_DRIFT] = b[THUD_FLOOR_DISPLACEMENT] - b_below;
        a_below = a[THUD_FLOOR_DISPLACEMENT];
        b_below = b[THUD_FLOOR_DISPLACEMENT];
        below = i;
        for (int x = 0; x < (p->stiffness_npm ? THUD_FLOOR_QUANTITIES : THUD_FLOOR_DRIFT); x++) {
            double end_value = fmax(fabs(a[x]), fabs(b[x]));
            double peak = thud_floor_peak(run, index, i, x)->value;
            if (end_value + margin[x] > peak && end_value + floor_margin(p, i, x, nmodes, modal) > peak)
                thud_peaks_floor(run, index, i, x, s_end);
        }
    }
}

/* Raises the largest value of the impact that goes on, and with it that of the contact. */
static void raise_contact_peak(struct thud_run *run, struct thud_peak *peak, double *of_impact, const double *p,
                               double s_end)
{
    double where = 0;
    *of_impact = thud_poly_peak(p, run->seg.terms, s_end, *of_impact, &where);
    if (*of_impact > peak->value)
        *peak = (struct thud_peak){*of_impact, thud_state_now(&run->state) + where * run->seg.h_s};
}

static void indentation_peak(struct thud_run *run, int c, double s_end)
{
    const struct thud_segment *seg = &run->seg;
    struct thud_impact *impact = &run->state.contact[c].impact;
    struct thud_peak *peak = &run->result.contact[c].indentation;
    const double *d = run->seg.indentation + c * THUD_SEGMENT_TERMS;
    if (run->state.locates) {
        raise_contact_peak(run, peak, &impact->indentation_m, d, s_end);
        return;
    }
    for (int end = 0; end <= 1; end++) { /* the step may reach far out of contact, to the other side of 0 */
        double value = thud_poly_value(d, seg->terms, end * s_end);
        impact->indentation_m = fmax(impact->indentation_m, value);
        if (value > peak->value)
            *peak = (struct thud_peak){value, thud_state_now(&run->state) + end * s_end * seg->h_s};
    }
}

static void contact_peaks(struct thud_run *run, int c, double s_end)
{
    const struct thud_segment *seg = &run->seg;
    struct thud_contact_state *s = &run->state.contact[c];
    double p[THUD_SEGMENT_TERMS];
    if (s->mode != THUD_OPEN)
        indentation_peak(run, c, s_end);
    if (!thud_segment_has_force(&run->state, &run->seg, c))
        return;
    for (int k = 0; k < seg->terms; k++)
        p[k] = seg->force[k * run->state.model->ncontacts + c];
    raise_contact_peak(run, &run->result.contact[c].force, &s->impact.force_n, p, s_end);
    s->largest_force_n = run->result.contact[c].force.value;
}

void thud_peaks_start(struct thud_run *run)
{
    const struct thud_model *m = run->state.model;
    thud_response_bound_start(run);
    for (int s = 0; s < m->nstructures; s++) {
        const struct thud_model_structure *p = &m->structure[s];
        for (int j = 0; j < p->modes; j++) {
            double most = 0, drift = 0;
            for (int i = 0; i < p->n; i++) {
                double below = i > 0 ? p->phi[(i - 1) * p->modes + j] : 0;
                most = fmax(most, fabs(p->phi[i * p->modes + j]));
                drift = fmax(drift, fabs(p->phi[i * p->modes + j] - below));
            }
            run->bounds.mode_max[p->first_mode + j] = most;
            run->bounds.mode_max[m->nmodes + p->first_mode + j] = drift;
        }
    }
}

/* Peaks of the structures that may have one. Modal values at the end are there already, but for the acceleration. */
static void motion_peaks(struct thud_run *run, double s)
{
    const struct thud_model *m = run->state.model;
    size_t n = (size_t)m->nmodes;
    double *start = run->bounds.ends, *end = start + 3 * n, *modal = end + 3 * n;
    bool prepared = false;
    for (int i = 0; i < m->nstructures; i++) {
        struct thud_response_bound reach = thud_response_bound_segment(run, i, s);
        if (!thud_response_bound_structure(run, i, &reach))
            continue;
        if (!prepared) {
            thud_peaks_prepare(run);
            memcpy(start, run->state.q, n * sizeof *start);
            memcpy(start + n, run->state.qd, n * sizeof *start);
            memcpy(start + 2 * n, run->scratch, n * sizeof *start);
            modal_acceleration(run, run->scratch, s, end + 2 * n);
            modal_margins(run, run->scratch, s, modal);
            prepared = true;
        }
        structure_peaks(run, i, s, &reach, start, end, modal);
    }
}

void thud_peaks_segment(struct thud_run *run, double s)
{
    motion_peaks(run, s);
    for (int c = 0; c < run->state.model->ncontacts; c++)
        contact_peaks(run, c, s);
}
