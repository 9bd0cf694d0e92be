/* The motion without pounding that a set of points shares. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "study/spacing.h"
#include "study/sweep_private.h"

bool thud_sweep_has_bumper(const struct thud_scene *scene)
{
    for (int i = 0; i + 1 < scene->nstructures; i++)
        if (scene->interface[i].has_bumper)
            return true;
    return false;
}

/* What the varied keys of the record ask for, over what was loaded. */
static double record_factor(const struct thud_sweep_plan *plan, const struct thud_scene *scene,
                            const struct thud_record *record)
{
    const struct thud_record_choice *now = &scene->record, *loaded = &plan->scene.record;
    double factor = 1;
    for (int i = 0; i < plan->nouter; i++) {
        const char *key = plan->axis[i].key;
        if (strcmp(key, "record.peak") == 0)
            factor *= now->peak_mps2 / thud_record_peak(record);
        else if (strcmp(key, "record.factor") == 0)
            factor *= now->factor / loaded->factor;
        else if (strcmp(key, "record.sign") == 0)
            factor *= now->sign * loaded->sign;
    }
    return factor;
}

static enum thud_status take_record(struct thud_sweep_base *base, const struct thud_scene *scene, int which,
                                    struct thud_error *err)
{
    const struct thud_sweep_plan *plan = base->plan;
    base->record = plan->nrecords > 0 ? plan->record[which] : NULL;
    double factor = base->record ? record_factor(plan, scene, base->record) : 1;
    if (factor == 1)
        return THUD_OK;
    enum thud_status status =
        thud_record_create(base->record->a_mps2, base->record->samples, base->record->dt_s, &base->scaled, err);
    if (status == THUD_OK) {
        thud_record_scale(base->scaled, factor);
        base->record = base->scaled;
    }
    return status;
}

static enum thud_status build(struct thud_sweep_base *base, struct thud_scene *scene, struct thud_scene *none,
                              struct thud_error *err)
{
    int at[THUD_VARY_MAX];
    long point = base->index * thud_sweep_points_per_base(base->plan);
    int record = thud_sweep_place(base->plan, point, at);
    struct thud_run_options options;
    enum thud_status status = thud_sweep_scene(base->plan, point, scene, err);
    if (status == THUD_OK)
        status = take_record(base, scene, record, err);
    if (status == THUD_OK)
        status =
            thud_scene_case(scene, thud_sweep_has_bumper(scene) ? THUD_CASE_NONE : THUD_CASE_AS_WRITTEN, none, err);
    if (status == THUD_OK)
        status = thud_scene_assemble(none, &base->model, err);
    if (status == THUD_OK)
        status = thud_scene_options(none, &options, err);
    if (status == THUD_OK) {
        options.no_ledger = true;
        status = thud_trunk_create(base->model, base->record, &options, &base->trunk, err);
    }
    if (status == THUD_OK && !(base->level = calloc((size_t)base->model->ncontacts + 1, sizeof *base->level)))
        status = thud_error_set(err, THUD_MEMORY, "out of memory");
    return status;
}

enum thud_status thud_sweep_base_create(const struct thud_sweep_plan *plan, long index, struct thud_sweep_base **out,
                                        struct thud_error *err)
{
    *out = NULL;
    struct thud_sweep_base *base = calloc(1, sizeof *base);
    struct thud_scene *scenes = malloc(2 * sizeof *scenes);
    enum thud_status status = THUD_MEMORY;
    if (base && scenes) {
        base->plan = plan;
        base->index = index;
        status = build(base, scenes, scenes + 1, err);
    } else {
        thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    free(scenes);
    if (status == THUD_OK)
        *out = base;
    else
        thud_sweep_base_free(base);
    return status;
}

/* Damping ratio of a structure's first mode. */
static double first_damping(const struct thud_model *model, int s)
{
    const struct thud_model_structure *p = &model->structure[s];
    if (p->n == 0)
        return 0;
    return p->damping ? p->damping[0] / (2 * model->omega[p->first]) : model->zeta[p->first];
}

static double largest(const struct thud_result *result, int s, int floor)
{
    return floor > 0 ? result->structure[s].floor[floor - 1].displacement.value : 0;
}

static double first_period(const struct thud_result *result, int s)
{
    return result->structure[s].floors > 0 ? result->structure[s].period_s[0] : INFINITY;
}

static void fill_levels(struct thud_sweep_base *base)
{
    const struct thud_result *result = thud_trunk_result(base->trunk);
    for (int c = 0; c < base->model->ncontacts; c++) {
        const struct thud_model_contact *p = &base->model->contact[c];
        int left = p->interface - 1, right = p->interface;
        base->level[c] = (struct thud_sweep_level){
            .interface = p->interface,
            .left_floor = p->left_floor,
            .right_floor = p->right_floor,
            .left_m = largest(result, left, p->left_floor),
            .right_m = largest(result, right, p->right_floor),
            .closing_m = thud_trunk_closing(base->trunk, c),
            .correlation = thud_spacing_correlation(first_period(result, left), first_damping(base->model, left),
                                                    first_period(result, right), first_damping(base->model, right))};
    }
}

enum thud_status thud_sweep_base_advance(struct thud_sweep_base *base, long budget, bool *done, struct thud_error *err)
{
    enum thud_status status = thud_trunk_advance(base->trunk, budget, done, err);
    if (status == THUD_OK && *done)
        fill_levels(base);
    return status;
}

void thud_sweep_base_free(struct thud_sweep_base *base)
{
    if (!base)
        return;
    thud_trunk_free(base->trunk);
    thud_model_free(base->model);
    thud_record_free(base->scaled);
    free(base->level);
    free(base);
}
