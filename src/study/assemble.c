/* From what a person describes to the numbers that a run needs. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "study/answer.h"

/* Floors closer in elevation than this stand at the same level. */
static const double same_level_m = 1e-6;

/* Input of the model with the arrays it points to: stiffness and mass of an isolated building begin with its base. */
struct assembly {
    struct thud_structure_input structure[THUD_STRUCTURES_MAX];
    double mass_kg[THUD_STRUCTURES_MAX][THUD_STOREYS_MAX + 1];
    double stiffness_npm[THUD_STRUCTURES_MAX][THUD_STOREYS_MAX + 1];
    double yield_m[THUD_STRUCTURES_MAX][THUD_STOREYS_MAX + 1];
    double hardening[THUD_STRUCTURES_MAX][THUD_STOREYS_MAX + 1];
    double level_m[THUD_STRUCTURES_MAX][THUD_STOREYS_MAX + 1]; /* elevation of each floor */
    struct thud_contact_input *contact;
    int ncontacts, capacity;
};

static int floors(const struct thud_structure *s)
{
    switch (s->kind) {
    case THUD_SHEAR:
        return s->storeys;
    case THUD_ISOLATED:
        return s->storeys + 1;
    case THUD_RIGID:
        return 1;
    case THUD_WALL:
        break;
    }
    return 0;
}

static void fill_structure(struct assembly *a, int index, const struct thud_structure *s)
{
    int n = floors(s), base = s->kind == THUD_ISOLATED;
    double *mass = a->mass_kg[index], *stiffness = a->stiffness_npm[index], *level = a->level_m[index];
    struct thud_structure_input *to = &a->structure[index];
    *to = (struct thud_structure_input){.n = n, .mass_kg = mass};
    if (base) {
        mass[0] = s->base_mass_kg;
        stiffness[0] = s->isolation_stiffness_npm;
        level[0] = 0;
    }
    for (int i = base; i < n; i++) {
        mass[i] = s->mass_kg[i - base];
        stiffness[i] = s->stiffness_npm[i - base];
        level[i] = (i > 0 ? level[i - 1] : 0) + s->height_m[i - base];
    }
    if (s->kind == THUD_RIGID) {
        to->velocity_mps = s->velocity_mps;
        return;
    }
    to->stiffness_npm = n > 0 ? stiffness : NULL;
    a->yield_m[index][0] = INFINITY; /* isolators do not yield */
    for (int i = base; i < n; i++) {
        a->yield_m[index][i] = thud_structure_yield(s, i - base);
        a->hardening[index][i] = s->hardening[i - base];
    }
    to->yield_m = a->yield_m[index];
    to->hardening = a->hardening[index];
    to->damping = s->damping;
    to->isolated = base;
    to->isolation_damping = s->isolation_damping;
}

/* A bumper covers every level of its interface. */
static void fill_law(const struct thud_interface *interface, struct thud_contact_input *to)
{
    const struct thud_law_choice *law = interface->has_bumper ? &interface->bumper : &interface->contact;
    to->law = law->law;
    memcpy(to->setup.value, law->value, sizeof to->setup.value);
    to->setup.thickness_m = interface->has_bumper ? interface->bumper_thickness_m : 0;
    to->clearance_m = thud_interface_clearance(interface);
}

static bool add_contact(struct assembly *a, const struct thud_interface *interface, int index, int left, int right)
{
    if (a->ncontacts == a->capacity) {
        int more = a->capacity ? 2 * a->capacity : 64;
        struct thud_contact_input *p = realloc(a->contact, (size_t)more * sizeof *p);
        if (!p)
            return false;
        a->contact = p;
        a->capacity = more;
    }
    struct thud_contact_input *to = &a->contact[a->ncontacts++];
    *to = (struct thud_contact_input){.interface = index + 1,
                                      .left_floor = left,
                                      .right_floor = right,
                                      .left_structure = index,
                                      .right_structure = index + 1};
    fill_law(interface, to);
    return true;
}

/* Whether floor i (from 0) of a building stands where its neighbour, a rigid body or a wall, can touch it. */
static bool meets(const struct assembly *a, int building, int i, const struct thud_structure *neighbour)
{
    double level = a->level_m[building][i], own = neighbour->height_m[0];
    if (neighbour->kind == THUD_WALL)
        return !(own < level - same_level_m);
    if (!isfinite(own))
        return i == 0;
    return fabs(level - own) <= same_level_m;
}

static bool is_building(const struct thud_structure *s)
{
    return s->kind == THUD_SHEAR || s->kind == THUD_ISOLATED;
}

static bool join(struct assembly *a, const struct thud_scene *scene, int index)
{
    const struct thud_structure *left = &scene->structure[index], *right = left + 1;
    const struct thud_interface *interface = &scene->interface[index];
    int nleft = floors(left), nright = floors(right);
    if (!is_building(left) && !is_building(right))
        return nleft + nright == 0 || add_contact(a, interface, index, nleft, nright);
    if (!is_building(right)) {
        for (int i = 0; i < nleft; i++)
            if (meets(a, index, i, right) && !add_contact(a, interface, index, i + 1, nright))
                return false;
        return true;
    }
    if (!is_building(left)) {
        for (int i = 0; i < nright; i++)
            if (meets(a, index + 1, i, left) && !add_contact(a, interface, index, nleft, i + 1))
                return false;
        return true;
    }
    for (int i = 0; i < nleft; i++)
        for (int k = 0; k < nright; k++)
            if (fabs(a->level_m[index][i] - a->level_m[index + 1][k]) <= same_level_m &&
                !add_contact(a, interface, index, i + 1, k + 1))
                return false;
    return true;
}

enum thud_status thud_scene_assemble(const struct thud_scene *scene, struct thud_model **out, struct thud_error *err)
{
    *out = NULL;
    struct assembly *a = calloc(1, sizeof *a);
    bool ok = a != NULL;
    for (int s = 0; ok && s < scene->nstructures; s++)
        fill_structure(a, s, &scene->structure[s]);
    for (int s = 0; ok && s + 1 < scene->nstructures; s++)
        ok = join(a, scene, s);
    enum thud_status status = THUD_MEMORY;
    if (ok) {
        struct thud_model_input input = {scene->nstructures, a->structure, a->ncontacts, a->contact,
                                         scene->analysis.modes};
        status = thud_model_create(&input, out, err);
    } else {
        thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    if (a)
        free(a->contact);
    free(a);
    return status;
}
