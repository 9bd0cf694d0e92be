/* The points of a study made by several threads, handed over one by one in their order, whatever the number of threads.
 * Memory does not grow with the number of points. */
#pragma once

#include <stdatomic.h>

#include "study/suite/suite.h"
#include "study/sweep/sweep.h"

struct thud_sweep_jobs {
    const struct thud_sweep_plan *plan;
    long first, step, count;  /* points first, first + step, ... count of them */
    int threads;              /* 0: the processors that are online */
    const atomic_int *cancel; /* not NULL: the work stops when it becomes other than 0 */
    /* For thud_sweep_jobs_run alone: */
    void *context;
    /* Takes a finished point and frees it. Called from the calling thread. */
    enum thud_status (*take)(void *context, struct thud_sweep_point *point, struct thud_error *err);
    /* From time to time, from the calling thread; may be NULL. */
    void (*progress)(void *context, long done, long count, double elapsed_s);
};

/* Errors: THUD_CANCELLED; those of `take`, which end the work; those of groups; THUD_MEMORY. What was taken before
 * stays taken. A run without a result is no error (see struct thud_sweep_effort). */
enum thud_status thud_sweep_jobs_run(const struct thud_sweep_jobs *jobs, struct thud_error *err);
/* All points of a plan into the runs of a suite, which it makes; `threads` and `cancel` as above. Errors: also those of
 * thud_suite_create; *out is to be freed after one, too. */
enum thud_status thud_sweep_suite_run(const struct thud_sweep_plan *plan, int threads, const atomic_int *cancel,
                                      struct thud_suite **out, struct thud_error *err);

/* The same work for a caller that has more to do than to wait for it, as a screen has. The plan must stay until the
 * end. Errors: THUD_MEMORY. */
struct thud_sweep_work;
enum thud_status thud_sweep_work_start(const struct thud_sweep_jobs *jobs, struct thud_sweep_work **out,
                                       struct thud_error *err);
/* The next point in the order, for the caller to free; NULL where it is not finished within `wait_s`. *done: all were
 * taken. Errors: THUD_CANCELLED, those of groups, THUD_MEMORY: there will be no more. */
enum thud_status thud_sweep_work_take(struct thud_sweep_work *work, double wait_s, struct thud_sweep_point **point,
                                      bool *done, struct thud_error *err);
/* Stops what goes on and waits for it, which takes no longer than a slice of a run. NULL is allowed. */
void thud_sweep_work_end(struct thud_sweep_work *work);
