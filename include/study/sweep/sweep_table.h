/* Whole study in memory, for figures and tables: only the values they show of each point, so that thousands of runs
 * take little. Files and standard output are written from the points (study/sweep.h). */
#pragma once

#include <math.h>
#include <stdbool.h>

#include "study/sweep/measure.h"
#include "study/sweep/sweep.h"

/* Ratios to case `none`, and to no pounding (`free_links`), as in struct thud_sweep_row. */
struct thud_sweep_ratio {
    double acceleration, drift, acceleration_free, drift_free;
};
enum thud_sweep_end { THUD_SWEEP_VALUE, THUD_SWEEP_LOW, THUD_SWEEP_HIGH };

/* Fractions of the ground motions of a suite, for a run whose own values are medians: with contact, and with a larger
 * mean acceleration of a structure than in case `none`. */
struct thud_sweep_shares {
    double pounding, worse;
    /* Wilson's 90 % bands, low and high, both signs of a motion as one; NaN: of so few motions there are none. */
    double pounding_band[2], worse_band[2];
};

/* Summary of a point: one allocation (free with free()), sized to its floors and cases. */
struct thud_sweep_summary {
    int record;                     /* from 0 */
    int at[THUD_VARY_MAX];          /* place of its value on each axis */
    int nruns;                      /* cases that were asked for and have a result */
    int nrows;                      /* of a run: a mean and the floors of every structure that has floors */
    bool spread, has_contact;       /* low and high are there; there are contacts */
    double gap_m;                   /* of the first interface; NaN where there is none */
    enum thud_case *which;          /* (nruns) in their order */
    struct thud_sweep_ratio *ratio; /* (nruns x nrows x 1, with a spread x 3: value, low, high) */
    double *measure; /* (nruns x nmeasures x 1, with a spread x 3, which a suite alone fills) THUD_TOLD_BY_SWEEP */
    int nmeasures, nstructures;
    int *first; /* (nstructures + 1): row of a structure's mean; its floors from 1 up come next */
};

struct thud_sweep_table {
    int nrecords, nstructures, naxes;
    int measures;                /* of the scene, for the names of cases */
    bool free_links, need_links; /* links act in the motion without pounding of ratios, and of required gaps */
    double sensitivity;          /* of the spread; 0: there is none */
    int motions; /* over how many ground motions the values are medians, low and high 16 and 84 %; 0: of one each */
    int draws;   /* number of independent motions: fewer than THUD_SHARES_LEAST have medians only */
    const char *const *record; /* (nrecords) names */
    const struct thud_record *const
        *motion; /* (nrecords) whose description figures show if the name is that of the file; NULL: names only */
    const char *const *structure;         /* (nstructures) names */
    const enum thud_structure_kind *kind; /* (nstructures) */
    const struct thud_sweep_axis *axis;   /* (naxes) */
    size_t nrows;                         /* of all runs */
    size_t npoints;
    struct thud_sweep_summary *const *point; /* (npoints): by record, then parameters, the last axis fastest */
    const struct thud_sweep_shares *shares;  /* (npoints x THUD_SWEEP_CASES_MAX) of a suite's runs; else NULL */
    /* (2 x nrecords) the levels that decide the gap: where the study needs the widest one, and after these where the
     * narrowest; interface 0: there is none. Of a suite (2 x motions), those of the table that it was made of */
    const struct thud_sweep_need_row *need;
};

/* Returns the bytes of a summary. */
size_t thud_sweep_summary_size(int nruns, int nstructures, int nrows, bool spread);
/* Creates an empty one for structures with this many floors each; NULL when out of memory. */
struct thud_sweep_summary *thud_sweep_summary_create(int nruns, int nstructures, const int *floors, bool spread);
/* Makes that of a finished point; *out is NULL if no requested case has a result. Errors: THUD_MEMORY. */
enum thud_status thud_sweep_summary_make(const struct thud_sweep_plan *plan, const struct thud_sweep_point *point,
                                         struct thud_sweep_summary **out, struct thud_error *err);

/* Settings of the varied keys from `axis` on. */
long thud_sweep_table_settings(const struct thud_sweep_table *table, int axis);
/* (settings x nrecords) the points of a table; NULL: no result. To be freed; NULL: out of memory. */
const struct thud_sweep_summary **thud_sweep_table_points(const struct thud_sweep_table *table);

/* Makes the table of a suite: one record, whose points have the statistics over all records of `table`. These are
 * medians, and as low and high the 16 and 84 % fractiles (of the logarithms if positive). It points to the names and
 * axes of `table`. Free with thud_sweep_suite_free. Errors: THUD_MEMORY. */
enum thud_status thud_sweep_suite_make(const struct thud_sweep_table *table, struct thud_sweep_table **out,
                                       struct thud_error *err);
void thud_sweep_suite_free(struct thud_sweep_table *suite);

static inline int thud_sweep_summary_floors(const struct thud_sweep_summary *d, int structure)
{
    int rows = d->first[structure + 1] - d->first[structure];
    return rows > 0 ? rows - 1 : 0;
}

/* Returns the values of run k and a floor of a structure (0: the mean); NULL: no such floor, or no spread. */
static inline struct thud_sweep_ratio *thud_sweep_summary_ratio(const struct thud_sweep_summary *d, int k,
                                                                int structure, int floor, enum thud_sweep_end end)
{
    int row = d->first[structure] + floor, ends = d->spread ? 3 : 1;
    if (row >= d->first[structure + 1] || (int)end >= ends)
        return NULL;
    return &d->ratio[((ptrdiff_t)k * d->nrows + row) * ends + end];
}

/* Returns a measure of run k, with a spread by its end; `structure` is used for those of structures. */
static inline double *thud_sweep_summary_measure(const struct thud_sweep_summary *d, int k, enum thud_measure measure,
                                                 int structure, enum thud_sweep_end end)
{
    int at = thud_measure_place(THUD_TOLD_BY_SWEEP, d->nstructures, measure) +
             (thud_measure_info(measure)->of_structure ? structure : 0);
    return &d->measure[((ptrdiff_t)k * d->nmeasures + at) * (d->spread ? 3 : 1) + end];
}

/* Returns the value of one structure, -1: of all. */
static inline double thud_sweep_summary_value(const struct thud_sweep_summary *d, int k, enum thud_measure measure,
                                              int structure, enum thud_sweep_end end)
{
    const struct thud_measure_info *info = thud_measure_info(measure);
    if (!info->of_structure || structure >= 0)
        return *thud_sweep_summary_measure(d, k, measure, structure, end);
    double most = NAN; /* NaN is ignored */
    for (int s = 0; s < d->nstructures; s++)
        most = fmax(most, *thud_sweep_summary_measure(d, k, measure, s, end));
    return most;
}

/* Returns the run of a case; -1: none. */
static inline int thud_sweep_summary_find(const struct thud_sweep_summary *d, enum thud_case which)
{
    for (int k = 0; k < d->nruns; k++)
        if (d->which[k] == which)
            return k;
    return -1;
}
