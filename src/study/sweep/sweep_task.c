/* One point of a study: its runs one after the other, in slices. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "study/scene/level.h"
#include "study/scene/solution.h"
#include "study/sweep/remark.h"
#include "study/sweep/sweep_private.h"

struct thud_sweep_task {
    const struct thud_sweep_plan *plan;
    const struct thud_sweep_group *group;
    struct thud_scene *scene, *cased;
    struct thud_sweep_point *point;
    int variant, which;              /* variant and case at work */
    struct thud_sweep_effort effort; /* of the run at work */
    struct thud_model *model;
    struct thud_run *run;
};

struct thud_sweep_point *thud_sweep_point_create(int ncases, int nfloors, int ncontacts, int nlinkages, int nvariants)
{
    struct thud_sweep_point *point;
    size_t floors = (size_t)nvariants * (size_t)(ncases + 1) * (size_t)nfloors;
    size_t contacts = (size_t)nvariants * (size_t)ncases * (size_t)ncontacts;
    size_t head = (sizeof *point + 15) / 16 * 16;
    char *block = calloc(1, head + floors * sizeof *point->floor + contacts * sizeof *point->contact +
                                (size_t)nlinkages * (size_t)ncontacts * sizeof *point->level);
    if (!block)
        return NULL;
    point = (void *)block;
    point->ncases = ncases;
    point->nfloors = nfloors;
    point->ncontacts = ncontacts;
    point->nlinkages = nlinkages;
    point->nvariants = nvariants;
    point->floor = (void *)(block + head);
    point->contact = (void *)(point->floor + floors);
    point->level = (void *)(point->contact + contacts);
    return point;
}

/* Floors' peaks of a result of the scene. */
static void take_floors(struct thud_sweep_floor *to, const struct thud_scene *scene, const struct thud_result *result)
{
    for (int s = 0; s < result->nstructures; s++)
        for (int i = 0; i < result->structure[s].floors; i++) {
            const struct thud_floor_result *f = &result->structure[s].floor[i];
            const struct thud_storey_result *storey = result->structure[s].storey;
            const struct thud_structure *of = &scene->structure[s];
            bool yields = storey && storey[i].yields;
            *to++ = (struct thud_sweep_floor){
                thud_floor_acceleration(result, s, i),
                f->drift.value,
                f->displacement.value,
                yields ? storey[i].ductility : NAN,
                yields ? storey[i].permanent_m : NAN,
                yields ? (double)storey[i].excursions : (double)NAN,
                yields ? storey[i].hysteretic_j : NAN,
                thud_stability_coefficient(of, &result->structure[s], thud_structure_storey(of, i) - 1)};
        }
}

/* The floors and contacts of a variant's case k from its result. */
static void point_fill(struct thud_sweep_point *point, int variant, int k, const struct thud_scene *scene,
                       const struct thud_model *model, const struct thud_result *result)
{
    struct thud_sweep_contact *to = thud_sweep_contacts(point, variant, k);
    take_floors(thud_sweep_floors(point, variant, k), scene, result);
    for (int c = 0; c < point->ncontacts; c++) {
        const struct thud_contact_result *r = &result->contact[c];
        const struct thud_column_result *column = r->column >= 0 ? &result->column[r->column] : NULL;
        to[c] = (struct thud_sweep_contact){r->impacts,
                                            thud_peak_force(r),
                                            thud_peak_depth(r),
                                            r->impulse_ns,
                                            r->contact_time_s,
                                            r->residual_m,
                                            model->contact[c].clearance_m + r->residual_m,
                                            column ? column->peak[THUD_COLUMN_SHEAR_LOWER].value : NAN,
                                            column ? column->peak[THUD_COLUMN_SHEAR_UPPER].value : NAN,
                                            column ? column->ratio : NAN,
                                            column ? column->peak[THUD_COLUMN_MOMENT_LOWER].value : NAN,
                                            column ? column->peak[THUD_COLUMN_MOMENT_UPPER].value : NAN};
    }
}

enum thud_status thud_sweep_task_create(const struct thud_sweep_plan *plan, const struct thud_sweep_group *group,
                                        long index, struct thud_sweep_task **out, struct thud_error *err)
{
    *out = NULL;
    const struct thud_model *model = group->baseline[THUD_SWEEP_LINKED][0].model;
    struct thud_sweep_task *task = calloc(1, sizeof *task);
    struct thud_scene *scenes = malloc(2 * sizeof *scenes);
    enum thud_status status = THUD_MEMORY;
    if (task && scenes) {
        task->plan = plan;
        task->group = group;
        task->scene = scenes;
        task->cased = scenes + 1;
        status = thud_sweep_scene(plan, index, task->scene, err);
    }
    if (status == THUD_OK) {
        enum thud_case which[THUD_SWEEP_CASES_MAX + 1];
        int ncases = thud_sweep_point_cases(plan, task->scene, which);
        struct thud_sweep_point *point = task->point =
            thud_sweep_point_create(ncases, thud_sweep_floor_count(model), model->npairs, group->nlinkages,
                                    plan->sensitivity > 0 ? THUD_SWEEP_VARIANTS : 1);
        status = point ? THUD_OK : THUD_MEMORY;
        for (int i = 0; point && i < ncases; i++) {
            point->which[i] = which[i];
            point->effort[i].reference = i >= plan->ncases;
        }
    }
    if (status != THUD_OK) {
        if (!task || !task->scene)
            free(scenes);
        thud_sweep_task_free(task);
        return status == THUD_MEMORY ? thud_error_set(err, status, "out of memory") : status;
    }
    struct thud_sweep_point *point = task->point;
    point->index = index;
    point->gap_m = task->scene->nstructures > 1 ? task->scene->interface[0].gap_m : NAN;
    point->nstructures = model->nstructures;
    for (int s = 0; s < point->nstructures; s++) {
        point->floors[s] = model->structure[s].n;
        point->first_storey[s] = thud_structure_first_storey(&task->scene->structure[s]);
    }
    for (int v = 0; v < point->nvariants; v++)
        take_floors(thud_sweep_floors(point, v, point->ncases), task->scene,
                    thud_baseline_result(thud_sweep_baseline(group, v, thud_sweep_free_case(plan))->baseline));
    for (int l = 0; l < point->nlinkages; l++)
        point->fall[l] = thud_baseline_result(group->baseline[l][0].baseline)->collapse;
    memcpy(point->level, group->level, (size_t)(point->nlinkages * point->ncontacts) * sizeof *point->level);
    *out = task;
    return THUD_OK;
}

static const struct thud_sweep_baseline *baseline_of(const struct thud_sweep_task *task)
{
    return thud_sweep_baseline(task->group, task->variant, task->point->which[task->which]);
}

/* Whether the motion without pounding never uses up the clearance of contact c. */
static bool never_closes(const struct thud_sweep_task *task, int c)
{
    const struct thud_model_contact *p = &task->model->contact[c];
    const struct thud_baseline_motion *baseline = baseline_of(task)->baseline;
    return (p->law->flags & THUD_LAW_NO_FORCE) || thud_baseline_relative_displacement(baseline, c) <= p->clearance_m;
}

/* Walls and laws without force part the row of structures into groups that know nothing of each other; where no contact
 * of a group closes without pounding, none of it ever does. Returns how many contacts of law are left out; *left: how
 * many remain. */
static int leave_out(struct thud_sweep_task *task, bool drop, int *left)
{
    struct thud_model *m = task->model;
    int group[THUD_STRUCTURES_MAX] = {0}, dropped = 0;
    bool closes[THUD_STRUCTURES_MAX] = {false}, open[THUD_STRUCTURES_MAX] = {false};
    for (int c = 0; c < m->npairs; c++)
        open[m->contact[c].interface] |= !(m->contact[c].law->flags & THUD_LAW_NO_FORCE);
    for (int i = 0; i < m->nlinks; i++) { /* what links join is one group; ends stand in neighbours */
        const struct thud_model_link *link = &m->link[i];
        if (link->left_dof >= 0 && link->right_dof >= 0)
            open[m->dof_structure[link->left_dof > link->right_dof ? link->left_dof : link->right_dof]] = true;
    }
    for (int i = 1; i < m->nstructures; i++) /* interface i joins structures i - 1 and i */
        group[i] = group[i - 1] + (i > 1 && (m->structure[i - 1].n == 0 || !open[i]));
    for (int c = 0; c < m->npairs; c++)
        closes[group[m->contact[c].interface]] |= !never_closes(task, c);
    *left = 0;
    for (int c = 0; c < m->npairs; c++) {
        if (m->contact[c].law->flags & THUD_LAW_NO_FORCE)
            continue;
        if (closes[group[m->contact[c].interface]]) {
            ++*left;
            continue;
        }
        dropped++;
        if (drop)
            m->contact[c].law = thud_law_find("none");
    }
    return dropped;
}

/* Whether results have the same floors and contacts. */
static bool same_layout(const struct thud_model *a, const struct thud_model *b)
{
    bool same = a->nstructures == b->nstructures && a->npairs == b->npairs;
    for (int s = 0; same && s < a->nstructures; s++)
        same = a->structure[s].n == b->structure[s].n;
    return same;
}

/* What became of the run at work; of a changed one only the sums are kept. */
static void count_run(struct thud_sweep_task *task)
{
    struct thud_sweep_changed *changed = &task->point->changed;
    struct thud_sweep_effort *kept = &task->point->effort[task->which];
    if (task->variant == 0) {
        bool reference = kept->reference;
        *kept = task->effort;
        kept->reference = reference;
        if (thud_sweep_is_made_before(task->group, task->point->index, task->which))
            thud_sweep_effort_taken(kept);
        return;
    }
    if (thud_sweep_is_made_before(task->group, task->point->index, task->which))
        return; /* counted where it is made, whether it could be reused or not */
    changed->made += task->effort.made;
    changed->free += task->effort.status == THUD_OK && !task->effort.made;
    changed->failed += task->effort.status != THUD_OK;
    changed->steps += task->effort.steps;
    changed->events += task->effort.events;
}

static void no_numbers(const struct thud_sweep_task *task)
{
    const struct thud_sweep_point *point = task->point;
    for (int i = 0; i < point->nfloors; i++)
        thud_sweep_floors(point, task->variant, task->which)[i] =
            (struct thud_sweep_floor){NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN};
    for (int c = 0; c < point->ncontacts && task->variant > 0; c++)
        thud_sweep_contacts(point, task->variant, task->which)[c] =
            (struct thud_sweep_contact){.force_n = NAN, .indentation_m = NAN};
}

/* What a run's effort keeps of its result. */
static void take_run(struct thud_sweep_task *task, const struct thud_result *result)
{
    const struct thud_link_result *link = thud_link_hardest(task->cased, result);
    task->effort.end_s = result->end_s;
    task->effort.fall = result->collapse;
    task->effort.link_n = link ? link->force.value : NAN;
}

/* The result without a run where the baseline has it; else a run. */
static enum thud_status start_run(struct thud_sweep_task *task, const struct thud_run_options *options,
                                  struct thud_error *err)
{
    const struct thud_sweep_baseline *baseline = baseline_of(task);
    struct thud_sweep_effort *effort = &task->effort;
    unsigned shortcuts = thud_baseline_shares(baseline->baseline) ? task->plan->shortcuts : 0;
    int left = 0, dropped = 0;
    if (shortcuts & (THUD_SWEEP_FREE | THUD_SWEEP_LEVELS))
        dropped = leave_out(task, shortcuts & THUD_SWEEP_LEVELS, &left);
    if ((shortcuts & THUD_SWEEP_FREE) && left == 0) {
        const struct thud_result *result = thud_baseline_result(baseline->baseline);
        point_fill(task->point, task->variant, task->which, task->scene, task->model, result);
        take_run(task, result);
        count_run(task);
        return THUD_OK;
    }
    effort->made = true;
    effort->left_out = shortcuts & THUD_SWEEP_LEVELS ? dropped : 0;
    if (shortcuts & THUD_SWEEP_START)
        return thud_baseline_run(baseline->baseline, task->model, baseline->record, options, &task->run,
                                 &effort->shared_s, err);
    return thud_run_create(task->model, baseline->record, options, &task->run, err);
}

static enum thud_status begin(struct thud_sweep_task *task, struct thud_error *err)
{
    struct thud_run_options options;
    task->effort = (struct thud_sweep_effort){0};
    enum thud_status status = thud_sweep_case(task->plan, task->scene, task->point->which[task->which], task->variant,
                                              true, task->cased, err);
    if (status == THUD_OK)
        status = thud_sweep_model(task->cased, &task->model, &options, err);
    if (status == THUD_OK && !same_layout(task->model, baseline_of(task)->model))
        status = thud_error_set(err, THUD_INPUT, "floors and contacts differ from those of the study's first case");
    if (status == THUD_OK)
        status = start_run(task, &options, err);
    return status;
}

static enum thud_status finish(struct thud_sweep_task *task, struct thud_error *err)
{
    const struct thud_result *result = thud_run_result(task->run);
    enum thud_status status = thud_result_check(result, err);
    if (status != THUD_OK)
        return status;
    point_fill(task->point, task->variant, task->which, task->scene, task->model, result);
    take_run(task, result);
    task->effort.steps = result->work.steps;
    task->effort.events = result->work.events;
    count_run(task);
    return THUD_OK;
}

/* The next case, and after the last one the next variant. */
static void next_run(struct thud_sweep_task *task)
{
    thud_run_free(task->run);
    thud_model_free(task->model);
    task->run = NULL;
    task->model = NULL;
    if (++task->which == task->point->ncases) {
        task->which = 0;
        task->variant++;
    }
}

/* A case without a result has no spread. */
static bool skipped(const struct thud_sweep_task *task)
{
    return task->variant > 0 && task->point->effort[task->which].status != THUD_OK;
}

enum thud_status thud_sweep_task_advance(struct thud_sweep_task *task, long budget, bool *done, struct thud_error *err)
{
    while (budget > 0 && task->variant < task->point->nvariants) {
        bool ended = false;
        if (task->point->awaited[task->which]) {
            next_run(task);
            continue;
        }
        if (skipped(task)) {
            no_numbers(task);
            next_run(task);
            continue;
        }
        enum thud_status status = task->run ? THUD_OK : begin(task, err);
        if (status == THUD_OK && task->run) {
            status = thud_run_advance(task->run, budget, &ended, err);
            budget = ended ? budget / 2 : 0;
            if (status == THUD_OK && ended)
                status = finish(task, err);
        }
        if (status == THUD_MEMORY)
            return status;
        if (status != THUD_OK) {
            task->effort.status = status;
            count_run(task);
            no_numbers(task);
        }
        if (status != THUD_OK || !task->run || ended)
            next_run(task);
    }
    *done = task->variant == task->point->nvariants;
    return THUD_OK;
}

void thud_sweep_task_leave(struct thud_sweep_task *task, long first, long step)
{
    struct thud_sweep_point *point = task->point;
    for (int k = 0; k < point->ncases; k++) {
        long maker = thud_sweep_maker(task->group, point->index, k);
        point->awaited[k] =
            thud_sweep_is_made_before(task->group, point->index, k) && maker >= first && (maker - first) % step == 0;
    }
}

struct thud_sweep_point *thud_sweep_task_take(struct thud_sweep_task *task)
{
    struct thud_sweep_point *point = task->point;
    task->point = NULL;
    return point;
}

void thud_sweep_task_free(struct thud_sweep_task *task)
{
    if (!task)
        return;
    thud_run_free(task->run);
    thud_model_free(task->model);
    free(task->scene);
    free(task->point);
    free(task);
}

enum thud_status thud_sweep_point_make(const struct thud_sweep_plan *plan, long index, struct thud_sweep_point **out,
                                       struct thud_error *err)
{
    enum { AT_ONCE = 1 << 20 };
    struct thud_sweep_group *group;
    struct thud_sweep_task *task = NULL;
    bool done = false;
    *out = NULL;
    enum thud_status status = thud_sweep_group_create(plan, index / thud_sweep_points_per_group(plan), &group, err);
    while (status == THUD_OK && !done)
        status = thud_sweep_group_advance(group, AT_ONCE, &done, err);
    if (status == THUD_OK)
        status = thud_sweep_task_create(plan, group, index, &task, err);
    for (done = false; status == THUD_OK && !done;)
        status = thud_sweep_task_advance(task, AT_ONCE, &done, err);
    if (status == THUD_OK)
        *out = thud_sweep_task_take(task);
    thud_sweep_task_free(task);
    thud_sweep_group_free(group);
    return status;
}
