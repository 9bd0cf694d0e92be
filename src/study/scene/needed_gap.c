#include "study/scene/needed_gap.h"

#include <math.h>
#include <stdlib.h>

#include "core/run/baseline.h"
#include "study/scene/level.h"
#include "study/scene/solution.h"
#include "study/scene/spacing.h"

double thud_gap_damping(const struct thud_model *model, int s)
{
    const struct thud_model_structure *p = &model->structure[s];
    if (p->n == 0)
        return 0;
    return p->damping ? p->damping[0] / (2 * model->omega[p->first_mode]) : model->zeta[p->first_mode];
}

static double largest(const struct thud_result *result, int s, int floor)
{
    return floor > 0 ? result->structure[s].floor[floor - 1].displacement.value : 0;
}

double thud_gap_side(const struct thud_model *model, const struct thud_baseline_motion *baseline, int contact,
                     bool right)
{
    const struct thud_model_contact *p = &model->contact[contact];
    if (p->struck == (right ? 1 : -1))
        return thud_baseline_struck_displacement(baseline, contact);
    return largest(thud_baseline_result(baseline), right ? p->interface : p->interface - 1,
                   right ? p->right_floor : p->left_floor);
}

static double first_period(const struct thud_result *result, int s)
{
    return result->structure[s].floors > 0 ? result->structure[s].period_s[0] : INFINITY;
}

/* Whether every floor of either building, up to the top of the lower one, has one of the other at its elevation (within
 * 1 cm). What has no elevation stands wherever its neighbour does; a wall has no floors. */
static bool same_elevations(const struct thud_scene *scene, int interface)
{
    const struct thud_structure *side[2] = {&scene->structure[interface - 1], &scene->structure[interface]};
    double top = INFINITY;
    for (int i = 0; i < 2; i++) {
        if (side[i]->kind == THUD_WALL)
            return false;
        double z = thud_structure_elevation(side[i], thud_structure_floors(side[i]) - 1);
        if (isnan(z))
            return true;
        top = fmin(top, z);
    }
    for (int i = 0; i < 2; i++)
        for (int f = 0; f < thud_structure_floors(side[i]); f++) {
            const double z = thud_structure_elevation(side[i], f);
            bool met = z > top + 0.01;
            for (int g = 0; g < thud_structure_floors(side[1 - i]); g++)
                met = met || fabs(thud_structure_elevation(side[1 - i], g) - z) <= 0.01 + 1e-12;
            if (!met)
                return false;
        }
    return true;
}

void thud_gap_aligned(const struct thud_scene *scene, bool aligned[THUD_STRUCTURES_MAX])
{
    for (int i = 1; i < scene->nstructures; i++)
        aligned[i - 1] = same_elevations(scene, i);
}

static bool has_yielded(const struct thud_result *result, int s)
{
    const struct thud_structure_result *p = &result->structure[s];
    for (int i = 0; p->storey && i < p->floors; i++)
        if (p->storey[i].yields && p->storey[i].ductility > 1)
            return true;
    return false;
}

void thud_gap_levels(const bool *aligned, const struct thud_model *alone, const struct thud_model *model,
                     const struct thud_baseline_motion *baseline, struct thud_gap_level *level)
{
    /* part of two displacements that their difference is right to: sides that move alike are apart by 4e-14 of them */
    static const double rounding = 1e-12;
    const struct thud_result *result = thud_baseline_result(baseline);
    for (int c = 0; c < model->npairs; c++) {
        const struct thud_model_contact *p = &model->contact[c];
        int left = p->interface - 1, right = p->interface;
        const double apart_m = thud_baseline_relative_displacement(baseline, c);
        level[c] = (struct thud_gap_level){
            .interface = p->interface,
            .left_floor = p->left_floor,
            .right_floor = p->right_floor,
            .struck = p->struck,
            .aligned = aligned[p->interface - 1],
            .left_m = thud_gap_side(model, baseline, c, false),
            .right_m = thud_gap_side(model, baseline, c, true),
            .relative_displacement_m = apart_m,
            .correlation = has_yielded(result, left) || has_yielded(result, right)
                               ? NAN
                               : thud_spacing_correlation(first_period(result, left), thud_gap_damping(alone, left),
                                                          first_period(result, right), thud_gap_damping(alone, right)),
            .height_m = NAN,
            .lower_m = NAN};
        if (apart_m <= rounding * (level[c].left_m + level[c].right_m)) {
            level[c].relative_displacement_m = 0;
            if (level[c].correlation == 0 && apart_m < level[c].left_m) /* free bodies, which have no periods */
                level[c].correlation = 1;
        }
        thud_gap_code_init(&level[c].code);
    }
}

/* Of a floor (from 1) above the ground of its own structure; NaN: a wall's, or that of a body without elevation. */
static double height_above_ground(const struct thud_structure *p, int floor)
{
    if (floor == 0 || p->kind == THUD_WALL)
        return NAN;
    return thud_structure_elevation(p, floor - 1) - (thud_kind_is_building(p->kind) ? p->base_m : 0);
}

static void set_heights(const struct thud_scene *scene, struct thud_needed_gap *gap)
{
    for (int i = 0; i < gap->nlevels; i++) {
        struct thud_gap_level *l = &gap->level[i];
        const struct thud_structure *left = &scene->structure[l->interface - 1], *right = left + 1;
        /* of two floors the higher one above its ground; of struck columns the slab that strikes them */
        l->height_m = l->struck == 0
                          ? fmax(height_above_ground(left, l->left_floor), height_above_ground(right, l->right_floor))
                      : thud_slab_is_left(l->left_floor, l->struck) ? height_above_ground(left, l->left_floor)
                                                                    : height_above_ground(right, l->right_floor);
        l->lower_m = fmin(height_above_ground(left, thud_structure_floors(left)),
                          height_above_ground(right, thud_structure_floors(right)));
    }
}

static double largest_ductility(const struct thud_result *result)
{
    double most = 0;
    for (int s = 0; s < result->nstructures; s++)
        for (int f = 0; result->structure[s].storey && f < result->structure[s].floors; f++)
            if (result->structure[s].storey[f].yields)
                most = fmax(most, result->structure[s].storey[f].ductility);
    return most;
}

static struct thud_needed_gap *read_gap(const struct thud_scene *scene, const struct thud_model *alone,
                                        const struct thud_model *model, const struct thud_baseline_motion *baseline)
{
    const struct thud_result *result = thud_baseline_result(baseline);
    const int nlevels = model->npairs;
    struct thud_needed_gap *gap =
        malloc(sizeof *gap + (size_t)nlevels * sizeof *gap->level + (size_t)result->ncolumns * sizeof *gap->shear_n);
    bool aligned[THUD_STRUCTURES_MAX];
    if (!gap)
        return NULL;
    gap->nlevels = nlevels;
    gap->ncolumns = result->ncolumns;
    gap->shear_n = (double *)(void *)(gap->level + nlevels);
    for (int i = 0; i < result->ncolumns; i++)
        gap->shear_n[i] = fmax(result->column[i].peak[THUD_COLUMN_SHEAR_LOWER].value,
                               result->column[i].peak[THUD_COLUMN_SHEAR_UPPER].value);
    gap->collapse = result->collapse;
    gap->ductility = largest_ductility(result);
    thud_gap_aligned(scene, aligned);
    thud_gap_levels(aligned, alone, model, baseline, gap->level);
    set_heights(scene, gap);
    return gap;
}

/* Of an interface (from 1) open and the others as they are; 0: all are open. */
static enum thud_status run_gap(const struct thud_scene *scene, int open, const struct thud_record *record,
                                struct thud_needed_gap **out, struct thud_error *err)
{
    struct thud_run_options options;
    struct thud_model *model = NULL, *unlinked = NULL;
    struct thud_baseline_motion *baseline = NULL;
    struct thud_scene *bare = malloc(sizeof *bare);
    bool done = false;
    *out = NULL;
    if (!bare)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    thud_scene_copy(bare, scene);
    for (int i = 0; i + 1 < bare->nstructures; i++)
        if (open == 0 || open == i + 1)
            thud_interface_case(&bare->interface[i], THUD_CASE_FREE);
    enum thud_status status = thud_scene_check(bare, err);
    if (status == THUD_OK)
        status = thud_scene_assemble(bare, &model, err);
    if (status == THUD_OK)
        status = thud_scene_options(bare, &options, err);
    const bool linked = bare->nlinks > 0;
    bare->nlinks = 0;
    if (status == THUD_OK && linked)
        status = thud_scene_assemble(bare, &unlinked, err);
    free(bare);
    if (status == THUD_OK)
        status = thud_baseline_create(model, open, record, &options, &baseline, err);
    while (status == THUD_OK && !done)
        status = thud_baseline_advance(baseline, 1L << 20, &done, err);
    if (status == THUD_OK && !(*out = read_gap(scene, linked ? unlinked : model, model, baseline)))
        status = thud_error_set(err, THUD_MEMORY, "out of memory");
    thud_baseline_free(baseline);
    thud_model_free(unlinked);
    thud_model_free(model);
    return status;
}

enum thud_status thud_needed_gap_run(const struct thud_scene *scene, const struct thud_record *record,
                                     struct thud_needed_gap **out, struct thud_error *err)
{
    return run_gap(scene, 0, record, out, err);
}

enum thud_status thud_needed_gap_in_row(const struct thud_scene *scene, int interface, const struct thud_record *record,
                                        double *need_m, struct thud_error *err)
{
    struct thud_needed_gap *gap;
    enum thud_status status = run_gap(scene, interface, record, &gap, err);
    if (status == THUD_OK)
        *need_m = gap->collapse.happened ? NAN : thud_needed_gap_widest(gap, interface, THUD_GAP_EXACT, NULL);
    free(gap);
    return status;
}

double thud_gap_widest(const struct thud_gap_level *of, int n, int interface, int rule, int *level)
{
    double most = -1;
    for (int i = 0; i < n; i++) {
        double x = thud_gap_value(&of[i], rule);
        if ((interface != 0 && of[i].interface != interface) || !thud_gap_is_wider(x, most))
            continue;
        most = x;
        if (level)
            *level = i;
    }
    return most;
}

double thud_needed_gap_widest(const struct thud_needed_gap *gap, int interface, int rule, int *level)
{
    return thud_gap_widest(gap->level, gap->nlevels, interface, rule, level);
}

double thud_needed_gap_with_bumpers(const struct thud_needed_gap *gap, const struct thud_scene *scene, int interface)
{
    const struct thud_interface *at = &scene->interface[interface - 1];
    double most = -1;
    for (int i = 0; i < gap->nlevels; i++) {
        const struct thud_level_values here = thud_interface_level(at, thud_needed_gap_level(gap->level, i));
        if (gap->level[i].interface == interface)
            most = fmax(most, gap->level[i].relative_displacement_m + here.gap_m - thud_level_clearance(&here));
    }
    return most;
}

int thud_needed_gap_level(const struct thud_gap_level *level, int i)
{
    int first = i;
    while (first > 0 && level[first - 1].interface == level[i].interface)
        first--;
    return i - first;
}

bool thud_gap_falls_short(double asked_m, double needed_m)
{
    static const double rounding = 1e-9; /* the two come by different sums */
    return asked_m < needed_m * (1 - rounding);
}
