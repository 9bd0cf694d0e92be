/* Sessions played without a terminal. */
#pragma once

#include "tui/loop/loop.h"

/* Carries out the commands of options->play, and prints each with what came of it: messages, and the result where it is
 * another one. Errors: THUD_INPUT with file and line where a command was refused, THUD_OUTPUT, THUD_MEMORY. */
enum thud_status thud_tui_play(const struct thud_tui_options *options, struct thud_error *err);
/* The same on screens that are there; what would be printed goes to `out`. */
enum thud_status thud_tui_play_lines(struct thud_tui *tui, const char *path, struct thud_text *out,
                                     struct thud_error *err);
