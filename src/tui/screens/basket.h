/* The suite of ground motions of the preset's study, as it is put together on the Record screen. */
#pragma once

#include "tui/document/motions.h"
#include "tui/document/state.h"

struct thud_basket {
    struct thud_study_choice study;   /* what `figure` was made of; */
    struct thud_record_choice choice; /* its file counts for nothing */
    bool made;
    struct thud_figure *figure; /* spectra of its motions against the target; NULL: `why` */
    char why[320];
    char pending[THUD_VARY_TEXT]; /* a motion that is asked for what it lacks, with what was said so far */
};

int thud_basket_count(const struct thud_tui *tui);
bool thud_basket_holds(const struct thud_tui *tui, const char *file);
/* Takes a file out, or puts it in, once it was asked for what it lacks to be read. */
void thud_basket_toggle(struct thud_tui *tui, struct thud_basket *basket, const char *file);
const struct thud_figure *thud_basket_figure(struct thud_tui *tui, struct thud_basket *basket);
