/* No pounding: the bodies pass through each other. */
#include "core/laws/law_common.h"

static double no_restitution(const struct thud_law_setup *setup)
{
    (void)setup;
    return NAN; /* nothing is ever touched */
}

static double no_restitution_at(const struct thud_law_setup *setup, double v_mps)
{
    (void)v_mps;
    return no_restitution(setup);
}

const struct thud_law thud_law_none = {
    .name = "none",
    .title = "no pounding",
    .reference = "for comparison",
    .summary = "F = 0",
    .flags = THUD_LAW_NO_FORCE,
    .prepare = thud_law_prepare_nothing,
    .onset = thud_law_onset_plain,
    .branch = thud_law_branch_none,
    .elastic_energy = thud_law_energy_none,
    .nominal = no_restitution,
    .restitution = no_restitution_at,
};
