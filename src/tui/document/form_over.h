/* A form over the screen: rows of one value, or of one for each of two structures, with their help below. What the rows
 * are comes from a table: the options of a command, the values of a new scene, the parts of a question. */
#pragma once

#include "tui/document/state.h"

enum { THUD_OVER_ROWS = 80 };

struct thud_over_row {
    char label[40];
    const char *help;
    const char *(*choice)(const struct thud_over_row *row,
                          int i); /* the i-th word it takes, NULL past the last; NULL: any text */
    const void *of;               /* what the row stands for */
    bool only;                    /* no other text than those words */
    bool two;                     /* a value for each structure */
    bool motion;                  /* a ground motion: files that fit what is typed are listed */
    struct thud_line value[2];
};

struct thud_form_over {
    char title[160];
    int n, at, side, top;
    struct thud_over_row row[THUD_OVER_ROWS]; /* (n) */
    int id;                                   /* what the form is of, for who reads it */
    char prefix[24];                          /* letters typed on words to choose from */
    char was[THUD_LINE_MAX];                  /* what stood in the field before it was entered */
    struct thud_browse files;
    bool (*applies)(const struct thud_form_over *form, int row, int side); /* NULL: all do */
    void (*left)(struct thud_form_over *form); /* the field is left, or accepted; NULL: nothing follows from it */
    void (*done)(struct thud_tui *tui, struct thud_form_over *form); /* Enter; it leaves the form, or says why not */
};

/* Empty; NULL: there is no memory, which was said. */
struct thud_form_over *thud_form_over_begin(struct thud_tui *tui);
/* One more row behind the others, to be filled in; at most THUD_OVER_ROWS, the last one again beyond. */
struct thud_over_row *thud_form_over_add(struct thud_form_over *form, const char *label, const char *help,
                                         const char *value);
void thud_form_over_focus(struct thud_form_over *form, int row, int side);
