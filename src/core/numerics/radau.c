/* The points of Radau IIA, from which the collocation of contact forces takes its stages (Hairer and Wanner 1996, IV.5):
 * of all quadratures with the right end among its n points that of the highest order, 2 n - 1. On [-1, 1] they are 1 and
 * the roots of P_n - P_(n-1) but for sign. */
#include "core/numerics/radau.h"

#include <math.h>

/* P_n - P_(n-1) of Legendre at x and its derivative: its roots but x = 1 are the left Radau points mirrored. */
static double radau_polynomial(int n, double x, double *slope)
{
    double p0 = 1, p1 = x, d0 = 0, d1 = 1;
    for (int k = 2; k <= n; k++) {
        double p2 = ((2 * k - 1) * x * p1 - (k - 1) * p0) / k;
        double d2 = ((2 * k - 1) * (p1 + x * d1) - (k - 1) * d0) / k;
        p0 = p1;
        p1 = p2;
        d0 = d1;
        d1 = d2;
    }
    *slope = d1 - d0;
    return p1 - p0;
}

void thud_radau_nodes(int n, double *node)
{
    node[n - 1] = 1;
    /* Newton with the roots already found divided out */
    for (int found = 0; found < n - 1; found++) {
        double x = 0.999;
        for (int i = 0; i < 200; i++) {
            double slope, p = radau_polynomial(n, x, &slope);
            double deflate = 1 / (x - 1);
            for (int k = 0; k < found; k++)
                deflate += 1 / (x - (2 * node[n - 2 - k] - 1));
            double dx = p / (slope - p * deflate);
            x -= dx;
            if (fabs(dx) < 1e-16)
                break;
        }
        node[n - 2 - found] = 0.5 * (1 + x);
    }
}

void thud_lagrange_coefficients(int n, const double *node, double *out)
{
    for (int i = 0; i < n; i++) {
        double c[16] = {1};
        int degree = 0;
        double scale = 1;
        for (int k = 0; k < n; k++) {
            if (k == i)
                continue;
            degree++;
            for (int m = degree; m >= 0; m--)
                c[m] = (m > 0 ? c[m - 1] : 0) - node[k] * c[m];
            scale *= node[i] - node[k];
        }
        for (int m = 0; m < n; m++)
            out[m * n + i] = c[m] / scale;
    }
}
