/* Newmark's average acceleration, the trapezoidal rule: beta 1/4, gamma 1/2 in alpha_step.h. In linear structures it keeps
 * q'^2 + omega^2 q^2 of every mode for any step, and only the period is off, by (omega h)^2/12 of it. In contact it keeps
 * nothing: the force of a step that touches half way acts as if it had acted all the way. */
#include <math.h>

#include "core/methods/alpha_step.h"

const struct thud_method thud_method_newmark = {
    .name = "newmark",
    .title = "Newmark, average acceleration",
    .reference = "Newmark, Journal of the Engineering Mechanics Division 85 (1959) 67-94, beta 1/4, gamma 1/2",
    .summary = "implicit; keeps the energy of linear structures exactly",
    .flags = THUD_METHOD_FIXED_STEP | THUD_METHOD_LOCATES | THUD_METHOD_CAN_LOCATE,
    .order = 2,
    .stability = INFINITY,
    .limits = "none in linear structures; in contact a large step gains energy",
    .stepper = &thud_alpha_stepper,
    .scheme = &(const struct thud_alpha){.beta = 0.25, .gamma = 0.5},
};
