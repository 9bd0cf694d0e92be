/* Modes of one structure. */
#pragma once

#include "base/status.h"
#include "core/model/model.h"

/* Computes the modes of a shear building: omega (n) rising, phi (n x n, floor-major) with Phi^T M Phi = I and a first
 * floor that moves to the right. work: 3 n + n n. Errors: THUD_INPUT if LAPACK finds none. */
enum thud_status thud_modes_shear(int n, const double *mass_kg, const double *stiffness_npm, double *omega, double *phi,
                                  double *work, struct thud_error *err);

/* Does the same for a building by its stiffness matrix (n x n). work: n n + 3 n. */
enum thud_status thud_modes_matrix(int n, const double *mass_kg, const double *matrix_npm, double *omega, double *phi,
                                   double *work, struct thud_error *err);

/* Computes the modal damping matrix (n x n) of an isolated building: the superstructure has the ratio `zeta` in each of
 * its fixed-base modes, the isolator a dashpot c = 2 zeta_b sqrt(k_b total mass). phi: modes of the whole. Errors:
 * THUD_INPUT if LAPACK finds none, THUD_MEMORY. */
enum thud_status thud_modes_isolated_damping(int n, const double *mass_kg, const double *stiffness_npm, double zeta,
                                             double zeta_b, const double *phi, double *damping, struct thud_error *err);
