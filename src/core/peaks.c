/* Peaks of the continuous history, read from the polynomials of a segment. */
#include <math.h>
#include <string.h>

#include "core/poly.h"
#include "core/run_private.h"

static void raise_peak(struct thud_run *run, struct thud_peak *peak, const double *p, int n, double s_end)
{
    double where;
    double value = thud_poly_peak(p, n, s_end, peak->value, &where);
    if (value > peak->value) {
        peak->value = value;
        peak->time_s = thud_run_now(run) + where * run->seg.h_s;
    }
}

/* Coefficients of a floor's value from those of the modes, out (terms). */
static void floor_polynomial(const struct thud_model_structure *p, int floor, const double *modal, int nmodes,
                             int terms, double *out)
{
    const double *row = p->phi + floor * p->n;
    for (int k = 0; k < terms; k++) {
        const double *x = modal + k * nmodes + p->first;
        double sum = 0;
        for (int j = 0; j < p->n; j++)
            sum += row[j] * x[j];
        out[k] = sum;
    }
}

/* Modal total acceleration q'' + gamma a_g, (terms - 2 x nmodes). */
static void modal_acceleration(const struct thud_run *run, double *out)
{
    const struct thud_model *m = run->model;
    const struct thud_segment *seg = &run->seg;
    double inverse = 1 / (seg->h_s * seg->h_s);
    for (int k = 0; k + 2 < seg->terms; k++) {
        double scale = (k + 1) * (k + 2) * inverse, ground = k == 0 ? seg->a0 : k == 1 ? seg->a1 : 0;
        for (int j = 0; j < m->ndof; j++)
            out[k * m->ndof + j] = scale * seg->q[(k + 2) * m->ndof + j] + m->gamma[j] * ground;
    }
}

enum { DISPLACEMENT, VELOCITY, ACCELERATION, DRIFT, QUANTITIES };

/* How far a value inside the segment may lie above those at its ends, per quantity: s^2/8 times a bound of the second
 * derivative. */
static void margins(const struct thud_run *run, const struct thud_model_structure *p, const double *acceleration,
                    double s_end, double margin[QUANTITIES])
{
    const struct thud_segment *seg = &run->seg;
    int n = run->model->ndof;
    double sum[QUANTITIES] = {0}, eighth = s_end * s_end / 8;
    for (int j = p->first; j < p->first + p->n; j++) {
        double second = 0, third = 0, total = 0;
        for (int k = 2; k < seg->terms; k++) {
            double c = k * (k - 1) * fabs(seg->q[k * n + j]);
            second += c;
            third += (k - 2) * c;
            if (k + 2 < seg->terms)
                total += k * (k - 1) * fabs(acceleration[k * n + j]);
        }
        sum[DISPLACEMENT] += run->shape[j] * second;
        sum[VELOCITY] += run->shape[j] * third / seg->h_s;
        sum[ACCELERATION] += run->shape[j] * total;
        sum[DRIFT] += run->shape[n + j] * second;
    }
    for (int x = 0; x < QUANTITIES; x++)
        margin[x] = sum[x] * eighth;
}

/* Modal q, q' and total acceleration at s, out (3 x nmodes). */
static void modal_values(const struct thud_run *run, const double *acceleration, double s, double *out)
{
    int n = run->model->ndof;
    thud_segment_state(&run->seg, n, s, out, out + n);
    double *a = out + 2 * n;
    memset(a, 0, (size_t)n * sizeof *a);
    for (int k = run->seg.terms - 3; k >= 0; k--)
        for (int j = 0; j < n; j++)
            a[j] = a[j] * s + acceleration[k * n + j];
}

/* A floor's displacement, velocity and acceleration from modal values. */
static void floor_values(const struct thud_model_structure *p, int floor, int nmodes, const double *modal,
                         double out[3])
{
    const double *row = p->phi + floor * p->n;
    out[0] = out[1] = out[2] = 0;
    for (int j = 0; j < p->n; j++) {
        out[DISPLACEMENT] += row[j] * modal[p->first + j];
        out[VELOCITY] += row[j] * modal[nmodes + p->first + j];
        out[ACCELERATION] += row[j] * modal[2 * nmodes + p->first + j];
    }
}

static void floor_peaks(struct thud_run *run, const struct thud_model_structure *p, int floor, int quantity,
                        double s_end, struct thud_peak *peak)
{
    const struct thud_segment *seg = &run->seg;
    double x[THUD_SEGMENT_TERMS], u[THUD_SEGMENT_TERMS];
    int n = seg->terms, nmodes = run->model->ndof;
    if (quantity == ACCELERATION) {
        floor_polynomial(p, floor, run->scratch, nmodes, n - 2, x);
        raise_peak(run, peak, x, n - 2, s_end);
        return;
    }
    floor_polynomial(p, floor, seg->q, nmodes, n, x);
    if (quantity == VELOCITY)
        for (int k = 0; k + 1 < n; k++)
            x[k] = (k + 1) / seg->h_s * x[k + 1];
    if (quantity == DRIFT && floor > 0) {
        floor_polynomial(p, floor - 1, seg->q, nmodes, n, u);
        for (int k = 0; k < n; k++)
            x[k] -= u[k];
    }
    raise_peak(run, peak, x, quantity == VELOCITY ? n - 1 : n, s_end);
}

static void structure_peaks(struct thud_run *run, int index, double s_end, const double *start, const double *end)
{
    const struct thud_model_structure *p = &run->model->structure[index];
    double margin[QUANTITIES], a[QUANTITIES], b[QUANTITIES], a_below = 0, b_below = 0;
    int nmodes = run->model->ndof;
    margins(run, p, run->scratch, s_end, margin);
    for (int i = 0; i < p->n; i++) {
        struct thud_floor_result *r = &run->result.structure[index].floor[i];
        struct thud_peak *peak[QUANTITIES] = {&r->displacement, &r->velocity, &r->acceleration, &r->drift};
        floor_values(p, i, nmodes, start, a);
        floor_values(p, i, nmodes, end, b);
        a[DRIFT] = a[DISPLACEMENT] - a_below;
        b[DRIFT] = b[DISPLACEMENT] - b_below;
        a_below = a[DISPLACEMENT];
        b_below = b[DISPLACEMENT];
        for (int x = 0; x < (p->stiffness_npm ? QUANTITIES : DRIFT); x++) {
            double least = peak[x]->value - margin[x];
            if (fabs(a[x]) > least || fabs(b[x]) > least)
                floor_peaks(run, p, i, x, s_end, peak[x]);
        }
    }
}

static void contact_peaks(struct thud_run *run, int c, double s_end)
{
    const struct thud_segment *seg = &run->seg;
    struct thud_contact_state *s = &run->contact[c];
    struct thud_contact_result *result = &run->result.contact[c];
    double p[THUD_SEGMENT_TERMS], where = 0;
    if (s->mode == THUD_OPEN)
        return;
    const double *d = run->indentation + c * THUD_SEGMENT_TERMS;
    raise_peak(run, &result->indentation, d, seg->terms, s_end);
    s->impact.indentation_m = thud_poly_peak(d, seg->terms, s_end, s->impact.indentation_m, &where);
    if (!thud_contact_acts(s))
        return;
    for (int k = 0; k < seg->terms; k++)
        p[k] = seg->force[k * run->model->ncontacts + c];
    raise_peak(run, &result->force, p, seg->terms, s_end);
    s->impact.force_n = thud_poly_peak(p, seg->terms, s_end, s->impact.force_n, &where);
}

void thud_peaks_start(struct thud_run *run)
{
    const struct thud_model *m = run->model;
    for (int s = 0; s < m->nstructures; s++) {
        const struct thud_model_structure *p = &m->structure[s];
        for (int j = 0; j < p->n; j++) {
            double most = 0, drift = 0;
            for (int i = 0; i < p->n; i++) {
                double below = i > 0 ? p->phi[(i - 1) * p->n + j] : 0;
                most = fmax(most, fabs(p->phi[i * p->n + j]));
                drift = fmax(drift, fabs(p->phi[i * p->n + j] - below));
            }
            run->shape[p->first + j] = most;
            run->shape[m->ndof + p->first + j] = drift;
        }
    }
}

void thud_peaks_motion(struct thud_run *run, double s)
{
    double *start = run->ends, *end = start + 3 * run->model->ndof;
    modal_acceleration(run, run->scratch);
    modal_values(run, run->scratch, 0, start);
    modal_values(run, run->scratch, s, end);
    for (int i = 0; i < run->model->nstructures; i++)
        structure_peaks(run, i, s, start, end);
}

void thud_peaks_segment(struct thud_run *run, double s)
{
    thud_peaks_motion(run, s);
    for (int c = 0; c < run->model->ncontacts; c++)
        contact_peaks(run, c, s);
}
