/* Checks of values against each other. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "study/scene/building.h"
#include "study/scene/level.h"
#include "study/scene/scene_slot.h"

static const double rounding_m = 1e-12;
/* The bound of `yield`: each time a storey yields the other way its drift has moved by twice this, so that a run's
 * events stay countable. */
static const double least_yield_m = 1e-6;

static enum thud_status check_names(const struct thud_scene *scene, int s, struct thud_error *err)
{
    for (int i = 0; i < s; i++)
        if (strcmp(scene->structure[i].name, scene->structure[s].name) == 0) {
            thud_error_set(err, THUD_INPUT, "\"%s\" is the name of structure %d too", scene->structure[s].name, i + 1);
            return thud_scene_refuse(err, "every structure has its own name", "structures.%d.name", s + 1);
        }
    return THUD_OK;
}

/* A storey's strength is said once, and is one that its drift can be told from. */
static enum thud_status check_yield(const struct thud_structure *structure, int s, struct thud_error *err)
{
    bool storeys = thud_kind_is_building(structure->kind);
    if (structure->cracked > 0 && structure->period_s > 0) {
        thud_error_set(err, THUD_INPUT, "the period gives the stiffness of the storeys as they are, cracked or not");
        return thud_scene_refuse(err, "period or cracked", "structures.%d.cracked", s + 1);
    }
    bool loads = false;
    for (int i = 0; i < structure->storeys; i++)
        loads |= structure->load_pa[i] > 0;
    if ((structure->area_m2 > 0) != loads && storeys && structure->kind != THUD_ESTIMATED) {
        thud_error_set(err, THUD_INPUT, "%s is not given", structure->area_m2 > 0 ? "the load" : "the area");
        return thud_scene_refuse(err, "both give the masses: area: 240 m2, load: 8 kPa", "structures.%d.%s", s + 1,
                                 structure->area_m2 > 0 ? "load" : "area");
    }
    for (int i = 0; i < structure->storeys && storeys; i++) {
        const double by_coefficient = structure->yield_coefficient[i], by_shear = structure->yield_shear_n[i];
        if ((structure->yield_m[i] > 0) + (by_shear > 0) + (by_coefficient > 0) > 1) {
            thud_error_set(err, THUD_INPUT, "storey %d has its strength twice", i + 1);
            return thud_scene_refuse(err, "one of yield, yield-shear and yield-coefficient", "structures.%d.%s", s + 1,
                                     by_coefficient > 0 ? "yield-coefficient" : "yield-shear");
        }
        if (!(thud_structure_yield(structure, i) >= least_yield_m)) {
            thud_error_set(err, THUD_INPUT, "storey %d yields at a drift of %.3g mm", i + 1,
                           1e3 * thud_structure_yield(structure, i));
            return thud_scene_refuse(err, "> 0.001 mm times the stiffness", "structures.%d.yield-shear", s + 1);
        }
    }
    return THUD_OK;
}

/* EI or stiffness, not both. */
static enum thud_status check_columns(const struct thud_scene *scene, int s, struct thud_error *err)
{
    const struct thud_structure *structure = &scene->structure[s];
    bool has = thud_kind_is_building(structure->kind);
    for (int i = 0; i < structure->storeys && has; i++) {
        if (!(structure->column_ei_nm2[i] > 0) || !(structure->column_stiffness_npm[i] > 0))
            continue;
        thud_error_set(err, THUD_INPUT, "given together with EI, to which it is an alternative");
        return thud_scene_refuse(err, "EI or stiffness", "structures.%d.column.stiffness", s + 1);
    }
    return THUD_OK;
}

/* A storey has columns under its slab. */
static enum thud_status check_depths(const struct thud_structure *structure, int s, struct thud_error *err)
{
    for (int i = 0; i < structure->storeys && thud_kind_is_building(structure->kind); i++) {
        char depth[48], height[48];
        if (structure->slab_depth_m[i] <= 0.5 * structure->height_m[i] + rounding_m)
            continue;
        thud_quantity_format(structure->slab_depth_m[i], "cm", depth, sizeof depth);
        thud_quantity_format(structure->height_m[i], "m", height, sizeof height);
        thud_error_set(err, THUD_INPUT, "the slab of floor %d is %s deep in a storey of %s", i + 1, depth, height);
        return thud_scene_refuse(err, "up to half of the storey's height", "structures.%d.slab-depth", s + 1);
    }
    return THUD_OK;
}

/* A storey whose weight takes off all of its stiffness is unstable. */
static enum thud_status check_weight(const struct thud_scene *scene, int s, struct thud_error *err)
{
    const struct thud_structure *structure = &scene->structure[s];
    if (scene->p_delta && thud_kind_is_read(structure->kind))
        return thud_structure_check_weight(scene, s, err);
    for (int i = 0; i < structure->storeys && scene->p_delta && thud_kind_is_building(structure->kind); i++) {
        double weight = thud_structure_weight(structure, i), geometric = weight / structure->height_m[i];
        if (thud_structure_stiffness(structure, i) > geometric)
            continue;
        thud_error_set(err, THUD_INPUT,
                       "storey %d of %.40s buckles under its own weight: %.4g MN above it on a height of %.4g m "
                       "take off %.4g MN/m",
                       i + 1, structure->name, 1e-6 * weight, structure->height_m[i], 1e-6 * geometric);
        thud_error_allow(err, "with p-delta > %.4g MN/m, and some times that", 1e-6 * geometric);
        return thud_scene_refuse(err, NULL, "structures.%d.stiffness.%d", s + 1, i + 1);
    }
    return THUD_OK;
}

/* What a law of isolators needs is given, and nothing that it has not. */
static enum thud_status check_isolator(const struct thud_structure *structure, int s, struct thud_error *err)
{
    static const char *const has[] = {"isolation-stiffness; or another law", "strength, post-yield, yield",
                                      "radius, friction, yield"};
    const enum thud_isolator_law law = (enum thud_isolator_law)structure->isolator_law;
    const struct thud_param *param;
    char key[96];
    if (law == THUD_ISOLATOR_LINEAR && isnan(structure->isolation_stiffness_npm)) {
        thud_error_set(err, THUD_INPUT, "the isolators' stiffness is not given");
        return thud_scene_refuse(err, "a stiffness, or isolator: {law: lead-rubber or pendulum, ...}",
                                 "structures.%d.isolation-stiffness", s + 1);
    }
    if (law != THUD_ISOLATOR_LINEAR && !isnan(structure->isolation_stiffness_npm)) {
        thud_error_set(err, THUD_INPUT, "%s isolators have no isolation stiffness", thud_isolator_name(law));
        return thud_scene_refuse(err, has[law], "structures.%d.isolation-stiffness", s + 1);
    }
    for (int i = 1; (param = thud_group_param(THUD_GROUP_ISOLATOR, i)); i++) {
        const struct thud_place *place = thud_group_place(THUD_GROUP_ISOLATOR, i);
        const double value = *(const double *)(const void *)((const char *)structure + place->offset);
        if (place->store != THUD_STORE_NUMBER)
            continue;
        snprintf(key, sizeof key, "structures.%d.isolator.%s", s + 1, param->name);
        if (!isnan(value) && !(place->laws & 1u << law)) {
            thud_error_set(err, THUD_INPUT, "%s isolators have no %s", thud_isolator_name(law), param->title);
            return thud_scene_refuse(err, has[law], "%s", key);
        }
        if (place->needed & 1u << law || !isnan(value)) {
            enum thud_status status = thud_value_check(param, value, key, err);
            if (status != THUD_OK)
                return status;
        }
    }
    return THUD_OK;
}

/* A flexible wall has a mass and a stiffness; backfill is behind a wall at an end of the row. */
static enum thud_status check_wall(const struct thud_scene *scene, int s, struct thud_error *err)
{
    const struct thud_structure *wall = &scene->structure[s];
    const bool soil = thud_structure_has_group(wall, THUD_GROUP_BACKFILL);
    const char *lacks = isnan(wall->backfill_stiffness_npm) ? "stiffness" : "strength";
    if (thud_wall_gives(wall) && isnan(wall->wall_stiffness_npm)) {
        thud_error_set(err, THUD_INPUT, "the wall has a mass, and no stiffness that holds it");
        return thud_scene_refuse(err, "a stiffness, or no mass: a wall that moves with the ground",
                                 "structures.%d.stiffness", s + 1);
    }
    if (!thud_wall_gives(wall) && (soil || !isnan(wall->wall_stiffness_npm) || !isnan(wall->wall_damping))) {
        thud_error_set(err, THUD_INPUT,
                       "a wall without mass moves with the ground, and has no stiffness, damping and backfill");
        return thud_scene_refuse(err, "a mass", "structures.%d.mass", s + 1);
    }
    if (soil && s > 0 && s + 1 < scene->nstructures) {
        thud_error_set(err, THUD_INPUT, "%.40s has a neighbour on either side, and no soil", wall->name);
        return thud_scene_refuse(err, "of the first or the last structure", "structures.%d.backfill", s + 1);
    }
    if (soil && (isnan(wall->backfill_stiffness_npm) || isnan(wall->backfill_strength_n))) {
        thud_error_set(err, THUD_INPUT, "the soil's %s is not given", lacks);
        return thud_scene_refuse(err, isnan(wall->backfill_stiffness_npm) ? "e.g. 200 MN/m" : "e.g. 3 MN",
                                 "structures.%d.backfill.%s", s + 1, lacks);
    }
    return THUD_OK;
}

static enum thud_status check_structure(const struct thud_scene *scene, int s, struct thud_error *err)
{
    const struct thud_structure *own = &scene->structure[s];
    char key[32];
    snprintf(key, sizeof key, "structures.%d", s + 1);
    enum thud_status status = thud_group_check(own, THUD_GROUP_STRUCTURE, own->kind, own->storeys, false, key, err);
    snprintf(key, sizeof key, "structures.%d.column", s + 1);
    if (status == THUD_OK)
        status = thud_group_check(own, THUD_GROUP_COLUMN, own->kind, own->storeys, false, key, err);
    if (status == THUD_OK && thud_kind_is_read(scene->structure[s].kind))
        status = thud_structure_check_shape(scene, s, err);
    if (status == THUD_OK && scene->structure[s].kind == THUD_ISOLATED)
        status = check_isolator(&scene->structure[s], s, err);
    if (status == THUD_OK && thud_structure_on_soil(&scene->structure[s]))
        status = thud_structure_check_foundation(&scene->structure[s], s, err);
    if (status == THUD_OK && scene->structure[s].kind == THUD_WALL)
        status = check_wall(scene, s, err);
    if (status == THUD_OK)
        status = check_yield(&scene->structure[s], s, err);
    if (status == THUD_OK)
        status = check_columns(scene, s, err);
    if (status == THUD_OK)
        status = check_depths(&scene->structure[s], s, err);
    if (status == THUD_OK)
        status = check_weight(scene, s, err);
    return status == THUD_OK ? check_names(scene, s, err) : status;
}

static enum thud_status check_law(const struct thud_law_choice *choice, double thickness_m, int interface,
                                  const char *part, struct thud_error *err)
{
    char key[160];
    if (!choice->law) {
        thud_error_set(err, THUD_INPUT, "the impact law is not given");
        return thud_scene_refuse(err, "one of `thud laws`", "interfaces.%d.%s.law", interface + 1, part);
    }
    for (int i = 0; i < choice->law->nparams; i++) {
        const struct thud_param *param = &choice->law->params[i];
        if (thud_value_fits(param, choice->value[i]))
            continue;
        snprintf(key, sizeof key, "interfaces.%d.%s.%s", interface + 1, part, param->name);
        enum thud_status status = isnan(choice->value[i]) && isnan(param->fallback)
                                      ? THUD_OK
                                      : thud_value_check(param, choice->value[i], key, err);
        if (status != THUD_OK)
            return status;
    }
    struct thud_law_setup setup = {.mass_kg = 1, .thickness_m = thickness_m};
    struct thud_error why = {0};
    memcpy(setup.value, choice->value, sizeof setup.value);
    enum thud_status status = thud_law_prepare(choice->law, &setup, &why);
    if (status == THUD_OK)
        return THUD_OK;
    snprintf(key, sizeof key, "interfaces.%d.%s.%.60s", interface + 1, part, why.key[0] ? why.key : "law");
    thud_error_key(&why, "%s", key);
    if (err)
        *err = why;
    return status;
}

static enum thud_status check_bumper(const struct thud_interface *at, int interface, struct thud_error *err)
{
    char key[96], gap[48], thick[48], text[48];
    snprintf(key, sizeof key, "interfaces.%d.bumper.thickness", interface + 1);
    enum thud_status status = thud_value_check(thud_group_param(THUD_GROUP_BUMPER, 1),
                                               at->bumper_thickness_m > 0 ? at->bumper_thickness_m : NAN, key, err);
    if (status != THUD_OK)
        return status;
    double out = at->bumper_thickness_m - at->bumper_cavity_m;
    if (out > 0 && out <= at->gap_m + rounding_m)
        return THUD_OK;
    thud_quantity_format(at->gap_m, "cm", gap, sizeof gap);
    thud_quantity_format(at->bumper_thickness_m, "cm", thick, sizeof thick);
    thud_quantity_format(at->bumper_cavity_m, "cm", text, sizeof text);
    if (out <= 0) {
        thud_error_set(err, THUD_INPUT, "the cavity, %s, is as deep as the bumper is thick, %s", text, thick);
        return thud_scene_refuse(err, "0 to less than the thickness", "interfaces.%d.bumper.cavity", interface + 1);
    }
    char much[48];
    thud_quantity_format(rint(out * 1e9) / 1e9, "cm", much, sizeof much);
    thud_error_set(err, THUD_INPUT, "the bumper projects by %s into a gap of %s", much, gap);
    return thud_scene_refuse(err, "thickness - cavity <= gap", "interfaces.%d.bumper.thickness", interface + 1);
}

/* An impulse has no force that columns could give under. */
static enum thud_status check_impulses(const struct thud_scene *scene, int i, struct thud_error *err)
{
    const struct thud_interface *at = &scene->interface[i];
    struct thud_contact_pair meeting[THUD_CONTACT_PAIRS_MAX];
    const bool impulses = (at->contact.law->flags | (at->has_bumper ? at->bumper.law->flags : 0)) & THUD_LAW_IMPULSIVE;
    int n = impulses ? thud_interface_contact_pairs(scene, i, meeting) : 0;
    for (int k = 0; k < n; k++) {
        const bool bumper = thud_interface_level(at, k).has_bumper;
        const struct thud_law *law = bumper ? at->bumper.law : at->contact.law;
        if (!(law->flags & THUD_LAW_IMPULSIVE))
            continue;
        bool left = meeting[k].struck < 0;
        const struct thud_structure *s = &scene->structure[i + !left];
        int storey = (left ? meeting[k].left_floor : meeting[k].right_floor) - 1 - (s->kind == THUD_ISOLATED);
        if (meeting[k].struck == 0 || isnan(thud_column_ei(s, storey)))
            continue;
        thud_error_set(err, THUD_INPUT, "%s has impulses, and columns that give need a contact force", law->name);
        return thud_scene_refuse(err, "another law, or columns without EI and stiffness", "interfaces.%d.%s.law", i + 1,
                                 bumper ? "bumper" : "contact");
    }
    return THUD_OK;
}

static enum thud_status check_interface(const struct thud_scene *scene, int i, struct thud_error *err)
{
    const struct thud_interface *at = &scene->interface[i];
    char key[64];
    snprintf(key, sizeof key, "interfaces.%d.gap", i + 1);
    enum thud_status status = thud_value_check(thud_group_param(THUD_GROUP_INTERFACE, 0), at->gap_m, key, err);
    if (status == THUD_OK)
        status = check_law(&at->contact, 0, i, "contact", err);
    if (status == THUD_OK && at->has_bumper)
        status = check_bumper(at, i, err);
    if (status == THUD_OK && at->has_bumper)
        status = check_law(&at->bumper, at->bumper_thickness_m, i, "bumper", err);
    if (status == THUD_OK)
        status = thud_levels_check(scene, i, err);
    return status == THUD_OK ? check_impulses(scene, i, err) : status;
}

static enum thud_status check_study(const struct thud_scene *scene, struct thud_error *err)
{
    const struct thud_study_choice *study = &scene->study;
    for (int i = 0; i < study->nvary; i++) {
        const struct thud_vary *vary = &study->vary[i];
        struct thud_slot slot;
        enum thud_status status = thud_slot_find(scene, vary->key, &slot, err);
        if (status != THUD_OK)
            return thud_scene_refuse(err, NULL, "study.vary");
        if (vary->values[0])
            continue;
        if (slot.param->kind != THUD_PARAM_QUANTITY && slot.param->kind != THUD_PARAM_INTEGER)
            return thud_error_refuse(err, THUD_INPUT, "study.values", "a list of its words",
                                     "the varied key %s has no values", vary->key);
        const char *absent = isnan(vary->from) ? "from" : isnan(vary->to) ? "to" : isnan(vary->step) ? "step" : NULL;
        if (absent) {
            thud_error_set(err, THUD_INPUT, "the varied key %s has no \"%s\"", vary->key, absent);
            return thud_scene_refuse(err, "from, to and step, or values", "study.%s", absent);
        }
        if (vary->from > vary->to)
            return thud_error_refuse(err, THUD_INPUT, "study.to", "from <= to",
                                     "the last value is below the first one");
        if ((vary->to - vary->from) / vary->step > 1e6)
            return thud_error_refuse(err, THUD_INPUT, "study.step", NULL, "the step makes more than a million values");
    }
    return THUD_OK;
}

enum thud_status thud_scene_check(const struct thud_scene *scene, struct thud_error *err)
{
    bool moves = false;
    enum thud_status status = THUD_OK;
    if (scene->nstructures < 1)
        return thud_error_refuse(err, THUD_INPUT, "structures", "a list of 1 to 20", "there is no structure");
    for (int s = 0; s < scene->nstructures && status == THUD_OK; s++) {
        status = check_structure(scene, s, err);
        moves = moves || scene->structure[s].kind != THUD_WALL;
    }
    if (status == THUD_OK && !moves)
        return thud_error_refuse(err, THUD_INPUT, "structures", "at least one building or rigid body",
                                 "there are only walls, so nothing moves");
    for (int i = 0; i + 1 < scene->nstructures && status == THUD_OK; i++)
        status = check_interface(scene, i, err);
    if (status == THUD_OK)
        status = thud_links_check(scene, err);
    if (status == THUD_OK && !isnan(scene->record.to_s) &&
        !(scene->record.to_s > (isnan(scene->record.from_s) ? 0 : scene->record.from_s)))
        return thud_error_refuse(err, THUD_INPUT, "record.to", "later than it begins",
                                 "the part of the motion ends before it begins");
    if (status == THUD_OK && !scene->record.file[0] && !(scene->analysis.tail_s > 0))
        return thud_error_refuse(err, THUD_INPUT, "analysis.tail", "> 0 s, up to 100 s",
                                 "without a ground motion the tail is the duration, and it is 0");
    return status == THUD_OK ? check_study(scene, err) : status;
}
