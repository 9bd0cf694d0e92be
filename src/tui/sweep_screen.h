/* The Sweep screen in its parts: what it shows, and its form. */
#ifndef THUD_TUI_SWEEP_SCREEN_H
#define THUD_TUI_SWEEP_SCREEN_H

#include "tui/state.h"
#include "tui/sweep_work.h"

struct thud_sweep_state {
    struct thud_study_words words;  /* as shown and run */
    struct thud_study_choice study; /* the scene's, when the words were taken from it */
    struct thud_study_words ran;    /* what the study on show was made with */
    struct thud_sweep_work work;
    unsigned long revision; /* of the scene the study was made with */
    int figure, panel;      /* which is shown; panel -1: all */
    struct thud_figure *shown;
    size_t shown_rows;
    int shown_figure;
    int typed; /* the line being typed */
};

/* NULL when out of memory. The words follow the scene's study, also when that is undone. */
struct thud_sweep_state *thud_sweep_state(struct thud_tui *tui);
/* Draws the form in pane `index`; returns the rows it would need. */
int thud_sweep_form_draw(struct thud_tui *tui, int index, const struct thud_pane *pane);
/* Enter on a line of it. */
void thud_sweep_form_row(struct thud_tui *tui, const struct thud_field *field);

#endif
