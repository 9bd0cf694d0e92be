/* Hertz's contact of two elastic spheres (Hertz 1882; Jing and Young 1991; Chau and Wei 2001).
 *     F = k d^1.5
 * Assumes quasi-static elastic contact: nothing is lost. */
#include "core/laws/law_common.h"

enum { STIFFNESS };

static const struct thud_param params[] = {THUD_PARAM_HERTZ_STIFFNESS};
static const double exponent = 1.5;

static struct thud_branch branch(const struct thud_law_setup *setup, const struct thud_law_memory *memory,
                                 enum thud_phase phase, bool past_ultimate)
{
    (void)memory;
    (void)phase;
    (void)past_ultimate;
    return (struct thud_branch){.K = setup->value[STIFFNESS], .p = exponent};
}

static double elastic_energy(const struct thud_law_setup *setup, const struct thud_law_memory *memory, double d_m)
{
    (void)memory;
    return thud_law_power_energy(setup->value[STIFFNESS], exponent, d_m);
}

const struct thud_law thud_law_hertz = {
    .name = "hertz",
    .title = "Hertz",
    .reference = "Hertz, Journal fuer die reine und angewandte Mathematik 92 (1882) 156-171; "
                 "Jing and Young, Earthquake Engineering and Structural Dynamics 20 (1991) 667-681; "
                 "Chau and Wei, Earthquake Engineering and Structural Dynamics 30 (2001) 633-651",
    .summary = "F = k d^1.5",
    THUD_LAW_PARAMS(params),
    .branch = branch,
    .elastic_energy = elastic_energy,
    .nominal = thud_law_nominal_one,
    .restitution = thud_law_restitution_one,
};
