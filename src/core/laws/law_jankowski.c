/* Jankowski's nonlinear viscoelastic contact: damping in approach only, with the indentation's own stiffness
 * (Jankowski 2005, 2006).
 *     approach       F = k d^n + 2 xi sqrt(k d^(n-1) m) v
 *     restitution    F = k d^n
 * xi follows from e by the published formula, for n = 1.5 alone, or exactly. Assumes that all is lost on the way in. */
#include "core/laws/law_closed_form.h"
#include "core/laws/law_common.h"

enum { STIFFNESS, EXPONENT, RESTITUTION, DAMPING };
enum { D, XI };

static const struct thud_param params[] = {
    THUD_PARAM_HERTZ_STIFFNESS,
    THUD_PARAM_EXPONENT(1.5),
    THUD_PARAM_RESTITUTION(0.6),
    THUD_PARAM_DAMPING,
};

static enum thud_status prepare(struct thud_law_setup *setup, struct thud_error *err)
{
    double e = setup->value[RESTITUTION], n = setup->value[EXPONENT];
    if (setup->value[DAMPING] == THUD_DAMPING_EXACT) {
        setup->constant[XI] = thud_jankowski_xi(e, n);
    } else if (n == 1.5) {
        setup->constant[XI] = thud_jankowski_xi_published(e);
    } else {
        return thud_error_refuse(err, THUD_INPUT, "damping", "damping exact, or exponent 1.5",
                                 "the published damping is for exponent 1.5, not %g", n);
    }
    setup->constant[D] = 2 * setup->constant[XI] * sqrt(setup->value[STIFFNESS] * setup->mass_kg);
    return thud_law_check_hertz_stiffness(setup->value[STIFFNESS], n, err);
}

static struct thud_branch branch(const struct thud_law_setup *setup, const struct thud_law_memory *memory,
                                 enum thud_phase phase, bool past_ultimate)
{
    (void)memory;
    (void)past_ultimate;
    double n = setup->value[EXPONENT];
    struct thud_branch out = {.K = setup->value[STIFFNESS], .p = n};
    if (phase == THUD_RESTITUTION)
        return out;
    if (n == 1) { /* the damper's power is 0: a plain dashpot, whose force starts with a jump */
        out.c_nspm = setup->constant[D];
    } else {
        out.D = setup->constant[D];
        out.r = 0.5 * (n - 1);
    }
    return out;
}

static double restitution(const struct thud_law_setup *setup, double v_mps)
{
    (void)v_mps;
    return thud_jankowski_restitution(setup->constant[XI], setup->value[EXPONENT]);
}

const struct thud_law thud_law_jankowski = {
    .name = "jankowski",
    .title = "nonlinear viscoelastic",
    .reference = "Jankowski, Earthquake Engineering and Structural Dynamics 34 (2005) 595-611; "
                 "xi from e: Jankowski, Earthquake Engineering and Structural Dynamics 35 (2006) 517-524",
    .summary = "approach F = k d^n + 2 xi sqrt(k d^(n-1) m) v, restitution F = k d^n",
    .flags = THUD_LAW_REVERSES,
    THUD_LAW_PARAMS(params),
    .prepare = prepare,
    .branch = branch,
    .elastic_energy = thud_law_energy_power,
    .restitution = restitution,
};
