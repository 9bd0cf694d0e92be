/* Peaks of a run that locates nothing and keeps no history: at the ends of its steps alone, which is all that such a step
 * knows. Most steps come nowhere near a peak; by Cauchy and Schwarz
 *     |u_i| = |sum_j phi_ij q_j| <= sqrt(sum_j phi_ij^2/omega_j^2) sqrt(sum_j omega_j^2 q_j^2) ,
 * and alike for rates and accelerations, three sums over the modes tell so for all floors of a structure at once (quiet),
 * and where no contact is indented the energy alone does for all structures (quiet_energy). */
#include "core/observe/end_peaks.h"

#include <assert.h>
#include <math.h>

#include "base/arena.h"
#include "base/largest.h"
#include "core/numerics/vec.h"
#include "core/observe/observe_peaks.h"

/* Floors of a structure, made even. */
static int even_floors(const struct thud_model_structure *p)
{
    return p->dofs + p->dofs % 2;
}

enum thud_status thud_end_peaks_init(struct thud_end_peaks *ends, const struct thud_state *state, const double *shape,
                                     int stride, const double *per_speed, struct thud_error *err)
{
    const struct thud_model *model = state->model;
    size_t row = (size_t)stride, rows = THUD_FLOOR_QUANTITIES * ((size_t)model->nstructures + 1);
    *ends = (struct thud_end_peaks){.shape = shape, .stride = stride, .per_speed = per_speed};
    const enum thud_status status = THUD_LAY_IN(state->memory, err, THUD_PIECE(ends->most, rows * row + 2),
                                                THUD_PIECE(ends->quiet, model->nstructures));
    if (status != THUD_OK)
        return status;
    double *next = ends->most;
    for (int s = 0; s < model->nstructures; s++) /* a rigid body has no drift, and the rest of a row is no floor */
        for (int x = 0; x < THUD_FLOOR_QUANTITIES; x++) {
            const struct thud_model_structure *p = &model->structure[s];
            const int count = x == THUD_FLOOR_DISPLACEMENT ? p->dofs : x != THUD_FLOOR_DRIFT || p->drifts ? p->n : 0;
            for (int i = 0; i < stride; i++)
                *next++ = i < count ? 0 : INFINITY;
        }
    ends->value = next + 2;
    return THUD_OK;
}

/* Displacements, velocities, total accelerations and drifts of all floors: value (quantities x stride), before which
 * there is room for the ground's displacement. */
static void floor_values(const struct thud_end_peaks *ends, const struct thud_model *m,
                         const struct thud_model_structure *p, const struct thud_motion *x, double ground)
{
    const int stride = ends->stride, floors = even_floors(p);
    double *value = ends->value;
    const double *q = x->q + p->first_mode, *qd = x->qd + p->first_mode, *qdd = x->qdd + p->first_mode,
                 *gamma = m->gamma + p->first_mode;
    for (int i = 0; i < floors; i += 2) {
        const double *at = ends->shape + p->first_shape * stride + i;
        thud_vec2 u = {0, 0}, v = {0, 0}, a = {0, 0};
        for (int j = 0; j < p->modes; j++, at += stride) {
            thud_vec2 shape = thud_vec2_at(at);
            u += shape * q[j];
            v += shape * qd[j];
            a += shape * (qdd[j] + gamma[j] * ground);
        }
        thud_vec2_put(u, value + THUD_FLOOR_DISPLACEMENT * stride + i);
        thud_vec2_put(v, value + THUD_FLOOR_VELOCITY * stride + i);
        thud_vec2_put(a, value + THUD_FLOOR_ACCELERATION * stride + i);
    }
    value[-1] = 0;
    for (int i = 0; p->rise && i < floors; i++)
        value[THUD_FLOOR_DRIFT * stride + i] = thud_model_drift(p, value, 1, i);
    for (int i = 0; !p->rise && i < floors; i += 2)
        thud_vec2_put(thud_vec2_at(value + i) - thud_vec2_at(value + i - 1), value + THUD_FLOOR_DRIFT * stride + i);
}

/* The floors' peaks; returns whether there was a new one. */
static bool raise_floors(struct thud_end_peaks *ends, const struct thud_model *m, int structure, double *most,
                         double time_s, struct thud_result *result)
{
    const struct thud_model_structure *p = &m->structure[structure];
    const int stride = ends->stride;
    bool any = false;
    for (int x = 0; x < THUD_FLOOR_QUANTITIES; x++)
        for (int i = 0; i < p->dofs; i++) {
            double value = fabs(ends->value[x * stride + i]);
            if (!(value > most[x * stride + i]))
                continue;
            *thud_floor_peak(result, structure, i, x) = (struct thud_peak){value, time_s};
            most[x * stride + i] = value;
            any = true;
        }
    if (any)
        ends->quiet[structure].push = ends->quiet_energy = 0;
    return any;
}

/* Squares of the sizes of a structure's modal values at a step's end; by Cauchy and Schwarz, none of its floors comes to
 * more than such a size times a number of its own. */
static struct thud_end_sizes sizes_of(const struct thud_model *m, const struct thud_model_structure *p,
                                      const struct thud_motion *x, double ground)
{
    const double *q = x->q + p->first_mode, *qd = x->qd + p->first_mode, *qdd = x->qdd + p->first_mode;
    const double *spring = m->spring + p->first_mode, *gamma = m->gamma + p->first_mode;
    thud_vec2 strain = {0, 0}, kinetic = {0, 0}, push = {0, 0};
    for (int j = 0; j < p->modes; j += 2) {
        const bool single = j + 1 == p->modes;
        const thud_vec2 u = thud_vec2_some(q + j, single), v = thud_vec2_some(qd + j, single),
                        a = thud_vec2_some(qdd + j, single) + thud_vec2_some(gamma + j, single) * ground;
        strain += thud_vec2_some(spring + j, single) * (u * u);
        kinetic += v * v;
        push += a * a;
    }
    return (struct thud_end_sizes){thud_vec2_sum(strain), thud_vec2_sum(kinetic), thud_vec2_sum(push), 0};
}

/* The least of a structure's peaks of one quantity by the bounds of another. */
static double least_ratio(const struct thud_end_peaks *ends, const struct thud_model *m, int structure, int quantity,
                          int bound)
{
    const struct thud_model_structure *p = &m->structure[structure];
    const double *most = ends->most + (structure * THUD_FLOOR_QUANTITIES + quantity) * ends->stride,
                 *per_speed = ends->per_speed + bound * m->ndof + p->first;
    double least = INFINITY;
    for (int i = 0; i < p->dofs && most[i] < INFINITY; i++)
        least = thud_smaller(least, most[i] / per_speed[i]);
    return least;
}

/* Sizes below which none of a structure's peaks can be passed, and the energy below which none of all can. */
static void set_quiet(struct thud_end_peaks *ends, const struct thud_model *m, int structure)
{
    enum { U = THUD_FLOOR_DISPLACEMENT, V = THUD_FLOOR_VELOCITY, A = THUD_FLOOR_ACCELERATION, D = THUD_FLOOR_DRIFT };
    double strain = thud_smaller(least_ratio(ends, m, structure, U, U), least_ratio(ends, m, structure, D, D)),
           kinetic = least_ratio(ends, m, structure, V, V), push = least_ratio(ends, m, structure, A, V),
           all = thud_smaller(thud_smaller(strain, kinetic), least_ratio(ends, m, structure, A, A));
    ends->quiet[structure] = (struct thud_end_sizes){strain * strain, kinetic * kinetic, push * push, all * all};
    ends->quiet_energy = INFINITY;
    for (int s = 0; s < m->nstructures; s++)
        if (m->structure[s].n > 0)
            ends->quiet_energy = thud_smaller(ends->quiet_energy, ends->quiet[s].energy);
}

/* The peaks of the end x of a step, which is this part of the segment from its start. */
static void look(struct thud_end_peaks *ends, const struct thud_model *m, const struct thud_segment *seg, double part,
                 const struct thud_motion *x, struct thud_result *result)
{
    const double time_s = seg->start_s + part * seg->h_s, ground = seg->a0 + part * seg->a1;
    const int row = THUD_FLOOR_QUANTITIES * ends->stride;
    for (int s = 0; s < m->nstructures; s++) {
        const struct thud_model_structure *p = &m->structure[s];
        struct thud_end_sizes now = sizes_of(m, p, x, ground), *quiet = &ends->quiet[s];
        double *most = ends->most + s * row;
        if (now.strain < quiet->strain && now.kinetic < quiet->kinetic && now.push < quiet->push)
            continue;
        floor_values(ends, m, p, x, ground);
        if (!raise_floors(ends, m, s, most, time_s, result) && quiet->push == 0)
            set_quiet(ends, m, s); /* peaks that rise step by step are waited for */
    }
}

void thud_end_peaks_add(struct thud_end_peaks *ends, const struct thud_observation *o, struct thud_result *result)
{
    const struct thud_segment *seg = o->seg;
    assert(seg->end && o->s == 1);
    if (seg->end->apart && o->state->nindented == 0 && seg->end_energy < ends->quiet_energy)
        return;
    for (int left = seg->steps - 1; left >= 0; left--)
        look(ends, o->state->model, seg, 1 - (double)left / seg->steps, seg->end - left, result);
}
