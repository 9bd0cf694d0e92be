#include "core/methods/dormand_prince.h"

#include <math.h>
#include <stdlib.h>

#include "core/methods/runge_kutta.h"
#include "core/numerics/tolerance.h"

static const struct thud_tableau tableau = {
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
    struct thud_rk rk;
    double h;     /* to try next */
    double speed; /* modal speed in which errors are measured */
};

enum thud_status thud_dormand_prince_create(const struct thud_state *state, void **own, struct thud_error *err)
{
    struct dormand_prince *x = *own = calloc(1, sizeof *x);
    if (!x || thud_rk_init(&x->rk, state, &tableau, err) != THUD_OK) {
        free(x);
        *own = NULL;
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    double mass = 0;
    for (int j = 0; j < state->model->nmodes; j++)
        mass += state->model->gamma[j] * state->model->gamma[j];
    x->h = thud_state_default_step(state);
    x->speed = sqrt(mass) * thud_record_speed(state->record) +
               sqrt(2 * (thud_state_kinetic(state) + thud_state_strain(state)));
    return THUD_OK;
}

void thud_dormand_prince_free(void *own)
{
    struct dormand_prince *x = own;
    if (!x)
        return;
    thud_rk_clear(&x->rk);
    free(x);
}

/* Error of the step in energy terms, sqrt(sum of (error of q')^2 + omega^2 (error of q)^2), over the absolute scale:
 * the speed of all floors moving with the ground at its fastest, and that of the initial motion. A free body's
 * displacement counts at 1 rad/s. */
static double error_of(const struct thud_state *state, const struct dormand_prince *x, double h)
{
    const struct thud_model *m = state->model;
    double sum = 0;
    for (int j = 0; j < m->nmodes; j++) {
        double q = 0, qd = 0, w = fmax(m->omega[j], 1);
        for (int i = 0; i < tableau.stages; i++) {
            q += difference[i] * x->rk.stage[i].qd[j];
            qd += difference[i] * x->rk.stage[i].qdd[j];
        }
        sum += qd * qd + w * w * q * q;
    }
    return h * sqrt(sum) / fmax(x->speed, 1e-9);
}

enum thud_status thud_dormand_prince_step(const struct thud_state *state, void *own, struct thud_segment *seg,
                                          struct thud_error *err)
{
    static const double share = 1e-2; /* of the tolerance, for one step: errors add up, and impacts make them grow */
    struct dormand_prince *x = own;
    double tolerance = share * state->tolerance, remaining = thud_step_room(state);
    thud_rk_start(state, &x->rk);
    for (;;) {
        double h = remaining / fmax(1, ceil(remaining / x->h * (1 - THUD_TOL_STEP_COUNT)));
        thud_rk_stages(state, &x->rk, h);
        double error = error_of(state, x, h);
        double factor = isfinite(error) ? 0.9 * pow(tolerance / fmax(error, 1e-10 * tolerance), 0.2) : 0.1;
        factor = fmin(5, fmax(0.1, factor));
        if (error <= tolerance) {
            x->h = factor > 1 ? fmax(x->h, factor * h) : factor * h; /* a step cut short to end at a kink says little */
            thud_rk_write(state, seg, &x->rk, h);
            return THUD_OK;
        }
        x->h = fmin(factor, 0.9) * h;
        state->work->rejected++;
        if (h < THUD_TOL_LEAST_STEP * state->end_s)
            return thud_error_set(err, THUD_DIVERGED, "no step is short enough at t = %.6g s", thud_state_now(state));
    }
}

void thud_dormand_prince_committed(const struct thud_state *state, void *own, const struct thud_segment *seg,
                                   double tau_s, bool switched)
{
    struct dormand_prince *x = own;
    if (tau_s <= 0) /* an event at the very start: another step would see another end of the same motion */
        x->h = fmin(x->h, seg->h_s);
    thud_rk_committed(state, seg, &x->rk, switched);
}
