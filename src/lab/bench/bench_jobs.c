#include "lab/bench/bench_jobs.h"

#include <math.h>
#include <stdio.h>

#include "app/run/timing.h"

enum { SLICE = 2000 };
/* A point is timed again while one run of it takes no longer than the first, and all of them no longer than the second. */
static const double again_below_s = 1, spend_s = 2;

/* Reference first, then every point, the first ones of all curves before the second ones; what is done stays when it is
 * stopped. */
struct bench_work {
    struct thud_bench *bench;
    struct thud_bench_jobs jobs;
    int reference;                          /* the one in the making; 2: both are there; 3: inputs were changed, too */
    int at;                                 /* the point in the making; -1: none */
    struct thud_run *run;                   /* in hand; NULL: none */
    bool judged;                            /* the point has its verdict, the run in hand is for its time */
    double elapsed_s, processor_s;          /* of the run in hand */
    double warm_s, spent_s;                 /* of the first run of the point; of the timed ones, about */
    double all_s;                           /* of all runs */
    int timed;                              /* runs whose time is known */
    double seconds[THUD_TIMINGS_MAX + 1];   /* (timed) by the wall clock */
    double processor[THUD_TIMINGS_MAX + 1]; /* (timed) */
};

static void let_go(struct bench_work *work)
{
    thud_run_free(work->run);
    work->run = NULL;
}

static void tell(const struct bench_work *work, const char *what, int done, int count)
{
    if (work->jobs.progress)
        work->jobs.progress(work->jobs.context, what, done, count);
}

/* A slice of the run in hand; only the time spent in it is counted. */
static enum thud_status advance_run(struct bench_work *work, long budget, bool *done, struct thud_error *err)
{
    double start = thud_timing_now_s(), begin = thud_timing_processor_s();
    enum thud_status status = thud_run_advance(work->run, budget, done, err);
    double took = thud_timing_now_s() - start;
    work->elapsed_s += took;
    work->all_s += took;
    work->processor_s += thud_timing_processor_s() - begin;
    return status;
}

static enum thud_status advance_reference(struct bench_work *work, long budget, struct thud_error *err)
{
    bool done = false;
    enum thud_status status = THUD_OK;
    if (!work->run) {
        tell(work, "reference", work->reference, 2);
        status = thud_bench_reference_start(work->bench, work->reference, &work->run, err);
    }
    if (status == THUD_OK && work->run)
        status = advance_run(work, budget, &done, err);
    if (status != THUD_OK || (!done && work->run))
        return status;
    struct thud_run *run = work->run;
    work->run = NULL;
    return thud_bench_reference_finish(work->bench, work->reference++, run, err);
}

/* Of the time of a run over that of the one before it on its curve: steps cost by their number, tolerances little. */
static double growth(const struct thud_bench_point *p, const struct thud_bench_point *before)
{
    return p->method->flags & THUD_METHOD_FIXED_STEP ? before->setting / p->setting : 1.8;
}

/* How long the point will take, by the one before it; 0: not known. */
static double expected_s(struct thud_bench *bench, int i)
{
    const struct thud_bench_point *p = thud_bench_point(bench, i), *before = i > 0 ? p - 1 : NULL;
    return before && before->curve == p->curve ? before->seconds * growth(p, before) : 0;
}

/* A point with its timings; one that takes long is timed once. */
static double with_timings_s(const struct thud_bench_jobs *jobs, double run_s)
{
    return run_s + (run_s > again_below_s ? 0 : fmin(spend_s, jobs->repeats * run_s));
}

static bool is_too_long(const struct bench_work *work, double run_s, double spent_s)
{
    const struct thud_bench_jobs *jobs = &work->jobs;
    return (jobs->patience_s > 0 && run_s > jobs->patience_s) ||
           (jobs->budget_s > 0 && spent_s + with_timings_s(jobs, run_s) > jobs->budget_s);
}

/* How long the points that wait will take, as far as their curves have begun. */
static double left_s(const struct bench_work *work)
{
    double sum = 0, run_s = 0;
    for (int i = 0; i < thud_bench_count(work->bench); i++) {
        const struct thud_bench_point *p = thud_bench_point(work->bench, i);
        run_s = p->state != THUD_BENCH_WAITING        ? p->seconds
                : i > 0 && p->curve == (p - 1)->curve ? run_s * growth(p, p - 1)
                                                      : 0;
        if (p->state == THUD_BENCH_WAITING && !is_too_long(work, run_s, work->all_s + sum))
            sum += with_timings_s(&work->jobs, run_s);
    }
    return sum;
}

static bool too_long(struct bench_work *work)
{
    struct thud_bench_point *p = thud_bench_point(work->bench, work->at);
    double expected = expected_s(work->bench, work->at);
    if (!is_too_long(work, expected, work->all_s))
        return false;
    p->state = THUD_BENCH_SKIPPED;
    if (expected > 0)
        snprintf(p->message, sizeof p->message, "would take about %.2g s", expected);
    else
        snprintf(p->message, sizeof p->message, "left out: %.2g s are spent", work->all_s);
    p->seconds = expected; /* for the next one on the curve */
    return true;
}

static void next_point(struct bench_work *work)
{
    work->at = -1;
    work->timed = 0;
    work->spent_s = 0;
    work->judged = false;
}

static void finish_point(struct bench_work *work)
{
    struct thud_bench_point *p = thud_bench_point(work->bench, work->at);
    double unused;
    p->repeats = work->timed > 0 ? work->timed : 1;
    p->seconds = thud_timing_median(work->seconds, p->repeats, &p->spread);
    p->processor_s = thud_timing_median(work->processor, p->repeats, &unused);
    next_point(work);
}

/* The first run of a point warms up and is judged, the others are for its time; it alone counts where it takes long. */
static enum thud_status finish_run(struct bench_work *work, enum thud_status status, const struct thud_error *failure,
                                   struct thud_error *err)
{
    int most = work->jobs.repeats < THUD_TIMINGS_MAX ? work->jobs.repeats : THUD_TIMINGS_MAX;
    bool first = !work->judged, failed = status != THUD_OK;
    enum thud_status verdict = THUD_OK;
    work->seconds[work->timed] = work->elapsed_s;
    work->processor[work->timed] = work->processor_s;
    if (first) {
        verdict = thud_bench_judge(work->bench, work->at, work->run, status, failure, err);
        work->warm_s = work->elapsed_s;
        work->judged = true;
    } else {
        work->timed++;
        work->spent_s += work->warm_s;
    }
    let_go(work);
    if (verdict != THUD_OK)
        return verdict;
    if ((first && failed) || work->warm_s > again_below_s || work->timed >= most || work->spent_s >= spend_s)
        finish_point(work);
    return THUD_OK;
}

static enum thud_status advance_point(struct bench_work *work, long budget, struct thud_error *err)
{
    struct thud_error failure = {0};
    enum thud_status status = THUD_OK;
    bool done = false;
    if (!work->run) {
        if (!work->judged) {
            char name[64], text[96];
            work->at = thud_bench_next(work->bench);
            const double left = left_s(work);
            thud_bench_curve_name(thud_bench_point(work->bench, work->at), name, sizeof name);
            snprintf(text, sizeof text, left >= 1 ? "%s, about %.0f s left" : "%s", name, left);
            tell(work, text, thud_bench_ended(work->bench), thud_bench_count(work->bench));
            if (too_long(work)) {
                next_point(work);
                return THUD_OK;
            }
        }
        double start = thud_timing_now_s(), begin = thud_timing_processor_s();
        status = thud_bench_start(work->bench, work->at, &work->run, &failure);
        work->elapsed_s = thud_timing_now_s() - start;
        work->processor_s = thud_timing_processor_s() - begin;
    }
    if (status == THUD_OK)
        status = advance_run(work, budget, &done, &failure);
    if (status == THUD_OK && !done)
        return THUD_OK;
    if (status == THUD_OK || status == THUD_DIVERGED)
        return finish_run(work, status, &failure, err);
    if (err)
        *err = failure;
    return status;
}

static enum thud_status move_inputs(struct bench_work *work, struct thud_error *err)
{
    const double start = thud_timing_now_s();
    tell(work, "0.1 % of input", 0, 1);
    enum thud_status status = thud_bench_move(work->bench, work->jobs.scene, err);
    work->reference++;
    work->all_s += thud_timing_now_s() - start;
    return status == THUD_DIVERGED || status == THUD_INPUT ? THUD_OK : status; /* a scene at an edge: not known */
}

static enum thud_status advance_bench(struct bench_work *work, long budget, bool *done, struct thud_error *err)
{
    enum thud_status status;
    *done = false;
    if (work->jobs.cancel && *work->jobs.cancel)
        status = thud_error_set(err, THUD_CANCELLED, "stopped");
    else if (work->reference < 2)
        status = advance_reference(work, budget, err);
    else if (work->reference == 2 && work->jobs.scene)
        status = move_inputs(work, err);
    else if (work->judged || thud_bench_next(work->bench) >= 0)
        status = advance_point(work, budget, err);
    else
        status = THUD_OK;
    *done = work->reference >= (work->jobs.scene ? 3 : 2) && !work->judged && thud_bench_next(work->bench) < 0;
    if (status != THUD_OK)
        let_go(work);
    return status;
}

enum thud_status thud_bench_jobs_run(struct thud_bench *bench, const struct thud_bench_jobs *jobs,
                                     struct thud_error *err)
{
    struct bench_work work = {.bench = bench, .jobs = *jobs, .at = -1};
    enum thud_status status = THUD_OK;
    for (bool done = false; status == THUD_OK && !done;)
        status = advance_bench(&work, SLICE, &done, err);
    return status;
}
