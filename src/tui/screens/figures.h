/* Figures of the live cases, as data for the terminal's charts and for gnuplot. */
#pragma once

#include "app/run/live_cases.h"
#include "plot/figure/figure.h"
#include "study/scene/scene.h"

enum thud_plot {
#define THUD_PLOT(name, words, file) THUD_PLOT_##name,
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
    enum thud_live_which which; /* for figures of one case */
    const char *compared;       /* what the state whose curves stand behind is called */
};

/* NULL when there is nothing to show (`why` says it), or no memory. `compared`: cases whose curves stand behind, dashed;
 * NULL: none. */
struct thud_figure *thud_plot_make(const struct thud_live *live, const struct thud_live *compared,
                                   const struct thud_scene *scene, enum thud_plot plot, const struct thud_sight *sight,
                                   const char **why);
