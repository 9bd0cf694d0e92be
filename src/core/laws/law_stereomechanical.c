/* Newton's impact: no force, but an impulse at d = 0 with v > 0 (Newton 1687; Papadrakakis and Mouzakis 1995).
 *     p = (1 + e) m v
 * Assumes that contact takes no time. Impulses at one instant are one linear complementarity problem (impulse.c). Not for
 * forces or accelerations of the floors that are struck: there are none. */
#include "core/laws/law_common.h"

enum { RESTITUTION };

static const struct thud_param params[] = {THUD_PARAM_RESTITUTION_OF(
    0.6, false, "Separation over approach velocity of two free bodies; 0: plastic.")}; /* both sides go on together */

static double restitution(const struct thud_law_setup *setup, double v_mps)
{
    (void)v_mps;
    return setup->value[RESTITUTION];
}

const struct thud_law thud_law_stereomechanical = {
    .name = "stereomechanical",
    .title = "impulse with restitution",
    .reference = "Newton, Philosophiae Naturalis Principia Mathematica, London (1687); "
                 "Papadrakakis and Mouzakis, Earthquake Engineering and Structural Dynamics 24 (1995) 811-834",
    .summary = "no force: at d = 0, v > 0 an impulse (1 + e) m v on each side",
    .flags = THUD_LAW_IMPULSIVE | THUD_LAW_DEGREE_ONE,
    THUD_LAW_PARAMS(params),
    .restitution = restitution,
};
