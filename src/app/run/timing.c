#include "app/run/timing.h"

#include <time.h>

#include "base/statistics.h"

static double read_s(clockid_t clock)
{
    struct timespec t;
    clock_gettime(clock, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

double thud_timing_now_s(void)
{
    return read_s(CLOCK_MONOTONIC);
}

double thud_timing_processor_s(void)
{
    return read_s(CLOCK_THREAD_CPUTIME_ID);
}

double thud_timing_median(double *seconds, int n, double *spread)
{
    thud_sort_numbers(seconds, (size_t)n);
    *spread = 0.5 * (seconds[(3 * n) / 4 < n ? (3 * n) / 4 : n - 1] - seconds[n / 4]);
    return n % 2 ? seconds[n / 2] : 0.5 * (seconds[n / 2 - 1] + seconds[n / 2]);
}
