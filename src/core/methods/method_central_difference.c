/* Central difference in the form of velocity Verlet: beta 0, gamma 1/2 in alpha_step.h. q1 does not depend on a1, so
 * springs, and with them a contact's indentation, are explicit; the dashpots of modes and contacts are taken at v1 and
 * solved for, where the textbook's central difference of displacements would lag them. Stable while omega h < 2 for every
 * mode and for a closed contact's sqrt(k/m). */
#include <math.h>

#include "core/methods/alpha_step.h"

const struct thud_method thud_method_central_difference = {
    .name = "central-difference",
    .title = "Central difference (velocity Verlet)",
    .reference = "Newmark, Journal of the Engineering Mechanics Division 85 (1959) 67-94, with beta 0, gamma 1/2; "
                 "Verlet, Physical Review 159 (1967) 98-103",
    .summary = "explicit in the displacements; keeps the energy of a spring in the mean",
    .flags = THUD_METHOD_FIXED_STEP | THUD_METHOD_LOCATES | THUD_METHOD_CAN_LOCATE,
    .order = 2,
    .stability = 2,
    .limits = "stable while omega dt < 2, but contacts that open and close may gain energy below",
    .stepper = &thud_alpha_stepper,
    .scheme = &(const struct thud_alpha){.gamma = 0.5},
};
