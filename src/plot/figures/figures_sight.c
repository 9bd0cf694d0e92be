/* One quantity at one place of a run, its cases over each other: what a screen shows of the figures of files. */
#include <math.h>
#include <stdio.h>

#include "plot/figures/figures_run_internal.h"
#include "study/scene/level.h"

/* Another state may have fewer floors and contacts. */
static bool has_place(const struct thud_figure_source *source, enum thud_run_figure which,
                      const struct thud_figure_sight *sight)
{
    const struct thud_result *result = source->result;
    if (which == THUD_FIGURE_FORCE || which == THUD_FIGURE_LOOP)
        return sight->contact < source->history->ncontacts;
    if (which == THUD_FIGURE_VELOCITY)
        return sight->contact < result->ncontacts;
    return sight->structure < result->nstructures &&
           sight->floor < result->structure[sight->structure].floors +
                              (which != THUD_FIGURE_DRIFT && result->structure[sight->structure].foundation ? 2 : 0);
}

/* The degree of freedom of a floor, from 1; -1 of a wall, which has none. */
static int dof_of(const struct thud_figure_source *source, int structure, int floor)
{
    return floor > 0 ? thud_source_first_dof(source, structure) + floor - 1 : -1;
}

/* Positive while the two of a contact come nearer. */
static void approach(struct thud_panel *panel, const struct thud_figure_source *source, int contact, const char *name,
                     int color)
{
    const struct thud_contact_result *c = &source->result->contact[contact];
    const struct thud_history *h = source->history;
    const int left = dof_of(source, c->interface - 1, c->left_floor),
              right = dof_of(source, c->interface, c->right_floor);
    const int of = left >= 0 ? left : right;
    if (of >= 0)
        thud_source_line(panel, source, thud_history_velocity(h, of),
                         left >= 0 && right >= 0 ? thud_history_velocity(h, right) : -1, left >= 0 ? 1.0 : -1.0, name,
                         color);
}

static void place_name(const struct thud_figure_source *source, const struct thud_figure_sight *sight, bool storey,
                       char *text, size_t size)
{
    const struct thud_structure *structure = &source->scene->structure[sight->structure];
    const int floors = source->result->structure[sight->structure].floors;
    char level[24];
    if (sight->floor >= floors)
        snprintf(text, size, "%s, %s", structure->name, sight->floor == floors ? "foundation" : "rocking at the roof");
    else
        snprintf(text, size, "%s, %s", structure->name,
                 thud_structure_level_name(structure, sight->floor, storey, level));
}

struct thud_figure *thud_run_figure_at(enum thud_run_figure which, const struct thud_figure_source *source,
                                       int nsources, const struct thud_figure_sight *sight)
{
    const struct thud_run_words *words = &thud_run_words[which];
    const bool speed = which == THUD_FIGURE_VELOCITY, loop = which == THUD_FIGURE_LOOP,
               force = which == THUD_FIGURE_FORCE || loop;
    const struct thud_shown_unit shown = force ? thud_shown_force(thud_source_force(source, nsources))
                                               : (struct thud_shown_unit){words->factor, words->unit};
    char place[160], what[256], title[3 * THUD_TEXT_MAX];
    if (force || speed)
        thud_source_contact_name(source, sight->contact, place, sizeof place);
    else
        place_name(source, sight, which == THUD_FIGURE_DRIFT, place, sizeof place);
    snprintf(what, sizeof what, loop ? "%s%.0s, %s" : "%s (%s), %s", speed ? "approach velocity" : words->title,
             shown.unit, place);
    thud_source_title(source, nsources, what, title, sizeof title);
    struct thud_figure *figure = thud_figure_create(thud_run_figure_name(which), title, 1, 1);
    struct thud_panel *panel = thud_figure_panel(figure, 0, 0, "");
    thud_panel_axis(panel, THUD_X, "Time", "s");
    thud_panel_axis(panel, THUD_Y, speed ? "Approach velocity" : words->label, shown.unit);
    if (loop)
        thud_loop_axes(panel, shown.unit);
    int own = 0;
    while (own < nsources && !source[own].behind)
        own++;
    for (int k = 0; panel && k < nsources; k++) {
        const int s = (own + k) % nsources, color = thud_case_color(source[s].which), before = panel->nseries;
        if (!has_place(&source[s], which, sight))
            continue;
        if (loop)
            thud_source_loop(panel, &source[s], sight->contact, shown.factor, source[s].name, color);
        else if (force)
            thud_source_line(panel, &source[s], thud_history_force(source[s].history, sight->contact), -1, shown.factor,
                             source[s].name, color);
        else if (speed)
            approach(panel, &source[s], sight->contact, source[s].name, color);
        else
            thud_source_floor(panel, &source[s], sight->structure, sight->floor, which, source[s].name, color);
        for (int i = before; source[s].behind && i < panel->nseries; i++)
            panel->series[i]->style.thin = panel->series[i]->style.dashed = true;
    }
    return figure;
}
