/* Gauss-Legendre quadrature on [0, 1]: exact for polynomials up to degree 15. */
#pragma once

enum { THUD_QUADRATURE_POINTS = 8 };
extern const double thud_quadrature_node[THUD_QUADRATURE_POINTS];
extern const double thud_quadrature_weight[THUD_QUADRATURE_POINTS];

/* Gauss-Lobatto quadrature on [0, 1]: its ends, and points between them. Exact for polynomials of degrees below `order`
 * (Abramowitz and Stegun, 25.4.32): of 3, 4, 5, 7, 10 and 14 points in all. */
enum { THUD_LOBATTO_RULES = 6, THUD_LOBATTO_INNER = 12 };
extern const struct thud_lobatto {
    int inner, order;
    double end_weight;
    double node[THUD_LOBATTO_INNER], weight[THUD_LOBATTO_INNER]; /* (inner) */
} thud_lobatto[THUD_LOBATTO_RULES];
/* The rule of so many points in all, or the next. */
const struct thud_lobatto *thud_lobatto_of(int points);
