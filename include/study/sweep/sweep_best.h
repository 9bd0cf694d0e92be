/* Best value of one varied key, for each setting of the others. */
#pragma once

#include "study/sweep/sweep_table.h"

/* Objective to minimize: the largest, over the structures, of the ratio of the mean peak accelerations. */
struct thud_sweep_best {
    int record; /* from 0; -1: the worst of all records counts */
    enum thud_case which;
    int at[THUD_VARY_MAX];     /* place of its value on each axis; on that of the key the best */
    int flat_least, flat_most; /* around it, places of the values whose ratio is at most 5 % above the best one's */
    double ratio, drift_ratio; /* there; of the mean drifts also the largest over the structures */
    double worst_ratio;        /* over the key's values */
    int values;                /* how many had a result */
    bool at_end;               /* the best is the first or the last value, so a better one may lie outside the range */
    bool idle; /* the ratio there is 1.000: nothing, or hardly anything, strikes the bumper, and no value is best */
};
enum { THUD_SWEEP_BEST_PER_CENT = 5 };

/* Makes rows for `axis` of the table, by record, case and the other keys in their order. With several records, the row
 * for all of them follows each group. *out is to be freed; returns their number, -1 when out of memory. Case `none` has
 * no rows. */
long thud_sweep_best(const struct thud_sweep_table *table, int axis, struct thud_sweep_best **out);
