/* All vector code of the core: pairs of numbers (vec2) that every processor of the kind works on at once. Left to
 * themselves, compilers may not change the order of a sum, and spend more on shuffling short rows than on
 * summing them. + - * / < > work on vec2 by element; the rest is here. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

typedef double thud_vec2 __attribute__((vector_size(2 * sizeof(double)), aligned(sizeof(double)), may_alias));
/* The same where they stand at a multiple of their size: as an operand they need not be loaded first. */
typedef double thud_vec2_aligned __attribute__((vector_size(2 * sizeof(double)), may_alias));
/* Its bits; also of a comparison, all 1 where it holds. */
typedef unsigned long long thud_vec2_bits __attribute__((vector_size(sizeof(thud_vec2)), may_alias));

static inline thud_vec2 thud_vec2_set(double first, double second)
{
    return (thud_vec2){first, second};
}

static inline thud_vec2 thud_vec2_at(const double *x)
{
    return *(const thud_vec2 *)x;
}

static inline void thud_vec2_put(thud_vec2 x, double *out)
{
    *(thud_vec2 *)out = x;
}

/* Only the first of the two where `single`: the end of a row whose length is odd. */
static inline thud_vec2 thud_vec2_some(const double *x, bool single)
{
    return single ? thud_vec2_set(*x, 0) : thud_vec2_at(x);
}

static inline void thud_vec2_put_some(thud_vec2 x, double *out, bool single)
{
    if (single)
        *out = x[0];
    else
        thud_vec2_put(x, out);
}

static inline thud_vec2 thud_vec2_abs(thud_vec2 x)
{
    return (thud_vec2)((thud_vec2_bits)x & (thud_vec2_bits){INT64_MAX, INT64_MAX}); /* all but the sign */
}

static inline double thud_vec2_sum(thud_vec2 x)
{
    return x[0] + x[1];
}

static inline bool thud_vec2_any(thud_vec2_bits where)
{
    return (where[0] | where[1]) != 0;
}

/* The larger of each two numbers; y where one is NaN. */
static inline thud_vec2 thud_vec2_larger(thud_vec2 x, thud_vec2 y)
{
    const thud_vec2_bits where = (thud_vec2_bits)(x > y);
    return (thud_vec2)(((thud_vec2_bits)x & where) | ((thud_vec2_bits)y & ~where));
}

/* a[0] b[0] + ... + a[n - 1] b[n - 1] */
static inline double thud_dot(int n, const double *a, const double *b)
{
    thud_vec2 even = {0, 0}, odd = {0, 0};
    int j = 0;
    for (; j + 4 <= n; j += 4) {
        even += thud_vec2_at(a + j) * thud_vec2_at(b + j);
        odd += thud_vec2_at(a + j + 2) * thud_vec2_at(b + j + 2);
    }
    if (j + 2 <= n) {
        even += thud_vec2_at(a + j) * thud_vec2_at(b + j);
        j += 2;
    }
    double sum = thud_vec2_sum(even + odd);
    return j < n ? sum + a[j] * b[j] : sum;
}

/* Adds a . b_k of a few rows that stand `apart` from each other to sum[k], in two parts. */
static inline void thud_add_dots(int n, const double *a, const double *b, int apart, const int count, thud_vec2 *sum)
{
    int j = 0;
    for (; j + 2 <= n; j += 2)
        for (int k = 0; k < count; k++)
            sum[k] += thud_vec2_at(a + j) * thud_vec2_at(b + k * apart + j);
    for (int k = 0; k < count && j < n; k++)
        sum[k] += thud_vec2_set(a[j] * b[k * apart + j], 0);
}

/* out[k] = a . b_k of such rows: four at once, for which a is read once. */
static inline void thud_dots(int n, const double *a, const double *b, int apart, int count, double *out)
{
    int k = 0;
    for (; k + 4 <= count; k += 4, b += 4 * apart) {
        thud_vec2 sum[4] = {0};
        thud_add_dots(n, a, b, apart, 4, sum);
        for (int i = 0; i < 4; i++)
            out[k + i] = thud_vec2_sum(sum[i]);
    }
    for (; k < count; k++, b += apart)
        out[k] = thud_dot(n, a, b);
}

/* Adds factor x[k] a_k, of rows that stand `apart`, to as many pairs of out. */
static inline void thud_add_pairs(int apart, int count, double factor, const double *x, const double *a, double *out,
                                  const int pairs)
{
    thud_vec2 sum[8] = {0};
    for (int k = 0; k < count; k++, a += apart)
        for (int i = 0; i < pairs; i++)
            sum[i] += x[k] * thud_vec2_at(a + 2 * i);
    for (int i = 0; i < pairs; i++)
        thud_vec2_put(thud_vec2_at(out + 2 * i) + factor * sum[i], out + 2 * i);
}

/* The same of whole rows (n) that stand one after the other. */
static inline void thud_add_rows(int n, int count, double factor, const double *x, const double *a, double *out)
{
    int i = 0;
    for (; i + 16 <= n; i += 16)
        thud_add_pairs(n, count, factor, x, a + i, out + i, 8);
    for (; i + 12 <= n; i += 12)
        thud_add_pairs(n, count, factor, x, a + i, out + i, 6);
    for (; i + 8 <= n; i += 8)
        thud_add_pairs(n, count, factor, x, a + i, out + i, 4);
    if (i + 6 <= n)
        thud_add_pairs(n, count, factor, x, a + i, out + i, 3);
    else if (i + 4 <= n)
        thud_add_pairs(n, count, factor, x, a + i, out + i, 2);
    else if (i + 2 <= n)
        thud_add_pairs(n, count, factor, x, a + i, out + i, 1);
    for (int k = 0; k < count && n % 2; k++)
        out[n - 1] += factor * x[k] * a[k * n + n - 1];
}

/* Sum of w q^2 + v^2: twice the energy of n modes with w = omega^2. */
static inline double thud_energy_sum(int n, const double *w, const double *q, const double *v)
{
    thud_vec2 strain = {0, 0}, kinetic = {0, 0};
    int j = 0;
    for (; j + 2 <= n; j += 2) {
        thud_vec2 x = thud_vec2_at(q + j), y = thud_vec2_at(v + j);
        strain += thud_vec2_at(w + j) * (x * x);
        kinetic += y * y;
    }
    double sum = thud_vec2_sum(strain + kinetic);
    return j < n ? sum + (w[j] * (q[j] * q[j]) + v[j] * v[j]) : sum;
}
