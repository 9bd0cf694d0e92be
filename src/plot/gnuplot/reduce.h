/* Traces made small for drawing: what two samples in the same column of the picture would hide of each other is left
 * out. */
#pragma once

#include <stddef.h>

/* Picks which of n points to draw when x from `least` to `most` has `columns` columns and y from `low` to `high` as
 * many rows as given. Where x never falls: per column the points with the least `y` and the largest `y_high` (NULL: y),
 * in their order, one neighbour beyond each limit, and every break (NaN). Else (loops): points that stand in the cell
 * of the last one kept are left out. A spike is never lost. `index` (n) gets the picked points; returns how many. */
struct thud_reduce {
    double least, most, low, high;
    size_t columns, rows;
};
size_t thud_reduce(const struct thud_reduce *to, size_t n, const double *x, const double *y, const double *y_high,
                   size_t *index);
