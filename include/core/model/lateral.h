/* The lateral stiffness K (n x n, symmetric) of a building's floors, as other programs give it: as a matrix, as its
 * inverse, or as periods and shapes.
 *
 *     modes, as many as floors:   K = M Phi Omega^2 Phi^T M,  Phi^T M Phi = I
 *     fewer:                      K = M Phi Omega^2 Phi^T M + omega_x^2 (M - M Phi Phi^T M)
 *
 * The motion omitted by the shapes has the frequency omega_x, ten times the largest given. Shapes are scaled, and made
 * orthogonal by the smallest changes: W (W^T W)^(-1/2) with W = M^(1/2) Phi (Loewdin 1950, J. Chem. Phys. 18:365). */
#pragma once

#include <stdbool.h>

#include "base/status.h"

/* Returns the largest difference between two elements that should be equal, over the root of their diagonal elements,
 * and its place (row, column from 0). */
double thud_lateral_asymmetry(int n, const double *k, int *row, int *column);
/* Computes the smallest eigenvalue; NaN where LAPACK finds none. Errors: THUD_MEMORY. */
enum thud_status thud_lateral_least(int n, const double *k, double *least, struct thud_error *err);
/* Inverts a positive definite matrix in place. Errors: THUD_INPUT (not definite), THUD_MEMORY. */
enum thud_status thud_lateral_invert(int n, double *k, struct thud_error *err);
/* Finds whether floors are listed from the roof down: the first floor then sways most under equal loads on all floors.
 * Errors: THUD_MEMORY. */
enum thud_status thud_lateral_hangs(int n, const double *k, bool *hangs, struct thud_error *err);

/* `row` (modes x (1 + n)): a period and the shape's values. */
/* Returns the largest phi_a^T M phi_b of two scaled shapes, and their indices (from 0). */
double thud_lateral_overlap(int n, int modes, const double *mass_kg, const double *row, int *a, int *b);
/* Computes K. Errors: THUD_INPUT (nearly equal shapes), THUD_MEMORY. */
enum thud_status thud_lateral_from_modes(int n, int modes, const double *mass_kg, const double *row, double *k,
                                         struct thud_error *err);
