/* Linear complementarity: w = M z + q, w >= 0, z >= 0, w . z = 0. */
#ifndef THUD_CORE_LCP_H
#define THUD_CORE_LCP_H

#include <stddef.h>

#include "base/status.h"

/* Doubles of working space for n unknowns. */
size_t thud_lcp_work(int n);

/* M (n x n) symmetric positive definite, q (n), z (n): by principal pivoting, least index first (Murty 1974), which
 * ends for such M. Errors: THUD_DIVERGED when a principal minor is not positive or the pivots do not end. */
enum thud_status thud_lcp_solve(int n, const double *m, const double *q, double *z, double *work,
                                struct thud_error *err);

#endif
