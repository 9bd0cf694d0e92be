/* The Plots screen in its parts: what it shows, its cursor in time, the pane at its side. */
#pragma once

#include "tui/document/state.h"
#include "tui/screens/figures.h"

struct thud_plots_state {
    enum thud_plot plot;
    struct thud_sight sight;
    int panel;     /* of a figure with several; -1: all, or the one with the most curves */
    double time_s; /* of its cursor */
    bool opened;   /* on the strong motion */
    bool playing;
    double speed, last_s;
    struct thud_figure *figure;
    const char *why;
    unsigned long revision;
    bool compared;      /* the curves of the state to compare with stand behind, */
    unsigned long base; /* of this number */
    bool fresh;         /* `figure` belongs to what is above */
};

struct thud_plots_state *thud_plots(const struct thud_tui *tui);
/* The case that is shown; NULL where it has no histories. */
const struct thud_live_case *thud_plots_case(struct thud_tui *tui);
double thud_plots_end(struct thud_tui *tui); /* of its histories, s; 0: there are none */

/* plots_time.c: playing, scrubbing, impacts, zoom. False where the action is another. */
void thud_plots_set_time(struct thud_tui *tui, double t); /* within what there is */
bool thud_plots_act_on_time(struct thud_tui *tui, enum thud_action action);
double thud_plots_pause(struct thud_tui *tui);
void thud_plots_tick(struct thud_tui *tui);

/* plots_side.c: the values most studies turn on, to be edited with the figure in sight, and the changes so far. Returns
 * the rows it would need. */
int thud_plots_side_draw(struct thud_tui *tui, int index, const struct thud_pane *pane);
