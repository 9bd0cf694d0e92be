#include "study/uncertainty/sobol.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "base/statistics.h"

enum thud_status thud_latin_hypercube(struct thud_random *random, size_t n, size_t d, double *u, struct thud_error *err)
{
    size_t *order = malloc((n + 1) * sizeof *order);
    if (!order)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    for (size_t j = 0; j < d; j++) {
        for (size_t i = 0; i < n; i++)
            order[i] = i;
        for (size_t i = n; i > 1; i--) { /* Fisher and Yates */
            size_t k = thud_random_below(random, i), last = order[i - 1];
            order[i - 1] = order[k];
            order[k] = last;
        }
        for (size_t i = 0; i < n; i++)
            u[i * d + j] = ((double)order[i] + thud_random_unit(random)) / (double)n;
    }
    free(order);
    return THUD_OK;
}

enum { BITS = 32, DEGREE_MAX = 7 };

/* Of dimensions 2 to 21: degree s and coefficients a of the primitive polynomial, first numbers m (new-joe-kuo-6). The
 * first dimension is van der Corput's sequence. */
static const struct {
    unsigned s, a, m[DEGREE_MAX];
} direction[THUD_SOBOL_DIMENSIONS - 1] = {{1, 0, {1}},
                                          {2, 1, {1, 3}},
                                          {3, 1, {1, 3, 1}},
                                          {3, 2, {1, 1, 1}},
                                          {4, 1, {1, 1, 3, 3}},
                                          {4, 4, {1, 3, 5, 13}},
                                          {5, 2, {1, 1, 5, 5, 17}},
                                          {5, 4, {1, 1, 5, 5, 5}},
                                          {5, 7, {1, 1, 7, 11, 19}},
                                          {5, 11, {1, 1, 5, 1, 1}},
                                          {5, 13, {1, 1, 1, 3, 11}},
                                          {5, 14, {1, 3, 5, 5, 31}},
                                          {6, 1, {1, 3, 3, 9, 7, 49}},
                                          {6, 13, {1, 1, 1, 15, 21, 21}},
                                          {6, 16, {1, 3, 1, 13, 27, 49}},
                                          {6, 19, {1, 1, 1, 15, 7, 5}},
                                          {6, 22, {1, 3, 1, 15, 13, 25}},
                                          {6, 25, {1, 1, 5, 5, 19, 61}},
                                          {7, 1, {1, 3, 7, 11, 23, 15, 103}},
                                          {7, 4, {1, 3, 7, 13, 13, 15, 69}},
                                          {7, 7, {1, 1, 3, 13, 7, 35, 63}},
                                          {7, 8, {1, 3, 5, 9, 1, 25, 53}},
                                          {7, 14, {1, 3, 1, 13, 9, 35, 107}},
                                          {7, 19, {1, 3, 1, 5, 27, 61, 31}},
                                          {7, 21, {1, 1, 5, 11, 19, 41, 61}}};

/* v[k] = m_k 2^(32-k), k from 1, by the recurrence of the polynomial. */
static void directions(size_t dimension, uint32_t v[BITS])
{
    for (unsigned k = 0; k < BITS && dimension == 0; k++)
        v[k] = (uint32_t)1 << (BITS - 1 - k);
    if (dimension == 0)
        return;
    unsigned s = direction[dimension - 1].s, a = direction[dimension - 1].a;
    for (unsigned k = 0; k < BITS; k++) {
        if (k < s) {
            v[k] = (uint32_t)direction[dimension - 1].m[k] << (BITS - 1 - k);
            continue;
        }
        v[k] = v[k - s] ^ v[k - s] >> s;
        for (unsigned i = 1; i < s; i++)
            v[k] ^= (a >> (s - 1 - i) & 1) ? v[k - i] : 0;
    }
}

void thud_sobol_sequence(struct thud_random *random, size_t n, size_t d, double *u)
{
    for (size_t j = 0; j < d; j++) {
        uint32_t v[BITS], x = 0, shift = random ? (uint32_t)(thud_random_next(random) >> 32) : 0;
        directions(j, v);
        for (size_t i = 0; i < n; i++) {
            u[i * d + j] = ((double)(x ^ shift) + (random ? 0.5 : 0)) / 4294967296.0;
            unsigned k = 0; /* the lowest 0 of i is where the next point changes */
            while (i >> k & 1)
                k++;
            x ^= v[k < BITS ? k : 0];
        }
    }
}

static bool is_whole(const double *a, const double *b, const double *ab, size_t n, size_t d, size_t row)
{
    bool whole = !isnan(a[row]) && !isnan(b[row]);
    for (size_t i = 0; whole && i < d; i++)
        whole = !isnan(ab[i * n + row]);
    return whole;
}

/* Which rows are whole, into row (n); returns how many. */
static size_t whole_rows(const double *a, const double *b, const double *ab, size_t n, size_t d, size_t *row)
{
    size_t rows = 0;
    for (size_t r = 0; r < n; r++)
        if (is_whole(a, b, ab, n, d, r))
            row[rows++] = r;
    return rows;
}

static void indices_of(const double *a, const double *b, const double *ab, size_t n, size_t d, const size_t *row,
                       size_t rows, double *first, double *total)
{
    double mean = 0, variance = 0;
    for (size_t k = 0; k < rows; k++)
        mean += a[row[k]] + b[row[k]];
    mean /= rows > 0 ? 2 * (double)rows : 1;
    for (size_t k = 0; k < rows; k++)
        variance += (a[row[k]] - mean) * (a[row[k]] - mean) + (b[row[k]] - mean) * (b[row[k]] - mean);
    for (size_t i = 0; i < d; i++) {
        double one = 0, all = 0;
        for (size_t k = 0; k < rows; k++) {
            double change = ab[i * n + row[k]] - a[row[k]];
            one += (b[row[k]] - mean) * change;
            all += change * change;
        }
        first[i] = variance > 0 ? 2 * one / variance : NAN;
        total[i] = variance > 0 ? all / variance : NAN;
    }
}

enum thud_status thud_sobol_indices(const double *a, const double *b, const double *ab, size_t n, size_t d,
                                    double *first, double *total, struct thud_error *err)
{
    size_t *row = malloc((n + 1) * sizeof *row);
    if (!row)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    indices_of(a, b, ab, n, d, row, whole_rows(a, b, ab, n, d, row), first, total);
    free(row);
    return THUD_OK;
}

enum thud_status thud_sobol_intervals(const double *a, const double *b, const double *ab, size_t n, size_t d,
                                      struct thud_random *random, double *low, double *high, struct thud_error *err)
{
    enum { SAMPLES = 1000 };
    size_t *row = malloc(2 * (n + 1) * sizeof *row), *drawn = row ? row + n + 1 : NULL;
    double *value = malloc((2 * d * SAMPLES + 2 * d + 1) * sizeof *value),
           *one = value ? value + 2 * d * SAMPLES : NULL;
    if (!row || !value) {
        free(row);
        free(value);
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    size_t rows = whole_rows(a, b, ab, n, d, row);
    for (size_t s = 0; s < SAMPLES; s++) {
        for (size_t k = 0; k < rows; k++)
            drawn[k] = row[thud_random_below(random, rows)];
        indices_of(a, b, ab, n, d, drawn, rows, one, one + d);
        for (size_t i = 0; i < 2 * d; i++)
            value[i * SAMPLES + s] = one[i];
    }
    for (size_t i = 0; i < 2 * d; i++) { /* a sample of equal rows has no index */
        size_t m = thud_sort_numbers(value + i * SAMPLES, SAMPLES);
        low[i] = rows > 1 ? thud_quantile(value + i * SAMPLES, m, 0.025, false) : NAN;
        high[i] = rows > 1 ? thud_quantile(value + i * SAMPLES, m, 0.975, false) : NAN;
    }
    free(row);
    free(value);
    return THUD_OK;
}
