/* Peaks of the floors in one segment, and which floors need to be looked at (observe_peaks.h has the bounds).
 *
 * Glossary, for a segment of which the first part, s in [0, s_end], is committed; tau = s_end h in s.
 *
 *     S                 thud_response_bound_segment: bound of sqrt(sum q'^2 + omega^2 q^2) of a structure
 *     modal[row]        peaks->modal, of each mode j of the structure (m kg^1/2 and s):
 *         START, END    q'' + gamma a_g at both ends, from which the floors' total accelerations follow
 *         FOURTH        bound of the second rate of q'' + gamma a_g: the sum of the sizes of the series' terms
 *     value[row]        peaks->value of the floors: u, u' and h^2 u''/2 at the start, u and u' at the end; or their total
 *                       accelerations at both
 *     push              bound of one row's |F|
 *     thirds            notes->thirds, bound of h^3 |u'''| of any floor; u'' strays by s thirds/h^2 from where it starts
 *     margin            tau^2/8 times the bound of the second rate: how far a floor's value may lie above the larger of
 *                       its two ends
 *
 * Steps, for each structure: S below all peaks so far: nothing. Else the floors' values. One that stays below its peak
 * with its margin: nothing; whose rate keeps its sign: the larger of its ends; else the maximum of its polynomial. The
 * same of accelerations, if what they start from and may stray does not stay below their peaks. */
#include "core/observe/observe_peaks_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "base/largest.h"
#include "core/motion/free_vibration.h"
#include "core/numerics/tolerance.h"
#include "core/numerics/vec.h"
#include "core/observe/rest.h"

enum { MODE_START, MODE_END, MODE_FOURTH, MODE_ROWS };

/* Total accelerations of all modes from the equations of motion into peaks->acceleration: the polynomials of a stepping
 * method have the state that the method gives, but their second derivative strays between the ends of the step by as
 * much as the acceleration changes in it. */
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

/* Fills peaks->modal from the series of the modes, or of a stepping method from peaks->acceleration: its bound is that of
 * the polynomials from which peaks are read, and holds however forces and damping move them. */
static void fill_accelerations(struct thud_peaks *peaks, const struct thud_observation *o,
                               const struct thud_model_structure *p)
{
    const struct thud_segment *seg = o->seg;
    const bool forces = seg->interpolates;
    const int n = o->state->model->nmodes, stride = peaks->stride, last = seg->terms - 3;
    const double *gamma = o->state->model->gamma + p->first_mode, square = 1 / (seg->h_s * seg->h_s),
                 scale = forces ? 1 : square, *from = (forces ? peaks->acceleration : seg->q + 2 * n) + p->first_mode;
    for (int j = 0; j < p->modes; j += 2) { /* rows and series are long enough for an odd number */
        const thud_vec2 ground = (forces ? 0 : 1) * thud_vec2_some(gamma + j, j + 1 == p->modes);
        thud_vec2 start = {0, 0}, end = {0, 0}, fourth = {0, 0};
        for (int k = last; k >= 0; k--) {
            start = (forces ? 1 : (k + 1) * (k + 2)) * thud_vec2_at(from + k * n + j);
            end = end * o->s + start;
            fourth += k * (k - 1) * thud_vec2_abs(start);
        }
        double *out = peaks->modal + j;
        thud_vec2_put(scale * start + ground * seg->a0, out + MODE_START * stride);
        thud_vec2_put(scale * end + ground * (seg->a0 + o->s * seg->a1), out + MODE_END * stride);
        thud_vec2_put(square * scale * fourth, out + MODE_FOURTH * stride);
    }
}

enum { VALUE_ROWS = 5 };

/* Fills so many rows of peaks->value as sums over the modes, two floors at a time. */
static inline void floor_values(struct thud_peaks *peaks, const struct thud_model_structure *p,
                                const double *const *from, const int rows)
{
    const int stride = peaks->stride;
    for (int i = 0; i < p->dofs; i += 2) {
        thud_vec2 sum[VALUE_ROWS] = {0};
        const double *shape = peaks->shape + p->first_shape * stride + i;
        for (int j = 0; j < p->modes; j++, shape += stride)
            for (int x = 0; x < rows; x++)
                sum[x] += from[x][j] * thud_vec2_at(shape);
        for (int x = 0; x < rows; x++)
            thud_vec2_put(sum[x], peaks->value + x * stride + i);
    }
}

/* A value at both ends of a segment, and how far it may stray from the line between them. */
struct ends {
    double start, end, margin;
};

/* The peak of one quantity of a floor from its values, and where these do not tell, from its polynomial. */
static inline void look(struct thud_peaks *peaks, const struct thud_observation *o, int structure, int floor,
                        int quantity, struct ends x, struct ends rate)
{
    struct thud_peak *peak = thud_floor_peak(peaks->result, structure, floor, quantity);
    const double most = thud_larger(fabs(x.start), fabs(x.end));
    if (!(most + x.margin > peak->value))
        return;
    if (!(rate.start * rate.end > 0 && thud_smaller(fabs(rate.start), fabs(rate.end)) > rate.margin))
        thud_peaks_read_floor(peaks, o->state->model, o->seg, structure, floor, quantity, o->s);
    else if (most > peak->value)
        *peak = (struct thud_peak){most, o->seg->start_s + (most == fabs(x.start) ? 0 : o->s * o->seg->h_s)};
}

/* Peaks of the accelerations of one structure's floors. */
static void acceleration_peaks(struct thud_peaks *peaks, const struct thud_observation *o, int index)
{
    const struct thud_model *m = o->state->model;
    const struct thud_model_structure *p = &m->structure[index];
    const double *from[] = {peaks->modal + MODE_START * peaks->stride, peaks->modal + MODE_END * peaks->stride},
                 *fourth = peaks->modal + MODE_FOURTH * peaks->stride, time_s = o->s * o->seg->h_s;
    fill_accelerations(peaks, o, p);
    floor_values(peaks, p, from, 2);
    const double margin = time_s * time_s / 8 * thud_dot(p->modes, m->mode_max + p->first_mode, fourth);
    for (int i = 0; i < p->n; i++)
        look(peaks, o, index, i, THUD_FLOOR_ACCELERATION,
             (struct ends){peaks->value[i], peaks->value[peaks->stride + i], margin}, (struct ends){0});
}

/* Peaks of the floors of one structure. The rates of a stepping method are not those of its polynomials. */
static void structure_peaks(struct thud_peaks *peaks, const struct thud_observation *o, int index)
{
    const struct thud_model *m = o->state->model;
    const struct thud_model_structure *p = &m->structure[index];
    const struct thud_segment *seg = o->seg;
    const int at = p->first_mode, stride = peaks->stride;
    const double *from[] = {o->state->q + at, o->state->qd + at, seg->q + 2 * m->nmodes + at, o->q + at, o->qd + at},
                 strays = o->s * seg->notes->thirds[index], rate = 1 / seg->h_s, eighth = o->s * o->s / 8,
                 drifts = thud_dot(p->modes, m->mode_max + m->nmodes + at, seg->notes->bound + m->nmodes + at),
                 unknown = seg->interpolates ? INFINITY : 0;
    bool accelerates = seg->interpolates;
    floor_values(peaks, p, from, VALUE_ROWS);
    thud_peaks_forget_series(peaks, p);
    for (int i = 0; i < p->dofs; i++) {
        const double *u = peaks->value + i, second = 2 * u[2 * stride], ground = m->ground_influence[p->first + i];
        const struct ends v = {u[stride], u[4 * stride], eighth * rate * seg->notes->thirds[index]};
        look(peaks, o, index, i, THUD_FLOOR_DISPLACEMENT,
             (struct ends){u[0], u[3 * stride], eighth * (fabs(second) + strays)},
             (struct ends){v.start, v.end, v.margin + unknown});
        if (i >= p->n) /* of a foundation, displacements alone */
            continue;
        look(peaks, o, index, i, THUD_FLOOR_VELOCITY, v, (struct ends){second, second, strays + unknown});
        accelerates |=
            rate * rate * (fabs(second + ground * seg->a0 / (rate * rate)) + strays) + o->s * fabs(ground * seg->a1) >
            peaks->result->structure[index].floor[i].acceleration.value;
        if (!p->drifts)
            continue;
        double row[VALUE_ROWS];
        for (int x = 0; x < VALUE_ROWS; x++)
            row[x] = thud_model_drift(p, peaks->value + x * stride, 1, i);
        look(peaks, o, index, i, THUD_FLOOR_DRIFT,
             (struct ends){row[0], row[3], eighth * (2 * fabs(row[2]) + o->s * drifts)},
             (struct ends){row[1], row[4], eighth * rate * drifts + unknown});
    }
    if (accelerates)
        acceleration_peaks(peaks, o, index);
}

/* Peaks of the structures that may have one. */
static void motion_peaks(struct thud_peaks *peaks, const struct thud_observation *o)
{
    const struct thud_state *state = o->state;
    /* steps of a stepping method do not keep to the equations of motion; the force of a storey that has yielded is large,
     * and the springs' cancel it */
    const bool bounded = !o->seg->interpolates && state->nshifted == 0 && state->nyielding == 0;
    if (o->seg->interpolates)
        acceleration_by_forces(peaks, state, o->seg);
    if (bounded)
        thud_peaks_row_forces(peaks, state->model, o->seg);
    if (!state->locates)
        thud_segment_bounds(o->seg, state->model, o->s);
    for (int i = 0; i < state->model->nstructures; i++) {
        const double speed = bounded ? thud_response_bound_segment(peaks, state, o->seg, i, o->s) : INFINITY;
        if (thud_response_bound_structure(peaks, state->model, i, speed))
            structure_peaks(peaks, o, i);
    }
}

static enum thud_status segment(void *own, const struct thud_observation *o, struct thud_error *err)
{
    struct thud_peaks *peaks = own;
    (void)err;
    if (o->seg->end)
        thud_end_peaks_add(&peaks->of_ends, o, peaks->result);
    else
        motion_peaks(peaks, o);
    return THUD_OK;
}

/* Whether the rest of the run can be left out: no floor comes above its peaks any more. */
static bool may_jump(const void *own, const struct thud_rest *rest)
{
    const struct thud_peaks *peaks = own;
    double most[THUD_FLOOR_QUANTITIES];
    for (int s = 0; s < peaks->result->nstructures; s++)
        for (int i = 0; i < rest->model->structure[s].dofs; i++) {
            thud_rest_floor(rest, s, i, most);
            for (int x = 0; x < THUD_FLOOR_QUANTITIES; x++)
                if (most[x] > thud_floor_peak(peaks->result, s, i, x)->value)
                    return false;
        }
    return true;
}

const struct thud_observer thud_observe_peaks = {.segment = segment, .block = thud_peaks_block, .may_jump = may_jump};

/* Floors or modes of the largest structure, an even number. */
static int even_size(const struct thud_model *m)
{
    int most = 0;
    for (int s = 0; s < m->nstructures; s++) {
        const struct thud_model_structure *p = &m->structure[s];
        const int size = p->dofs > p->modes ? p->dofs : p->modes;
        most = size > most ? size : most;
    }
    return most + most % 2;
}

/* Fills peaks->shape and peaks->ground. */
static void fill_shapes(struct thud_peaks *peaks, const struct thud_model *m)
{
    for (int s = 0; s < m->nstructures; s++) {
        const struct thud_model_structure *p = &m->structure[s];
        for (int i = 0; i < p->dofs; i++)
            for (int j = 0; j < p->modes; j++) {
                double *shape = peaks->shape + (p->first_shape + j) * peaks->stride + i;
                shape[0] = p->phi[i * p->modes + j];
                shape[m->nshapes * peaks->stride] = thud_model_drift(p, p->phi + j, p->modes, i);
            }
        peaks->ground[s] = sqrt(thud_dot(p->modes, m->gamma + p->first_mode, m->gamma + p->first_mode));
    }
}

enum thud_status thud_peaks_init(struct thud_peaks *peaks, const struct thud_state *state, struct thud_result *result,
                                 struct thud_error *err)
{
    const struct thud_model *m = state->model;
    const size_t n = (size_t)m->nmodes, stride = (size_t)even_size(m), rows = THUD_FLOOR_QUANTITIES * stride,
                 structures = (size_t)m->nstructures;
    *peaks = (struct thud_peaks){.result = result, .stride = (int)stride};
    const enum thud_status status = THUD_LAY_IN(
        state->memory, err, THUD_PIECE(peaks->per_speed, THUD_FLOOR_QUANTITIES * m->ndof),
        THUD_PIECE(peaks->ground, structures), THUD_PIECE(peaks->as_speed, structures),
        THUD_PIECE(peaks->quiet, structures), THUD_PIECE(peaks->per_force, structures * (size_t)m->nrows),
        THUD_PIECE(peaks->shape, 2 * (size_t)m->nshapes * stride), THUD_PIECE(peaks->modal, MODE_ROWS * stride),
        THUD_PIECE(peaks->value, VALUE_ROWS * stride), THUD_PIECE(peaks->series, THUD_SEGMENT_TERMS * stride),
        THUD_PIECE(peaks->acceleration, (THUD_SEGMENT_TERMS + 1) * n), THUD_PIECE(peaks->push, m->nrows),
        THUD_PIECE(peaks->made, stride), THUD_PIECE(peaks->row, rows), THUD_PIECE(peaks->due, rows));
    if (status != THUD_OK)
        return status;
    peaks->upper = malloc((rows * THUD_FREE_VIBRATION_BLOCK + 1) * sizeof *peaks->upper); /* large: not to be cleared */
    if (!peaks->upper)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    fill_shapes(peaks, m);
    thud_response_bound_fill(peaks, state);
    return state->locates
               ? THUD_OK
               : thud_end_peaks_init(&peaks->of_ends, state, peaks->shape, peaks->stride, peaks->per_speed, err);
}

void thud_peaks_clear(struct thud_peaks *peaks)
{
    free(peaks->upper);
}
