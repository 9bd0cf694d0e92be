/* The rows of a point as an array. */
#pragma once

#include "study/sweep/measure.h"

static inline int sweep_rows(const struct thud_sweep_point *point, struct thud_sweep_row *row)
{
    const int n = thud_sweep_row_count(point);
    for (int i = 0; row && i < n; i++)
        thud_sweep_row_at(point, i, &row[i]);
    return n;
}

static inline int sweep_contact_rows(const struct thud_sweep_point *point, struct thud_sweep_contact_row *row)
{
    const int n = thud_sweep_contact_row_count(point);
    for (int i = 0; i < n; i++)
        thud_sweep_contact_row_at(point, i, &row[i]);
    return n;
}
