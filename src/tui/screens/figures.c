#include "tui/screens/figures.h"

#include <stdio.h>

#include "app/run/figure_files.h"

static const struct {
    const char *title, *file;
    enum thud_run_figure of;
} plots[] = {
#define THUD_PLOT(name, words, stem, which) [THUD_PLOT_##name] = {words, stem, THUD_FIGURE_##which},
#include "tui/screens/plot_list.h"
#undef THUD_PLOT
};

const char *thud_plot_title(enum thud_plot plot)
{
    return plots[plot].title;
}

int thud_plot_count(const struct thud_scene *scene)
{
    return THUD_PLOTS - !thud_scene_yields(scene);
}

enum { CASES = THUD_LIVE_CASES, NAME = 64 };

/* The cases of a state that have motions, at most CASES; `called`: what that state is, where it stands behind. */
static int add_sources(struct thud_figure_source *source, char name[][NAME], const struct thud_live *live,
                       const struct thud_scene *scene, const char *called, bool pounding)
{
    int n = 0;
    for (int i = pounding ? THUD_LIVE_NONE : THUD_LIVE_FREE; i < CASES; i++) {
        const enum thud_live_which which = (enum thud_live_which)i;
        if (!thud_live_motions(live, which))
            continue;
        snprintf(name[n], NAME, "%s%s%s", thud_live_name(live->measures, which), called ? ", " : "",
                 called ? called : "");
        source[n] = thud_run_source(name[n], thud_case_compared(i), scene, live->which[i].run);
        source[n++].behind = called;
    }
    return n;
}

/* Whether these two floors stay apart in every case. */
static bool never_meet(const struct thud_figure_source *source, int n, int contact)
{
    for (int s = 0; s < n; s++)
        if (contact < source[s].result->ncontacts && source[s].result->contact[contact].impacts > 0)
            return false;
    return true;
}

bool thud_plot_is_of_contact(enum thud_plot plot)
{
    return plot == THUD_PLOT_FORCE || plot == THUD_PLOT_APPROACH || plot == THUD_PLOT_LOOP;
}

bool thud_plot_is_of_floor(enum thud_plot plot)
{
    return plot == THUD_PLOT_ACCELERATION || plot == THUD_PLOT_DRIFT || plot == THUD_PLOT_DISPLACEMENT;
}

/* Why there is nothing to show; NULL: there is. */
static const char *lacks(const struct thud_live *live, enum thud_plot plot, const struct thud_sight *sight,
                         const struct thud_figure_source *own, int n)
{
    const bool of_contact = thud_plot_is_of_contact(plot);
    return live->running                                           ? "running"
           : live->which[THUD_LIVE_NONE].state == THUD_LIVE_FAILED ? "FAILED"
           : live->which[THUD_LIVE_NONE].state != THUD_LIVE_DONE   ? "no results: r runs"
           : n == 0 || (plot == THUD_PLOT_ENERGY && live->history != THUD_LIVE_WHOLE)
               ? "the histories are not there yet"
           : of_contact && sight->contact < 0              ? "No two floors can meet here"
           : thud_plot_is_of_floor(plot) && sight->dof < 0 ? "There is no floor"
           : of_contact && plot != THUD_PLOT_APPROACH && never_meet(own, n, sight->contact) ? "no contact at this gap"
                                                                                            : NULL;
}

struct thud_figure *thud_plot_make(const struct thud_live *live, const struct thud_base *behind,
                                   const struct thud_scene *scene, enum thud_plot plot, const struct thud_sight *sight,
                                   const char **why)
{
    struct thud_figure_source source[2 * CASES];
    char name[2 * CASES][NAME];
    const bool placed = thud_plot_is_of_contact(plot) || thud_plot_is_of_floor(plot),
               pounding = plot == THUD_PLOT_FORCE || plot == THUD_PLOT_LOOP;
    const int n = live->running ? 0 : add_sources(source, name, live, scene, NULL, pounding);
    struct thud_figure *figure;
    if ((*why = lacks(live, plot, sight, source, n)) != NULL)
        return NULL;
    const int all = behind && (placed || plot == THUD_PLOT_ENVELOPE)
                        ? n + add_sources(source + n, name + n, &behind->live, &behind->scene, behind->name, pounding)
                        : n;
    if (placed) {
        const struct thud_model *model = live->which[THUD_LIVE_NONE].model;
        const int s = sight->dof >= 0 ? model->dof_structure[sight->dof] : 0;
        const struct thud_figure_sight at = {sight->contact, s, sight->dof - model->structure[s].first};
        figure = thud_run_figure_at(plots[plot].of, source, all, &at);
    } else {
        figure = thud_run_figure_has(plots[plot].of, source, all) ? thud_run_figure(plots[plot].of, source, all) : NULL;
    }
    thud_figure_rename(figure, plots[plot].file);
    if (figure && thud_figure_check(figure, NULL) == THUD_OK)
        return figure;
    thud_figure_free(figure);
    *why = "There is nothing to show";
    return NULL;
}
