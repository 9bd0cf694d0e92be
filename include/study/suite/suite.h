/* What a study says over its ground motions together: of every run a few numbers, kept small so that tens of thousands
 * of runs fit, and their fractiles over the motions at each setting of the other varied keys. */
#pragma once

#include "base/statistics.h"
#include "study/sweep/sweep.h"
#include "study/sweep/sweep_table.h"

/* Of a run; from the accelerations on by structure. */
enum thud_suite_measure {
    THUD_SUITE_IMPACTS,            /* all contacts */
    THUD_SUITE_USED,               /* largest relative displacement without pounding over clearance, of all levels */
    THUD_SUITE_SHORT,              /* largest relative displacement less clearance, m */
    THUD_SUITE_FORCE,              /* largest of all contacts, N; 0: there was no contact */
    THUD_SUITE_ACCELERATION,       /* largest of the floors, m/s2 */
    THUD_SUITE_DRIFT,              /* largest of the storeys, m */
    THUD_SUITE_DRIFT_ANGLE,        /* the same over the storey's height; without the isolators' */
    THUD_SUITE_ACCELERATION_RATIO, /* of the means over the floors, to case none */
    THUD_SUITE_DRIFT_RATIO,
    THUD_SUITE_DUCTILITY, /* largest drift over yield drift of the storeys that yield; NaN: none does */
    THUD_SUITE_PERMANENT, /* largest permanent drift of those, m */
    THUD_SUITE_ISOLATOR,  /* largest displacement of its isolators, m; NaN: it has none */
    THUD_SUITE_COLUMNS,   /* largest shear over capacity of the columns that slabs strike; NaN: none, or not given */
    THUD_SUITE_MEASURES
};
const char *thud_suite_column(enum thud_suite_measure measure); /* "force_n", "drift_m", ... */

/* Fewer independent motions have no bootstrapped band. */
enum { THUD_DRAWS_LEAST = 7 };

/* Setting i (of thud_suite_settings) of ground motion r is point r x settings + i of the plan. */
struct thud_suite {
    const struct thud_sweep_plan *plan;
    int nrecords, nstructures, nvalues; /* nvalues: of a run */
    bool yields;                        /* some storey may: it has ductilities and permanent drifts */
    bool linear;                        /* without pounding, displacements are linear in the ground motion */
    bool isolated;                      /* a structure stands on isolators */
    bool columns;                       /* a capacity is given: it has shears over it */
    long settings;
    int ndraws;    /* independent motions: one and the same reversed is one */
    int *first;    /* (ndraws + 1) its first record; those of a motion stand one after the other */
    double *value; /* (nrecords x settings x plan->ncases x nvalues); NaN: no result */
};
/* Whether its runs may have any. */
bool thud_suite_has(const struct thud_suite *suite, enum thud_suite_measure measure);

/* Errors: THUD_MEMORY. The plan must outlive it. */
enum thud_status thud_suite_create(const struct thud_sweep_plan *plan, struct thud_suite **out, struct thud_error *err);
void thud_suite_free(struct thud_suite *suite);
/* Errors: THUD_MEMORY. */
enum thud_status thud_suite_add(struct thud_suite *suite, const struct thud_sweep_point *point, struct thud_error *err);

/* `k`: index into the plan's cases. structure -1: the largest over the structures. */
double thud_suite_value(const struct thud_suite *suite, int record, long setting, int k,
                        enum thud_suite_measure measure, int structure);
/* Over the ground motions; fewer than three have no 16 and 84 %. `room` (nrecords) is scratch. `share`: of values above
 * `limit`. */
struct thud_fractiles thud_suite_fractiles(const struct thud_suite *suite, long setting, int k,
                                           enum thud_suite_measure measure, int structure, double limit, double *room);

/* Wilson's band of a share of the motions (see thud_share_band), where both signs of a motion count as one; NaN: fewer
 * than three motions. */
void thud_suite_share_band(const struct thud_suite *suite, size_t count, size_t n, double *low, double *high);

/* Places on the axes (naxes) to the number of a setting; back: thud_sweep_place. */
long thud_suite_setting(const struct thud_sweep_plan *plan, const int *at);
