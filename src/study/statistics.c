#include "study/statistics.h"

#include <math.h>
#include <stdlib.h>

double thud_quantile(const double *sorted, size_t n, double p, bool logarithms)
{
    if (n == 0)
        return NAN;
    double at = p * (double)(n - 1);
    size_t below = at >= (double)(n - 1) ? n - 1 : (size_t)at;
    double part = at - (double)below, low = sorted[below];
    if (below + 1 >= n || part <= 0)
        return low;
    double high = sorted[below + 1];
    if (low == high)
        return low;
    return logarithms ? low * pow(high / low, part) : low + part * (high - low);
}

static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    if (isnan(x) || isnan(y))
        return isnan(x) - isnan(y);
    return (x > y) - (x < y);
}

struct thud_fractiles thud_fractiles_of(double *value, size_t n, double limit)
{
    struct thud_fractiles f = {.n = n, .least = NAN, .most = NAN, .share = NAN};
    size_t above = 0;
    if (n > 0)
        qsort(value, n, sizeof *value, by_value);
    while (f.n > 0 && isnan(value[f.n - 1]))
        f.n--;
    bool logarithms = f.n > 0 && value[0] > 0 && isfinite(value[f.n - 1]);
    f.p16 = thud_quantile(value, f.n, 0.16, logarithms);
    f.median = thud_quantile(value, f.n, 0.5, logarithms);
    f.p84 = thud_quantile(value, f.n, 0.84, logarithms);
    if (f.n == 0)
        return f;
    f.least = value[0];
    f.most = value[f.n - 1];
    for (size_t i = 0; i < f.n; i++)
        above += value[i] > limit;
    f.share = (double)above / (double)f.n;
    return f;
}
