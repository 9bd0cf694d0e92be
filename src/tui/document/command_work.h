/* A command of the program's own, run beside the screens: its progress is read as it comes, its output at its end. */
#pragma once

#include <stdbool.h>

#include "plot/figure/figure.h"

struct thud_command_work;

/* `program`: NULL: this one. `word` (NULL-ended, without the program's name). Errors: THUD_INPUT (it cannot be
 * started), THUD_MEMORY. */
enum thud_status thud_command_work_start(const char *program, char *const *word, struct thud_command_work **out,
                                         struct thud_error *err);
int thud_command_work_fd(const struct thud_command_work *work); /* readable when something has changed */
/* Reads what is there; false: it has come to its end. `line` gets the last line of progress. */
bool thud_command_work_look(struct thud_command_work *work, char *line, size_t size);
/* The next of the figures that it has made so far, for the caller to free; NULL: there is none. */
struct thud_figure *thud_command_work_figure(struct thud_command_work *work);
void thud_command_work_stop(struct thud_command_work *work); /* as Ctrl-C does */
/* Waits for the end and frees: the exit status (128 and the signal's number), with what was printed and what was said
 * of an error (both to be cleared). */
int thud_command_work_finish(struct thud_command_work *work, struct thud_text *printed, struct thud_text *said);
