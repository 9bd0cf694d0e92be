/* What the energy of a structure lets its floors come to: observe_peaks.h has the equation. */
#include <math.h>
#include <string.h>

#include "base/largest.h"
#include "core/numerics/vec.h"
#include "core/observe/observe_peaks_parts.h"

/* What a structure's energy lets its floors come to at most: where that is below the peaks so far, no floor needs to be
 * looked at. With S = sqrt(sum of q'^2 + omega^2 q^2), whatever the damping, dS/dt is at most the size of the forces in
 * modal coordinates; and by Cauchy and Schwarz a floor's value is at most S times a number of its own.
 *
 * Where a storey has yielded, its force F_0 besides the elastic one and the spring forces on the modes are large and
 * cancel. So S is that of q - s, where
 *
 *     s = -sum of g F_0/omega^2
 *
 * is the rest under these forces as they are at the start: what they change by from there on acts, and the floors' places
 * at rest are added to what S bounds. */

/* Fills peaks->per_force and peaks->per_speed. A total acceleration without contacts is -phi_i . (Omega^2 x + D v): of
 * (Omega x, v), whose norm is S, with the factors (Omega phi_i, D phi_i). */
void thud_response_bound_fill(struct thud_peaks *peaks, const struct thud_state *state)
{
    const struct thud_model *m = state->model;
    for (int s = 0; s < m->nstructures; s++) {
        const struct thud_model_structure *p = &m->structure[s];
        for (int row = 0; row < m->nrows; row++) {
            const double *g = m->jacobian + row * m->nmodes + p->first_mode;
            peaks->per_force[s * m->nrows + row] = sqrt(thud_dot(p->modes, g, g));
        }
        for (int i = 0; i < p->dofs; i++) {
            double sum[THUD_FLOOR_QUANTITIES] = {0};
            for (int j = 0; j < p->modes; j++) {
                const double *row = p->phi + i * p->modes, a = row[j], w = m->omega[p->first_mode + j],
                             drift = thud_model_drift(p, p->phi + j, p->modes, i),
                             damped = m->dashpot[p->first_mode + j] * a +
                                      (p->damping ? thud_dot(p->modes, p->damping + j * p->modes, row) : 0);
                sum[THUD_FLOOR_DISPLACEMENT] += a * a / (w * w);
                sum[THUD_FLOOR_VELOCITY] += a * a;
                sum[THUD_FLOOR_ACCELERATION] += a * a * w * w + damped * damped;
                sum[THUD_FLOOR_DRIFT] += p->drifts ? drift * drift / (w * w) : 0;
            }
            for (int x = 0; x < THUD_FLOOR_QUANTITIES; x++)
                peaks->per_speed[x * m->ndof + p->first + i] = sqrt(sum[x]);
        }
    }
}

/* Whether a floor, and whether any floor of the structure, may then pass a peak; at rest they are at these places. */
static bool may_pass(struct thud_peaks *peaks, const struct thud_model *model, int structure, int floor,
                     const struct thud_response_bound *bound, const double *rest)
{
    const struct thud_model *m = model;
    const double drift = peaks->rests ? fabs(thud_model_drift(&m->structure[structure], rest, 1, floor)) : 0,
                 place = peaks->rests ? fabs(rest[floor]) : 0;
    const struct thud_floor_result *r = &peaks->result->structure[structure].floor[floor];
    const double *most = peaks->per_speed + m->structure[structure].first + floor;
    double push = most[THUD_FLOOR_VELOCITY * m->ndof] * bound->force;
    bool below = most[THUD_FLOOR_DISPLACEMENT * m->ndof] * bound->speed + place <= r->displacement.value;
    if (floor < m->structure[structure].n) /* else of a foundation */
        below = below && most[THUD_FLOOR_VELOCITY * m->ndof] * bound->speed <= r->velocity.value &&
                most[THUD_FLOOR_ACCELERATION * m->ndof] * bound->speed + push <= r->acceleration.value &&
                most[THUD_FLOOR_DRIFT * m->ndof] * bound->speed + drift <= r->drift.value;
    return !below; /* NaN: a rigid body, whose place no energy bounds */
}

bool thud_response_bound_structure(struct thud_peaks *peaks, const struct thud_model *model, int structure,
                                   const struct thud_response_bound *bound)
{
    const struct thud_model_structure *p = &model->structure[structure];
    for (int i = 0; i < p->dofs && peaks->rests; i++)
        peaks->value[i] = thud_dot(p->modes, p->phi + i * p->modes, peaks->rest + p->first_mode);
    for (int i = 0; i < p->dofs; i++)
        if (may_pass(peaks, model, structure, i, bound, peaks->value))
            return true;
    return false;
}

/* Adds to the modes' rest under the force of a storey. */
static void add_rest(struct thud_peaks *peaks, const struct thud_model *m, int row, double force_n)
{
    const double *g = m->jacobian + (size_t)row * (size_t)m->nmodes;
    if (!peaks->rests)
        memset(peaks->rest, 0, (size_t)m->nmodes * sizeof *peaks->rest);
    peaks->rests = true;
    for (int j = 0; j < m->nmodes; j++)
        peaks->rest[j] -= m->spring[j] > 0 ? g[j] * force_n / m->spring[j] : 0;
}

void thud_peaks_row_forces(struct thud_peaks *peaks, const struct thud_state *state, const struct thud_segment *seg)
{
    const struct thud_model *m = state->model;
    peaks->pushes = 0;
    peaks->rests = false;
    for (int c = 0; c < m->nrows; c++) {
        const struct thud_model_storey *storey = thud_model_row_storey(m, c);
        const bool rests = storey && storey->link < 0; /* a link's may push a free body, which rests nowhere */
        if (!storey && !thud_row_acts(state, c))
            continue;
        double bound = rests ? 0 : fabs(seg->force[c]);
        for (int k = 1; k < seg->loaded; k++)
            bound += fabs(seg->force[k * m->nrows + c]);
        if (bound > 0)
            peaks->push[peaks->pushes++] = (struct thud_row_push){c, bound};
        if (rests && seg->force[c] != 0)
            add_rest(peaks, m, c, seg->force[c]);
    }
}

/* In the segment up to s; without bound for methods whose steps do not keep to the equations of motion. */
struct thud_response_bound thud_response_bound_segment(const struct thud_peaks *peaks, const struct thud_state *state,
                                                       const struct thud_segment *seg, int structure, double s)
{
    const struct thud_model *m = state->model;
    const struct thud_model_structure *p = &m->structure[structure];
    if (seg->interpolates)
        return (struct thud_response_bound){INFINITY, INFINITY};
    double energy = 0, force = 0;
    for (int i = 0; i < peaks->pushes; i++)
        force += peaks->per_force[structure * m->nrows + peaks->push[i].row] * peaks->push[i].bound;
    for (int j = p->first_mode; j < p->first_mode + p->modes; j++) {
        const double q = state->q[j] - (peaks->rests ? peaks->rest[j] : 0);
        energy += state->qd[j] * state->qd[j] + m->spring[j] * q * q;
    }
    double ground = thud_larger(fabs(seg->a0), fabs(seg->a0 + seg->a1)) * peaks->ground[structure];
    return (struct thud_response_bound){sqrt(energy) + s * seg->h_s * (ground + force), force};
}
