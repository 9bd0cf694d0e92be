/* Fragility curves, and the responses of incremental dynamic analysis. */
#pragma once

#include "plot/figure/figure.h"
#include "study/suite/fragility.h"

/* Curve of a panel; the fragility is along plan->axis[axis]. */
struct thud_fragility_curve {
    int axis, k; /* k: index into the plan's cases */
    const struct thud_fragility *fragility;
};
/* Makes a panel for each axis with curves: shares of the motions as points, the fitted curves, and their bands. `note`
 * states the values of the other keys. Ask thud_figure_check. */
struct thud_figure *thud_figure_of_fragility(const struct thud_sweep_plan *plan, const char *event,
                                             const struct thud_fragility_curve *curve, int ncurves, const char *note);

/* Returns a sentence on its points and shades, for a suite of this many independent motions. */
const char *thud_fragility_note(int ndraws);

/* Draws the peak drift of each structure against the intensity (plan->axis[axis]) for one case: every motion, and the
 * curves of 16, 50 and 84 % of them. `at`: places on the other axes. Ask thud_figure_check. */
struct thud_figure *thud_figure_of_ida(const struct thud_suite *suite, int axis, int k, const int *at,
                                       const char *note);
