#include "core/methods/alpha_step.h"
#include "core/methods/method.h"

#include <math.h>

static enum thud_status create(const struct thud_state *state, void **own, struct thud_error *err)
{
    return thud_alpha_create(state, (struct thud_alpha){.beta = 0.25, .gamma = 0.5, .lagged = true}, own, err);
}

const struct thud_method thud_method_lagged = {
    .name = "lagged",
    .title = "Contact force lagged by one step",
    .reference = "Newmark, Journal of the Engineering Mechanics Division 85 (1959) 67-94, beta 1/4, with the contact "
                 "force of the step before",
    .summary = "a demonstration: every impact gains energy",
    .flags = THUD_METHOD_FIXED_STEP | THUD_METHOD_DEMONSTRATION,
    .order = 2,
    .stability = INFINITY,
    .limits = "every elastic impact leaves exp(pi omega dt / 2) times as fast as it came",
    .create = create,
    .step = thud_alpha_step,
    .committed = thud_alpha_committed,
    .free = thud_alpha_free,
};
