/* The points of a study made by several threads, handed over one by one in their order, whatever the number of threads.
 * Memory does not grow with the number of points. */
#ifndef THUD_APP_SWEEP_JOBS_H
#define THUD_APP_SWEEP_JOBS_H

#include <signal.h>

#include "study/sweep.h"

struct thud_sweep_jobs {
    const struct thud_sweep_plan *plan;
    long first, step, count;             /* points first, first + step, ... count of them */
    int threads;                         /* 0: the processors that are online */
    const volatile sig_atomic_t *cancel; /* not NULL: the work stops when it becomes other than 0 */
    void *context;
    /* Takes a finished point and frees it. Called from the calling thread. */
    enum thud_status (*take)(void *context, struct thud_sweep_point *point, struct thud_error *err);
    /* From time to time, from the calling thread; may be NULL. */
    void (*progress)(void *context, long done, long count, double elapsed_s);
};

/* Errors: THUD_CANCELLED; those of `take`, which end the work; those of groups; THUD_MEMORY. What was taken before
 * stays taken. A run without an answer is no error (see struct thud_sweep_effort). */
enum thud_status thud_sweep_jobs_run(const struct thud_sweep_jobs *jobs, struct thud_error *err);

#endif
