/* The colour of every role (canvas.h): one table a theme. */
#pragma once

#include <stdbool.h>

enum thud_theme {
    THUD_THEME_AUTO, /* to be read on black and on white */
    THUD_THEME_DARK,
    THUD_THEME_LIGHT,
    THUD_THEME_MONO, /* no colour */
    THUD_THEME_16,   /* as auto, of the first sixteen colours, which are the terminal's own */
    THUD_THEMES
};
const char *thud_theme_name(enum thud_theme theme); /* "auto" */

/* What a role is drawn in on a terminal of so many colours: an index into its palette, -1 the terminal's own text
 * colour. The background is always the terminal's own. */
int thud_role_color(enum thud_theme theme, int role, int colors);
/* Whether it is bold there: terminals of eight colours show blue bright enough only so. */
bool thud_role_bold(enum thud_theme theme, int role, int colors);
