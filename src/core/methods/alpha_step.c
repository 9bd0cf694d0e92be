#include "core/methods/alpha_private.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "base/arena.h"
#include "core/numerics/tolerance.h"
#include "core/numerics/vec.h"

/* The scheme's a0 is r at the time t0 + (am - af) h, to second order: 0 where a is r itself, as Newmark's and central
 * difference's is. It passes from step to step, but not over a jump of the forces (a contact switched, the record ended),
 * which it would smear. */
static double time_offset(const struct thud_alpha *p)
{
    return p->am - p->af;
}

static enum thud_status create(const struct thud_method *method, const struct thud_state *state, void **own,
                               struct thud_error *err)
{
    const struct thud_alpha *parameters = method->scheme;
    const struct thud_model *m = state->model;
    const size_t n = (size_t)m->nmodes, nc = (size_t)m->nrows, size = thud_motion_size(m);
    struct thud_alpha_work *x, to = {.p = *parameters, .fresh = true};
    assert(time_offset(parameters) != 0 || parameters->am == 0);
    const enum thud_status status =
        THUD_LAY_IN(state->memory, err, THUD_PIECE(x, 1), THUD_PIECE(to.a0, (THUD_STEPS_AT_ONCE + 2) * size + n),
                    THUD_PIECE(to.a1, n), THUD_PIECE(to.rhs, n), THUD_PIECE(to.response, nc * n),
                    THUD_PIECE(to.w, nc * nc), THUD_PIECE(to.matrix, nc * nc), THUD_PIECE(to.change, nc),
                    THUD_PIECE(to.d, nc), THUD_PIECE(to.v, nc), THUD_PIECE(to.a, nc), THUD_PIECE(to.reach, nc),
                    THUD_PIECE(to.active, nc), THUD_PIECE(to.pivot, nc), THUD_MODAL_OPERATOR_PIECES(to.op, m));
    *own = x;
    if (status != THUD_OK)
        return status;
    *x = to;
    x->a0 = thud_motion_place(&x->work, m, x->a0);
    for (int i = 0; i <= THUD_STEPS_AT_ONCE; i++)
        x->a0 = thud_motion_place(&x->end[i], m, x->a0);
    for (size_t i = 0; i < nc * n; i++) /* a mode without a spring goes any way */
        if (m->jacobian[i] != 0)
            x->reach[i / n] += m->jacobian[i] * m->jacobian[i] / m->spring[i % n];
    return THUD_OK;
}

/* Operator and responses for steps of length h; kept while steps differ by rounding only. */
static void prepare(const struct thud_model *m, struct thud_alpha_work *x, double h)
{
    if (fabs(h - x->h_made) <= THUD_TOL_STEP_CHANGE * h)
        return;
    const double part = 1 - x->p.af;
    x->h_made = h;
    thud_modal_operator_set(&x->op, m, 1 - x->p.am, part * x->p.gamma * h, part * x->p.beta * h * h);
    for (int c = 0; c < m->nrows; c++) {
        double *r = x->response + c * m->nmodes;
        thud_modal_operator_apply(&x->op, m, m->jacobian + c * m->nmodes, r);
        for (int j = 0; j < m->nmodes; j++)
            r[j] *= part;
        for (int a = 0; a < m->nrows; a++)
            x->w[a * m->nrows + c] = thud_model_gap_sum(m, a, r);
    }
}

/* Lagged: what acts in the step is the force found at the end of the step before, which still stands there; the law's now
 * is for the next. */
static void lag_forces(const struct thud_state *state, struct thud_alpha_work *x, double ground)
{
    double *law = x->end[0].force;
    x->end[0].force = x->end[1].force;
    x->end[1].force = law;
    thud_model_acceleration(state->model, state->q, state->qd, ground, x->end[0].qdd);
    thud_model_apply_contact_forces(state->model, x->end[0].force, x->end[0].qdd);
}

/* q0, q0', r0, a0 and the forces: those of the last step's end where it goes on, else from the state. Where the length of
 * the steps changes, a0 keeps its time offset in steps: it lies on the line through r0. */
static void start_step(const struct thud_state *state, struct thud_alpha_work *x, double h)
{
    const size_t n = (size_t)state->model->nmodes;
    const double ground = thud_step_ground(state, 0), jump = fabs(ground - x->before_mps2),
                 size = fabs(ground) + fabs(x->before_mps2);
    struct thud_motion *start = &x->end[0];
    if (!x->goes_on || jump > THUD_TOL_GROUND * size) {
        memcpy(start->q, state->q, n * sizeof(double));
        memcpy(start->qd, state->qd, n * sizeof(double));
        thud_step_motion(state, start, 0);
    }
    if (x->p.lagged)
        lag_forces(state, x, ground);
    x->fresh = x->fresh || jump > THUD_TOL_GROUND_JUMP * size;
    if (time_offset(&x->p) == 0)
        return;
    if (x->fresh)
        memcpy(x->a0, start->qdd, n * sizeof(double));
    else if (fabs(h - x->a0_step_s) > THUD_TOL_STEP_CHANGE * h)
        for (size_t j = 0; j < n; j++)
            x->a0[j] = start->qdd[j] + h / x->a0_step_s * (x->a0[j] - start->qdd[j]);
}

/* q1, v1, a1 of the step between two ends, `after` seconds from now, if no contact force acted at t1. With a1 = 0 in
 * Newmark's update first, a1 = A ((1 - af) r(q1, v1) + af r0 - am a0), and its part is added. */
static void predict(const struct thud_state *state, struct thud_alpha_work *x, const struct thud_motion *from,
                    const struct thud_motion *to, double h, double after)
{
    const struct thud_model *m = state->model;
    const struct thud_alpha *p = &x->p;
    const bool own = time_offset(p) != 0;
    const int n = m->nmodes;
    const double *restrict q0 = from->q, *restrict v0 = from->qd, *restrict a0 = own ? x->a0 : from->qdd;
    double *restrict q = to->q, *restrict v = to->qd, *restrict a1 = x->a1 = own ? x->a1 : to->qdd, *rhs = x->rhs;
    const double by_q = h * h * (0.5 - p->beta), by_v = h * (1 - p->gamma), end_q = h * h * p->beta,
                 end_v = h * p->gamma;
    for (int j = 0; j < n; j++) {
        q[j] = q0[j] + h * v0[j] + by_q * a0[j];
        v[j] = v0[j] + by_v * a0[j];
    }
    x->ground_mps2 = thud_step_ground(state, after);
    thud_model_acceleration(m, q, v, x->ground_mps2, rhs);
    for (int j = 0; j < n && own; j++)
        rhs[j] = (1 - p->af) * rhs[j] + p->af * from->qdd[j] - p->am * a0[j];
    thud_modal_operator_apply(&x->op, m, rhs, a1);
    for (int j = 0; j < n; j++) {
        q[j] += end_q * a1[j];
        v[j] += end_v * a1[j];
    }
}

/* The part of the forces at t1 in a1, q1, v1. */
static void correct(const struct thud_model *m, struct thud_alpha_work *x, double h)
{
    const struct thud_motion *end = &x->end[1];
    for (int c = 0; c < m->nrows; c++)
        for (int j = 0; j < m->nmodes && end->force[c] != 0; j++) {
            const double a = -x->response[c * m->nmodes + j] * end->force[c];
            x->a1[j] += a;
            end->q[j] += x->p.beta * h * h * a;
            end->qd[j] += x->p.gamma * h * a;
        }
}

/* From t0 to t1 with given a0; r1 by the equations of motion, where a1 is not r1 itself. */
static void take_step(const struct thud_state *state, struct thud_alpha_work *x, double h)
{
    struct thud_motion *end = &x->end[1];
    predict(state, x, &x->end[0], end, h, h);
    end->apart = false;
    if (!x->p.lagged)
        thud_alpha_forces(state, x, h);
    if (!end->apart)
        correct(state->model, x, h);
    if (!state->locates && time_offset(&x->p) == 0)
        return;
    thud_model_acceleration(state->model, end->q, end->qd, x->ground_mps2, end->qdd);
    thud_model_apply_contact_forces(state->model, end->force, end->qdd);
}

/* a1 is the next step's a0. */
static void pass_on(struct thud_alpha_work *x)
{
    double *now = x->a0;
    x->a0 = x->a1;
    x->a1 = now;
}

/* Whether no contact is indented; that a sum of omega^2 q^2 is below `energy` tells so of most (Cauchy and Schwarz). */
static bool is_apart(const struct thud_state *state, const struct thud_alpha_work *x, const double *q, double energy)
{
    for (int c = 0; c < state->model->ncontacts; c++) {
        const double room = thud_state_clearance(state, c);
        if (!(room > 0 && x->reach[c] * energy < room * room) && thud_model_gap_sum(state->model, c, q) > room)
            return false;
    }
    return true;
}

/* Up to `most` steps, of which the first has been taken: those after it while no contact closes, so that nothing is to be
 * done at their ends. Returns how many there are; *energy: the largest sum of omega^2 q^2 + q'^2 of those after it. */
static int go_ahead(const struct thud_state *state, struct thud_alpha_work *x, double h, double most, double *energy)
{
    const struct thud_model *m = state->model;
    int steps = 1;
    *energy = 0;
    while (steps < most && x->end[steps].apart && state->nindented == 0) {
        struct thud_motion *end = &x->end[steps + 1];
        pass_on(x);
        predict(state, x, &x->end[steps], end, h, (steps + 1) * h);
        const double sum = thud_energy_sum(m->nmodes, m->spring, end->q, end->qd);
        if (!(sum < state->energy_most) || !is_apart(state, x, end->q, sum)) {
            pass_on(x);
            break;
        }
        if (time_offset(&x->p) != 0)
            thud_model_acceleration(m, end->q, end->qd, x->ground_mps2, end->qdd);
        memset(end->force, 0, (size_t)m->nrows * sizeof *end->force);
        end->apart = true;
        *energy = thud_larger(*energy, sum);
        steps++;
    }
    return steps;
}

static enum thud_status step(const struct thud_state *state, void *own, struct thud_segment *seg,
                             struct thud_error *err)
{
    struct thud_alpha_work *x = own;
    const double h = thud_step_length(state);
    double energy;
    (void)err;
    prepare(state->model, x, h);
    start_step(state, x, h);
    take_step(state, x, h);
    if (x->fresh && time_offset(&x->p) != 0) {
        /* r0 and r1 tell how the acceleration changes: once more, with a0 at its time offset */
        for (int j = 0; j < state->model->nmodes; j++)
            x->a0[j] = x->end[0].qdd[j] + time_offset(&x->p) * (x->end[1].qdd[j] - x->end[0].qdd[j]);
        take_step(state, x, h);
    }
    x->a0_step_s = h;
    const double room = thud_step_room(state), all = round(room / h);
    const int steps = go_ahead(state, x, h, thud_smaller(all, state->at_once), &energy);
    x->ground_mps2 = thud_step_ground(state, steps * h);
    thud_step_write(state, seg, steps == all ? room : steps * h, x->end, &x->end[steps], &x->work);
    seg->steps = steps;
    seg->end_energy = thud_larger(seg->end_energy, energy);
    return THUD_OK;
}

static void committed(const struct thud_state *state, void *own, const struct thud_segment *seg, double tau_s,
                      bool switched)
{
    struct thud_alpha_work *x = own;
    (void)tau_s;
    x->fresh = state->locates && switched; /* nothing located: the program does not know that anything happened */
    x->before_mps2 = x->ground_mps2;
    x->goes_on = !state->locates && !switched && !x->p.lagged && state->model->nstoreys == 0 && x->solved;
    pass_on(x);
    if (x->goes_on) {
        const struct thud_motion last = x->end[seg->steps];
        x->end[seg->steps] = x->end[0];
        x->end[0] = last;
    }
}

const struct thud_stepper thud_alpha_stepper = {create, step, committed};
