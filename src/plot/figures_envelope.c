/* Peaks over the height of each structure. */
#include <math.h>
#include <stdio.h>

#include "plot/figures_run_internal.h"

enum { QUANTITIES = 3 };

static const struct {
    const char *label, *unit;
    double factor;
} quantity[QUANTITIES] = {
    {"Total acceleration", "m/s²", 1.0}, {"Displacement", "cm", 100.0}, {"Deflection", "mm", 1000.0}};

/* Elevations of the floors; the base slab of an isolated building stands at 0. */
static void elevations(const struct thud_structure *structure, int floors, double *height)
{
    double h = 0.0;
    for (int f = 0; f < floors; f++) {
        if (structure->kind != THUD_ISOLATED || f > 0)
            h += structure->height_m[structure->kind == THUD_ISOLATED ? f - 1 : f];
        height[f] = h;
    }
}

static double peak_of(const struct thud_floor_result *floor, int q)
{
    return q == 0 ? floor->acceleration.value : q == 1 ? floor->displacement.value : floor->drift.value;
}

static double largest(const struct thud_figure_source *source, int nsources, int structure, int q)
{
    double peak = 0.0;
    for (int s = 0; s < nsources; s++) {
        const struct thud_structure_result *result = &source[s].result->structure[structure];
        for (int f = 0; f < result->floors; f++)
            peak = fmax(peak, peak_of(&result->floor[f], q));
    }
    return peak > 0.0 ? peak : 1.0;
}

/* Floor values joined by lines from the ground up; a deflection belongs to its whole storey. */
static void envelope(struct thud_panel *panel, const struct thud_figure_source *source, int structure, int q,
                     const char *name, int color)
{
    const struct thud_structure_result *result = &source->result->structure[structure];
    double height[THUD_STOREYS_MAX + 1] = {0.0}, below = 0.0;
    size_t n = 0, floors = (size_t)result->floors;
    elevations(&source->scene->structure[structure], result->floors, height);
    struct thud_style style = {.kind = q == 2 ? THUD_LINES : THUD_LINES_POINTS, .color = color};
    struct thud_series *series = thud_panel_add(panel, style, name, q == 2 ? 2 * floors : floors, NULL, NULL);
    for (size_t f = 0; series && f < floors; f++) {
        double value = quantity[q].factor * peak_of(&result->floor[f], q);
        if (q == 2) {
            series->x[n] = value;
            series->y[n++] = below;
        }
        series->x[n] = value;
        series->y[n++] = below = height[f];
    }
}

struct thud_figure *thud_figure_envelopes(const struct thud_figure_source *source, int nsources)
{
    int rows = 0, row = 0;
    char text[THUD_TEXT_MAX + 64];
    for (int i = 0; i < source->result->nstructures; i++)
        rows += source->result->structure[i].floors > 0 && source->scene->structure[i].kind != THUD_RIGID;
    rows = rows < THUD_ROWS_MAX ? rows : THUD_ROWS_MAX;
    snprintf(text, sizeof text, "%s: Peaks over the height", source->scene->title);
    struct thud_figure *figure = thud_figure_create(thud_run_figure_name(THUD_FIGURE_ENVELOPE), text, rows, QUANTITIES);
    for (int i = 0; i < source->result->nstructures && row < rows; i++) {
        const struct thud_structure *structure = &source->scene->structure[i];
        if (source->result->structure[i].floors == 0 || structure->kind == THUD_RIGID)
            continue;
        for (int q = 0; q < QUANTITIES; q++) {
            struct thud_panel *panel = thud_figure_panel(figure, row, q, structure->name);
            thud_panel_axis(panel, THUD_X, quantity[q].label, quantity[q].unit);
            thud_panel_axis(panel, THUD_Y, "Height", "m");
            thud_panel_limits(panel, THUD_X, 0.0, 1.05 * quantity[q].factor * largest(source, nsources, i, q));
            thud_panel_limits(panel, THUD_Y, 0.0, NAN);
            for (int s = 0; s < nsources; s++)
                envelope(panel, &source[s], i, q, nsources > 1 ? source[s].name : "", s);
        }
        row++;
    }
    return figure;
}
