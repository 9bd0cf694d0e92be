#include <math.h>
#include <stdio.h>
#include <string.h>

#include "plot/figure.h"

static void field(struct thud_text *out, const char *text)
{
    thud_text_csv(out, text);
    thud_text_bytes(out, ",", 1);
}

/* Which panel a row belongs to; with the meaning of its numbers where the header cannot say it. */
static void panel_name(const struct thud_panel *panel, bool same, struct thud_text *name)
{
    char x[256], y[256];
    *name = (struct thud_text){0};
    thud_text_append(name, "%s", panel->title);
    if (!same)
        thud_text_append(name, "%s%s against %s", *panel->title ? ": " : "",
                         thud_axis_text(&panel->axis[THUD_Y], y, sizeof y),
                         thud_axis_text(&panel->axis[THUD_X], x, sizeof x));
}

static bool same_axis(const struct thud_axis *a, const struct thud_axis *b)
{
    return !strcmp(a->label, b->label) && !strcmp(a->unit, b->unit);
}

/* The first panel in use when all the others have its axes, else NULL. */
static const struct thud_panel *common(const struct thud_figure *figure)
{
    const struct thud_panel *first = NULL;
    for (int p = 0; p < figure->rows * figure->columns; p++) {
        const struct thud_panel *panel = &figure->panel[p];
        if (!panel->used)
            continue;
        if (!first)
            first = panel;
        if (!same_axis(&first->axis[THUD_X], &panel->axis[THUD_X]) ||
            !same_axis(&first->axis[THUD_Y], &panel->axis[THUD_Y]))
            return NULL;
    }
    return first;
}

static void header(const struct thud_panel *panel, struct thud_text *out)
{
    char text[256];
    thud_text_append(out, "panel,series,");
    for (int side = 0; side < 2; side++) {
        if (panel)
            field(out, thud_axis_text(&panel->axis[side], text, sizeof text));
        else
            thud_text_append(out, side == THUD_X ? "x," : "y,");
    }
    thud_text_append(out, "y_high_or_z\n");
}

/* What is no number stays empty. */
static void value(struct thud_text *out, double number)
{
    if (!isnan(number))
        thud_text_number(out, number);
}

static void row(struct thud_text *out, const struct thud_text *prefix, double x, double y, const double *third)
{
    thud_text_bytes(out, prefix->data, prefix->size);
    value(out, x);
    thud_text_bytes(out, ",", 1);
    value(out, y);
    thud_text_bytes(out, ",", 1);
    if (third)
        value(out, *third);
    thud_text_bytes(out, "\n", 1);
}

static void series_rows(struct thud_text *out, const struct thud_text *panel, const struct thud_series *series)
{
    struct thud_text prefix = {0};
    field(&prefix, panel->data);
    field(&prefix, series->name);
    for (size_t i = 0; i < series->n && !prefix.failed; i++)
        row(out, &prefix, series->x[i], series->y[i], series->y_high ? &series->y_high[i] : NULL);
    out->failed |= prefix.failed;
    thud_text_clear(&prefix);
}

static void map_rows(struct thud_text *out, const struct thud_text *panel, const struct thud_map *map)
{
    struct thud_text prefix = {0};
    struct thud_axis axis = {.label = map->label, .unit = map->unit};
    char label[256];
    field(&prefix, panel->data);
    field(&prefix, thud_axis_text(&axis, label, sizeof label));
    for (size_t i = 0; i < map->nx * map->ny && !prefix.failed; i++)
        row(out, &prefix, map->x[i % map->nx], map->y[i / map->nx], &map->z[i]);
    out->failed |= prefix.failed;
    thud_text_clear(&prefix);
}

void thud_figure_csv(const struct thud_figure *figure, struct thud_text *out)
{
    const struct thud_panel *same = common(figure);
    header(same, out);
    for (int p = 0; p < figure->rows * figure->columns; p++) {
        const struct thud_panel *panel = &figure->panel[p];
        struct thud_text name;
        if (!panel->used || panel->closer)
            continue;
        panel_name(panel, same != NULL, &name);
        out->failed |= name.failed;
        for (int i = 0; i < panel->nseries && !out->failed; i++)
            series_rows(out, &name, panel->series[i]);
        if (panel->map && !out->failed)
            map_rows(out, &name, panel->map);
        thud_text_clear(&name);
    }
}
