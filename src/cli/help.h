/* Help and completions as text, from the table of commands and options. */
#ifndef THUD_CLI_HELP_H
#define THUD_CLI_HELP_H

#include "app/run/command.h"
#include "base/text.h"

/* All commands; the usage and options of one. Each fits 80 columns and 24 lines. */
void thud_help_all(struct thud_text *out);
void thud_help_command(struct thud_text *out, enum thud_command_id id);

/* A completion script; false when the shell is none of bash, zsh, fish. The scripts ask `thud help --words LIST` for
 * words that change. */
bool thud_completion(struct thud_text *out, const char *shell);

#endif
