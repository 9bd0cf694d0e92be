#include "plot/figures/figures_simplify.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Points of a group, or (`curve`) the steps of one method from the coarsest on. */
static void add_points(struct thud_panel *panel, const struct thud_simplify_found *found,
                       enum thud_simplify_group group, const struct thud_simplification *curve, const char *name,
                       int color)
{
    double x[THUD_SIMPLIFY_MAX], y[THUD_SIMPLIFY_MAX];
    size_t n = 0;
    for (int i = 0; i < found->n; i++) {
        const struct thud_simplification *one = &found->one[i];
        if (one->group != group || (curve ? one->row != curve->row || one->at != curve->at : one->information) ||
            one->failed || !(one->change.all > 0) || isinf(one->change.all) || !(one->seconds > 0))
            continue;
        x[n] = one->change.all;
        y[n++] = 100 * one->seconds / found->full.seconds;
    }
    const struct thud_style style = {.kind = curve ? THUD_LINES_POINTS : THUD_POINTS, .color = color};
    if (n > 0)
        thud_panel_add(panel, style, name, n, x, y);
}

struct thud_figure *thud_figure_of_simplify(const struct thud_simplify_found *found, const char *title)
{
    char text[THUD_TEXT_MAX + 64];
    const struct thud_simplification *best = &found->cheapest, *last = NULL;
    snprintf(text, sizeof text, "%s: what more detail buys", title);
    struct thud_figure *figure = thud_figure_create("simplify", text, 1, 1);
    struct thud_panel *panel =
        thud_figure_panel(figure, 0, 0, "Simplifications one at a time, the cheapest of all, and methods");
    int color = 0;
    thud_panel_axis(panel, THUD_X, "Largest change of the peaks", "");
    thud_panel_axis(panel, THUD_Y, "Time, of the full model", "%");
    thud_panel_log(panel, THUD_X);
    thud_panel_log(panel, THUD_Y);
    thud_panel_mark(panel, THUD_X, found->within, found->within, "within");
    if (best->change.all > 0 && best->seconds > 0) {
        const double y = 100 * best->seconds / found->full.seconds;
        const struct thud_style style = {.kind = THUD_POINTS, .color = color, .wide = true};
        thud_panel_add(panel, style, "cheapest model", 1, &best->change.all, &y);
    }
    for (enum thud_simplify_group group = THUD_SIMPLIFY_MODEL; group <= THUD_SIMPLIFY_METHOD; group++)
        add_points(panel, found, group, NULL,
                   group == THUD_SIMPLIFY_METHOD ? "tolerance" : thud_simplify_group_name(group), ++color);
    for (int i = 0; i < found->n; i++) {
        const struct thud_simplification *one = &found->one[i];
        char name[32];
        if (one->group != THUD_SIMPLIFY_METHOD || !one->information ||
            (last && one->row == last->row && one->at == last->at))
            continue;
        last = one;
        snprintf(name, sizeof name, "%.*s", (int)strcspn(one->words, " "), one->words);
        add_points(panel, found, one->group, one, name, ++color);
    }
    return figure;
}
