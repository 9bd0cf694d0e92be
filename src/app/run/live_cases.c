#include "app/run/live_cases.h"

#include <math.h>
#include <stdlib.h>

#include "app/run/live_work.h"
#include "base/largest.h"
#include "plot/figures/figures_case.h"
#include "study/scene/level.h"
#include "study/scene/needed_gap.h"
#include "study/scene/solution.h"
#include "study/scene/spacing.h"
#include "study/sweep/remark.h"

enum { HISTORY_BYTES = 48 << 20, NEED = THUD_LIVE_CASES };
static const double wait_s = 0.004, look_s = 1e-3;
_Static_assert(THUD_LIVE_JOBS == THUD_LIVE_CASES + 1, "the cases, and the gap that is needed");

const char *thud_live_name(int measures, enum thud_live_which which)
{
    if (which == THUD_LIVE_FREE)
        return thud_case_free_title(measures & THUD_HAS_LINKS);
    return thud_case_title(measures, which == THUD_LIVE_BUMPER ? THUD_CASE_WHOLE : thud_case_compared((int)which));
}

const char *thud_live_short_name(const struct thud_scene *scene, enum thud_live_which which)
{
    const int measures = thud_scene_measures(scene);
    if (which == THUD_LIVE_FREE && scene->nlinks > 0)
        return "only links";
    if (measures != (THUD_HAS_BUMPER | THUD_HAS_LINKS) || which == THUD_LIVE_FREE)
        return thud_live_name(measures ? measures : THUD_HAS_BUMPER, which); /* a column that is empty has its name */
    return which == THUD_LIVE_NONE ? "neither" : "both";
}

int thud_live_color(enum thud_live_which which)
{
    return thud_case_color(thud_case_compared((int)which));
}

static void forget_old(struct thud_live_case *c)
{
    thud_run_free(c->old);
    thud_model_free(c->old_model);
    c->old = NULL;
    c->old_model = NULL;
}

static void case_clear(struct thud_live_case *c)
{
    forget_old(c);
    thud_run_free(c->run);
    thud_model_free(c->model);
    *c = (struct thud_live_case){0};
}

static void need_clear(struct thud_live *live)
{
    thud_baseline_free(live->baseline);
    thud_model_free(live->apart);
    free(live->projection_m);
    live->baseline = NULL;
    live->apart = NULL;
    live->projection_m = NULL;
}

void thud_live_stop(struct thud_live *live)
{
    thud_live_work_end(live->work);
    live->work = NULL;
}

void thud_live_clear(struct thud_live *live)
{
    thud_live_stop(live);
    need_clear(live);
    for (int i = 0; i < THUD_STRUCTURES_MAX; i++)
        live->need[i] = (struct thud_live_need){NAN, NAN, NAN, NAN};
    for (int i = 0; i < THUD_LIVE_CASES; i++)
        case_clear(&live->which[i]);
    live->running = false;
    live->history = THUD_LIVE_NO_HISTORY;
}

void thud_live_fail(struct thud_live *live, const struct thud_error *why)
{
    thud_live_clear(live);
    for (int i = 0; i < THUD_LIVE_CASES; i++) {
        live->which[i].state = THUD_LIVE_FAILED;
        live->which[i].error = *why;
    }
}

/* The scene of a case; false where it has none. */
static bool case_scene(const struct thud_scene *scene, enum thud_live_which which, struct thud_scene *out)
{
    static const enum thud_case cases[THUD_LIVE_CASES] = {THUD_CASE_FREE, THUD_CASE_NONE, THUD_CASE_AS_WRITTEN};
    *out = *scene;
    thud_scene_case(scene, cases[which], out, NULL);
    return which != THUD_LIVE_BUMPER || thud_scene_has_measure(scene);
}

/* Of the bumper at each pair of floors of the model; NULL: no memory. */
static double *projections(const struct thud_scene *scene, const struct thud_model *model)
{
    double *projection_m = malloc(((size_t)model->npairs + 1) * sizeof *projection_m);
    int level = 0;
    for (int c = 0; projection_m && c < model->npairs; c++) {
        const int interface = model->contact[c].interface;
        level = c > 0 && model->contact[c - 1].interface == interface ? level + 1 : 0;
        const struct thud_level_values at = thud_interface_level(&scene->interface[interface - 1], level);
        projection_m[c] = at.gap_m - thud_level_clearance(&at);
    }
    return projection_m;
}

/* The motion without pounding, from which the required gap follows. If it cannot be had, nothing is known of the gap,
 * and the cases say why. */
static void need_start(struct thud_live *live, const struct thud_scene *scene, const struct thud_record *record)
{
    struct thud_scene *bare = malloc(sizeof *bare);
    struct thud_run_options options;
    need_clear(live);
    for (int i = 0; i < THUD_STRUCTURES_MAX; i++)
        live->need[i] = (struct thud_live_need){NAN, NAN, NAN, NAN};
    if (bare) {
        case_scene(scene, THUD_LIVE_FREE, bare);
        if (thud_scene_assemble(bare, &live->apart, NULL) == THUD_OK &&
            thud_scene_options(bare, &options, NULL) == THUD_OK) {
            thud_baseline_create(live->apart, 0, record, &options, &live->baseline, NULL);
            live->projection_m = projections(scene, live->apart);
        }
    }
    free(bare);
    if (!live->baseline || !live->projection_m)
        need_clear(live);
}

static void need_finish(struct thud_live *live)
{
    for (int c = 0; c < live->apart->npairs; c++) {
        const struct thud_model_contact *p = &live->apart->contact[c];
        struct thud_live_need *need = &live->need[p->interface - 1];
        double left = thud_gap_side(live->apart, live->baseline, c, false),
               right = thud_gap_side(live->apart, live->baseline, c, true);
        const double relative_m = thud_baseline_relative_displacement(live->baseline, c);
        need->relative_displacement_m = fmax(need->relative_displacement_m, relative_m); /* fmax passes over NaN */
        need->with_bumper_m = fmax(need->with_bumper_m, relative_m + live->projection_m[c]);
        need->abs_m = fmax(need->abs_m, thud_spacing_abs(left, right));
        need->srss_m = fmax(need->srss_m, thud_spacing_srss(left, right));
    }
    need_clear(live);
}

/* Rows no closer than the memory set aside allows. */
static double history_step(const struct thud_model *model, const struct thud_record *record, double tail_s)
{
    double columns = 1.0 + 3.0 * model->ndof + 2.0 * model->npairs + THUD_HISTORY_ENERGIES + 1.0;
    double rows = HISTORY_BYTES / (8.0 * columns);
    double span = tail_s + (record ? record->dt_s * (double)record->samples : 0.0);
    double least = record ? record->dt_s : 1e-3;
    return fmax(least, span / rows);
}

static enum thud_status case_start(struct thud_live_case *c, const struct thud_scene *scene,
                                   const struct thud_record *record, enum thud_live_history history)
{
    struct thud_run_options options;
    enum thud_status status = thud_scene_options(scene, &options, &c->error);
    if (status == THUD_OK)
        status = thud_scene_check_motion(scene, record, &c->error);
    if (status == THUD_OK)
        status = thud_scene_assemble(scene, &c->model, &c->error);
    if (status != THUD_OK)
        return status;
    options.keep_impacts = true;
    options.keep_history = history != THUD_LIVE_NO_HISTORY;
    options.history_look_s = history == THUD_LIVE_CONTACTS || history == THUD_LIVE_LOOK ? look_s : 0.0;
    options.history_step_s = history_step(c->model, record, options.tail_s);
    return thud_run_create(c->model, record, &options, &c->run, &c->error);
}

static enum thud_live_history kept_of(enum thud_live_history history, enum thud_live_which which)
{
    return history == THUD_LIVE_CONTACTS && which == THUD_LIVE_FREE ? THUD_LIVE_NO_HISTORY : history;
}

/* The last result goes aside; of a run that was cut off nothing stays, but of what was shown meanwhile. */
static void keep_old(struct thud_live_case *c)
{
    struct thud_live_case kept = {0};
    if (c->state == THUD_LIVE_DONE) {
        kept.old = c->run;
        kept.old_model = c->model;
        c->run = NULL;
        c->model = NULL;
    } else if (c->state == THUD_LIVE_RUNNING) {
        kept.old = c->old;
        kept.old_model = c->old_model;
        c->old = NULL;
        c->old_model = NULL;
    }
    case_clear(c);
    *c = kept;
}

/* Hands the runs over, the one that takes longest first. */
static void work_start(struct thud_live *live)
{
    static const int order[] = {THUD_LIVE_BUMPER, THUD_LIVE_NONE, THUD_LIVE_FREE, NEED};
    struct thud_live_job job[THUD_LIVE_JOBS];
    struct thud_error error;
    int n = 0;
    for (int i = 0; i < THUD_LIVE_JOBS; i++)
        live->job[i] = -1;
    for (size_t i = 0; i < sizeof order / sizeof *order; i++) {
        bool need = order[i] == NEED;
        if (need ? live->baseline == NULL : live->which[order[i]].state != THUD_LIVE_RUNNING)
            continue;
        live->job[n] = order[i];
        job[n++] = need ? (struct thud_live_job){.baseline = live->baseline}
                        : (struct thud_live_job){.run = live->which[order[i]].run};
    }
    if (thud_live_work_start(job, n, live->threads, &live->work, &error) != THUD_OK)
        thud_live_fail(live, &error);
}

void thud_live_start(struct thud_live *live, const struct thud_scene *scene, const struct thud_record *record,
                     enum thud_live_history history)
{
    thud_live_stop(live);
    live->running = false;
    live->measures = thud_scene_measures(scene);
    for (int s = 0; s < scene->nstructures; s++)
        live->first_storey[s] = thud_structure_first_storey(&scene->structure[s]);
    live->history = history;
    for (int i = 0; i < THUD_LIVE_CASES; i++) {
        struct thud_live_case *c = &live->which[i];
        struct thud_scene of_case;
        keep_old(c);
        if (!case_scene(scene, (enum thud_live_which)i, &of_case)) {
            c->state = THUD_LIVE_ABSENT;
        } else if (case_start(c, &of_case, record, kept_of(history, (enum thud_live_which)i)) == THUD_OK) {
            c->state = THUD_LIVE_RUNNING;
            live->running = true;
        } else {
            c->state = THUD_LIVE_FAILED;
        }
        if (c->state != THUD_LIVE_RUNNING)
            forget_old(c);
    }
    if (!live->running)
        return;
    need_start(live, scene, record);
    work_start(live);
}

/* What came of a job. */
static void job_ended(struct thud_live *live, int which, enum thud_status status, const struct thud_error *error)
{
    if (which == NEED) {
        if (status == THUD_OK)
            need_finish(live);
        else
            need_clear(live);
        return;
    }
    struct thud_live_case *c = &live->which[which];
    c->state = status == THUD_OK ? THUD_LIVE_DONE : THUD_LIVE_FAILED;
    if (status != THUD_OK) {
        c->error = *error;
        c->failed_s = thud_run_time(c->run);
    }
    forget_old(c);
}

bool thud_live_advance(struct thud_live *live)
{
    enum thud_status status;
    struct thud_error error;
    int left = 0;
    if (!live->running || !live->work)
        return live->running = false;
    for (int i = thud_live_work_take(live->work, wait_s, &left, &status, &error); i >= 0;
         i = thud_live_work_take(live->work, 0.0, &left, &status, &error)) {
        job_ended(live, live->job[i], status, &error);
        live->ended++;
    }
    if (left == 0) {
        thud_live_stop(live);
        live->running = false;
    }
    return live->running;
}

/* How far the run of a case has come, s. */
static double time_of(const struct thud_live *live, int which)
{
    for (int i = 0; live->work && i < THUD_LIVE_JOBS; i++)
        if (live->job[i] == which)
            return thud_live_work_time(live->work, i);
    return 0.0;
}

double thud_live_progress(const struct thud_live *live)
{
    double done = 0.0, all = 0.0;
    for (int i = 0; i < THUD_LIVE_CASES; i++) {
        const struct thud_live_case *c = &live->which[i];
        if (!c->run)
            continue;
        double end = thud_run_end(c->run);
        all += 1.0;
        done += c->state != THUD_LIVE_RUNNING ? 1.0 : end > 0.0 ? fmin(1.0, time_of(live, i) / end) : 0.0;
    }
    return all > 0.0 ? done / all : 1.0;
}

const struct thud_result *thud_live_result(const struct thud_live *live, enum thud_live_which which)
{
    return live->which[which].state == THUD_LIVE_DONE ? thud_run_result(live->which[which].run) : NULL;
}

const struct thud_history *thud_live_motions(const struct thud_live *live, enum thud_live_which which)
{
    const struct thud_live_case *c = &live->which[which];
    return c->state == THUD_LIVE_DONE && kept_of(live->history, which) ? thud_run_history(c->run) : NULL;
}

const struct thud_live_case *thud_live_failed(const struct thud_live *live)
{
    for (int i = 0; i < THUD_LIVE_CASES; i++)
        if (live->which[i].state == THUD_LIVE_FAILED)
            return &live->which[i];
    return NULL;
}

bool thud_live_is_old(const struct thud_live *live, enum thud_live_which which)
{
    return live->which[which].state == THUD_LIVE_RUNNING && live->which[which].old;
}

/* What is shown of a case: its result, or while it runs the one before. */
static const struct thud_result *shown(const struct thud_live *live, enum thud_live_which which)
{
    return thud_live_is_old(live, which) ? thud_run_result(live->which[which].old) : thud_live_result(live, which);
}

double thud_live_floor(const struct thud_live *live, enum thud_live_which which, int structure, int floor,
                       enum thud_peak_kind kind)
{
    const struct thud_result *result = shown(live, which);
    if (!result || structure >= result->nstructures || floor >= result->structure[structure].floors)
        return NAN;
    const struct thud_floor_result *f = &result->structure[structure].floor[floor];
    const struct thud_storey_result *storey = result->structure[structure].storey;
    const bool yields = storey && storey[floor].yields;
    switch (kind) {
    case THUD_PEAK_DUCTILITY:
        return yields ? storey[floor].ductility : NAN;
    case THUD_PEAK_PERMANENT:
        return yields ? fabs(storey[floor].permanent_m) : NAN;
    case THUD_PEAK_ACCELERATION:
        return thud_floor_acceleration(result, structure, floor);
    case THUD_PEAK_DRIFT:
        return live->first_storey[structure] < result->structure[structure].floors ? f->drift.value : NAN;
    case THUD_PEAK_DISPLACEMENT:
        return f->displacement.value;
    default:
        return f->velocity.value;
    }
}

double thud_live_peak(const struct thud_live *live, enum thud_live_which which, int structure, enum thud_peak_kind kind)
{
    const struct thud_result *result = shown(live, which);
    int floors = result && structure < result->nstructures ? result->structure[structure].floors : 0;
    const bool of_floors = kind != THUD_PEAK_DRIFT && kind < THUD_PEAK_DUCTILITY;
    const int first = of_floors ? 0 : live->first_storey[structure];
    double most = floors > first ? 0.0 : NAN;
    for (int i = first; i < floors; i++)
        most = thud_larger(most, thud_live_floor(live, which, structure, i, kind));
    return most;
}

double thud_live_impulse(const struct thud_live *live, enum thud_live_which which, int interface)
{
    const struct thud_result *result = shown(live, which);
    return result ? thud_contacts_sum(result, interface).impulse_ns : 0.0;
}

double thud_live_force(const struct thud_live *live, enum thud_live_which which, int interface, int *impacts)
{
    const struct thud_result *result = shown(live, which);
    const struct thud_contact_sum sum =
        result ? thud_contacts_sum(result, interface) : (struct thud_contact_sum){.force_n = NAN};
    *impacts = sum.impacts;
    return sum.force_n;
}
