/* The Sweep screen in its parts: what it shows, and its form. */
#pragma once

#include "app/sweep/live_study.h"
#include "tui/document/state.h"

struct thud_sweep_state {
    struct thud_study_choice study; /* what the study on show was made with */
    struct thud_live_study data;
    struct thud_scene *base; /* of the study, its varied keys at their first values; NULL: none was made */
    bool current;            /* the study on show is that of the words and the scene of `revision` */
    unsigned long revision;  /* at which `current` was last found */
    bool by_itself;          /* it was begun by an edit, and not by `r` */
    char why[320];           /* why it could not be begun, or was not; empty: nothing */
    double begun_s;
    int figure, panel; /* which is shown; panel -1: all */
    struct thud_figure *shown;
    size_t shown_rows;
    bool shown_complete;
    int shown_figure;
    unsigned long begun, shown_of; /* studies begun so far; the one of them that `shown` was made of */
};

struct thud_sweep_state *thud_sweep_state(const struct thud_tui *tui);
/* Whether the study on show is that of the scene and the words as they are: what is varied may have any value. */
bool thud_sweep_current(struct thud_tui *tui, struct thud_sweep_state *s);
/* Draws the form in pane `index`; returns the rows it would need. */
int thud_sweep_form_draw(struct thud_tui *tui, int index, const struct thud_pane *pane);
/* What is typed on a line of it. */
const char *thud_sweep_form_hint(const struct thud_field *field);
/* "vary KEY=...; KEY=...": all its lines. */
void thud_sweep_command(struct thud_tui *tui, const char *word, const char *rest);
/* Enter on a line of it: the form of all that is varied. */
void thud_sweep_form_row(struct thud_tui *tui, const struct thud_field *field);
