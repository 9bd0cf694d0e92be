/* The search: the full run on every ground motion; every simplification by itself on the governing one; then, by what
 * it saves for what it changes, one after the other on top of those that were taken, where the whole keeps the
 * accuracy. A row that was taken for the same thing is replaced by one that saves more. At last the cheapest, and each
 * of its steps by itself, on the other ground motions. */
#include "study/simplify/simplify.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/statistics.h"
#include "ground/record_edit.h"
#include "study/scene/needed_gap.h"
#include "study/simplify/simplify_private.h"
#include "study/sweep/sensitivity.h"

enum { RUNS_MOST = 150 };
static const struct thud_simplify_change unchanged = {NAN, NAN, NAN, NAN, 0, 0}; /* as yet */
enum stage { STAGE_MOTIONS, STAGE_MOVED, STAGE_SINGLE, STAGE_TOGETHER, STAGE_WHOLE, STAGE_EACH, STAGE_DONE };

/* The full run on a ground motion. */
struct motion {
    const struct thud_record *record;                      /* NULL: none */
    struct thud_simplify_peaks peaks[THUD_SIMPLIFY_CASES]; /* of its cases */
    double gap_m, work, force_n, seconds;                  /* gap: required; NaN: none */
};

struct thud_simplify {
    struct thud_simplify_ask ask; /* with one case where none was asked for */
    struct thud_scene base;       /* as given, scaled by a peak alone */
    struct thud_scene trial, cased;
    struct thud_solution full; /* of the scene as written, on the governing motion */
    struct motion *motion, *on;
    double *change; /* (nmotions) */
    struct thud_simplify_found found;
    int order[THUD_SIMPLIFY_MAX + 1];
    enum stage stage;
    int at, listed, each;
    double worked; /* in all */
};

const char *thud_simplify_group_name(enum thud_simplify_group group)
{
    static const char *const names[] = {"model", "contact", "motion", "method"};
    return names[group];
}

enum thud_status thud_simplify_create(const struct thud_scene *scene, struct thud_record *const *record, int n,
                                      const struct thud_simplify_ask *ask, struct thud_simplify **out,
                                      struct thud_error *err)
{
    struct thud_simplify *s = *out = calloc(1, sizeof *s);
    const size_t motions = n > 0 ? (size_t)n : 1;
    if (s) {
        s->on = s->motion = calloc(motions, sizeof *s->motion);
        s->change = calloc(motions, sizeof *s->change);
    }
    if (!s || !s->motion || !s->change) {
        thud_simplify_free(s);
        *out = NULL;
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    for (int i = 0; i < n; i++)
        s->motion[i].record = record[i];
    s->ask = *ask;
    if (ask->ncases == 0)
        s->ask.cases[s->ask.ncases++] = THUD_CASE_AS_WRITTEN;
    s->base = *scene;
    struct thud_record_choice *choice = &s->base.record;
    if (n > 0 && (choice->sa_mps2 > 0 || choice->target[0])) { /* their scale hangs on the buildings' periods */
        choice->sa_mps2 = choice->period_s = choice->target_from_s = choice->target_to_s = NAN;
        memset(choice->target, 0, sizeof choice->target);
        choice->peak_mps2 = thud_record_peak(record[0]);
        choice->factor = 1;
    }
    struct thud_simplify_found *f = &s->found;
    f->within = ask->within;
    f->moved = NAN;
    f->nmotions = (int)motions;
    f->scene = s->base;
    f->full = (struct thud_simplification){
        .inputs = thud_scene_inputs(&s->base), .work = 1, .median = NAN, .worst = NAN, .row = -1};
    f->cheapest = f->full;
    return THUD_OK;
}

static void clear_peaks(struct motion *motion)
{
    for (int i = 0; i < THUD_SIMPLIFY_CASES; i++)
        thud_simplify_peaks_clear(&motion->peaks[i]);
}

void thud_simplify_free(struct thud_simplify *s)
{
    if (!s)
        return;
    for (int i = 0; s->motion && i < s->found.nmotions; i++)
        clear_peaks(&s->motion[i]);
    thud_solution_clear(&s->full);
    free(s->motion);
    free(s->change);
    free(s);
}

const struct thud_simplify_found *thud_simplify_found(const struct thud_simplify *s)
{
    return &s->found;
}

/* Its required gap; NaN: nothing can meet. */
static enum thud_status needed_gap(const struct thud_scene *scene, const struct thud_record *record, double *gap_m,
                                   struct thud_error *err)
{
    struct thud_needed_gap *gap = NULL;
    *gap_m = NAN;
    enum thud_status status = thud_needed_gap_run(scene, record, &gap, err);
    if (status == THUD_OK && gap->nlevels > 0)
        *gap_m = thud_needed_gap_widest(gap, 0, THUD_GAP_EXACT, NULL);
    free(gap);
    return status;
}

/* The peaks of all cases of a scene, its required gap and its work. */
static enum thud_status run_cases(struct thud_simplify *s, const struct thud_scene *scene, struct motion *to,
                                  struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (int i = 0; status == THUD_OK && i < s->ask.ncases; i++) {
        struct thud_solution solution = {0};
        status = thud_scene_case(scene, s->ask.cases[i], &s->cased, err);
        if (status == THUD_OK)
            status = thud_scene_solve(&s->cased, to->record, NULL, &solution, err);
        s->found.runs++;
        if (status == THUD_OK)
            status = thud_simplify_peaks_take(thud_run_result(solution.run), &to->peaks[i], err);
        if (status == THUD_OK) {
            const struct thud_work *w = &thud_run_result(solution.run)->work;
            const double work =
                (double)(w->steps + w->force_evaluations + w->samples_fast) * fmax(1, solution.model->nmodes);
            to->work += work;
            s->worked += work;
            to->force_n = fmax(to->force_n, to->peaks[i].force_n);
        }
        thud_solution_clear(&solution);
    }
    return status == THUD_OK ? needed_gap(scene, to->record, &to->gap_m, err) : status;
}

/* The full run on the next ground motion; the hardest governs. */
static enum thud_status run_motion(struct thud_simplify *s, double **seconds, struct thud_error *err)
{
    struct motion *now = &s->motion[s->at++];
    const enum thud_status status = run_cases(s, &s->base, now, err);
    if (now->force_n > s->on->force_n || (s->on->force_n == 0 && now->gap_m > s->on->gap_m))
        s->on = now;
    *seconds = &now->seconds;
    return status;
}

/* The motion of a scene: that of the search, cut and thinned where the scene says so, or without what lies above a
 * frequency. */
static enum thud_status make_record(const struct thud_simplify *s, const struct thud_scene *scene,
                                    const struct thud_record *record, double low_pass, struct thud_record **out,
                                    struct thud_error *err)
{
    *out = NULL;
    if (!record)
        return THUD_OK;
    enum thud_status status = thud_record_scaled(record, 1, out, err);
    const double begin = thud_simplify_begin(&s->base, record);
    const bool cut = memcmp(&scene->record.from_s, &s->base.record.from_s, 2 * sizeof(double)) != 0;
    if (status == THUD_OK && cut)
        status = thud_record_trim(*out, scene->record.from_s - begin, scene->record.to_s - begin, err);
    if (status == THUD_OK && scene->record.every > 1 && s->base.record.every != scene->record.every)
        status = thud_record_low_pass(*out, scene->record.every, scene->record.every, err);
    return status == THUD_OK && low_pass > 0 ? thud_record_low_pass(*out, low_pass, 1, err) : status;
}

static struct thud_simplify_change compare(const struct thud_simplify *s, const struct motion *full,
                                           const struct motion *simple)
{
    struct thud_simplify_change change = unchanged;
    for (int i = 0; i < s->ask.ncases; i++)
        thud_simplify_compare(&full->peaks[i], &simple->peaks[i], &change);
    thud_simplify_compare_gap(full->gap_m, simple->gap_m, &change);
    return change;
}

/* A scene against the full one on a ground motion. A run that fails is no error: `failed`. */
static enum thud_status evaluate(struct thud_simplify *s, const struct thud_scene *scene, const struct motion *full,
                                 double low_pass, struct thud_simplification *to, struct thud_error *err)
{
    struct thud_record *record = NULL;
    struct motion simple = {.gap_m = NAN};
    const int runs = s->found.runs;
    to->inputs = thud_scene_inputs(scene);
    enum thud_status status = make_record(s, scene, full->record, low_pass, &record, err);
    simple.record = record;
    if (status == THUD_OK)
        status = run_cases(s, scene, &simple, err);
    to->failed = status != THUD_OK;
    to->change =
        to->failed ? (struct thud_simplify_change){NAN, NAN, NAN, NAN, INFINITY, 0} : compare(s, full, &simple);
    to->work = full->work > 0 ? simple.work / full->work : 1;
    clear_peaks(&simple);
    if (full != s->on)
        s->found.runs = runs;
    thud_record_free(record);
    return status == THUD_DIVERGED || status == THUD_INPUT ? THUD_OK : status;
}

/* The run as written, which rows are made from, and the largest change by the inputs of thud_change_solve. */
static enum thud_status run_moved(struct thud_simplify *s, struct thud_error *err)
{
    struct thud_simplify_peaks full = {0};
    double most = 0;
    enum thud_status status = thud_scene_solve(&s->base, s->on->record, NULL, &s->full, err);
    s->found.runs++;
    if (status != THUD_OK)
        return status;
    status = thud_simplify_peaks_take(thud_run_result(s->full.run), &full, err);
    for (int i = 0; status == THUD_OK && i < 2 * THUD_CHANGES; i++) {
        struct thud_solution solution;
        struct thud_simplify_peaks peaks = {0};
        struct thud_simplify_change change = unchanged;
        status = thud_change_solve(&s->base, s->on->record, (enum thud_change)(i / 2), i % 2 ? 1.001 : 0.999, &solution,
                                   err);
        s->found.runs++;
        if (status == THUD_OK)
            status = thud_simplify_peaks_take(thud_run_result(solution.run), &peaks, err);
        if (status == THUD_OK)
            thud_simplify_compare(&full, &peaks, &change);
        most = fmax(most, change.all);
        thud_simplify_peaks_clear(&peaks);
        thud_solution_clear(&solution);
    }
    thud_simplify_peaks_clear(&full);
    s->found.moved = status == THUD_OK ? most : NAN;
    return status == THUD_DIVERGED || status == THUD_INPUT ? THUD_OK : status; /* a scene at an edge: not known */
}

static struct thud_simplify_from from(const struct thud_simplify *s)
{
    return (struct thud_simplify_from){.base = &s->base, .record = s->on->record, .full = thud_run_result(s->full.run)};
}

/* One ground motion in place of all: the one whose peaks and required gap are nearest to the means of all. */
static enum thud_status list_one_motion(struct thud_simplify *s, struct thud_error *err)
{
    struct thud_simplify_found *f = &s->found;
    struct motion mean = {.gap_m = 0};
    struct thud_simplification *to = &f->one[s->listed];
    enum thud_status status = THUD_OK;
    for (int m = 0; status == THUD_OK && m < f->nmotions; m++) {
        for (int i = 0; status == THUD_OK && i < s->ask.ncases; i++)
            status = thud_simplify_peaks_add(&s->motion[m].peaks[i], 1.0 / f->nmotions, &mean.peaks[i], err);
        mean.gap_m += s->motion[m].gap_m / f->nmotions;
    }
    *to = f->full;
    to->group = THUD_SIMPLIFY_MOTION;
    to->information = true;
    to->work = 1.0 / f->nmotions;
    to->seconds = 0;
    for (int m = 0; status == THUD_OK && m < f->nmotions; m++) {
        const struct thud_simplify_change change = compare(s, &mean, &s->motion[m]);
        if (m == 0 || change.all < to->change.all) {
            to->change = change;
            snprintf(to->words, sizeof to->words, "ground motion %d alone in place of %d", m + 1, f->nmotions);
        }
    }
    clear_peaks(&mean);
    return status;
}

/* Every row that applies. What applies to the file of one motion only is not a step for several. */
static enum thud_status list_rows(struct thud_simplify *s, struct thud_error *err)
{
    struct thud_simplify_found *f = &s->found;
    s->listed = thud_simplify_list(from(s), s->ask.no_methods, THUD_SIMPLIFY_MAX - 1, f->one);
    for (int i = 0; i < s->listed && f->nmotions > 1; i++)
        f->one[i].information |= f->one[i].group == THUD_SIMPLIFY_MOTION;
    return f->nmotions > 1 ? list_one_motion(s, err) : THUD_OK;
}

bool thud_simplification_within(const struct thud_simplify_found *f, const struct thud_simplification *of)
{
    return !of->failed && of->change.all <= f->within;
}

/* The next of the listed rows by itself; those of which enough is known are left out. */
static enum thud_status run_single(struct thud_simplify *s, double **seconds, struct thud_error *err)
{
    static const double enough = 0.25; /* of the accuracy: half a step of second order further on */
    struct thud_simplify_found *f = &s->found;
    struct thud_simplification *one = &f->one[f->n];
    const struct thud_simplification *last = f->n > 0 ? one - 1 : NULL;
    *one = f->one[s->at++];
    if (last && thud_simplify_row_of(one)->enough && last->row == one->row && last->at == one->at && !last->failed &&
        last->change.all <= enough * f->within)
        return THUD_OK;
    f->n++;
    s->trial = s->base;
    thud_simplify_apply(one, from(s), &s->trial);
    *seconds = &one->seconds;
    const enum thud_status status =
        evaluate(s, &s->trial, s->on, thud_simplify_low_pass(one, from(s).full, s->on->record), one, err);
    if (thud_simplify_row_of(one)->span == THUD_SPAN_METHOD)
        one->work = NAN; /* a step of another method is another amount of work */
    return status;
}

/* What a model saves: of the numbers to be known and of the work, each up to 1. */
static double saving(const struct thud_simplify_found *f, const struct thud_simplification *of)
{
    return (double)(f->full.inputs - of->inputs) / fmax(1, f->full.inputs) + fmax(0, 1 - of->work);
}

static double rank(const struct thud_simplify_found *f, const struct thud_simplification *of)
{
    const double least = 1e-3; /* changes below are alike */
    return saving(f, of) / fmax(of->change.all, least);
}

/* Those that keep the accuracy by themselves and save something, the best first. */
static void sort_steps(struct thud_simplify *s)
{
    const struct thud_simplify_found *f = &s->found;
    int n = 0;
    for (int i = 0; i < f->n; i++) {
        const struct thud_simplification *one = &f->one[i];
        if (one->information || !thud_simplification_within(f, one) || one->inputs > f->full.inputs ||
            !(saving(f, one) > 0))
            continue;
        int at = n++;
        for (; at > 0 && rank(f, &f->one[s->order[at - 1]]) < rank(f, one); at--)
            s->order[at] = s->order[at - 1];
        s->order[at] = i;
    }
    s->order[n] = -1;
}

/* The scene of steps in their order; false where one does not apply any more. */
static bool make_scene(const struct thud_simplify *s, const int *step, int n, struct thud_scene *scene)
{
    *scene = s->base;
    bool made = true;
    for (int i = 0; i < n && made; i++)
        made = thud_simplify_apply(&s->found.one[step[i]], from(s), scene);
    return made;
}

enum thud_status thud_simplify_try(struct thud_simplify *s, const int *step, int n, struct thud_simplification *out,
                                   struct thud_error *err)
{
    *out = s->found.full;
    out->failed = !make_scene(s, step, n, &s->trial);
    return out->failed ? THUD_OK : evaluate(s, &s->trial, s->on, 0, out, err);
}

/* One more step, in place of one of the same row for the same thing. */
static enum thud_status take_step(struct thud_simplify *s, int next, double **seconds, struct thud_error *err)
{
    struct thud_simplify_found *f = &s->found;
    int step[THUD_SIMPLIFY_MAX], n = 0;
    for (int i = 0; i < f->steps; i++)
        if (f->one[f->step[i]].row != f->one[next].row || f->one[f->step[i]].at != f->one[next].at)
            step[n++] = f->step[i];
    step[n++] = next;
    struct thud_simplification whole;
    const enum thud_status status = thud_simplify_try(s, step, n, &whole, err);
    if (status != THUD_OK || !thud_simplification_within(f, &whole) || !(saving(f, &whole) > saving(f, &f->cheapest)))
        return status;
    f->cheapest = whole;
    f->scene = s->trial;
    f->steps = n;
    *seconds = &f->cheapest.seconds;
    memcpy(f->step, step, (size_t)n * sizeof *step);
    return status;
}

/* The next of all ground motions with these steps; after the last, their median and worst. */
static enum thud_status run_on(struct thud_simplify *s, const int *step, int n, struct thud_simplification *of,
                               struct thud_error *err)
{
    struct thud_simplification here = *of;
    const struct motion *motion = &s->motion[s->at];
    enum thud_status status = THUD_OK;
    if (motion != s->on && make_scene(s, step, n, &s->trial))
        status = evaluate(s, &s->trial, motion, 0, &here, err);
    s->change[s->at++] = here.change.all;
    of->worst = s->at == 1 ? here.change.all : fmax(of->worst, here.change.all);
    if (s->at == s->found.nmotions)
        of->median = thud_quantile(s->change, thud_sort_numbers(s->change, (size_t)s->at), 0.5, false);
    return status;
}

/* Without its last step, where it does not keep the accuracy on all ground motions. */
static enum thud_status step_back(struct thud_simplify *s, struct thud_error *err)
{
    struct thud_simplify_found *f = &s->found;
    make_scene(s, f->step, --f->steps, &f->scene);
    f->cheapest = f->full;
    return f->steps > 0 ? evaluate(s, &f->scene, s->on, 0, &f->cheapest, err) : THUD_OK;
}

static bool may_run(const struct thud_simplify *s)
{
    return s->found.runs < RUNS_MOST && (s->ask.work_most == 0 || s->worked < s->ask.work_most);
}

static void next_stage(struct thud_simplify *s)
{
    s->stage++;
    s->at = 0;
}

enum thud_status thud_simplify_advance(struct thud_simplify *s, double **seconds, bool *done, struct thud_error *err)
{
    static const double runs_least = 20; /* below, a search says nothing */
    struct thud_simplify_found *f = &s->found;
    enum thud_status status = THUD_OK;
    *seconds = NULL;
    switch (s->stage) {
    case STAGE_MOTIONS:
        status = run_motion(s, seconds, err);
        if (s->at == f->nmotions) {
            f->governing = (int)(s->on - s->motion);
            f->runs /= f->nmotions;
            f->cheapest.change = f->full.change = compare(s, s->on, s->on);
            next_stage(s);
        }
        break;
    case STAGE_MOVED:
        if (s->ask.work_most > 0 && runs_least * s->worked > s->ask.work_most) {
            s->stage = STAGE_DONE;
            break;
        }
        f->full.seconds = s->on->seconds;
        status = run_moved(s, err);
        if (status == THUD_OK)
            status = list_rows(s, err);
        next_stage(s);
        break;
    case STAGE_SINGLE:
        if (s->at < s->listed && may_run(s)) {
            status = run_single(s, seconds, err);
            break;
        }
        f->untried = s->listed - s->at;
        if (f->nmotions > 1)
            f->one[f->n++] = f->one[s->listed];
        sort_steps(s);
        next_stage(s);
        break;
    case STAGE_TOGETHER:
        if (s->order[s->at] < 0 || !may_run(s))
            next_stage(s);
        else
            status = take_step(s, s->order[s->at++], seconds, err);
        break;
    case STAGE_WHOLE:
        if (f->nmotions == 1 || f->steps == 0 || (s->at == f->nmotions && f->cheapest.worst <= f->within))
            next_stage(s);
        else if (s->at < f->nmotions)
            status = run_on(s, f->step, f->steps, &f->cheapest, err);
        else {
            s->at = 0;
            status = step_back(s, err);
        }
        break;
    case STAGE_EACH:
        if (f->nmotions == 1 || s->each == f->steps) {
            next_stage(s);
            break;
        }
        status = run_on(s, &f->step[s->each], 1, &f->one[f->step[s->each]], err);
        if (s->at == f->nmotions) {
            s->each++;
            s->at = 0;
        }
        break;
    case STAGE_DONE:
        break;
    }
    *done = s->stage == STAGE_DONE;
    return status;
}
