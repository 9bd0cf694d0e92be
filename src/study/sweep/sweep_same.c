/* Within a group, runs whose contacts are the same (laws with their values, clearances) are the same run: case `none`
 * at one gap whatever the bumper, a bumper in a cavity and one with the same projection at another gap. The first of
 * them makes it, the others take its result. Runs of a group are numbered by point, then by case (the plan's, and after
 * them `none` for the ratios). */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "study/sweep/sweep_private.h"

enum { RUNS_MAX = 1 << 18 }; /* of a group with more of them each is made */

/* What a run's contacts are, in 128 bits. */
struct key {
    uint64_t a, b;
    long run; /* in the group */
};

/* A result that more than one run has. Behind it stand its contacts, (nvariants x ncontacts). */
struct kept {
    struct thud_sweep_effort effort;
    struct thud_sweep_floor floor[]; /* (nvariants x nfloors) */
};

struct thud_sweep_same {
    long points, runs, next; /* of the group, and up to which point keys were made */
    struct key *key;         /* (runs) while they are made */
    int32_t *maker;          /* (runs): the run whose result it has; -1: no other has it */
    int32_t *place;          /* (runs): of a maker, its place in `kept` */
    struct kept **kept;      /* (nkept) once made */
    long nkept;
};

int thud_sweep_point_cases(const struct thud_sweep_plan *plan, const struct thud_scene *scene, enum thud_case *which)
{
    bool none = false;
    for (int i = 0; i < plan->ncases; i++) {
        which[i] = plan->cases[i];
        none = none || which[i] == THUD_CASE_NONE;
    }
    if (none || !thud_scene_has_measure(scene))
        return plan->ncases;
    which[plan->ncases] = THUD_CASE_NONE;
    return plan->ncases + 1;
}

static void mix(struct key *key, double value)
{
    uint64_t bits;
    value += 0.0; /* -0 is 0 */
    memcpy(&bits, &value, sizeof bits);
    key->a = (key->a ^ bits) * 0x9e3779b97f4a7c15U;
    key->a ^= key->a >> 29;
    key->b = (key->b + bits) * 0xd6e8feb86659fd93U;
    key->b ^= key->b >> 32;
}

/* All that a case's model has and the group's does not. */
static void mix_contacts(struct key *key, const struct thud_scene *cased)
{
    if (cased->nlinks > 0) /* what they are is the group's */
        mix(key, cased->nlinks);
    for (int i = 0; i + 1 < cased->nstructures; i++) {
        const struct thud_interface *at = &cased->interface[i];
        struct thud_contact_input contact = {0};
        for (int l = 0; l < at->gap.n || l < at->thickness.n; l++) { /* has_bumper: the law */
            const struct thud_level_values level = thud_interface_level(at, l);
            mix(key, thud_level_clearance(&level));
            mix(key, level.thickness_m);
        }
        thud_interface_contact(at, -1, &contact);
        mix(key, contact.clearance_m);
        mix(key, contact.setup.thickness_m);
        for (const char *p = contact.law->name; *p; p++)
            mix(key, *p);
        for (int j = 0; j < contact.law->nparams; j++)
            mix(key, contact.setup.value[j]);
    }
}

/* Of a run and all its changed ones; *cased: scratch. A run that is not possible is like no other. */
static struct key key_of(const struct thud_sweep_plan *plan, const struct thud_scene *scene, enum thud_case which,
                         long run, struct thud_scene *cased)
{
    int nvariants = plan->sensitivity > 0 ? THUD_SWEEP_VARIANTS : 1;
    struct key key = {1, 1, run};
    for (int v = 0; v < nvariants; v++) {
        if (thud_sweep_case(plan, scene, which, v, true, cased, NULL) != THUD_OK)
            return (struct key){0, (uint64_t)run, run};
        mix_contacts(&key, cased);
    }
    return key;
}

static int compare(const void *left, const void *right)
{
    const struct key *l = left, *r = right;
    if (l->a != r->a)
        return l->a < r->a ? -1 : 1;
    if (l->b != r->b)
        return l->b < r->b ? -1 : 1;
    return l->run < r->run ? -1 : 1;
}

/* Runs with equal keys follow each other, the first of the group first. Places are given in the order of the makers. */
static enum thud_status match(struct thud_sweep_same *same, size_t bytes, struct thud_error *err)
{
    long most = (long)(THUD_SWEEP_SAME_BYTES / bytes);
    qsort(same->key, (size_t)same->runs, sizeof *same->key, compare);
    for (long i = 0; i < same->runs; i++)
        same->maker[i] = same->place[i] = -1;
    for (long i = 0, first = 0; i < same->runs; i++) {
        const struct key *key = &same->key[i], *maker = &same->key[first];
        if (key->a != maker->a || key->b != maker->b || key->a == 0)
            first = i;
        else if (i > first)
            same->maker[key->run] = same->maker[maker->run] = (int32_t)maker->run;
    }
    for (long i = 0; i < same->runs; i++) {
        if (same->maker[i] == i)
            same->place[i] = (int32_t)same->nkept++;
        if (same->maker[i] >= 0 && same->place[same->maker[i]] >= most)
            same->maker[i] = -1; /* there is no room for more: each is made */
    }
    same->nkept = same->nkept < most ? same->nkept : most;
    free(same->key);
    same->key = NULL;
    same->kept = calloc((size_t)same->nkept + 1, sizeof(struct kept *));
    return same->kept ? THUD_OK : thud_error_set(err, THUD_MEMORY, "out of memory");
}

enum thud_status thud_sweep_same_create(const struct thud_sweep_plan *plan, struct thud_sweep_same **out,
                                        struct thud_error *err)
{
    long points = thud_sweep_points_per_group(plan), cases = plan->ncases + 1;
    *out = NULL;
    if (!(plan->shortcuts & THUD_SWEEP_SAME) || points > RUNS_MAX / cases)
        return THUD_OK;
    struct thud_sweep_same *same = calloc(1, sizeof *same);
    if (same) {
        same->points = points;
        same->runs = points * cases;
        same->key = malloc((size_t)same->runs * sizeof *same->key);
        same->maker = malloc((size_t)same->runs * sizeof *same->maker);
        same->place = malloc((size_t)same->runs * sizeof *same->place);
    }
    if (!same || !same->key || !same->maker || !same->place) {
        thud_sweep_same_free(same);
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    *out = same;
    return THUD_OK;
}

static size_t size_of(int nvariants, int nfloors, int ncontacts)
{
    return sizeof(struct kept) + (size_t)nvariants * ((size_t)nfloors * sizeof(struct thud_sweep_floor) +
                                                      (size_t)ncontacts * sizeof(struct thud_sweep_contact));
}

static enum thud_status add_keys(struct thud_sweep_same *same, const struct thud_sweep_plan *plan, long point,
                                 struct thud_scene *scenes, struct thud_error *err)
{
    enum thud_case which[THUD_SWEEP_CASES_MAX + 1];
    long run = same->next++ * (plan->ncases + 1);
    enum thud_status status = thud_sweep_scene(plan, point, scenes, err);
    int ncases = status == THUD_OK ? thud_sweep_point_cases(plan, scenes, which) : 0;
    for (int k = 0; k <= plan->ncases; k++)
        same->key[run + k] = k < ncases ? key_of(plan, scenes, which[k], run + k, scenes + 1)
                                        : (struct key){0, (uint64_t)(run + k), run + k};
    return status;
}

enum thud_status thud_sweep_same_advance(struct thud_sweep_group *group, long budget, bool *done,
                                         struct thud_error *err)
{
    struct thud_sweep_same *same = group->same;
    enum thud_status status = THUD_OK;
    *done = !same || same->kept;
    if (*done)
        return THUD_OK;
    struct thud_scene *scenes = malloc(2 * sizeof *scenes);
    if (!scenes)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    for (; budget > 0 && same->next < same->points && status == THUD_OK; budget--)
        status = add_keys(same, group->plan, group->index * same->points + same->next, scenes, err);
    free(scenes);
    if (status == THUD_OK && same->next == same->points) {
        const struct thud_model *model = group->baseline[THUD_SWEEP_LINKED][0].model;
        int nvariants = group->plan->sensitivity > 0 ? THUD_SWEEP_VARIANTS : 1;
        *done = true;
        status = match(same, size_of(nvariants, thud_sweep_floor_count(model), model->npairs), err);
    }
    return status;
}

void thud_sweep_same_free(struct thud_sweep_same *same)
{
    if (!same)
        return;
    for (long i = 0; same->kept && i < same->nkept; i++)
        free(same->kept[i]);
    free(same->kept);
    free(same->key);
    free(same->maker);
    free(same->place);
    free(same);
}

static long run_of(const struct thud_sweep_group *group, long point, int k)
{
    return (point - group->index * group->same->points) * (group->plan->ncases + 1) + k;
}

long thud_sweep_maker(const struct thud_sweep_group *group, long point, int k)
{
    long maker = group->same ? group->same->maker[run_of(group, point, k)] : -1;
    return maker < 0 ? point : group->index * group->same->points + maker / (group->plan->ncases + 1);
}

bool thud_sweep_is_made_before(const struct thud_sweep_group *group, long point, int k)
{
    long run = group->same ? run_of(group, point, k) : 0, maker = group->same ? group->same->maker[run] : -1;
    return maker >= 0 && maker != run;
}

/* Between a case of a point and what is kept of it; `away`: into what is kept. */
static void move(struct kept *kept, const struct thud_sweep_point *point, int k, bool away)
{
    size_t floors = (size_t)point->nfloors * sizeof *kept->floor;
    size_t contacts = (size_t)point->ncontacts * sizeof(struct thud_sweep_contact);
    struct thud_sweep_contact *all = (void *)(kept->floor + point->nvariants * point->nfloors);
    for (int v = 0; v < point->nvariants; v++) {
        struct thud_sweep_floor *floor = thud_sweep_floors(point, v, k), *with = kept->floor + v * point->nfloors;
        struct thud_sweep_contact *contact = thud_sweep_contacts(point, v, k), *there = all + v * point->ncontacts;
        memcpy(away ? with : floor, away ? floor : with, floors);
        memcpy(away ? there : contact, away ? contact : there, contacts);
    }
}

static enum thud_status keep(struct thud_sweep_group *group, const struct thud_sweep_point *point, int k,
                             struct thud_error *err)
{
    struct kept **place = &group->same->kept[group->same->place[run_of(group, point->index, k)]];
    if (!*place && !(*place = malloc(size_of(point->nvariants, point->nfloors, point->ncontacts))))
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    (*place)->effort = point->effort[k];
    move(*place, point, k, true);
    return THUD_OK;
}

void thud_sweep_effort_taken(struct thud_sweep_effort *effort)
{
    if (!effort->made)
        return;
    effort->made = false;
    effort->reused = true;
    effort->left_out = 0;
    effort->steps = effort->events = 0;
    effort->shared_s = 0;
}

enum thud_status thud_sweep_group_settle(struct thud_sweep_group *group, struct thud_sweep_point *point,
                                         struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (int k = 0; group->same && k < point->ncases && status == THUD_OK; k++) {
        long run = run_of(group, point->index, k), maker = group->same->maker[run];
        if (maker == run)
            status = keep(group, point, k, err);
        if (!point->awaited[k])
            continue;
        bool reference = point->effort[k].reference;
        struct kept *kept = group->same->kept[group->same->place[maker]];
        point->effort[k] = kept->effort;
        point->effort[k].reference = reference;
        thud_sweep_effort_taken(&point->effort[k]);
        move(kept, point, k, false);
        point->awaited[k] = false;
    }
    return status;
}
