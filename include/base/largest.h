/* Return the larger and the smaller of two numbers; NaN if either is NaN, so that NaN propagates. What is compared
 * first is an instruction, not a branch, and gives b where a comparison fails. */
#pragma once

#include <math.h>

static inline double thud_larger(double a, double b)
{
    const double most = a > b ? a : b;
    return __builtin_expect(a != a, 0) ? a : most;
}

static inline double thud_smaller(double a, double b)
{
    const double least = a < b ? a : b;
    return __builtin_expect(a != a, 0) ? a : least;
}

/* Returns the largest of n > 0 numbers; four partial maxima break the dependency chain. */
static inline double thud_largest(const double *x, int n)
{
    double most[4] = {x[0], x[0], x[0], x[0]};
    int i = 1;
    for (; i + 4 <= n; i += 4)
        for (int k = 0; k < 4; k++)
            most[k] = x[i + k] > most[k] ? x[i + k] : most[k];
    for (; i < n; i++)
        most[0] = x[i] > most[0] ? x[i] : most[0];
    double a = most[0] > most[1] ? most[0] : most[1], b = most[2] > most[3] ? most[2] : most[3];
    return a > b ? a : b;
}

/* Returns the largest absolute value of n numbers. */
static inline double thud_largest_size(const double *x, int n)
{
    double most[4] = {0};
    int i = 0;
    for (; i + 4 <= n; i += 4)
        for (int k = 0; k < 4; k++) {
            double size = fabs(x[i + k]);
            most[k] = size > most[k] ? size : most[k];
        }
    for (; i < n; i++)
        most[0] = fabs(x[i]) > most[0] ? fabs(x[i]) : most[0];
    double a = most[0] > most[1] ? most[0] : most[1], b = most[2] > most[3] ? most[2] : most[3];
    return a > b ? a : b;
}
