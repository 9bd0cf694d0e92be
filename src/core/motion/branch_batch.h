/* Force of a branch at the points of a batch at once: what a processor spends on powers one by one is most of what a
 * contact force costs. */
#ifndef THUD_CORE_BRANCH_BATCH_H
#define THUD_CORE_BRANCH_BATCH_H

#include "core/laws/law.h"

/* thud_branch_force at (THUD_BATCH) points, to a few units in its last digit; no derivative by d of the power terms at
 * d <= 0, where thud_branch_force has that from the right. */
void thud_branch_batch(const struct thud_branch *branch, const double *d_m, const double *v_mps, double *force,
                       double *df_dd, double *df_dv);

#endif
