#include <math.h>
#include <stdio.h>

#include "app/run/result_table.h"
#include "lab/bench/bench_jobs.h"

static const char *state_word(const struct thud_bench_point *p)
{
    static const char *const words[] = {"not run", "", "FAILED", "skipped"};
    return words[p->state];
}

static void add_reference(struct thud_bench *bench, struct thud_text *out)
{
    double error = bench->reference_error;
    thud_text_append(out, "reference: %s at its tightest, against %s:\n  ", thud_bench_reference_name[0],
                     thud_bench_reference_name[1]);
    if (isnan(error))
        thud_text_append(out, "not confirmed\n");
    else if (error > 0)
        thud_text_append(out, "they agree to %.1f digits (largest relative difference %.1e)\n", -log10(error), error);
    else
        thud_text_append(out, "they agree to all digits\n");
}

/* What is told apart from results: runs whose impacts are not those of the reference, and runs without a result, or
 * with one that is none. */
enum fault { WRONG_IMPACTS, NO_RESULT, WORTHLESS, NOT_RUN };
static const double worthless = 100; /* relative error */

static bool has_fault(const struct thud_bench_point *p, enum fault fault)
{
    const bool done = p->state == THUD_BENCH_DONE;
    return fault == WRONG_IMPACTS ? done && p->error.missed + p->error.extra > 0
           : fault == NO_RESULT   ? p->state == THUD_BENCH_FAILED
           : fault == WORTHLESS   ? done && !(p->error.all <= worthless)
                                  : p->state == THUD_BENCH_SKIPPED;
}

/* How a list of runs is written: what stands before it, between two curves, behind a curve's name, between two runs. */
struct list_style {
    const char *begin, *curve, *name, *run;
};

/* The runs with a fault, by curve and setting; nothing where there are none. */
static void put_runs(struct thud_bench *bench, enum fault fault, const struct list_style *style, struct thud_text *out)
{
    int curve = -1;
    for (int i = 0; i < bench->npoints; i++) {
        const struct thud_bench_point *p = &bench->point[i];
        char name[64];
        if (!has_fault(p, fault))
            continue;
        thud_stepping_name(&p->how, name, sizeof name);
        if (p->curve != curve)
            thud_text_append(out, "%s%s%s%.0e", curve < 0 ? style->begin : style->curve, name, style->name,
                             p->how.setting);
        else
            thud_text_append(out, "%s%.0e", style->run, p->how.setting);
        if (fault == WORTHLESS)
            thud_text_append(out, " (%.3g times off)", p->error.all);
        curve = p->curve;
    }
}

static void add_list(struct thud_bench *bench, enum fault fault, const char *begin, struct thud_text *out)
{
    size_t before = out->size;
    put_runs(bench, fault, &(struct list_style){begin, "\n  ", ": ", " "}, out);
    if (out->size > before)
        thud_text_append(out, "\n");
}

/* What each accuracy costs, the quickest curve first, and where it buys nothing. */
static void add_costs(struct thud_bench *bench, struct thud_text *out)
{
    struct thud_bench_cost cost[THUD_BENCH_CURVES_MAX];
    const double moved = bench->moved;
    for (int k = 0; k < THUD_BENCH_LEVELS; k++) {
        const double level = thud_bench_level[k];
        const int n = thud_bench_costs(bench, level, cost);
        thud_text_append(out, "\npeaks right to %g %% cost%s\n", 100 * level,
                         n == 0 ? ": no run has them so near" : "");
        if (n > 0)
            thud_text_append(out, "  %-32s setting   error time ms   steps  ratio\n", "");
        for (int i = 0; i < n; i++) {
            const struct thud_bench_point *p = &bench->point[cost[i].point];
            char name[64];
            thud_stepping_name(&p->how, name, sizeof name);
            thud_text_append(out, "  %-32s %7.0e %7.1e %7.3g %7ld  %.3g\n", name, p->how.setting, p->error.all,
                             1e3 * p->seconds, p->work.steps, cost[i].ratio);
        }
    }
    if (moved > 0)
        thud_text_append(out,
                         "\n0.1 %% of input (gap, ground motion, stiffness) moves the peaks by up to %.2g %%:\n"
                         "  an error below that means nothing for this scene\n",
                         100 * moved);
}

void thud_bench_table(struct thud_bench *bench, struct thud_text *out)
{
    int curve = -1;
    add_reference(bench, out);
    add_costs(bench, out);
    for (int i = 0; i < bench->npoints; i++) {
        const struct thud_bench_point *p = &bench->point[i];
        char name[64];
        if (p->curve != curve) {
            thud_stepping_name(&p->how, name, sizeof name);
            thud_text_append(out, "\n%s%s\n", name,
                             bench->model->nstoreys == 0 ? ""
                             : p->how.locate             ? ": impacts, yielding and unloading where they are"
                                                         : ": impacts, yielding and unloading at ends of steps");
            thud_text_append(out, "%5s      ms  spread   error  accel.   drift   force  impact miss  steps forces\n",
                             p->how.method->flags & THUD_METHOD_FIXED_STEP ? "step" : "tol.");
            curve = p->curve;
        }
        if (p->state != THUD_BENCH_DONE) {
            struct thud_text words = {0};
            thud_text_append(&words, "%6.0e  %s %s", p->how.setting, state_word(p), p->message);
            thud_table_words(out, "", &words, 8);
            continue;
        }
        char spread[16] = "-"; /* of one timing */
        if (p->repeats > 1)
            snprintf(spread, sizeof spread, "%.2g", 1e3 * p->spread);
        thud_text_append(out, "%5.0e %7.3g %7s %7.1e %7.1e %7.1e %7.1e %7.1e %2d+%-1d %6ld %6ld\n", p->how.setting,
                         1e3 * p->seconds, spread, p->error.all, p->error.acceleration, p->error.drift, p->error.force,
                         p->error.impact_time_s, p->error.missed, p->error.extra, p->work.steps,
                         p->work.force_evaluations);
    }
    add_list(bench, WRONG_IMPACTS, "\nimpacts missed or added:\n  ", out);
    add_list(bench, WORTHLESS, "\nworthless:\n  ", out);
    add_list(bench, NO_RESULT, "\nno result:\n  ", out);
    add_list(bench, NOT_RUN, "\nnot run, they take too long (--patience 1000s runs them):\n  ", out);
}

/* Runs of a curve that are drawn alike. */
struct runs {
    double x[64], time[64], work[64];
    size_t n;
};

static void take_run(struct runs *runs, const struct thud_bench_point *p)
{
    runs->x[runs->n] = fmax(p->error.all, 1e-13);
    runs->time[runs->n] = 1e3 * p->seconds;
    runs->work[runs->n++] = (double)p->work.steps + (double)p->work.force_evaluations;
}

static void add_runs(struct thud_panel *const panel[2], struct thud_style style, const char *name,
                     const struct runs *runs)
{
    if (runs->n == 0)
        return;
    thud_panel_add(panel[0], style, name, runs->n, runs->x, runs->time);
    thud_panel_add(panel[1], style, name, runs->n, runs->x, runs->work);
}

/* One curve into both panels of its column. A line joins the runs that are nearer to the reference than all coarser
 * steps: near its own rounding a method moves at random. Returns whether others stand alone. */
static bool add_curve(struct thud_bench *bench, int first, int last, struct thud_panel *const panel[2], int color)
{
    struct runs joined = {.n = 0}, alone = {.n = 0}, ringed = {.n = 0};
    double least = INFINITY;
    for (int i = first; i < last && i < first + 64; i++) {
        const struct thud_bench_point *p = &bench->point[i];
        if (p->state != THUD_BENCH_DONE || !(p->error.all > 0) || has_fault(p, WORTHLESS))
            continue;
        take_run(p->error.all < least ? &joined : &alone, p);
        least = fmin(least, p->error.all);
        if (has_fault(p, WRONG_IMPACTS))
            take_run(&ringed, p);
    }
    const struct thud_style line = {.kind = THUD_LINES_POINTS, .color = color, .wide = color == 0},
                            point = {.kind = THUD_POINTS, .color = color},
                            ring = {.kind = THUD_POINTS, .color = THUD_COLORS - 1, .wide = true};
    add_runs(panel, line, bench->point[first].how.method->name, &joined);
    add_runs(panel, point, "", &alone);
    add_runs(panel, ring, "", &ringed); /* no method: the note says what it is */
    return alone.n > 0;
}

/* What marks mean, and methods with runs that no chart can show. */
static void add_note(struct thud_bench *bench, bool alone, struct thud_figure *figure)
{
    static const struct list_style blown_up = {"Blown up, and not shown: ", "; ", " at ", ", "},
                                   off = {"Worthless, and not shown: ", "; ", " at ", ", "};
    enum { PARTS = 5 };
    struct thud_text part[PARTS] = {{0}}, note = {0};
    if (bench->moved > 0)
        thud_text_append(&part[0], "Shaded: errors below what 0.1 %% of input moves");
    for (int i = 0; i < bench->npoints && part[1].size == 0; i++)
        if (has_fault(&bench->point[i], WRONG_IMPACTS))
            thud_text_append(&part[1], "Ringed: runs that missed impacts or added some");
    if (alone)
        thud_text_append(&part[2], "Not joined: runs no more accurate than a coarser one");
    put_runs(bench, NO_RESULT, &blown_up, &part[3]);
    put_runs(bench, WORTHLESS, &off, &part[4]);
    for (int i = 0; i < PARTS; i++) {
        if (part[i].size > 0)
            thud_text_append(&note, "%s%s.", note.size > 0 ? " " : "", part[i].data);
        thud_text_clear(&part[i]);
    }
    if (note.size > 0 && !note.failed)
        thud_figure_note(figure, note.data);
    thud_text_clear(&note);
}

/* The same colour for a method wherever it stands; `exact`, the first of the list, is 0. */
static int color_of(const struct thud_method *method)
{
    int i = 0;
    while (i < thud_method_count() && thud_method_at(i) != method)
        i++;
    return i;
}

/* Panels side by side show the same stretch, so that they can be compared. */
static void share_axis(struct thud_panel *const panel[], int n, enum thud_side side)
{
    double least = INFINITY, most = -INFINITY;
    for (int i = 0; i < n; i++) {
        if (!panel[i] || panel[i]->nseries == 0)
            continue;
        struct thud_range range = thud_panel_range(panel[i], side);
        least = fmin(least, range.least);
        most = fmax(most, range.most);
    }
    for (int i = 0; i < n && least < most; i++)
        thud_panel_limits(panel[i], side, least, most);
}

struct thud_figure *thud_bench_figure(struct thud_bench *bench, const char *title)
{
    static const char *const titles[2][2] = {
        {"Time, not located: peaks at step ends", "Time, located: peaks inside steps"},
        {"Work, events not located", "Work, events located"}};
    struct thud_figure *figure = thud_figure_create("bench", title, 2, 2);
    struct thud_panel *panel[2][2];
    double trust = bench->reference_error, moved = bench->moved;
    for (int row = 0; row < 2; row++)
        for (int column = 0; column < 2; column++) {
            struct thud_panel *p = panel[column][row] = thud_figure_panel(figure, row, column, titles[row][column]);
            thud_panel_axis(p, THUD_X, "Largest relative error of the peaks", "");
            thud_panel_axis(p, THUD_Y, row == 0 ? "Time" : "Steps and force evaluations", row == 0 ? "ms" : "");
            thud_panel_log(p, THUD_X);
            thud_panel_log(p, THUD_Y);
            if (isfinite(trust) && trust > 0)
                thud_panel_mark(p, THUD_X, fmax(trust, 1e-13), fmax(trust, 1e-13), "reference");
            if (moved > 0)
                thud_panel_mark(p, THUD_X, 1e-13, moved, "");
        }
    int count = bench->npoints;
    bool alone = false;
    for (int first = 0, last; first < count; first = last) {
        const struct thud_bench_point *p = &bench->point[first];
        for (last = first; last < count && bench->point[last].curve == p->curve;)
            last++;
        bool exact = p->how.method->order == 0 && p->how.locate;
        for (int column = 0; column < 2; column++)
            if (exact || column == p->how.locate)
                alone |= add_curve(bench, first, last, panel[column], color_of(p->how.method));
    }
    struct thud_panel *const all[] = {panel[0][0], panel[1][0], panel[0][1], panel[1][1]}; /* time, time, work, work */
    add_note(bench, alone, figure);
    share_axis(all, 4, THUD_X);
    share_axis(all, 2, THUD_Y);
    share_axis(all + 2, 2, THUD_Y);
    return figure;
}
