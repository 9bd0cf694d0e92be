#include "core/methods/alpha_private.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/numerics/tolerance.h"

/* The scheme's a0 is r at the time t0 + (am - af) h, to second order: 0 where a is r itself, as Newmark's and central
 * difference's is. It passes from step to step, but not over a jump of the forces (a contact switched, the record ended),
 * which it would smear. */
static double time_offset(const struct thud_alpha *p)
{
    return p->am - p->af;
}

enum thud_status thud_alpha_create(const struct thud_method *method, const struct thud_state *state, void **own,
                                   struct thud_error *err)
{
    const struct thud_alpha *parameters = method->scheme;
    const struct thud_model *m = state->model;
    const size_t n = (size_t)m->nmodes, nc = (size_t)m->nrows, size = thud_motion_size(m);
    struct thud_alpha_work *x = calloc(1, sizeof *x);
    *own = NULL;
    assert(time_offset(parameters) != 0 || parameters->am == 0);
    if (x) {
        x->block = calloc(3 * size + 3 * n + nc * n + 2 * nc * nc + 4 * nc + 1, sizeof *x->block);
        x->active = calloc(2 * nc + 1, sizeof *x->active);
    }
    if (!x || !x->block || !x->active || thud_modal_operator_create(m, &x->op, err) != THUD_OK) {
        thud_alpha_free(x);
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    x->a0 = thud_motion_place(&x->start, m, x->block);
    x->a0 = thud_motion_place(&x->end, m, x->a0);
    x->a0 = thud_motion_place(&x->work, m, x->a0);
    x->a1 = x->a0 + n;
    x->rhs = x->a1 + n;
    x->response = x->rhs + n;
    x->w = x->response + nc * n;
    x->matrix = x->w + nc * nc;
    x->change = x->matrix + nc * nc;
    x->d = x->change + nc;
    x->v = x->d + nc;
    x->a = x->v + nc;
    x->pivot = x->active + nc;
    x->p = *parameters;
    x->fresh = true;
    *own = x;
    return THUD_OK;
}

void thud_alpha_free(void *own)
{
    struct thud_alpha_work *x = own;
    if (!x)
        return;
    thud_modal_operator_free(x->op);
    free(x->block);
    free(x->active);
    free(x);
}

/* Operator and responses for steps of length h; kept while steps differ by rounding only. */
static void prepare(const struct thud_model *m, struct thud_alpha_work *x, double h)
{
    if (fabs(h - x->h_made) <= THUD_TOL_STEP_CHANGE * h)
        return;
    const double part = 1 - x->p.af;
    x->h_made = h;
    thud_modal_operator_set(x->op, m, 1 - x->p.am, part * x->p.gamma * h, part * x->p.beta * h * h);
    for (int c = 0; c < m->nrows; c++) {
        double *r = x->response + c * m->nmodes;
        thud_modal_operator_apply(x->op, m, m->jacobian + c * m->nmodes, r);
        for (int j = 0; j < m->nmodes; j++)
            r[j] *= part;
        for (int a = 0; a < m->nrows; a++)
            x->w[a * m->nrows + c] = thud_model_gap_sum(m, a, r);
    }
}

/* Lagged: what acts in the step is the force found at the end of the step before, which still stands in end.force; the
 * law's now is for the next. */
static void lag_forces(const struct thud_state *state, struct thud_alpha_work *x, double ground)
{
    double *law = x->start.force;
    x->start.force = x->end.force;
    x->end.force = law;
    thud_model_acceleration(state->model, state->q, state->qd, ground, x->start.qdd);
    thud_model_apply_contact_forces(state->model, x->start.force, x->start.qdd);
}

/* q0, q0', r0, a0 and the forces: those of the last step's end where it goes on, else from the state. Where the length of
 * the steps changes, a0 keeps its time offset in steps: it lies on the line through r0. */
static void start_step(const struct thud_state *state, struct thud_alpha_work *x, double h)
{
    const size_t n = (size_t)state->model->nmodes;
    const double ground = thud_step_ground(state, 0), jump = fabs(ground - x->before_mps2),
                 size = fabs(ground) + fabs(x->before_mps2);
    if (x->goes_on && jump <= THUD_TOL_GROUND * size) {
        const struct thud_motion last = x->start;
        x->start = x->end;
        x->end = last;
    } else {
        memcpy(x->start.q, state->q, n * sizeof(double));
        memcpy(x->start.qd, state->qd, n * sizeof(double));
        thud_step_motion(state, &x->start, 0);
    }
    if (x->p.lagged)
        lag_forces(state, x, ground);
    x->fresh = x->fresh || jump > THUD_TOL_GROUND_JUMP * size;
    if (time_offset(&x->p) == 0)
        return;
    if (x->fresh)
        memcpy(x->a0, x->start.qdd, n * sizeof(double));
    else if (fabs(h - x->a0_step_s) > THUD_TOL_STEP_CHANGE * h)
        for (size_t j = 0; j < n; j++)
            x->a0[j] = x->start.qdd[j] + h / x->a0_step_s * (x->a0[j] - x->start.qdd[j]);
}

/* Newmark's update without the part of a1: by_q = h^2 (1/2 - beta), by_v = h (1 - gamma). */
static void update(int n, double h, double by_q, double by_v, const double *restrict q0, const double *restrict v0,
                   const double *restrict a0, double *restrict q, double *restrict v)
{
    for (int j = 0; j < n; j++) {
        q[j] = q0[j] + h * v0[j] + by_q * a0[j];
        v[j] = v0[j] + by_v * a0[j];
    }
}

/* The part of a1: by_q = h^2 beta, by_v = h gamma. */
static void add_end(int n, double by_q, double by_v, const double *restrict a1, double *restrict q, double *restrict v)
{
    for (int j = 0; j < n; j++) {
        q[j] += by_q * a1[j];
        v[j] += by_v * a1[j];
    }
}

/* q1, v1, a1 if no contact force acted at t1. With a1 = 0 in Newmark's update first, a1 = A ((1 - af) r(q1, v1) + af r0 -
 * am a0), and its part is added. */
static void predict(const struct thud_state *state, struct thud_alpha_work *x, double h)
{
    const struct thud_model *m = state->model;
    const struct thud_alpha *p = &x->p;
    const bool own = time_offset(p) != 0;
    const int n = m->nmodes;
    update(n, h, h * h * (0.5 - p->beta), h * (1 - p->gamma), x->start.q, x->start.qd, own ? x->a0 : x->start.qdd,
           x->end.q, x->end.qd);
    x->ground_mps2 = thud_step_ground(state, h);
    thud_model_acceleration(m, x->end.q, x->end.qd, x->ground_mps2, x->rhs);
    for (int j = 0; j < n && own; j++)
        x->rhs[j] = (1 - p->af) * x->rhs[j] + p->af * x->start.qdd[j] - p->am * x->a0[j];
    thud_modal_operator_apply(x->op, m, x->rhs, x->a1);
    add_end(n, h * h * p->beta, h * p->gamma, x->a1, x->end.q, x->end.qd);
}

/* The part of the forces at t1 in a1, q1, v1. */
static void correct(const struct thud_model *m, struct thud_alpha_work *x, double h)
{
    for (int c = 0; c < m->nrows; c++) {
        if (x->end.force[c] == 0)
            continue;
        for (int j = 0; j < m->nmodes; j++) {
            x->rhs[j] = -x->response[c * m->nmodes + j] * x->end.force[c];
            x->a1[j] += x->rhs[j];
        }
        add_end(m->nmodes, x->p.beta * h * h, x->p.gamma * h, x->rhs, x->end.q, x->end.qd);
    }
}

/* From t0 to t1 with given a0; r1 by the equations of motion, where a1 is not r1 itself. */
static void take_step(const struct thud_state *state, struct thud_alpha_work *x, double h)
{
    predict(state, x, h);
    x->end.apart = false;
    if (!x->p.lagged)
        thud_alpha_forces(state, x, h);
    if (!x->end.apart)
        correct(state->model, x, h);
    if (!state->locates && time_offset(&x->p) == 0) {
        memcpy(x->end.qdd, x->a1, (size_t)state->model->nmodes * sizeof *x->a1);
        return;
    }
    thud_model_acceleration(state->model, x->end.q, x->end.qd, x->ground_mps2, x->end.qdd);
    thud_model_apply_contact_forces(state->model, x->end.force, x->end.qdd);
}

enum thud_status thud_alpha_step(const struct thud_state *state, void *own, struct thud_segment *seg,
                                 struct thud_error *err)
{
    struct thud_alpha_work *x = own;
    const double h = thud_step_length(state);
    (void)err;
    prepare(state->model, x, h);
    start_step(state, x, h);
    take_step(state, x, h);
    if (x->fresh && time_offset(&x->p) != 0) {
        /* r0 and r1 tell how the acceleration changes: once more, with a0 at its time offset */
        for (int j = 0; j < state->model->nmodes; j++)
            x->a0[j] = x->start.qdd[j] + time_offset(&x->p) * (x->end.qdd[j] - x->start.qdd[j]);
        take_step(state, x, h);
    }
    x->a0_step_s = h;
    thud_step_write(state, seg, h, &x->start, &x->end, &x->work);
    return THUD_OK;
}

void thud_alpha_committed(const struct thud_state *state, void *own, const struct thud_segment *seg, double tau_s,
                          bool switched)
{
    struct thud_alpha_work *x = own;
    double *now = x->a0;
    (void)seg, (void)tau_s;
    x->fresh = state->locates && switched; /* nothing located: the program does not know that anything happened */
    x->before_mps2 = x->ground_mps2;
    x->goes_on = !state->locates && !switched && !x->p.lagged && state->model->nstoreys == 0 && x->solved;
    x->a0 = x->a1;
    x->a1 = now;
}
