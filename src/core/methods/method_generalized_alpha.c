/* Chung and Hulbert's generalized-alpha method, by the one number that they leave free: the spectral radius rho of modes
 * that the step does not resolve.
 *     am = (2 rho - 1)/(rho + 1),   af = rho/(rho + 1),   gamma = 1/2 - am + af,   beta = (1 - am + af)^2/4
 * make it of order 2, unconditionally stable in linear structures, and of all such schemes that with the least damping of
 * low modes for this damping of high ones. The acceleration is the scheme's own (alpha_step.h). */
#include <math.h>

#include "core/methods/alpha_step.h"

#define RHO 0.8
#define AM  ((2 * RHO - 1) / (RHO + 1))
#define AF  (RHO / (RHO + 1))

const struct thud_method thud_method_generalized_alpha = {
    .name = "generalized-alpha",
    .title = "Generalized-alpha, spectral radius 0.8",
    .reference = "Chung and Hulbert, Journal of Applied Mechanics 60 (1993) 371-375",
    .summary = "implicit; damps high frequencies most, low ones least",
    .flags = THUD_METHOD_FIXED_STEP | THUD_METHOD_LOCATES | THUD_METHOD_CAN_LOCATE,
    .order = 2,
    .stability = INFINITY,
    .limits = "none in linear structures; in contact a large step damps or gains at random",
    .stepper = &thud_alpha_stepper,
    .scheme = &(const struct thud_alpha){AM, AF, 0.25 * (1 - AM + AF) * (1 - AM + AF), 0.5 - AM + AF, false},
};
