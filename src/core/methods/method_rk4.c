/* Kutta's classical method, of which the fifth stage is the end of the step (weights 1/6, 1/3, 1/3, 1/6): its right-hand
 * side is the next step's first, so a step costs four evaluations. Between the ends the motion is the quintic through q,
 * q', q'' of both (stepping.h), of order 5: what is located or read there is no less accurate than the steps. */
#include <stdlib.h>

#include "core/methods/method.h"
#include "core/methods/runge_kutta.h"

/* Rows 1 to 3 are the stages, row 4 the weights of the step. */
static const struct thud_tableau tableau = {
    .stages = 5,
    .c = {0, 0.5, 0.5, 1, 1},
    .a = {{0}, {0.5}, {0, 0.5}, {0, 0, 1}, {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6}},
};

static enum thud_status create(const struct thud_state *state, void **own, struct thud_error *err)
{
    struct thud_rk *rk = *own = calloc(1, sizeof *rk);
    enum thud_status status = rk ? thud_rk_init(rk, state, &tableau, err) : THUD_MEMORY;
    if (status == THUD_OK)
        return status;
    free(rk);
    *own = NULL;
    return thud_error_set(err, THUD_MEMORY, "out of memory");
}

static enum thud_status step(const struct thud_state *state, void *own, struct thud_segment *seg,
                             struct thud_error *err)
{
    double h = thud_step_length(state);
    (void)err;
    thud_rk_start(state, own);
    thud_rk_stages(state, own, h);
    thud_rk_write(state, seg, own, h);
    return THUD_OK;
}

static void committed(const struct thud_state *state, void *own, const struct thud_segment *seg, double tau_s,
                      bool switched)
{
    (void)tau_s;
    thud_rk_committed(state, seg, own, switched);
}

static void release(void *own)
{
    thud_rk_clear(own);
    free(own);
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
    .create = create,
    .step = step,
    .committed = committed,
    .free = release,
};
