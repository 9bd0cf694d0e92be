/* The statistics of a study over its ground motions as a table of one: what shows a motion then shows the suite. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/statistics.h"
#include "ground/identity.h"
#include "study/sweep/sweep_table.h"

static const char *const no_name[] = {""};

/* Scratch of the making. */
struct making {
    const struct thud_sweep_table *table;
    const struct thud_sweep_summary **of; /* (settings x nrecords) NULL: no result */
    double *value;                        /* (nrecords) */
    int draws;                            /* independent ground motions */
};

static struct thud_fractiles fractiles(const struct making *m, const struct thud_sweep_summary *const *of,
                                       enum thud_case which, enum thud_measure measure, int structure, double limit)
{
    for (int r = 0; r < m->table->nrecords; r++) {
        int k = of[r] ? thud_sweep_summary_find(of[r], which) : -1;
        m->value[r] = k >= 0 ? thud_sweep_summary_value(of[r], k, measure, structure, THUD_SWEEP_VALUE) : NAN;
    }
    return thud_fractiles_of(m->value, (size_t)m->table->nrecords, m->draws, limit);
}

/* Of a share of the ground motions. */
static void put_band(const struct making *m, const struct thud_fractiles *f, double band[2])
{
    band[0] = band[1] = NAN;
    if (m->draws >= THUD_SHARES_LEAST)
        thud_share_band(f->above, f->n, (double)m->draws / m->table->nrecords, &band[0], &band[1]);
}

static void put_run(const struct making *m, const struct thud_sweep_summary *const *of, struct thud_sweep_summary *out,
                    int k, struct thud_sweep_shares *shares)
{
    enum thud_measure told[THUD_MEASURES];
    const int n = thud_measures_told(THUD_TOLD_BY_SWEEP, ~0u, told);
    for (int i = 0; i < n; i++)
        for (int s = 0; s < (thud_measure_info(told[i])->of_structure ? out->nstructures : 1); s++) {
            const struct thud_fractiles f = fractiles(m, of, out->which[k], told[i], s, 0);
            double *to = thud_sweep_summary_measure(out, k, told[i], s, THUD_SWEEP_VALUE);
            to[THUD_SWEEP_VALUE] = told[i] == THUD_MEASURE_IMPACTS ? round(f.median) : f.median;
            to[THUD_SWEEP_LOW] = f.p16;
            to[THUD_SWEEP_HIGH] = f.p84;
        }
    const struct thud_fractiles impacts = fractiles(m, of, out->which[k], THUD_MEASURE_IMPACTS, -1, 0);
    const struct thud_fractiles worst = fractiles(m, of, out->which[k], THUD_MEASURE_ACCELERATION_RATIO, -1, 1);
    *shares = (struct thud_sweep_shares){.pounding = impacts.share, .worse = worst.share};
    put_band(m, &impacts, shares->pounding_band);
    put_band(m, &worst, shares->worse_band);
}

/* Each ratio of run k and a floor over the ground motions. */
static void put_ratios(const struct making *m, const struct thud_sweep_summary *const *of,
                       struct thud_sweep_summary *out, int k, int structure, int floor)
{
    for (size_t q = 0; q < sizeof(struct thud_sweep_ratio) / sizeof(double); q++) {
        for (int r = 0; r < m->table->nrecords; r++) {
            int from = of[r] ? thud_sweep_summary_find(of[r], out->which[k]) : -1;
            const double *x =
                from >= 0 ? (void *)thud_sweep_summary_ratio(of[r], from, structure, floor, THUD_SWEEP_VALUE) : NULL;
            m->value[r] = x ? x[q] : NAN;
        }
        struct thud_fractiles f = thud_fractiles_of(m->value, (size_t)m->table->nrecords, m->draws, 1);
        const double end[] = {[THUD_SWEEP_VALUE] = f.median, [THUD_SWEEP_LOW] = f.p16, [THUD_SWEEP_HIGH] = f.p84};
        for (int e = THUD_SWEEP_VALUE; e <= THUD_SWEEP_HIGH; e++)
            ((double *)(void *)thud_sweep_summary_ratio(out, k, structure, floor, (enum thud_sweep_end)e))[q] = end[e];
    }
}

/* The point of a setting; NULL: out of memory. `like`: one of its ground motions. */
static struct thud_sweep_summary *make_point(const struct making *m, const struct thud_sweep_summary *const *of,
                                             const struct thud_sweep_summary *like, struct thud_sweep_shares *shares)
{
    int floors[THUD_STRUCTURES_MAX] = {0};
    enum thud_case which[THUD_SWEEP_CASES_MAX];
    int nruns = 0;
    for (int c = THUD_CASE_AS_WRITTEN; c < THUD_CASES; c++)
        for (int r = 0; r < m->table->nrecords; r++)
            if (of[r] && thud_sweep_summary_find(of[r], (enum thud_case)c) >= 0) {
                which[nruns++] = (enum thud_case)c;
                break;
            }
    for (int s = 0; s < m->table->nstructures; s++)
        floors[s] = thud_sweep_summary_floors(like, s);
    struct thud_sweep_summary *out = thud_sweep_summary_create(nruns, m->table->nstructures, floors, true);
    if (!out)
        return NULL;
    memcpy(out->at, like->at, sizeof out->at);
    out->has_contact = like->has_contact;
    out->gap_m = like->gap_m;
    for (int k = 0; k < nruns; k++) {
        out->which[k] = which[k];
        put_run(m, of, out, k, &shares[k]);
        for (int s = 0; s < m->table->nstructures; s++)
            for (int f = 0; floors[s] > 0 && f <= floors[s]; f++)
                put_ratios(m, of, out, k, s, f);
    }
    return out;
}

static bool fill(const struct making *m, struct thud_sweep_table *suite, struct thud_sweep_summary **point,
                 struct thud_sweep_shares *shares)
{
    size_t records = (size_t)m->table->nrecords;
    for (size_t i = 0; i < (size_t)thud_sweep_table_settings(m->table, 0); i++) {
        const struct thud_sweep_summary *const *of = m->of + i * records, *like = NULL;
        for (size_t r = 0; r < records && !like; r++)
            like = of[r];
        if (!like)
            continue;
        point[suite->npoints] = make_point(m, of, like, shares + suite->npoints * THUD_SWEEP_CASES_MAX);
        if (!point[suite->npoints])
            return false;
        suite->nrows += (size_t)point[suite->npoints]->nruns * (size_t)point[suite->npoints]->nrows;
        suite->npoints++;
    }
    return true;
}

enum thud_status thud_sweep_suite_make(const struct thud_sweep_table *table, struct thud_sweep_table **out,
                                       struct thud_error *err)
{
    size_t settings = (size_t)thud_sweep_table_settings(table, 0), records = (size_t)table->nrecords;
    struct making m = {.table = table, .draws = thud_motions_recordings(table->motion, table->nrecords, NULL)};
    struct thud_sweep_table *suite = malloc(sizeof *suite);
    struct thud_sweep_summary **point = calloc(settings, sizeof *point);
    m.of = thud_sweep_table_points(table);
    m.value = malloc(records * sizeof *m.value);
    struct thud_sweep_shares *shares = malloc((settings * THUD_SWEEP_CASES_MAX) * sizeof *shares);
    bool made = suite && point && m.of && m.value && shares;
    if (suite) {
        *suite = *table;
        suite->nrecords = 1;
        suite->record = no_name;
        suite->motions = table->nrecords;
        suite->draws = m.draws;
        suite->sensitivity = 0;
        suite->nrows = suite->npoints = 0;
        suite->point = point;
        suite->shares = shares;
    }
    made = made && fill(&m, suite, point, shares);
    free(m.of);
    free(m.value);
    *out = made ? suite : NULL;
    if (made)
        return THUD_OK;
    if (suite)
        thud_sweep_suite_free(suite);
    else {
        free(point);
        free(shares);
    }
    return thud_error_set(err, THUD_MEMORY, "out of memory");
}

void thud_sweep_suite_free(struct thud_sweep_table *suite)
{
    if (!suite)
        return;
    for (size_t i = 0; i < suite->npoints; i++)
        free(suite->point[i]);
    free((void *)suite->point);
    free((void *)suite->shares);
    free(suite);
}
