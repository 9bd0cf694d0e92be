/* Concrete on concrete as in Polycarpou and Komodromos 2011, eqs. (1)-(3): Kelvin-Voigt without the pull.
 *     F = k d + c v while that is above 0, then the contact is over;    c = 2 xi sqrt(k m)
 * xi is that of the classical law (damping paper: bodies part faster than e says) or solved for e (exact). The
 * indentation left at release is plastic and widens the clearance (residual keep), or goes back (recover). The force
 * begins with a jump, c v. */
#include "core/laws/law_closed_form.h"
#include "core/laws/law_common.h"

enum { STIFFNESS, RESTITUTION, DAMPING, RESIDUAL };
enum { C, XI };
enum { KEEP, RECOVER };

static const char *const residual_choices[] = {"keep", "recover", NULL};

static const struct thud_param params[] = {
    THUD_PARAM_STIFFNESS,
    THUD_PARAM_RESTITUTION(0.6),
    THUD_PARAM_DAMPING,
    THUD_PARAM_ONE_OF("residual", "indentation left at release",
                      "keep: it widens the clearance permanently; recover: the material springs back.", KEEP,
                      residual_choices),
};

static enum thud_status prepare(struct thud_law_setup *setup, struct thud_error *err)
{
    (void)err;
    double e = setup->value[RESTITUTION];
    bool exact = setup->value[DAMPING] == THUD_DAMPING_EXACT;
    setup->constant[XI] = exact ? thud_kelvin_voigt_cut_xi(e) : thud_kelvin_voigt_xi(e);
    setup->constant[C] = 2 * setup->constant[XI] * sqrt(setup->value[STIFFNESS] * setup->mass_kg);
    return THUD_OK;
}

static double restitution(const struct thud_law_setup *setup, double v_mps)
{
    (void)v_mps;
    return thud_kelvin_voigt_cut_restitution(setup->constant[XI]);
}

static bool keeps_residual(const struct thud_law_setup *setup)
{
    return setup->value[RESIDUAL] == KEEP;
}

const struct thud_law thud_law_kelvin_voigt_no_tension = {
    .name = "kelvin-voigt-no-tension",
    .title = "linear viscoelastic, no tension",
    .reference = "Komodromos, Polycarpou, Papaloizou and Phocas, Earthquake Engineering and Structural Dynamics 36 "
                 "(2007) 1605-1622; "
                 "Polycarpou and Komodromos, COMPDYN 2011, Corfu, eqs. (1)-(3)",
    .summary = "F = k d + c v while that is > 0, then released; c = 2 xi sqrt(k m)",
    .flags = THUD_LAW_LINEAR | THUD_LAW_DEGREE_ONE,
    THUD_LAW_PARAMS(params),
    .prepare = prepare,
    .branch = thud_law_branch_viscoelastic,
    .elastic_energy = thud_law_energy_line,
    .restitution = restitution,
    .keeps_residual = keeps_residual,
};
