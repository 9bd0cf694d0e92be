/* Storeys that yield: their loops and those of links. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "plot/figures/figures_run_internal.h"
#include "study/scene/level.h"

enum { LOOPS_MAX = 6, LOOP_COLUMNS = 3 };

/* A storey that yields: its structure and floor, from 0, and its place among the storeys of a history; a link, or the
 * soil behind a wall: -1, its index less their number, and -1. */
struct place {
    int structure, floor, storey;
};

/* Index of a link of a case; below 0: a case may be without the links of others, whose soil is then before that. */
static int link_of(const struct thud_figure_source *source, const struct place *at)
{
    return source->result->nlinks + at->floor;
}

static bool has(const struct thud_figure_source *source, const struct place *at)
{
    return at->structure >= 0 || link_of(source, at) >= 0;
}

static double lost_of(const struct thud_figure_source *source, const struct place *at)
{
    if (!has(source, at))
        return 0.0;
    return at->structure < 0 ? source->result->link[link_of(source, at)].lost_j
                             : source->result->structure[at->structure].storey[at->floor].hysteretic_j;
}

static double force_of(const struct thud_figure_source *source, const struct place *at)
{
    if (!has(source, at))
        return 0.0;
    return at->structure < 0 ? source->result->link[link_of(source, at)].force.value
                             : source->result->structure[at->structure].storey[at->floor].shear.value;
}

/* The source that has the links. */
static const struct thud_figure_source *linked_source(const struct thud_figure_source *source, int nsources)
{
    const struct thud_figure_source *most = source;
    for (int s = 1; s < nsources; s++)
        most = source[s].result->nlinks > most->result->nlinks ? &source[s] : most;
    return most;
}

/* Storeys that yield and, behind them, links, at most `most`; how many there are. */
static int list_storeys(const struct thud_figure_source *source, struct place *place, int most)
{
    int n = 0;
    for (int s = 0; s < source->result->nstructures; s++)
        for (int f = 0; f < source->result->structure[s].floors; f++) {
            const struct thud_storey_result *storey = source->result->structure[s].storey;
            if (!storey || !storey[f].yields)
                continue;
            if (n < most)
                place[n] = (struct place){s, f, n};
            n++;
        }
    for (int i = 0; i < source->result->nlinks; i++, n++)
        if (n < most)
            place[n] = (struct place){-1, i - source->result->nlinks, -1};
    return n;
}

bool thud_source_yields(const struct thud_figure_source *source, int nsources, bool links)
{
    struct place first;
    return list_storeys(linked_source(source, nsources), &first, 1) > 0 && (links || first.structure >= 0);
}

static void loop(struct thud_panel *panel, const struct thud_figure_source *source, const struct place *at,
                 double factor, const char *name, int color)
{
    const struct thud_history *h = source->history;
    const bool link = at->structure < 0;
    const int drift =
                  link ? thud_history_link_stroke(h, link_of(source, at)) : thud_history_storey_drift(h, at->storey),
              force = link ? thud_history_link_force(h, link_of(source, at)) : thud_history_storey_shear(h, at->storey);
    struct thud_series *series =
        thud_panel_add(panel, (struct thud_style){.kind = THUD_LINES, .color = color}, name, h->rows, NULL, NULL);
    for (size_t i = 0; series && i < h->rows; i++) {
        const double *row = h->value + i * (size_t)h->columns;
        series->x[i] = 1e3 * row[drift];
        series->y[i] = factor * row[force];
    }
}

struct thud_figure *thud_figure_hysteresis(enum thud_run_figure which, const struct thud_figure_source *source,
                                           int nsources)
{
    enum { STOREYS = THUD_STRUCTURES_MAX * (THUD_STOREYS_MAX + 1) + THUD_LINKS_MAX + 2 };
    static const char largest[] = "The storeys and links that lost most energy; histories.csv has all.";
    const struct thud_figure_source *linked = linked_source(source, nsources);
    struct place *place = malloc(STOREYS * sizeof *place);
    double *lost = calloc(STOREYS, sizeof *lost), shear = 0.0;
    char text[3 * THUD_TEXT_MAX];
    int index[LOOPS_MAX], all = place && lost ? list_storeys(linked, place, STOREYS) : 0;
    for (int k = 0; k < all; k++)
        for (int s = 0; s < nsources; s++) {
            lost[k] = fmax(lost[k], lost_of(&source[s], &place[k]));
            shear = fmax(shear, force_of(&source[s], &place[k]));
        }
    int n = thud_pick_largest(lost, all, LOOPS_MAX, index), columns = n < LOOP_COLUMNS ? n > 0 ? n : 1 : LOOP_COLUMNS;
    struct thud_shown_unit shown = thud_shown_force(shear);
    thud_source_title(source, nsources,
                      n > 0 && place[index[0]].structure < 0 ? "force against stroke" : "storey shear against drift",
                      text, sizeof text);
    struct thud_figure *figure =
        thud_figure_create(thud_run_figure_name(which), text, n > 0 ? (n + columns - 1) / columns : 1, columns);
    for (int i = 0; i < n; i++) {
        const struct place *at = &place[index[i]];
        const struct thud_structure *of = at->structure < 0 ? NULL : &source->scene->structure[at->structure];
        if (!of) {
            char ends[2 * THUD_NAME_MAX + 32];
            thud_link_name(linked->scene, link_of(linked, at), ends, sizeof ends);
            snprintf(text, sizeof text, "%s, %s", ends, thud_link_law_name(linked->scene, link_of(linked, at)));
        } else {
            char level[24];
            snprintf(text, sizeof text, "%s, %s", of->name, thud_structure_level_name(of, at->floor, true, level));
        }
        struct thud_panel *panel = thud_figure_panel(figure, i / columns, i % columns, text);
        thud_panel_axis(panel, THUD_X, of ? "Drift" : "Stroke", "mm");
        thud_panel_results_on_x(panel);
        thud_panel_axis(panel, THUD_Y, of ? "Shear" : "Force", shown.unit);
        for (int s = 0; s < nsources; s++)
            if (has(&source[s], at))
                loop(panel, &source[s], at, shown.factor, nsources > 1 ? source[s].name : "",
                     thud_source_color(&source[s], nsources));
    }
    if (n < all)
        thud_figure_note(figure, largest);
    free(place);
    free(lost);
    return figure;
}
