/* Polynomials c[0] + c[1] s + ... on 0 <= s <= 1: first crossings and largest values, found with bounds, so that
 * a grazing or a double root inside a step is not missed. */
#pragma once

/* p(s); `n` is the number of coefficients. */
double thud_poly_value(const double *c, int n, double s);
/* p, p', p'' at s. */
void thud_poly_value3(const double *c, int n, double s, double out[3]);

/* Bounds on [0, 1] of how far p may come from its start, and of how far p' may be from its value there: *slope. */
double thud_poly_move(const double *c, int n, double *slope);

/* Returns the first s in [0, s_end] after which sign * p is above 0; INFINITY if there is none. The lowest `suppressed`
 * coefficients are taken as exactly 0 (the event that has just been handled), so that only what comes after it is
 * found. Values below `noise` are not above 0. */
double thud_poly_first_above(const double *c, int n, double s_end, double sign, int suppressed, double noise);

/* Part of [0, s_end] in which p is above 0, as a length. */
double thud_poly_above(const double *c, int n, double s_end);

/* Largest |p| on [0, s_end] if it is above `least`, else `least`; *where (left alone in that case) gets its s. */
double thud_poly_peak(const double *c, int n, double s_end, double least, double *where);

/* Coefficients of the Lagrange polynomials of n nodes, at most 16, out (n x n): out[m * n + i] belongs to s^m of polynomial
 * i. */
void thud_lagrange_coefficients(int n, const double *node, double *out);
