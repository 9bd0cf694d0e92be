/* Largest shears of the columns that slabs strike, over the height of each structure, against what they can bear. */
#include <math.h>
#include <stdio.h>

#include "plot/figures/figures_run_internal.h"
#include "study/scene/level.h"

enum { PANELS_MAX = 4, BLACK = THUD_COLORS - 1 };

/* Elevation of the struck place: of the contact with the largest force on these columns. *impacts: are there any. */
static double struck_at(const struct thud_result *result, int column, double low, double high, bool *impacts)
{
    const struct thud_contact_result *most = NULL;
    for (int c = 0; c < result->ncontacts; c++)
        if (result->contact[c].column == column && (!most || result->contact[c].force.value > most->force.value))
            most = &result->contact[c];
    *impacts = most && most->impacts > 0;
    return low + (most ? most->eta : 0.5) * (high - low);
}

/* Elevations of the two ends of struck columns. */
static void ends_of(const struct thud_structure *s, const struct thud_column_result *c, double *low, double *high)
{
    *high = thud_structure_elevation(s, c->storey - 1);
    *low = c->storey > 1 ? thud_structure_elevation(s, c->storey - 2) : s->base_m;
}

static bool is_shown(const struct thud_column_result *c, int structure, int interface)
{
    return c->structure == structure && c->interface == interface;
}

/* Of each storey from the lower end up: the shear below the slab and the one above it; storeys stand apart. */
static void add_shears(struct thud_panel *panel, const struct thud_figure_source *source, int structure, int interface,
                       const char *name, int color)
{
    const struct thud_result *result = source->result;
    struct thud_style style = {.kind = THUD_LINES, .color = color};
    struct thud_series *series = thud_panel_add(panel, style, name, 5 * (size_t)result->ncolumns, NULL, NULL);
    size_t n = 0;
    for (int i = 0; series && i < result->ncolumns; i++) {
        const struct thud_column_result *c = &result->column[i];
        double low, high, shear[2];
        for (int q = 0; q < 2; q++)
            shear[q] = is_shown(c, structure, interface) ? 1e-6 * c->peak[q].value : NAN;
        ends_of(&source->scene->structure[c->structure], c, &low, &high);
        bool impacts;
        double at = struck_at(result, i, low, high, &impacts);
        const double x[] = {shear[0], shear[0], shear[1], shear[1], NAN}, y[] = {low, at, at, high, NAN};
        for (int k = 0; k < 5; k++, n++) {
            series->x[n] = x[k];
            series->y[n] = y[k];
        }
    }
}

/* Where a slab strikes: its elevation, at the larger of the two shears. */
static void add_strikes(struct thud_panel *panel, const struct thud_figure_source *source, int structure, int interface)
{
    const struct thud_result *result = source->result;
    struct thud_style style = {.kind = THUD_POINTS, .color = BLACK, .wide = true};
    struct thud_series *series =
        thud_panel_add(panel, style, "where a slab strikes", (size_t)result->ncolumns, NULL, NULL);
    for (int i = 0; series && i < result->ncolumns; i++) {
        const struct thud_column_result *c = &result->column[i];
        double low, high;
        ends_of(&source->scene->structure[c->structure], c, &low, &high);
        bool impacts;
        series->y[i] = struck_at(result, i, low, high, &impacts);
        series->x[i] =
            impacts && is_shown(c, structure, interface) ? 1e-6 * fmax(c->peak[0].value, c->peak[1].value) : NAN;
    }
}

static void add_capacities(struct thud_panel *panel, const struct thud_figure_source *source, int structure,
                           int interface)
{
    const struct thud_result *result = source->result;
    struct thud_style style = {.kind = THUD_LINES, .color = BLACK, .wide = true}; /* grey dots are no pounding */
    bool any = false;
    for (int i = 0; i < result->ncolumns; i++)
        any |= is_shown(&result->column[i], structure, interface) && isfinite(result->column[i].capacity_n);
    struct thud_series *series =
        any ? thud_panel_add(panel, style, "capacity", 3 * (size_t)result->ncolumns, NULL, NULL) : NULL;
    for (int i = 0; series && i < result->ncolumns; i++) {
        const struct thud_column_result *c = &result->column[i];
        double low, high, x = is_shown(c, structure, interface) ? 1e-6 * c->capacity_n : NAN;
        ends_of(&source->scene->structure[c->structure], c, &low, &high);
        const double y[] = {low, high, NAN};
        for (int k = 0; k < 3; k++) {
            series->x[3 * i + k] = k < 2 ? x : NAN;
            series->y[3 * i + k] = y[k];
        }
    }
}

/* The next structure and interface with struck columns after these; false where there is none. */
static bool next_panel(const struct thud_result *result, int *structure, int *interface)
{
    for (int s = *structure, i = *interface + 1; s < result->nstructures; s++, i = 1)
        for (; i < result->nstructures; i++)
            for (int c = 0; c < result->ncolumns; c++)
                if (is_shown(&result->column[c], s, i)) {
                    *structure = s;
                    *interface = i;
                    return true;
                }
    return false;
}

struct thud_figure *thud_figure_columns(enum thud_run_figure which, const struct thud_figure_source *source,
                                        int nsources)
{
    char text[3 * THUD_TEXT_MAX];
    int panels = 0, s = 0, i = 0;
    while (panels < PANELS_MAX && next_panel(source->result, &s, &i))
        panels++;
    thud_source_title(source, nsources, "largest shear of struck columns", text, sizeof text);
    struct thud_figure *figure = thud_figure_create(thud_run_figure_name(which), text, 1, panels);
    s = i = 0;
    for (int p = 0; p < panels && next_panel(source->result, &s, &i); p++) {
        const struct thud_structure *own = &source->scene->structure[s], *other = own + (s == i - 1 ? 1 : -1);
        snprintf(text, sizeof text, "%.60s, struck by %.60s", own->name, other->name);
        struct thud_panel *panel = thud_figure_panel(figure, 0, p, text);
        thud_panel_axis(panel, THUD_X, "Largest shear", "MN");
        thud_panel_results_on_x(panel);
        thud_panel_axis(panel, THUD_Y, "Height", "m");
        thud_panel_limits(panel, THUD_X, 0.0, NAN);
        for (int k = 0; k < nsources; k++)
            add_shears(panel, &source[k], s, i, nsources > 1 ? source[k].name : "shear",
                       thud_source_color(&source[k], nsources));
        for (int k = 0; k < nsources; k++)
            add_strikes(panel, &source[k], s, i);
        add_capacities(panel, source, s, i);
    }
    thud_figure_share_scale(figure, THUD_Y, 0, 1, panels, NULL);
    thud_figure_note(figure, "Above and below the slab that strikes, each at its own time.");
    return figure;
}
