/* Amplification over two parameters. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "plot/figures/figures_sweep_internal.h"

/* A dot in every cell where the response is larger: the two ends of the colours are one grey in print. */
static void add_harm(struct thud_panel *panel, const struct thud_map *map)
{
    static const double harm = 1.01;
    struct thud_series *dots =
        thud_panel_add(panel, (struct thud_style){.kind = THUD_POINTS, .color = THUD_COLORS - 1, .thin = true},
                       "ratio above 1.01", map->nx * map->ny, NULL, NULL);
    size_t n = 0;
    for (size_t i = 0; dots && i < map->nx * map->ny; i++)
        if (map->z[i] > harm) {
            dots->x[n] = map->x[i % map->nx];
            dots->y[n++] = map->y[i / map->nx];
        }
    if (dots)
        dots->n = n;
}

static void fill_map(struct thud_panel *panel, const struct thud_sweep_table *table, const struct thud_wanted *wanted)
{
    const struct thud_sweep_axis *on_x = &table->axis[0], *on_y = &table->axis[1];
    double *x = malloc(((size_t)on_x->n + (size_t)on_y->n) * sizeof *x), *y = x ? x + on_x->n : NULL;
    for (int i = 0; x && i < on_x->n; i++)
        x[i] = thud_axis_place(on_x, i);
    for (int i = 0; x && i < on_y->n; i++)
        y[i] = thud_axis_place(on_y, i);
    struct thud_map *map = x ? thud_panel_map(panel, (size_t)on_x->n, x, (size_t)on_y->n, y, NULL,
                                              thud_sweep_ratio_label[wanted->told], "")
                             : NULL;
    free(x);
    if (!map) {
        if (panel)
            panel->figure->failed = true;
        return;
    }
    map->centre = 1.0;
    map->level =
        thud_axis_has_numbers(on_x) && thud_axis_has_numbers(on_y) ? 1.0 : NAN; /* nothing lies between words */
    for (size_t i = 0; i < table->npoints; i++) {
        const struct thud_sweep_summary *d = table->point[i];
        if (d->record == wanted->record && thud_sweep_is_drawn(table, d, 2, wanted->at))
            map->z[(size_t)d->at[1] * map->nx + (size_t)d->at[0]] =
                thud_sweep_value(table, i, wanted, THUD_SWEEP_VALUE);
    }
    add_harm(panel, map);
}

/* One scale of colours for all panels, as far to one side of 1 as to the other. */
static void same_colors(struct thud_figure *figure)
{
    double half = 0.0;
    for (int p = 0; figure && p < figure->rows * figure->columns; p++) {
        double least, most;
        if (figure->panel[p].map && thud_map_range(figure->panel[p].map, &least, &most))
            half = fmax(half, fmax(most - 1.0, 1.0 - least));
    }
    for (int p = 0; figure && p < figure->rows * figure->columns; p++)
        if (figure->panel[p].map)
            figure->panel[p].map->reach = half;
}

struct thud_figure *thud_figure_of_map(const struct thud_sweep_table *table, int record, enum thud_case which,
                                       const int *at, const char *name)
{
    int structure[THUD_SWEEP_COLUMNS_MAX], columns = thud_sweep_columns(table, structure);
    bool free = which == THUD_CASE_NONE;
    char text[768], head[160], amplified[THUD_SWEEP_TITLE], helps[THUD_SWEEP_TITLE], ratio[200];
    snprintf(text, sizeof text, "%s: %s, means over the floors", thud_sweep_record_name(table, record, head),
             thud_sweep_amplification(table, which, amplified));
    for (int a = 2; a < table->naxes; a++)
        thud_append(text, sizeof text, ", %s %s", table->axis[a].key, table->axis[a].text[at ? at[a] : 0]);
    struct thud_figure *figure =
        thud_figure_create(name, text, thud_sweep_ratio_rows(table), columns > 0 ? columns : 1);
    for (int c = 0; c < columns; c++) {
        for (int q = 0; q < THUD_TOLD_RATIOS && thud_sweep_has_ratio(table, (enum thud_told)q, structure[c]); q++) {
            snprintf(text, sizeof text, "%s: %s", thud_sweep_structure_title(table, structure[c], head),
                     q == THUD_TOLD_DRIFT ? "drifts" : "accelerations");
            struct thud_panel *panel = thud_figure_panel(figure, q, c, text);
            thud_sweep_axis_of(panel, THUD_X, table, 0);
            thud_sweep_axis_of(panel, THUD_Y, table, 1);
            struct thud_wanted wanted = {.record = record,
                                         .which = which,
                                         .told = (enum thud_told)q,
                                         .structure = structure[c],
                                         .free = free,
                                         .at = at};
            fill_map(panel, table, &wanted);
        }
    }
    same_colors(figure);
    bool line = thud_axis_has_numbers(&table->axis[0]) && thud_axis_has_numbers(&table->axis[1]);
    if (free)
        snprintf(ratio, sizeof ratio, "Ratio to %s; red: pounding harms;",
                 thud_case_free_words(table->measures, table->free_links));
    else
        snprintf(ratio, sizeof ratio, "Ratio to %s at the same gap; blue: the %s;",
                 thud_case_title(table->measures, THUD_CASE_NONE), thud_sweep_helps(table, which, helps));
    snprintf(text, sizeof text, "%s%s%s", ratio, line ? " line: ratio 1 where there is contact;" : "",
             " dots: above 1.01; white: no change; empty: no result.");
    thud_figure_note(figure, text);
    thud_sweep_note_gap(figure, table, 2);
    return figure;
}
