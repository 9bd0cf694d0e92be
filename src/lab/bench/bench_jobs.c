#include "lab/bench/bench_jobs.h"

#include <math.h>
#include <stdio.h>

#include "app/run/timing.h"

enum { SLICE = 2000 };
/* A point is timed again while one run of it takes no longer than the first, and all of them than the second. */
static const double again_below_s = 1, spend_s = 2;

struct bench_work {
    struct thud_bench *bench;
    const struct thud_bench_jobs *jobs;
    double start_s; /* when all began, on the clock */
};

static double spent_s(const struct bench_work *work)
{
    return thud_timing_now_s() - work->start_s;
}

static void show_progress(const struct bench_work *work, const char *what, int done, int count)
{
    if (work->jobs->progress)
        work->jobs->progress(work->jobs->context, what, done, count);
}

/* In slices, so that a wish to stop is seen. */
static enum thud_status run_whole(const struct bench_work *work, struct thud_run *run, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (bool done = false; status == THUD_OK && !done;)
        status = work->jobs->cancel && *work->jobs->cancel ? thud_error_set(err, THUD_CANCELLED, "stopped")
                                                           : thud_run_advance(run, SLICE, &done, err);
    return status;
}

static enum thud_status make_reference(const struct bench_work *work, int which, struct thud_error *err)
{
    struct thud_run *run;
    show_progress(work, "reference", which, 2);
    enum thud_status status = thud_bench_reference_start(work->bench, which, &run, err);
    if (status == THUD_OK && run)
        status = run_whole(work, run, err);
    if (status == THUD_OK)
        return thud_bench_reference_finish(work->bench, which, run, err);
    thud_run_free(run);
    return status;
}

/* Of the time of a run over that of the one before it on its curve: steps cost by their number, tolerances little. */
static double growth(const struct thud_bench_point *p, const struct thud_bench_point *before)
{
    return p->how.method->flags & THUD_METHOD_FIXED_STEP ? before->how.setting / p->how.setting : 1.8;
}

/* How long the point will take, by the one before it; 0: not known. */
static double expected_s(struct thud_bench *bench, int i)
{
    const struct thud_bench_point *p = &bench->point[i], *before = i > 0 ? p - 1 : NULL;
    return before && before->curve == p->curve ? before->seconds * growth(p, before) : 0;
}

/* A point with its timings; one that takes long is timed once. */
static double with_timings_s(double run_s)
{
    return run_s + (run_s > again_below_s ? 0 : fmin(spend_s, THUD_BENCH_REPEATS * run_s));
}

static bool is_too_long(const struct thud_bench_jobs *jobs, double run_s, double before_s)
{
    return (jobs->patience_s > 0 && run_s > jobs->patience_s) ||
           (jobs->budget_s > 0 && before_s + with_timings_s(run_s) > jobs->budget_s);
}

/* How long the points that wait will take, as far as their curves have begun. */
static double left_s(const struct bench_work *work)
{
    double sum = 0, run_s = 0;
    const double before_s = spent_s(work);
    for (int i = 0; i < work->bench->npoints; i++) {
        const struct thud_bench_point *p = &work->bench->point[i];
        run_s = p->state != THUD_BENCH_WAITING        ? p->seconds
                : i > 0 && p->curve == (p - 1)->curve ? run_s * growth(p, p - 1)
                                                      : 0;
        if (p->state == THUD_BENCH_WAITING && !is_too_long(work->jobs, run_s, before_s + sum))
            sum += with_timings_s(run_s);
    }
    return sum;
}

static bool skip_point(const struct bench_work *work, int i)
{
    struct thud_bench_point *p = &work->bench->point[i];
    const double expected = expected_s(work->bench, i), before_s = spent_s(work);
    if (!is_too_long(work->jobs, expected, before_s))
        return false;
    p->state = THUD_BENCH_SKIPPED;
    if (expected > 0)
        snprintf(p->message, sizeof p->message, "would take about %.2g s", expected);
    else
        snprintf(p->message, sizeof p->message, "left out: %.2g s are spent", before_s);
    p->seconds = expected; /* for the next one on the curve */
    return true;
}

/* The first run of a point warms up and is judged, the others are for its time; it alone counts where it takes long. */
static enum thud_status measure_point(const struct bench_work *work, int i, struct thud_error *err)
{
    struct thud_bench_point *p = &work->bench->point[i];
    double seconds[THUD_BENCH_REPEATS + 1], processor[THUD_BENCH_REPEATS + 1], warm_s = 0, unused;
    int timed = 0;
    for (bool first = true, again = true; again; first = false) {
        struct thud_run *run = NULL;
        struct thud_error failure = {0};
        const double start = thud_timing_now_s(), begin = thud_timing_processor_s();
        enum thud_status status = thud_bench_start(work->bench, i, &run, &failure), judged = THUD_OK;
        if (status == THUD_OK)
            status = run_whole(work, run, &failure);
        seconds[timed] = thud_timing_now_s() - start;
        processor[timed] = thud_timing_processor_s() - begin;
        if (status != THUD_OK && status != THUD_DIVERGED && err)
            *err = failure;
        if (status != THUD_OK && status != THUD_DIVERGED)
            judged = status;
        else if (first)
            judged = thud_bench_judge(work->bench, i, run, status, &failure, err);
        thud_run_free(run);
        if (judged != THUD_OK)
            return judged;
        warm_s = first ? seconds[0] : warm_s;
        timed += !first;
        again = (!first || status == THUD_OK) && warm_s <= again_below_s && timed < THUD_BENCH_REPEATS &&
                timed * warm_s < spend_s;
    }
    p->repeats = timed > 0 ? timed : 1;
    p->seconds = thud_timing_median(seconds, p->repeats, &p->spread);
    p->processor_s = thud_timing_median(processor, p->repeats, &unused);
    return THUD_OK;
}

/* A scene at an edge has none: not known. */
static enum thud_status move_inputs(const struct bench_work *work, struct thud_error *err)
{
    show_progress(work, "0.1 % of input", 0, 1);
    enum thud_status status = thud_bench_move(work->bench, work->jobs->scene, err);
    return status == THUD_DIVERGED || status == THUD_INPUT ? THUD_OK : status;
}

/* The first points of all curves before the second ones. */
enum thud_status thud_bench_jobs_run(struct thud_bench *bench, const struct thud_bench_jobs *jobs,
                                     struct thud_error *err)
{
    const struct bench_work work = {bench, jobs, thud_timing_now_s()};
    enum thud_status status = make_reference(&work, 0, err);
    if (status == THUD_OK)
        status = make_reference(&work, 1, err);
    if (status == THUD_OK)
        status = move_inputs(&work, err);
    for (int i; status == THUD_OK && (i = thud_bench_next(bench)) >= 0;) {
        char name[64], text[96];
        const double left = left_s(&work);
        thud_stepping_name(&bench->point[i].how, name, sizeof name);
        snprintf(text, sizeof text, left >= 1 ? "%s, about %.0f s left" : "%s", name, left);
        show_progress(&work, text, thud_bench_ended(bench), bench->npoints);
        if (!skip_point(&work, i))
            status = measure_point(&work, i, err);
    }
    return status;
}
