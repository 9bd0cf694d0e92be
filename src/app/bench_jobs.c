#include "app/bench_jobs.h"

#include <stdio.h>

#include "app/timing.h"

static enum thud_status reference(struct thud_bench *bench, const struct thud_bench_jobs *jobs, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (int which = 0; which < 2 && status == THUD_OK; which++) {
        struct thud_run *run = NULL;
        if (jobs->progress)
            jobs->progress(jobs->context, "reference", which, 2);
        status = thud_bench_reference_start(bench, which, &run, err);
        if (status == THUD_OK && run)
            status = thud_timing_advance(run, jobs, err);
        if (status == THUD_OK)
            status = thud_bench_reference_finish(bench, which, run, err);
        else
            thud_run_free(run);
    }
    return status;
}

/* One timed run of a point, by the wall clock and of processor time; *run is left to be judged and freed. */
static enum thud_status once(struct thud_bench *bench, int i, const struct thud_bench_jobs *jobs, struct thud_run **run,
                             double *seconds, double *processor_s, struct thud_error *err)
{
    double start = thud_timing_now_s(), begin = thud_timing_processor_s();
    enum thud_status status = thud_bench_start(bench, i, run, err);
    if (status == THUD_OK)
        status = thud_timing_advance(*run, jobs, err);
    *seconds = thud_timing_now_s() - start;
    *processor_s = thud_timing_processor_s() - begin;
    return status;
}

/* How long the point will take, by the one before it on its curve: steps cost by their number, tolerances grow slowly.
 */
static double expected_s(struct thud_bench *bench, int i)
{
    const struct thud_bench_point *p = thud_bench_point(bench, i), *before = i > 0 ? p - 1 : NULL;
    if (!before || before->curve != p->curve || before->seconds == 0)
        return 0;
    return before->seconds * (p->method->flags & THUD_METHOD_FIXED_STEP ? before->setting / p->setting : 1.8);
}

static enum thud_status point(struct thud_bench *bench, int i, const struct thud_bench_jobs *jobs,
                              struct thud_error *err)
{
    struct thud_bench_point *p = thud_bench_point(bench, i);
    double seconds[THUD_TIMINGS_MAX], processor[THUD_TIMINGS_MAX], warm, unused, expected = expected_s(bench, i);
    struct thud_run *run = NULL;
    struct thud_error failure = {0};
    if (jobs->patience_s > 0 && expected > jobs->patience_s) {
        p->state = THUD_BENCH_SKIPPED;
        snprintf(p->message, sizeof p->message, "would take about %.2g s", expected);
        p->seconds = expected; /* for the next one on the curve */
        return THUD_OK;
    }
    enum thud_status status = once(bench, i, jobs, &run, &warm, &processor[0], &failure);
    if (status != THUD_OK && status != THUD_DIVERGED) {
        thud_run_free(run);
        if (err)
            *err = failure;
        return status;
    }
    seconds[0] = warm;
    int n = warm > 1 || status != THUD_OK ? 1 : 0,
        most = jobs->repeats < THUD_TIMINGS_MAX ? jobs->repeats : THUD_TIMINGS_MAX;
    status = thud_bench_judge(bench, i, run, status, &failure, err);
    thud_run_free(run);
    for (double spent = 0; n < most && spent < 2 && status == THUD_OK && warm <= 1; n++, spent += warm) {
        status = once(bench, i, jobs, &run, &seconds[n], &processor[n], err);
        thud_run_free(run);
        if (status == THUD_DIVERGED)
            status = THUD_OK;
    }
    p->repeats = n > 0 ? n : 1;
    p->seconds = thud_timing_median(seconds, p->repeats, &p->spread);
    p->processor_s = thud_timing_median(processor, p->repeats, &unused);
    return status;
}

enum thud_status thud_bench_jobs_run(struct thud_bench *bench, const struct thud_bench_jobs *jobs,
                                     struct thud_error *err)
{
    enum thud_status status = reference(bench, jobs, err);
    int count = thud_bench_count(bench);
    for (int i = 0; i < count && status == THUD_OK; i++) {
        char name[64];
        thud_bench_curve_name(thud_bench_point(bench, i), name, sizeof name);
        if (jobs->progress)
            jobs->progress(jobs->context, name, i, count);
        status =
            thud_timing_cancelled(jobs) ? thud_error_set(err, THUD_CANCELLED, "stopped") : point(bench, i, jobs, err);
    }
    return status;
}
