/* What was done, as commands of the `:` line: shown, saved, and played again by `thud --play FILE`. */
#pragma once

#include "tui/document/state.h"

/* Keeps a command. */
void thud_tui_log(struct thud_tui *tui, const char *fmt, ...) THUD_PRINTF(2, 3);
void thud_tui_show_log(struct thud_tui *tui);
/* Writes it to a file that is not there yet, or that holds such a log. */
void thud_tui_save_log(struct thud_tui *tui, const char *path);
