/* What a structure's energy lets its floors come to at most: where that is below the peaks so far, no floor needs to be
 * looked at. With S = sqrt(sum of q'^2 + omega^2 q^2), whatever the damping, dS/dt is at most the size of the forces in
 * modal coordinates; and by Cauchy and Schwarz a floor's value is at most S times a number of its own. */
#include <math.h>

#include "core/observe_peaks.h"

/* Largest factor by which damping may raise the sum of spring and damping forces over that of the springs. */
static double damping_factor(const struct thud_model *m, const struct thud_model_structure *p, int j)
{
    double ratio = 2 * m->zeta[p->first_mode + j], sum = 0;
    for (int i = 0; p->damping && i < p->modes; i++)
        for (int k = 0; k < p->modes; k++)
            sum += p->damping[i * p->modes + k] * p->damping[i * p->modes + k];
    return sqrt(1 + ratio * ratio) + (sum > 0 ? sqrt(sum) / m->omega[p->first_mode + j] : 0);
}

void thud_response_bound_start(struct thud_peaks *peaks, const struct thud_state *state)
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

bool thud_response_bound_floor(struct thud_peaks *peaks, const struct thud_model *model, int structure, int floor,
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
        if (thud_response_bound_floor(peaks, model, structure, i, reach))
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
    for (int c = 0; c < m->ncontacts; c++) {
        const struct thud_model_contact *contact = &m->contact[c];
        if (!thud_contact_acts(&state->contact[c]))
            continue;
        double force = 0;
        for (int k = 0; k < seg->terms; k++)
            force += fabs(seg->force[k * m->ncontacts + c]);
        for (int side = 0; side < 2; side++) {
            int dof = side == 0 ? contact->left_dof : contact->right_dof;
            if (dof >= p->first && dof < p->first + p->n)
                total += peaks->per_speed[THUD_FLOOR_VELOCITY * m->ndof + dof] * force;
        }
    }
    return total;
}

struct thud_response_bound thud_response_bound_segment(struct thud_peaks *peaks, const struct thud_state *state,
                                                       const struct thud_segment *seg, int structure, double s)
{
    const struct thud_model *m = state->model;
    const struct thud_model_structure *p = &m->structure[structure];
    double energy = 0, gamma = 0, force = largest_force(peaks, state, seg, p);
    if (seg->interpolates)
        return (struct thud_response_bound){INFINITY, INFINITY};
    for (int j = p->first_mode; j < p->first_mode + p->modes; j++) {
        energy += state->qd[j] * state->qd[j] + m->omega[j] * m->omega[j] * state->q[j] * state->q[j];
        gamma += m->gamma[j] * m->gamma[j];
    }
    double ground = fmax(fabs(seg->a0), fabs(seg->a0 + seg->a1)) * sqrt(gamma);
    return (struct thud_response_bound){sqrt(energy) + s * seg->h_s * (ground + force), force};
}
