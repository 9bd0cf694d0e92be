/* Stages and ends of explicit Runge-Kutta steps for q'' = r(q, q', t), written as the system (q, q')' = (q', r):
 *     q_i = q0 + h sum_k a_ik q'_k,   q'_i = q0' + h sum_k a_ik r_k        (k < i)
 * Kept between steps: the last stage, which is the next step's first, unless a contact has switched or the ground motion
 * jumps there. */
#include "core/methods/runge_kutta.h"

#include <math.h>
#include <string.h>

#include "core/numerics/tolerance.h"

enum thud_status thud_rk_create(const struct thud_method *method, const struct thud_state *state, void **own,
                                struct thud_error *err)
{
    const struct thud_tableau *tableau = method->scheme;
    const size_t size = (size_t)(tableau->stages + 1) * thud_motion_size(state->model);
    struct thud_rk *rk;
    double *next;
    if (THUD_LAY_IN(state->memory, err, THUD_PIECE(rk, 1), THUD_PIECE(next, size)) != THUD_OK)
        return THUD_MEMORY;
    *own = rk;
    rk->tableau = tableau;
    for (int i = 0; i < tableau->stages; i++)
        next = thud_motion_place(&rk->stage[i], state->model, next);
    thud_motion_place(&rk->work, state->model, next);
    return THUD_OK;
}

void thud_rk_start(const struct thud_state *state, struct thud_rk *rk)
{
    double ground = thud_step_ground(state, 0), before = rk->end_mps2;
    if (rk->first_known && fabs(ground - before) <= THUD_TOL_GROUND * (fabs(ground) + fabs(before)))
        return;
    memcpy(rk->stage[0].q, state->q, (size_t)state->model->nmodes * sizeof(double));
    memcpy(rk->stage[0].qd, state->qd, (size_t)state->model->nmodes * sizeof(double));
    thud_step_motion(state, &rk->stage[0], 0);
    rk->first_known = true;
    rk->end_mps2 = ground;
}

/* Weights of 0 are stepped over: most of a tableau is empty. */
void thud_rk_stages(const struct thud_state *state, struct thud_rk *rk, double h)
{
    const struct thud_tableau *t = rk->tableau;
    int n = state->model->nmodes;
    for (int i = 1; i < t->stages; i++) {
        struct thud_motion *x = &rk->stage[i];
        memcpy(x->q, state->q, (size_t)n * sizeof *x->q);
        memcpy(x->qd, state->qd, (size_t)n * sizeof *x->qd);
        for (int k = 0; k < i; k++) {
            double weight = h * t->a[i][k];
            const struct thud_motion *y = &rk->stage[k];
            for (int j = 0; j < n && weight != 0.0; j++) {
                x->q[j] += weight * y->qd[j];
                x->qd[j] += weight * y->qdd[j];
            }
        }
        thud_step_motion(state, x, t->c[i] * h);
    }
}

void thud_rk_committed(const struct thud_state *state, void *own, const struct thud_segment *seg, double tau_s,
                       bool switched)
{
    struct thud_rk *rk = own;
    (void)tau_s;
    struct thud_motion *first = &rk->stage[0], *last = &rk->stage[rk->tableau->stages - 1], keep = *first;
    rk->first_known = !switched;
    if (switched)
        return;
    *first = *last;
    *last = keep;
    /* The state was read from the segment: the same but for rounding. */
    memcpy(first->q, state->q, (size_t)state->model->nmodes * sizeof(double));
    memcpy(first->qd, state->qd, (size_t)state->model->nmodes * sizeof(double));
    rk->end_mps2 = seg->a0 + seg->a1;
}
