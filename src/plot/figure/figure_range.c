/* What the axes of a panel show, and the key of a figure: one result for every way of drawing. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "plot/figure/figure.h"

static void stretch(struct thud_range *range, double value, bool log)
{
    if (!isfinite(value) || (log && value <= 0.0))
        return;
    if (!(value >= range->least))
        range->least = value;
    if (!(value <= range->most))
        range->most = value;
}

static bool is_set(const struct thud_axis *axis)
{
    return !isnan(axis->least) && !isnan(axis->most);
}

static bool inside(const struct thud_axis *axis, double value)
{
    return !(value < axis->least) && !(value > axis->most);
}

/* Only what is seen counts: with x limited by hand, y follows the points between the limits. */
static void stretch_series(struct thud_range *range, const struct thud_panel *panel, const struct thud_series *series,
                           enum thud_side side)
{
    const struct thud_axis *axis = &panel->axis[side], *other = &panel->axis[1 - (int)side];
    const double *value = side == THUD_X ? series->x : series->y;
    const double *across = side == THUD_X ? series->y : series->x;
    for (size_t i = 0; i < series->n; i++) {
        if (!isfinite(series->x[i]) || !isfinite(series->y[i]) || !inside(other, across[i]))
            continue;
        stretch(range, value[i], axis->log);
        if (side == THUD_Y && series->y_high)
            stretch(range, series->y_high[i], axis->log);
    }
    if (side == THUD_Y && series->style.kind == THUD_BARS)
        stretch(range, 0.0, axis->log);
}

/* A map's cells reach half way to their neighbours. */
static void stretch_map(struct thud_range *range, const double *at, size_t n, bool log)
{
    if (!n)
        return;
    double first = n > 1 ? 0.5 * (at[1] - at[0]) : 0.5, last = n > 1 ? 0.5 * (at[n - 1] - at[n - 2]) : 0.5;
    stretch(range, at[0] - first, log);
    stretch(range, at[n - 1] + last, log);
}

static double round_step(double width, int parts)
{
    double raw = width / parts * (1.0 - 1e-9), base = pow(10.0, floor(log10(raw)));
    double times = raw / base;
    return base * (times <= 1.0 ? 1.0 : times <= 2.0 ? 2.0 : times <= 2.5 ? 2.5 : times <= 5.0 ? 5.0 : 10.0);
}

static struct thud_range round_linear(struct thud_range range, const struct thud_axis *axis, enum thud_side side,
                                      bool tight)
{
    if (isnan(range.least)) { /* nothing to show */
        range.least = 0.0;
        range.most = 1.0;
    }
    double width = range.most - range.least;
    if (fabs(range.least) < 1e-6 * width && isnan(axis->least))
        range.least = 0.0; /* what rounding left of a 0 */
    if (fabs(range.most) < 1e-6 * width && isnan(axis->most))
        range.most = 0.0;
    if (width <= 1e-12 * fmax(fabs(range.least), fabs(range.most))) {
        double room = range.most != 0.0 ? 0.1 * fabs(range.most) : 1.0;
        range.least -= room;
        range.most += room;
        width = 2.0 * room;
    }
    range.step = round_step(width, side == THUD_X ? 7 : 6);
    if (tight)
        return range;
    /* along x a fifth of a step is round enough; no result lies on the frame, except at 0 */
    double unit = side == THUD_X ? 0.2 * range.step : range.step,
           hair = side == THUD_Y || axis->results ? 0.03 * width : 0.0;
    double bottom = range.least >= 0.0 ? 0.0 : -INFINITY; /* what is never negative needs no room there */
    if (isnan(axis->least))
        range.least = fmax(bottom, unit * floor((range.least - (range.least == 0.0 ? 0.0 : hair)) / unit + 1e-9));
    if (isnan(axis->most))
        range.most = unit * ceil((range.most + (range.most == 0.0 ? 0.0 : hair)) / unit - 1e-9);
    return range;
}

static struct thud_range round_log(struct thud_range range, const struct thud_axis *axis, enum thud_side side)
{
    if (isnan(range.least))
        return (struct thud_range){1.0, 10.0, 0.0};
    const double low = log10(range.least), high = log10(range.most),
                 hair = side == THUD_Y || axis->results ? 0.02 * (high - low) : 0.0; /* no result on the frame */
    double least = floor(low + 1e-9), most = ceil(high - 1e-9);
    least = low - least < hair ? low - 2.0 * hair : least;
    most = most - high < hair ? high + 2.0 * hair : most;
    if (isnan(axis->least))
        range.least = pow(10.0, least);
    if (isnan(axis->most))
        range.most = pow(10.0, most > least ? most : least + 1.0);
    range.step = 0.0;
    return range;
}

static struct thud_range data_range(const struct thud_panel *panel, enum thud_side side)
{
    const struct thud_axis *axis = &panel->axis[side];
    struct thud_range range = {NAN, NAN, 0.0};
    for (int i = 0; i < panel->nseries; i++)
        stretch_series(&range, panel, panel->series[i], side);
    if (panel->map)
        stretch_map(&range, side == THUD_X ? panel->map->x : panel->map->y,
                    side == THUD_X ? panel->map->nx : panel->map->ny, axis->log);
    for (int i = 0; i < panel->nmarks; i++) {
        if (panel->mark[i].side == side && panel->mark[i].from == panel->mark[i].to)
            stretch(&range, panel->mark[i].from, axis->log);
    }
    return range;
}

struct thud_range thud_panel_range(const struct thud_panel *panel, enum thud_side side)
{
    const struct thud_axis *axis = &panel->axis[side];
    struct thud_range range = {axis->least, axis->most, 0.0};
    if (!is_set(axis)) { /* else no sample is looked at */
        range = data_range(panel, side);
        range.least = isnan(axis->least) ? range.least : axis->least;
        range.most = isnan(axis->most) ? range.most : axis->most;
    }
    if (isnan(range.least) && !isnan(range.most))
        range.least = axis->log ? 0.1 * range.most : range.most - 1.0;
    if (isnan(range.most) && !isnan(range.least))
        range.most = axis->log ? 10.0 * range.least : range.least + 1.0;
    return axis->log ? round_log(range, axis, side) : round_linear(range, axis, side, panel->map != NULL);
}

/* Curves of zeros alone fit into any scale. */
static void widen(const struct thud_panel *panel, enum thud_side side, double *least, double *most)
{
    const struct thud_range data = data_range(panel, side), range = thud_panel_range(panel, side);
    if (data.least == 0.0 && data.most == 0.0)
        return;
    *least = fmin(*least, range.least);
    *most = fmax(*most, range.most);
}

void thud_figure_share_scale(struct thud_figure *figure, enum thud_side side, int first, int step, int n,
                             const struct thud_figure *other)
{
    double least = INFINITY, most = -INFINITY;
    for (int k = 0; figure && k < n; k++) {
        const int p = first + k * step;
        if (!figure->panel[p].used || figure->panel[p].closer || is_set(&figure->panel[p].axis[side]))
            continue;
        widen(&figure->panel[p], side, &least, &most);
        if (other)
            widen(&other->panel[p], side, &least, &most);
    }
    for (int k = 0; least <= most && k < n; k++)
        if (!is_set(&figure->panel[first + k * step].axis[side]))
            thud_panel_limits(&figure->panel[first + k * step], side, least, most);
}

static bool listed(const struct thud_series **entry, int n, const char *name)
{
    for (int i = 0; i < n; i++) {
        if (!strcmp(entry[i]->name, name))
            return true;
    }
    return false;
}

/* Nothing is seen of a curve without a point between the limits. */
static bool is_seen(const struct thud_panel *panel, const struct thud_series *series)
{
    for (size_t i = 0; i < series->n; i++)
        if (isfinite(series->x[i]) && isfinite(series->y[i]) && inside(&panel->axis[THUD_X], series->x[i]))
            return true;
    return false;
}

int thud_figure_key(const struct thud_figure *figure, const struct thud_series **entry, int most)
{
    int n = 0;
    for (int p = 0; p < figure->rows * figure->columns; p++) {
        const struct thud_panel *panel = &figure->panel[p];
        for (int i = 0; i < panel->nseries; i++) {
            const struct thud_series *series = panel->series[i];
            if (!*series->name || thud_series_is_shade(series) || listed(entry, n < most ? n : most, series->name) ||
                !is_seen(panel, series))
                continue;
            if (n < most)
                entry[n] = series;
            n++;
        }
    }
    for (int i = 1; i < (n < most ? n : most); i++) { /* those of one colour stay as they came */
        const struct thud_series *moved = entry[i];
        int to = i;
        for (; to > 0 && entry[to - 1]->style.color > moved->style.color; to--)
            entry[to] = entry[to - 1];
        entry[to] = moved;
    }
    return n;
}

char *thud_axis_text(const struct thud_axis *axis, char *text, size_t size)
{
    if (*axis->unit)
        snprintf(text, size, "%s (%s)", axis->label, axis->unit);
    else
        snprintf(text, size, "%s", axis->label);
    return text;
}
