/* The peaks of the pair shown, in the three cases. */
#ifndef THUD_TUI_PEAKS_STRIP_H
#define THUD_TUI_PEAKS_STRIP_H

#include "tui/state.h"

/* The heads of the columns, for the frame's upper edge, as there are few rows. */
/* The heads of its columns, for a pane `w` columns wide within. */
void thud_peaks_strip_title(const struct thud_tui *tui, int w, char *text, size_t size);
/* Returns the rows it would need. */
int thud_peaks_strip_draw(struct thud_tui *tui, const struct thud_pane *pane);

#endif
