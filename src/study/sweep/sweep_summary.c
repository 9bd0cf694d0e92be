/* What a study keeps of a point for its figures and tables. */
#include "base/largest.h"
#include "study/sweep/sweep_table.h"

#include <math.h>
#include <stdlib.h>

static size_t ratios_of(int nruns, int nrows, bool spread)
{
    return (size_t)nruns * (size_t)nrows * (spread ? 3 : 1);
}

size_t thud_sweep_summary_size(int nruns, int nstructures, int nrows, bool spread)
{
    return sizeof(struct thud_sweep_summary) + (size_t)nruns * sizeof(struct thud_sweep_run) +
           ratios_of(nruns, nrows, spread) * sizeof(struct thud_sweep_ratio) +
           ratios_of(nruns, nstructures, spread) * sizeof(struct thud_sweep_storeys) +
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
    d->spread = spread;
    d->run = (void *)(d + 1);
    d->ratio = (void *)(d->run + nruns);
    d->storeys = (void *)(d->ratio + ratios_of(nruns, nrows, spread));
    d->first = (void *)(d->storeys + ratios_of(nruns, nstructures, spread));
    for (int s = 0; s < nstructures; s++)
        d->first[s + 1] = d->first[s] + (floors[s] > 0 ? floors[s] + 1 : 0);
    for (int k = 0; k < nruns; k++)
        d->run[k].shear_n = d->run[k].capacity_ratio = NAN;
    for (size_t i = 0; i < ratios_of(nruns, nstructures, spread); i++)
        d->storeys[i] = (struct thud_sweep_storeys){NAN, NAN};
    return d;
}

static void put_ratios(struct thud_sweep_summary *d, const struct thud_sweep_row *row)
{
    struct thud_sweep_ratio *to = d->ratio;
    for (int i = 0; i < d->nruns * d->nrows; i++, row++) {
        const double *const of[] = {row->of, row->low, row->high};
        for (int end = 0; end < (d->spread ? 3 : 1); end++)
            *to++ = (struct thud_sweep_ratio){of[end][THUD_SWEEP_ACCELERATION_RATIO], of[end][THUD_SWEEP_DRIFT_RATIO],
                                              of[end][THUD_SWEEP_ACCELERATION_FREE_RATIO],
                                              of[end][THUD_SWEEP_DRIFT_FREE_RATIO]};
    }
}

static void put_storeys(struct thud_sweep_summary *d, int nstructures, const struct thud_sweep_row *row)
{
    for (int k = 0; k < d->nruns; k++, row += d->nrows)
        for (int s = 0; s < nstructures; s++) {
            struct thud_sweep_storeys most = {NAN, NAN};
            for (int i = d->first[s] + 1; i < d->first[s + 1]; i++) { /* a NaN gives way */
                most.ductility = fmax(most.ductility, row[i].of[THUD_SWEEP_DUCTILITY]);
                most.permanent_m = fmax(most.permanent_m, fabs(row[i].of[THUD_SWEEP_PERMANENT]));
            }
            *thud_sweep_summary_storeys(d, k, nstructures, s, THUD_SWEEP_VALUE) = most;
        }
}

static void put_contacts(struct thud_sweep_run *run, const struct thud_sweep_contact_row *row, int n)
{
    for (int c = 0; c < n; c++) { /* a NaN gives way */
        run->shear_n = fmax(run->shear_n, fmax(row[c].of.shear_lower_n, row[c].of.shear_upper_n));
        run->capacity_ratio = fmax(run->capacity_ratio, row[c].of.capacity_ratio);
        run->impacts += row[c].of.impacts;
        run->force_n = thud_larger(run->force_n, row[c].of.force_n);
        run->indentation_m = thud_larger(run->indentation_m, row[c].of.indentation_m);
    }
}

enum thud_status thud_sweep_summary_make(const struct thud_sweep_plan *plan, const struct thud_sweep_point *point,
                                         struct thud_sweep_summary **out, struct thud_error *err)
{
    int rows = thud_sweep_rows(plan, point, NULL), contacts = thud_sweep_contact_rows(plan, point, NULL);
    *out = NULL;
    if (rows == 0)
        return THUD_OK;
    struct thud_sweep_row *row = malloc((size_t)rows * sizeof *row);
    struct thud_sweep_contact_row *contact = malloc(((size_t)contacts + 1) * sizeof *contact);
    if (row && contact) {
        thud_sweep_rows(plan, point, row);
        thud_sweep_contact_rows(plan, point, contact);
        int nruns = 1;
        for (int i = 1; i < rows; i++)
            nruns += row[i].which != row[i - 1].which;
        *out = thud_sweep_summary_create(nruns, point->nstructures, point->floors, point->nvariants > 1);
    }
    struct thud_sweep_summary *d = *out;
    for (int k = 0; d && k < d->nruns; k++) {
        d->run[k].which = row[k * d->nrows].which;
        put_contacts(&d->run[k], contact + k * point->ncontacts, point->ncontacts);
    }
    if (d) {
        d->record = thud_sweep_place(plan, point->index, d->at);
        d->gap_m = point->gap_m;
        d->has_contact = point->ncontacts > 0;
        put_ratios(d, row);
        put_storeys(d, point->nstructures, row);
    }
    free(row);
    free(contact);
    return d ? THUD_OK : thud_error_set(err, THUD_MEMORY, "out of memory for the rows of the study");
}
