/* Figures of the live cases, as data for the terminal's charts and for gnuplot. */
#pragma once

#include "tui/document/base.h"

enum thud_plot {
#define THUD_PLOT(name, words, file, which) THUD_PLOT_##name,
#include "tui/screens/plot_list.h"
#undef THUD_PLOT
    THUD_PLOTS
};
const char *thud_plot_title(enum thud_plot plot);
/* How many of them the scene has: the last one is of storeys that yield. */
int thud_plot_count(const struct thud_scene *scene);

/* What is looked at: a contact of the model (from 0, -1: none) and a floor by its dof. */
struct thud_sight {
    int contact, dof;
    enum thud_live_which which; /* that moves */
};
bool thud_plot_is_of_contact(enum thud_plot plot);
bool thud_plot_is_of_floor(enum thud_plot plot);

/* NULL when there is nothing to show (`why` says it), or no memory. `behind`: the state whose curves stand behind,
 * dashed; NULL: none. */
struct thud_figure *thud_plot_make(const struct thud_live *live, const struct thud_base *behind,
                                   const struct thud_scene *scene, enum thud_plot plot, const struct thud_sight *sight,
                                   const char **why);
