/* Newmark's linear acceleration: beta 1/6, gamma 1/2 in alpha_step.h. The period is off by (omega h)^2/24, half as much as
 * with average acceleration, and the price is a limit: omega h < 1/sqrt(gamma/2 - beta) = 2 sqrt(3). */
#include <math.h>

#include "core/methods/alpha_step.h"

const struct thud_method thud_method_newmark_linear = {
    .name = "newmark-linear",
    .title = "Newmark, linear acceleration",
    .reference = "Newmark, Journal of the Engineering Mechanics Division 85 (1959) 67-94, beta 1/6, gamma 1/2",
    .summary = "implicit; smaller period error than average acceleration, but stable for small steps only",
    .flags = THUD_METHOD_FIXED_STEP | THUD_METHOD_LOCATES | THUD_METHOD_CAN_LOCATE,
    .order = 2,
    .stability = 3.4641016151377544,
    .limits = "stable while omega dt < 2 sqrt(3), but contacts that open and close may gain energy below",
    .stepper = &thud_alpha_stepper,
    .scheme = &(const struct thud_alpha){.beta = 1.0 / 6, .gamma = 0.5},
};
