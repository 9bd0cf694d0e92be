#include "core/model/lateral.h"

#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"
#include "core/model/modes.h"
#include "core/numerics/vec.h"

static const double frequency_left_out = 10; /* omega_x over the largest given omega */
static const double least_independent = 0.1; /* eigenvalue of W^T W, which is 1 of orthogonal shapes */

static enum thud_status no_memory(struct thud_error *err)
{
    return thud_error_set(err, THUD_MEMORY, "out of memory");
}

double thud_lateral_asymmetry(int n, const double *k, int *row, int *column)
{
    double most = 0;
    *row = *column = 0;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < i; j++) {
            double size = sqrt(fabs(k[i * n + i] * k[j * n + j])), part = fabs(k[i * n + j] - k[j * n + i]) / size;
            if (!(part > most) && !(size == 0 && k[i * n + j] != k[j * n + i]))
                continue;
            most = part;
            *row = i;
            *column = j;
        }
    return most;
}

enum thud_status thud_lateral_least(int n, const double *k, double *least, struct thud_error *err)
{
    const size_t square = (size_t)n * (size_t)n;
    double *a = malloc((square + 4 * (size_t)n) * sizeof *a), *w = a + square;
    if (!a)
        return no_memory(err);
    memcpy(a, k, square * sizeof *a);
    *least = LAPACKE_dsyev_work(LAPACK_COL_MAJOR, 'N', 'U', n, a, n, w, w + n, 3 * n) == 0 ? w[0] : NAN;
    free(a);
    return THUD_OK;
}

enum thud_status thud_lateral_invert(int n, double *k, struct thud_error *err)
{
    if (LAPACKE_dpotrf_work(LAPACK_COL_MAJOR, 'L', n, k, n) != 0 ||
        LAPACKE_dpotri_work(LAPACK_COL_MAJOR, 'L', n, k, n) != 0)
        return thud_error_set(err, THUD_INPUT, "the matrix is not positive definite");
    for (int i = 0; i < n; i++) /* column-major: the lower triangle is the upper one of rows */
        for (int j = 0; j < i; j++)
            k[i * n + j] = k[j * n + i];
    return THUD_OK;
}

enum thud_status thud_lateral_hangs(int n, const double *k, bool *hangs, struct thud_error *err)
{
    const size_t square = (size_t)n * (size_t)n;
    double *a = malloc(square * sizeof *a), first = 0, last = 0;
    if (!a)
        return no_memory(err);
    memcpy(a, k, square * sizeof *a);
    enum thud_status status = thud_lateral_invert(n, a, err);
    for (int j = 0; j < n && status == THUD_OK; j++) {
        first += a[j];
        last += a[(n - 1) * n + j];
    }
    *hangs = first > last;
    free(a);
    return status;
}

/* phi_a^T M phi_b. */
static double product(int n, const double *mass_kg, const double *a, const double *b)
{
    double sum = 0;
    for (int i = 0; i < n; i++)
        sum += a[i] * mass_kg[i] * b[i];
    return sum;
}

double thud_lateral_overlap(int n, int modes, const double *mass_kg, const double *row, int *a, int *b)
{
    double most = 0;
    *a = 0;
    *b = modes > 1;
    for (int i = 0; i < modes; i++)
        for (int j = 0; j < i; j++) {
            const double *p = row + i * (1 + n) + 1, *q = row + j * (1 + n) + 1;
            double part = fabs(product(n, mass_kg, p, q)) / sqrt(product(n, mass_kg, p, p) * product(n, mass_kg, q, q));
            if (!(part > most))
                continue;
            most = part;
            *a = j;
            *b = i;
        }
    return most;
}

/* W (n x m) of the scaled shapes, column by column. */
static void weigh(int n, int m, const double *mass_kg, const double *row, double *w)
{
    for (int j = 0; j < m; j++) {
        const double *shape = row + j * (1 + n) + 1, size = sqrt(product(n, mass_kg, shape, shape));
        for (int i = 0; i < n; i++)
            w[j * n + i] = sqrt(mass_kg[i]) * shape[i] / size;
    }
}

/* W (W^T W)^(-1/2) into out; g (m x m), root (m x m) and values (4 m) are work space. */
static bool orthogonal(int n, int m, const double *w, double *out, double *g, double *root, double *values)
{
    for (int a = 0; a < m; a++)
        for (int b = 0; b < m; b++)
            g[a * m + b] = thud_dot(n, w + a * n, w + b * n);
    if (LAPACKE_dsyev_work(LAPACK_COL_MAJOR, 'V', 'U', m, g, m, values, values + m, 3 * m) != 0 ||
        !(values[0] > least_independent))
        return false;
    for (int a = 0; a < m; a++)
        for (int b = 0; b < m; b++) {
            double sum = 0;
            for (int j = 0; j < m; j++)
                sum += g[j * m + a] * g[j * m + b] / sqrt(values[j]);
            root[a * m + b] = sum;
        }
    for (int a = 0; a < m; a++)
        for (int i = 0; i < n; i++) {
            double sum = 0;
            for (int b = 0; b < m; b++)
                sum += w[b * n + i] * root[b * m + a];
            out[a * n + i] = sum;
        }
    return true;
}

enum thud_status thud_lateral_from_modes(int n, int m, const double *mass_kg, const double *row, double *k,
                                         struct thud_error *err)
{
    const size_t shapes = (size_t)n * (size_t)m, square = (size_t)m * (size_t)m;
    double *w = malloc((2 * shapes + 2 * square + 4 * (size_t)m) * sizeof *w);
    if (!w)
        return no_memory(err);
    double *phi = w + shapes, *g = phi + shapes, *values = g + 2 * square, fastest = 0;
    weigh(n, m, mass_kg, row, w);
    bool apart = orthogonal(n, m, w, phi, g, g + square, values);
    for (int j = 0; j < m; j++)
        fastest = fmax(fastest, 2 * THUD_PI / row[j * (1 + n)]);
    const double rest = m < n ? pow(frequency_left_out * fastest, 2) : 0;
    for (int a = 0; a < n && apart; a++)
        for (int b = 0; b < n; b++) {
            double sum = a == b ? rest : 0;
            for (int j = 0; j < m; j++) {
                double omega = 2 * THUD_PI / row[j * (1 + n)];
                sum += (omega * omega - rest) * (phi[j * n + a] * phi[j * n + b]);
            }
            k[a * n + b] = sum * sqrt(mass_kg[a] * mass_kg[b]);
        }
    free(w);
    return apart ? THUD_OK : thud_error_set(err, THUD_INPUT, "two of the shapes are nearly the same");
}
