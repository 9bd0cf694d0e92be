/* What was done, as commands of the `:` line: shown among the messages, saved, and played by `thud --play FILE`. */
#pragma once

#include "tui/document/state.h"

/* Keeps a command. */
void thud_tui_log(struct thud_tui *tui, const char *fmt, ...) THUD_PRINTF(2, 3);
/* The last command takes the place of the one before it, with what was said of that. */
void thud_tui_log_again(struct thud_tui *tui);
void thud_tui_show_log(struct thud_tui *tui);
/* Writes it to a file that is not there yet, or that holds such a log. */
void thud_tui_save_log(struct thud_tui *tui, const char *path);
