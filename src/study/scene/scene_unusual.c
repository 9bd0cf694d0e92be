/* What is allowed but unusual. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/methods/method.h"
#include "study/scene/building.h"
#include "study/scene/level.h"
#include "study/scene/scene_slot.h"
#include "study/scene/solution.h"

struct search {
    int wanted, found;
    struct thud_error *out;
};

static bool look(struct search *search, const struct thud_param *param, double value, const char *key)
{
    char usual[160], text[64];
    if (!thud_param_unusual(param, value, usual, sizeof usual) || search->found++ != search->wanted)
        return false;
    thud_quantity_format(value, strchr(param->unit, '^') ? "" : param->unit, text, sizeof text);
    thud_error_set(search->out, THUD_OK, "%s is unusual", text);
    thud_error_allow(search->out, "usually %s", usual);
    thud_error_key(search->out, "%s", key);
    return true;
}

static bool look_group(struct search *search, enum thud_group group, const void *base, unsigned kind, int storeys,
                       const char *prefix)
{
    int count;
    const struct thud_param *params = thud_group_params(group, &count);
    const struct thud_place *places = thud_group_places(group);
    for (int i = 0; i < count; i++) {
        if (kind && !(places[i].kinds & kind))
            continue;
        const double *value = (const double *)(const void *)((const char *)base + places[i].offset);
        int n = places[i].store == THUD_STORE_FLOORS ? storeys : places[i].store == THUD_STORE_NUMBER ? 1 : 0;
        for (int floor = 0; floor < n; floor++) {
            char key[96];
            snprintf(key, sizeof key, n > 1 ? "%s.%s.%d" : "%s.%s", prefix, params[i].name, floor + 1);
            if ((floor > 0 && value[floor] == value[floor - 1]) || (places[i].optional && value[floor] == 0))
                continue; /* said once */
            if (look(search, &params[i], value[floor], key))
                return true;
        }
    }
    return false;
}

static bool look_law(struct search *search, const struct thud_law_choice *choice, const char *prefix)
{
    for (int i = 0; choice->law && i < choice->law->nparams; i++) {
        char key[128];
        snprintf(key, sizeof key, "%s.%s", prefix, choice->law->params[i].name);
        if (choice->law->params[i].kind == THUD_PARAM_QUANTITY &&
            look(search, &choice->law->params[i], choice->value[i], key))
            return true;
    }
    return false;
}

/* What the law says of its values together. */
static bool look_whole_law(struct search *search, const struct thud_law_choice *choice, double thickness_m,
                           const char *prefix)
{
    struct thud_law_setup setup = {.mass_kg = 1, .thickness_m = thickness_m};
    struct thud_error one = {0};
    const struct thud_law *law = choice->law;
    if (!law || !law->unusual)
        return false;
    memcpy(setup.value, choice->value, sizeof setup.value);
    if (thud_law_prepare(law, &setup, NULL) != THUD_OK)
        return false;
    for (int i = 0; law->unusual(&setup, i, &one); i++) {
        if (search->found++ != search->wanted)
            continue;
        char key[sizeof one.key + 64];
        snprintf(key, sizeof key, "%s.%s", prefix, one.key);
        *search->out = one;
        thud_error_key(search->out, "%s", key);
        return true;
    }
    return false;
}

/* Struck columns stiffer than the storey that they are a part of. */
static bool look_columns(struct search *search, const struct thud_structure *s, const char *prefix)
{
    for (int i = 0; i < s->storeys && thud_structure_has_columns(s); i++) {
        double length = thud_clear_height(s, i), k = 12 * thud_column_ei(s, i) / (length * length * length);
        if (!(s->stiffness_npm[i] > 0) || !(k > s->stiffness_npm[i] * (1 + 1e-9)) || search->found++ != search->wanted)
            continue;
        thud_error_set(search->out, THUD_OK,
                       "the columns of storey %d alone have %.4g MN/m (12 EI/L^3), the storey %.4g", i + 1, 1e-6 * k,
                       1e-6 * s->stiffness_npm[i]);
        thud_error_allow(search->out, "usually less than the storey's stiffness");
        thud_error_key(search->out, "%s.%s", prefix, s->column_stiffness_npm[i] > 0 ? "stiffness" : "EI");
        return true;
    }
    return false;
}

/* Modes that are fewer than the floors. */
static bool look_modes(struct search *search, const struct thud_structure *s, const char *prefix)
{
    if (s->kind != THUD_MODES || s->shape_rows == 0 || s->shape_rows >= s->storeys || search->found++ != search->wanted)
        return false;
    thud_error_set(search->out, THUD_OK,
                   "%d of %d modes: what they leave out is taken as ten times faster than the fastest of them, so that "
                   "the local give at a struck floor is not known",
                   s->shape_rows, s->storeys);
    thud_error_allow(search->out, "as many modes as floors");
    thud_error_key(search->out, "%s.periods", prefix);
    return true;
}

/* Both codes fit their formulas to buildings of some storeys. */
static bool look_estimate(struct search *search, const struct thud_structure *s, const char *prefix)
{
    static const double most_m = 40;
    const double height = s->kind == THUD_ESTIMATED ? thud_structure_estimate(s).height_m : 0;
    if (!(height > most_m) || search->found++ != search->wanted)
        return false;
    thud_error_set(search->out, THUD_OK, "a period is estimated for a building of %.4g m", height);
    thud_error_allow(search->out, "EN 1998-1 4.3.3.2.2(3): up to %.4g m", most_m);
    thud_error_key(search->out, "%s.height", prefix);
    return true;
}

/* A cavity that leaves less of the bumper outside than it can be compressed by: the walls would touch first. */
static bool look_cavity(struct search *search, const struct thud_interface *at, const char *prefix)
{
    double strain = thud_interface_max_strain(at);
    if (isnan(strain) || at->bumper_cavity_m <= at->bumper_thickness_m * (1 - strain) * (1 + 1e-9) ||
        search->found++ != search->wanted)
        return false;
    thud_error_set(search->out, THUD_OK, "at %.4g cm the walls would touch before the bumper is at its ultimate strain",
                   100 * at->bumper_cavity_m);
    thud_error_allow(search->out, "usually up to thickness (1 - max-strain), %.4g cm",
                     100 * at->bumper_thickness_m * (1 - strain));
    thud_error_key(search->out, "%s.cavity", prefix);
    return true;
}

/* A contact whose law nobody has chosen. */
static bool look_assumed(struct search *search, const struct thud_law_choice *choice, int i)
{
    if (!choice->assumed || search->found++ != search->wanted)
        return false;
    thud_error_set(search->out, THUD_OK,
                   "no impact law is given: %s is taken, with its usual values where none are given",
                   choice->law->name);
    thud_error_allow(search->out, "the law of Polycarpou and Komodromos (2011); others: `thud laws`");
    thud_error_key(search->out, "interfaces.%d.contact.law", i + 1);
    return true;
}

static bool look_interface(struct search *search, const struct thud_interface *at, int i)
{
    char key[64];
    if (look_assumed(search, &at->contact, i))
        return true;
    if (at->has_bumper) {
        snprintf(key, sizeof key, "interfaces.%d.bumper", i + 1);
        return look_group(search, THUD_GROUP_BUMPER, at, 0, 0, key) || look_law(search, &at->bumper, key) ||
               look_cavity(search, at, key) || look_whole_law(search, &at->bumper, at->bumper_thickness_m, key);
    }
    snprintf(key, sizeof key, "interfaces.%d.contact", i + 1);
    return look_law(search, &at->contact, key);
}

/* Neighbours none of whose floors can touch. */
static bool look_levels(struct search *search, const struct thud_scene *scene)
{
    struct thud_model *model;
    int contacts[THUD_STRUCTURES_MAX + 1] = {0};
    if (thud_scene_assemble(scene, &model, NULL) != THUD_OK)
        return false;
    for (int c = 0; c < model->npairs; c++)
        contacts[model->contact[c].interface]++;
    thud_model_free(model);
    for (int i = 0; i + 1 < scene->nstructures; i++) {
        const struct thud_structure *left = &scene->structure[i], *right = left + 1;
        if (contacts[i + 1] > 0 || search->found++ != search->wanted)
            continue;
        thud_error_set(search->out, THUD_OK, "%s and %s have nothing at the same level, so they cannot touch",
                       left->name, right->name);
        thud_error_allow(search->out, "floors at or between the other's floors: see heights and base");
        thud_error_key(search->out, "interfaces.%d", i + 1);
        return true;
    }
    return false;
}

/* Faces that overlap so little that what meets is neither two floors nor a slab and columns: the first pair, and how
 * many there are. */
static bool look_faces(struct search *search, const struct thud_scene *scene, int i)
{
    const struct thud_structure *left = &scene->structure[i], *right = left + 1;
    struct thud_contact_pair meeting[THUD_CONTACT_PAIRS_MAX];
    bool buildings = thud_kind_is_building(left->kind) && thud_kind_is_building(right->kind);
    int n = buildings ? thud_interface_contact_pairs(scene, i, meeting) : 0, few = 0, a = 0, b = 0;
    double overlap = 0, depth = 0;
    for (int k = n - 1; k >= 0; k--) {
        int l = meeting[k].left_floor - 1, r = meeting[k].right_floor - 1;
        double shallow = fmin(thud_structure_depth(left, l), thud_structure_depth(right, r));
        double common = thud_face_overlap(thud_structure_elevation(left, l), thud_structure_depth(left, l),
                                          thud_structure_elevation(right, r), thud_structure_depth(right, r));
        if (meeting[k].struck != 0 || !(common < 0.25 * shallow))
            continue;
        few++;
        a = l + 1;
        b = r + 1;
        overlap = common;
        depth = shallow;
    }
    if (few == 0 || search->found++ != search->wanted)
        return false;
    thud_error_set(search->out, THUD_OK,
                   "floor %d of %.40s and floor %d of %.40s overlap by %.3g cm of %.3g cm (%d such pairs): that is "
                   "neither a contact of floors nor one of a slab and columns",
                   a, left->name, b, right->name, 100 * overlap, 100 * depth, few);
    thud_error_allow(search->out, "usually a quarter of the shallower slab or more; see height and base");
    thud_error_key(search->out, "structures.%d.slab-depth", i + 1);
    return true;
}

/* A step in which much of a contact goes by. */
static bool look_step(struct search *search, const struct thud_scene *scene)
{
    const struct thud_method *method = thud_method_find(scene->analysis.method);
    double step_s = scene->analysis.step_s, shortest = INFINITY;
    struct thud_model *model;
    if (!method || !(method->flags & THUD_METHOD_FIXED_STEP) || isnan(step_s) ||
        thud_scene_assemble(scene, &model, NULL) != THUD_OK)
        return false;
    for (int c = 0; c < model->npairs; c++)
        shortest = fmin(shortest, thud_model_contact_period(&model->contact[c]));
    thud_model_free(model);
    if (step_s <= shortest / 20 * (1 + 1e-9) || search->found++ != search->wanted)
        return false;
    thud_error_set(search->out, THUD_OK, "%.4g ms is long for a contact that swings in %.4g ms", 1e3 * step_s,
                   1e3 * shortest);
    thud_error_allow(search->out, "usually up to a twentieth of that, %.4g ms", 50 * shortest);
    thud_error_key(search->out, "analysis.step");
    return true;
}

bool thud_scene_warning(const struct thud_scene *scene, int n, struct thud_error *out)
{
    struct search search = {n, 0, out};
    for (int s = 0; s < scene->nstructures; s++) {
        const struct thud_structure *at = &scene->structure[s];
        char key[64];
        snprintf(key, sizeof key, "structures.%d", s + 1);
        if (look_group(&search, THUD_GROUP_STRUCTURE, at, 1u << at->kind, at->storeys, key))
            return true;
        if (look_modes(&search, at, key) || look_estimate(&search, at, key))
            return true;
        snprintf(key, sizeof key, "structures.%d.column", s + 1);
        if (look_group(&search, THUD_GROUP_COLUMN, at, 1u << at->kind, at->storeys, key) ||
            look_columns(&search, at, key))
            return true;
        snprintf(key, sizeof key, "structures.%d.foundation", s + 1);
        if (thud_structure_on_soil(at) && look_group(&search, THUD_GROUP_FOUNDATION, at, 1u << at->kind, 0, key))
            return true;
        snprintf(key, sizeof key, "structures.%d.isolator", s + 1);
        if (thud_isolator_slides(at) && look_group(&search, THUD_GROUP_ISOLATOR, at, 1u << at->kind, at->storeys, key))
            return true;
    }
    for (int i = 0; i + 1 < scene->nstructures; i++)
        if (look_interface(&search, &scene->interface[i], i) || look_faces(&search, scene, i))
            return true;
    return look_group(&search, THUD_GROUP_RECORD, scene, 0, 0, "record") ||
           look_group(&search, THUD_GROUP_ANALYSIS, scene, 0, 0, "analysis") || look_levels(&search, scene) ||
           look_step(&search, scene);
}
