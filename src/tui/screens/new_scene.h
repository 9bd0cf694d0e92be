/* A scene from nothing: the few values that two neighbours, their gap and a ground motion need, and from them a preset
 * to go on with on the screens. */
#ifndef THUD_TUI_NEW_SCENE_H
#define THUD_TUI_NEW_SCENE_H

#include "tui/document/state.h"

enum { THUD_NEW_ROWS = 9 }; /* of the form */
enum { THUD_NEW_TEXT = 256 };

struct thud_new_scene {
    char text[THUD_NEW_ROWS][2][THUD_NEW_TEXT]; /* as typed, left and right; rows of one value have it on the left */
    bool own[THUD_NEW_ROWS];                    /* the right value was typed; else it goes with the left one */
    int row, side;                              /* the value being typed */
    struct thud_line line;
    struct thud_browse files; /* ground motions to choose from */
};

/* Begins with the usual values, the cursor on the number of storeys. */
void thud_new_scene_begin(struct thud_tui *tui);
void thud_new_scene_key(struct thud_tui *tui, int key);
/* "storeys: 5, 7; gap: 8 cm; record: a.AT2": makes it at once, with the usual values where nothing is said; a single
 * value is of both. */
void thud_new_scene_command(struct thud_tui *tui, const char *text);
void thud_new_scene_draw(struct thud_tui *tui, const struct thud_pane *area);
void thud_new_scene_free(struct thud_tui *tui);

#endif
