#include "study/sobol.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

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

static bool is_whole(const double *a, const double *b, const double *ab, size_t n, size_t d, size_t row)
{
    bool whole = !isnan(a[row]) && !isnan(b[row]);
    for (size_t i = 0; whole && i < d; i++)
        whole = !isnan(ab[i * n + row]);
    return whole;
}

void thud_sobol_indices(const double *a, const double *b, const double *ab, size_t n, size_t d, double *first,
                        double *total)
{
    double mean = 0, variance = 0;
    size_t rows = 0;
    for (size_t r = 0; r < n; r++)
        if (is_whole(a, b, ab, n, d, r)) {
            mean += a[r] + b[r];
            rows++;
        }
    mean /= rows > 0 ? 2 * (double)rows : 1;
    for (size_t r = 0; r < n; r++)
        if (is_whole(a, b, ab, n, d, r))
            variance += (a[r] - mean) * (a[r] - mean) + (b[r] - mean) * (b[r] - mean);
    for (size_t i = 0; i < d; i++) {
        double one = 0, all = 0;
        for (size_t r = 0; r < n; r++) {
            if (!is_whole(a, b, ab, n, d, r))
                continue;
            double change = ab[i * n + r] - a[r];
            one += (b[r] - mean) * change;
            all += change * change;
        }
        first[i] = variance > 0 ? 2 * one / variance : NAN;
        total[i] = variance > 0 ? all / variance : NAN;
    }
}
