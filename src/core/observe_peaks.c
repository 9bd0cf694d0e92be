#include "core/observe_peaks.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/double_pair.h"
#include "core/free_vibration.h"
#include "core/largest.h"
#include "core/poly.h"

/* What a structure's energy lets its floors come to at most: where that is below the peaks so far, no floor needs to be
 * looked at. With S = sqrt(sum of q'^2 + omega^2 q^2), whatever the damping, dS/dt is at most the size of the forces in
 * modal coordinates; and by Cauchy and Schwarz a floor's value is at most S times a number of its own. */

/* Largest factor by which damping may raise the sum of spring and damping forces over that of the springs. */
static double damping_factor(const struct thud_model *m, const struct thud_model_structure *p, int j)
{
    double ratio = 2 * m->zeta[p->first_mode + j], sum = 0;
    for (int i = 0; p->damping && i < p->modes; i++)
        for (int k = 0; k < p->modes; k++)
            sum += p->damping[i * p->modes + k] * p->damping[i * p->modes + k];
    return sqrt(1 + ratio * ratio) + (sum > 0 ? sqrt(sum) / m->omega[p->first_mode + j] : 0);
}

/* Fills peaks->per_speed. */
static void fill_response_bounds(struct thud_peaks *peaks, const struct thud_state *state)
{
    const struct thud_model *m = state->model;
    for (int s = 0; s < m->nstructures; s++) {
        const struct thud_model_structure *p = &m->structure[s];
        for (int i = 0; i < p->n; i++) {
            double sum[THUD_FLOOR_QUANTITIES] = {0};
            for (int j = 0; j < p->modes; j++) {
                double a = p->phi[i * p->modes + j], below = i > 0 ? p->phi[(i - 1) * p->modes + j] : 0;
                double w = m->omega[p->first_mode + j], f = damping_factor(m, p, j) * w;
                sum[THUD_FLOOR_DISPLACEMENT] += a * a / (w * w);
                sum[THUD_FLOOR_VELOCITY] += a * a;
                sum[THUD_FLOOR_ACCELERATION] += a * a * f * f;
                sum[THUD_FLOOR_DRIFT] += p->stiffness_npm ? (a - below) * (a - below) / (w * w) : 0;
            }
            for (int x = 0; x < THUD_FLOOR_QUANTITIES; x++)
                peaks->per_speed[x * m->ndof + p->first + i] = sqrt(sum[x]);
        }
    }
}

/* Whether a floor, and whether any floor of the structure, may then pass a peak. */
static bool may_pass(struct thud_peaks *peaks, const struct thud_model *model, int structure, int floor,
                     const struct thud_response_bound *reach)
{
    const struct thud_model *m = model;
    const struct thud_floor_result *r = &peaks->result->structure[structure].floor[floor];
    const double *most = peaks->per_speed + m->structure[structure].first + floor;
    double push = most[THUD_FLOOR_VELOCITY * m->ndof] * reach->force;
    bool below = most[THUD_FLOOR_DISPLACEMENT * m->ndof] * reach->speed <= r->displacement.value &&
                 most[THUD_FLOOR_VELOCITY * m->ndof] * reach->speed <= r->velocity.value &&
                 most[THUD_FLOOR_ACCELERATION * m->ndof] * reach->speed + push <= r->acceleration.value &&
                 most[THUD_FLOOR_DRIFT * m->ndof] * reach->speed <= r->drift.value;
    return !below; /* NaN: a rigid body, whose place no energy bounds */
}

bool thud_response_bound_structure(struct thud_peaks *peaks, const struct thud_model *model, int structure,
                                   const struct thud_response_bound *reach)
{
    for (int i = 0; i < model->structure[structure].n; i++)
        if (may_pass(peaks, model, structure, i, reach))
            return true;
    return false;
}

/* Size of the contact forces on the structure in modal coordinates, at most, over the segment: a force on a floor of
 * mass m is force/sqrt(m) there. */
static double largest_force(struct thud_peaks *peaks, const struct thud_state *state, const struct thud_segment *seg,
                            const struct thud_model_structure *p)
{
    const struct thud_model *m = state->model;
    double total = 0;
    for (int c = 0; c < m->nrows; c++) {
        const struct thud_model_contact *contact = &m->contact[c];
        if (c < m->ncontacts && !thud_contact_acts(&state->contact[c]))
            continue;
        double force = 0;
        for (int k = 0; k < seg->loaded; k++)
            force += fabs(seg->force[k * m->nrows + c]);
        for (int side = 0; side < 2; side++) {
            const struct thud_model_side *at = side == 0 ? &contact->left : &contact->right;
            const double *per_speed = peaks->per_speed + THUD_FLOOR_VELOCITY * m->ndof;
            if (at->dof < p->first || at->dof >= p->first + p->n)
                continue;
            total += at->share * per_speed[at->dof] * force;
            total += at->below < 0 ? 0 : (1 - at->share) * per_speed[at->below] * force;
        }
    }
    return total;
}

/* In the segment up to s; without bound for methods whose steps do not keep to the equations of motion. */
static struct thud_response_bound bound_of_segment(struct thud_peaks *peaks, const struct thud_state *state,
                                                   const struct thud_segment *seg, int structure, double s)
{
    const struct thud_model *m = state->model;
    const struct thud_model_structure *p = &m->structure[structure];
    if (seg->interpolates)
        return (struct thud_response_bound){INFINITY, INFINITY};
    double energy = 0, gamma = 0, force = largest_force(peaks, state, seg, p);
    for (int j = p->first_mode; j < p->first_mode + p->modes; j++) {
        energy += state->qd[j] * state->qd[j] + m->omega[j] * m->omega[j] * state->q[j] * state->q[j];
        gamma += m->gamma[j] * m->gamma[j];
    }
    double ground = fmax(fabs(seg->a0), fabs(seg->a0 + seg->a1)) * sqrt(gamma);
    return (struct thud_response_bound){sqrt(energy) + s * seg->h_s * (ground + force), force};
}

/* Peaks of the continuous history, read from the polynomials of a segment. */

static void raise_peak(const struct thud_segment *seg, struct thud_peak *peak, const double *p, int n, double s_end)
{
    double where;
    double value = thud_poly_peak(p, n, s_end, peak->value, &where);
    if (value > peak->value) {
        peak->value = value;
        peak->time_s = seg->start_s + where * seg->h_s;
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

struct thud_peak *thud_floor_peak(struct thud_result *result, int structure, int floor, int quantity)
{
    struct thud_floor_result *r = &result->structure[structure].floor[floor];
    struct thud_peak *peak[] = {&r->displacement, &r->velocity, &r->acceleration, &r->drift};
    return peak[quantity];
}

/* The same from the equations of motion: the polynomials of a stepping method have the state that the method gives, but
 * their second derivative strays between the ends of the step by as much as the acceleration changes in it. */
static void acceleration_by_forces(struct thud_peaks *peaks, const struct thud_state *state,
                                   const struct thud_segment *seg)
{
    const struct thud_model *m = state->model;
    int n = m->nmodes;
    for (int k = 0; k + 2 < seg->terms; k++) {
        double *out = peaks->acceleration + k * n, rate = (k + 1) / seg->h_s,
               *qd = peaks->acceleration + seg->terms * n;
        for (int j = 0; j < n; j++)
            qd[j] = rate * seg->q[(k + 1) * n + j];
        thud_model_acceleration(m, seg->q + k * n, qd, 0, out);
        thud_model_apply_contact_forces(m, seg->force + k * m->nrows, out);
    }
}

/* Of `modes` modes from the first one on. */
static void prepare_accelerations(struct thud_peaks *peaks, const struct thud_state *state,
                                  const struct thud_segment *seg, int first, int modes)
{
    if (seg->interpolates) {
        acceleration_by_forces(peaks, state, seg);
        return;
    }
    double *out = peaks->acceleration;
    const struct thud_model *m = state->model;
    double inverse = 1 / (seg->h_s * seg->h_s);
    for (int k = 0; k + 2 < seg->terms; k++) {
        double scale = (k + 1) * (k + 2) * inverse, ground = k == 0 ? seg->a0 : k == 1 ? seg->a1 : 0;
        for (int j = first; j < first + modes; j++)
            out[k * m->nmodes + j] = scale * seg->q[(k + 2) * m->nmodes + j] + m->gamma[j] * ground;
    }
}

/* Bounds of the second derivatives of each mode's displacement, velocity and acceleration in the segment, times s^2/8:
 * how far a value inside may lie above those at its ends. out (3 x nmodes). */
static void modal_margins(const struct thud_state *state, const struct thud_segment *seg, const double *acceleration,
                          double s_end, double *out)
{
    int n = state->model->nmodes;
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
static void structure_margins(const struct thud_model *m, const struct thud_model_structure *p, const double *modal,
                              double margin[THUD_FLOOR_QUANTITIES])
{
    int n = m->nmodes;
    double sum[THUD_FLOOR_QUANTITIES] = {0};
    for (int j = p->first_mode; j < p->first_mode + p->modes; j++) {
        sum[THUD_FLOOR_DISPLACEMENT] += m->mode_max[j] * modal[j];
        sum[THUD_FLOOR_VELOCITY] += m->mode_max[j] * modal[n + j];
        sum[THUD_FLOOR_ACCELERATION] += m->mode_max[j] * modal[2 * n + j];
        sum[THUD_FLOOR_DRIFT] += m->mode_max[n + j] * modal[j];
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
static void modal_acceleration(const struct thud_state *state, const struct thud_segment *seg,
                               const double *acceleration, double s, double *out)
{
    int n = state->model->nmodes;
    memset(out, 0, (size_t)n * sizeof *out);
    for (int k = seg->terms - 3; k >= 0; k--)
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
    thud_double_pair sum[2 * N] = {0};
    int j = 0;
    for (; j + 2 <= p->modes; j += 2)
        for (int x = 0; x < N; x++) {
            sum[x] += thud_double_pair_at(row + j) * thud_double_pair_at(start + x * nmodes + p->first_mode + j);
            sum[N + x] += thud_double_pair_at(row + j) * thud_double_pair_at(end + x * nmodes + p->first_mode + j);
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

static void floor_peak(struct thud_peaks *peaks, const struct thud_state *state, const struct thud_segment *seg,
                       int structure, int floor, int quantity, double s_end)
{
    const struct thud_model_structure *p = &state->model->structure[structure];
    struct thud_peak *peak = thud_floor_peak(peaks->result, structure, floor, quantity);
    double x[THUD_SEGMENT_TERMS] = {0}, u[THUD_SEGMENT_TERMS] = {0};
    int n = seg->terms, nmodes = state->model->nmodes;
    if (quantity == THUD_FLOOR_ACCELERATION) {
        floor_polynomial(p, floor, peaks->acceleration, nmodes, n - 2, x);
        raise_peak(seg, peak, x, n - 2, s_end);
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
    raise_peak(seg, peak, x, quantity == THUD_FLOOR_VELOCITY ? n - 1 : n, s_end);
}

static void structure_peaks(struct thud_peaks *peaks, const struct thud_state *state, const struct thud_segment *seg,
                            int index, double s_end, const struct thud_response_bound *reach, const double *start,
                            const double *end, const double *modal)
{
    const struct thud_model_structure *p = &state->model->structure[index];
    double margin[THUD_FLOOR_QUANTITIES], a[THUD_FLOOR_QUANTITIES], b[THUD_FLOOR_QUANTITIES], a_below = 0, b_below = 0;
    int nmodes = state->model->nmodes, below = -1; /* the floor whose displacements a_below and b_below are */
    structure_margins(state->model, p, modal, margin);
    for (int i = 0; i < p->n; i++) {
        if (!may_pass(peaks, state->model, index, i, reach))
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
            double peak = thud_floor_peak(peaks->result, index, i, x)->value;
            if (end_value + margin[x] > peak && end_value + floor_margin(p, i, x, nmodes, modal) > peak)
                floor_peak(peaks, state, seg, index, i, x, s_end);
        }
    }
}

/* Raises the largest value of the impact that goes on, and with it that of the contact. */
static void raise_contact_peak(const struct thud_segment *seg, struct thud_peak *peak, double *of_impact,
                               const double *p, double s_end)
{
    double where = 0;
    *of_impact = thud_poly_peak(p, seg->terms, s_end, *of_impact, &where);
    if (*of_impact > peak->value)
        *peak = (struct thud_peak){*of_impact, seg->start_s + where * seg->h_s};
}

static void indentation_peak(struct thud_peaks *peaks, const struct thud_state *state, const struct thud_segment *seg,
                             struct thud_contact_log *log, int c, double s_end)
{
    struct thud_impact *impact = &log->now[c];
    struct thud_peak *peak = &peaks->result->contact[c].indentation;
    const double *d = seg->indentation + c * THUD_SEGMENT_TERMS;
    if (state->locates) {
        raise_contact_peak(seg, peak, &impact->indentation_m, d, s_end);
        return;
    }
    for (int end = 0; end <= 1; end++) { /* the step may reach far out of contact, to the other side of 0 */
        double value = thud_poly_value(d, seg->terms, end * s_end);
        impact->indentation_m = fmax(impact->indentation_m, value);
        if (value > peak->value)
            *peak = (struct thud_peak){value, seg->start_s + end * s_end * seg->h_s};
    }
}

static void contact_peaks(struct thud_peaks *peaks, const struct thud_state *state, const struct thud_segment *seg,
                          struct thud_contact_log *log, int c, double s_end)
{
    const struct thud_contact_state *s = &state->contact[c];
    double p[THUD_SEGMENT_TERMS];
    if (s->mode != THUD_OPEN)
        indentation_peak(peaks, state, seg, log, c, s_end);
    if (!thud_segment_has_force(state, seg, c))
        return;
    for (int k = 0; k < seg->terms; k++)
        p[k] = seg->force[k * state->model->nrows + c];
    raise_contact_peak(seg, &peaks->result->contact[c].force, &log->now[c].force_n, p, s_end);
}

/* Peaks of the structures that may have one. */
static void motion_peaks(struct thud_peaks *peaks, const struct thud_observation *o)
{
    const struct thud_state *state = o->state;
    const struct thud_model *m = state->model;
    const struct thud_segment *seg = o->seg;
    double s = o->s;
    size_t n = (size_t)m->nmodes;
    double *start = peaks->ends, *end = start + 3 * n, *modal = end + 3 * n;
    bool prepared = false;
    for (int i = 0; i < m->nstructures; i++) {
        struct thud_response_bound reach = bound_of_segment(peaks, state, seg, i, s);
        if (!thud_response_bound_structure(peaks, state->model, i, &reach))
            continue;
        if (!prepared) {
            prepare_accelerations(peaks, state, seg, 0, m->nmodes);
            memcpy(start, state->q, n * sizeof *start);
            memcpy(start + n, state->qd, n * sizeof *start);
            memcpy(start + 2 * n, peaks->acceleration, n * sizeof *start);
            memcpy(end, o->q, n * sizeof *end);
            memcpy(end + n, o->qd, n * sizeof *end);
            modal_acceleration(state, seg, peaks->acceleration, s, end + 2 * n);
            modal_margins(state, seg, peaks->acceleration, s, modal);
            prepared = true;
        }
        structure_peaks(peaks, state, seg, i, s, &reach, start, end, modal);
    }
}

/* A step whose events are not located: the values at its end, which are all that it knows. */

static void raise_to(struct thud_peak *peak, double value, double time_s)
{
    if (fabs(value) > peak->value)
        *peak = (struct thud_peak){fabs(value), time_s};
}

/* S of a structure below which no floor can pass a peak while no contact force acts on it. */
static double quiet_speed(const struct thud_peaks *peaks, const struct thud_model *m, int structure)
{
    const struct thud_model_structure *p = &m->structure[structure];
    double least = INFINITY;
    for (int i = 0; i < p->n; i++) {
        const double *most = peaks->per_speed + p->first + i;
        for (int x = 0; x < (p->stiffness_npm ? THUD_FLOOR_QUANTITIES : THUD_FLOOR_DRIFT); x++)
            least = fmin(least, thud_floor_peak(peaks->result, structure, i, x)->value / most[x * m->ndof]);
    }
    return least;
}

static void structure_end(struct thud_peaks *peaks, const struct thud_observation *o, int structure, bool forced)
{
    const struct thud_model *m = o->state->model;
    const struct thud_model_structure *p = &m->structure[structure];
    const struct thud_motion *x = o->seg->end;
    double energy = 0, time_s = o->seg->start_s + o->seg->h_s, ground = o->seg->a0 + o->seg->a1, below = 0;
    for (int j = p->first_mode; j < p->first_mode + p->modes; j++)
        energy += x->qd[j] * x->qd[j] + m->spring[j] * x->q[j] * x->q[j];
    double quiet = peaks->quiet[structure];
    if (!forced && energy < quiet * quiet)
        return;
    for (int i = 0; i < p->n; i++) {
        const double *row = p->phi + i * p->modes;
        struct thud_floor_result *r = &peaks->result->structure[structure].floor[i];
        double u = thud_dot(p->modes, row, x->q + p->first_mode);
        raise_to(&r->displacement, u, time_s);
        raise_to(&r->velocity, thud_dot(p->modes, row, x->qd + p->first_mode), time_s);
        raise_to(&r->acceleration,
                 thud_dot(p->modes, row, x->qdd + p->first_mode) + m->ground_influence[p->first + i] * ground, time_s);
        if (p->stiffness_npm)
            raise_to(&r->drift, u - below, time_s);
        below = u;
    }
    peaks->quiet[structure] = quiet_speed(peaks, m, structure);
}

static void end_peaks(struct thud_peaks *peaks, const struct thud_observation *o)
{
    const struct thud_model *m = o->state->model;
    const struct thud_motion *x = o->seg->end;
    double time_s = o->seg->start_s + o->seg->h_s;
    bool forced = false;
    for (int c = 0; c < m->ncontacts; c++) {
        if (x->force[c] == 0 && o->state->contact[c].mode == THUD_OPEN)
            continue;
        struct thud_impact *impact = &peaks->log->now[c];
        double d = thud_model_gap_sum(m, c, x->q) - thud_state_clearance(o->state, c);
        forced = true;
        impact->indentation_m = fmax(impact->indentation_m, d);
        impact->force_n = fmax(impact->force_n, fabs(x->force[c]));
        raise_to(&peaks->result->contact[c].indentation, fmax(d, 0), time_s);
        raise_to(&peaks->result->contact[c].force, x->force[c], time_s);
    }
    for (int s = 0; s < m->nstructures; s++)
        structure_end(peaks, o, s, forced);
}

static enum thud_status segment(void *own, const struct thud_observation *o, struct thud_error *err)
{
    struct thud_peaks *peaks = own;
    (void)err;
    if (o->seg->end) {
        end_peaks(peaks, o);
        return THUD_OK;
    }
    motion_peaks(peaks, o);
    for (int c = 0; c < o->state->model->ncontacts; c++)
        contact_peaks(peaks, o->state, o->seg, peaks->log, c, o->s);
    return THUD_OK;
}

/* Peaks of free vibration: bounds show in which intervals of a block the peak of a floor's value can lie; of those the
 * series is made. */

enum { ENDS = THUD_FREE_VIBRATION_ENDS };

/* Rate of a row's value at end t of an interval whose ground acceleration there is `ground`. */
static double rate_at(const struct thud_model *m, const struct thud_free_vibration *f, const struct thud_peak_row *row,
                      int t, double ground)
{
    const struct thud_model_structure *p = &m->structure[row->structure];
    const double *v = f->value[THUD_FLOOR_VELOCITY] + (p->first + row->floor) * ENDS + t;
    if (row->quantity == THUD_FLOOR_DISPLACEMENT)
        return *v;
    if (row->quantity == THUD_FLOOR_DRIFT)
        return row->floor > 0 ? *v - v[-ENDS] : *v;
    if (row->quantity == THUD_FLOOR_VELOCITY)
        return f->value[THUD_FLOOR_ACCELERATION][(p->first + row->floor) * ENDS + t] -
               m->ground_influence[p->first + row->floor] * ground;
    return thud_free_vibration_jerk(f, m, row->structure, row->floor, t, ground);
}

/* Largest |p| on [0, 1] of the cubic with values x0, x1 and rates (by s) r0, r1 at the ends. */
static double cubic_peak(double x0, double x1, double r0, double r1)
{
    double c2 = 3 * (x1 - x0) - 2 * r0 - r1, c3 = 2 * (x0 - x1) + r0 + r1;
    double most = thud_larger(fabs(x0), fabs(x1)), root = c2 * c2 - 3 * c3 * r0;
    if (root < 0)
        return most;
    root = sqrt(root);
    double u = -(c2 + (c2 < 0 ? -root : root)); /* 3 c3 s^2 + 2 c2 s + r0 = 0, without cancellation */
    double s[2] = {u / (3 * c3), r0 / u};
    for (int i = 0; i < 2; i++)
        if (s[i] > 0 && s[i] < 1)
            most = thud_larger(most, fabs(x0 + s[i] * (r0 + s[i] * (c2 + s[i] * c3))));
    return most;
}

/* Intervals with an end at `near` or above, in order; how many. */
static int intervals_near(const double *x, int intervals, double near, int *list)
{
    int count = 0;
    bool before = fabs(x[0]) >= near;
    for (int t = 0; t < intervals; t++) {
        bool after = fabs(x[t + 1]) >= near;
        list[count] = t;
        count += before | after;
        before = after;
    }
    return count;
}

/* Bounds of the row inside the intervals in which it may pass both its peak so far and what it surely reaches in the
 * block, by interval into upper (0 elsewhere); false where there is none. */
static bool row_bounds(const struct thud_model *m, const struct thud_free_vibration *f, const struct thud_peak_row *row,
                       int intervals, double *upper)
{
    const double *x = row->x;
    double most = thud_largest_size(x, intervals + 1);
    if (most + row->margin <= row->peak->value)
        return false;
    double limit = thud_larger(row->peak->value, most);
    int list[THUD_FREE_VIBRATION_BLOCK], count = intervals_near(x, intervals, limit - row->margin, list);
    memset(upper, 0, (size_t)intervals * sizeof *upper);
    for (int i = 0; i < count; i++) {
        int t = list[i];
        double r0 = rate_at(m, f, row, t, f->ground[t]), r1 = rate_at(m, f, row, t + 1, f->after[t]);
        double cubic = cubic_peak(x[t], x[t + 1], f->dt_s * r0, f->dt_s * r1);
        upper[t] = cubic + row->cubic_margin;
        limit = thud_larger(limit, cubic - row->cubic_margin);
    }
    bool any = false;
    for (int i = 0; i < count; i++) {
        if (upper[list[i]] < limit)
            upper[list[i]] = 0;
        any = any || upper[list[i]] > row->peak->value;
    }
    return any;
}

/* Peaks of the rows of one structure that are due in interval t. */
static void read_interval(struct thud_peaks *peaks, const struct thud_state *state, struct thud_free_vibration *f,
                          int structure, const int *due, int count, int t)
{
    const struct thud_model_structure *p = &state->model->structure[structure];
    bool accelerates = false;
    for (int i = 0; i < count; i++)
        accelerates = accelerates || peaks->row[due[i]].quantity == THUD_FLOOR_ACCELERATION;
    for (int piece = 0; piece < f->pieces; piece++) {
        const struct thud_segment *seg = thud_free_vibration_series(f, state, structure, t, piece);
        if (accelerates)
            prepare_accelerations(peaks, state, seg, p->first_mode, p->modes);
        for (int i = 0; i < count; i++)
            floor_peak(peaks, state, seg, structure, peaks->row[due[i]].floor, peaks->row[due[i]].quantity, 1);
    }
}

/* Interval by interval, so that one series serves all rows of the structure. */
static void structure_rows(struct thud_peaks *peaks, const struct thud_state *state, struct thud_free_vibration *f,
                           int structure, int intervals)
{
    const struct thud_model *m = state->model;
    const struct thud_model_structure *p = &m->structure[structure];
    int rows = 0;
    for (int i = 0; i < p->n; i++)
        for (int x = 0; x < (p->stiffness_npm ? THUD_FLOOR_QUANTITIES : THUD_FLOOR_DRIFT); x++) {
            struct thud_peak_row *row = &peaks->row[rows];
            *row = (struct thud_peak_row){structure,
                                          i,
                                          x,
                                          f->value[x] + (size_t)(p->first + i) * ENDS,
                                          thud_floor_peak(peaks->result, structure, i, x),
                                          f->margin[x * m->nstructures + structure],
                                          f->cubic_margin[x * m->nstructures + structure]};
            rows += row_bounds(m, f, row, intervals, peaks->upper + rows * THUD_FREE_VIBRATION_BLOCK);
        }
    for (int t = 0; t < intervals; t++) {
        int count = 0;
        for (int i = 0; i < rows; i++)
            if (peaks->upper[i * THUD_FREE_VIBRATION_BLOCK + t] > peaks->row[i].peak->value)
                peaks->due[count++] = i;
        if (count > 0)
            read_interval(peaks, state, f, structure, peaks->due, count, t);
    }
}

/* Whether a structure moves enough in the block for a new peak. */
static bool may_pass_in_block(struct thud_peaks *peaks, const struct thud_model *m, const struct thud_free_vibration *f,
                              int structure)
{
    const struct thud_model_structure *p = &m->structure[structure];
    double energy = 0, gamma = 0;
    for (int j = p->first_mode; j < p->first_mode + p->modes; j++) {
        energy += f->speed[j] * f->speed[j];
        gamma += m->gamma[j] * m->gamma[j];
    }
    struct thud_response_bound reach = {sqrt(energy) + f->dt_s * sqrt(gamma) * f->ground_most, 0};
    return thud_response_bound_structure(peaks, m, structure, &reach);
}

static enum thud_status block(void *own, const struct thud_state *state, struct thud_free_vibration *f, int intervals,
                              struct thud_error *err)
{
    struct thud_peaks *peaks = own;
    const struct thud_model *m = state->model;
    (void)err;
    for (int s = 0; s < m->nstructures; s++) {
        if (!f->shifted && !may_pass_in_block(peaks, m, f, s))
            continue;
        thud_free_vibration_values(f, m, s);
        structure_rows(peaks, state, f, s, intervals);
    }
    return THUD_OK;
}

const struct thud_observer thud_observe_peaks = {segment, block};

enum thud_status thud_peaks_init(struct thud_peaks *peaks, const struct thud_state *state, struct thud_result *result,
                                 struct thud_contact_log *log, struct thud_error *err)
{
    size_t n = (size_t)state->model->nmodes, terms = THUD_SEGMENT_TERMS;
    size_t floors = THUD_FLOOR_QUANTITIES * (size_t)state->model->ndof;
    size_t rows = 0;
    for (int s = 0; s < state->model->nstructures; s++)
        rows = state->model->structure[s].n > (int)rows ? (size_t)state->model->structure[s].n : rows;
    rows *= THUD_FLOOR_QUANTITIES;
    *peaks = (struct thud_peaks){.result = result, .log = log};
    peaks->block = calloc((9 + terms + 1) * n + floors + (size_t)state->model->nstructures + 1, sizeof *peaks->block);
    peaks->upper = malloc((rows * THUD_FREE_VIBRATION_BLOCK + 1) * sizeof *peaks->upper);
    peaks->row = malloc((rows + 1) * sizeof *peaks->row);
    peaks->due = malloc((rows + 1) * sizeof *peaks->due);
    if (!peaks->block || !peaks->upper || !peaks->row || !peaks->due) {
        thud_peaks_clear(peaks);
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    peaks->ends = peaks->block;
    peaks->quiet = peaks->block + (9 + terms + 1) * n + floors;
    peaks->acceleration = peaks->ends + 9 * n;
    peaks->per_speed = peaks->acceleration + (terms + 1) * n;
    fill_response_bounds(peaks, state);
    return THUD_OK;
}

void thud_peaks_clear(struct thud_peaks *peaks)
{
    free(peaks->block);
    free(peaks->upper);
    free(peaks->row);
    free(peaks->due);
    *peaks = (struct thud_peaks){0};
}
