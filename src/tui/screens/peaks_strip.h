/* The peaks of the pair shown, in the three cases. */
#pragma once

#include "tui/document/state.h"

/* The heads of its columns, for the frame's upper edge, as there are few rows; for a pane `w` columns wide within. */
void thud_peaks_strip_title(const struct thud_tui *tui, int w, char *text, size_t size);
/* Returns the rows it would need. */
int thud_peaks_strip_draw(struct thud_tui *tui, const struct thud_pane *pane);
/* What the bumper makes of the number without; nothing while one of the two is still that of before the last change. */
void thud_ratio_draw(const struct thud_live *live, const struct thud_pane *pane, int x, int y,
                     const double value[THUD_LIVE_CASES]);
/* The number of a case, right before column `right`, or what stands in its place; `moved`: words in place of it. */
void thud_case_draw(const struct thud_live *live, enum thud_live_which which, const struct thud_pane *pane, int right,
                    int y, const char *moved, const char *number);
