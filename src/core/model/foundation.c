#include "core/model/foundation.h"

#include <stdlib.h>
#include <string.h>

#include "core/model/modes.h"
#include "core/numerics/vec.h"

double thud_foundation_arm(const struct thud_structure_input *in)
{
    double height = 0;
    for (int i = 0; i < in->n; i++)
        height += in->rise_m[i];
    return height;
}

/* out (columns x columns) = b^T a b, a (rows x rows), b (rows x columns). `temp` (rows x columns). */
static void congruent(int rows, int columns, const double *a, const double *b, double *temp, double *out)
{
    memset(temp, 0, (size_t)rows * (size_t)columns * sizeof *temp);
    memset(out, 0, (size_t)columns * (size_t)columns * sizeof *out);
    for (int i = 0; i < rows; i++)
        thud_add_rows(columns, rows, 1, a + i * rows, b, temp + i * columns);
    for (int i = 0; i < rows; i++)
        for (int j = 0; j < columns; j++)
            for (int k = 0; k < columns; k++)
                out[j * columns + k] += b[i * columns + j] * temp[i * columns + k];
}

void thud_foundation_add_storey(double stiffness_npm, int n, int above, int below, double *k)
{
    k[above * n + above] += stiffness_npm;
    if (below < 0)
        return;
    k[below * n + below] += stiffness_npm;
    k[above * n + below] -= stiffness_npm;
    k[below * n + above] -= stiffness_npm;
}

/* K_own (n x n). */
static void own_stiffness(const struct thud_structure_input *in, double *k)
{
    const int n = in->n;
    for (int i = 0; i < n * n; i++)
        k[i] = in->matrix_npm ? in->matrix_npm[i] : 0;
    for (int i = 0; i < n && !in->matrix_npm; i++)
        thud_foundation_add_storey(in->stiffness_npm[i], n, i, i - 1, k);
}

/* C_own = M Phi D Phi^T M (n x n); work (3 n x n). */
static void own_damping(const struct thud_structure_input *in, const double *omega, const double *phi,
                        const double *damping, double *work, double *c)
{
    const int n = in->n;
    double *d = work, *weighted = d + n * n, *temp = weighted + n * n;
    for (int a = 0; a < n; a++)
        for (int b = 0; b < n; b++) {
            d[a * n + b] = damping ? damping[a * n + b] : a == b ? 2 * in->damping * omega[a] : 0;
            weighted[a * n + b] = phi[b * n + a] * in->mass_kg[b];
        }
    congruent(n, n, d, weighted, temp, c);
}

/* B (n x dofs). */
static void deformation(const struct thud_structure_input *in, int dofs, double *b)
{
    const double arm = thud_foundation_arm(in);
    double z = 0;
    memset(b, 0, (size_t)in->n * (size_t)dofs * sizeof *b);
    for (int i = 0; i < in->n; i++) {
        z += in->rise_m[i];
        b[i * dofs + i] = 1;
        b[i * dofs + in->n] = -1;
        b[i * dofs + in->n + 1] = -z / arm;
    }
}

enum thud_status thud_foundation_modes(const struct thud_structure_input *in, const double *fixed_omega,
                                       const double *fixed, const double *fixed_damping, double *omega, double *phi,
                                       double *damping, struct thud_error *err)
{
    const struct thud_foundation_input *soil = in->foundation;
    const int n = in->n, dofs = n + THUD_FOUNDATION_DOFS, sway = n * dofs + n, rocking = (n + 1) * dofs + n + 1;
    const size_t square = (size_t)dofs * (size_t)dofs;
    const double arm = thud_foundation_arm(in), arm2 = arm * arm;
    double *block = calloc(8 * square + 4 * (size_t)dofs, sizeof *block);
    if (!block)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    double *own = block, *b = own + square, *temp = b + square, *whole = temp + square, *work = whole + square,
           *mass = work + 3 * square + 3 * dofs;
    memcpy(mass, in->mass_kg, (size_t)n * sizeof *mass);
    mass[n] = soil->mass_kg;
    mass[n + 1] = soil->inertia_kgm2 / arm2;
    deformation(in, dofs, b);
    own_stiffness(in, own);
    congruent(n, dofs, own, b, temp, whole);
    for (int i = 0; in->geometric_npm && i < n; i++) /* K_G, on the whole drift, tilted or not */
        thud_foundation_add_storey(-in->geometric_npm[i], dofs, i, i > 0 ? i - 1 : n, whole);
    whole[sway] += soil->sway_npm;
    whole[rocking] += soil->rocking_nmprad / arm2;
    enum thud_status status = thud_modes_matrix(dofs, mass, whole, omega, phi, work, err);
    own_damping(in, fixed_omega, fixed, fixed_damping, work, own);
    congruent(n, dofs, own, b, temp, whole);
    whole[sway] += soil->sway_nspm;
    whole[rocking] += soil->rocking_nmsprad / arm2;
    congruent(dofs, dofs, whole, phi, temp, damping);
    if (status == THUD_OK && !(omega[0] > 0)) {
        thud_error_set(err, THUD_INPUT, "the building buckles under its own weight on this soil");
        thud_error_allow(err, "stiffer soil, or p-delta: no");
        status = THUD_INPUT;
    }
    free(block);
    return status;
}
