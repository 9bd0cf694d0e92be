#include "core/methods/alpha_step.h"
#include "core/methods/method.h"

#include <math.h>

static enum thud_status create(const struct thud_state *state, void **own, struct thud_error *err)
{
    return thud_alpha_create(state, (struct thud_alpha){.beta = 0.25, .gamma = 0.5}, own, err);
}

const struct thud_method thud_method_newmark = {
    .name = "newmark",
    .title = "Newmark, average acceleration",
    .reference = "Newmark, Journal of the Engineering Mechanics Division 85 (1959) 67-94, beta 1/4, gamma 1/2",
    .summary = "implicit; keeps the energy of linear structures exactly",
    .flags = THUD_METHOD_FIXED_STEP | THUD_METHOD_LOCATES | THUD_METHOD_CAN_LOCATE,
    .order = 2,
    .stability = INFINITY,
    .limits = "none in linear structures; in contact a large step gains energy",
    .create = create,
    .step = thud_alpha_step,
    .committed = thud_alpha_committed,
    .free = thud_alpha_free,
};
