/* Help and completions as text, from the table of commands and options. */
#pragma once

#include <stdbool.h>

#include "app/run/command.h"
#include "base/text.h"

/* All commands; the usage and options of one. Each fits 80 columns and 24 lines. */
void thud_help_all(struct thud_text *out);
void thud_help_command(struct thud_text *out, enum thud_command_id id);

/* The paragraphs of the manual pages that a question is about; false: there are none. */
bool thud_help_search(struct thud_text *out, const char *question);

/* A completion script; false when the shell is none of bash, zsh, fish. The scripts ask `thud help --complete LINE`. */
bool thud_completion(struct thud_text *out, const char *shell);
/* The words allowed at the end of a line, whose words are separated by tabs: "WORD", or "WORD\tWHAT IT IS". ":files",
 * ":folders" and ":presets" stand for such files. */
void thud_complete(struct thud_text *out, const char *line);
/* The words of a kind, a line each; keys are those of the laws that `line` sets. */
void thud_word_list(enum thud_word word, const char *line, struct thud_text *out);

/* ---- The parts of thud-preset(5) that come from the program's own tables, as mdoc ---- */

/* One part: "units", "keys", "laws". It stands in man/thud-preset.5 between the comments `begin NAME` and `end NAME`,
 * where tests/tools/manual.sh puts it and the tests compare it. false: there is no such part. */
bool thud_manual_part(struct thud_text *out, const char *name);

/* The names of the parts, by index from 0; NULL after the last. */
const char *thud_manual_part_name(int index);
