/* Designs of experiments over the unit cube, and the fraction of the variance that each input explains. */
#pragma once

#include <stddef.h>

#include "base/random.h"
#include "base/status.h"

/* Latin hypercube (McKay, Beckman and Conover, Technometrics 21 (1979) 239): n points in d dimensions, u (n x d). Each
 * of the n equal strata of a dimension has one point, at a random place. Errors: THUD_MEMORY. */
enum thud_status thud_latin_hypercube(struct thud_random *random, size_t n, size_t d, double *u,
                                      struct thud_error *err);

/* Sobol's sequence (USSR Computational Mathematics and Mathematical Physics 7 (1967) 86) in Gray code order (Antonov
 * and Saleev 1979), with the direction numbers new-joe-kuo-6 of Joe and Kuo (SIAM Journal on Scientific Computing 30
 * (2008) 2635). Gives its first n points in d dimensions (up to THUD_SOBOL_DIMENSIONS), u (n x d). The error of a mean
 * falls nearly as 1/n. `random` gives every coordinate a digital shift, so that each seed has its own sample and no
 * point is on the edge. NULL: the sequence itself, 0, 1/2, 3/4, 1/4, ... */
enum { THUD_SOBOL_DIMENSIONS = 26 };
void thud_sobol_sequence(struct thud_random *random, size_t n, size_t d, double *u);

/* First-order and total Sobol indices of a quantity from n rows of two designs A and B and of A with column i from B:
 *
 *     S_i  = mean((f(B) - m) (f(AB_i) - f(A))) / V    Saltelli et al., Computer Physics Communications 181 (2010) 259
 *     ST_i = mean((f(A) - f(AB_i))^2) / (2 V)         Jansen, Computer Physics Communications 117 (1999) 35
 *
 * m and V: mean and variance of all f(A) and f(B); without m, the error of S_i would grow with m, since its factor has
 * the mean 0. `ab` is (d x n). Rows where any value is NaN are left out. Both are NaN where nothing varies. Errors:
 * THUD_MEMORY. */
enum thud_status thud_sobol_indices(const double *a, const double *b, const double *ab, size_t n, size_t d,
                                    double *first, double *total, struct thud_error *err);

/* 95 % intervals of both: percentiles of a bootstrap over the rows (Archer, Saltelli and Sobol, Journal of Statistical
 * Computation and Simulation 58 (1997) 99). `low` and `high`: (2 x d), of the first-order indices and then the total
 * ones; NaN with fewer than two whole rows. Errors: THUD_MEMORY. */
enum thud_status thud_sobol_intervals(const double *a, const double *b, const double *ab, size_t n, size_t d,
                                      struct thud_random *random, double *low, double *high, struct thud_error *err);
