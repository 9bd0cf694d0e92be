/* An example of a law: material that yields and keeps what it yielded,
 *     loading      F = k1 d up to d_y, then k1 d_y + k2 (d - d_y)
 *     unloading    F = k1 (d - d_p) down to F = 0, where the indentation d_p is left
 *     reloading    along the line of unloading up to the largest force so far, then along k2
 * residual keep: d_p widens the clearance, and the next contact begins there; recover: the clearance stays, and the next
 * contact has no force before d_p. The motion is the same. */
#include "core/laws/law_common.h"

enum { STIFFNESS, HARDENING, YIELD, RESIDUAL };
enum { PLASTIC, HARDER }; /* in the memory: d_p of this contact; largest force so far over k1, less d_y */
enum { KEEP, RECOVER };

static const char *const residual_choices[] = {"keep", "recover", NULL};
static const struct thud_param params[] = {
    THUD_PARAM_STIFFNESS,
    {.name = "hardening",
     .title = "hardening ratio k2/k1",
     .help = "Slope past the yield indentation, over the stiffness.",
     .unit = "",
     .fallback = 0.1,
     .least = 0,
     .most = 1,
     .soft_least = NAN,
     .soft_most = NAN},
    {.name = "yield-indentation",
     .title = "yield indentation",
     .help = "Indentation at which the material yields first.",
     .dimension = THUD_LENGTH,
     .unit = "mm",
     .fallback = 1e-3,
     .least = 0,
     .most = 1,
     .least_open = true,
     .soft_least = NAN,
     .soft_most = NAN},
    {.name = "residual",
     .title = "indentation left at release",
     .help = "keep: it widens the clearance; recover: the next contact goes through it without force.",
     .kind = THUD_PARAM_CHOICE,
     .unit = "",
     .fallback = KEEP,
     .least = NAN,
     .most = NAN,
     .soft_least = NAN,
     .soft_most = NAN,
     .choices = residual_choices},
};

static double yield_now(const struct thud_law_setup *setup, const struct thud_law_memory *memory)
{
    return setup->value[YIELD] + memory->own[HARDER];
}

static bool keeps_residual(const struct thud_law_setup *setup)
{
    return setup->value[RESIDUAL] == KEEP;
}

static void onset(const struct thud_law_setup *setup, double v_mps, struct thud_law_memory *memory)
{
    (void)v_mps;
    if (keeps_residual(setup))
        memory->own[PLASTIC] = 0;
}

static double ultimate(const struct thud_law_setup *setup, const struct thud_law_memory *memory, enum thud_phase phase)
{
    return phase == THUD_RESTITUTION ? INFINITY : memory->own[PLASTIC] + yield_now(setup, memory);
}

static struct thud_branch branch(const struct thud_law_setup *setup, const struct thud_law_memory *memory,
                                 enum thud_phase phase, bool past_ultimate)
{
    double k1 = setup->value[STIFFNESS], k2 = setup->value[HARDENING] * k1;
    if (!past_ultimate)
        return (struct thud_branch){.f0_n = -k1 * memory->own[PLASTIC], .k_npm = k1};
    return (struct thud_branch){.f0_n = k1 * yield_now(setup, memory) - k2 * ultimate(setup, memory, phase),
                                .k_npm = k2};
}

/* Over k1, in approach. */
static double force(const struct thud_law_setup *setup, const struct thud_law_memory *memory, double d)
{
    double past = d - ultimate(setup, memory, THUD_APPROACH);
    return past > 0 ? yield_now(setup, memory) + setup->value[HARDENING] * past : d - memory->own[PLASTIC];
}

static void reversal(const struct thud_law_setup *setup, enum thud_phase phase, double d_m,
                     struct thud_law_memory *memory)
{
    if (phase == THUD_APPROACH || d_m <= ultimate(setup, memory, THUD_APPROACH))
        return;
    double f = force(setup, memory, d_m);
    memory->own[PLASTIC] = d_m - f;
    memory->own[HARDER] = f - setup->value[YIELD];
}

static double elastic_energy(const struct thud_law_setup *setup, const struct thud_law_memory *memory, double d_m)
{
    double f = fmax(force(setup, memory, d_m), 0);
    return 0.5 * setup->value[STIFFNESS] * f * f;
}

static double restitution(const struct thud_law_setup *setup, double v_mps)
{
    double y = setup->value[YIELD], r = setup->value[HARDENING];
    double energy = 0.5 * setup->mass_kg * v_mps * v_mps / setup->value[STIFFNESS], left = energy - 0.5 * y * y;
    if (left <= 0)
        return 1;
    double f = y + r * 2 * left / (y + sqrt(y * y + 2 * r * left)); /* y x + r x^2/2 = left */
    return sqrt(0.5 * f * f / energy);
}

extern const struct thud_law thud_law_permanent_indentation;
const struct thud_law thud_law_permanent_indentation = {
    .name = "permanent-indentation",
    .title = "material that yields",
    .reference = "an example of the tests",
    .summary = "F = k1 d up to d_y, then with slope k2; back along k1",
    .flags = THUD_LAW_LINEAR | THUD_LAW_REVERSES,
    THUD_LAW_PARAMS(params),
    .onset = onset,
    .reversal = reversal,
    .branch = branch,
    .ultimate = ultimate,
    .elastic_energy = elastic_energy,
    .restitution = restitution,
    .keeps_residual = keeps_residual,
};
