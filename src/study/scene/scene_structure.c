/* Structures and their lists of floors; laws and bumpers; the empty scene. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/quantity.h"
#include "base/text.h"
#include "study/scene/building.h"
#include "study/scene/scene_slot.h"
#include "study/scene/scene_words.h"

double *thud_structure_list(struct thud_structure *structure, int which)
{
    double *const list[THUD_STRUCTURE_LISTS] = {structure->mass_kg,
                                                structure->stiffness_npm,
                                                structure->height_m,
                                                structure->yield_m,
                                                structure->yield_shear_n,
                                                structure->hardening,
                                                structure->column_ei_nm2,
                                                structure->column_stiffness_npm,
                                                structure->column_capacity_n,
                                                structure->slab_depth_m,
                                                structure->gravity_n,
                                                structure->yield_coefficient,
                                                structure->load_pa};
    return list[which];
}

static double cracked(const struct thud_structure *structure)
{
    return structure->cracked > 0 ? structure->cracked : 1;
}

double thud_structure_stiffness(const struct thud_structure *structure, int i)
{
    return cracked(structure) * structure->stiffness_npm[i];
}

double thud_structure_yield(const struct thud_structure *structure, int i)
{
    if (structure->yield_m[i] > 0)
        return structure->yield_m[i];
    if (structure->yield_coefficient[i] > 0)
        return structure->yield_coefficient[i] * thud_structure_weight(structure, i) /
               thud_structure_stiffness(structure, i);
    return structure->yield_shear_n[i] > 0 ? structure->yield_shear_n[i] / thud_structure_stiffness(structure, i)
                                           : INFINITY;
}

bool thud_isolator_slides(const struct thud_structure *structure)
{
    return structure->kind == THUD_ISOLATED && structure->isolator_law != THUD_ISOLATOR_LINEAR;
}

double thud_structure_weight(const struct thud_structure *structure, int i)
{
    double weight = 0;
    for (; i < structure->storeys; i++)
        weight += structure->gravity_n[i] > 0 ? structure->gravity_n[i] : THUD_GRAVITY * structure->mass_kg[i];
    return weight;
}

struct thud_storey thud_storey_of(const struct thud_structure *s, int i)
{
    const double stiffness = thud_kind_is_read(s->kind) ? (double)NAN : thud_structure_stiffness(s, i),
                 yield = thud_structure_yield(s, i), drift = isfinite(yield) ? yield : (double)NAN,
                 weight = thud_structure_weight(s, i);
    return (struct thud_storey){stiffness, weight, stiffness * drift, drift, stiffness * drift / weight};
}

void thud_structure_init(struct thud_structure *structure, enum thud_structure_kind kind)
{
    memset(structure, 0, sizeof *structure);
    structure->kind = kind;
    structure->storeys = kind == THUD_WALL ? 0 : 1;
    thud_group_clear(structure, THUD_GROUP_STRUCTURE, 1u << kind);
    for (int i = 0; i < THUD_NESTED_GROUPS; i++)
        thud_group_clear(structure, thud_nested_group(i), 1u << kind);
}

/* Storeys are added and taken away below the top floor, which keeps its values; new ones are like the one below it. */
enum thud_status thud_storeys_set(struct thud_structure *structure, int storeys)
{
    int before = structure->storeys;
    for (int which = 0; which < THUD_STRUCTURE_LISTS; which++) {
        double *list = thud_structure_list(structure, which), top = list[before - 1];
        double like = before > 1 ? list[before - 2] : list[0];
        for (int i = before - 1; i < storeys - 1; i++)
            list[i] = like;
        for (int i = storeys; i < before; i++)
            list[i] = 0;
        list[storeys - 1] = top;
    }
    structure->storeys = storeys;
    return THUD_OK;
}

/* Storeys that a building by its matrix has not, or has no more. */
static void change_springs(struct thud_structure *structure, int i)
{
    if (thud_kind_is_read(structure->kind) || structure->kind == THUD_ESTIMATED)
        structure->stiffness_npm[i] = structure->yield_m[i] = structure->yield_shear_n[i] =
            structure->yield_coefficient[i] = structure->hardening[i] = 0;
    else if (!(structure->stiffness_npm[i] > 0))
        structure->stiffness_npm[i] = 600e6;
}

/* Numbers of a group that both have. */
static void copy_group(const struct thud_structure *from, struct thud_structure *to, enum thud_group group)
{
    const struct thud_place *place;
    for (int i = 0; (place = thud_group_place(group, i)); i++)
        if (place->store == THUD_STORE_NUMBER)
            memcpy((char *)to + place->offset, (const char *)from + place->offset, sizeof(double));
}

int thud_scene_names_width(const struct thud_scene *scene, int least)
{
    for (int s = 0; s < scene->nstructures; s++)
        least = thud_text_wider(least, scene->structure[s].name);
    return least;
}

/* What the new kind has and the old one had not gets the values of the paper's buildings, so that a change of kind
 * alone leaves a structure that can be computed. */
enum thud_status thud_kind_set(struct thud_structure *structure, enum thud_structure_kind kind)
{
    struct thud_structure before = *structure;
    bool storeys = thud_kind_is_building(kind), had = thud_kind_is_building(before.kind);
    if (kind == before.kind)
        return THUD_OK;
    thud_structure_init(structure, kind);
    memcpy(structure->name, before.name, sizeof structure->name);
    memcpy(structure->source[0], before.source[0], sizeof structure->source[0]);
    if (kind == THUD_WALL)
        return THUD_OK;
    structure->mass_kg[0] = before.storeys > 0 ? before.mass_kg[0] : 320e3;
    if (storeys) {
        if (!thud_kind_is_read(kind))
            structure->stiffness_npm[0] = 600e6;
        if (had) {
            structure->storeys = before.storeys;
            for (int which = 0; which < THUD_STRUCTURE_LISTS; which++)
                memcpy(thud_structure_list(structure, which), thud_structure_list(&before, which),
                       sizeof before.mass_kg);
            structure->damping = before.damping;
            structure->area_m2 = before.load_pa[0] > 0 ? before.area_m2 : 0;
            structure->base_m = before.base_m;
            copy_group(&before, structure, THUD_GROUP_FOUNDATION);
            copy_group(&before, structure, THUD_GROUP_COLUMN);
            for (int i = 0; i < structure->storeys; i++)
                change_springs(structure, i);
        }
    }
    if (kind == THUD_ESTIMATED && !(structure->area_m2 > 0)) /* it keeps its mass */
        structure->area_m2 = structure->mass_kg[0] / THUD_ESTIMATE_KGPM2;
    thud_structure_fill_estimate(structure);
    if (kind == THUD_ISOLATED) {
        double mass = structure->base_mass_kg = structure->mass_kg[0];
        for (int i = 0; i < structure->storeys; i++)
            mass += structure->mass_kg[i];
        /* a period of 2 s */
        structure->isolation_stiffness_npm = rint(mass * 9.8696044 / 1e5) * 1e5;
    }
    return THUD_OK;
}

bool thud_wall_gives(const struct thud_structure *structure)
{
    return structure->kind == THUD_WALL && isfinite(structure->wall_mass_kg);
}

double thud_wall_damping(const struct thud_structure *structure)
{
    static const double usual = 0.05;
    return isnan(structure->wall_damping) ? usual : structure->wall_damping;
}

bool thud_wall_has_backfill(const struct thud_structure *structure)
{
    return thud_wall_gives(structure) && thud_structure_has_group(structure, THUD_GROUP_BACKFILL);
}

enum thud_group thud_nested_group(int i)
{
    return (enum thud_group)((int)THUD_GROUP_COLUMN + i);
}

bool thud_structure_has_group(const struct thud_structure *s, enum thud_group group)
{
    const struct thud_place *place;
    for (int i = 0; (place = thud_group_place(group, i)); i++) {
        const double *value = (const double *)(const void *)((const char *)s + place->offset);
        const double usual = place->store == THUD_STORE_NUMBER ? place->absent : 0;
        for (int k = 0; k < (place->store == THUD_STORE_FLOORS ? s->storeys : 1); k++)
            if (place->store != THUD_STORE_TEXT && place->kinds & 1u << s->kind && isfinite(value[k]) &&
                value[k] != usual &&
                (value[k] != 0 || group == THUD_GROUP_BACKFILL)) /* nothing stands on dashpots of 0 */
                return true;
    }
    return false;
}

double thud_clear_height(const struct thud_structure *structure, int storey)
{
    return structure->height_m[storey] - structure->slab_depth_m[storey];
}

double thud_column_ei(const struct thud_structure *structure, int storey)
{
    double length = thud_clear_height(structure, storey), k = structure->column_stiffness_npm[storey],
           ei = k > 0 ? k * length * length * length / 12 : structure->column_ei_nm2[storey];
    return ei > 0 ? cracked(structure) * ei : NAN;
}

/* One floor's value; `none` where that is allowed. */
static enum thud_status read_floor(const struct thud_slot *slot, const char *text, double *out, struct thud_error *err)
{
    if (thud_floor_may_lack(slot->param, &slot->place) && strcmp(text, THUD_FLOOR_NONE) == 0) {
        *out = 0;
        return THUD_OK;
    }
    return thud_quantity_read(slot->param, NULL, text, out, err);
}

static enum thud_status set_list(struct thud_structure *structure, const struct thud_slot *slot, char *text,
                                 double *list, struct thud_error *err)
{
    char *item[THUD_STOREYS_MAX];
    double value[THUD_STOREYS_MAX];
    int n = thud_list_split(text, item, THUD_STOREYS_MAX);
    if (n < 0)
        return thud_error_set(err, THUD_INPUT, "the list has no end; write [320 t, 250 t]");
    if (n != structure->storeys) {
        thud_error_set(err, THUD_INPUT, "the list has %d value%s, the structure has %d", n, n == 1 ? "" : "s",
                       structure->storeys);
        thud_error_allow(err, "one value for every floor, or %d from the lowest up", structure->storeys);
        return THUD_INPUT;
    }
    for (int i = 0; i < n; i++) {
        enum thud_status status = read_floor(slot, item[i], &value[i], err);
        if (status != THUD_OK)
            return status;
    }
    memcpy(list, value, (size_t)n * sizeof *value);
    return THUD_OK;
}

enum thud_status thud_floors_set(struct thud_scene *scene, const struct thud_slot *slot, const char *text,
                                 struct thud_error *err)
{
    struct thud_structure *structure = &scene->structure[slot->structure];
    double *list = thud_slot_at(scene, slot), value;
    if (text[0] == '[') {
        char copy[16400];
        if (slot->floor >= 0)
            return thud_error_set(err, THUD_INPUT, "one floor takes one value, not a list");
        snprintf(copy, sizeof copy, "%s", text);
        return set_list(structure, slot, copy, list, err);
    }
    enum thud_status status = read_floor(slot, text, &value, err);
    if (status != THUD_OK)
        return status;
    for (int i = 0; i < structure->storeys; i++)
        if (slot->floor < 0 || slot->floor == i)
            list[i] = value;
    return THUD_OK;
}

/* ---- laws ---- */

void thud_interface_add_bumper(struct thud_interface *interface)
{
    const struct thud_law *rubber = thud_law_find("rubber");
    thud_law_choice_init(&interface->bumper, rubber);
    struct thud_quantity stiffness;
    int k = thud_law_param(rubber, "stiffness");
    if (thud_quantity_parse("0.36 kN/mm^2.65", THUD_POWER_STIFFNESS, NULL, &stiffness, NULL) == THUD_OK)
        interface->bumper.value[k] = stiffness.value;
    interface->has_bumper = true;
    if (!(interface->bumper_thickness_m > 0))
        interface->bumper_thickness_m = interface->gap_m > 0 ? fmin(0.05, interface->gap_m) : 0.05;
}

void thud_interface_init(struct thud_interface *interface)
{
    memset(interface, 0, sizeof *interface);
    interface->gap_m = 0.1;
    thud_law_choice_init(&interface->contact, thud_law_find("kelvin-voigt-no-tension"));
}

static enum thud_status unknown_law(const char *name, struct thud_error *err)
{
    struct thud_words words = {0};
    for (int i = 0; i < thud_law_count(); i++)
        thud_words_add(&words, thud_law_at(i)->name);
    return thud_words_unknown(&words, "law", name, err);
}

/* Values of the same name and dimension are kept. */
static void change_law(struct thud_law_choice *choice, const struct thud_law *law)
{
    struct thud_law_choice before = *choice;
    thud_law_choice_init(choice, law);
    for (int i = 0; before.law && i < before.law->nparams; i++) {
        int j = thud_law_param(law, before.law->params[i].name);
        if (j >= 0 && law->params[j].kind == before.law->params[i].kind && law->params[j].kind == THUD_PARAM_QUANTITY &&
            law->params[j].dimension == before.law->params[i].dimension &&
            law->params[j].dimension != THUD_POWER_STIFFNESS && strcmp(law->params[j].name, "exponent") != 0)
            choice->value[j] = before.value[i];
    }
}

enum thud_status thud_law_set(struct thud_scene *scene, const struct thud_slot *slot, const char *text,
                              struct thud_error *err)
{
    const struct thud_law *law = thud_law_find(text);
    struct thud_interface *interface = &scene->interface[slot->interface];
    struct thud_law_choice *choice = thud_slot_at(scene, slot);
    if (!law)
        return unknown_law(text, err);
    if (choice->law == law && (!slot->bumper || interface->has_bumper))
        return THUD_OK;
    if (slot->bumper && (!interface->has_bumper || !choice->law || strcmp(law->name, "rubber") == 0))
        thud_interface_add_bumper(interface);
    if (choice->law != law)
        change_law(choice, law);
    return THUD_OK;
}

/* ---- the empty scene ---- */

void thud_record_choice_init(struct thud_record_choice *choice)
{
    memset(choice, 0, sizeof *choice);
    thud_group_clear(choice, THUD_GROUP_RECORD, 0);
    choice->target_from_s = choice->target_to_s = choice->resample_s = NAN; /* no keys of presets */
}

void thud_record_choice_replace(struct thud_record_choice *choice, const char *file)
{
    char name[THUD_TEXT_MAX];
    snprintf(name, sizeof name, "%s", file); /* it may be the choice's own */
    thud_record_choice_init(choice);
    memcpy(choice->file, name, strlen(name));
}

void thud_scene_init(struct thud_scene *scene)
{
    memset(scene, 0, sizeof *scene);
    thud_record_choice_init(&scene->record);
    for (enum thud_group group = THUD_GROUP_ANALYSIS; group <= THUD_GROUP_DOCUMENT; group++)
        thud_group_clear((char *)scene + thud_group_base(group), group, 0);
}
