/* The buildings at the largest impact of the interface shown, as a pane of a screen that is wide enough. */
#pragma once

#include "tui/document/state.h"

/* Columns from which it stands beside what a screen shows, and rows from which forms share theirs with it. */
enum { THUD_MOMENT_WIDE = 120, THUD_MOMENT_TALL = 44 };

void thud_moment_title(const struct thud_tui *tui, char *text, size_t size);
int thud_moment_draw(const struct thud_tui *tui, const struct thud_pane *pane);
/* What a screen needs of the motions for it, where it has the room. */
enum thud_live_history thud_moment_history(const struct thud_tui *tui);
