/* Figures of the required gap: over the height, and the share of ground motions that a gap keeps apart. */
#pragma once

#include "plot/figure/figure.h"
#include "study/suite/gap_suite.h"

/* Draws them; `title` of the scene. NULL, or failed (thud_figure_check), when out of memory. */
struct thud_figure *thud_figure_of_gaps(const struct thud_gap_suite *suite, const char *title);
