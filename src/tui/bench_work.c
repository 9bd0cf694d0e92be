#include <stdio.h>
#include <string.h>

#include "tui/bench_work.h"

enum { SEGMENTS = 300 };
static const double patience_s = 10.0, again_below_s = 0.2;

void thud_bench_work_stop(struct thud_bench_work *work)
{
    thud_run_free(work->run);
    work->run = NULL;
    work->running = false;
}

void thud_bench_work_clear(struct thud_bench_work *work)
{
    thud_bench_work_stop(work);
    if (work->bench)
        thud_bench_free(work->bench);
    thud_record_free(work->record);
    memset(work, 0, sizeof *work);
}

enum thud_status thud_bench_work_start(struct thud_bench_work *work, const struct thud_scene *scene,
                                       const struct thud_record *record, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    thud_bench_work_clear(work);
    work->scene = *scene;
    if (record)
        status = thud_record_create(record->a_mps2, record->samples, record->dt_s, &work->record, err);
    if (status == THUD_OK)
        status = thud_bench_create(&work->scene, work->record, false, &work->bench, err);
    if (status != THUD_OK) {
        thud_bench_work_clear(work);
        return status;
    }
    work->running = true;
    return THUD_OK;
}

/* A slice of the run in hand; its time is counted. */
static enum thud_status advance_run(struct thud_bench_work *work, struct thud_backend *clock, bool *done,
                                    struct thud_error *err)
{
    double start = clock->now(clock);
    enum thud_status status = thud_run_advance(work->run, SEGMENTS, done, err);
    work->elapsed_s += clock->now(clock) - start;
    return status;
}

static enum thud_status advance_reference(struct thud_bench_work *work, struct thud_backend *clock,
                                          struct thud_error *err)
{
    bool done = false;
    enum thud_status status = THUD_OK;
    if (!work->run) {
        status = thud_bench_reference_start(work->bench, work->reference, &work->run, err);
        if (status != THUD_OK)
            return status;
    }
    if (work->run)
        status = advance_run(work, clock, &done, err);
    if (status == THUD_OK && (done || !work->run)) {
        status = thud_bench_reference_finish(work->bench, work->reference++, work->run, err);
        work->run = NULL;
    }
    return status;
}

static void next_point(struct thud_bench_work *work)
{
    struct thud_bench_point *point = thud_bench_point(work->bench, work->at);
    if (point->state != THUD_BENCH_SKIPPED && work->timed > 0) {
        double least = work->seconds[0], most = work->seconds[0], sum = 0.0;
        for (int i = 0; i < work->timed; i++) {
            least = work->seconds[i] < least ? work->seconds[i] : least;
            most = work->seconds[i] > most ? work->seconds[i] : most;
            sum += work->seconds[i];
        }
        /* of three the one in the middle */
        point->seconds = work->timed == 3 ? sum - least - most : sum / work->timed;
        point->spread = 0.5 * (most - least);
        point->repeats = work->timed;
    }
    work->at++;
    work->done++;
    work->timed = 0;
    work->judged = false;
}

/* The point before on the curve tells what this one will take. */
static bool too_long(struct thud_bench_work *work)
{
    struct thud_bench_point *point = thud_bench_point(work->bench, work->at);
    const struct thud_bench_point *before = work->at > 0 ? thud_bench_point(work->bench, work->at - 1) : NULL;
    if (!before || before->curve != point->curve || !(before->seconds > 0.0))
        return false;
    bool fixed = point->method->flags & THUD_METHOD_FIXED_STEP;
    double expected = before->seconds * (fixed ? before->setting / point->setting : 1.8);
    if (expected <= patience_s)
        return false;
    point->state = THUD_BENCH_SKIPPED;
    point->seconds = expected;
    snprintf(point->message, sizeof point->message, "would take about %.2g s", expected);
    return true;
}

/* The first run of a point warms up and is judged, the others are for its time. */
static enum thud_status finish_run(struct thud_bench_work *work, enum thud_status status,
                                   const struct thud_error *failure, struct thud_error *err)
{
    bool first = !work->judged, slow = work->elapsed_s > again_below_s;
    enum thud_status verdict = THUD_OK;
    if (first)
        verdict = thud_bench_judge(work->bench, work->at, work->run, status, failure, err);
    thud_run_free(work->run);
    work->run = NULL;
    work->judged = true;
    if (!first || slow || status != THUD_OK)
        work->seconds[work->timed++] = work->elapsed_s;
    if (verdict == THUD_OK && (slow || status != THUD_OK || work->timed == THUD_BENCH_REPEATS))
        next_point(work);
    return verdict;
}

static enum thud_status advance_point(struct thud_bench_work *work, struct thud_backend *clock, struct thud_error *err)
{
    struct thud_error failure = {0};
    enum thud_status status = THUD_OK;
    bool done = false;
    if (!work->run) {
        if (!work->judged && too_long(work)) {
            next_point(work);
            return THUD_OK;
        }
        double start = clock->now(clock);
        status = thud_bench_start(work->bench, work->at, &work->run, &failure);
        work->elapsed_s = clock->now(clock) - start;
    }
    if (status == THUD_OK)
        status = advance_run(work, clock, &done, &failure);
    if (status == THUD_OK && !done)
        return THUD_OK;
    if (status == THUD_OK || status == THUD_DIVERGED)
        return finish_run(work, status, &failure, err);
    *err = failure;
    return status;
}

enum thud_status thud_bench_work_advance(struct thud_bench_work *work, struct thud_backend *clock,
                                         struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    if (work->reference < 2) {
        status = advance_reference(work, clock, err);
    } else if (work->at < thud_bench_count(work->bench)) {
        status = advance_point(work, clock, err);
    } else {
        work->complete = true;
        thud_bench_work_stop(work);
    }
    if (status != THUD_OK)
        thud_bench_work_stop(work);
    return status;
}
