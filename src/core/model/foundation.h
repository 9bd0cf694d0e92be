/* A building on soil. With x_i the motion of floor i against the free field, z_i its height over the foundation, u_f the
 * foundation's sway and t its rotation, the building's own stiffness and damping act on its deformation, the weight on
 * the whole drift, and the soil's springs and dashpots on u_f and r:
 *
 *     d = B (x, u_f, r) = x - u_f - (z/H) r,   r = H t
 *     K = B^T K_own B - K_G + diag(0, K_x, K_t/H^2)
 *     C = B^T C_own B + diag(0, C_x, C_t/H^2)
 *     M = diag(m_i, m_f, I_f/H^2)
 *
 * C_own is that of the modes on rigid ground. Where dashpots have a part in it, C couples the modes of K (Veletsos and
 * Meek, Earthquake Engineering and Structural Dynamics 3 (1974) 121-138). */
#pragma once

#include "core/model/model.h"

enum { THUD_FOUNDATION_DOFS = 2 }; /* its sway and its rotation, behind the floors */

/* Floors of a structure, and on soil the sway and the rotation of its foundation. */
static inline int thud_input_dofs(const struct thud_structure_input *in)
{
    return in->n + (in->foundation ? THUD_FOUNDATION_DOFS : 0);
}
/* Its modes that stay where `modes` are asked for. */
static inline int thud_input_modes(const struct thud_structure_input *in, int modes)
{
    const int kept = in->modes > 0 ? in->modes : modes;
    return kept > 0 && kept < thud_input_dofs(in) ? kept : thud_input_dofs(in);
}

/* Adds a storey of this stiffness between two rows of k (n x n); below the lowest one (-1) nothing moves. */
void thud_foundation_add_storey(double stiffness_npm, int n, int above, int below, double *k);
/* H of a building with a foundation. */
double thud_foundation_arm(const struct thud_structure_input *in);
/* Natural frequencies omega (dofs), shapes phi (dofs x dofs, row-major, Phi^T M Phi = I) and damping Phi^T C Phi of the
 * same size, of a building with a foundation. `fixed` are its shapes (n x n) on rigid ground, and the damping of these
 * modes is fixed_damping (n x n) or, where that is NULL, the building's own ratio at fixed_omega. Errors: THUD_INPUT
 * (it buckles under its own weight; no modes), THUD_MEMORY. */
enum thud_status thud_foundation_modes(const struct thud_structure_input *in, const double *fixed_omega,
                                       const double *fixed, const double *fixed_damping, double *omega, double *phi,
                                       double *damping, struct thud_error *err);
