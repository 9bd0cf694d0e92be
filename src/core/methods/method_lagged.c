/* Newmark's average acceleration with the contact force of the step's start in the whole step: what comes of eq. (1) read
 * as a rule that yields a force after the motion is known. A demonstration of why that must not be done. The force comes
 * a step late on the way in and on the way out, so it has a part -F' h, in phase with the velocity: a dashpot of negative
 * coefficient, -k h. With omega^2 = k/m, an elastic impact takes pi/omega and leaves exp(pi omega h/2) times as fast. */
#include <math.h>

#include "core/methods/alpha_step.h"

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
    .stepper = &thud_alpha_stepper,
    .scheme = &(const struct thud_alpha){.beta = 0.25, .gamma = 0.5, .lagged = true},
};
