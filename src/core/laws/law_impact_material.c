/* The bilinear contact of OpenSees' ImpactMaterial, to reproduce models made with it (Muthukumar and DesRoches 2006).
 * With d the indentation, two lines
 *     upper    K1 d up to d_y, then K1 d_y + K2 (d - d_y)
 *     lower    K2 d
 * Loading has the slope K1 from wherever it is until it meets the upper line, and follows it; unloading has the slope K1
 * until it meets the lower one, and follows that. So
 *     F = K2 d + (K1 - K2) (d - a),    0 <= d - a <= d_y ,
 * where a is 0 at contact onset and moves with d where d - a would leave its interval (a play): all that the contact
 * remembers. It does not depend on the rate, is never in tension, and is 0 only at d = 0.
 *
 * K1, K2 and d_y are given, or follow from a Hertz contact k_h d^1.5 with restitution e, at the largest indentation d_m
 * that is expected, with a = d_y/d_m = 0.1:
 *     E = k_h d_m^2.5 (1 - e^2)/2.5,   K_eff = k_h sqrt(d_m),
 *     K1 = K_eff + E/(a d_m^2),        K2 = K_eff - E/((1 - a) d_m^2) .
 * The loop up to d_m loses E, as meant. But the formulas take k_h d_m^2.5/2.5 for the energy that goes in, and the lines
 * take in more: the restitution at d_m is not e (0.77 for 0.6), and at any other depth it is another one. Not for damping
 * that is to be chosen by a restitution. */
#include "core/laws/law_common.h"

enum { STIFFNESS, RESTITUTION, MAX_INDENTATION, INITIAL, SECONDARY, YIELD };
enum { K1, K2, DY };
enum { SLIP }; /* in the memory: a */

static const double yield_ratio = 0.1;

/* clang-format off */
static const struct thud_param params[] = {
    [STIFFNESS] = THUD_PARAM_HERTZ_STIFFNESS,
    [RESTITUTION] = THUD_PARAM_RESTITUTION(0.6),
    [MAX_INDENTATION] = {.name = "max-indentation", .title = "largest indentation expected",
     .help = "Indentation at which the loop loses what the restitution asks of a Hertz contact.",
     .kind = THUD_PARAM_QUANTITY, .dimension = THUD_LENGTH, .unit = "mm",
     .fallback = 10e-3, .least = 0, .most = 1, .least_open = true, .soft_least = 1e-3, .soft_most = 50e-3},
    [INITIAL] = {.name = "initial-stiffness", .title = "initial stiffness K1",
     .help = "Slope of loading and unloading between the two lines; with K2 and d_y instead of the first three.",
     .kind = THUD_PARAM_QUANTITY, .dimension = THUD_STIFFNESS, .unit = "kN/mm",
     .fallback = NAN, .least = 0, .most = NAN, .least_open = true, .soft_least = NAN, .soft_most = NAN},
    [SECONDARY] = {.name = "secondary-stiffness", .title = "secondary stiffness K2",
     .help = "Slope of the two lines past the yield indentation.",
     .kind = THUD_PARAM_QUANTITY, .dimension = THUD_STIFFNESS, .unit = "kN/mm",
     .fallback = NAN, .least = 0, .most = NAN, .least_open = true, .soft_least = NAN, .soft_most = NAN},
    [YIELD] = {.name = "yield-indentation", .title = "yield indentation d_y",
     .help = "Indentation at which the first loading meets the upper line.",
     .kind = THUD_PARAM_QUANTITY, .dimension = THUD_LENGTH, .unit = "mm",
     .fallback = NAN, .least = 0, .most = 1, .least_open = true, .soft_least = NAN, .soft_most = NAN},
};
/* clang-format on */

static enum thud_status refuse(struct thud_error *err, int param, const char *what, const char *allowed)
{
    return thud_error_refuse(err, THUD_INPUT, params[param].name, allowed, "%s", what);
}

static bool has_lines(const struct thud_law_setup *setup)
{
    return !isnan(setup->value[INITIAL]);
}

static enum thud_status take_lines(struct thud_law_setup *setup, struct thud_error *err)
{
    static const char all[] = "initial-stiffness, secondary-stiffness and yield-indentation together, or none of them";
    for (int i = INITIAL; i <= YIELD; i++)
        if (isnan(setup->value[i]))
            return refuse(err, i, "not given, but the other values of the two lines are", all);
    for (int i = STIFFNESS; i <= MAX_INDENTATION; i++)
        if (setup->value[i] != params[i].fallback)
            return refuse(err, i, "given as well as the two lines, which replace it", all);
    if (setup->value[SECONDARY] > setup->value[INITIAL])
        return refuse(err, SECONDARY, "above the initial stiffness: the contact would give energy",
                      "up to initial-stiffness");
    for (int i = 0; i < 3; i++)
        setup->constant[K1 + i] = setup->value[INITIAL + i];
    return THUD_OK;
}

static enum thud_status prepare(struct thud_law_setup *setup, struct thud_error *err)
{
    for (int i = INITIAL; i <= YIELD; i++)
        if (!isnan(setup->value[i]))
            return take_lines(setup, err);
    double e = setup->value[RESTITUTION], dm = setup->value[MAX_INDENTATION], a = yield_ratio;
    double effective = setup->value[STIFFNESS] * sqrt(dm), lost = effective * (1 - e * e) / 2.5; /* E/d_m^2 */
    setup->constant[K1] = effective + lost / a;
    setup->constant[K2] = effective - lost / (1 - a);
    setup->constant[DY] = a * dm;
    return THUD_OK;
}

static void onset(const struct thud_law_setup *setup, double v_mps, struct thud_law_memory *memory)
{
    (void)setup;
    (void)v_mps;
    memory->own[SLIP] = 0;
}

static void reversal(const struct thud_law_setup *setup, enum thud_phase phase, double d_m,
                     struct thud_law_memory *memory)
{
    double *slip = &memory->own[SLIP];
    *slip = phase == THUD_RESTITUTION ? fmax(*slip, d_m - setup->constant[DY]) : fmin(*slip, d_m);
}

/* Where loading meets the upper line, and unloading the lower one. */
static double ultimate(const struct thud_law_setup *setup, const struct thud_law_memory *memory, enum thud_phase phase)
{
    return memory->own[SLIP] + (phase == THUD_APPROACH ? setup->constant[DY] : 0);
}

static struct thud_branch branch(const struct thud_law_setup *setup, const struct thud_law_memory *memory,
                                 enum thud_phase phase, bool past_ultimate)
{
    double k1 = setup->constant[K1], k2 = setup->constant[K2];
    if (past_ultimate == (phase == THUD_RESTITUTION)) /* between the lines */
        return (struct thud_branch){.f0_n = (k2 - k1) * memory->own[SLIP], .k_npm = k1};
    return (struct thud_branch){.f0_n = past_ultimate ? (k1 - k2) * setup->constant[DY] : 0, .k_npm = k2};
}

static double elastic_energy(const struct thud_law_setup *setup, const struct thud_law_memory *memory, double d_m)
{
    double k1 = setup->constant[K1], k2 = setup->constant[K2];
    double play = fmin(fmax(d_m - memory->own[SLIP], 0), setup->constant[DY]);
    return 0.5 * (k2 * d_m * d_m + (k1 - k2) * play * play);
}

static double nominal(const struct thud_law_setup *setup)
{
    return has_lines(setup) ? NAN : setup->value[RESTITUTION];
}

/* Of the energy, K1 d_y^2/2 + K1 d_y x + K2 x^2/2 at the indentation d_y + x, the loop keeps (K1 - K2) d_y x. */
static double restitution(const struct thud_law_setup *setup, double v_mps)
{
    double k1 = setup->constant[K1], k2 = setup->constant[K2], force = k1 * setup->constant[DY];
    double energy = 0.5 * setup->mass_kg * v_mps * v_mps, left = energy - 0.5 * force * setup->constant[DY];
    if (left <= 0)
        return 1;
    double x = 2 * left / (force + sqrt(force * force + 2 * k2 * left));
    return sqrt(1 - (k1 - k2) * setup->constant[DY] * x / energy);
}

const struct thud_law thud_law_impact_material = {
    .name = "impact-material",
    .title = "bilinear, as OpenSees' ImpactMaterial",
    .reference = "Muthukumar and DesRoches, Earthquake Engineering and Structural Dynamics 35 (2006) 811-828",
    .summary = "loading and unloading with slope K1 between the lines K2 d + (K1 - K2) d_y and K2 d",
    .flags = THUD_LAW_LINEAR | THUD_LAW_REVERSES,
    THUD_LAW_PARAMS(params),
    .prepare = prepare,
    .onset = onset,
    .reversal = reversal,
    .branch = branch,
    .ultimate = ultimate,
    .elastic_energy = elastic_energy,
    .nominal = nominal,
    .restitution = restitution,
};
