/* Runs that are computed side by side, on threads where there are any. */
#pragma once

#include "core/run/baseline.h"
#include "core/run/run.h"

enum { THUD_LIVE_JOBS = 4 };

/* One of them. Until it is taken back nobody else may touch it. */
struct thud_live_job {
    struct thud_run *run; /* or */
    struct thud_baseline_motion *baseline;
};

struct thud_live_work;

/* Begins `n` jobs, the first first. `threads`: 0 one a processor, negative none. Where none can be started
 * thud_live_work_wait computes. Errors: THUD_MEMORY. */
enum thud_status thud_live_work_start(const struct thud_live_job *job, int n, int threads, struct thud_live_work **out,
                                      struct thud_error *err);
/* A job that has ended since the last call, with its status; -1: none has within about `wait_s`. *left: how many have
 * not been taken back. */
int thud_live_work_take(struct thud_live_work *work, double wait_s, int *left, enum thud_status *status,
                        struct thud_error *err);
/* Time that the run of job `index` has come to, s; also while it goes on. */
double thud_live_work_time(struct thud_live_work *work, int index);
/* Stops within about a millisecond, and frees; NULL is allowed. The runs stay, as far as they came. */
void thud_live_work_end(struct thud_live_work *work);
