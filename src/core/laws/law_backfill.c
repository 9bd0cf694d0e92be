/* Soil behind a wall (Duncan and Mokwa 2001; Shamsabadi, Rollins and Kapuskar 2007), in compression alone. With x the
 * displacement into the soil since it was filled in,
 *     loading      F = x/(1/K_max + R_f x/F_ult)
 *     unloading    F = F_r - K_max (x_r - x) from the largest x_r so far, and back along the same line
 * Where the line has come to F = 0 a gap stays: the residual of the contact. Of the law's own,
 *     x = shift + d,   zero = x_r - F_r/K_max - shift,
 * with the indentation d beyond the gap that earlier contacts have left, which is `shift`. It acts between a wall and the
 * ground behind it; bodies that strike each other have none. */
#include <math.h>

#include "core/laws/law_common.h"

enum { STIFFNESS, STRENGTH, RATIO };
enum { SHIFT, LARGEST, ZERO }; /* of the memory; LARGEST: x_r - shift */

static const struct thud_param params[] = {
    THUD_PARAM_STIFFNESS,
    {.name = "strength", .title = "ultimate force", .dimension = THUD_FORCE, .unit = "kN", .fallback = NAN},
    {.name = "ratio", .title = "failure ratio", .dimension = THUD_NUMBER, .unit = "", .fallback = 0.7}};

static struct thud_branch loading(const struct thud_law_setup *setup, const struct thud_law_memory *memory)
{
    return (struct thud_branch){.K = setup->value[STIFFNESS],
                                .p = 1,
                                .soft_m = setup->value[STRENGTH] / (setup->value[RATIO] * setup->value[STIFFNESS]),
                                .shift_m = memory->own[SHIFT]};
}

static double force(const struct thud_law_setup *setup, const struct thud_law_memory *memory, double d_m)
{
    const struct thud_branch curve = loading(setup, memory);
    return d_m > memory->own[LARGEST] ? thud_branch_force(&curve, d_m, 0, NULL, NULL)
                                      : setup->value[STIFFNESS] * fmax(d_m - memory->own[ZERO], 0);
}

static void onset(const struct thud_law_setup *setup, double v_mps, struct thud_law_memory *memory)
{
    (void)setup;
    (void)v_mps;
    memory->own[SHIFT] += memory->own[ZERO];
    memory->own[LARGEST] -= memory->own[ZERO];
    memory->own[ZERO] = 0;
}

static void reversal(const struct thud_law_setup *setup, enum thud_phase phase, double d_m,
                     struct thud_law_memory *memory)
{
    if (phase != THUD_RESTITUTION || !(d_m > memory->own[LARGEST]))
        return;
    memory->own[ZERO] = d_m - force(setup, memory, d_m) / setup->value[STIFFNESS];
    memory->own[LARGEST] = d_m;
}

static struct thud_branch branch(const struct thud_law_setup *setup, const struct thud_law_memory *memory,
                                 enum thud_phase phase, bool past_ultimate)
{
    const double k = setup->value[STIFFNESS];
    if (phase == THUD_RESTITUTION || (memory->own[LARGEST] > 0 && !past_ultimate))
        return (struct thud_branch){.f0_n = -k * memory->own[ZERO], .k_npm = k};
    return loading(setup, memory);
}

static double ultimate(const struct thud_law_setup *setup, const struct thud_law_memory *memory, enum thud_phase phase)
{
    (void)setup;
    return phase == THUD_APPROACH && memory->own[LARGEST] > 0 ? memory->own[LARGEST] : INFINITY;
}

static double elastic_energy(const struct thud_law_setup *setup, const struct thud_law_memory *memory, double d_m)
{
    const double f = force(setup, memory, d_m);
    return 0.5 * f * f / setup->value[STIFFNESS];
}

static bool keeps_residual(const struct thud_law_setup *setup)
{
    (void)setup;
    return true;
}

const struct thud_law thud_law_backfill = {
    .name = "backfill",
    .title = "soil behind a wall",
    .reference =
        "Duncan and Mokwa, Journal of Geotechnical and Geoenvironmental Engineering 127 (2001) 248-257; "
        "Shamsabadi, Rollins and Kapuskar, Journal of Geotechnical and Geoenvironmental Engineering 133 (2007) "
        "707-720",
    .summary = "loading F = x/(1/K + R x/F_ult); unloading and reloading with K",
    .flags = THUD_LAW_REVERSES,
    THUD_LAW_PARAMS(params),
    .onset = onset,
    .reversal = reversal,
    .branch = branch,
    .ultimate = ultimate,
    .elastic_energy = elastic_energy,
    .keeps_residual = keeps_residual,
};
