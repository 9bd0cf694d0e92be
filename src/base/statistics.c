#include "base/statistics.h"

#include <math.h>
#include <stdlib.h>

static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    if (isnan(x) || isnan(y))
        return isnan(x) - isnan(y);
    return (x > y) - (x < y);
}

size_t thud_sort_numbers(double *value, size_t n)
{
    if (n > 0)
        qsort(value, n, sizeof *value, by_value);
    while (n > 0 && isnan(value[n - 1]))
        n--;
    return n;
}

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

struct thud_fractiles thud_fractiles_of(double *value, size_t n, int draws, double limit)
{
    static const double equal = 1e-9; /* relative: values nearer to the limit are neither below nor above */
    struct thud_fractiles f = {.n = thud_sort_numbers(value, n), .least = NAN, .most = NAN, .share = NAN};
    bool logarithms = f.n > 0 && value[0] > 0 && isfinite(value[f.n - 1]);
    const size_t enough = draws >= THUD_SHARES_LEAST ? f.n : 0;
    f.p16 = thud_quantile(value, enough, 0.16, logarithms);
    f.median = thud_quantile(value, f.n, 0.5, logarithms);
    f.p84 = thud_quantile(value, enough, 0.84, logarithms);
    if (f.n == 0)
        return f;
    f.least = value[0];
    f.most = value[f.n - 1];
    for (size_t i = 0; i < f.n; i++) {
        f.below += value[i] < limit - equal * fabs(limit);
        f.above += value[i] > limit + equal * fabs(limit);
    }
    f.share = (double)f.above / (double)f.n;
    return f;
}

void thud_share_band(size_t count, size_t n, double independent, double *low, double *high)
{
    static const double z = 1.6448536269514722; /* of 90 % */
    *low = *high = NAN;
    if (n == 0)
        return;
    double m = (double)n * independent, share = (double)count / (double)n, scale = 1 + z * z / m;
    double centre = (share + z * z / (2 * m)) / scale,
           half = z * sqrt(share * (1 - share) / m + z * z / (4 * m * m)) / scale;
    *low = fmax(0, centre - half);
    *high = fmin(1, centre + half);
}

double thud_enough(const double *sorted, size_t n, double p, size_t *count)
{
    static const double rounding = 1e-9; /* 0.84 x 25 is 21 */
    size_t k = (size_t)ceil(p * (double)n - rounding);
    k = k < 1 ? 1 : k > n ? n : k;
    *count = n > 0 ? k : 0;
    while (*count > 0 && *count < n && sorted[*count] == sorted[k - 1])
        ++*count;
    return n > 0 ? sorted[k - 1] : NAN;
}
