/* The colour of every role (canvas.h): one table. */
#ifndef THUD_TUI_ROLES_H
#define THUD_TUI_ROLES_H

#include <stdbool.h>

/* What a role is drawn in on a terminal of so many colours: an index into its palette, -1 the terminal's own text
 * colour. The background is always the terminal's own. */
int thud_role_color(int role, int colors);
/* Whether it is bold there: terminals of eight colours show blue bright enough only so. */
bool thud_role_bold(int role, int colors);

#endif
