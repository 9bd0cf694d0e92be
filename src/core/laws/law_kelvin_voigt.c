/* The classical Kelvin-Voigt contact: spring and dashpot until the indentation is gone (Anagnostopoulos 1988).
 *     F = k d + c v,    c = 2 xi sqrt(k m),    xi = -ln e/sqrt(pi^2 + ln^2 e)
 * m is the effective mass. The relation of xi and e is exact for two free bodies. The force begins with a jump, c v, and
 * pulls before the bodies part: not for forces at the end of a contact. */
#include "core/laws/law_closed_form.h"
#include "core/laws/law_common.h"

enum { STIFFNESS, RESTITUTION };
enum { C };

static const struct thud_param params[] = {THUD_PARAM_STIFFNESS, THUD_PARAM_RESTITUTION(0.6)};

static enum thud_status prepare(struct thud_law_setup *setup, struct thud_error *err)
{
    (void)err;
    double xi = thud_kelvin_voigt_xi(setup->value[RESTITUTION]);
    setup->constant[C] = 2 * xi * sqrt(setup->value[STIFFNESS] * setup->mass_kg);
    return THUD_OK;
}

static double restitution(const struct thud_law_setup *setup, double v_mps)
{
    (void)v_mps;
    return setup->value[RESTITUTION]; /* the relation between xi and e is exact for this law */
}

const struct thud_law thud_law_kelvin_voigt = {
    .name = "kelvin-voigt",
    .title = "linear viscoelastic, classical",
    .reference = "Anagnostopoulos, Earthquake Engineering and Structural Dynamics 16 (1988) 443-456",
    .summary = "F = k d + c v while d > 0 (pulls at the end); c = 2 xi sqrt(k m), xi = -ln e/sqrt(pi^2 + ln^2 e)",
    .flags = THUD_LAW_LINEAR | THUD_LAW_PULLS | THUD_LAW_DEGREE_ONE,
    THUD_LAW_PARAMS(params),
    .prepare = prepare,
    .branch = thud_law_branch_viscoelastic,
    .elastic_energy = thud_law_energy_line,
    .restitution = restitution,
};
