#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "plot/figure.h"
#include "study/answer.h"
#include "study/needed_gap.h"
#include "study/remark.h"
#include "study/spacing.h"
#include "study/statistics.h"
#include "tui/live.h"

enum { SEGMENTS = 100, HISTORY_BYTES = 48 << 20 };

const char *thud_live_name(enum thud_live_which which)
{
    static const char *const name[] = {"no pounding", "no bumper", "bumper"};
    return name[which];
}

int thud_live_color(enum thud_live_which which)
{
    static const int color[] = {THUD_COLOR_GREY, 0, 1};
    return color[which];
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
    live->baseline = NULL;
    live->apart = NULL;
}

void thud_live_clear(struct thud_live *live)
{
    need_clear(live);
    for (int i = 0; i < THUD_STRUCTURES_MAX; i++)
        live->need[i] = (struct thud_live_need){NAN, NAN, NAN};
    for (int i = 0; i < THUD_LIVE_CASES; i++)
        case_clear(&live->which[i]);
    live->running = live->history = false;
}

void thud_live_fail(struct thud_live *live, const struct thud_error *why)
{
    thud_live_clear(live);
    for (int i = 0; i < THUD_LIVE_CASES; i++) {
        live->which[i].state = THUD_LIVE_FAILED;
        live->which[i].error = *why;
    }
}

static bool any_bumper(const struct thud_scene *scene)
{
    for (int i = 0; i + 1 < scene->nstructures; i++)
        if (scene->interface[i].has_bumper)
            return true;
    return false;
}

/* The scene of a case; false where it has none. */
static bool case_scene(const struct thud_scene *scene, enum thud_live_which which, struct thud_scene *out)
{
    *out = *scene;
    if (which == THUD_LIVE_BUMPER)
        return any_bumper(scene);
    for (int i = 0; i + 1 < out->nstructures; i++) {
        out->interface[i].has_bumper = false;
        if (which == THUD_LIVE_FREE) {
            out->interface[i].contact.law = thud_law_find("none");
            memset(out->interface[i].contact.value, 0, sizeof out->interface[i].contact.value);
        }
    }
    return true;
}

/* The motion without pounding, from which the gap that is needed follows. Where it cannot be had nothing is known of it,
 * and the cases say why. */
static void need_start(struct thud_live *live, const struct thud_scene *scene, const struct thud_record *record)
{
    struct thud_scene *bare = malloc(sizeof *bare);
    struct thud_run_options options;
    need_clear(live);
    for (int i = 0; i < THUD_STRUCTURES_MAX; i++)
        live->need[i] = (struct thud_live_need){NAN, NAN, NAN};
    if (bare) {
        case_scene(scene, THUD_LIVE_NONE, bare);
        if (thud_scene_assemble(bare, &live->apart, NULL) == THUD_OK &&
            thud_scene_options(bare, &options, NULL) == THUD_OK) {
            thud_baseline_create(live->apart, record, &options, &live->baseline, NULL);
        }
    }
    free(bare);
    if (!live->baseline)
        need_clear(live);
}

static void need_finish(struct thud_live *live)
{
    for (int c = 0; c < live->apart->ncontacts; c++) {
        const struct thud_model_contact *p = &live->apart->contact[c];
        struct thud_live_need *need = &live->need[p->interface - 1];
        double left = thud_gap_side(live->apart, live->baseline, c, false),
               right = thud_gap_side(live->apart, live->baseline, c, true);
        need->closing_m =
            fmax(need->closing_m, thud_baseline_relative_displacement(live->baseline, c)); /* fmax passes over NaN */
        need->abs_m = fmax(need->abs_m, thud_spacing_abs(left, right));
        need->srss_m = fmax(need->srss_m, thud_spacing_srss(left, right));
    }
    need_clear(live);
}

/* Rows no closer than the memory set aside allows. */
static double history_step(const struct thud_model *model, const struct thud_record *record, double tail_s)
{
    double columns = 1.0 + 3.0 * model->ndof + 2.0 * model->ncontacts + THUD_HISTORY_ENERGIES + 1.0;
    double rows = HISTORY_BYTES / (8.0 * columns);
    double span = tail_s + (record ? record->dt_s * (double)record->samples : 0.0);
    double least = record ? record->dt_s : 1e-3;
    return fmax(least, span / rows);
}

static enum thud_status case_start(struct thud_live_case *c, const struct thud_scene *scene,
                                   const struct thud_record *record, bool history)
{
    struct thud_run_options options;
    enum thud_status status = thud_scene_options(scene, &options, &c->error);
    if (status == THUD_OK)
        status = thud_scene_assemble(scene, &c->model, &c->error);
    if (status != THUD_OK)
        return status;
    options.keep_impacts = true;
    options.keep_history = history;
    options.history_step_s = history_step(c->model, record, options.tail_s);
    return thud_run_create(c->model, record, &options, &c->run, &c->error);
}

/* The last answer goes aside; of a run that was cut off nothing stays, but of what was shown meanwhile. */
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

void thud_live_start(struct thud_live *live, const struct thud_scene *scene, const struct thud_record *record,
                     bool history)
{
    live->running = false;
    live->history = history;
    for (int i = 0; i < THUD_LIVE_CASES; i++) {
        struct thud_live_case *c = &live->which[i];
        struct thud_scene of_case;
        keep_old(c);
        if (!case_scene(scene, (enum thud_live_which)i, &of_case)) {
            c->state = THUD_LIVE_ABSENT;
        } else if (case_start(c, &of_case, record, history) == THUD_OK) {
            c->state = THUD_LIVE_RUNNING;
            live->running = true;
        } else {
            c->state = THUD_LIVE_FAILED;
        }
        if (c->state != THUD_LIVE_RUNNING)
            forget_old(c);
    }
    if (live->running)
        need_start(live, scene, record);
}

static void case_advance(struct thud_live_case *c)
{
    bool done = false;
    if (thud_run_advance(c->run, SEGMENTS, &done, &c->error) != THUD_OK) {
        c->failed_s = thud_run_time(c->run);
        c->state = THUD_LIVE_FAILED;
    } else if (done) {
        c->state = THUD_LIVE_DONE;
    }
    if (c->state != THUD_LIVE_RUNNING)
        forget_old(c);
}

bool thud_live_advance(struct thud_live *live)
{
    for (int i = 0; i < THUD_LIVE_CASES; i++) {
        if (live->which[i].state != THUD_LIVE_RUNNING)
            continue;
        case_advance(&live->which[i]);
        return true;
    }
    if (live->baseline) {
        bool done = false;
        if (thud_baseline_advance(live->baseline, SEGMENTS, &done, NULL) != THUD_OK)
            need_clear(live);
        else if (done)
            need_finish(live);
        return true;
    }
    live->running = false;
    return false;
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
        done += c->state != THUD_LIVE_RUNNING ? 1.0 : end > 0.0 ? fmin(1.0, thud_run_time(c->run) / end) : 0.0;
    }
    return all > 0.0 ? done / all : 1.0;
}

const struct thud_result *thud_live_result(const struct thud_live *live, enum thud_live_which which)
{
    return live->which[which].state == THUD_LIVE_DONE ? thud_run_result(live->which[which].run) : NULL;
}

bool thud_live_is_old(const struct thud_live *live, enum thud_live_which which)
{
    return live->which[which].state == THUD_LIVE_RUNNING && live->which[which].old;
}

/* What is shown of a case: its answer, or while it runs the one before. */
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
        return f->drift.value;
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
    double most = floors > 0 ? 0.0 : NAN;
    for (int i = 0; i < floors; i++)
        most = thud_largest(most, thud_live_floor(live, which, structure, i, kind));
    return most;
}

double thud_live_impulse(const struct thud_live *live, enum thud_live_which which, int interface)
{
    const struct thud_result *result = shown(live, which);
    double sum = 0.0;
    for (int i = 0; result && i < result->ncontacts; i++)
        if (!interface || result->contact[i].interface == interface)
            sum += result->contact[i].impulse_ns;
    return sum;
}

double thud_live_force(const struct thud_live *live, enum thud_live_which which, int interface, int *impacts)
{
    const struct thud_result *result = shown(live, which);
    double most = result ? 0.0 : NAN;
    *impacts = 0;
    for (int i = 0; result && i < result->ncontacts; i++) {
        if (interface && result->contact[i].interface != interface)
            continue;
        most = thud_largest(most, thud_peak_force(&result->contact[i]));
        *impacts += result->contact[i].impacts;
    }
    return most;
}
