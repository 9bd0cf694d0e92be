/* Curves of the figures of a study. */
#include <math.h>
#include <stdio.h>

#include "plot/figures/figures_sweep_internal.h"

const char *const thud_sweep_ratio_label[THUD_TOLD_RATIOS] = {"Peak acceleration ratio", "Peak drift ratio"};

static double ratio(const struct thud_sweep_summary *d, int k, const struct thud_wanted *w, enum thud_sweep_end end)
{
    const struct thud_sweep_ratio *x = thud_sweep_summary_ratio(d, k, w->structure, w->floor, end);
    if (!x)
        return NAN;
    if (w->free)
        return w->told == THUD_TOLD_ACCELERATION ? x->acceleration_free : x->drift_free;
    return w->told == THUD_TOLD_ACCELERATION ? x->acceleration : x->drift;
}

/* Measures by the quantity shown, with the factor to its unit. */
static const struct shown_measure {
    enum thud_measure measure;
    double factor;
} shown[] = {
    [THUD_TOLD_IMPACTS] = {THUD_MEASURE_IMPACTS, 1},     [THUD_TOLD_FORCE] = {THUD_MEASURE_FORCE, 1e-6},
    [THUD_TOLD_SHEAR] = {THUD_MEASURE_SHEAR, 1e-6},      [THUD_TOLD_CAPACITY] = {THUD_MEASURE_COLUMNS, 1},
    [THUD_TOLD_DUCTILITY] = {THUD_MEASURE_DUCTILITY, 1}, [THUD_TOLD_PERMANENT] = {THUD_MEASURE_PERMANENT, 1e3}};

static double share_of(const struct thud_sweep_shares *shares, enum thud_told told, enum thud_sweep_end end)
{
    const bool pounding = told == THUD_TOLD_POUNDING;
    if (!shares)
        return NAN;
    if (end == THUD_SWEEP_VALUE)
        return 100 * (pounding ? shares->pounding : shares->worse);
    return 100 * (pounding ? shares->pounding_band : shares->worse_band)[end == THUD_SWEEP_HIGH];
}

static double value_of(const struct thud_sweep_table *table, size_t i, int k, const struct thud_wanted *w,
                       enum thud_sweep_end end)
{
    const struct thud_sweep_summary *d = table->point[i];
    const struct thud_sweep_shares *shares =
        table->shares ? &table->shares[i * THUD_SWEEP_CASES_MAX + (size_t)k] : NULL;
    if (w->told < (enum thud_told)THUD_TOLD_RATIOS)
        return ratio(d, k, w, end);
    const bool of_contacts = w->told < THUD_TOLD_DUCTILITY;
    if (of_contacts && !d->has_contact)
        return NAN;
    if (w->told == THUD_TOLD_POUNDING || w->told == THUD_TOLD_WORSE)
        return share_of(shares, w->told, end);
    if (of_contacts && (!shares || !d->spread || w->told == THUD_TOLD_IMPACTS)) /* of these there is no spread */
        end = THUD_SWEEP_VALUE;
    return shown[w->told].factor *
           thud_sweep_summary_value(d, k, shown[w->told].measure, of_contacts ? -1 : w->structure, end);
}

double thud_sweep_value(const struct thud_sweep_table *table, size_t i, const struct thud_wanted *wanted,
                        enum thud_sweep_end end)
{
    const int k = thud_sweep_summary_find(table->point[i], wanted->which);
    return k < 0 ? (double)NAN : value_of(table, i, k, wanted, end);
}

bool thud_sweep_is_told(const struct thud_sweep_table *table, enum thud_told told, int structure)
{
    const struct thud_wanted wanted = {.told = told, .structure = structure};
    for (size_t i = 0; i < table->npoints; i++)
        for (int k = 0; k < table->point[i]->nruns; k++)
            if (!isnan(value_of(table, i, k, &wanted, THUD_SWEEP_VALUE)))
                return true;
    return false;
}

static bool is_on(const struct thud_sweep_table *table, const struct thud_wanted *w, const struct thud_sweep_summary *d)
{
    return d->record == w->record && thud_sweep_is_drawn(table, d, 1, w->at);
}

/* Of shares there are bars, and of numbers of impacts nothing. */
static bool is_share(enum thud_told told)
{
    return told == THUD_TOLD_POUNDING || told == THUD_TOLD_WORSE;
}

/* A band, or a bar for each of the words of a list. */
void thud_sweep_shade(struct thud_panel *panel, const struct thud_sweep_table *table, const struct thud_wanted *wanted,
                      const char *name, int color)
{
    const struct thud_sweep_axis *axis = &table->axis[0];
    struct thud_style style = {.color = color, .thin = true};
    size_t each = thud_axis_has_numbers(axis) ? 1 : 3;
    const bool sensitive = table->sensitivity > 0 && wanted->told < (enum thud_told)THUD_TOLD_RATIOS;
    if ((!sensitive && table->motions == 0) || wanted->told == THUD_TOLD_IMPACTS || is_share(wanted->told))
        return;
    struct thud_series *series = thud_panel_fill(panel, style, name, each * (size_t)axis->n, NULL, NULL, NULL);
    if (!series)
        return;
    for (size_t i = 0; i < series->n; i++) {
        series->x[i] = thud_axis_place(axis, (int)(i / each)) + (each > 1 ? 0.2 * ((double)(i % each) - 0.5) : 0);
        series->y[i] = series->y_high[i] = NAN;
    }
    for (size_t i = 0; i < table->npoints; i++) {
        const struct thud_sweep_summary *d = table->point[i];
        for (size_t k = 0; is_on(table, wanted, d) && k < (each > 1 ? 2 : 1); k++) {
            series->y[(size_t)d->at[0] * each + k] = thud_sweep_value(table, i, wanted, THUD_SWEEP_LOW);
            series->y_high[(size_t)d->at[0] * each + k] = thud_sweep_value(table, i, wanted, THUD_SWEEP_HIGH);
        }
    }
}

/* Beside those of other cases. */
static void bar_of(struct thud_panel *panel, const struct thud_sweep_table *table, size_t i,
                   const struct thud_wanted *wanted, int color)
{
    const struct thud_sweep_axis *axis = &table->axis[0];
    const double low = thud_sweep_value(table, i, wanted, THUD_SWEEP_LOW),
                 high = thud_sweep_value(table, i, wanted, THUD_SWEEP_HIGH),
                 width = thud_axis_place(axis, axis->n - 1) - thud_axis_place(axis, 0),
                 beside = 0.005 * (2 * (int)wanted->which - 1 + (wanted->told == THUD_TOLD_WORSE)),
                 at = thud_axis_place(axis, table->point[i]->at[0]) + beside * width;
    thud_panel_bars(panel, color, 1, &at, &low, &high);
}

void thud_sweep_curve(struct thud_panel *panel, const struct thud_sweep_table *table, const struct thud_wanted *wanted,
                      const char *name, int color)
{
    const struct thud_sweep_axis *axis = &table->axis[0];
    struct thud_style style = {.kind = thud_axis_has_numbers(axis) ? THUD_LINES_POINTS : THUD_POINTS, .color = color};
    struct thud_series *series = thud_panel_add(panel, style, name, (size_t)axis->n, NULL, NULL);
    for (int i = 0; series && i < axis->n; i++) {
        series->x[i] = thud_axis_place(axis, i);
        series->y[i] = NAN;
    }
    for (size_t i = 0; series && i < table->npoints; i++) {
        const struct thud_sweep_summary *d = table->point[i];
        if (!is_on(table, wanted, d))
            continue;
        series->y[d->at[0]] = thud_sweep_value(table, i, wanted, THUD_SWEEP_VALUE);
        if (is_share(wanted->told))
            bar_of(panel, table, i, wanted, color);
    }
}

void thud_sweep_curves(struct thud_panel *panel, const struct thud_sweep_table *table, struct thud_wanted wanted)
{
    for (int i = 0; i < 2 * (THUD_CASES + 1); i++) { /* what is shaded first */
        const bool shade = i <= THUD_CASES, worse = wanted.told == THUD_TOLD_WORSE;
        wanted.which = (enum thud_case)(i % (THUD_CASES + 1) + THUD_CASE_AS_WRITTEN);
        if (!thud_sweep_has_case(table, wanted.which) || (worse && wanted.which == THUD_CASE_NONE) ||
            (shade && table->motions == 0))
            continue;
        char name[64];
        snprintf(name, sizeof name, "%s%s", thud_case_title(table->measures, wanted.which), worse ? ": worse" : "");
        (shade ? thud_sweep_shade : thud_sweep_curve)(panel, table, &wanted, name,
                                                      thud_case_color(wanted.which) + (worse ? 4 : 0));
    }
}
