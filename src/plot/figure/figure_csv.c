#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plot/figure/figure.h"

static void field(struct thud_text *out, const char *text)
{
    thud_text_csv(out, text);
    thud_text_bytes(out, ",", 1);
}

enum { COLUMNS_MAX = 64 };

/* The variables of a figure: what stands at an axis or in a map, each once. */
struct columns {
    char text[COLUMNS_MAX][256];
    int n;
};

/* Column of a variable, added where it is new; -1: there is no room. `plain`: what it is called without a label. */
static int column_of(struct columns *columns, const struct thud_axis *axis, const char *plain, const char *behind)
{
    char text[256], label[224];
    thud_axis_text(axis, label, sizeof label);
    snprintf(text, sizeof text, "%s%s", *label ? label : plain, behind);
    for (int i = 0; i < columns->n; i++)
        if (!strcmp(columns->text[i], text))
            return i;
    if (columns->n == COLUMNS_MAX)
        return -1;
    memcpy(columns->text[columns->n], text, sizeof text);
    return columns->n++;
}

/* The same of an axis; two of a panel that are called alike have a column each. */
static int axis_column(struct columns *columns, const struct thud_panel *panel, enum thud_side side, const char *behind)
{
    const struct thud_axis *x = &panel->axis[THUD_X], *y = &panel->axis[THUD_Y];
    bool alike = side == THUD_Y && *y->label && !strcmp(x->label, y->label) && !strcmp(x->unit, y->unit);
    char both[32];
    snprintf(both, sizeof both, "%s%s", alike ? ", upward" : "", behind);
    return column_of(columns, &panel->axis[side], side == THUD_X ? "x" : "y", both);
}

static int map_column(struct columns *columns, const struct thud_map *map)
{
    return column_of(columns, &(struct thud_axis){.label = map->label, .unit = map->unit}, "z", "");
}

static const char high[] = ", upper end";

static bool is_written(const struct thud_panel *panel)
{
    return panel->used && !panel->closer;
}

static void find_columns(const struct thud_figure *figure, struct columns *columns)
{
    for (int p = 0; p < figure->rows * figure->columns; p++) {
        const struct thud_panel *panel = &figure->panel[p];
        if (!is_written(panel))
            continue;
        axis_column(columns, panel, THUD_X, "");
        axis_column(columns, panel, THUD_Y, "");
        for (int i = 0; i < panel->nseries; i++)
            if (panel->series[i]->y_high)
                axis_column(columns, panel, THUD_Y, high);
        if (panel->map)
            map_column(columns, panel->map);
    }
}

/* A row: numbers in their columns, the others empty. What is no number stays empty too. */
static void put_row(struct thud_text *out, const struct thud_text *prefix, const struct columns *columns,
                    const int at[3], const double value[3])
{
    thud_text_bytes(out, prefix->data, prefix->size - 1); /* a comma comes before each number */
    for (int c = 0; c < columns->n; c++) {
        thud_text_bytes(out, ",", 1);
        for (int k = 0; k < 3; k++)
            if (at[k] == c && !isnan(value[k])) /* in a unit: the last digits are those of the conversion from SI */
                thud_text_append(out, "%.15g", value[k] + 0.0);
    }
    thud_text_bytes(out, "\n", 1);
}

static const char *kind_of(const struct thud_series *series)
{
    static const char *const kind[] = {[THUD_LINES] = "line",  [THUD_POINTS] = "points", [THUD_LINES_POINTS] = "line",
                                       [THUD_STEPS] = "steps", [THUD_FILL] = "band",     [THUD_BARS] = "bars"};
    return series->y_high ? "band" : kind[series->style.kind];
}

static void series_rows(struct thud_text *out, const struct thud_panel *panel, const struct thud_series *series,
                        struct columns *columns)
{
    struct thud_text prefix = {0};
    int at[3] = {axis_column(columns, panel, THUD_X, ""), axis_column(columns, panel, THUD_Y, ""),
                 series->y_high ? axis_column(columns, panel, THUD_Y, high) : -1};
    field(&prefix, panel->title);
    field(&prefix, series->name);
    field(&prefix, kind_of(series));
    for (size_t i = 0; i < series->n && !prefix.failed; i++)
        put_row(out, &prefix, columns, at,
                (double[]){series->x[i], series->y[i], series->y_high ? series->y_high[i] : NAN});
    out->failed |= prefix.failed;
    thud_text_clear(&prefix);
}

static void map_rows(struct thud_text *out, const struct thud_panel *panel, struct columns *columns)
{
    const struct thud_map *map = panel->map;
    struct thud_text prefix = {0};
    int at[3] = {axis_column(columns, panel, THUD_X, ""), axis_column(columns, panel, THUD_Y, ""),
                 map_column(columns, map)};
    field(&prefix, panel->title);
    field(&prefix, "");
    field(&prefix, "map");
    for (size_t i = 0; i < map->nx * map->ny && !prefix.failed; i++)
        put_row(out, &prefix, columns, at, (double[]){map->x[i % map->nx], map->y[i / map->nx], map->z[i]});
    out->failed |= prefix.failed;
    thud_text_clear(&prefix);
}

void thud_figure_csv(const struct thud_figure *figure, struct thud_text *out)
{
    struct columns *columns = calloc(1, sizeof *columns);
    if (!columns) {
        out->failed = 1;
        return;
    }
    find_columns(figure, columns);
    thud_text_append(out, "panel,series,kind");
    for (int c = 0; c < columns->n; c++) {
        struct thud_text head = {0};
        field(&head, columns->text[c]);
        thud_text_append(out, ",");
        if (!head.failed)
            thud_text_bytes(out, head.data, head.size - 1);
        out->failed |= head.failed;
        thud_text_clear(&head);
    }
    thud_text_append(out, "\n");
    for (int p = 0; p < figure->rows * figure->columns; p++) {
        const struct thud_panel *panel = &figure->panel[p];
        for (int i = 0; is_written(panel) && i < panel->nseries && !out->failed; i++)
            series_rows(out, panel, panel->series[i], columns);
        if (is_written(panel) && panel->map && !out->failed)
            map_rows(out, panel, columns);
    }
    free(columns);
}
