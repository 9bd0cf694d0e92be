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
 * (Omega x, v), whose norm is S, with the factors (Omega phi_i, D phi_i); a force adds at most its share in velocities, and
 * so counts as the S that does no less to any floor. */
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
            if (i < p->n)
                peaks->as_speed[s] =
                    thud_larger(peaks->as_speed[s], sqrt(sum[THUD_FLOOR_VELOCITY] / sum[THUD_FLOOR_ACCELERATION]));
        }
    }
}

bool thud_response_bound_structure(struct thud_peaks *peaks, const struct thud_model *m, int structure, double speed)
{
    const struct thud_model_structure *p = &m->structure[structure];
    double *rest = peaks->value, least = INFINITY;
    if (speed <= peaks->quiet[structure] && !peaks->rests)
        return false;
    for (int i = 0; i < p->dofs && peaks->rests; i++)
        rest[i] = thud_dot(p->modes, p->phi + i * p->modes, peaks->rest + p->first_mode);
    for (int i = 0; i < p->dofs; i++)
        for (int x = 0; x < (i < p->n ? THUD_FLOOR_QUANTITIES : THUD_FLOOR_VELOCITY); x++) { /* else of a foundation */
            const double per_speed = peaks->per_speed[x * m->ndof + p->first + i];
            double room = thud_floor_peak(peaks->result, structure, i, x)->value;
            if (peaks->rests && x == THUD_FLOOR_DISPLACEMENT)
                room -= fabs(rest[i]);
            if (peaks->rests && x == THUD_FLOOR_DRIFT)
                room -= fabs(thud_model_drift(p, rest, 1, i));
            if (!(per_speed * speed <= room)) /* infinite: a rigid body, whose place no energy bounds */
                return true;
            least = room < per_speed * least ? room / per_speed : least;
        }
    if (!peaks->rests)
        peaks->quiet[structure] = least; /* peaks only rise */
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
    for (int i = 0; i < seg->rows; i++) {
        const int c = seg->row[i];
        const struct thud_model_storey *storey = thud_model_row_storey(m, c);
        const bool rests = storey && storey->link < 0; /* a link's may push a free body, which rests nowhere */
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
double thud_response_bound_segment(const struct thud_peaks *peaks, const struct thud_state *state,
                                   const struct thud_segment *seg, int structure, double s)
{
    const struct thud_model *m = state->model;
    const struct thud_model_structure *p = &m->structure[structure];
    const int at = p->first_mode;
    if (seg->interpolates)
        return INFINITY;
    double energy = peaks->rests ? 0 : thud_energy_sum(p->modes, m->spring + at, state->q + at, state->qd + at),
           force = 0;
    for (int i = 0; i < peaks->pushes; i++)
        force += peaks->per_force[structure * m->nrows + peaks->push[i].row] * peaks->push[i].bound;
    for (int j = at; j < at + p->modes && peaks->rests; j++) {
        const double q = state->q[j] - peaks->rest[j];
        energy += state->qd[j] * state->qd[j] + m->spring[j] * q * q;
    }
    double ground = thud_larger(fabs(seg->a0), fabs(seg->a0 + seg->a1)) * peaks->ground[structure];
    return sqrt(energy) + s * seg->h_s * (ground + force) + peaks->as_speed[structure] * force;
}
