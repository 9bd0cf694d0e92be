/* The text of the help, made from the program's own tables: keys, fields, laws, methods, commands. */
#pragma once

#include "tui/document/state.h"

enum { THUD_HELP_COLUMNS = 100 };

enum thud_help_kind { THUD_HELP_PLAIN, THUD_HELP_HEAD, THUD_HELP_ITEM };
struct thud_help_line {
    enum thud_help_kind kind;
    int key; /* columns at the start that are a key or a name; 0: none */
    char text[4 * THUD_HELP_COLUMNS + 4];
};
struct thud_help_text {
    struct thud_help_line *line; /* (n) */
    int n;
};

/* For a screen, in so many columns. Out of memory what could not be kept is left out. */
void thud_help_text_make(struct thud_help_text *text, const struct thud_tui *tui, int screen, int columns);
void thud_help_text_clear(struct thud_help_text *text);
/* The next line from `from` on in steps of `step` (1 or -1, around the ends) that holds `word`, upper and lower case
 * alike; -1: none does. */
int thud_help_text_find(const struct thud_help_text *text, const char *word, int from, int step);
/* Where `word` stands in a line, from byte `from` on; -1: not there. */
int thud_help_line_find(const struct thud_help_line *line, const char *word, int from);
