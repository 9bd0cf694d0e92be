#include <assert.h>
#include <math.h>
#include <stdalign.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plot/figure/figure_memory.h"

struct thud_figure_block {
    struct thud_figure_block *next;
    alignas(max_align_t) unsigned char data[];
};

unsigned thud_color_rgb(int color)
{
    /* yellow, the palette's eighth, cannot be seen on white. Its orange and sky blue are darker here, 3.4 : 1, so that
     * a thin line can be seen. The two blues stand apart from each other */
    static const unsigned palette[THUD_COLORS_ALL] = {0x0072B2, 0xD55E00, 0x009E73, 0xB08C00, 0x882255, 0xCC79A7,
                                                      0x000000, 0x3390CC, 0x667F00, 0x332288, 0x8C510A, 0x01665E};
    return color < 0 ? 0x808080 : palette[color % THUD_COLORS_ALL];
}

void *thud_figure_keep(struct thud_figure *figure, size_t count, size_t size)
{
    if (!figure || figure->failed)
        return NULL;
    struct thud_figure_block *block = NULL;
    if (count <= (SIZE_MAX - sizeof *block) / size)
        block = calloc(1, sizeof *block + count * size);
    if (!block) {
        figure->failed = true;
        return NULL;
    }
    block->next = figure->blocks;
    figure->blocks = block;
    return block->data;
}

static const char *keep_text(struct thud_figure *figure, const char *text)
{
    if (!text || !*text)
        return "";
    char *copy = thud_figure_keep(figure, strlen(text) + 1, 1);
    return copy ? strcpy(copy, text) : "";
}

static double *keep_numbers(struct thud_figure *figure, size_t n, const double *values)
{
    double *copy = thud_figure_keep(figure, n ? n : 1, sizeof *copy);
    if (copy && values && n)
        memcpy(copy, values, n * sizeof *copy);
    return copy;
}

/* Room for one more in an array that grows at powers of two; NULL when out of memory (the array stays as it was). */
static void *grow(struct thud_figure *figure, void *array, int n, size_t size)
{
    if (n & (n - 1))
        return array;
    void *more = thud_figure_keep(figure, n ? 2 * (size_t)n : 1, size);
    if (more && n)
        memcpy(more, array, (size_t)n * size);
    return more;
}

struct thud_figure *thud_figure_create(const char *name, const char *title, int rows, int columns)
{
    assert(rows > 0 && columns > 0);
    struct thud_figure *figure = calloc(1, sizeof *figure);
    if (!figure)
        return NULL;
    int panels = rows * columns;
    figure->rows = rows;
    figure->columns = columns;
    figure->name = keep_text(figure, name);
    figure->title = keep_text(figure, title);
    figure->note = "";
    figure->panel = thud_figure_keep(figure, (size_t)panels, sizeof *figure->panel);
    if (!figure->panel) {
        thud_figure_free(figure);
        return NULL;
    }
    for (int i = 0; i < panels; i++) {
        struct thud_panel *panel = &figure->panel[i];
        panel->figure = figure;
        panel->title = panel->note = "";
        for (int side = 0; side < 2; side++)
            panel->axis[side] = (struct thud_axis){.label = "", .unit = "", .least = NAN, .most = NAN};
    }
    return figure;
}

void thud_figure_title_add(struct thud_figure *figure, const char *text)
{
    size_t room = figure && *text ? strlen(figure->title) + strlen(text) + 4 : 0;
    char *title = room > 0 ? thud_figure_keep(figure, room, 1) : NULL;
    if (!title)
        return;
    snprintf(title, room, "%s%s(%s)", figure->title, *figure->title ? " " : "", text);
    figure->title = title;
}

void thud_figure_title_motions(struct thud_figure *figure, const char *motions)
{
    if (figure && figure->motion != THUD_MOTIONS)
        motions = figure->motion == THUD_MOTION_SYNTHETIC ? "synthetic motion" : "";
    thud_figure_title_add(figure, motions);
}

void thud_figure_free(struct thud_figure *figure)
{
    if (!figure)
        return;
    while (figure->blocks) {
        struct thud_figure_block *next = figure->blocks->next;
        free(figure->blocks);
        figure->blocks = next;
    }
    free(figure);
}

enum thud_status thud_figure_check(const struct thud_figure *figure, struct thud_error *err)
{
    if (!figure || figure->failed)
        return thud_error_set(err, THUD_MEMORY, "out of memory for a figure");
    return THUD_OK;
}

void thud_figure_rename(struct thud_figure *figure, const char *name)
{
    if (figure)
        figure->name = keep_text(figure, name);
}

void thud_figure_note(struct thud_figure *figure, const char *text)
{
    size_t room = figure && text ? strlen(figure->note) + strlen(text) + 2 : 0;
    char *note = room > 0 ? thud_figure_keep(figure, room, 1) : NULL;
    if (!note)
        return;
    snprintf(note, room, "%s%s%s", figure->note, *figure->note && *text ? " " : "", text);
    figure->note = note;
}

struct thud_panel *thud_figure_panel(struct thud_figure *figure, int row, int column, const char *title)
{
    if (!figure)
        return NULL;
    assert(row >= 0 && row < figure->rows && column >= 0 && column < figure->columns);
    struct thud_panel *panel = &figure->panel[row * figure->columns + column];
    panel->used = true;
    panel->title = keep_text(figure, title);
    return panel;
}

void thud_panel_note(struct thud_panel *panel, const char *text)
{
    if (panel)
        panel->note = keep_text(panel->figure, text);
}

void thud_panel_axis(struct thud_panel *panel, enum thud_side side, const char *label, const char *unit)
{
    if (!panel)
        return;
    panel->axis[side].label = keep_text(panel->figure, label);
    panel->axis[side].unit = keep_text(panel->figure, unit);
}

void thud_panel_limits(struct thud_panel *panel, enum thud_side side, double least, double most)
{
    if (!panel)
        return;
    panel->axis[side].least = least;
    panel->axis[side].most = most;
}

void thud_panel_share_axis(struct thud_panel *panel, enum thud_side side, const char *label)
{
    thud_panel_axis(panel, side, label, "%");
    thud_panel_limits(panel, side, -4, 104);
}

void thud_panel_results_on_x(struct thud_panel *panel)
{
    if (panel)
        panel->axis[THUD_X].results = true;
}

void thud_panel_log(struct thud_panel *panel, enum thud_side side)
{
    if (panel)
        panel->axis[side].log = true;
}

void thud_panel_tick(struct thud_panel *panel, enum thud_side side, double at, const char *text)
{
    if (!panel)
        return;
    struct thud_axis *axis = &panel->axis[side];
    struct thud_tick *ticks = grow(panel->figure, axis->tick, axis->nticks, sizeof *ticks);
    if (!ticks)
        return;
    axis->tick = ticks;
    ticks[axis->nticks++] = (struct thud_tick){at, keep_text(panel->figure, text)};
}

void thud_panel_mark(struct thud_panel *panel, enum thud_side side, double from, double to, const char *text)
{
    if (!panel)
        return;
    struct thud_mark *marks = grow(panel->figure, panel->mark, panel->nmarks, sizeof *marks);
    if (!marks)
        return;
    panel->mark = marks;
    marks[panel->nmarks++] = (struct thud_mark){side, from, to, keep_text(panel->figure, text)};
}

void thud_panel_label(struct thud_panel *panel, double x, double y, int side, const char *text)
{
    if (!panel)
        return;
    struct thud_label *labels = grow(panel->figure, panel->label, panel->nlabels, sizeof *labels);
    if (!labels)
        return;
    panel->label = labels;
    labels[panel->nlabels++] = (struct thud_label){x, y, side, keep_text(panel->figure, text)};
}

struct thud_series *thud_panel_add(struct thud_panel *panel, struct thud_style style, const char *name, size_t n,
                                   const double *x, const double *y)
{
    if (!panel)
        return NULL;
    struct thud_figure *figure = panel->figure;
    struct thud_series *series = thud_figure_keep(figure, 1, sizeof *series);
    struct thud_series **list = grow(figure, panel->series, panel->nseries, sizeof *list);
    if (!series || !list)
        return NULL;
    panel->series = list;
    *series = (struct thud_series){keep_text(figure, name), style, n, NULL, NULL, NULL};
    series->x = keep_numbers(figure, n, x);
    series->y = keep_numbers(figure, n, y);
    if (figure->failed)
        return NULL;
    list[panel->nseries++] = series;
    return series;
}

struct thud_series *thud_panel_fill(struct thud_panel *panel, struct thud_style style, const char *name, size_t n,
                                    const double *x, const double *low, const double *high)
{
    double *y_high = panel ? keep_numbers(panel->figure, n, high) : NULL;
    style.kind = THUD_FILL;
    struct thud_series *series = y_high ? thud_panel_add(panel, style, name, n, x, low) : NULL;
    if (series)
        series->y_high = y_high;
    return series;
}

void thud_panel_bars(struct thud_panel *panel, int color, size_t n, const double *x, const double *low,
                     const double *high)
{
    bool any = false;
    for (size_t i = 0; i < n; i++)
        any |= !isnan(low[i]);
    const struct thud_style style = {.kind = THUD_LINES, .color = color, .thin = true};
    struct thud_series *bars = any ? thud_panel_add(panel, style, "", 3 * n, NULL, NULL) : NULL;
    for (size_t i = 0; bars && i < n; i++) {
        bars->x[3 * i] = bars->x[3 * i + 1] = bars->x[3 * i + 2] = x[i];
        bars->y[3 * i] = low[i];
        bars->y[3 * i + 1] = high[i];
        bars->y[3 * i + 2] = NAN;
    }
}

struct thud_map *thud_panel_map(struct thud_panel *panel, size_t nx, const double *x, size_t ny, const double *y,
                                const double *z, const char *label, const char *unit)
{
    if (!panel)
        return NULL;
    struct thud_figure *figure = panel->figure;
    struct thud_map *map = thud_figure_keep(figure, 1, sizeof *map);
    if (!map)
        return NULL;
    *map = (struct thud_map){nx,  ny,  NULL, NULL, NULL, keep_text(figure, label), keep_text(figure, unit),
                             NAN, NAN, 0,    NULL, 0};
    map->x = keep_numbers(figure, nx, x);
    map->y = keep_numbers(figure, ny, y);
    map->z = keep_numbers(figure, nx * ny, z);
    if (figure->failed)
        return NULL;
    for (size_t i = 0; !z && i < nx * ny; i++)
        map->z[i] = NAN;
    panel->map = map;
    return map;
}

void thud_figure_strips(struct thud_figure *figure)
{
    for (int i = 0; figure && figure->rows > 1 && i < figure->rows * figure->columns; i++)
        figure->panel[i].strip = true;
}

void thud_panel_zoom(struct thud_panel *panel, struct thud_panel *from, double least, double most)
{
    if (!panel || !from)
        return;
    assert(panel->figure == from->figure && panel != from);
    panel->axis[THUD_X] = from->axis[THUD_X];
    panel->axis[THUD_Y] = from->axis[THUD_Y];
    thud_panel_limits(panel, THUD_X, least, most);
    panel->closer = true;
    for (int i = 0; i < from->nseries; i++) {
        struct thud_series **list = grow(panel->figure, panel->series, panel->nseries, sizeof *list);
        if (!list)
            return;
        panel->series = list;
        list[panel->nseries++] = from->series[i];
    }
    thud_panel_mark(from, THUD_X, least, most, "");
}
