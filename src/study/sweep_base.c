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

/* `scale`: over what the plan asks for. */
static enum thud_status take_record(const struct thud_sweep_plan *plan, struct thud_sweep_ground *ground,
                                    const struct thud_scene *scene, int which, double scale, struct thud_error *err)
{
    ground->record = NULL;
    if (plan->nrecords == 0)
        return THUD_OK;
    const struct thud_record *record = ground->record = plan->record[which];
    if (!record)
        return THUD_OK;
    double factor = scale * record_factor(plan, scene, record);
    if (factor == 1)
        return THUD_OK;
    enum thud_status status = thud_record_create(record->a_mps2, record->samples, record->dt_s, &ground->scaled, err);
    if (status == THUD_OK) {
        thud_record_scale(ground->scaled, factor);
        ground->record = ground->scaled;
    }
    return status;
}

/* Ground g from the first point's scene; *none: scratch. */
static enum thud_status build_ground(struct thud_sweep_base *base, int g, int record, const struct thud_scene *scene,
                                     struct thud_scene *none, struct thud_error *err)
{
    struct thud_sweep_ground *ground = &base->ground[g];
    struct thud_run_options options;
    enum thud_change change;
    double factor;
    bool changed = thud_sweep_variant(base->plan, g > 0 ? g + 2 : 0, &change, &factor);
    double scale = changed && change == THUD_CHANGE_SCALE ? factor : 1;
    enum thud_status status = take_record(base->plan, ground, scene, record, scale, err);
    if (status == THUD_OK)
        status =
            thud_scene_case(scene, thud_sweep_has_bumper(scene) ? THUD_CASE_NONE : THUD_CASE_AS_WRITTEN, none, err);
    if (status == THUD_OK) {
        if (changed)
            thud_change_scene(none, change, factor);
        status = thud_scene_assemble(none, &ground->model, err);
    }
    if (status == THUD_OK)
        status = thud_scene_options(none, &options, err);
    if (status == THUD_OK) {
        options.no_ledger = true;
        status = thud_trunk_create(ground->model, ground->record, &options, &ground->trunk, err);
    }
    return status;
}

static enum thud_status build(struct thud_sweep_base *base, struct thud_scene *scene, struct thud_scene *none,
                              struct thud_error *err)
{
    int at[THUD_VARY_MAX];
    long point = base->index * thud_sweep_points_per_base(base->plan);
    int record = thud_sweep_place(base->plan, point, at);
    enum thud_status status = thud_sweep_scene(base->plan, point, scene, err);
    for (int g = 0; g < base->ngrounds && status == THUD_OK; g++)
        status = build_ground(base, g, record, scene, none, err);
    if (status == THUD_OK && !(base->level = calloc((size_t)base->ground[0].model->ncontacts + 1, sizeof *base->level)))
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
        base->ngrounds = plan->sensitivity > 0 ? THUD_SWEEP_GROUNDS : 1;
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
    return p->damping ? p->damping[0] / (2 * model->omega[p->first_mode]) : model->zeta[p->first_mode];
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
    const struct thud_trunk *trunk = base->ground[0].trunk;
    const struct thud_model *model = base->ground[0].model;
    const struct thud_result *result = thud_trunk_result(trunk);
    for (int c = 0; c < model->ncontacts; c++) {
        const struct thud_model_contact *p = &model->contact[c];
        int left = p->interface - 1, right = p->interface;
        base->level[c] = (struct thud_sweep_level){
            .interface = p->interface,
            .left_floor = p->left_floor,
            .right_floor = p->right_floor,
            .left_m = largest(result, left, p->left_floor),
            .right_m = largest(result, right, p->right_floor),
            .closing_m = thud_trunk_closing(trunk, c),
            .correlation = thud_spacing_correlation(first_period(result, left), first_damping(model, left),
                                                    first_period(result, right), first_damping(model, right))};
    }
}

enum thud_status thud_sweep_base_advance(struct thud_sweep_base *base, long budget, bool *done, struct thud_error *err)
{
    bool whole = false;
    *done = false;
    if (base->ndone < base->ngrounds) {
        enum thud_status status = thud_trunk_advance(base->ground[base->ndone].trunk, budget, &whole, err);
        if (status != THUD_OK)
            return status;
        base->ndone += whole;
    }
    *done = base->ndone == base->ngrounds;
    if (*done)
        fill_levels(base);
    return THUD_OK;
}

void thud_sweep_base_free(struct thud_sweep_base *base)
{
    if (!base)
        return;
    for (int g = 0; g < base->ngrounds; g++) {
        thud_trunk_free(base->ground[g].trunk);
        thud_model_free(base->ground[g].model);
        thud_record_free(base->ground[g].scaled);
    }
    free(base->level);
    free(base);
}
