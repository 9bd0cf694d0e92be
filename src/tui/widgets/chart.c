#include <math.h>
#include <stdio.h>

#include "tui/widgets/chart.h"
#include "tui/widgets/dots.h"

/* What the parts of one drawing share. */
struct drawing {
    struct thud_dots dots;
    const struct thud_chart_frame *frame;
};

/* The ends of an axis lie in the middle of the first and last cell, where their ticks are. */
static double dot_x(const struct drawing *d, double x)
{
    return thud_chart_along(&d->frame->x, d->frame->x_log, x) * (d->dots.width - d->dots.across) +
           0.5 * (d->dots.across - 1);
}

static double dot_y(const struct drawing *d, double y)
{
    return (1.0 - thud_chart_along(&d->frame->y, d->frame->y_log, y)) * (d->dots.height - d->dots.down) +
           0.5 * (d->dots.down - 1);
}

/* Every sample is joined to the next, so no spike is lost, however narrow. */
static void draw_lines(struct drawing *d, const double *xs, const double *ys, size_t n, bool steps, int every,
                       struct thud_look look)
{
    double x0 = NAN, y0 = NAN;
    for (size_t i = 0; i < n; i++) {
        double x = dot_x(d, xs[i]), y = dot_y(d, ys[i]);
        if (steps) {
            thud_dots_line(&d->dots, x0, y0, x, y0, every, look);
            thud_dots_line(&d->dots, x, y0, x, y, every, look);
        } else if (!(fabs(x - x0) < 0.4 && fabs(y - y0) < 0.4 && i + 1 < n)) {
            thud_dots_line(&d->dots, x0, y0, x, y, every, look);
        } else {
            continue; /* within the same dot: wait for a step that shows */
        }
        x0 = x;
        y0 = y;
    }
}

static void draw_points(struct drawing *d, const struct thud_series *series, struct thud_look look)
{
    for (size_t i = 0; i < series->n; i++) {
        double x = dot_x(d, series->x[i]) / d->dots.across, y = dot_y(d, series->y[i]) / d->dots.down;
        if (isfinite(x) && isfinite(y) && fabs(x) < 1e6 && fabs(y) < 1e6)
            thud_pane_glyph(&d->dots.pane, (int)floor(x + 0.25), (int)floor(y + 0.25), look, 0x25cf);
    }
}

static void draw_bars(struct drawing *d, const struct thud_series *series, struct thud_look look)
{
    double base = dot_y(d, d->frame->y_log ? d->frame->y.least : 0.0);
    for (size_t i = 0; i < series->n; i++) {
        double x = dot_x(d, series->x[i]);
        thud_dots_line(&d->dots, x, base, x, dot_y(d, series->y[i]), 1, look);
    }
}

static void draw_series(struct drawing *d, const struct thud_series *series, struct thud_look look)
{
    enum thud_series_kind kind = series->style.kind;
    int every = thud_series_is_shade(series) ? 3 : 1; /* of the dots: a shade is seen behind its curve, no more */
    if (kind == THUD_BARS)
        draw_bars(d, series, look);
    else if (kind != THUD_POINTS)
        draw_lines(d, series->x, series->y, series->n, kind == THUD_STEPS, every, look);
    if (kind == THUD_FILL && series->y_high)
        draw_lines(d, series->x, series->y_high, series->n, false, every, look);
    if (series->n == 1 && kind != THUD_BARS && every == 1)
        draw_points(d, series, look);
    thud_dots_put(&d->dots);
    bool roomy = 3 * series->n <= (size_t)d->dots.pane.w; /* else the points would hide the line */
    if (kind == THUD_POINTS || (kind == THUD_LINES_POINTS && roomy))
        draw_points(d, series, look);
}

/* The series' number at its highest point, so that curves are told apart without colour. */
static void label_series(struct drawing *d, const struct thud_series *series, int index, struct thud_look look)
{
    double best = -1.0, px = NAN, py = NAN;
    for (size_t i = 0; i < series->n; i++) {
        double x = dot_x(d, series->x[i]), y = dot_y(d, series->y[i]);
        double height = d->dots.height - y;
        if (x >= 0.0 && x < d->dots.width && y >= -0.5 && y < d->dots.height && height > best) {
            best = height;
            px = x;
            py = y;
        }
    }
    if (isnan(px) || index > 8)
        return;
    int row = (int)(py / d->dots.down), column = (int)(px / d->dots.across);
    thud_pane_glyph(&d->dots.pane, column, row > 0 ? row - 1 : 0, thud_look(look.role, THUD_BOLD),
                    (uint32_t)('1' + index));
}

static void draw_mark(struct drawing *d, const struct thud_mark *mark)
{
    struct thud_look look = thud_look(THUD_ROLE_MUTED, 0);
    double edge[2] = {mark->from, mark->to};
    for (int i = 0; i < 2; i++) {
        double at = mark->side == THUD_X ? dot_x(d, edge[i]) : dot_y(d, edge[i]);
        if (mark->side == THUD_X)
            thud_dots_line(&d->dots, at, 0.0, at, d->dots.height - 1.0, 2, look);
        else
            thud_dots_line(&d->dots, 0.0, at, d->dots.width - 1.0, at, 3, look);
    }
    thud_dots_put(&d->dots);
}

/* Its words at the mark or in the band, in the first place where no curve goes; nowhere when there is none. */
static void label_mark(struct drawing *d, const struct thud_mark *mark)
{
    const struct thud_pane *pane = &d->dots.pane;
    int w = mark->text ? thud_utf8_columns(mark->text) : 0;
    bool upright = mark->side == THUD_X;
    double x = upright ? floor((double)lround(dot_x(d, mark->to)) / d->dots.across) + 1.0 : 1.0;
    double low = upright ? pane->h - 1.0 : fmin(pane->h - 1.0, dot_y(d, fmin(mark->from, mark->to)) / d->dots.down);
    double high = upright ? 0.0 : fmax(0.0, dot_y(d, fmax(mark->from, mark->to)) / d->dots.down);
    if (w == 0 || !(x >= 0.0 && x + w <= pane->w) || !(high <= low))
        return;
    for (int row = upright ? 0 : (int)low; row >= (int)high && row <= (int)low; row += upright ? 1 : -1)
        for (int column = (int)x; column + w <= pane->w; column += upright ? pane->w : 4)
            if (thud_pane_is_free(pane, column, row, w)) {
                thud_pane_put(pane, column, row, thud_look(THUD_ROLE_MUTED, 0), mark->text);
                return;
            }
}

static size_t nearest(const double *at, size_t n, double value)
{
    size_t best = 0;
    for (size_t i = 1; i < n; i++)
        if (fabs(at[i] - value) < fabs(at[best] - value))
            best = i;
    return best;
}

double thud_chart_at(const struct thud_range *range, bool log, double along)
{
    return log ? range->least * pow(range->most / range->least, along)
               : range->least + along * (range->most - range->least);
}

/* Five shades from low to high. */
static void draw_map(struct drawing *d, const struct thud_map *map)
{
    static const uint32_t shade[] = {0x00b7, 0x2591, 0x2592, 0x2593, 0x2588};
    double low, high;
    if (!thud_map_range(map, &low, &high))
        return;
    const struct thud_pane *pane = &d->dots.pane;
    for (int row = 0; row < pane->h; row++)
        for (int column = 0; column < pane->w; column++) {
            double x = thud_chart_at(&d->frame->x, d->frame->x_log, (column + 0.5) / pane->w);
            double y = thud_chart_at(&d->frame->y, d->frame->y_log, 1.0 - (row + 0.5) / pane->h);
            double z = map->z[nearest(map->y, map->ny, y) * map->nx + nearest(map->x, map->nx, x)];
            if (!isfinite(z))
                continue;
            int level = high > low ? (int)(4.999 * (z - low) / (high - low)) : 0;
            bool above = !isnan(map->centre) && z > map->centre;
            thud_pane_glyph(pane, column, row, thud_look(above ? THUD_ROLE_WARN : THUD_ROLE_SERIES, 0), shade[level]);
        }
}

static void draw_cursor(struct drawing *d, double at)
{
    double x = dot_x(d, at) / d->dots.across;
    if (!(x >= 0.0 && x < d->dots.pane.w))
        return;
    for (int y = 0; y < d->dots.pane.h; y++)
        thud_pane_glyph(&d->dots.pane, (int)x, y, thud_look(THUD_ROLE_KEY, 0), 0x2506);
}

double thud_chart_value(const struct thud_series *s, double x)
{
    double best = NAN;
    for (size_t i = 0; i < s->n; i++) {
        double y = NAN, width = i + 1 < s->n ? s->x[i + 1] - s->x[i] : 0.0;
        if (fabs(s->x[i] - x) <= 1e-9 * fmax(1.0, fabs(x)))
            y = s->y[i];
        else if (width != 0.0 && (x - s->x[i]) / width > 0.0 && (x - s->x[i]) / width < 1.0)
            y = s->style.kind == THUD_STEPS ? s->y[i] : s->y[i] + (x - s->x[i]) / width * (s->y[i + 1] - s->y[i]);
        if (isfinite(y) && !(fabs(y) <= fabs(best)))
            best = y;
    }
    return best;
}

void thud_chart_words(const struct thud_panel *panel, double x, char *text, size_t size)
{
    const struct thud_axis *across = &panel->axis[THUD_X], *up = &panel->axis[THUD_Y];
    snprintf(text, size, "%s %.5g%s%s:", across->label ? across->label : "x", x,
             across->unit && *across->unit ? " " : "", across->unit ? across->unit : "");
    static const double rounding = 1e-12; /* in any unit that is shown */
    for (int i = 0; i < panel->nseries; i++) {
        const struct thud_series *s = panel->series[i];
        double value = thud_chart_value(s, x);
        if (isnan(value) || thud_series_is_shade(s))
            continue;
        if (fabs(value) < rounding)
            value = 0;
        thud_append(text, size, "  %.40s %.3g", s->name && *s->name ? s->name : up->label, value);
    }
    if (up->unit)
        thud_append(text, size, " %s", up->unit);
}

/* Dashes and dots that tell curves apart where colours cannot; in ASCII their numbers do. */
static unsigned char pattern_of(const struct drawing *d, const struct thud_series *series, int number)
{
    static const unsigned char pattern[] = {0xff, 0x3f, 0x0f, 0x55, 0x5f, 0x33, 0x77, 0x57};
    enum { BEHIND = 0x11 };
    if (d->dots.down < 4 || thud_series_is_shade(series))
        return 0;
    if (series->style.dashed)
        return BEHIND;
    if (d->dots.pane.canvas->hues) /* and by the numbers at the curves */
        return 0;
    return number < 0 ? 0 : pattern[number % (int)sizeof pattern];
}

/* Moves a window of `all` into it; one that has no room is none. */
static struct thud_chart_window within(const struct thud_range *all, bool log, double low, double high)
{
    double over = low < 0.0 ? -low : high > 1.0 ? 1.0 - high : 0.0;
    if (!(high - low < 0.999) || !(high > low))
        return (struct thud_chart_window){0.0, 0.0};
    return (struct thud_chart_window){thud_chart_at(all, log, low + over), thud_chart_at(all, log, high + over)};
}

struct thud_chart_window thud_chart_zoom(const struct thud_chart_frame *frame, double factor, double at)
{
    static const double least = 1e-5; /* of all */
    double low = thud_chart_along(&frame->all, frame->x_log, frame->x.least),
           high = thud_chart_along(&frame->all, frame->x_log, frame->x.most),
           here = thud_chart_along(&frame->all, frame->x_log, at);
    if (!(here >= low && here <= high))
        here = 0.5 * (low + high);
    if (factor * (high - low) < least)
        return within(&frame->all, frame->x_log, low, high);
    return within(&frame->all, frame->x_log, here - factor * (here - low), here + factor * (high - here));
}

struct thud_chart_window thud_chart_pan(const struct thud_chart_frame *frame, double part)
{
    double low = thud_chart_along(&frame->all, frame->x_log, frame->x.least),
           high = thud_chart_along(&frame->all, frame->x_log, frame->x.most), by = part * (high - low);
    return within(&frame->all, frame->x_log, low + by, high + by);
}

void thud_chart_draw(const struct thud_pane *pane, const struct thud_panel *panel, const struct thud_chart *chart)
{
    struct thud_chart_frame frame;
    struct thud_panel zoomed = *panel;
    const struct thud_range all = thud_panel_range(panel, THUD_X);
    if (chart->window.to > chart->window.from) {
        thud_panel_limits(&zoomed, THUD_X, chart->window.from, chart->window.to);
        panel = &zoomed;
    }
    if (!thud_chart_axes(pane, panel, &frame)) {
        thud_pane_put(pane, 0, 0, thud_look(THUD_ROLE_MUTED, 0), "more room is needed for this chart");
        return;
    }
    frame.all = all;
    if (chart->drawn)
        *chart->drawn = frame;
    struct drawing d = {.frame = &frame};
    if (thud_dots_init(&d.dots, &frame.plot, NULL) != THUD_OK)
        return;
    if (panel->map)
        draw_map(&d, panel->map);
    for (int i = 0; i < panel->nmarks; i++)
        draw_mark(&d, &panel->mark[i]);
    if (chart->has_here)
        draw_mark(&d, &(struct thud_mark){.side = THUD_X, .from = chart->here, .to = chart->here});
    if (!isnan(chart->cursor))
        draw_cursor(&d, chart->cursor);
    for (int i = 0; i < panel->nseries; i++) {
        int number = thud_chart_number(panel, i);
        bool named = panel->series[i]->name && *panel->series[i]->name;
        d.dots.sign = number > 0 && number < 9 && named && !thud_series_is_shade(panel->series[i]) ? '1' + number : 0;
        d.dots.pattern = panel->nseries > 1 ? pattern_of(&d, panel->series[i], named ? number : -1) : 0;
        if (panel->series[i]->style.dashed)
            d.dots.sign = 0;
        draw_series(&d, panel->series[i], thud_chart_look(panel->series[i], i));
    }
    d.dots.sign = d.dots.pattern = 0;
    for (int i = 0; panel->nseries > 1 && i < panel->nseries; i++)
        if (panel->series[i]->name && *panel->series[i]->name && !thud_series_is_shade(panel->series[i]))
            label_series(&d, panel->series[i], thud_chart_number(panel, i), thud_chart_look(panel->series[i], i));
    for (int i = 0; i < panel->nmarks; i++)
        label_mark(&d, &panel->mark[i]);
    thud_dots_clear(&d.dots);
}

/* Without what stands behind, such as the ground motion above the histories. */
static int curves_of(const struct thud_panel *panel)
{
    int n = 0;
    for (int i = 0; i < panel->nseries; i++)
        n += !panel->series[i]->style.thin;
    return n;
}

/* The panel with the most series, the first of them: what the figure is about. */
static int busiest(const struct thud_figure *figure)
{
    int best = 0;
    for (int i = 1; i < figure->rows * figure->columns; i++)
        if (figure->panel[i].used && curves_of(&figure->panel[i]) > curves_of(&figure->panel[best]))
            best = i;
    return best;
}

void thud_chart_figure(const struct thud_pane *pane, const struct thud_figure *figure, int only,
                       const struct thud_chart *chart)
{
    int count = figure->rows * figure->columns;
    if (only < 0 && count > 1 && (pane->w / figure->columns < 34 || pane->h / figure->rows < 9))
        only = busiest(figure); /* too little room for all of them */
    for (int i = 0; i < count; i++) {
        int row = i / figure->columns, column = i % figure->columns;
        struct thud_pane part = *pane;
        if (!figure->panel[i].used || (only >= 0 && only != i))
            continue;
        if (only < 0) {
            int x = column * pane->w / figure->columns, y = row * pane->h / figure->rows;
            int apart = column + 1 < figure->columns; /* from the next one's names */
            part = thud_pane_inside(pane, x, y, (column + 1) * pane->w / figure->columns - x - apart,
                                    (row + 1) * pane->h / figure->rows - y);
        }
        thud_chart_draw(&part, &figure->panel[i], chart);
    }
}
