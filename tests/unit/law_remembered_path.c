/* An example of a law: filled rubber that softens (Mullins' effect) by friction inside,
 *     first loading                                              F = k d
 *     below the largest indentation d_m so far, back and again   F = e^2 k d
 * The path of reloading is the one remembered from the contacts before. All branches are straight lines, but at the end
 * of a first loading they do not meet: a contact that is pushed there sticks between them. */
#include "core/laws/law_common.h"

enum { STIFFNESS, RESTITUTION };
enum { DEEPEST }; /* in the memory: d_m */

static const struct thud_param params[] = {THUD_PARAM_STIFFNESS, THUD_PARAM_RESTITUTION(0.6)};

static double part(const struct thud_law_setup *setup)
{
    return setup->value[RESTITUTION] * setup->value[RESTITUTION];
}

static double ultimate(const struct thud_law_setup *setup, const struct thud_law_memory *memory, enum thud_phase phase)
{
    (void)setup;
    return phase == THUD_RESTITUTION || memory->own[DEEPEST] == 0 ? INFINITY : memory->own[DEEPEST];
}

static struct thud_branch branch(const struct thud_law_setup *setup, const struct thud_law_memory *memory,
                                 enum thud_phase phase, bool past_ultimate)
{
    bool first = phase == THUD_APPROACH && (past_ultimate || memory->own[DEEPEST] == 0);
    return (struct thud_branch){.k_npm = (first ? 1 : part(setup)) * setup->value[STIFFNESS]};
}

static void reversal(const struct thud_law_setup *setup, enum thud_phase phase, double d_m,
                     struct thud_law_memory *memory)
{
    (void)setup;
    if (phase == THUD_RESTITUTION)
        memory->own[DEEPEST] = fmax(memory->own[DEEPEST], d_m);
}

static double elastic_energy(const struct thud_law_setup *setup, const struct thud_law_memory *memory, double d_m)
{
    (void)memory;
    return part(setup) * thud_law_power_energy(setup->value[STIFFNESS], 1, d_m);
}

static double restitution(const struct thud_law_setup *setup, double v_mps)
{
    (void)v_mps;
    return setup->value[RESTITUTION];
}

extern const struct thud_law thud_law_remembered_path;
const struct thud_law thud_law_remembered_path = {
    .name = "remembered-path",
    .title = "rubber that softens",
    .reference = "an example of the tests",
    .summary = "F = k d, and e^2 k d below the largest indentation so far",
    .flags = THUD_LAW_LINEAR | THUD_LAW_REVERSES | THUD_LAW_DEGREE_ONE,
    THUD_LAW_PARAMS(params),
    .reversal = reversal,
    .branch = branch,
    .ultimate = ultimate,
    .elastic_energy = elastic_energy,
    .restitution = restitution,
};
