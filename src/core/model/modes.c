#include "core/model/modes.h"

#include <lapacke.h>
#include <math.h>
#include <stdlib.h>

static const char none_found[] = "the modes of a structure were not found";

/* From the squares of omega and the eigenvectors (column by column) of M^-1/2 K M^-1/2. */
static void scale_modes(int n, const double *mass_kg, const double *z, double *omega, double *phi)
{
    for (int j = 0; j < n; j++) {
        omega[j] = sqrt(fmax(omega[j], 0));
        const double *column = z + (size_t)j * (size_t)n;
        double sign = column[0] < 0 ? -1 : 1;
        for (int i = 0; i < n; i++)
            phi[i * n + j] = sign * column[i] / sqrt(mass_kg[i]);
    }
}

enum thud_status thud_modes_matrix(int n, const double *mass_kg, const double *matrix_npm, double *omega, double *phi,
                                   double *work, struct thud_error *err)
{
    double *z = work, *scratch = z + (size_t)n * (size_t)n;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            z[i * n + j] = matrix_npm[i * n + j] / sqrt(mass_kg[i] * mass_kg[j]);
    if (LAPACKE_dsyev_work(LAPACK_COL_MAJOR, 'V', 'U', n, z, n, omega, scratch, 3 * n) != 0)
        return thud_error_set(err, THUD_INPUT, none_found);
    scale_modes(n, mass_kg, z, omega, phi);
    return THUD_OK;
}

enum thud_status thud_modes_shear(int n, const double *mass_kg, const double *stiffness_npm, double *omega, double *phi,
                                  double *work, struct thud_error *err)
{
    double *off = work, *z = work + n, *scratch = z + (size_t)n * (size_t)n;
    /* M^-1/2 K M^-1/2 is tridiagonal and symmetric */
    for (int i = 0; i < n; i++) {
        double above = i + 1 < n ? stiffness_npm[i + 1] : 0;
        omega[i] = (stiffness_npm[i] + above) / mass_kg[i];
        if (i + 1 < n)
            off[i] = -above / sqrt(mass_kg[i] * mass_kg[i + 1]);
    }
    if (LAPACKE_dstev_work(LAPACK_COL_MAJOR, 'V', n, omega, off, z, n, scratch) != 0)
        return thud_error_set(err, THUD_INPUT, none_found);
    scale_modes(n, mass_kg, z, omega, phi);
    return THUD_OK;
}

/* C of the superstructure in its own floors' coordinates: M Psi diag(2 zeta omega) Psi^T M, (m x m). */
static void own_damping(int m, const double *mass_kg, double zeta, const double *omega, const double *psi, double *c)
{
    for (int i = 0; i < m; i++)
        for (int k = 0; k < m; k++) {
            double sum = 0;
            for (int j = 0; j < m; j++)
                sum += psi[i * m + j] * 2 * zeta * omega[j] * psi[k * m + j];
            c[i * m + k] = mass_kg[i] * sum * mass_kg[k];
        }
}

/* Motion relative to the base of the floors above it, per mode of the whole: (m x n) row-major. */
static void relative_modes(int n, const double *phi, double *r)
{
    for (int i = 1; i < n; i++)
        for (int j = 0; j < n; j++)
            r[(i - 1) * n + j] = phi[i * n + j] - phi[j];
}

enum thud_status thud_modes_isolated_damping(int n, const double *mass_kg, const double *stiffness_npm, double zeta,
                                             double zeta_b, const double *phi, double *damping, struct thud_error *err)
{
    int m = n - 1;
    size_t square = (size_t)n * (size_t)n;
    double *block = malloc((5 * square + 4 * (size_t)n) * sizeof *block);
    if (!block)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    double *psi = block, *c = psi + square, *r = c + square, *omega = r + square, *work = omega + n;
    enum thud_status status = THUD_OK;
    if (m > 0)
        status = thud_modes_shear(m, mass_kg + 1, stiffness_npm + 1, omega, psi, work, err);
    if (status == THUD_OK) {
        double total = 0;
        for (int i = 0; i < n; i++)
            total += mass_kg[i];
        double base = 2 * zeta_b * sqrt(stiffness_npm[0] * total);
        own_damping(m, mass_kg + 1, zeta, omega, psi, c);
        relative_modes(n, phi, r);
        for (int a = 0; a < n; a++)
            for (int b = 0; b < n; b++) {
                double sum = base * phi[a] * phi[b];
                for (int i = 0; i < m; i++)
                    for (int k = 0; k < m; k++)
                        sum += r[i * n + a] * c[i * m + k] * r[k * n + b];
                damping[a * n + b] = sum;
            }
    }
    free(block);
    return status;
}
