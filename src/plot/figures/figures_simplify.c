#include "plot/figures/figures_simplify.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Points of one kind: a group's simplifications, or (`row` not -1) the steps of one method as a curve. */
static void add_points(struct thud_panel *panel, const struct thud_simplify *s, enum thud_simplify_group group, int row,
                       const char *name, int color)
{
    double x[THUD_SIMPLIFY_MAX], y[THUD_SIMPLIFY_MAX];
    size_t n = 0;
    for (int i = 0; i < thud_simplify_count(s); i++) {
        const struct thud_simplification *one = thud_simplify_at(s, i);
        if (one->group != group || (row >= 0 ? one->row != row : one->information) || one->failed ||
            !(one->change.all > 0) || isinf(one->change.all))
            continue;
        x[n] = one->change.all;
        y[n++] = 100 * one->work;
    }
    const struct thud_style style = {.kind = row < 0 ? THUD_POINTS : THUD_LINES_POINTS, .color = color};
    if (n > 0)
        thud_panel_add(panel, style, name, n, x, y);
}

struct thud_figure *thud_figure_of_simplify(const struct thud_simplify *s, const char *title)
{
    char text[THUD_TEXT_MAX + 64];
    const struct thud_simplification *best = thud_simplify_cheapest(s);
    snprintf(text, sizeof text, "%s: what more detail buys", title);
    struct thud_figure *figure = thud_figure_create("simplify", text, 1, 1);
    struct thud_panel *panel =
        thud_figure_panel(figure, 0, 0, "Simplifications one at a time, and the cheapest of all");
    int color = 0;
    thud_panel_axis(panel, THUD_X, "Largest change of the peaks", "");
    thud_panel_axis(panel, THUD_Y, "Work, of the full model", "%");
    thud_panel_log(panel, THUD_X);
    thud_panel_log(panel, THUD_Y);
    thud_panel_mark(panel, THUD_X, thud_simplify_within(s), thud_simplify_within(s), "within");
    if (best->change.all > 0) {
        const double y = 100 * best->work;
        const struct thud_style style = {.kind = THUD_POINTS, .color = color, .wide = true};
        thud_panel_add(panel, style, "cheapest model", 1, &best->change.all, &y);
    }
    for (enum thud_simplify_group group = THUD_SIMPLIFY_MODEL; group <= THUD_SIMPLIFY_METHOD; group++)
        add_points(panel, s, group, -1, group == THUD_SIMPLIFY_METHOD ? "tolerance" : thud_simplify_group_name(group),
                   ++color);
    for (int i = 0, last = -1; i < thud_simplify_count(s); i++) {
        const struct thud_simplification *one = thud_simplify_at(s, i);
        char name[32];
        if (one->group != THUD_SIMPLIFY_METHOD || !one->information || one->row == last)
            continue;
        last = one->row;
        snprintf(name, sizeof name, "%.*s", (int)strcspn(one->words, " "), one->words);
        add_points(panel, s, one->group, one->row, name, ++color);
    }
    return figure;
}
