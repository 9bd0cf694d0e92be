/* Figure of the spectra of a suite of ground motions. */
#pragma once

#include "plot/figures/figures_record.h"
#include "study/suite/scaling.h"

/* Draws each chosen motion scaled, their mean, the target and 90 % of it, with the buildings' periods marked. Ask
 * thud_figure_check. */
struct thud_figure *thud_figure_of_suite(const struct thud_scaled_suite *suite, const char *target,
                                         const struct thud_period_mark *mark, int nmarks);
