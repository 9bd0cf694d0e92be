/* The loop in its parts, so that tests can turn it by hand. */
#ifndef THUD_TUI_LOOP_H
#define THUD_TUI_LOOP_H

#include "tui/document/state.h"

/* Errors: THUD_INPUT (the preset), THUD_MEMORY. */
enum thud_status thud_tui_create(const struct thud_tui_options *options, struct thud_backend *backend,
                                 struct thud_tui **out, struct thud_error *err);
void thud_tui_key(struct thud_tui *tui, int key);
/* One turn: draws where something changed, takes a key, works for a few milliseconds. Blocks only where there is
 * nothing to do and `wait`. False: nothing was done. */
bool thud_tui_turn(struct thud_tui *tui, bool wait);
void thud_tui_free(struct thud_tui *tui);

#endif
