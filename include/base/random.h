/* Seeded generator of random numbers, and the normal distribution. */
#pragma once

#include <stddef.h>
#include <stdint.h>

/* SplitMix64 (Steele, Lea and Flood, OOPSLA 2014): 64 bits of state, any seed is good. Each call gives the next number
 * of the sequence, the same on every machine. */
struct thud_random {
    uint64_t state;
};
uint64_t thud_random_next(struct thud_random *random);
/* Returns a number in [0, 1) of 53 bits. */
double thud_random_unit(struct thud_random *random);
/* Returns an integer in 0 .. n - 1, 0 < n < 2^53, uniform to n/2^53. */
size_t thud_random_below(struct thud_random *random, size_t n);

/* Distribution function of the standard normal distribution, and its inverse (0 < p < 1; to 1e-14). */
double thud_normal_cdf(double x);
double thud_normal_quantile(double p);
/* Returns the probability that chi-square of this many degrees of freedom (> 0) exceeds the value. */
double thud_chi_square_tail(double x, int free);
