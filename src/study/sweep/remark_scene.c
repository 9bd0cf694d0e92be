/* What is allowed but unusual. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "core/methods/method.h"
#include "study/scene/building.h"
#include "study/scene/level.h"
#include "study/scene/scene_slot.h"
#include "study/scene/solution.h"
#include "study/sweep/remark_rows.h"

static void look(const struct thud_scene *scene, struct thud_remarks *out, const struct thud_param *param, double value,
                 const char *key)
{
    char usual[160], text[96];
    if (!thud_param_unusual(param, value, usual, sizeof usual))
        return;
    thud_scene_get_short(scene, key, NULL, text, sizeof text, NULL);
    struct thud_error *said = thud_remark_add(out);
    thud_error_set(said, THUD_OK, "%s is unusual", text);
    thud_error_allow(said, "usually %s", usual);
    thud_error_key(said, "%s", key);
}

static void look_group(const struct thud_scene *scene, struct thud_remarks *out, enum thud_group group,
                       const void *base, unsigned kind, int storeys, const char *prefix)
{
    const struct thud_param *param;
    for (int i = 0; (param = thud_group_param(group, i)); i++) {
        const struct thud_place *place = thud_group_place(group, i);
        if (kind && !(place->kinds & kind))
            continue;
        const double *value = (const double *)(const void *)((const char *)base + place->offset);
        int n = place->store == THUD_STORE_FLOORS ? storeys : place->store == THUD_STORE_NUMBER ? 1 : 0;
        for (int floor = 0; floor < n; floor++) {
            char key[96];
            snprintf(key, sizeof key, n > 1 ? "%s.%s.%d" : "%s.%s", prefix, param->name, floor + 1);
            if ((floor > 0 && value[floor] == value[floor - 1]) || (place->optional && value[floor] == 0))
                continue; /* said once */
            look(scene, out, param, value[floor], key);
        }
    }
}

void thud_remark_structure_values(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    const struct thud_structure *s = &scope->scene->structure[i];
    const struct {
        enum thud_group group;
        const char *part;
        bool is;
        int storeys;
    } each[] = {{THUD_GROUP_STRUCTURE, "", true, s->storeys},
                {THUD_GROUP_COLUMN, ".column", true, s->storeys},
                {THUD_GROUP_FOUNDATION, ".foundation", thud_structure_on_soil(s), 0},
                {THUD_GROUP_ISOLATOR, ".isolator", thud_isolator_slides(s), s->storeys}};
    for (size_t k = 0; k < sizeof each / sizeof *each; k++) {
        char key[64];
        snprintf(key, sizeof key, "structures.%d%s", i + 1, each[k].part);
        if (each[k].is)
            look_group(scope->scene, out, each[k].group, s, 1u << s->kind, each[k].storeys, key);
    }
}

void thud_remark_setup(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    (void)i;
    look_group(scope->scene, out, THUD_GROUP_RECORD, &scope->scene->record, 0, 0, "record");
    look_group(scope->scene, out, THUD_GROUP_ANALYSIS, &scope->scene->analysis, 0, 0, "analysis");
}

/* The law that acts first at an interface, and its key. */
static const struct thud_law_choice *first_law(const struct thud_remark_scope *scope, int i, char key[64])
{
    const struct thud_interface *at = &scope->scene->interface[i];
    snprintf(key, 64, "interfaces.%d.%s", i + 1, at->has_bumper ? "bumper" : "contact");
    return at->has_bumper ? &at->bumper : &at->contact;
}

void thud_remark_interface_values(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    char prefix[64], key[128];
    const struct thud_law_choice *choice = first_law(scope, i, prefix);
    if (scope->scene->interface[i].has_bumper)
        look_group(scope->scene, out, THUD_GROUP_BUMPER, &scope->scene->interface[i], 0, 0, prefix);
    for (int k = 0; choice->law && k < choice->law->nparams; k++) {
        snprintf(key, sizeof key, "%s.%s", prefix, choice->law->params[k].name);
        if (choice->law->params[k].kind == THUD_PARAM_QUANTITY)
            look(scope->scene, out, &choice->law->params[k], choice->value[k], key);
    }
}

/* What a bumper's law says of its values together. */
void thud_remark_whole_law(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    char prefix[64], key[sizeof((struct thud_error *)0)->key + 64];
    const struct thud_law_choice *choice = first_law(scope, i, prefix);
    struct thud_law_setup setup = {.mass_kg = 1, .thickness_m = scope->scene->interface[i].bumper_thickness_m};
    struct thud_error one = {0};
    if (!scope->scene->interface[i].has_bumper || !choice->law || !choice->law->unusual)
        return;
    memcpy(setup.value, choice->value, sizeof setup.value);
    if (thud_law_prepare(choice->law, &setup, NULL) != THUD_OK)
        return;
    for (int k = 0; choice->law->unusual(&setup, k, &one); k++) {
        snprintf(key, sizeof key, "%s.%s", prefix, one.key);
        struct thud_error *said = thud_remark_add(out);
        if (said)
            *said = one;
        thud_error_key(said, "%s", key);
    }
}

/* Struck columns stiffer than the storey that they are a part of. */
void thud_remark_columns(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    const struct thud_structure *s = &scope->scene->structure[i];
    for (int k = 0; k < s->storeys && thud_structure_has_group(s, THUD_GROUP_COLUMN); k++) {
        double length = thud_clear_height(s, k), own = 12 * thud_column_ei(s, k) / (length * length * length);
        const double storey = thud_structure_stiffness(s, k);
        if (!(storey > 0) || !(own > storey * (1 + 1e-9)))
            continue;
        struct thud_error *said = thud_remark_add(out);
        thud_error_set(
            said, THUD_OK,
            "the struck columns of storey %d have a stiffness of %.4g MN/m (12 EI/L^3), the storey only %.4g", k + 1,
            1e-6 * own, 1e-6 * storey);
        thud_error_key(said, "structures.%d.column.%s", i + 1, s->column_stiffness_npm[k] > 0 ? "stiffness" : "EI");
    }
}

/* Modes that are fewer than the floors. */
void thud_remark_modes(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    const struct thud_structure *s = &scope->scene->structure[i];
    if (s->kind != THUD_MODES || s->shape_rows == 0 || s->shape_rows >= s->storeys)
        return;
    thud_error_set(thud_remark_add(out), THUD_OK,
                   "%d of %d modes: the omitted motion has a tenth of their shortest period, so the local compliance "
                   "at a struck floor is not known",
                   s->shape_rows, s->storeys);
}

/* Both codes fit their formulas to buildings of some storeys. */
void thud_remark_estimate(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    static const double most_m = 40;
    const struct thud_structure *s = &scope->scene->structure[i];
    const double height = s->kind == THUD_ESTIMATED ? thud_structure_estimate(s).height_m : 0;
    if (!(height > most_m))
        return;
    struct thud_error *said = thud_remark_add(out);
    thud_error_set(said, THUD_OK, "a period is estimated for a building of %.4g m", height);
    thud_error_allow(said, "EN 1998-1 4.3.3.2.2(3): up to %.4g m", most_m);
}

/* A cavity that leaves less of the bumper outside than it can be compressed by: the walls would touch first. */
void thud_remark_cavity(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    const struct thud_interface *at = &scope->scene->interface[i];
    double strain = thud_interface_max_strain(at);
    if (!at->has_bumper || isnan(strain) || at->bumper_cavity_m <= at->bumper_thickness_m * (1 - strain) * (1 + 1e-9))
        return;
    struct thud_error *said = thud_remark_add(out);
    thud_error_set(said, THUD_OK,
                   "at a depth of %.4g cm the walls would touch before the bumper reaches its ultimate strain",
                   100 * at->bumper_cavity_m);
    thud_error_allow(said, "usually up to thickness (1 - max-strain), %.4g cm",
                     100 * at->bumper_thickness_m * (1 - strain));
}

/* Force of a law between bodies of an effective mass that approach, at a depth and speed usual for pounding. */
static double approach_force(const struct thud_law_choice *choice, double thickness_m, double mass_kg, double depth_m)
{
    struct thud_law_setup setup = {.mass_kg = mass_kg, .thickness_m = thickness_m};
    struct thud_law_memory memory = {{0}};
    memcpy(setup.value, choice->value, sizeof setup.value);
    if (choice->law->flags & (THUD_LAW_NO_FORCE | THUD_LAW_IMPULSIVE) ||
        thud_law_prepare(choice->law, &setup, NULL) != THUD_OK)
        return NAN;
    thud_law_onset(choice->law, &setup, 0.5, &memory);
    const struct thud_branch branch = thud_law_branch_at(choice->law, &setup, &memory, THUD_APPROACH, depth_m);
    return thud_branch_force(&branch, depth_m, 0.5, NULL, NULL);
}

/* A flexible wall, but stiffer than the contact and lighter than the floor that strikes it. It hardly moves, but laws
 * take their dashpot from the effective mass m1 m2/(m1 + m2), which is the wall's: it is not the fixed wall. */
void thud_remark_light_wall(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    static const double differ = 0.02, depth_m = 0.01; /* of a force: less is not worth a remark */
    struct thud_contact_pair pair[THUD_CONTACT_PAIRS_MAX];
    const struct thud_structure *left = &scope->scene->structure[i], *right = left + 1;
    const struct thud_structure *wall = left->kind == THUD_WALL ? left : right, *other = wall == left ? right : left;
    char key[64];
    const struct thud_law_choice *choice = first_law(scope, i, key);
    if (!thud_wall_gives(wall) || !choice->law || thud_interface_contact_pairs(scope->scene, i, pair) == 0)
        return;
    const int floor = wall == left ? pair[0].right_floor : pair[0].left_floor, base = other->kind == THUD_ISOLATED;
    const double mass = floor <= base ? other->base_mass_kg : other->mass_kg[floor - 1 - base],
                 effective = mass * wall->wall_mass_kg / (mass + wall->wall_mass_kg),
                 thickness_m = scope->scene->interface[i].bumper_thickness_m,
                 fixed = approach_force(choice, thickness_m, mass, depth_m),
                 gives = approach_force(choice, thickness_m, effective, depth_m);
    if (!(wall->wall_mass_kg < mass && wall->wall_stiffness_npm * depth_m > fixed && gives < (1 - differ) * fixed))
        return;
    struct thud_error *said = thud_remark_add(out);
    thud_error_set(said, THUD_OK,
                   "the wall of %.3g t hardly moves under a floor of %.3g t, but is not fixed: %s uses the dashpot of "
                   "their effective mass, %.3g t",
                   1e-3 * wall->wall_mass_kg, 1e-3 * mass, choice->law->name, 1e-3 * effective);
    thud_error_key(said, "structures.%d.mass", (int)(wall - scope->scene->structure) + 1);
}

/* A contact whose law nobody has chosen. */
void thud_remark_assumed_law(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    const struct thud_law_choice *choice = &scope->scene->interface[i].contact;
    if (choice->assumed)
        thud_error_set(thud_remark_add(out), THUD_OK,
                       "no impact law is given: %s is used, with usual values where none are given", choice->law->name);
}

/* Neighbours none of whose floors can touch. */
void thud_remark_levels(const struct thud_remark_scope *scope, int at, struct thud_remarks *out)
{
    const struct thud_scene *scene = scope->scene;
    struct thud_model *model;
    int contacts[THUD_STRUCTURES_MAX + 1] = {0};
    (void)at;
    if (thud_scene_assemble(scene, &model, NULL) != THUD_OK)
        return;
    for (int c = 0; c < model->npairs; c++)
        contacts[model->contact[c].interface]++;
    thud_model_free(model);
    for (int i = 0; i + 1 < scene->nstructures; i++) {
        const struct thud_structure *left = &scene->structure[i], *right = left + 1;
        if (contacts[i + 1] > 0)
            continue;
        struct thud_error *said = thud_remark_add(out);
        thud_error_set(said, THUD_OK, "%s and %s have no floors at the same level, so they cannot touch", left->name,
                       right->name);
        thud_error_key(said, "interfaces.%d", i + 1);
    }
}

/* Faces that overlap so little that what meets is neither two floors nor a slab and columns: the first pair, and how
 * many there are. */
void thud_remark_faces(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    const struct thud_scene *scene = scope->scene;
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
    if (few == 0)
        return;
    thud_error_set(thud_remark_add(out), THUD_OK,
                   "floor %d of %.40s and floor %d of %.40s overlap by %.3g cm of %.3g cm (%d such pairs): neither "
                   "floor-to-floor nor slab-to-column contact",
                   a, left->name, b, right->name, 100 * overlap, 100 * depth, few);
}

/* A step in which much of a contact goes by. */
void thud_remark_step(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    const struct thud_scene *scene = scope->scene;
    const struct thud_method *method = thud_method_find(scene->analysis.method);
    double step_s = scene->analysis.step_s, shortest = INFINITY;
    struct thud_model *model;
    (void)i;
    if (!method || !(method->flags & THUD_METHOD_FIXED_STEP) || isnan(step_s) ||
        thud_scene_assemble(scene, &model, NULL) != THUD_OK)
        return;
    for (int c = 0; c < model->npairs; c++)
        shortest = fmin(shortest, thud_model_contact_period(&model->contact[c]));
    thud_model_free(model);
    if (step_s <= shortest / 20 * (1 + 1e-9))
        return;
    struct thud_error *said = thud_remark_add(out);
    thud_error_set(said, THUD_OK, "%.4g ms is long for a contact with a period of %.4g ms", 1e3 * step_s,
                   1e3 * shortest);
    thud_error_allow(said, "usually up to a twentieth of that, %.4g ms", 50 * shortest);
}

/* A scene of much detail: which command shows how much of it is needed. */
void thud_remark_simpler(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    enum { FLOORS = 10 };
    const struct thud_scene *scene = scope->scene;
    bool soil = false;
    int floors = 0;
    (void)i;
    for (int s = 0; s < scene->nstructures; s++) {
        soil = soil || thud_structure_on_soil(&scene->structure[s]);
        floors += thud_structure_floors(&scene->structure[s]);
    }
    const struct {
        bool has;
        const char *words;
    } detail[] = {{scene->p_delta, "P-Delta"},
                  {soil, "soil"},
                  {thud_scene_yields(scene), "yielding"},
                  {scene->nlinks > 0, "links"},
                  {floors > FLOORS, "floors"}};
    struct thud_text words = {0};
    for (size_t k = 0; k < sizeof detail / sizeof *detail; k++)
        if (detail[k].has)
            thud_text_append(&words, "%s%s", words.size > 0 ? ", " : "", detail[k].words);
    if (words.data)
        thud_error_set(thud_remark_add(out), THUD_OK, "`thud simplify` shows how much detail this scene needs (%s)",
                       words.data);
    thud_text_clear(&words);
}
