/* Two numbers that every processor of the kind works on at once. Left to themselves, compilers may not change the order
 * of a sum, and spend more on shuffling short rows than on summing them. */
#ifndef THUD_CORE_DOUBLE_PAIR_H
#define THUD_CORE_DOUBLE_PAIR_H

#include <stdbool.h>
#include <stdint.h>

typedef double thud_double_pair __attribute__((vector_size(2 * sizeof(double)), aligned(sizeof(double)), may_alias));

/* The same where they stand at a multiple of their size: as an operand they need not be loaded first. */
typedef double thud_aligned_pair __attribute__((vector_size(2 * sizeof(double)), may_alias));

static inline thud_double_pair thud_double_pair_at(const double *x)
{
    return *(const thud_double_pair *)x;
}

static inline void thud_double_pair_put(thud_double_pair x, double *out, bool single)
{
    if (single)
        *out = x[0];
    else
        *(thud_double_pair *)out = x;
}

/* Only the first of the two where `single`. */
static inline thud_double_pair thud_double_pair_some(const double *x, bool single)
{
    return single ? (thud_double_pair){*x, 0} : thud_double_pair_at(x);
}

static inline thud_double_pair thud_double_pair_abs(thud_double_pair x)
{
    typedef long long bits __attribute__((vector_size(sizeof(thud_double_pair))));
    return (thud_double_pair)((bits)x & (bits){INT64_MAX, INT64_MAX}); /* all but the sign */
}

/* a[0] b[0] + ... + a[n - 1] b[n - 1] */
static inline double thud_dot(int n, const double *a, const double *b)
{
    thud_double_pair even = {0, 0}, odd = {0, 0};
    int j = 0;
    for (; j + 4 <= n; j += 4) {
        even += thud_double_pair_at(a + j) * thud_double_pair_at(b + j);
        odd += thud_double_pair_at(a + j + 2) * thud_double_pair_at(b + j + 2);
    }
    if (j + 2 <= n) {
        even += thud_double_pair_at(a + j) * thud_double_pair_at(b + j);
        j += 2;
    }
    even += odd;
    double sum = even[0] + even[1];
    return j < n ? sum + a[j] * b[j] : sum;
}

/* Sum of w q^2 + v^2: twice the energy of n modes with w = omega^2. */
static inline double thud_energy_sum(int n, const double *w, const double *q, const double *v)
{
    thud_double_pair strain = {0, 0}, kinetic = {0, 0};
    int j = 0;
    for (; j + 2 <= n; j += 2) {
        thud_double_pair x = thud_double_pair_at(q + j), y = thud_double_pair_at(v + j);
        strain += thud_double_pair_at(w + j) * (x * x);
        kinetic += y * y;
    }
    strain += kinetic;
    double sum = strain[0] + strain[1];
    return j < n ? sum + (w[j] * (q[j] * q[j]) + v[j] * v[j]) : sum;
}

#endif
