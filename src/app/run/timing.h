/* What runs are timed with. */
#pragma once

#include <stdatomic.h>

#include "core/run/run.h"

double thud_timing_now_s(void);
/* Of this thread: what else the machine does stays out. */
double thud_timing_processor_s(void);
/* Advances to the end, or until `cancel` (may be NULL) becomes other than 0. Errors: THUD_CANCELLED, those of
 * thud_run_advance. */
enum thud_status thud_timing_advance(struct thud_run *run, const atomic_int *cancel, struct thud_error *err);
/* Sorts `seconds` (n >= 1); the median, and half the range of the middle half. */
double thud_timing_median(double *seconds, int n, double *spread);
