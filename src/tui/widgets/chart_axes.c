#include <math.h>
#include <stdio.h>
#include <string.h>

#include "tui/widgets/chart.h"

enum { TICKS_MAX = 64, TICK_TEXT = 16 };

struct ticks {
    int n;
    double at[TICKS_MAX];
    char text[TICKS_MAX][TICK_TEXT];
};

double thud_chart_along(const struct thud_range *range, bool log, double value)
{
    if (!log)
        return (value - range->least) / (range->most - range->least);
    if (!(value > 0.0))
        return NAN;
    return log10(value / range->least) / log10(range->most / range->least);
}

static void add_tick(struct ticks *ticks, double at, const char *text)
{
    if (ticks->n == TICKS_MAX)
        return;
    ticks->at[ticks->n] = at;
    snprintf(ticks->text[ticks->n++], TICK_TEXT, "%s", text);
}

/* Round numbers a whole number of cells apart, so that their distances are equal: a tick every `cells` cells (at least
 * `apart`), `step` between two, over `length` cells that hold all of the range. Of all such the one that leaves the
 * least empty; a tick less than four in all counts as much as a seventh of the range. */
static struct thud_range fit_cells(const struct thud_range *range, int length, int apart)
{
    static const double times[] = {1.0, 2.0, 2.5, 5.0};
    struct thud_range best = *range;
    double width = range->most - range->least, least = INFINITY;
    int power = (int)floor(log10(width)) - 2;
    for (int i = 0; i < 4 * 4 && length > apart && width > 0.0 && isfinite(width); i++) {
        double step = times[i % 4] * pow(10.0, power + i / 4);
        for (int c = apart; c < length && c <= 6 * apart; c++) {
            double cell = step / c, first = floor(range->least / cell + 1e-6);
            double most = cell * (first + length - 1);
            int ticks = (int)(floor(most / step + 1e-6) - ceil(first * cell / step - 1e-6)) + 1;
            double waste = (most - first * cell) / width + (ticks < 4 ? (4 - ticks) / 7.0 : 0.0);
            if (most < range->most - 1e-6 * width || ticks < 2 || waste >= least)
                continue;
            least = waste;
            best = (struct thud_range){first * cell, most, step};
        }
    }
    return best;
}

static void number_ticks(struct ticks *ticks, const struct thud_range *range)
{
    double step = range->step, first = ceil(range->least / step - 1e-6);
    for (int i = 0; step > 0.0 && i < TICKS_MAX; i++) {
        double at = (first + i) * step;
        if (at > range->most + 1e-6 * step)
            return;
        char text[TICK_TEXT];
        snprintf(text, sizeof text, "%.6g", fabs(at) < 1e-9 * step ? 0.0 : at);
        add_tick(ticks, at, text);
    }
}

static void decade_ticks(struct ticks *ticks, const struct thud_range *range)
{
    if (!(range->least > 0.0) || !isfinite(range->most))
        return; /* it has no decades */
    int first = (int)ceil(log10(range->least) - 1e-9), last = (int)floor(log10(range->most) + 1e-9);
    static const double between[] = {1.0, 2.0, 5.0};
    bool few = last - first < 2; /* decades: 2 and 5 of each besides */
    for (int i = few ? first - 1 : first; i <= last; i++)
        for (int k = 0; k < (few ? 3 : 1); k++) {
            double at = between[k] * pow(10.0, i);
            char text[TICK_TEXT];
            snprintf(text, sizeof text, i >= -2 && i <= 4 ? "%g" : "%.0e", at);
            if (at >= range->least * (1 - 1e-9) && at <= range->most * (1 + 1e-9))
                add_tick(ticks, at, text);
        }
}

static void make_ticks(const struct thud_axis *axis, const struct thud_range *range, struct ticks *ticks)
{
    ticks->n = 0;
    if (axis->nticks > 0)
        for (int i = 0; i < axis->nticks; i++)
            add_tick(ticks, axis->tick[i].at, axis->tick[i].text);
    else if (axis->log)
        decade_ticks(ticks, range);
    else
        number_ticks(ticks, range);
}

/* Whether the axis is one of numbers at equal distances, whose range may be stretched to whole cells. */
static bool is_linear(const struct thud_axis *axis)
{
    return !axis->log && axis->nticks == 0;
}

/* Only the two ends of the range: round steps might leave none or one of them in so little room. */
static void keep_ends(const struct thud_axis *axis, const struct thud_range *range, struct ticks *ticks)
{
    const double end[] = {range->least, range->most};
    if (axis->nticks > 0)
        return;
    ticks->n = 0;
    for (int i = 0; i < 2; i++) {
        char text[TICK_TEXT];
        snprintf(text, sizeof text, "%.6g", end[i]);
        add_tick(ticks, end[i], text);
    }
}

struct thud_look thud_chart_look(const struct thud_series *series, int index)
{
    int color = series->style.color;
    if (color == THUD_COLOR_GREY)
        return thud_look(THUD_ROLE_MUTED, 0);
    if (color < 0)
        color = index;
    return thud_look(THUD_ROLE_SERIES + color % 8, series->style.wide ? THUD_BOLD : 0);
}

int thud_chart_number(const struct thud_panel *panel, int index)
{
    int number = 0;
    for (int i = 0; i < index; i++)
        number += panel->series[i]->name && *panel->series[i]->name && !thud_series_is_shade(panel->series[i]);
    return number;
}

/* "1 left  2 right", each in its colour, in at most `rows` rows from (x, y) on; returns the rows it takes, drawn only
 * where `draw`. */
static int key_lines(const struct thud_pane *pane, const struct thud_panel *panel, int x, int y, int rows, bool draw)
{
    int at = x, row = 0;
    for (int i = 0; i < panel->nseries; i++) {
        const struct thud_series *series = panel->series[i];
        if (!series->name || !*series->name || thud_series_is_shade(series))
            continue;
        char text[80];
        int number = thud_chart_number(panel, i);
        snprintf(text, sizeof text, "%c %.70s", number < 9 ? '1' + number : '+', series->name);
        int width = thud_utf8_columns(text);
        if (at > 0 && at + width > pane->w) {
            at = 0;
            row++;
        }
        if (draw && row < rows)
            thud_pane_put(pane, at, y + row, thud_chart_look(series, i), text);
        at += width + 2;
    }
    return at == x && row == 0 ? 0 : row + 1;
}

/* Title and key; returns the rows they took. */
static int head(const struct thud_pane *pane, const struct thud_panel *panel)
{
    const struct thud_axis *axis = &panel->axis[THUD_Y];
    char text[256], unit[96];
    const char *title = panel->title && *panel->title ? panel->title : axis->label ? axis->label : "";
    thud_axis_text(axis, unit, sizeof unit);
    bool both = *unit && strcmp(title, axis->label ? axis->label : "") != 0;
    const int least = 8; /* of the axis' name; where it has less room it stands alone */
    int room = pane->w - thud_utf8_columns(title) - 2;
    both = both && room >= least;
    char fitted[96];
    thud_utf8_fit(both || !*unit ? title : unit, pane->w, text, sizeof text);
    int at = thud_pane_put(pane, 0, 0, thud_look(THUD_ROLE_PLAIN, THUD_BOLD), text);
    if (both)
        at += 2 + thud_pane_put(pane, at + 2, 0, thud_look(THUD_ROLE_MUTED, 0),
                                thud_utf8_fit(unit, room, fitted, sizeof fitted));
    at += 3;
    if (key_lines(pane, panel, at, 0, 1, false) <= 1) {
        key_lines(pane, panel, at, 0, 1, true);
        return 1;
    }
    int most = pane->h / 5, rows = key_lines(pane, panel, 0, 1, most, false);
    if (most == 0) { /* what fits beside the title */
        key_lines(pane, panel, at, 0, 1, true);
        return 1;
    }
    key_lines(pane, panel, 0, 1, most, true);
    return 1 + (rows < most ? rows : most);
}

static void y_axis(const struct thud_chart_frame *frame, const struct thud_pane *pane, const struct ticks *ticks)
{
    struct thud_look look = thud_look(THUD_ROLE_BORDER, 0);
    int x = frame->plot.x - pane->x - 1, top = frame->plot.y - pane->y, last = -9;
    for (int y = 0; y < frame->plot.h; y++)
        thud_pane_glyph(pane, x, top + y, look, 0x2502);
    for (int i = 0; i < ticks->n; i++) {
        double along = thud_chart_along(&frame->y, frame->y_log, ticks->at[i]);
        if (!(along > -1e-6 && along < 1.0 + 1e-6))
            continue;
        int y = (int)lround((1.0 - along) * (frame->plot.h - 1));
        if (last >= 0 && last - y < 2 && frame->y_log)
            continue;
        last = y;
        thud_pane_glyph(pane, x, top + y, look, 0x2524);
        thud_pane_right(pane, x - 1, top + y, thud_look(THUD_ROLE_PLAIN, 0), ticks->text[i]);
    }
}

static void x_axis(const struct thud_chart_frame *frame, const struct thud_pane *pane, const struct ticks *ticks,
                   const struct thud_axis *axis)
{
    struct thud_look look = thud_look(THUD_ROLE_BORDER, 0);
    int left = frame->plot.x - pane->x, y = frame->plot.y - pane->y + frame->plot.h;
    char unit[96];
    thud_axis_text(axis, unit, sizeof unit);
    const char *label = pane->w > 28 || !axis->unit || !*axis->unit ? unit : axis->unit;
    bool own_row = y + 2 < pane->h;
    int room = own_row ? pane->w : pane->w - thud_utf8_columns(label) - 1, taken = 0;
    thud_pane_glyph(pane, left - 1, y, look, 0x2514);
    for (int x = 0; x < frame->plot.w; x++)
        thud_pane_glyph(pane, left + x, y, look, 0x2500);
    for (int i = 0; i < ticks->n; i++) {
        double along = thud_chart_along(&frame->x, frame->x_log, ticks->at[i]);
        if (!(along > -1e-6 && along < 1.0 + 1e-6))
            continue;
        int at = left + (int)lround(along * (frame->plot.w - 1)), width = thud_utf8_columns(ticks->text[i]);
        thud_pane_glyph(pane, at, y, look, 0x252c);
        int start = at - width / 2 < taken ? at : at - width / 2;
        if (start < taken || start + width > room)
            continue;
        thud_pane_put(pane, start, y + 1, thud_look(THUD_ROLE_PLAIN, 0), ticks->text[i]);
        taken = start + width + 2;
    }
    thud_pane_right(pane, pane->w, y + 1 + own_row, thud_look(THUD_ROLE_MUTED, 0), label);
}

/* Rows for the x axis, its numbers and, where they would have no room beside it, its name. */
static int rows_below(const struct thud_pane *pane, const struct thud_axis *axis, int top)
{
    char text[96];
    int rows = pane->h - top - 2 < 2 ? 0 : 2;
    thud_axis_text(axis, text, sizeof text);
    return rows == 2 && pane->h - top > 7 && 5 * thud_utf8_columns(text) > 2 * pane->w ? 3 : rows;
}

/* Where there is no room for an axis: from where to where it goes, at the end of the title's row if that is free. */
static void x_extent(const struct thud_pane *pane, const struct ticks *ticks, const struct thud_axis *axis)
{
    char text[64];
    if (ticks->n < 2)
        return;
    snprintf(text, sizeof text, "%s to %s%s%s", ticks->text[0], ticks->text[ticks->n - 1],
             axis->unit && *axis->unit ? " " : "", axis->unit ? axis->unit : "");
    int w = thud_utf8_columns(text);
    if (w + 1 < pane->w && thud_pane_is_free(pane, pane->w - w - 1, 0, w + 1))
        thud_pane_right(pane, pane->w, 0, thud_look(THUD_ROLE_MUTED, 0), text);
}

static int width_of(const struct ticks *ticks)
{
    int most = 1;
    for (int i = 0; i < ticks->n; i++) {
        int width = thud_utf8_columns(ticks->text[i]);
        most = width > most ? width : most;
    }
    return most;
}

bool thud_chart_axes(const struct thud_pane *pane, const struct thud_panel *panel, struct thud_chart_frame *frame)
{
    if (pane->w < 16 || pane->h < 3)
        return false;
    struct ticks x_ticks, y_ticks;
    const struct thud_axis *x_axis_of = &panel->axis[THUD_X], *y_axis_of = &panel->axis[THUD_Y];
    frame->x = thud_panel_range(panel, THUD_X);
    frame->y = thud_panel_range(panel, THUD_Y);
    frame->x_log = x_axis_of->log;
    frame->y_log = y_axis_of->log;
    int top = head(pane, panel), below = rows_below(pane, x_axis_of, top);
    int rows = pane->h - top - below;
    if (below > 0 && is_linear(y_axis_of))
        frame->y = fit_cells(&frame->y, rows, rows < 8 ? 1 : 2);
    make_ticks(y_axis_of, &frame->y, &y_ticks);
    if (below == 0 || y_ticks.n < 2) /* one number gives no scale */
        keep_ends(y_axis_of, &frame->y, &y_ticks);
    int left = width_of(&y_ticks) + 2;
    frame->plot = thud_pane_inside(pane, left, top, pane->w - left, rows);
    if (frame->plot.w < 6 || frame->plot.h < 2)
        return false;
    make_ticks(x_axis_of, &frame->x, &x_ticks);
    if (below > 0 && is_linear(x_axis_of)) {
        frame->x = fit_cells(&frame->x, frame->plot.w, width_of(&x_ticks) + 2);
        make_ticks(x_axis_of, &frame->x, &x_ticks);
    }
    if (below == 0)
        keep_ends(x_axis_of, &frame->x, &x_ticks);
    y_axis(frame, pane, &y_ticks);
    if (below > 0)
        x_axis(frame, pane, &x_ticks, &panel->axis[THUD_X]);
    else
        x_extent(pane, &x_ticks, &panel->axis[THUD_X]);
    return true;
}
