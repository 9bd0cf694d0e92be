/* From what a person describes to the numbers that a run needs. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/grow.h"
#include "study/scene/building.h"
#include "study/scene/level.h"
#include "study/scene/scene_elements.h"
#include "study/scene/solution.h"

/* Input of the model with the arrays it points to: stiffness and mass of an isolated building begin with its base. */
struct assembly {
    struct thud_structure_input structure[THUD_STRUCTURES_MAX];
    double mass_kg[THUD_STRUCTURES_MAX][THUD_STOREYS_MAX + 1];
    double stiffness_npm[THUD_STRUCTURES_MAX][THUD_STOREYS_MAX + 1];
    double yield_m[THUD_STRUCTURES_MAX][THUD_STOREYS_MAX + 1];
    double hardening[THUD_STRUCTURES_MAX][THUD_STOREYS_MAX + 1];
    double geometric_npm[THUD_STRUCTURES_MAX][THUD_STOREYS_MAX + 1];
    double collapse_m[THUD_STRUCTURES_MAX][THUD_STOREYS_MAX + 1];
    double rise_m[THUD_STRUCTURES_MAX][THUD_STOREYS_MAX + 1];
    double level_m[THUD_STRUCTURES_MAX][THUD_STOREYS_MAX + 1];
    struct thud_foundation_input foundation[THUD_STRUCTURES_MAX];
    struct thud_contact_pair meeting[THUD_CONTACT_PAIRS_MAX];
    double *matrix_npm[THUD_STRUCTURES_MAX]; /* (n x n) of a building by its matrix, else NULL */
    struct thud_contact_input *contact;
    int ncontacts;
    struct thud_link_input link[THUD_LINKS_MAX + 2];
    int nlinks;
};

/* W/h of each storey, and the drift at which it has collapsed; isolators stand on their own height. */
static void fill_weights(struct assembly *a, int index, const struct thud_structure *s)
{
    double *geometric = a->geometric_npm[index], *collapse = a->collapse_m[index];
    int base = s->kind == THUD_ISOLATED;
    geometric[0] = 0;
    collapse[0] = INFINITY;
    for (int i = 0; i < s->storeys; i++) {
        geometric[i + base] = thud_structure_weight(s, i) / s->height_m[i];
        collapse[i + base] = THUD_COLLAPSE_DRIFT * s->height_m[i];
    }
    a->structure[index].geometric_npm = geometric;
    a->structure[index].collapse_m = collapse;
}

/* Its floors turn about the underside of its lowest storey; isolators stand on no height of their own. */
static void fill_foundation(struct assembly *a, int index, const struct thud_structure *s)
{
    const int base = s->kind == THUD_ISOLATED;
    double *rise = a->rise_m[index];
    rise[0] = 0;
    for (int i = 0; i < s->storeys; i++)
        rise[i + base] = s->height_m[i];
    a->foundation[index] = thud_structure_foundation(s);
    a->structure[index].foundation = &a->foundation[index];
    a->structure[index].rise_m = rise;
}

/* Heights of an isolated building's floors above its isolators. */
static void fill_levels(struct assembly *a, int index, const struct thud_structure *s)
{
    double *level = a->level_m[index];
    level[0] = 0;
    for (int i = 0; i < s->storeys; i++)
        level[i + 1] = level[i] + s->height_m[i];
    a->structure[index].level_m = level;
}

static void fill_structure(struct assembly *a, int index, const struct thud_structure *s, bool p_delta)
{
    int n = thud_structure_floors(s), base = s->kind == THUD_ISOLATED;
    double *mass = a->mass_kg[index], *stiffness = a->stiffness_npm[index];
    struct thud_structure_input *to = &a->structure[index];
    *to = (struct thud_structure_input){.n = n, .mass_kg = mass};
    const struct thud_isolator isolator = base ? thud_structure_isolator(s) : (struct thud_isolator){0};
    if (base) {
        mass[0] = s->base_mass_kg;
        stiffness[0] = isolator.stiffness_npm;
    }
    for (int i = base; i < n; i++) {
        mass[i] = s->mass_kg[i - base];
        stiffness[i] = thud_structure_stiffness(s, i - base);
    }
    if (thud_wall_gives(s)) {
        mass[0] = s->wall_mass_kg;
        stiffness[0] = s->wall_stiffness_npm;
    }
    if (s->kind == THUD_RIGID) {
        to->velocity_mps = s->velocity_mps;
        return;
    }
    to->matrix_npm = a->matrix_npm[index];
    to->stiffness_npm = n > 0 && !to->matrix_npm ? stiffness : NULL;
    a->yield_m[index][0] = isolator.yield_m;
    a->hardening[index][0] = isolator.hardening;
    for (int i = base; i < n; i++) {
        a->yield_m[index][i] = thud_structure_yield(s, i - base);
        a->hardening[index][i] = s->hardening[i - base];
    }
    to->yield_m = a->yield_m[index];
    to->hardening = a->hardening[index];
    to->damping = thud_wall_gives(s) ? thud_wall_damping(s) : s->damping;
    to->modes = s->modes;
    to->isolated = base;
    to->isolation_damping = isolator.damping;
    if (p_delta && n > 0)
        fill_weights(a, index, s);
    if (thud_structure_on_soil(s))
        fill_foundation(a, index, s);
    if (base && !isnan(s->width_m))
        fill_levels(a, index, s);
}

static enum thud_status fill_matrix(struct assembly *a, const struct thud_scene *scene, int index,
                                    struct thud_error *err)
{
    const size_t n = (size_t)scene->structure[index].storeys;
    if (!thud_kind_is_read(scene->structure[index].kind))
        return THUD_OK;
    a->matrix_npm[index] = malloc(n * n * sizeof(double));
    if (!a->matrix_npm[index])
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    return thud_structure_lateral(scene, index, a->matrix_npm[index], err);
}

void thud_interface_contact(const struct thud_interface *interface, int level, struct thud_contact_input *to)
{
    const struct thud_level_values at = thud_interface_level(interface, level);
    const struct thud_law_choice *law = at.has_bumper ? &interface->bumper : &interface->contact;
    to->law = law->law;
    memcpy(to->setup.value, law->value, sizeof to->setup.value);
    to->setup.thickness_m = at.thickness_m;
    to->clearance_m = thud_level_clearance(&at);
}

/* The struck columns of a storey, from the floor above them (from 1). */
static struct thud_struck_input columns(const struct thud_structure *s, int floor,
                                        const struct thud_contact_pair *meeting)
{
    int storey = floor - 1 - (s->kind == THUD_ISOLATED);
    struct thud_struck_input out = {.side = meeting->struck,
                                    .a_m = meeting->a_m,
                                    .b_m = meeting->b_m,
                                    .hinged = s->column_shape == THUD_COLUMN_LINEAR,
                                    .ei_nm2 = thud_column_ei(s, storey),
                                    .capacity_n =
                                        s->column_capacity_n[storey] > 0 ? s->column_capacity_n[storey] : NAN};
    return out;
}

static bool add_contact(struct assembly *a, const struct thud_scene *scene, int index, int level,
                        const struct thud_contact_pair *meeting)
{
    struct thud_contact_input *larger = thud_grow(a->contact, (size_t)a->ncontacts, sizeof *larger);
    if (!larger)
        return false;
    a->contact = larger;
    struct thud_contact_input *to = &larger[a->ncontacts++];
    *to = (struct thud_contact_input){.interface = index + 1,
                                      .left_floor = meeting->left_floor,
                                      .right_floor = meeting->right_floor,
                                      .left_structure = index,
                                      .right_structure = index + 1};
    thud_interface_contact(&scene->interface[index], level, to);
    if (meeting->struck < 0)
        to->struck = columns(&scene->structure[index], meeting->left_floor, meeting);
    else if (meeting->struck > 0)
        to->struck = columns(&scene->structure[index + 1], meeting->right_floor, meeting);
    return true;
}

static bool join(struct assembly *a, const struct thud_scene *scene, int index)
{
    int n = thud_interface_contact_pairs(scene, index, a->meeting);
    for (int i = 0; i < n; i++)
        if (!add_contact(a, scene, index, i, &a->meeting[i]))
            return false;
    return true;
}

/* Its left end is that of the structure to the left. */
static void add_link(struct assembly *a, const struct thud_scene *scene, const struct thud_link *link)
{
    int structure[2], floor[2];
    if (thud_link_end(scene, link->from, &structure[0], &floor[0], NULL) != THUD_OK ||
        thud_link_end(scene, link->to, &structure[1], &floor[1], NULL) != THUD_OK)
        return; /* thud_scene_check has said so */
    const int left = structure[1] < structure[0], right = !left;
    struct thud_link_input *to = &a->link[a->nlinks++];
    *to = (struct thud_link_input){.left_structure = structure[left],
                                   .left_floor = floor[left],
                                   .right_structure = structure[right],
                                   .right_floor = floor[right],
                                   .stiffness_npm = link->stiffness_npm,
                                   .damping_nspm = link->damping_nspm,
                                   .slip_n = link->slip_n,
                                   .tension = link->law == THUD_LINK_RESTRAINER,
                                   .clearance_m = link->slack_m};
    if (link->law == THUD_LINK_RESTRAINER || link->law == THUD_LINK_STRUT) {
        to->law = thud_law_find("linear");
        to->setup.value[thud_law_param(to->law, "stiffness")] = link->stiffness_npm;
    }
}

/* The soil behind a wall at an end of the row is a strut of the law `backfill` between it and the ground. */
static void add_backfill(struct assembly *a, const struct thud_scene *scene, int index)
{
    const struct thud_structure *s = &scene->structure[index];
    if (!thud_wall_has_backfill(s))
        return;
    struct thud_link_input *to = &a->link[a->nlinks++];
    *to = (struct thud_link_input){.left_structure = index,
                                   .left_floor = index > 0,
                                   .right_structure = index,
                                   .right_floor = index == 0,
                                   .law = &thud_law_backfill,
                                   .setup.value = {s->backfill_stiffness_npm, s->backfill_strength_n,
                                                   isnan(s->backfill_ratio) ? 0.7 : s->backfill_ratio},
                                   .clearance_m = isnan(s->backfill_gap_m) ? 0 : s->backfill_gap_m};
}

enum thud_status thud_scene_assemble(const struct thud_scene *scene, struct thud_model **out, struct thud_error *err)
{
    *out = NULL;
    struct assembly *a = malloc(sizeof *a); /* of its 140 KB a scene fills little */
    if (!a)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    a->contact = NULL;
    a->ncontacts = a->nlinks = 0;
    memset(a->matrix_npm, 0, sizeof a->matrix_npm);
    enum thud_status status = THUD_OK;
    for (int s = 0; status == THUD_OK && s < scene->nstructures; s++) {
        status = fill_matrix(a, scene, s, err);
        fill_structure(a, s, &scene->structure[s], scene->p_delta);
    }
    for (int s = 0; status == THUD_OK && s + 1 < scene->nstructures; s++)
        if (!join(a, scene, s))
            status = thud_error_set(err, THUD_MEMORY, "out of memory");
    for (int i = 0; status == THUD_OK && i < scene->nlinks; i++)
        add_link(a, scene, &scene->link[i]);
    for (int s = 0; status == THUD_OK && s < scene->nstructures; s++)
        add_backfill(a, scene, s);
    if (status == THUD_OK) {
        struct thud_model_input input = {.nstructures = scene->nstructures,
                                         .structure = a->structure,
                                         .ncontacts = a->ncontacts,
                                         .contact = a->contact,
                                         .traits = thud_scene_elements(scene).traits,
                                         .modes = scene->analysis.modes,
                                         .nlinks = a->nlinks,
                                         .link = a->link};
        status = thud_model_create(&input, out, err);
    }
    for (int s = 0; s < scene->nstructures; s++)
        free(a->matrix_npm[s]);
    free(a->contact);
    free(a);
    return status;
}
