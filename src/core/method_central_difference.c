#include "core/alpha_step.h"
#include "core/method.h"

#include <math.h>

static enum thud_status create(const struct thud_state *state, void **own, struct thud_error *err)
{
    return thud_alpha_create(state, (struct thud_alpha){.gamma = 0.5}, own, err);
}

const struct thud_method thud_method_central_difference = {
    .name = "central-difference",
    .title = "Central difference (velocity Verlet)",
    .reference = "Newmark 1959 with beta 0, gamma 1/2; Stoermer 1907, Verlet 1967",
    .summary = "explicit in the displacements; keeps the energy of a spring in the mean",
    .flags = THUD_METHOD_FIXED_STEP | THUD_METHOD_LOCATES | THUD_METHOD_CAN_LOCATE,
    .order = 2,
    .stability = 2,
    .limits = "stable while omega dt < 2 in linear structures; where contacts open and close it may gain energy below",
    .create = create,
    .step = thud_alpha_step,
    .committed = thud_alpha_committed,
    .free = thud_alpha_free,
};
