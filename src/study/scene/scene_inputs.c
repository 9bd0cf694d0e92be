/* How many numbers have to be known to describe a scene. */
#include <math.h>

#include "study/scene/level.h"
#include "study/scene/scene_slot.h"

/* Values that are all the same are one number; 0 and what is not given are none. */
static int count_list(const double *value, int n)
{
    int given = 0;
    bool alike = true;
    for (int i = 0; i < n; i++) {
        given += isfinite(value[i]) && value[i] != 0;
        alike = alike && value[i] == value[0];
    }
    return alike && given > 0 ? 1 : given;
}

/* The quantities of a group that stand in a structure, an interface or a link; `kind`: of those that have them. */
static int count_group(const void *of, enum thud_group group, unsigned kind, int storeys)
{
    int sum = 0;
    const struct thud_param *param;
    for (int i = 0; (param = thud_group_param(group, i)); i++) {
        const struct thud_place *place = thud_group_place(group, i);
        const void *at = (const char *)of + place->offset;
        const struct thud_by_level *levels = at;
        if (param->kind != THUD_PARAM_QUANTITY || (place->kinds && !(place->kinds & 1u << kind)))
            continue;
        if (place->store == THUD_STORE_NUMBER)
            sum += count_list(at, 1);
        else if (place->store == THUD_STORE_FLOORS)
            sum += count_list(at, storeys);
        else if (place->store == THUD_STORE_LEVELS && param->dimension != THUD_NUMBER)
            sum += count_list(levels->value_m, levels->n);
    }
    return sum;
}

static int count_law(const struct thud_law_choice *choice)
{
    int sum = 0;
    for (int i = 0; choice->law && i < choice->law->nparams; i++)
        sum += choice->law->params[i].kind == THUD_PARAM_QUANTITY && count_list(&choice->value[i], 1) > 0;
    return sum;
}

/* Floors of a structure that can meet a neighbour. */
static int meeting_floors(const struct thud_scene *scene, int structure)
{
    bool meets[THUD_STOREYS_MAX + 2] = {false};
    struct thud_contact_pair pair[THUD_CONTACT_PAIRS_MAX];
    int sum = 0;
    for (int i = structure - 1; i <= structure; i++) {
        const bool there = i >= 0 && i + 1 < scene->nstructures;
        for (int k = there ? thud_interface_contact_pairs(scene, i, pair) - 1 : -1; k >= 0; k--)
            meets[i == structure ? pair[k].left_floor : pair[k].right_floor] = true;
    }
    for (int f = 1; f < THUD_STOREYS_MAX + 2; f++)
        sum += meets[f];
    return sum;
}

/* What masses and stiffnesses come to. Few modes need no more than period and modal mass of each, and its shape at the
 * floors that meet a neighbour. */
static int count_storeys(const struct thud_scene *scene, int structure)
{
    const struct thud_structure *s = &scene->structure[structure];
    const int n = s->storeys, modes = s->modes > 0 ? s->modes : scene->analysis.modes;
    int sum = 0;
    if (s->kind == THUD_MATRIX)
        sum = count_list(s->mass_kg, n) + n * (n + 1) / 2;
    else if (s->kind == THUD_MODES)
        sum = count_list(s->mass_kg, n) + s->shape_rows * (n + 1);
    else if (s->kind != THUD_ESTIMATED)
        sum = count_list(s->mass_kg, n) + count_list(s->stiffness_npm, n);
    const int few = modes * (2 + meeting_floors(scene, structure));
    return modes > 0 && few < sum ? few : sum;
}

static int count_structure(const struct thud_scene *scene, int structure)
{
    const struct thud_structure *s = &scene->structure[structure];
    int sum = count_group(s, THUD_GROUP_STRUCTURE, s->kind, s->storeys);
    for (int i = 0; i < THUD_NESTED_GROUPS; i++)
        if (thud_structure_has_group(s, thud_nested_group(i)))
            sum += count_group(s, thud_nested_group(i), s->kind, s->storeys);
    if (thud_kind_is_building(s->kind) && s->kind != THUD_ESTIMATED)
        sum += count_storeys(scene, structure) - count_list(s->mass_kg, s->storeys) -
               (thud_kind_is_read(s->kind) ? 0 : count_list(s->stiffness_npm, s->storeys));
    return sum;
}

static int count_interface(const struct thud_interface *at)
{
    int sum = 0;
    bool bare = !at->has_bumper;
    for (int l = 0; l < at->thickness.n; l++)
        bare = bare || at->thickness.value_m[l] == 0;
    if (bare && at->contact.law && at->contact.law->flags & THUD_LAW_NO_FORCE)
        return 0;
    sum += count_group(at, THUD_GROUP_INTERFACE, 0, 0);
    sum += bare ? count_law(&at->contact) : 0;
    return sum + (at->has_bumper ? count_group(at, THUD_GROUP_BUMPER, 0, 0) + count_law(&at->bumper) : 0);
}

int thud_scene_inputs(const struct thud_scene *scene)
{
    int sum = 0;
    for (int s = 0; s < scene->nstructures; s++)
        sum += count_structure(scene, s);
    for (int i = 0; i + 1 < scene->nstructures; i++)
        sum += count_interface(&scene->interface[i]);
    for (int i = 0; i < scene->nlinks; i++)
        sum += count_group(&scene->link[i], THUD_GROUP_LINK, (unsigned)scene->link[i].law, 0);
    return sum;
}
