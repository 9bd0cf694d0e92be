/* The answer in one line: whether the two neighbours shown pound, how hard, which gap they need, what the bumper does. */
#ifndef THUD_TUI_VERDICT_H
#define THUD_TUI_VERDICT_H

#include "tui/state.h"

/* "POUNDS at 8 cm: 27 impacts, 21.4 MN   needs 18.9 cm (ABS 28.0, SRSS 20.0)   bumper: force -9 %". The needed gap is
 * rounded up. Where there is no room in `columns` the rules of the codes are left off first. Empty where there is nothing to say; *pounds:
 * whether there is contact without a bumper. */
void thud_verdict_words(const struct thud_tui *tui, int columns, char *text, size_t size, bool *pounds);
/* Draws it, dimmed while a run goes on whose answer it is not yet. */
void thud_verdict_draw(struct thud_tui *tui, const struct thud_pane *row);

#endif
