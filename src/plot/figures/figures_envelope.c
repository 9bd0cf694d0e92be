/* Peaks over the height of each structure. */
#include <math.h>
#include <stdio.h>

#include "base/quantity.h"
#include "plot/figures/figures_run_internal.h"
#include "study/scene/level.h"
#include "study/scene/solution.h"

enum { ACCELERATION, DISPLACEMENT, DRIFT, RATIO, QUANTITIES };

static const struct {
    const char *label, *unit;
    double factor;
} quantity[QUANTITIES] = {{"Total acceleration", "g", 1.0 / THUD_GRAVITY},
                          {"Displacement", "cm", 100.0},
                          {"Drift", "mm", 1000.0},
                          {"Drift ratio", "%", 100.0}};

/* Height of the storey below a floor; NaN below a base slab. */
static double storey(const struct thud_structure *structure, int floor)
{
    if (structure->kind != THUD_ISOLATED)
        return structure->height_m[floor];
    return floor > 0 ? structure->height_m[floor - 1] : NAN;
}

static double peak_of(const struct thud_figure_source *source, int structure, int f, int q)
{
    const struct thud_floor_result *floor = &source->result->structure[structure].floor[f];
    const bool isolators = source->scene->structure[structure].kind == THUD_ISOLATED && f == 0;
    if ((q == ACCELERATION && thud_floor_struck(source->result, structure, f)) || (q == DRIFT && isolators))
        return NAN;
    return q == ACCELERATION   ? floor->acceleration.value
           : q == DISPLACEMENT ? floor->displacement.value
           : q == DRIFT        ? floor->drift.value
                               : floor->drift.value / storey(&source->scene->structure[structure], f);
}

/* Of the ground itself. */
static double ground_peak(const struct thud_figure_source *source)
{
    const struct thud_history *h = source->history;
    double peak = 0.0;
    for (size_t i = 0; i < h->rows; i++)
        peak = fmax(peak, fabs(h->value[i * (size_t)h->columns + (size_t)thud_history_ground()]));
    return peak;
}

/* Floor values joined by lines, from the ground's own at the lowest; a drift belongs to its whole storey. */
static void envelope(struct thud_panel *panel, const struct thud_figure_source *source, int structure, int q,
                     const char *name, int color)
{
    const struct thud_structure_result *result = &source->result->structure[structure];
    const struct thud_structure *s = &source->scene->structure[structure];
    double below = s->base_m;
    size_t n = 0, floors = (size_t)result->floors;
    bool whole = q >= DRIFT, slab = s->kind == THUD_ISOLATED;
    struct thud_style style = {.kind = whole || source->behind ? THUD_LINES : THUD_LINES_POINTS,
                               .color = color,
                               .thin = source->behind,
                               .dashed = source->behind};
    struct thud_series *series = thud_panel_add(panel, style, name, whole ? 2 * floors : floors + !slab, NULL, NULL);
    if (series && !whole && !slab) {
        series->x[n] = q == ACCELERATION ? quantity[q].factor * ground_peak(source) : 0.0;
        series->y[n++] = s->base_m;
    }
    for (size_t f = 0; series && f < floors; f++) {
        double value = quantity[q].factor * peak_of(source, structure, (int)f, q);
        if (whole) {
            series->x[n] = value;
            series->y[n++] = below;
        }
        series->x[n] = value;
        series->y[n++] = below = thud_structure_elevation(s, (int)f);
    }
}

struct thud_figure *thud_figure_envelopes(enum thud_run_figure which, const struct thud_figure_source *source,
                                          int nsources)
{
    int rows = 0, row = 0;
    char text[3 * THUD_TEXT_MAX];
    for (int i = 0; i < source->result->nstructures; i++)
        rows += thud_kind_is_building(source->scene->structure[i].kind);
    rows = rows < THUD_ROWS_MAX ? rows : THUD_ROWS_MAX;
    thud_source_title(source, nsources, "peaks over the height", text, sizeof text);
    struct thud_figure *figure = thud_figure_create(thud_run_figure_name(which), text, rows, QUANTITIES);
    for (int i = 0; i < source->result->nstructures && row < rows; i++) {
        const struct thud_structure *structure = &source->scene->structure[i];
        if (!thud_kind_is_building(structure->kind)) /* of one height there is no line over it */
            continue;
        for (int q = 0; q < QUANTITIES; q++) {
            struct thud_panel *panel = thud_figure_panel(figure, row, q, structure->name);
            thud_panel_axis(panel, THUD_X, quantity[q].label, quantity[q].unit);
            thud_panel_results_on_x(panel);
            thud_panel_axis(panel, THUD_Y, "Height", "m");
            thud_panel_limits(panel, THUD_X, 0.0, NAN);
            for (int s = 0; s < nsources; s++)
                if (i < source[s].result->nstructures && source[s].result->structure[i].floors > 0)
                    envelope(panel, &source[s], i, q, nsources > 1 ? source[s].name : "",
                             thud_source_color(&source[s], nsources));
        }
        row++;
    }
    thud_figure_share_scale(figure, THUD_Y, 0, 1, rows * QUANTITIES, NULL);
    for (int q = 0; q < QUANTITIES; q++) /* neighbours on one scale */
        thud_figure_share_scale(figure, THUD_X, q, QUANTITIES, rows, NULL);
    return figure;
}
