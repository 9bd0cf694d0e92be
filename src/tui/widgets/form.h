/* The fields on a screen. Every drawing registers them again with their places, so the cursor keys need no map. */
#pragma once

#include "tui/terminal/canvas.h"

enum { THUD_PATH_MAX = 128 };

enum thud_field_kind {
    THUD_FIELD_VALUE, /* `path` is a key of the scene */
    THUD_FIELD_ROW    /* a line that can be chosen; `path` names it, `index` counts it */
};

struct thud_field {
    char path[THUD_PATH_MAX];
    enum thud_field_kind kind;
    int pane, x, y, w; /* in the pane's own rows, before scrolling */
    int index;
    bool beside; /* left or right of what is drawn: the cursor keys lead there, Tab and clicks do not */
};

enum { THUD_FORM_SCREENS = 9, THUD_FORM_PANES = 6 };
struct thud_form {
    struct thud_field *field; /* (n) in the order they were drawn */
    int n;
    int screen;
    char focus[THUD_FORM_SCREENS][THUD_PATH_MAX]; /* the field the cursor is on, by screen */
    int pane[THUD_FORM_SCREENS];                  /* the pane with the cursor */
    int scroll[THUD_FORM_SCREENS][THUD_FORM_PANES];
    bool loose
        [THUD_FORM_SCREENS]; /* the pane with the cursor is scrolled on by lines, also where that hides the field */
    int used[THUD_FORM_PANES], height[THUD_FORM_PANES];
};

void thud_form_begin(struct thud_form *form, int screen);
/* Out of memory a field is only not there for the cursor. */
void thud_form_add(struct thud_form *form, enum thud_field_kind kind, int pane, int x, int y, int w, int index,
                   const char *path);
/* One more VALUE that has no room now: the pane has to show it once the cursor is on it. */
void thud_form_add_beside(struct thud_form *form, int pane, int x, int y, int w, const char *path);
/* After drawing: a cursor on a field that is gone goes to the nearest; true where that or a pane's scrolling has to be
 * drawn. */
bool thud_form_end(struct thud_form *form, int panes);
const struct thud_field *thud_form_focus(const struct thud_form *form); /* NULL: there is none */
bool thud_form_focused(const struct thud_form *form, int pane, const char *path);
void thud_form_focus_on(struct thud_form *form, int screen, const char *path);

/* Moves the cursor; where a pane has no fields, or none further down, it scrolls by lines. */
void thud_form_move(struct thud_form *form, int dx, int dy);
void thud_form_page(struct thud_form *form, int pages);
void thud_form_edge(struct thud_form *form, bool last);
void thud_form_pane(struct thud_form *form, int step, int panes);
void thud_form_next(struct thud_form *form, int step);
/* The field of a pane in row y that is nearest to column x, so that a label counts as well; NULL: the row has none. */
const struct thud_field *thud_form_at(const struct thud_form *form, int pane, int x, int y);
void thud_form_free(struct thud_form *form);
