/* Drawing the fields of a screen; each registers itself for the cursor. */
#pragma once

#include "tui/document/state.h"

/* The value of a key of the scene in `w` columns; `unit` false leaves the table's unit out (a heading has it). */
void thud_field_value(struct thud_tui *tui, int index, const struct thud_pane *pane, int x, int y, int w,
                      const char *key, bool unit);
/* A label at x and the value of a key at value_x, which a blank is before; likewise in a row of its own. */
void thud_field_labelled(struct thud_tui *tui, int index, const struct thud_pane *pane, int x, int y, const char *label,
                         int value_x, int w, const char *key);
void thud_field_row(struct thud_tui *tui, int index, const struct thud_pane *pane, int y, const char *label,
                    const char *key);
/* Likewise keys of the interface shown, a row each from `y` on; what its laws have not is left out. Returns the row
 * after them. */
struct thud_labelled {
    const char *label, *key;
};
int thud_field_rows(struct thud_tui *tui, int index, const struct thud_pane *pane, int y,
                    const struct thud_labelled *row, size_t n);
/* All keys of a group behind a prefix ("" or "analysis."), a row each; returns the row after them. */
int thud_field_group(struct thud_tui *tui, int index, const struct thud_pane *pane, int y, enum thud_group group,
                     const char *prefix);
/* A line that Enter chooses. */
void thud_field_line(struct thud_tui *tui, int index, const struct thud_pane *pane, int y, int number, const char *path,
                     const char *text);
/* "title" in muted letters. */
void thud_field_note(const struct thud_pane *pane, int y, const char *fmt, ...) THUD_PRINTF(3, 4);

/* What a parameter is: meaning, units, what is allowed, what is usual, its default. */
void thud_param_words(const struct thud_param *param, char *words, size_t size);
