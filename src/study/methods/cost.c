#include "study/methods/cost.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Sizes along the axes; of impacts the clearances, wide ones first. */
static const double storeys[] = {1, 2, 3, 5, 7, 10, 15, 20, 30, 50, 70, 100, 150, 200};
static const double buildings[] = {2, 3, 4, 5, 6, 8, 10, 12, 14, 16, 18, 20};
static const double repeats[] = {1, 2, 4, 8, 16, 32};
static const double clearances_m[] = {1,    0.2,  0.15, 0.1,   0.08,  0.06,  0.05, 0.04,
                                      0.03, 0.02, 0.01, 0.005, 0.002, 0.001, 0};
#define SIZES(list) (int)(sizeof(list) / sizeof *(list)), list
/* So that two buildings of the same number of storeys do not sway as one. */
static const double right_stiffness = 0.7;

static const struct thud_cost_axis_info axes[THUD_COST_AXES] = {
    {"storeys", "Storeys of each of two buildings", "",
     "few storeys: each sample moves each mode once, the first power; many: there is a contact for each floor, and "
     "its\n"
     "indentation is a sum over both buildings' modes, so that looking at all of them costs the square; setting up "
     "finds\n"
     "the modes, which costs the cube in the end"},
    {"buildings", "Buildings in a row", "",
     "each building adds its modes and its impacts, and at every impact of one pair all the others are moved too: the\n"
     "number of impacts times the size of the row, up to the square; coupled rubber contacts cost more still"},
    {"duration", "Length of the ground motion", "s",
     "every second and every impact costs what those before did, for nothing is kept that grows with time; below the\n"
     "first power where impacts grow rare (residual: keep, where concrete gives way for good)"},
    {"impacts", "Impacts", "",
     "contact-free response costs the same whatever the gap, and every impact adds its own solution and the search for "
     "its ends"}};

struct thud_cost {
    enum thud_cost_axis axis;
    struct thud_scene scene; /* as given */
    const struct thud_record *record;
    struct thud_record *longest;     /* duration only: the record as often as it is ever repeated */
    struct thud_record cut;          /* its beginning, for the point in hand */
    struct thud_run_options options; /* common to all */
    struct thud_scene work;          /* the point's */
    int npoints;
    struct thud_cost_point point[32];
};

const struct thud_cost_axis_info *thud_cost_axis_info(enum thud_cost_axis axis)
{
    return &axes[axis];
}

enum thud_status thud_cost_axis_find(const char *name, enum thud_cost_axis *out, struct thud_error *err)
{
    for (int i = 0; i < THUD_COST_AXES; i++)
        if (strcmp(axes[i].name, name) == 0) {
            *out = (enum thud_cost_axis)i;
            return THUD_OK;
        }
    return thud_error_refuse(err, THUD_USAGE, NULL, "storeys, buildings, duration or impacts",
                             "--cost: there is no \"%.40s\"", name);
}

/* The first two structures with storeys stand at the front. */
static bool pick_shear(struct thud_scene *scene)
{
    int found = 0;
    for (int i = 0; i < scene->nstructures && found < 2; i++)
        if (scene->structure[i].kind == THUD_SHEAR)
            scene->structure[found++] = scene->structure[i];
    scene->nstructures = 2;
    return found == 2;
}

/* Every storey as the lowest, the roof as it was. */
static void set_storeys(struct thud_structure *s, int n)
{
    double roof_kg = s->mass_kg[s->storeys - 1];
    for (int which = 0; which < THUD_STRUCTURE_LISTS; which++)
        for (int i = 1; i < n; i++)
            thud_structure_list(s, which)[i] = thud_structure_list(s, which)[0];
    s->mass_kg[n - 1] = roof_kg;
    s->storeys = n;
}

static void grow_storeys(struct thud_scene *scene, int n)
{
    pick_shear(scene);
    for (int i = 0; i < 2; i++)
        set_storeys(&scene->structure[i], n);
    for (int i = 0; i < n; i++)
        scene->structure[1].stiffness_npm[i] *= right_stiffness;
}

static void grow_row(struct thud_scene *scene, const struct thud_scene *from, int n)
{
    for (int i = 0; i < n; i++)
        scene->structure[i] = from->structure[i % from->nstructures];
    for (int i = 0; i + 1 < n; i++)
        scene->interface[i] = from->interface[i % (from->nstructures - 1)];
    scene->nstructures = n;
}

static void narrow(struct thud_scene *scene, double clearance_m)
{
    for (int i = 0; i + 1 < scene->nstructures; i++)
        scene->interface[i].gap_m += clearance_m - thud_interface_clearance(&scene->interface[i]);
}

static void make_scene(struct thud_cost *cost, const struct thud_cost_point *p)
{
    cost->work = cost->scene;
    if (cost->axis == THUD_COST_STOREYS)
        grow_storeys(&cost->work, (int)p->size);
    else if (cost->axis == THUD_COST_BUILDINGS)
        grow_row(&cost->work, &cost->scene, (int)p->size);
    else if (cost->axis == THUD_COST_IMPACTS)
        narrow(&cost->work, p->clearance_m);
}

static void plan(struct thud_cost *cost, int n, const double *size)
{
    cost->npoints = n;
    for (int i = 0; i < n; i++) {
        struct thud_cost_point *p = &cost->point[i];
        p->size = size[i];
        if (cost->axis == THUD_COST_DURATION)
            p->size *= (double)cost->record->samples * cost->record->dt_s;
        if (cost->axis == THUD_COST_IMPACTS)
            *p = (struct thud_cost_point){.size = NAN, .clearance_m = size[i]};
        else
            p->clearance_m = thud_interface_clearance(&cost->scene.interface[0]);
    }
}

static enum thud_status repeat(struct thud_cost *cost, struct thud_error *err)
{
    int times = (int)repeats[sizeof repeats / sizeof *repeats - 1];
    size_t n = cost->record->samples;
    double *a = malloc((size_t)times * n * sizeof *a);
    if (!a)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    for (int i = 0; i < times; i++)
        memcpy(a + (size_t)i * n, cost->record->a_mps2, n * sizeof *a);
    enum thud_status status = thud_record_create(a, (size_t)times * n, cost->record->dt_s, &cost->longest, err);
    free(a);
    return status;
}

static enum thud_status prepare(struct thud_cost *cost, struct thud_error *err)
{
    switch (cost->axis) {
    case THUD_COST_STOREYS:
        cost->work = cost->scene;
        plan(cost, SIZES(storeys));
        if (!pick_shear(&cost->work))
            return thud_error_set(err, THUD_INPUT, "storeys can only be added to two shear buildings (kind: shear)");
        return THUD_OK;
    case THUD_COST_BUILDINGS:
        plan(cost, SIZES(buildings));
        return THUD_OK;
    case THUD_COST_DURATION:
        if (!cost->record || cost->record->samples == 0)
            return thud_error_set(err, THUD_INPUT, "a scene without a ground motion has none to make longer");
        plan(cost, SIZES(repeats));
        return repeat(cost, err);
    default:
        plan(cost, SIZES(clearances_m));
        return THUD_OK;
    }
}

enum thud_status thud_cost_create(const struct thud_scene *scene, const struct thud_record *record,
                                  enum thud_cost_axis axis, struct thud_cost **out, struct thud_error *err)
{
    struct thud_cost *cost = calloc(1, sizeof *cost);
    *out = NULL;
    if (!cost)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    cost->axis = axis;
    cost->scene = *scene;
    cost->record = record;
    enum thud_status status = thud_scene_options(scene, &cost->options, err);
    if (status == THUD_OK && scene->nstructures < 2)
        status = thud_error_set(err, THUD_INPUT, "there is one structure only and nothing to pound against");
    if (status == THUD_OK)
        status = prepare(cost, err);
    if (status != THUD_OK) {
        thud_cost_free(cost);
        return status;
    }
    *out = cost;
    return THUD_OK;
}

void thud_cost_free(struct thud_cost *cost)
{
    if (cost)
        thud_record_free(cost->longest);
    free(cost);
}

enum thud_cost_axis thud_cost_axis(const struct thud_cost *cost)
{
    return cost->axis;
}

int thud_cost_count(const struct thud_cost *cost)
{
    return cost->npoints;
}

struct thud_cost_point *thud_cost_point(struct thud_cost *cost, int i)
{
    return &cost->point[i];
}

enum thud_status thud_cost_setup(struct thud_cost *cost, int i, struct thud_model **out, struct thud_error *err)
{
    struct thud_cost_point *p = &cost->point[i];
    make_scene(cost, p);
    enum thud_status status = thud_scene_assemble(&cost->work, out, err);
    if (status != THUD_OK)
        return status;
    p->floors = (*out)->ndof;
    p->contacts = (*out)->ncontacts;
    return THUD_OK;
}

enum thud_status thud_cost_start(struct thud_cost *cost, int i, const struct thud_model *model, struct thud_run **out,
                                 struct thud_error *err)
{
    const struct thud_record *record = cost->record;
    if (cost->longest) {
        cost->cut = *cost->longest;
        cost->cut.samples = record->samples * (size_t)repeats[i];
        record = &cost->cut;
    }
    return thud_run_create(model, record, &cost->options, out, err);
}

void thud_cost_judge(struct thud_cost *cost, int i, const struct thud_run *run, enum thud_status status,
                     const struct thud_error *failure)
{
    struct thud_cost_point *p = &cost->point[i];
    const struct thud_result *r = thud_run_result(run);
    p->work = r->work;
    p->impacts = 0;
    for (int c = 0; c < r->ncontacts; c++)
        p->impacts += r->contact[c].impacts;
    if (cost->axis == THUD_COST_IMPACTS)
        p->size = p->impacts;
    p->state = status == THUD_OK ? THUD_COST_DONE : THUD_COST_FAILED;
    if (status != THUD_OK)
        snprintf(p->message, sizeof p->message, "%.180s", failure->what);
}

double thud_cost_value(const struct thud_cost_point *point, enum thud_cost_quantity quantity)
{
    switch (quantity) {
    case THUD_COST_TIME:
        return point->seconds;
    case THUD_COST_SETUP:
        return point->setup_s;
    case THUD_COST_STEPS:
        return (double)point->work.steps;
    default:
        return (double)point->work.force_evaluations;
    }
}

struct thud_cost_fit thud_cost_fit(const struct thud_cost *cost, enum thud_cost_quantity quantity)
{
    struct thud_cost_fit fit = {.power = cost->axis != THUD_COST_IMPACTS, .from = NAN};
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0, middle = 0;
    if (fit.power)
        middle = sqrt(cost->point[0].size * cost->point[cost->npoints - 1].size);
    for (int i = 0; i < cost->npoints; i++) {
        const struct thud_cost_point *p = &cost->point[i];
        double x = p->size, y = thud_cost_value(p, quantity);
        if (p->state != THUD_COST_DONE || x < middle || (fit.power && !(y > 0)))
            continue;
        fit.from = fmin(fit.from, x);
        fit.points++;
        if (fit.power) {
            x = log(x);
            y = log(y);
        }
        n++, sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    double spread = n * sxx - sx * sx;
    if (fit.points < 2 || !(spread > 0)) {
        fit.points = 0;
        return fit;
    }
    fit.b = (n * sxy - sx * sy) / spread;
    fit.a = (sy - fit.b * sx) / n;
    if (fit.power)
        fit.a = exp(fit.a);
    return fit;
}
