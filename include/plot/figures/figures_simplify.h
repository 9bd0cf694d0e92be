/* Figure of error against cost of models, beside that of methods. */
#pragma once

#include "plot/figure/figure.h"
#include "study/simplify/simplify.h"

/* Draws it; `title` of the scene. NULL, or failed (thud_figure_check), when out of memory. */
struct thud_figure *thud_figure_of_simplify(const struct thud_simplify_found *found, const char *title);
