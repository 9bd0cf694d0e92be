/* One line of text being typed. */
#pragma once

#include "tui/terminal/backend.h"

enum { THUD_LINE_MAX = 512 };

struct thud_line {
    char text[THUD_LINE_MAX];
    int cursor;    /* byte offset, always at the start of a code point */
    bool selected; /* all of it: the next character replaces it */
};

void thud_line_set(struct thud_line *line, const char *text); /* cursor at the end, nothing selected */
void thud_line_select(struct thud_line *line, const char *text);
/* Types a text up to its first control character, as if key by key. */
void thud_line_type(struct thud_line *line, const char *text);
/* Types or moves; false where the key means nothing to a line. */
bool thud_line_key(struct thud_line *line, int key);
/* Draws it in `w` columns with the part around the cursor shown, and sets the canvas's cursor. */
void thud_line_draw(const struct thud_line *line, const struct thud_pane *pane, int x, int y, int w,
                    struct thud_look style);
