/* What a study keeps of a point for its figures and tables. */
#include "study/sweep/sweep_table.h"

#include <math.h>
#include <stdlib.h>

static size_t ratios_of(int nruns, int nrows, bool spread)
{
    return (size_t)nruns * (size_t)nrows * (spread ? 3 : 1);
}

size_t thud_sweep_summary_size(int nruns, int nstructures, int nrows, bool spread)
{
    const int nmeasures = thud_measure_place(THUD_TOLD_BY_SWEEP, nstructures, THUD_MEASURES);
    return sizeof(struct thud_sweep_summary) + ratios_of(nruns, nrows, spread) * sizeof(struct thud_sweep_ratio) +
           ratios_of(nruns, nmeasures, spread) * sizeof(double) + (size_t)nruns * sizeof(enum thud_case) +
           ((size_t)nstructures + 1) * sizeof(int);
}

struct thud_sweep_summary *thud_sweep_summary_create(int nruns, int nstructures, const int *floors, bool spread)
{
    int nrows = 0;
    for (int s = 0; s < nstructures; s++)
        nrows += floors[s] > 0 ? floors[s] + 1 : 0;
    struct thud_sweep_summary *d = calloc(1, thud_sweep_summary_size(nruns, nstructures, nrows, spread));
    if (!d)
        return NULL;
    d->nruns = nruns;
    d->nrows = nrows;
    d->nstructures = nstructures;
    d->nmeasures = thud_measure_place(THUD_TOLD_BY_SWEEP, nstructures, THUD_MEASURES);
    d->spread = spread;
    d->ratio = (void *)(d + 1);
    d->measure = (void *)(d->ratio + ratios_of(nruns, nrows, spread));
    d->which = (void *)(d->measure + ratios_of(nruns, d->nmeasures, spread));
    d->first = (void *)(d->which + nruns);
    for (int s = 0; s < nstructures; s++)
        d->first[s + 1] = d->first[s] + (floors[s] > 0 ? floors[s] + 1 : 0);
    for (size_t i = 0; i < ratios_of(nruns, d->nmeasures, spread); i++)
        d->measure[i] = NAN;
    return d;
}

static void put_ratios(struct thud_sweep_summary *d, const struct thud_sweep_point *point)
{
    struct thud_sweep_ratio *to = d->ratio;
    struct thud_sweep_row row;
    for (int i = 0; i < d->nruns * d->nrows; i++) {
        const double *const of[] = {row.of, row.low, row.high};
        thud_sweep_row_at(point, i, &row);
        for (int end = 0; end < (d->spread ? 3 : 1); end++)
            *to++ = (struct thud_sweep_ratio){
                of[end][THUD_MEASURE_ACCELERATION_RATIO], of[end][THUD_MEASURE_DRIFT_RATIO],
                of[end][THUD_MEASURE_ACCELERATION_FREE_RATIO], of[end][THUD_MEASURE_DRIFT_FREE_RATIO]};
    }
}

/* The measures of every run that was asked for and has a result, in the order of the rows. */
static void put_measures(const struct thud_sweep_plan *plan, const struct thud_sweep_point *point,
                         struct thud_sweep_summary *d)
{
    enum thud_measure told[THUD_MEASURES];
    const int n = thud_measures_told(THUD_TOLD_BY_SWEEP, ~0u, told);
    for (int k = 0; k < d->nruns; k++) {
        const struct thud_measured_run run = {&plan->scene, point, thud_sweep_answered(point, k)};
        d->which[k] = point->which[run.k];
        for (int i = 0; i < n; i++)
            for (int s = 0; s < (thud_measure_info(told[i])->of_structure ? d->nstructures : 1); s++)
                *thud_sweep_summary_measure(d, k, told[i], s, THUD_SWEEP_VALUE) = thud_measure_read(&run, told[i], s);
    }
}

enum thud_status thud_sweep_summary_make(const struct thud_sweep_plan *plan, const struct thud_sweep_point *point,
                                         struct thud_sweep_summary **out, struct thud_error *err)
{
    int nruns = 0;
    *out = NULL;
    if (thud_sweep_row_count(point) == 0)
        return THUD_OK;
    while (thud_sweep_answered(point, nruns) < point->ncases)
        nruns++;
    struct thud_sweep_summary *d = *out =
        thud_sweep_summary_create(nruns, point->nstructures, point->floors, point->nvariants > 1);
    if (!d)
        return thud_error_set(err, THUD_MEMORY, "out of memory for the rows of the study");
    d->record = thud_sweep_place(plan, point->index, d->at);
    d->gap_m = point->gap_m;
    d->has_contact = point->ncontacts > 0;
    put_ratios(d, point);
    put_measures(plan, point, d);
    return THUD_OK;
}

long thud_sweep_table_settings(const struct thud_sweep_table *table, int axis)
{
    long n = 1;
    for (int a = axis; a < table->naxes; a++)
        n *= table->axis[a].n;
    return n;
}

const struct thud_sweep_summary **thud_sweep_table_points(const struct thud_sweep_table *table)
{
    const size_t n = (size_t)thud_sweep_table_settings(table, 0) * (size_t)table->nrecords;
    const struct thud_sweep_summary **of = calloc(n, sizeof *of);
    for (size_t i = 0; of && i < table->npoints; i++) {
        const struct thud_sweep_summary *d = table->point[i];
        long setting = 0;
        for (int a = 0; a < table->naxes; a++)
            setting = setting * table->axis[a].n + d->at[a];
        of[setting * table->nrecords + d->record] = d;
    }
    return of;
}
