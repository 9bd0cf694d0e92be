#include "study/scene/spacing.h"

#include <math.h>

double thud_spacing_abs(double left_m, double right_m)
{
    return left_m + right_m;
}

double thud_spacing_srss(double left_m, double right_m)
{
    return hypot(left_m, right_m);
}

double thud_spacing_ddc(double left_m, double right_m, double correlation)
{
    double square = left_m * left_m + right_m * right_m - 2 * correlation * left_m * right_m;
    return square <= 0 ? 0 : sqrt(square); /* NaN stays */
}

double thud_spacing_correlation(double left_period_s, double left_damping, double right_period_s, double right_damping)
{
    double r = right_period_s / left_period_s, za = left_damping, zb = right_damping;
    if (!(left_period_s > 0 && right_period_s > 0) || !isfinite(r) || r == 0)
        return 0;
    double below = (1 - r * r) * (1 - r * r) + 4 * za * zb * (1 + r * r) * r + 4 * (za * za + zb * zb) * r * r;
    if (below == 0)
        return 1;
    return 8 * sqrt(za * zb) * (zb + za * r) * r * sqrt(r) / below;
}
