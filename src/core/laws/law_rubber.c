/* The rubber bumper of Polycarpou and Komodromos 2011, eqs. (4)-(7): a power curve up to the ultimate compression
 * delta_u = max-strain thickness, a stiff line beyond, and damping in restitution only.
 *     approach       F_A = k d^n up to delta_u, then k delta_u^n + k_py (d - delta_u)
 *     restitution    F_R = k d^n (1 + C v)      unloading paper, for every d
 *                    F_R = F_A (1 + C v)        unloading continuous
 * C follows from e and a speed: that of contact onset, or that of the energy stored at the reversal. Eq. (7) for C is a
 * fit in kg and m/s; damping exact solves for C. Past delta_u unloading paper goes to another curve: below the line more is
 * lost than e says, and a contact that is pushed sticks; above it energy is created. Assumes that rubber keeps no set. */
#include "core/laws/law_closed_form.h"
#include "core/laws/law_common.h"

enum {
    STIFFNESS,
    EXPONENT,
    MAX_STRAIN,
    POST_YIELD,
    RESTITUTION,
    DAMPING,
    UNLOADING,
    IMPACT_SPEED,
    SPEED_FLOOR,
    ALPHA,
    AREA,
    MATERIAL_STIFFNESS
};
enum { K, ULTIMATE, F0, CV }; /* F0: the line's force at d = 0; CV: C times the speed, for damping = exact */
enum { DAMP };                /* in the memory: C */
enum { UNLOADING_PAPER, UNLOADING_CONTINUOUS };
enum { SPEED_TOUCH, SPEED_ENERGY };

static const char *const unloading_choices[] = {"paper", "continuous", NULL};
static const char *const speed_choices[] = {"touch", "energy", NULL};

/* With impact-speed = energy the reference speed falls with the indentation and the rate of restitution stays that of
 * the elastic contact, so no floor is needed: this only keeps a division by 0 out. */
static const double least_energy_speed = 1e-20;

/* clang-format off */
static const struct thud_param params[] = {
    [STIFFNESS] = {.name = "stiffness", .title = "bumper stiffness",
     .help = "Force at an indentation of 1 mm, the exponent in its unit; or give alpha, area, material-stiffness.",
     .kind = THUD_PARAM_QUANTITY, .dimension = THUD_POWER_STIFFNESS, .unit = "kN/mm^n",
     .fallback = NAN, .least = 0, .most = NAN, .least_open = true, .soft_least = NAN, .soft_most = NAN},
    [EXPONENT] = THUD_PARAM_EXPONENT(2.65),
    [MAX_STRAIN] = {.name = "max-strain", .title = "ultimate strain",
     .help = "Fraction of the thickness that can be compressed before the post-yield stiffness holds.",
     .kind = THUD_PARAM_QUANTITY, .dimension = THUD_NUMBER, .unit = "",
     .fallback = 0.8, .least = 0, .most = 1, .least_open = true, .most_open = true,
     .soft_least = 0.5, .soft_most = 0.9},
    [POST_YIELD] = {.name = "post-yield", .title = "stiffness past the ultimate strain",
     .help = "Slope of the force once the bumper has bottomed out.",
     .kind = THUD_PARAM_QUANTITY, .dimension = THUD_STIFFNESS, .unit = "kN/mm",
     .fallback = 2500 * THUD_KN_PER_MM, .least = 0, .most = NAN, .least_open = true,
     .soft_least = NAN, .soft_most = NAN},
    [RESTITUTION] = THUD_PARAM_RESTITUTION(0.5),
    [DAMPING] = THUD_PARAM_DAMPING,
    [UNLOADING] = THUD_PARAM_ONE_OF("unloading", "restitution past the ultimate strain",
     "paper: eq. (5) as printed, on the power curve; continuous: from the approach curve.",
     UNLOADING_PAPER, unloading_choices),
    [IMPACT_SPEED] = THUD_PARAM_ONE_OF("impact-speed", "approach velocity of the damping",
     "touch: the approach velocity at contact onset; energy: at each turn, from the energy stored then.",
     SPEED_TOUCH, speed_choices),
    [SPEED_FLOOR] = THUD_PARAM_SPEED_FLOOR,
    [ALPHA] = {.name = "alpha", .title = "stiffening factor",
     .help = "Factor of eq. (6), with area and material-stiffness instead of stiffness.",
     .kind = THUD_PARAM_QUANTITY, .dimension = THUD_NUMBER, .unit = "",
     .fallback = NAN, .least = 0, .most = NAN, .least_open = true, .soft_least = 2, .soft_most = 2.5},
    [AREA] = {.name = "area", .title = "contact area",
     .help = "Area of eq. (6).",
     .kind = THUD_PARAM_QUANTITY, .dimension = THUD_AREA, .unit = "m^2",
     .fallback = NAN, .least = 0, .most = NAN, .least_open = true, .soft_least = NAN, .soft_most = NAN},
    [MATERIAL_STIFFNESS] = {.name = "material-stiffness", .title = "stiffness of the rubber itself",
     .help = "Material stiffness of eq. (6).",
     .kind = THUD_PARAM_QUANTITY, .dimension = THUD_PRESSURE, .unit = "MPa",
     .fallback = NAN, .least = 0, .most = NAN, .least_open = true, .soft_least = NAN, .soft_most = NAN},
};
/* clang-format on */

static enum thud_status refuse(struct thud_error *err, const char *key, const char *what)
{
    return thud_error_refuse(err, THUD_INPUT, key, "stiffness; or alpha, area and material-stiffness", "%s", what);
}

/* Given, or from eq. (6): k = alpha A K_r / d^n. */
static enum thud_status find_stiffness(struct thud_law_setup *setup, struct thud_error *err)
{
    const double *value = setup->value;
    int missing = 0, given = 0;
    for (int i = ALPHA; i <= MATERIAL_STIFFNESS; i++) {
        if (!isnan(value[i]))
            given = i;
        else
            missing = i;
    }
    if (!isnan(value[STIFFNESS])) {
        if (given)
            return refuse(err, params[given].name, "given together with stiffness, to which it is an alternative");
        setup->constant[K] = value[STIFFNESS];
        return THUD_OK;
    }
    if (!given)
        return refuse(err, params[STIFFNESS].name, "the bumper's stiffness is not given");
    if (missing)
        return refuse(err, params[missing].name, "not given, but needed to compute the bumper's stiffness");
    setup->constant[K] =
        value[ALPHA] * value[AREA] * value[MATERIAL_STIFFNESS] / pow(setup->thickness_m, value[EXPONENT]);
    return THUD_OK;
}

static struct thud_rubber_curve curve_of(const struct thud_law_setup *setup)
{
    return thud_rubber_curve(setup->constant[K], setup->value[EXPONENT], setup->constant[ULTIMATE],
                             setup->value[POST_YIELD]);
}

static enum thud_status prepare(struct thud_law_setup *setup, struct thud_error *err)
{
    if (!(setup->thickness_m > 0))
        return thud_error_refuse(err, THUD_INPUT, "thickness", "> 0", "the rubber law needs the thickness of a bumper");
    enum thud_status status = find_stiffness(setup, err);
    if (status != THUD_OK)
        return status;
    setup->constant[ULTIMATE] = setup->value[MAX_STRAIN] * setup->thickness_m;
    struct thud_rubber_curve curve = curve_of(setup);
    setup->constant[F0] = curve.ultimate_force_n - curve.post_yield_npm * curve.ultimate_m;
    setup->constant[CV] = thud_rubber_cv(setup->value[RESTITUTION]);
    return THUD_OK;
}

/* C for a reference speed > 0. */
static double damping(const struct thud_law_setup *setup, double v_mps)
{
    if (setup->value[DAMPING] == THUD_DAMPING_EXACT)
        return setup->constant[CV] / v_mps;
    return thud_rubber_c_paper(setup->value[RESTITUTION], setup->mass_kg, v_mps);
}

static void onset(const struct thud_law_setup *setup, double v_mps, struct thud_law_memory *memory)
{
    memory->own[DAMP] = damping(setup, fmax(v_mps, setup->value[SPEED_FLOOR]));
}

static double elastic_energy(const struct thud_law_setup *setup, const struct thud_law_memory *memory, double d_m)
{
    (void)memory;
    struct thud_rubber_curve curve = curve_of(setup);
    return thud_rubber_curve_energy(&curve, d_m);
}

static double energy_speed(const struct thud_law_setup *setup, double d_m)
{
    struct thud_rubber_curve curve = curve_of(setup);
    double force = thud_rubber_curve_force(&curve, d_m), energy = thud_rubber_curve_energy(&curve, d_m);
    if (setup->column_npm > 0) /* what the struck columns hold too */
        energy += 0.5 * force * force / setup->column_npm;
    return fmax(sqrt(2 * energy / setup->mass_kg), least_energy_speed);
}

static void reversal(const struct thud_law_setup *setup, enum thud_phase phase, double d_m,
                     struct thud_law_memory *memory)
{
    if (phase == THUD_RESTITUTION && setup->value[IMPACT_SPEED] == SPEED_ENERGY)
        memory->own[DAMP] = damping(setup, energy_speed(setup, d_m));
}

static struct thud_branch branch(const struct thud_law_setup *setup, const struct thud_law_memory *memory,
                                 enum thud_phase phase, bool past_ultimate)
{
    double k = setup->constant[K], n = setup->value[EXPONENT];
    bool line = past_ultimate && (phase == THUD_APPROACH || setup->value[UNLOADING] == UNLOADING_CONTINUOUS);
    double C = phase == THUD_RESTITUTION ? memory->own[DAMP] : 0;
    if (!line)
        return (struct thud_branch){.K = k, .p = n, .D = k * C, .r = n};
    double f0 = setup->constant[F0], post_yield = setup->value[POST_YIELD];
    return (struct thud_branch){.f0_n = f0, .k_npm = post_yield, .c_nspm = f0 * C, .D = post_yield * C, .p = 1, .r = 1};
}

static double ultimate(const struct thud_law_setup *setup, const struct thud_law_memory *memory, enum thud_phase phase)
{
    (void)memory;
    return phase == THUD_RESTITUTION && setup->value[UNLOADING] == UNLOADING_PAPER ? INFINITY
                                                                                   : setup->constant[ULTIMATE];
}

/* All of m v^2/2 is stored at the velocity reversal; restitution starts with what lies under its own curve. */
static double restitution(const struct thud_law_setup *setup, double v_mps)
{
    struct thud_rubber_curve curve = curve_of(setup);
    if (setup->value[IMPACT_SPEED] == SPEED_ENERGY)
        v_mps = fmax(v_mps, least_energy_speed); /* what holds at any small speed holds at rest */
    double energy = 0.5 * setup->mass_kg * v_mps * v_mps;
    double d = thud_rubber_curve_indentation(&curve, energy), ratio = 1;
    if (setup->value[UNLOADING] == UNLOADING_PAPER && d > curve.ultimate_m)
        ratio = thud_law_power_energy(curve.k, curve.n, d) / energy;
    struct thud_law_memory memory;
    onset(setup, v_mps, &memory);
    reversal(setup, THUD_RESTITUTION, d, &memory);
    return thud_rubber_restitution(memory.own[DAMP] * v_mps, ratio);
}

/* A force at the ultimate strain that no bumper has, and a line softer than the power curve: than its tangent there, and
 * with unloading paper than its chord up to the thickness, below which restitution lies above approach. */
static bool unusual(const struct thud_law_setup *setup, int n, struct thud_error *out)
{
    static const double least_n = 0.1e6, most_n = 100e6;
    struct thud_rubber_curve curve = curve_of(setup);
    bool force = curve.ultimate_force_n < least_n || curve.ultimate_force_n > most_n;
    bool paper = setup->value[UNLOADING] == UNLOADING_PAPER;
    double over = 1 / setup->value[MAX_STRAIN], factor = paper ? (pow(over, curve.n) - 1) / (over - 1) : curve.n;
    double least = factor * curve.ultimate_force_n / curve.ultimate_m;
    if (n >= (int)force + (int)(curve.post_yield_npm < least))
        return false;
    if (force && n == 0) {
        thud_error_set(out, THUD_OK, "a force of %.3g MN at the ultimate strain is unusual",
                       1e-6 * curve.ultimate_force_n);
        thud_error_allow(out, "usually %g to %g MN", 1e-6 * least_n, 1e-6 * most_n);
        thud_error_key(out, "%s", params[isnan(setup->value[STIFFNESS]) ? MATERIAL_STIFFNESS : STIFFNESS].name);
        return true;
    }
    thud_error_set(out, THUD_OK, "%.4g kN/mm past the ultimate strain is softer than the rubber's own curve%s",
                   curve.post_yield_npm / THUD_KN_PER_MM,
                   paper ? ", so the bumper can give back more energy than it takes" : "");
    thud_error_allow(out, "usually at least %.4g kN/mm%s", least / THUD_KN_PER_MM,
                     paper ? ", or unloading: continuous" : "");
    thud_error_key(out, "%s", params[POST_YIELD].name);
    return true;
}

const struct thud_law thud_law_rubber = {
    .name = "rubber",
    .title = "rubber bumper with hysteretic damping",
    .reference = "Polycarpou and Komodromos, COMPDYN 2009, Rhodes; "
                 "Polycarpou and Komodromos, Earthquakes and Structures 2 (2011) 1-24; "
                 "Polycarpou and Komodromos, COMPDYN 2011, Corfu, eqs. (4)-(7)",
    .summary = "approach F = k d^n, past the ultimate strain a line; restitution F = k d^n (1 + C v)",
    .flags = THUD_LAW_REVERSES,
    THUD_LAW_PARAMS(params),
    .prepare = prepare,
    .onset = onset,
    .reversal = reversal,
    .branch = branch,
    .ultimate = ultimate,
    .elastic_energy = elastic_energy,
    .restitution = restitution,
    .unusual = unusual,
};
