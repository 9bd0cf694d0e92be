/* Radau points (right end included) and the polynomials through them, and dense linear systems: what the collocation of
 * contact forces is made of. */
#pragma once

/* Points of the n-stage Radau IIA method on (0, 1], rising; node[n - 1] = 1. 1 <= n <= 10. */
void thud_radau_nodes(int n, double *node);

/* Monomial coefficients of the Lagrange polynomials of these points, out (n x n): out[m * n + i] belongs to s^m of
 * polynomial i. */
void thud_lagrange_coefficients(int n, const double *node, double *out);
