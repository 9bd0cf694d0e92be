/* Hertz with damping in proportion to the elastic force, in approach and restitution alike (Lankarani and Nikravesh
 * 1990; Muthukumar and DesRoches 2006).
 *     F = k d^n (1 + s v/v0)
 * v0 is the approach velocity at contact onset, and s follows from e by one of four formulas; only `exact` makes two
 * free bodies part with e. The damping cannot be set by the energy at the reversal, as approach needs it before any
 * energy is stored: at grazing contacts it is very stiff, and v0 has a floor. */
#include "core/laws/law_closed_form.h"
#include "core/laws/law_common.h"

enum { STIFFNESS, EXPONENT, RESTITUTION, FORMULA, SPEED_FLOOR };
enum { S };
enum { DAMP }; /* in the memory: s over the approach velocity */
enum { MUTHUKUMAR, HUNT_CROSSLEY, YE_FLORES, EXACT };

static const char *const formula_choices[] = {"muthukumar", "hunt-crossley", "ye-flores", "exact", NULL};

static const struct thud_param params[] = {
    THUD_PARAM_HERTZ_STIFFNESS,
    THUD_PARAM_EXPONENT(1.5),
    THUD_PARAM_RESTITUTION(0.6),
    THUD_PARAM_ONE_OF(
        "formula", "damping from restitution",
        "muthukumar: s = 3(1-e^2)/4; hunt-crossley: 3(1-e)/2; ye-flores: 8(1-e)/(5e); exact: parts with e.", MUTHUKUMAR,
        formula_choices),
    THUD_PARAM_SPEED_FLOOR,
};

static double formula(int which, double e)
{
    switch (which) {
    case HUNT_CROSSLEY:
        return 1.5 * (1 - e);
    case YE_FLORES:
        return 1.6 * (1 - e) / e;
    case EXACT:
        return thud_hertz_damp_s(e);
    default:
        return 0.75 * (1 - e * e);
    }
}

static enum thud_status prepare(struct thud_law_setup *setup, struct thud_error *err)
{
    setup->constant[S] = formula((int)setup->value[FORMULA], setup->value[RESTITUTION]);
    return thud_law_check_hertz_stiffness(setup->value[STIFFNESS], setup->value[EXPONENT], err);
}

static void onset(const struct thud_law_setup *setup, double v_mps, struct thud_law_memory *memory)
{
    double v = fmax(v_mps, setup->value[SPEED_FLOOR]);
    memory->own[DAMP] = setup->constant[S] / v;
}

static struct thud_branch branch(const struct thud_law_setup *setup, const struct thud_law_memory *memory,
                                 enum thud_phase phase, bool past_ultimate)
{
    (void)phase;
    (void)past_ultimate;
    double k = setup->value[STIFFNESS], n = setup->value[EXPONENT];
    return (struct thud_branch){.K = k, .p = n, .D = k * memory->own[DAMP], .r = n};
}

static double restitution(const struct thud_law_setup *setup, double v_mps)
{
    struct thud_law_memory memory;
    onset(setup, v_mps, &memory);
    return thud_hertz_damp_restitution(memory.own[DAMP] * v_mps);
}

const struct thud_law thud_law_hertz_damp = {
    .name = "hertz-damp",
    .title = "Hertz with nonlinear damping",
    .reference =
        "Lankarani and Nikravesh, Journal of Mechanical Design 112 (1990) 369-376; "
        "muthukumar: Muthukumar and DesRoches, Earthquake Engineering and Structural Dynamics 35 (2006) 811-828; "
        "hunt-crossley: Hunt and Crossley, Journal of Applied Mechanics 42 (1975) 440-445; "
        "ye-flores: Ye, Li and Zhu, Earthquake Engineering and Structural Dynamics 38 (2009) 1135-1142; "
        "Flores, Machado, Silva and Martins, Multibody System Dynamics 25 (2011) 357-375",
    .summary = "F = k d^n (1 + s v/v0), s from e by the formula chosen",
    THUD_LAW_PARAMS(params),
    .prepare = prepare,
    .onset = onset,
    .branch = branch,
    .elastic_energy = thud_law_energy_power,
    .restitution = restitution,
};
