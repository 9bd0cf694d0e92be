/* The result in one line: whether the neighbours shown pound, how hard, which gap they need, what the bumper does. */
#pragma once

#include "tui/document/state.h"

/* Draws it, dimmed while a run goes on whose result it is not yet. */
void thud_verdict_draw(struct thud_tui *tui, const struct thud_pane *row);
