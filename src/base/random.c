#include "base/random.h"

#include <math.h>

uint64_t thud_random_next(struct thud_random *random)
{
    uint64_t z = random->state += 0x9e3779b97f4a7c15ULL;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
}

double thud_random_unit(struct thud_random *random)
{
    return (double)(thud_random_next(random) >> 11) * 0x1p-53;
}

size_t thud_random_below(struct thud_random *random, size_t n)
{
    return (size_t)(thud_random_unit(random) * (double)n);
}

double thud_normal_cdf(double x)
{
    return 0.5 * erfc(-x * 0.70710678118654752440);
}

double thud_normal_quantile(double p)
{
    /* bisection to a part in 1e3, then Newton on the logarithm of the smaller tail, which is concave: it converges from
     * there to rounding */
    double tail = p < 0.5 ? p : 1 - p, low = 0, high = 40;
    for (int i = 0; i < 16; i++) {
        double mid = 0.5 * (low + high);
        *(thud_normal_cdf(-mid) > tail ? &low : &high) = mid;
    }
    double x = 0.5 * (low + high);
    for (int i = 0; i < 6; i++) {
        double q = thud_normal_cdf(-x), density = 0.39894228040143267794 * exp(-0.5 * x * x);
        x += q / density * log(q / tail);
    }
    return p < 0.5 ? -x : x;
}

double thud_chi_square_tail(double x, int free)
{
    /* Abramowitz and Stegun 26.4.4 and 26.4.5: Q(x | n + 2) = Q(x | n) + (x / 2)^(n / 2) exp(-x / 2) / Gamma(n / 2 +
     * 1); the logarithm of the term goes from n to n + 2, for lgamma writes a global */
    if (!(x > 0))
        return 1;
    static const double four_over_pi = 1.27323954473516268615; /* 1 / Gamma(3 / 2)^2 */
    double half = 0.5 * x, tail = free % 2 ? erfc(sqrt(half)) : 0;
    double term = free % 2 ? 0.5 * log(four_over_pi * half) - half : -half;
    for (int n = free % 2; n < free; n += 2) {
        tail += exp(term);
        term += log(half / (0.5 * n + 1));
    }
    return fmin(1, tail);
}
