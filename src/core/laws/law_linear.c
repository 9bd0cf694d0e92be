/* A linear spring (Maison and Kasai 1990).
 *     F = k d
 * Assumes that nothing is lost: two free bodies part as fast as they met. Not for damped contact. */
#include "core/laws/law_common.h"

static const struct thud_param params[] = {THUD_PARAM_STIFFNESS};

const struct thud_law thud_law_linear = {
    .name = "linear",
    .title = "linear spring",
    .reference = "Maison and Kasai, Journal of Structural Engineering 116 (1990) 957-977",
    .summary = "F = k d",
    .flags = THUD_LAW_LINEAR | THUD_LAW_DEGREE_ONE,
    THUD_LAW_PARAMS(params),
    .branch = thud_law_branch_viscoelastic, /* with a dashpot of 0 */
    .elastic_energy = thud_law_energy_line,
    .nominal = thud_law_nominal_one,
    .restitution = thud_law_restitution_one,
};
