#include "study/sweep/sweep_best.h"

#include <math.h>
#include <stdlib.h>

/* A ratio so near to 1 is that of a bumper that is struck by nothing, or hardly. */
#define THUD_SWEEP_IDLE 5e-4

/* Along a key, one of its settings being `step` from the next. */
struct line {
    const struct thud_sweep_table *table;
    const struct thud_sweep_summary **of; /* thud_sweep_table_points */
    int axis;
    long step;
};

/* A measure of a setting, the largest over the structures; of all records (-1) the worst where each has a result. */
static double value(const struct line *l, int record, int which, long setting, enum thud_measure measure)
{
    const int records = l->table->nrecords;
    double worst = NAN;
    for (int r = record < 0 ? 0 : record; r <= (record < 0 ? records - 1 : record); r++) {
        const struct thud_sweep_summary *d = l->of[setting * records + r];
        const int k = d ? thud_sweep_summary_find(d, (enum thud_case)which) : -1;
        if (k < 0 || isnan(thud_sweep_summary_value(d, k, THUD_MEASURE_ACCELERATION_RATIO, -1, THUD_SWEEP_VALUE)))
            return NAN;
        worst = fmax(worst, thud_sweep_summary_value(d, k, measure, -1, THUD_SWEEP_VALUE));
    }
    return worst;
}

/* From a setting at the first value of the key. false: no value had a result. */
static bool find(const struct line *l, int record, int which, long setting, struct thud_sweep_best *out)
{
    const struct thud_sweep_axis *axis = &l->table->axis[l->axis];
    int best = -1, low, high, first = -1, last = -1;
    *out = (struct thud_sweep_best){.record = record, .which = (enum thud_case)which, .ratio = INFINITY};
    for (int i = 0; i < axis->n; i++) {
        const double ratio = value(l, record, which, setting + i * l->step, THUD_MEASURE_ACCELERATION_RATIO);
        if (isnan(ratio))
            continue;
        out->values++;
        first = first < 0 ? i : first;
        last = i;
        out->worst_ratio = fmax(out->worst_ratio, ratio);
        if (ratio < out->ratio) {
            best = i;
            out->ratio = ratio;
        }
    }
    if (best < 0)
        return false;
    out->drift_ratio = value(l, record, which, setting + best * l->step, THUD_MEASURE_DRIFT_RATIO);
    out->at_end = !axis->words && out->values > 1 && (best == first || best == last);
    out->idle = fabs(out->ratio - 1) < THUD_SWEEP_IDLE;
    const double limit = out->ratio * (1 + THUD_SWEEP_BEST_PER_CENT / 100.0);
    for (low = best;
         low > 0 && value(l, record, which, setting + (low - 1) * l->step, THUD_MEASURE_ACCELERATION_RATIO) <= limit;)
        low--;
    for (high = best; high + 1 < axis->n && value(l, record, which, setting + (high + 1) * l->step,
                                                  THUD_MEASURE_ACCELERATION_RATIO) <= limit;)
        high++;
    out->flat_least = axis->value[low] < axis->value[high] ? low : high;
    out->flat_most = low + high - out->flat_least;
    for (int a = l->table->naxes - 1; a >= 0; a--) {
        out->at[a] = (int)(setting % l->table->axis[a].n);
        setting /= l->table->axis[a].n;
    }
    out->at[l->axis] = best;
    return true;
}

long thud_sweep_best(const struct thud_sweep_table *table, int axis, struct thud_sweep_best **out)
{
    const long settings = thud_sweep_table_settings(table, 0), along = table->axis[axis].n;
    struct line l = {table, thud_sweep_table_points(table), axis, thud_sweep_table_settings(table, axis + 1)};
    *out = malloc(((size_t)table->nrecords + 1) * (THUD_CASES + 1) * (size_t)(settings / along) * sizeof **out);
    if (!l.of || !*out) {
        free(l.of);
        free(*out);
        *out = NULL;
        return -1;
    }
    long count = 0;
    for (int which = THUD_CASE_AS_WRITTEN; which < THUD_CASES; which++)
        for (long setting = 0; setting < settings && which != THUD_CASE_NONE; setting++) {
            if (setting / l.step % along > 0)
                continue;
            for (int r = 0; r < table->nrecords; r++)
                count += find(&l, r, which, setting, *out + count);
            if (table->nrecords > 1)
                count += find(&l, -1, which, setting, *out + count);
        }
    free(l.of);
    return count;
}
