/* What runs are timed with. */
#ifndef THUD_APP_TIMING_H
#define THUD_APP_TIMING_H

#include <stdbool.h>

#include "app/bench_jobs.h"

double thud_timing_now_s(void);
/* Of this thread: what else the machine does stays out. */
double thud_timing_processor_s(void);
bool thud_timing_cancelled(const struct thud_bench_jobs *jobs);
/* Advances to the end. Errors: THUD_CANCELLED, those of thud_run_advance. */
enum thud_status thud_timing_advance(struct thud_run *run, const struct thud_bench_jobs *jobs, struct thud_error *err);
/* Sorts `seconds` (n >= 1); the median, and half the range of the middle half. */
double thud_timing_median(double *seconds, int n, double *spread);

#endif
