/* Foundations as a person gives them: springs and dashpots, or the soil that they follow from. */
#include <math.h>
#include <stdio.h>

#include "base/quantity.h"
#include "core/model/model.h"
#include "study/scene/building.h"
#include "study/scene/scene_slot.h"

bool thud_structure_on_soil(const struct thud_structure *structure)
{
    return thud_structure_has_group(structure, THUD_GROUP_FOUNDATION);
}

static double given(double value, double otherwise)
{
    return isnan(value) ? otherwise : value;
}

struct thud_foundation_input thud_structure_foundation(const struct thud_structure *s)
{
    static const double usual_poisson = 1.0 / 3;
    const double a = s->foundation_radius_m, rho = s->soil_density_kgpm3, vs = s->soil_vs_mps,
                 nu = given(s->soil_poisson, usual_poisson), shear = rho * vs * vs,
                 vp = vs * sqrt(2 * (1 - nu) / (1 - 2 * nu));
    const bool soil = !isnan(vs);
    return (struct thud_foundation_input){
        .mass_kg = s->foundation_mass_kg,
        .inertia_kgm2 = given(s->foundation_inertia_kgm2, 0.25 * s->foundation_mass_kg * a * a),
        .sway_npm = given(s->sway_npm, 8 * shear * a / (2 - nu)),
        .sway_nspm = given(s->sway_nspm, soil ? rho * vs * THUD_PI * a * a : 0),
        .rocking_nmprad = given(s->rocking_nmprad, 8 * shear * a * a * a / (3 * (1 - nu))),
        .rocking_nmsprad = given(s->rocking_nmsprad, soil ? rho * vp * 0.25 * THUD_PI * a * a * a * a : 0)};
}

#define KEY "structures.%d.foundation.%s"

enum thud_status thud_structure_check_foundation(const struct thud_structure *s, int index, struct thud_error *err)
{
    char prefix[48];
    const struct thud_foundation_input f = thud_structure_foundation(s);
    const bool soil = !isnan(s->soil_vs_mps) || !isnan(s->soil_density_kgpm3) || !isnan(s->soil_poisson);
    snprintf(prefix, sizeof prefix, "structures.%d.foundation", index + 1);
    if (thud_group_check(s, THUD_GROUP_FOUNDATION, s->kind, 0, true, prefix, err) != THUD_OK)
        return THUD_INPUT;
    if (isnan(f.mass_kg)) {
        thud_error_set(err, THUD_INPUT, "the foundation's mass is not given");
        return thud_scene_refuse(err, "a mass in t or kg", KEY, index + 1, "mass");
    }
    if (soil && isnan(s->soil_vs_mps + s->soil_density_kgpm3 + s->foundation_radius_m)) {
        const char *key = isnan(s->soil_vs_mps) ? "vs" : isnan(s->soil_density_kgpm3) ? "density" : "radius";
        thud_error_set(err, THUD_INPUT, "of the soil, vs, density and radius are not all given");
        return thud_scene_refuse(err, "all three, and poisson (1/3 where it is not given)", KEY, index + 1, key);
    }
    if (isnan(f.sway_npm) || isnan(f.rocking_nmprad)) {
        thud_error_set(err, THUD_INPUT, "the stiffness against %s is not given",
                       isnan(f.sway_npm) ? "sway" : "rocking");
        return thud_scene_refuse(err, "sway-stiffness and rocking-stiffness, or vs, density and radius", KEY, index + 1,
                                 isnan(f.sway_npm) ? "sway-stiffness" : "rocking-stiffness");
    }
    if (isnan(f.inertia_kgm2)) {
        thud_error_set(err, THUD_INPUT, "the foundation's moment of inertia is not given");
        return thud_scene_refuse(err, "in t m2; or a radius, for that of a disk", KEY, index + 1, "inertia");
    }
    return THUD_OK;
}
