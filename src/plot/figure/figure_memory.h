/* What a figure owns. */
#pragma once

#include "plot/figure/figure.h"

/* Zeroed memory that lives as long as the figure; NULL when out of memory, which the figure remembers. */
void *thud_figure_keep(struct thud_figure *figure, size_t count, size_t size);
