/* A scene from nothing: the few values that two neighbours, their gap and a ground motion need, and from them a preset
 * to go on with on the screens. */
#pragma once

#include "tui/document/state.h"

/* Begins with the usual values, the cursor on the number of storeys. */
void thud_new_scene_begin(struct thud_tui *tui);
/* "storeys: 5, 7; gap: 8 cm; record: a.AT2": makes it at once, with the usual values where nothing is said; a single
 * value is of both. */
void thud_new_scene_command(struct thud_tui *tui, char *text);
