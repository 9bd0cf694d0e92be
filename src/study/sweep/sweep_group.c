/* The motion without pounding that a set of points shares. */
#include <stdlib.h>
#include <string.h>

#include "ground/spectrum.h"
#include "study/sweep/sweep_private.h"

enum thud_status thud_sweep_motion_factor(const struct thud_sweep_plan *plan, const struct thud_scene *scene,
                                          const struct thud_record *record, double *out, struct thud_error *err)
{
    const struct thud_record_choice *now = &scene->record, *loaded = &plan->scene.record;
    double factor = 1;
    for (int i = 0; i < plan->nouter; i++) {
        const char *key = plan->axis[i].key;
        if (strcmp(key, "record.peak") == 0)
            factor *= now->peak_mps2 / thud_record_peak(record);
        else if (strcmp(key, "record.sa") == 0) {
            struct thud_record_choice choice = *now;
            enum thud_status status = thud_record_choice_resolve(scene, &choice, err);
            if (status != THUD_OK)
                return status;
            factor *= choice.sa_mps2 / thud_record_sa(record, choice.period_s);
        } else if (strcmp(key, "record.factor") == 0)
            factor *= now->factor / loaded->factor;
        else if (strcmp(key, "record.sign") == 0)
            factor *= now->sign * loaded->sign;
    }
    *out = factor;
    return THUD_OK;
}

/* `scale`: over what the plan asks for. */
static enum thud_status take_record(const struct thud_sweep_plan *plan, struct thud_sweep_baseline *baseline,
                                    const struct thud_scene *scene, int which, double scale, struct thud_error *err)
{
    baseline->record = NULL;
    if (plan->nrecords == 0)
        return THUD_OK;
    const struct thud_record *record = baseline->record = plan->record[which];
    if (!record)
        return THUD_OK;
    double factor;
    enum thud_status status = thud_sweep_motion_factor(plan, scene, record, &factor, err);
    factor *= scale;
    if (status != THUD_OK || factor == 1)
        return status;
    status = thud_record_scaled(record, factor, &baseline->scaled, err);
    baseline->record = baseline->scaled;
    return status;
}

enum thud_status thud_sweep_model(const struct thud_scene *cased, struct thud_model **model,
                                  struct thud_run_options *options, struct thud_error *err)
{
    enum thud_status status = thud_scene_assemble(cased, model, err);
    if (status == THUD_OK)
        status = thud_scene_options(cased, options, err);
    if (status != THUD_OK) {
        thud_model_free(*model);
        *model = NULL;
    }
    return status;
}

enum thud_case thud_sweep_free_case(const struct thud_sweep_plan *plan)
{
    for (int i = 0; i < plan->ncases; i++)
        if (!thud_case_has_links(plan->cases[i]))
            return THUD_CASE_NONE;
    return THUD_CASE_AS_WRITTEN;
}

enum thud_case thud_sweep_need_case(const enum thud_case *cases, int ncases)
{
    for (int i = 0; i < ncases; i++)
        if (thud_case_has_links(cases[i]))
            return THUD_CASE_AS_WRITTEN;
    return THUD_CASE_NONE;
}

/* Baseline g of a linkage from the first point's scene; *cased: scratch. */
static enum thud_status build_baseline(struct thud_sweep_group *group, int linkage, int g, int record,
                                       const struct thud_scene *scene, struct thud_scene *cased, struct thud_error *err)
{
    struct thud_sweep_baseline *baseline = &group->baseline[linkage][g];
    const enum thud_case which = linkage == THUD_SWEEP_LINKED ? THUD_CASE_AS_WRITTEN : THUD_CASE_NONE;
    struct thud_run_options options;
    enum thud_change change;
    double factor;
    int variant = g > 0 ? g + 2 : 0;
    bool changed = thud_sweep_variant(group->plan, variant, &change, &factor);
    double scale = changed && change == THUD_CHANGE_SCALE ? factor : 1;
    enum thud_status status = take_record(group->plan, baseline, scene, record, scale, err);
    if (status == THUD_OK)
        status = thud_sweep_case(group->plan, scene, which, variant, false, cased, err);
    if (status == THUD_OK) {
        thud_scene_case(cased, THUD_CASE_FREE, cased, NULL);
        status = thud_sweep_model(cased, &baseline->model, &options, err);
        if (status == THUD_INPUT)
            (void)thud_scene_check(cased, err); /* which says the key */
    }
    if (status == THUD_OK)
        status = thud_baseline_create(baseline->model, 0, baseline->record, &options, &baseline->baseline, err);
    return status;
}

static enum thud_status build(struct thud_sweep_group *group, struct thud_scene *scene, struct thud_scene *cased,
                              struct thud_error *err)
{
    int at[THUD_VARY_MAX];
    long point = group->index * thud_sweep_points_per_group(group->plan);
    int record = thud_sweep_place(group->plan, point, at);
    enum thud_status status = thud_sweep_scene(group->plan, point, scene, err);
    if (status == THUD_OK)
        thud_gap_aligned(scene, group->aligned);
    group->nlinkages = scene->nlinks > 0 ? THUD_SWEEP_LINKAGES : 1;
    for (int l = 0; l < group->nlinkages; l++)
        for (int g = 0; g < group->nbaselines && status == THUD_OK; g++)
            status = build_baseline(group, l, g, record, scene, cased, err);
    if (status == THUD_OK &&
        !(group->level = calloc((size_t)(group->nlinkages * group->baseline[THUD_SWEEP_LINKED][0].model->npairs) + 1,
                                sizeof *group->level)))
        status = thud_error_set(err, THUD_MEMORY, "out of memory");
    return status;
}

enum thud_status thud_sweep_group_create(const struct thud_sweep_plan *plan, long index, struct thud_sweep_group **out,
                                         struct thud_error *err)
{
    *out = NULL;
    struct thud_sweep_group *group = calloc(1, sizeof *group);
    struct thud_scene *scenes = malloc(2 * sizeof *scenes);
    enum thud_status status = THUD_MEMORY;
    if (group && scenes) {
        group->plan = plan;
        group->index = index;
        group->nbaselines = plan->sensitivity > 0 ? THUD_SWEEP_BASELINES : 1;
        status = build(group, scenes, scenes + 1, err);
        if (status == THUD_OK)
            status = thud_sweep_same_create(plan, &group->same, err);
    } else {
        thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    free(scenes);
    if (status == THUD_OK)
        *out = group;
    else
        thud_sweep_group_free(group);
    return status;
}

enum thud_status thud_sweep_group_advance(struct thud_sweep_group *group, long budget, bool *done,
                                          struct thud_error *err)
{
    bool whole = false;
    *done = false;
    const int n = group->nbaselines, all = group->nlinkages * n;
    if (group->ndone < all) {
        struct thud_sweep_baseline *next = &group->baseline[group->ndone / n][group->ndone % n];
        enum thud_status status = thud_baseline_advance(next->baseline, budget, &whole, err);
        if (status != THUD_OK)
            return status;
        group->ndone += whole;
    }
    if (group->ndone < all)
        return THUD_OK;
    enum thud_status status = thud_sweep_same_advance(group, budget, done, err);
    for (int l = 0; l < group->nlinkages && status == THUD_OK && *done; l++) {
        const struct thud_sweep_baseline *nominal = &group->baseline[l][0];
        thud_gap_levels(group->aligned, group->baseline[group->nlinkages - 1][0].model, nominal->model,
                        nominal->baseline, group->level + l * nominal->model->npairs);
    }
    return status;
}

void thud_sweep_group_free(struct thud_sweep_group *group)
{
    if (!group)
        return;
    for (int i = 0; i < group->nlinkages * group->nbaselines; i++) {
        struct thud_sweep_baseline *b = &group->baseline[i / group->nbaselines][i % group->nbaselines];
        thud_baseline_free(b->baseline);
        thud_model_free(b->model);
        thud_record_free(b->scaled);
    }
    thud_sweep_same_free(group->same);
    free(group->level);
    free(group);
}
