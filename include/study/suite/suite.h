/* Statistics of a study over its ground motions. A few numbers of every run are stored, so tens of thousands of runs
 * fit. Fractiles over the motions are computed at each setting of the other varied keys. */
#pragma once

#include "base/statistics.h"
#include "study/sweep/measure.h"
#include "study/sweep/sweep.h"
#include "study/sweep/sweep_table.h"

/* Smallest number of independent motions with a bootstrap band. */
enum { THUD_DRAWS_LEAST = 7 };

/* Setting i (of thud_suite_settings) of ground motion r is point r x settings + i of the plan. */
struct thud_suite {
    const struct thud_sweep_plan *plan;
    int nrecords, nstructures, nvalues; /* nvalues: of a run */
    int at[THUD_MEASURES];              /* where a measure stands among them, of structures its first one */
    unsigned features;                  /* THUD_HAS_...: measures that its runs may have */
    long settings;
    int ndraws;    /* independent motions: those of one recording are one (thud_motions_recordings) */
    int *motion;   /* (nrecords) the records by recording */
    int *first;    /* (ndraws + 1, and room) where those of a recording begin in `motion` */
    double *value; /* (nrecords x settings x plan->ncases x nvalues); NaN: no result */
};
/* Creates a suite; the plan must outlive it. Errors: THUD_MEMORY. */
enum thud_status thud_suite_create(const struct thud_sweep_plan *plan, struct thud_suite **out, struct thud_error *err);
void thud_suite_free(struct thud_suite *suite);
/* Errors: THUD_MEMORY. */
enum thud_status thud_suite_add(struct thud_suite *suite, const struct thud_sweep_point *point, struct thud_error *err);

/* Returns a number of a run. `k`: index into the plan's cases. structure -1: the largest over the structures. */
double thud_suite_value(const struct thud_suite *suite, int record, long setting, int k, enum thud_measure measure,
                        int structure);
/* Computes statistics over the ground motions. `room` (nrecords) is scratch. `share`: of values above
 * `limit`. */
struct thud_fractiles thud_suite_fractiles(const struct thud_suite *suite, long setting, int k,
                                           enum thud_measure measure, int structure, double limit, double *room);

/* Computes Wilson's band of a fraction of the motions (see thud_share_band); both polarities of a motion count as one.
 * NaN: fewer than three motions. */
void thud_suite_share_band(const struct thud_suite *suite, size_t count, size_t n, double *low, double *high);

/* Returns the number of a setting from its places on the axes (naxes); back: thud_sweep_place. */
long thud_suite_setting(const struct thud_sweep_plan *plan, const int *at);
