/* Peaks over the height of each structure. */
#include <math.h>
#include <stdio.h>

#include "base/quantity.h"
#include "plot/figures/figures_run_internal.h"
#include "study/scene/level.h"
#include "study/scene/solution.h"

/* What is drawn over the height of a structure. */
struct quantity {
    const char *label, *unit;
    double factor;
    double (*value)(const struct thud_figure_source *source, int structure, int floor); /* NaN: there is none */
    bool of_storey;    /* the one below the floor: it belongs to its whole height */
    bool no_isolators; /* begins above them */
    double (*ground)(const struct thud_figure_source *source); /* of the ground; NULL: 0 */
    double mark;                                               /* NaN: none; its axis begins at 0 */
    bool from_0;
};

static double acceleration(const struct thud_figure_source *source, int structure, int floor)
{
    return thud_floor_struck(source->result, structure, floor)
               ? (double)NAN
               : source->result->structure[structure].floor[floor].acceleration.value;
}

static double displacement(const struct thud_figure_source *source, int structure, int floor)
{
    return source->result->structure[structure].floor[floor].displacement.value;
}

static double drift(const struct thud_figure_source *source, int structure, int floor)
{
    const bool isolators = source->scene->structure[structure].kind == THUD_ISOLATED && floor == 0;
    return isolators ? (double)NAN : source->result->structure[structure].floor[floor].drift.value;
}

static double drift_ratio(const struct thud_figure_source *source, int structure, int floor)
{
    const struct thud_structure *s = &source->scene->structure[structure];
    const int storey = floor - (s->kind == THUD_ISOLATED);
    return storey < 0 ? (double)NAN : drift(source, structure, floor) / s->height_m[storey];
}

static double ductility(const struct thud_figure_source *source, int structure, int floor)
{
    const struct thud_storey_result *storey = &source->result->structure[structure].storey[floor];
    return storey->yields ? storey->ductility : (double)NAN; /* elastic storeys leave a gap */
}

static double permanent(const struct thud_figure_source *source, int structure, int floor)
{
    const struct thud_storey_result *storey = &source->result->structure[structure].storey[floor];
    return storey->yields ? storey->permanent_m : (double)NAN;
}

/* Of the ground itself. */
static double ground_peak(const struct thud_figure_source *source)
{
    const struct thud_history *h = source->history;
    double peak = 0.0;
    for (size_t i = 0; i < h->rows; i++)
        peak = fmax(peak, fabs(h->value[i * (size_t)h->columns + (size_t)thud_history_ground(h, 0)]));
    return peak;
}

static const struct quantity peaks[] = {
    {"Total acceleration", "g", 1.0 / THUD_GRAVITY, acceleration, .ground = ground_peak, .mark = NAN, .from_0 = true},
    {"Displacement", "cm", 100.0, displacement, .mark = NAN, .from_0 = true},
    {"Drift", "mm", 1000.0, drift, .of_storey = true, .mark = NAN, .from_0 = true},
    {"Drift ratio", "%", 100.0, drift_ratio, .of_storey = true, .mark = NAN, .from_0 = true},
};
static const struct quantity yielding[] = {
    {"Ductility", "", 1.0, ductility, .of_storey = true, .no_isolators = true, .mark = 1.0, .from_0 = true},
    {"Permanent drift", "mm", 1000.0, permanent, .of_storey = true, .no_isolators = true, .mark = NAN},
};

/* Floor values joined by lines, from the ground's own at the lowest; a storey's value over its whole height. */
static void envelope(struct thud_panel *panel, const struct thud_figure_source *source, int structure,
                     const struct quantity *q, const char *name, int color)
{
    const struct thud_structure_result *result = &source->result->structure[structure];
    const struct thud_structure *s = &source->scene->structure[structure];
    const bool slab = s->kind == THUD_ISOLATED;
    const int first = slab && q->no_isolators;
    size_t n = 0, floors = (size_t)(result->floors - first);
    struct thud_style style = {.kind = q->of_storey || source->behind ? THUD_LINES : THUD_LINES_POINTS,
                               .color = color,
                               .thin = source->behind,
                               .dashed = source->behind};
    struct thud_series *series =
        thud_panel_add(panel, style, name, q->of_storey ? 2 * floors : floors + !slab, NULL, NULL);
    if (series && !q->of_storey && !slab) {
        series->x[n] = q->ground ? q->factor * q->ground(source) : 0.0;
        series->y[n++] = s->base_m;
    }
    for (int f = first; series && f < result->floors; f++) {
        const double value = q->factor * q->value(source, structure, f);
        if (q->of_storey) {
            series->x[n] = value;
            series->y[n++] = f > 0 ? thud_structure_elevation(s, f - 1) : s->base_m;
        }
        series->x[n] = value;
        series->y[n++] = thud_structure_elevation(s, f);
    }
}

/* A row of panels for each structure of which there is such a thing. */
static struct thud_figure *over_height(enum thud_run_figure which, const struct thud_figure_source *source,
                                       int nsources, const char *what, const struct quantity *quantity, int n)
{
    const struct thud_result *result = source->result;
    int row = 0, of[THUD_STRUCTURES_MAX];
    char text[3 * THUD_TEXT_MAX];
    for (int i = 0; i < result->nstructures && row < THUD_ROWS_MAX; i++) /* of one height there is no line over it */
        if (quantity == yielding ? result->structure[i].storey != NULL
                                 : thud_kind_is_building(source->scene->structure[i].kind))
            of[row++] = i;
    const int rows = row;
    thud_source_title(source, nsources, what, text, sizeof text);
    struct thud_figure *figure = thud_figure_create(thud_run_figure_name(which), text, rows > 0 ? rows : 1, n);
    for (int k = 0; k < rows * n; k++) {
        const int i = of[k / n];
        const struct quantity *q = &quantity[k % n];
        struct thud_panel *panel = thud_figure_panel(figure, k / n, k % n, source->scene->structure[i].name);
        thud_panel_axis(panel, THUD_X, q->label, q->unit);
        thud_panel_results_on_x(panel);
        thud_panel_axis(panel, THUD_Y, "Height", "m");
        if (q->from_0)
            thud_panel_limits(panel, THUD_X, 0.0, NAN);
        if (!isnan(q->mark))
            thud_panel_mark(panel, THUD_X, q->mark, q->mark, "");
        for (int s = 0; s < nsources; s++) {
            const struct thud_result *own = source[s].result;
            if (i < own->nstructures && own->structure[i].floors > 0 &&
                (quantity != yielding || own->structure[i].storey))
                envelope(panel, &source[s], i, q, nsources > 1 ? source[s].name : "",
                         thud_source_color(&source[s], nsources));
        }
    }
    thud_figure_share_scale(figure, THUD_Y, 0, 1, rows * n, NULL);
    for (int q = 0; q < n; q++) /* neighbours on one scale */
        thud_figure_share_scale(figure, THUD_X, q, n, rows, NULL);
    return figure;
}

struct thud_figure *thud_figure_envelopes(enum thud_run_figure which, const struct thud_figure_source *source,
                                          int nsources)
{
    return over_height(which, source, nsources, "peaks over the height", peaks, sizeof peaks / sizeof *peaks);
}

const char thud_ductility_note[] =
    "Ductility: largest drift over that at which the storey yields. Permanent drift: that "
    "at which it carries no force after the run.";

struct thud_figure *thud_figure_permanent(enum thud_run_figure which, const struct thud_figure_source *source,
                                          int nsources)
{
    struct thud_figure *figure = over_height(which, source, nsources, "ductility and permanent drift over the height",
                                             yielding, sizeof yielding / sizeof *yielding);
    thud_figure_note(figure, thud_ductility_note);
    return figure;
}
