/* What the energy of a structure lets its floors come to: observe_peaks.h has the equation. */
#include <math.h>
#include <string.h>

#include "base/largest.h"
#include "core/numerics/vec.h"
#include "core/observe/observe_peaks_parts.h"

/* What a structure's energy lets its floors come to at most: where that is below the peaks so far, no floor needs to be
 * looked at. With S = sqrt(sum of q'^2 + omega^2 q^2), whatever the damping, dS/dt is at most the size of the forces in
 * modal coordinates; and by Cauchy and Schwarz a floor's value is at most S times a number of its own. */

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
    double least = INFINITY;
    if (speed <= peaks->quiet[structure])
        return false;
    for (int i = 0; i < p->dofs; i++)
        for (int x = 0; x < (i < p->n ? THUD_FLOOR_QUANTITIES : THUD_FLOOR_VELOCITY); x++) { /* else of a foundation */
            const double per_speed = peaks->per_speed[x * m->ndof + p->first + i],
                         room = thud_floor_peak(peaks->result, structure, i, x)->value;
            if (!(per_speed * speed <= room)) /* infinite: a rigid body, whose place no energy bounds */
                return true;
            least = room < per_speed * least ? room / per_speed : least;
        }
    peaks->quiet[structure] = least; /* peaks only rise */
    return false;
}

void thud_peaks_row_forces(struct thud_peaks *peaks, const struct thud_model *m, const struct thud_segment *seg)
{
    for (int i = 0; i < seg->rows; i++) {
        peaks->push[i] = fabs(seg->force[seg->row[i]]);
        for (int k = 1; k < seg->loaded; k++)
            peaks->push[i] += fabs(seg->force[k * m->nrows + seg->row[i]]);
    }
}

double thud_response_bound_segment(const struct thud_peaks *peaks, const struct thud_state *state,
                                   const struct thud_segment *seg, int structure, double s)
{
    const struct thud_model *m = state->model;
    const struct thud_model_structure *p = &m->structure[structure];
    const int at = p->first_mode;
    const double energy = thud_energy_sum(p->modes, m->spring + at, state->q + at, state->qd + at),
                 ground = thud_larger(fabs(seg->a0), fabs(seg->a0 + seg->a1)) * peaks->ground[structure];
    double force = 0;
    for (int i = 0; i < seg->rows; i++)
        force += peaks->per_force[structure * m->nrows + seg->row[i]] * peaks->push[i];
    return sqrt(energy) + s * seg->h_s * (ground + force) + peaks->as_speed[structure] * force;
}
