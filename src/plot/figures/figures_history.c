/* Histories of the floors: a strip for each. */
#include <math.h>
#include <stdio.h>

#include "base/quantity.h"
#include "plot/figures/figures_run_internal.h"
#include "study/scene/level.h"

int thud_source_first_dof(const struct thud_figure_source *source, int structure)
{
    int dof = 0;
    for (int i = 0; i < structure; i++)
        dof += source->result->structure[i].floors + (source->result->structure[i].foundation ? 2 : 0);
    return dof;
}

const struct thud_run_words thud_run_words[THUD_RUN_FIGURES] = {
    [THUD_FIGURE_FORCE] = {"Impact force", "impact force", "", 0},
    [THUD_FIGURE_LOOP] = {"Impact force", "impact force against indentation", "", 0},
    [THUD_FIGURE_VELOCITY] = {"Velocity to the ground", "floor velocity relative to the ground", "m/s", 1.0},
    [THUD_FIGURE_ACCELERATION] = {"Total acceleration", "total floor acceleration", "g", 1.0 / THUD_GRAVITY},
    [THUD_FIGURE_DISPLACEMENT] = {"Displacement to the ground", "floor displacement relative to the ground", "cm",
                                  100.0},
    [THUD_FIGURE_DRIFT] = {"Interstorey drift", "interstorey drift", "mm", 1000.0},
};

static double floor_peak(const struct thud_figure_source *source, int structure, int floor, enum thud_run_figure which)
{
    const struct thud_floor_result *f = &source->result->structure[structure].floor[floor];
    return which == THUD_FIGURE_VELOCITY       ? f->velocity.value
           : which == THUD_FIGURE_ACCELERATION ? f->acceleration.value
           : which == THUD_FIGURE_DISPLACEMENT ? f->displacement.value
                                               : f->drift.value;
}

void thud_source_floor(struct thud_panel *panel, const struct thud_figure_source *source, int structure, int floor,
                       enum thud_run_figure which, const char *name, int color)
{
    const struct thud_history *h = source->history;
    int dof = thud_source_first_dof(source, structure) + floor, column = thud_history_displacement(h, dof), less = -1;
    if (which == THUD_FIGURE_VELOCITY)
        column = thud_history_velocity(h, dof);
    else if (which == THUD_FIGURE_ACCELERATION)
        column = thud_history_acceleration(h, dof);
    else if (which == THUD_FIGURE_DRIFT && floor > 0)
        less = thud_history_displacement(h, dof - 1);
    struct thud_series *line = thud_source_line(panel, source, column, less, thud_run_words[which].factor, name, color);
    const struct thud_structure_result *r = &source->result->structure[structure];
    const struct thud_structure *of = &source->scene->structure[structure];
    const int base = dof - floor + r->floors, storey = floor - (of->kind == THUD_ISOLATED);
    const double rise = storey >= 0 ? of->height_m[storey] / r->arm_m : 0;
    for (size_t i = 0; line && which == THUD_FIGURE_DRIFT && r->foundation && i < line->n; i++) {
        const double *row = h->value + i * (size_t)h->columns + thud_history_displacement(h, base);
        line->y[i] -= thud_run_words[which].factor * ((floor > 0 ? 0 : row[0]) + rise * row[1]);
    }
}

bool thud_source_shown(const struct thud_figure_source *source, int structure, enum thud_run_figure which)
{
    enum thud_structure_kind kind = source->scene->structure[structure].kind;
    return source->result->structure[structure].floors > 0 &&
           !(which == THUD_FIGURE_DRIFT && !thud_kind_is_building(kind));
}

/* A floor of a structure, both from 0. */
struct place {
    int structure, floor;
};

/* The floors that have a strip: all, or of each structure those with the largest peaks; the top of the first structure
 * first. */
static int pick_floors(const struct thud_figure_source *source, int nsources, enum thud_run_figure which,
                       struct place *place, bool *all)
{
    int nshown = 0, total = 0, n = 0;
    for (int i = 0; i < source->result->nstructures; i++) {
        nshown += thud_source_shown(source, i, which);
        total += thud_source_shown(source, i, which) ? source->result->structure[i].floors : 0;
    }
    const int most = thud_source_places(nsources);
    *all = total <= most;
    int each = *all ? total : nshown > 0 && most > nshown ? most / nshown : 1;
    for (int i = 0; i < source->result->nstructures; i++) {
        int floors = source->result->structure[i].floors, index[THUD_STOREYS_MAX + 1];
        double peak[THUD_STOREYS_MAX + 1] = {0.0};
        if (!thud_source_shown(source, i, which))
            continue;
        for (int f = 0; f < floors; f++)
            for (int s = 0; s < nsources; s++)
                peak[f] = fmax(peak[f], floor_peak(&source[s], i, f, which));
        int count = *all ? floors : thud_pick_largest(peak, floors, each, index);
        for (int k = count - 1; k >= 0 && n < (most > nshown ? most : nshown) && n < THUD_STRIPS_MAX; k--)
            place[n++] = (struct place){i, *all ? k : index[k]};
    }
    return n;
}

/* Whether a strip has a scale of its own: a wall, and what isolators move beside drifts of storeys. */
static bool is_apart(const struct thud_figure_source *source, const struct place *place, enum thud_run_figure which)
{
    const enum thud_structure_kind kind = source->scene->structure[place->structure].kind;
    return kind == THUD_WALL || (which == THUD_FIGURE_DRIFT && kind == THUD_ISOLATED && place->floor == 0);
}

struct thud_figure *thud_figure_histories(enum thud_run_figure which, const struct thud_figure_source *source,
                                          int nsources)
{
    struct place place[THUD_STRIPS_MAX];
    bool all, apart = false, ground = thud_source_ground(source);
    double from, to;
    char title[3 * THUD_TEXT_MAX], what[128];
    bool zoom = thud_source_zoom(source, nsources, &from, &to);
    int n = pick_floors(source, nsources, which, place, &all), rows = n * nsources + ground;
    snprintf(what, sizeof what, "%s (%s)", thud_run_words[which].title, thud_run_words[which].unit);
    thud_source_title(source, nsources, what, title, sizeof title);
    struct thud_figure *figure =
        thud_figure_create(thud_run_figure_name(which), title, rows > 0 ? rows : 1, zoom ? 2 : 1);
    if (ground)
        thud_figure_ground(figure, source, from, to);
    for (int i = 0; i < n; i++) {
        const struct thud_structure *structure = &source->scene->structure[place[i].structure];
        bool one = source->result->structure[place[i].structure].floors == 1;
        char name[128], text[256], level[24];
        snprintf(name, sizeof name, "%s%s%s", structure->name, one ? "" : ", ",
                 one ? "" : thud_structure_level_name(structure, place[i].floor, which == THUD_FIGURE_DRIFT, level));
        for (int s = 0; s < nsources; s++) {
            const int row = i * nsources + s + ground;
            const char *strip = thud_source_strip(&source[s], nsources, name, text);
            struct thud_panel *panel = thud_figure_panel(figure, row, 0, strip);
            thud_panel_axis(panel, THUD_X, "Time", "s");
            thud_panel_axis(panel, THUD_Y, thud_run_words[which].label, thud_run_words[which].unit);
            thud_source_floor(panel, &source[s], place[i].structure, place[i].floor, which, "",
                              thud_source_color(&source[s], nsources));
            if (zoom)
                thud_panel_zoom(thud_figure_panel(figure, row, 1, strip), panel, from, to);
        }
    }
    for (int i = 0; figure && i < n;
         i++) /* a light wall that is struck would leave the floors flat, as would isolators */
        if (is_apart(source, &place[i], which)) {
            thud_figure_share_scale(figure, THUD_Y, (i * nsources + ground) * figure->columns, 1,
                                    nsources * figure->columns, NULL);
            apart = true;
        }
    thud_figure_same_height(figure, ground);
    thud_figure_strips(figure);
    thud_figure_shorten(figure);
    if (apart)
        thud_figure_note(figure, which == THUD_FIGURE_DRIFT ? "Isolators have scales of their own."
                                                            : "Walls have scales of their own.");
    if (!all)
        thud_figure_note(figure, "Of each structure the floors with the largest peaks; histories.csv has all.");
    return figure;
}
