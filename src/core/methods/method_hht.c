/* Hilber, Hughes and Taylor's alpha method: the scheme of alpha_step.h with am = 0 and, for alpha = -0.1,
 *     af = -alpha = 0.1,   beta = (1 + af)^2/4 = 0.3025,   gamma = 1/2 + af = 0.6 ,
 * of order 2 and unconditionally stable in linear structures. Modes that the step does not resolve lose about a fifth of
 * their amplitude in each step. */
#include <math.h>

#include "core/methods/alpha_step.h"

const struct thud_method thud_method_hht = {
    .name = "hht",
    .title = "Hilber, Hughes and Taylor, alpha -0.1",
    .reference = "Hilber, Hughes and Taylor, Earthquake Engineering and Structural Dynamics 5 (1977) 283-292",
    .summary = "implicit; damps what the step cannot resolve",
    .flags = THUD_METHOD_FIXED_STEP | THUD_METHOD_LOCATES | THUD_METHOD_CAN_LOCATE,
    .order = 2,
    .stability = INFINITY,
    .limits = "none in linear structures; in contact a large step damps or gains at random",
    .stepper = &thud_alpha_stepper,
    .scheme = &(const struct thud_alpha){.af = 0.1, .beta = 0.3025, .gamma = 0.6},
};
