/* The search: every simplification by itself; then, by what it saves for what it changes, one after the other on top of
 * those that were taken, where the whole keeps the accuracy. A row that was taken for the same thing is replaced by one
 * that saves more. */
#include "study/simplify/simplify.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ground/record_edit.h"
#include "study/scene/needed_gap.h"
#include "study/simplify/simplify_private.h"
#include "study/sweep/sensitivity.h"

enum { RUNS_MOST = 150 };
enum stage { STAGE_FULL, STAGE_MOVED, STAGE_SINGLE, STAGE_TOGETHER, STAGE_DONE };

struct thud_simplify {
    struct thud_simplify_ask ask;
    struct thud_scene base, scene; /* as given, scaled by a peak alone; of the cheapest */
    struct thud_scene trial, cased;
    const struct thud_record *record;
    struct thud_solution full;                             /* of the scene as written */
    struct thud_simplify_peaks peaks[THUD_SIMPLIFY_CASES]; /* of its cases */
    double gap_m;                                          /* required; NaN: none */
    struct thud_simplification self, cheapest, one[THUD_SIMPLIFY_MAX];
    int n, steps, step[THUD_SIMPLIFY_MAX], order[THUD_SIMPLIFY_MAX];
    enum stage stage;
    int at, runs;
    double moved, work;
};

const char *thud_simplify_group_name(enum thud_simplify_group group)
{
    static const char *const names[] = {"model", "contact", "motion", "method"};
    return names[group];
}

static int cases(const struct thud_simplify *s)
{
    return s->ask.ncases > 0 ? s->ask.ncases : 1;
}

static enum thud_case case_at(const struct thud_simplify *s, int i)
{
    return s->ask.ncases > 0 ? s->ask.cases[i] : THUD_CASE_AS_WRITTEN;
}

enum thud_status thud_simplify_create(const struct thud_scene *scene, const struct thud_record *record,
                                      const struct thud_simplify_ask *ask, struct thud_simplify **out,
                                      struct thud_error *err)
{
    struct thud_simplify *s = *out = calloc(1, sizeof *s);
    if (!s)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    s->ask = *ask;
    s->base = *scene;
    s->record = record;
    s->moved = s->gap_m = NAN;
    struct thud_record_choice *choice = &s->base.record;
    if (record && (choice->sa_mps2 > 0 || choice->target[0])) { /* their scale hangs on the buildings' periods */
        choice->sa_mps2 = choice->period_s = choice->target_from_s = choice->target_to_s = NAN;
        memset(choice->target, 0, sizeof choice->target);
        choice->peak_mps2 = thud_record_peak(record);
        choice->factor = 1;
    }
    s->scene = s->base;
    s->self.inputs = s->cheapest.inputs = thud_scene_inputs(&s->base);
    s->self.work = s->cheapest.work = 1;
    return THUD_OK;
}

void thud_simplify_free(struct thud_simplify *s)
{
    if (!s)
        return;
    for (int i = 0; i < THUD_SIMPLIFY_CASES; i++)
        thud_simplify_peaks_clear(&s->peaks[i]);
    thud_solution_clear(&s->full);
    free(s);
}

static double work_of(const struct thud_solution *solution)
{
    const struct thud_work *w = &thud_run_result(solution->run)->work;
    return (double)(w->steps + w->force_evaluations + w->samples_fast) * fmax(1, solution->model->nmodes);
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

/* The run of a case (by its index) and its peaks; its work is added. */
static enum thud_status run_case(struct thud_simplify *s, const struct thud_scene *scene,
                                 const struct thud_record *record, int which, struct thud_simplify_peaks *peaks,
                                 double *work, struct thud_error *err)
{
    struct thud_solution solution = {0};
    *peaks = (struct thud_simplify_peaks){0};
    enum thud_status status = thud_scene_case(scene, case_at(s, which), &s->cased, err);
    if (status == THUD_OK)
        status = thud_scene_solve(&s->cased, record, NULL, &solution, err);
    s->runs += status == THUD_OK || status == THUD_DIVERGED;
    if (status == THUD_OK)
        status = thud_simplify_peaks_take(thud_run_result(solution.run), peaks, err);
    if (status == THUD_OK)
        *work += work_of(&solution);
    thud_solution_clear(&solution);
    return status;
}

static enum thud_status run_full(struct thud_simplify *s, struct thud_error *err)
{
    enum thud_status status = thud_scene_solve(&s->base, s->record, NULL, &s->full, err);
    s->runs++;
    for (int i = 0; status == THUD_OK && i < cases(s); i++)
        if (case_at(s, i) != THUD_CASE_AS_WRITTEN)
            status = run_case(s, &s->base, s->record, i, &s->peaks[i], &s->work, err);
        else if ((status = thud_simplify_peaks_take(thud_run_result(s->full.run), &s->peaks[i], err)) == THUD_OK)
            s->work += work_of(&s->full);
    for (int i = 0; i < cases(s); i++)
        s->self.change.impacts += s->peaks[i].impacts;
    s->cheapest.change = s->self.change;
    return status == THUD_OK ? needed_gap(&s->base, s->record, &s->gap_m, err) : status;
}

static void largest(struct thud_simplify_change *c)
{
    const double part[] = {c->acceleration, c->drift, c->force, c->gap};
    for (size_t i = 0; i < sizeof part / sizeof *part; i++)
        c->all = fmax(c->all, isnan(part[i]) ? 0 : part[i]);
}

/* The motion of a scene: that of the search, cut and thinned where the scene says so. */
static enum thud_status make_record(const struct thud_simplify *s, const struct thud_scene *scene,
                                    const struct thud_record *record, struct thud_record **out, struct thud_error *err)
{
    *out = NULL;
    if (!record)
        return THUD_OK;
    enum thud_status status = thud_record_create(record->a_mps2, record->samples, record->dt_s, out, err);
    const double begin = thud_simplify_begin(&s->base, record);
    const bool cut = memcmp(&scene->record.from_s, &s->base.record.from_s, 2 * sizeof(double)) != 0;
    if (status == THUD_OK && cut)
        status = thud_record_trim(*out, scene->record.from_s - begin, scene->record.to_s - begin, err);
    if (status == THUD_OK && scene->record.every > 1 && s->base.record.every != scene->record.every)
        status = thud_record_thin(*out, scene->record.every, err);
    return status;
}

/* A scene against the full one, on a motion of which the full peaks are given. A run that fails is no error: `failed`. */
static enum thud_status evaluate(struct thud_simplify *s, const struct thud_scene *scene,
                                 const struct thud_record *motion, const struct thud_simplify_peaks *full, double gap_m,
                                 struct thud_simplification *to, struct thud_error *err)
{
    struct thud_record *record = NULL;
    double work = 0, gap = NAN;
    to->change = (struct thud_simplify_change){NAN, NAN, NAN, NAN, 0, 0};
    to->inputs = thud_scene_inputs(scene);
    enum thud_status status = make_record(s, scene, motion, &record, err);
    for (int i = 0; status == THUD_OK && i < cases(s); i++) {
        struct thud_simplify_peaks peaks;
        status = run_case(s, scene, record, i, &peaks, &work, err);
        if (status == THUD_OK)
            thud_simplify_compare(&full[i], &peaks, &to->change);
        thud_simplify_peaks_clear(&peaks);
    }
    if (status == THUD_OK)
        status = needed_gap(scene, record, &gap, err);
    if (gap_m > 0)
        to->change.gap = isnan(gap) ? 1 : fabs(gap - gap_m) / gap_m;
    largest(&to->change);
    to->work = s->work > 0 ? work / s->work : 1;
    to->failed = status != THUD_OK;
    if (to->failed)
        to->change = (struct thud_simplify_change){NAN, NAN, NAN, NAN, INFINITY, 0};
    thud_record_free(record);
    return status == THUD_DIVERGED || status == THUD_INPUT ? THUD_OK : status;
}

/* The largest change by the inputs of thud_change_solve. */
static enum thud_status run_moved(struct thud_simplify *s, struct thud_error *err)
{
    struct thud_simplify_peaks full = {0};
    double most = 0;
    enum thud_status status = thud_simplify_peaks_take(thud_run_result(s->full.run), &full, err);
    for (int i = 0; status == THUD_OK && i < 2 * THUD_CHANGES; i++) {
        struct thud_solution solution;
        struct thud_simplify_peaks peaks = {0};
        struct thud_simplify_change change = {NAN, NAN, NAN, NAN, 0, 0};
        status =
            thud_change_solve(&s->base, s->record, (enum thud_change)(i / 2), i % 2 ? 1.001 : 0.999, &solution, err);
        s->runs++;
        if (status == THUD_OK)
            status = thud_simplify_peaks_take(thud_run_result(solution.run), &peaks, err);
        if (status == THUD_OK)
            thud_simplify_compare(&full, &peaks, &change);
        largest(&change);
        most = fmax(most, change.all);
        thud_simplify_peaks_clear(&peaks);
        thud_solution_clear(&solution);
    }
    thud_simplify_peaks_clear(&full);
    s->moved = status == THUD_OK ? most : NAN;
    return status == THUD_DIVERGED || status == THUD_INPUT ? THUD_OK : status; /* a scene at an edge: not known */
}

/* Every row that applies. */
static void list_rows(struct thud_simplify *s)
{
    for (int r = 0; r < thud_simplify_rows(); r++) {
        const struct thud_simplify_row *row = thud_simplify_row_at(r);
        const int span = thud_simplify_span(row, &s->base);
        if (row->group == THUD_SIMPLIFY_MOTION && (s->ask.suite || !s->record))
            continue;
        for (int i = 0; i < span; i++)
            for (int size = 0; size == 0 || (row->size && row->size[size]); size++) {
                struct thud_simplification one = {
                    .group = row->group, .information = row->information, .row = r, .at = i, .size = size};
                s->trial = s->base;
                if (s->n == THUD_SIMPLIFY_MAX ||
                    !thud_simplify_apply(&one, &s->base, s->record, thud_run_result(s->full.run), &s->trial))
                    continue;
                thud_simplify_words(&one, &s->base, one.words, sizeof one.words);
                s->one[s->n++] = one;
            }
    }
}

/* What a model saves: of the numbers to be known and of the work, each up to 1. */
static double saving(const struct thud_simplify *s, const struct thud_simplification *of)
{
    return (double)(s->self.inputs - of->inputs) / fmax(1, s->self.inputs) + fmax(0, 1 - of->work);
}

bool thud_simplification_within(const struct thud_simplify *s, const struct thud_simplification *of)
{
    return !of->failed && of->change.all <= s->ask.within;
}

static double rank(const struct thud_simplify *s, const struct thud_simplification *of)
{
    const double least = 1e-3; /* changes below are alike */
    return saving(s, of) / fmax(of->change.all, least);
}

/* Those that keep the accuracy by themselves and save something, the best first. */
static void sort_steps(struct thud_simplify *s)
{
    int n = 0;
    for (int i = 0; i < s->n; i++) {
        const struct thud_simplification *one = &s->one[i];
        if (one->information || !thud_simplification_within(s, one) || one->inputs > s->self.inputs ||
            !(saving(s, one) > 0))
            continue;
        int at = n++;
        for (; at > 0 && rank(s, &s->one[s->order[at - 1]]) < rank(s, one); at--)
            s->order[at] = s->order[at - 1];
        s->order[at] = i;
    }
    s->order[n] = -1;
}

/* The scene of steps in their order; false where one does not apply any more. */
static bool make_scene(struct thud_simplify *s, const int *step, int n, struct thud_scene *scene)
{
    *scene = s->base;
    bool made = true;
    for (int i = 0; i < n && made; i++)
        made = thud_simplify_apply(&s->one[step[i]], &s->base, s->record, thud_run_result(s->full.run), scene);
    return made;
}

/* One more step, in place of one of the same row for the same thing. */
static enum thud_status take_step(struct thud_simplify *s, int next, struct thud_error *err)
{
    int step[THUD_SIMPLIFY_MAX], n = 0;
    for (int i = 0; i < s->steps; i++)
        if (s->one[s->step[i]].row != s->one[next].row || s->one[s->step[i]].at != s->one[next].at)
            step[n++] = s->step[i];
    step[n++] = next;
    struct thud_simplification whole = {0};
    if (!make_scene(s, step, n, &s->trial))
        return THUD_OK;
    enum thud_status status = evaluate(s, &s->trial, s->record, s->peaks, s->gap_m, &whole, err);
    if (status != THUD_OK || !thud_simplification_within(s, &whole) || !(saving(s, &whole) > saving(s, &s->cheapest)))
        return status;
    s->cheapest = whole;
    s->scene = s->trial;
    s->steps = n;
    memcpy(s->step, step, sizeof step);
    return status;
}

enum thud_status thud_simplify_advance(struct thud_simplify *s, struct thud_simplification **timed, bool *done,
                                       struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    *timed = NULL;
    if (s->stage == STAGE_FULL) {
        status = run_full(s, err);
        *timed = &s->self;
        s->stage++;
    } else if (s->stage == STAGE_MOVED) {
        status = run_moved(s, err);
        list_rows(s);
        s->stage++;
    } else if (s->stage == STAGE_SINGLE && s->at < s->n && s->runs < RUNS_MOST) {
        struct thud_simplification *one = *timed = &s->one[s->at++];
        s->trial = s->base;
        thud_simplify_apply(one, &s->base, s->record, thud_run_result(s->full.run), &s->trial);
        status = evaluate(s, &s->trial, s->record, s->peaks, s->gap_m, one, err);
    } else if (s->stage == STAGE_SINGLE) {
        s->n = s->at;
        s->at = 0;
        sort_steps(s);
        s->stage++;
    } else if (s->stage == STAGE_TOGETHER) {
        if (s->order[s->at] < 0 || s->runs >= RUNS_MOST)
            s->stage++;
        else
            status = take_step(s, s->order[s->at++], err);
    }
    *done = s->stage == STAGE_DONE;
    return status;
}

enum thud_status thud_simplify_try(struct thud_simplify *s, const struct thud_record *record,
                                   struct thud_simplify_change *out, struct thud_error *err)
{
    struct thud_simplify_peaks full[THUD_SIMPLIFY_CASES] = {0};
    struct thud_simplification tried = {0};
    double gap = NAN, work = 0;
    enum thud_status status = THUD_OK;
    for (int i = 0; status == THUD_OK && i < cases(s); i++)
        status = run_case(s, &s->base, record, i, &full[i], &work, err);
    if (status == THUD_OK)
        status = needed_gap(&s->base, record, &gap, err);
    if (status == THUD_OK)
        status = evaluate(s, &s->scene, record, full, gap, &tried, err);
    for (int i = 0; i < cases(s); i++)
        thud_simplify_peaks_clear(&full[i]);
    *out = tried.change;
    if (tried.failed)
        out->all = INFINITY;
    return status;
}

void thud_simplify_step_back(struct thud_simplify *s)
{
    struct thud_error err = {0};
    if (s->steps == 0)
        return;
    s->steps--;
    make_scene(s, s->step, s->steps, &s->scene);
    if (s->steps == 0)
        s->cheapest = s->self;
    else
        evaluate(s, &s->scene, s->record, s->peaks, s->gap_m, &s->cheapest, &err);
}

int thud_simplify_runs(const struct thud_simplify *s)
{
    return s->runs;
}

int thud_simplify_count(const struct thud_simplify *s)
{
    return s->n;
}

const struct thud_simplification *thud_simplify_at(const struct thud_simplify *s, int i)
{
    return &s->one[i];
}

const struct thud_simplification *thud_simplify_full(const struct thud_simplify *s)
{
    return &s->self;
}

const struct thud_simplification *thud_simplify_cheapest(const struct thud_simplify *s)
{
    return &s->cheapest;
}

double thud_simplify_within(const struct thud_simplify *s)
{
    return s->ask.within;
}

double thud_simplify_moved(const struct thud_simplify *s)
{
    return s->moved;
}

int thud_simplify_steps(const struct thud_simplify *s)
{
    return s->steps;
}

int thud_simplify_step(const struct thud_simplify *s, int i)
{
    return s->step[i];
}

const struct thud_scene *thud_simplify_scene(const struct thud_simplify *s)
{
    return &s->scene;
}
