/* Dormand and Prince's pair of orders 5 and 4 with the usual control of the step, h (tolerance/error)^(1/5) times 0.9. What
 * is not usual is the measure of the error, which is made for what is asked of a run: peaks of accelerations and contact
 * forces (error_of), and that its tolerance per step falls with the length of the step, so that many steps add up to what
 * few may have. Kept from step to step: the length to try, and the largest accelerations and forces so far. */
#include "core/methods/dormand_prince.h"

#include <math.h>

#include "base/arena.h"
#include "core/methods/runge_kutta.h"
#include "core/numerics/tolerance.h"

const struct thud_tableau thud_dormand_prince_tableau = {
    .stages = 7,
    .c = {0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1, 1},
    .a = {{0},
          {1.0 / 5},
          {3.0 / 40, 9.0 / 40},
          {44.0 / 45, -56.0 / 15, 32.0 / 9},
          {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
          {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
          {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}},
};
/* Weights of the end less those of the embedded method of order 4. */
static const double difference[7] = {71.0 / 57600,      0,          -71.0 / 16695, 71.0 / 1920,
                                     -17253.0 / 339200, 22.0 / 525, -1.0 / 40};

struct dormand_prince {
    struct thud_rk *rk;
    double h;                 /* to try next */
    double speed;             /* modal speed in which errors are measured, and */
    double *scale_mps2;       /* (nstructures) largest total accelerations so far */
    double *scale_n;          /* (nrows) largest forces so far */
    struct thud_motion error; /* of the step at its end */
};

static enum thud_status create(const struct thud_method *method, const struct thud_state *state, void **own,
                               struct thud_error *err)
{
    const struct thud_model *m = state->model;
    void *rk = NULL;
    struct dormand_prince *x, to = {.h = thud_state_default_step(state)};
    enum thud_status status = THUD_LAY_IN(state->memory, err, THUD_PIECE(x, 1), THUD_MOTION_PIECES(to.error, m),
                                          THUD_PIECE(to.scale_mps2, m->nstructures), THUD_PIECE(to.scale_n, m->nrows));
    *own = x;
    if (status != THUD_OK)
        return status;
    *x = to;
    status = thud_rk_create(method, state, &rk, err);
    x->rk = rk;
    for (int s = 0; s < m->nstructures; s++)
        x->scale_mps2[s] = state->ground_mps2;
    double mass = 0;
    for (int j = 0; j < m->nmodes; j++)
        mass += m->gamma[j] * m->gamma[j];
    x->speed = sqrt(mass) * thud_record_speed(state->record) +
               sqrt(2 * (thud_state_kinetic(state) + thud_state_strain(state)));
    return status;
}

/* The largest total acceleration of a structure's floors at a motion. */
static double largest_acceleration(const struct thud_model *m, const struct thud_model_structure *p, const double *qdd,
                                   double ground)
{
    double largest = 0;
    for (int i = p->first; i < p->first + p->dofs; i++)
        largest = fmax(largest, fabs(thud_model_floor(m, i, qdd) + m->ground_influence[i] * ground));
    return largest;
}

/* Scales of the accelerations at the start of a step: what they are, and what a contact that has just begun will make of
 * them. */
static void raise_scales(const struct thud_state *state, struct dormand_prince *x)
{
    const struct thud_model *m = state->model;
    const double ground = thud_step_ground(state, 0);
    for (int s = 0; s < m->nstructures; s++)
        x->scale_mps2[s] =
            fmax(x->scale_mps2[s], largest_acceleration(m, &m->structure[s], x->rk->stage[0].qdd, ground));
    for (int c = 0; c < m->nrows; c++)
        x->scale_n[c] = fmax(x->scale_n[c], fabs(x->rk->stage[0].force[c]));
    for (int c = 0; c < m->ncontacts; c++) {
        const int dof[] = {m->contact[c].left_dof, m->contact[c].right_dof};
        if (state->contact[c].mode != THUD_CLOSED || state->contact[c].suppressed.indentation == 0)
            continue;
        for (int i = 0; i < 2; i++)
            if (dof[i] >= 0)
                x->scale_mps2[m->dof_structure[dof[i]]] = fmax(x->scale_mps2[m->dof_structure[dof[i]]],
                                                               state->contact[c].expected_force_n / m->mass_kg[dof[i]]);
    }
}

/* Error of the step, the largest of three parts:
 * - in energy terms, sqrt(sum of (error of q')^2 + omega^2 (error of q)^2), over the speed of all floors moving with the
 *   ground at its fastest, and that of the initial motion; a free body's displacement counts at 1 rad/s;
 * - what that makes of the floors' total accelerations, over the largest of the structure so far or now, and no less
 *   than the peak of the ground's: fast modes and light floors, whose energy is small, count here;
 * - and of the rows' forces, over what is expected of them. */
static double error_of(const struct thud_state *state, struct dormand_prince *x, double h)
{
    const struct thud_model *m = state->model;
    const struct thud_motion *end = &x->rk->stage[x->rk->tableau->stages - 1];
    const double ground = thud_step_ground(state, h);
    double sum = 0;
    for (int j = 0; j < m->nmodes; j++) {
        double q = 0, qd = 0, w = fmax(m->omega[j], 1);
        for (int i = 0; i < x->rk->tableau->stages; i++) {
            q += difference[i] * x->rk->stage[i].qd[j];
            qd += difference[i] * x->rk->stage[i].qdd[j];
        }
        x->error.q[j] = h * q;
        x->error.qd[j] = h * qd;
        sum += qd * qd + w * w * q * q;
    }
    double error = h * sqrt(sum) / fmax(x->speed, 1e-9);
    thud_step_motion_change(state, end, &x->error);
    for (int s = 0; s < m->nstructures; s++) {
        const struct thud_model_structure *p = &m->structure[s];
        double scale = fmax(x->scale_mps2[s], largest_acceleration(m, p, end->qdd, ground));
        error = fmax(error, largest_acceleration(m, p, x->error.qdd, 0) /
                                fmax(scale, THUD_TOL_LEAST_ACCELERATION_PS2 * state->length_m));
    }
    for (int c = 0; c < m->nrows; c++) {
        const struct thud_contact_state *contact = thud_row_contact(state, c);
        double scale = fmax(fmax(x->scale_n[c], contact ? contact->expected_force_n : 0), fabs(end->force[c]));
        error = fmax(error, fabs(x->error.force[c]) / fmax(scale, thud_contact_least_force(state, c)));
    }
    return isfinite(sum) ? error : INFINITY;
}

static enum thud_status step(const struct thud_state *state, void *own, struct thud_segment *seg,
                             struct thud_error *err)
{
    /* of the tolerance, for one step: errors add up, and impacts make them grow; and for the steps of a whole run */
    static const double step_share = 1e-2, run_share = 500, least_share = 1e-3;
    struct dormand_prince *x = own;
    double remaining = thud_step_room(state);
    thud_rk_start(state, x->rk);
    raise_scales(state, x);
    for (;;) {
        double h = remaining / fmax(1, ceil(remaining / x->h * (1 - THUD_TOL_STEP_COUNT)));
        thud_rk_stages(state, x->rk, h);
        double error = error_of(state, x, h);
        double tolerance = thud_smaller(step_share, fmax(least_share, run_share * h / state->end_s)) * state->tolerance;
        double factor = isfinite(error) ? 0.9 * pow(tolerance / fmax(error, 1e-10 * tolerance), 0.2) : 0.1;
        factor = fmin(5, fmax(0.1, factor));
        if (error <= tolerance) {
            x->h = factor > 1 ? fmax(x->h, factor * h) : factor * h; /* a step cut short to end at a kink says little */
            thud_step_write(state, seg, h, x->rk->stage, &x->rk->stage[x->rk->tableau->stages - 1], &x->rk->work);
            return THUD_OK;
        }
        x->h = fmin(factor, 0.9) * h;
        state->work->rejected++;
        if (h < THUD_TOL_LEAST_STEP * state->end_s)
            return thud_error_set(err, THUD_DIVERGED, "no step is short enough at t = %.6g s", thud_state_now(state));
    }
}

static void committed(const struct thud_state *state, void *own, const struct thud_segment *seg, double tau_s,
                      bool switched)
{
    struct dormand_prince *x = own;
    if (tau_s <= 0) /* an event at the very start: another step would see another end of the same motion */
        x->h = fmin(x->h, seg->h_s);
    thud_rk_committed(state, x->rk, seg, tau_s, switched);
}

const struct thud_stepper thud_dormand_prince_stepper = {create, step, committed};
