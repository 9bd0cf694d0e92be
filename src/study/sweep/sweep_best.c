#include "study/sweep/sweep_best.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

/* A ratio so near to 1 is that of a bumper that is struck by nothing, or hardly. */
#define THUD_SWEEP_IDLE 5e-4

/* Largest ratios over the structures for one run (measure.h); NaN: no result. */
struct cell {
    double acceleration, drift;
};

/* Where a run's numbers stand: record, case, other keys, value of the key. */
struct grid {
    const struct thud_sweep_table *table;
    int axis, n[THUD_VARY_MAX];
    long others;       /* settings of the other keys */
    struct cell *cell; /* (records x THUD_CASES + 1 x others x n[axis]) */
};

static struct cell *cell_at(const struct grid *g, int record, int which, long other, int at)
{
    return &g->cell[((((long)record * (THUD_CASES + 1) + which + 1) * g->others) + other) * g->n[g->axis] + at];
}

static void fill(const struct grid *g)
{
    const struct thud_sweep_table *t = g->table;
    for (size_t i = 0; i < t->npoints; i++) {
        const struct thud_sweep_summary *d = t->point[i];
        long other = 0;
        for (int a = 0; a < t->naxes; a++)
            other = a == g->axis ? other : other * g->n[a] + d->at[a];
        for (int k = 0; k < d->nruns; k++) {
            *cell_at(g, d->record, d->which[k], other, d->at[g->axis]) =
                (struct cell){thud_sweep_summary_value(d, k, THUD_MEASURE_ACCELERATION_RATIO, -1, THUD_SWEEP_VALUE),
                              thud_sweep_summary_value(d, k, THUD_MEASURE_DRIFT_RATIO, -1, THUD_SWEEP_VALUE)};
        }
    }
}

/* One record's cell, or the worst over all of them where each has a result. */
static struct cell pick(const struct grid *g, int record, int which, long other, int at)
{
    if (record >= 0)
        return *cell_at(g, record, which, other, at);
    struct cell worst = {NAN, NAN};
    for (int r = 0; r < g->table->nrecords; r++) {
        struct cell c = *cell_at(g, r, which, other, at);
        if (isnan(c.acceleration))
            return (struct cell){NAN, NAN};
        worst.acceleration = fmax(worst.acceleration, c.acceleration);
        worst.drift = fmax(worst.drift, c.drift);
    }
    return worst;
}

/* false: no value had a result. */
static bool find(const struct grid *g, int record, int which, long other, struct thud_sweep_best *out)
{
    const struct thud_sweep_axis *axis = &g->table->axis[g->axis];
    int best = -1, low, high, first = -1, last = -1;
    *out = (struct thud_sweep_best){.record = record, .which = (enum thud_case)which, .ratio = INFINITY};
    for (int i = 0; i < axis->n; i++) {
        struct cell c = pick(g, record, which, other, i);
        if (isnan(c.acceleration))
            continue;
        out->values++;
        first = first < 0 ? i : first;
        last = i;
        out->worst_ratio = fmax(out->worst_ratio, c.acceleration);
        if (c.acceleration < out->ratio) {
            best = i;
            out->ratio = c.acceleration;
            out->drift_ratio = c.drift;
        }
    }
    if (best < 0)
        return false;
    out->at_end = !axis->words && out->values > 1 && (best == first || best == last);
    out->idle = fabs(out->ratio - 1) < THUD_SWEEP_IDLE;
    double limit = out->ratio * (1 + THUD_SWEEP_BEST_PER_CENT / 100.0);
    for (low = best; low > 0 && pick(g, record, which, other, low - 1).acceleration <= limit;)
        low--;
    for (high = best; high + 1 < axis->n && pick(g, record, which, other, high + 1).acceleration <= limit;)
        high++;
    out->flat_least = axis->value[low] < axis->value[high] ? low : high;
    out->flat_most = low + high - out->flat_least;
    for (int a = g->table->naxes - 1; a >= 0; a--) {
        out->at[a] = best;
        if (a == g->axis)
            continue;
        assert(g->n[a] > 0);
        out->at[a] = (int)(other % g->n[a]);
        other /= g->n[a];
    }
    return true;
}

long thud_sweep_best(const struct thud_sweep_table *table, int axis, struct thud_sweep_best **out)
{
    struct grid g = {.table = table, .axis = axis, .others = 1};
    for (int a = 0; a < table->naxes; a++) {
        g.n[a] = table->axis[a].n;
        g.others *= a == axis ? 1 : g.n[a];
    }
    size_t cells = (size_t)table->nrecords * (THUD_CASES + 1) * (size_t)g.others * (size_t)g.n[axis];
    g.cell = calloc(cells, sizeof *g.cell);
    *out = malloc(((size_t)table->nrecords + 1) * (THUD_CASES + 1) * (size_t)g.others * sizeof **out);
    if (!g.cell || !*out) {
        free(g.cell);
        free(*out);
        *out = NULL;
        return -1;
    }
    for (size_t i = 0; i < cells; i++)
        g.cell[i] = (struct cell){NAN, NAN};
    fill(&g);
    long count = 0;
    for (int which = THUD_CASE_AS_WRITTEN; which < THUD_CASES; which++)
        for (long other = 0; other < g.others && which != THUD_CASE_NONE; other++) {
            for (int r = 0; r < table->nrecords; r++)
                count += find(&g, r, which, other, *out + count);
            if (table->nrecords > 1)
                count += find(&g, -1, which, other, *out + count);
        }
    free(g.cell);
    return count;
}
