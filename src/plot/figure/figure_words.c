/* A figure in words, for those who cannot see it. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "plot/figure/figure.h"

enum { WORDS_MOST = 700, CURVES_MOST = 6 };

/* How far the curves of a name reach along the axis of the results. */
static void reach(const struct thud_panel *panel, const char *name, enum thud_side side, double *least, double *most)
{
    *least = INFINITY;
    *most = -INFINITY;
    for (int i = 0; i < panel->nseries; i++) {
        const struct thud_series *s = panel->series[i];
        const double *value = side == THUD_X ? s->x : s->y;
        if (strcmp(s->name, name) != 0 || thud_series_is_shade(s))
            continue;
        for (size_t k = 0; k < s->n; k++)
            if (isfinite(value[k])) {
                *least = fmin(*least, value[k]);
                *most = fmax(*most, value[k]);
            }
    }
}

static bool is_first(const struct thud_panel *panel, int i)
{
    for (int k = 0; k < i; k++)
        if (strcmp(panel->series[k]->name, panel->series[i]->name) == 0)
            return false;
    return true;
}

/* Whether a curve without a name is beside named ones, which have a legend. */
static bool is_beside_named(const struct thud_panel *panel, int i)
{
    bool named = false;
    for (int k = 0; k < panel->nseries; k++)
        named = named || *panel->series[k]->name;
    return named && !*panel->series[i]->name;
}

static void panel_words(const struct thud_panel *panel, struct thud_text *out)
{
    const enum thud_side side = panel->axis[THUD_X].results ? THUD_X : THUD_Y;
    const struct thud_axis *axis = &panel->axis[side], *across = &panel->axis[1 - (int)side];
    const char *colon = ": ";
    int curves = 0;
    thud_text_append(out, "%s%s%s", out->size ? " " : "", panel->title, *panel->title ? ": " : "");
    if (panel->drawing) {
        for (int i = 0; i < panel->nseries; i++)
            if (is_first(panel, i) && *panel->series[i]->name)
                thud_text_append(out, "%s%s", curves++ ? ", " : "a drawing of ", panel->series[i]->name);
        thud_text_append(out, ".");
        return;
    }
    thud_text_append(out, "%s against %s", *axis->label ? axis->label : "values",
                     *across->label ? across->label : "index");
    for (int i = 0; i < panel->nseries && curves < CURVES_MOST; i++) {
        double least, most;
        if (!is_first(panel, i) || is_beside_named(panel, i))
            continue;
        reach(panel, panel->series[i]->name, side, &least, &most);
        if (!(least <= most))
            continue;
        if (fabs(least) < 1e-3 * fabs(most)) /* round-off of what is 0 */
            least = 0;
        thud_text_append(out, most < 999.5 ? "%s%s%s%.3g to %.3g%s%s" : "%s%s%s%.0f to %.0f%s%s", colon,
                         panel->series[i]->name, *panel->series[i]->name ? " " : "", least, most,
                         *axis->unit ? " " : "", axis->unit);
        colon = ", ";
        curves++;
    }
    thud_text_append(out, ".");
}

void thud_figure_words(const struct thud_figure *figure, struct thud_text *out)
{
    for (int i = 0; figure && i < figure->rows * figure->columns && out->size < WORDS_MOST; i++)
        if (figure->panel[i].used && !figure->panel[i].closer)
            panel_words(&figure->panel[i], out);
}
