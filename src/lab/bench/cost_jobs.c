#include "lab/bench/cost_jobs.h"

#include <math.h>
#include <stdio.h>

#include "app/run/timing.h"

/* One timed setup and run of a size. `judge`: also its verdict. */
static enum thud_status once(struct thud_cost *cost, int i, const struct thud_bench_jobs *jobs, bool judge,
                             double *setup_s, double *run_s, struct thud_error *err)
{
    struct thud_model *model = NULL;
    struct thud_run *run = NULL;
    struct thud_error failure = {0};
    double start = thud_timing_processor_s();
    enum thud_status status = thud_cost_setup(cost, i, &model, &failure);
    double ready = thud_timing_processor_s();
    if (status == THUD_OK)
        status = thud_cost_start(cost, i, model, &run, &failure);
    if (status == THUD_OK)
        status = thud_timing_advance(run, jobs->cancel, &failure);
    *run_s = thud_timing_processor_s() - ready;
    *setup_s = ready - start;
    if (judge && run && (status == THUD_OK || status == THUD_DIVERGED))
        thud_cost_judge(cost, i, run, status, &failure);
    thud_run_free(run);
    thud_model_free(model);
    if (status == THUD_DIVERGED)
        return THUD_OK;
    if (status != THUD_OK && err)
        *err = failure;
    return status;
}

/* By the two sizes before; what comes after a skipped one takes longer still. */
static bool too_long(struct thud_cost *cost, int i, const struct thud_bench_jobs *jobs)
{
    struct thud_cost_point *p = thud_cost_point(cost, i);
    if (i < 2 || !(jobs->patience_s > 0))
        return false;
    double expected = p[-1].seconds * fmax(1, p[-2].seconds > 0 ? p[-1].seconds / p[-2].seconds : 1);
    if (expected <= jobs->patience_s)
        return false;
    p->state = THUD_COST_SKIPPED;
    p->seconds = expected;
    snprintf(p->message, sizeof p->message, "would take about %.2g s", expected);
    return true;
}

/* The first time warms up; it alone counts where it takes long. */
static enum thud_status point(struct thud_cost *cost, int i, const struct thud_bench_jobs *jobs, struct thud_error *err)
{
    struct thud_cost_point *p = thud_cost_point(cost, i);
    double setup[THUD_TIMINGS_MAX], run[THUD_TIMINGS_MAX], unused;
    int n = 0, most = jobs->repeats < THUD_TIMINGS_MAX ? jobs->repeats : THUD_TIMINGS_MAX;
    if (too_long(cost, i, jobs))
        return THUD_OK;
    enum thud_status status = once(cost, i, jobs, true, &setup[0], &run[0], err);
    double each = setup[0] + run[0];
    for (double spent = 0; n < most && spent < 2 && each < 1 && status == THUD_OK; n++, spent += each)
        status = once(cost, i, jobs, false, &setup[n], &run[n], err);
    if (status != THUD_OK) { /* half measured is not done */
        p->state = THUD_COST_WAITING;
        return status;
    }
    p->repeats = n > 0 ? n : 1;
    p->seconds = thud_timing_median(run, p->repeats, &p->spread);
    p->setup_s = thud_timing_median(setup, p->repeats, &unused);
    return THUD_OK;
}

enum thud_status thud_cost_jobs_run(struct thud_cost *cost, const struct thud_bench_jobs *jobs, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    int count = thud_cost_count(cost);
    for (int i = 0; i < count && status == THUD_OK; i++) {
        if (jobs->progress)
            jobs->progress(jobs->context, thud_cost_axis_info(thud_cost_axis(cost))->name, i, count);
        if (jobs->cancel && *jobs->cancel)
            return thud_error_set(err, THUD_CANCELLED, "stopped");
        status = point(cost, i, jobs, err);
    }
    return status;
}
