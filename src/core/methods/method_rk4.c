/* Kutta's classical method, of which the fifth stage is the end of the step (weights 1/6, 1/3, 1/3, 1/6): its right-hand
 * side is the next step's first, so a step costs four evaluations. Between the ends the motion is the quintic through q,
 * q', q'' of both (stepping.h), of order 5: what is located or read there is no less accurate than the steps. */
#include "core/methods/runge_kutta.h"

/* Rows 1 to 3 are the stages, row 4 the weights of the step. */
static const struct thud_tableau tableau = {
    .stages = 5,
    .c = {0, 0.5, 0.5, 1, 1},
    .a = {{0}, {0.5}, {0, 0.5}, {0, 0, 1}, {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6}},
};

static enum thud_status step(const struct thud_state *state, void *own, struct thud_segment *seg,
                             struct thud_error *err)
{
    struct thud_rk *rk = own;
    double h = thud_step_length(state);
    (void)err;
    thud_rk_start(state, rk);
    thud_rk_stages(state, rk, h);
    thud_step_write(state, seg, h, &rk->stage[0], &rk->stage[tableau.stages - 1], &rk->work);
    return THUD_OK;
}

const struct thud_method thud_method_rk4 = {
    .name = "rk4",
    .title = "Runge-Kutta of order 4",
    .reference = "Kutta, Zeitschrift fuer Mathematik und Physik 46 (1901) 435-453",
    .summary = "explicit, four evaluations a step; of order 4 only where impacts are located",
    .flags = THUD_METHOD_FIXED_STEP | THUD_METHOD_LOCATES | THUD_METHOD_CAN_LOCATE,
    .order = 4,
    .stability = 2.8284271247461903,
    .limits = "stable while omega dt < 2 sqrt(2), but contacts that open and close may gain energy below",
    .stepper = &(const struct thud_stepper){thud_rk_create, step, thud_rk_committed},
    .scheme = &tableau,
};
