/* Order statistics of a sample. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

/* Sorts n values in place, smallest first, NaN last; returns how many are numbers. */
size_t thud_sort_numbers(double *value, size_t n);

/* Returns the quantile p (0 to 1) of n sorted values, linear between order statistics: h = (n - 1) p (definition 7 of
 * Hyndman and Fan, The American Statistician 50 (1996) 361). `logarithms`: linear in the logarithms of the values,
 * which must be positive. NaN for n = 0. */
double thud_quantile(const double *sorted, size_t n, double p, bool logarithms);

/* Smallest number of independent motions with fractiles other than the median, and with a band of a fraction. */
enum { THUD_SHARES_LEAST = 3 };

/* Statistics of a quantity over a suite of ground motions. */
struct thud_fractiles {
    size_t n;                  /* number of values that are not NaN */
    double p16, median, p84;   /* of the logarithms where all values are positive; NaN for n = 0, and of few motions */
    double least, most, share; /* share: of the n values that are above `limit` */
    size_t below, above; /* number of values below and above it, by more than round-off; the others equal `limit` */
    size_t half, most84; /* of gaps: for how many motions the median and p84 are enough */
};
/* Computes them; sorts the values in place (NaN last). `draws`: number of values from independent motions. */
struct thud_fractiles thud_fractiles_of(double *value, size_t n, int draws, double limit);

/* Computes the 90 % confidence interval of a share, `count` of n trials: the score interval of Wilson, Journal of the
 * American Statistical Association 22 (1927) 209. `independent`: independent trials per trial (1; 1/2 for pairs). NaN
 * for n = 0. */
void thud_share_band(size_t count, size_t n, double independent, double *low, double *high);

/* Returns the smallest of n sorted values that is at least as large as a fraction p of them. *count: how many of them
 * are not larger. NaN and 0 for n = 0. */
double thud_enough(const double *sorted, size_t n, double p, size_t *count);
