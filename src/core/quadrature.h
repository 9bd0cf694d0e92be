/* Gauss-Legendre quadrature on [0, 1]: exact for polynomials up to degree 15. */
#ifndef THUD_CORE_QUADRATURE_H
#define THUD_CORE_QUADRATURE_H

enum { THUD_QUADRATURE_POINTS = 8 };
extern const double thud_quadrature_node[THUD_QUADRATURE_POINTS];
extern const double thud_quadrature_weight[THUD_QUADRATURE_POINTS];

#endif
