/* Linear complementarity: w = M z + q, w >= 0, z >= 0, w . z = 0; and linear equations with such an M. M (n x n) is
 * symmetric and positive semidefinite: a sum of g g', which is singular where rows g depend on each other. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/status.h"

/* Doubles of working space for n unknowns, for either. */
size_t thud_lcp_work(int n);

/* z (n) by principal pivoting, least index first (Murty 1974), which ends where M is positive definite. Where it is not,
 * of M + r D, D its diagonal, with q - r D z of the solution before (proximal point method, Rockafellar 1976): M z and w
 * are unique, and z comes out as the smallest in the norm of D. *unique (may be NULL): no rows that depend on each other were
 * met. Errors: THUD_DIVERGED when there is no solution, M is not semidefinite, or the pivots do not end. */
enum thud_status thud_lcp_solve(int n, const double *m, const double *q, double *z, double *work, bool *unique,
                                struct thud_error *err);

/* b becomes x of M x = b, b in the range of M: where M is singular the smallest in the norm of D, in the same way.
 * False: M is not semidefinite. */
bool thud_semidefinite_solve(int n, const double *m, double *b, double *work);
/* No rows of M depend on each other. */
bool thud_is_definite(int n, const double *m, double *work);
