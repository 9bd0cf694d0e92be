/* What runs are timed with. */
#pragma once

double thud_timing_now_s(void);
/* Of this thread: what else the machine does stays out. */
double thud_timing_processor_s(void);
/* Sorts `seconds` (n >= 1); the median, and half the range of the middle half. */
double thud_timing_median(double *seconds, int n, double *spread);
