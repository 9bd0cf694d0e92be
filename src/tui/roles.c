/* Nobody asks the terminal for its background, so a colour has to be read on black and on white. Contrast is that of
 * WCAG 2.1, (L1 + 0.05)/(L2 + 0.05) with the relative luminance L. Of the 256 colours those from 16 on are the same in
 * every terminal; the ones chosen here have a contrast of at least 3.3 with both. The first sixteen are each terminal's
 * own: red, magenta and bright blue can be read on both in all that were looked at; yellow, green and cyan cannot be on
 * white, bright black not everywhere on black, so what would have these is in the terminal's own text colour.
 *
 * Series have the hues of the figures (plot/figure.h: Okabe and Ito 2008). */
#include "tui/roles.h"

#include "tui/canvas.h"

enum { TEXT = -1, RED = 1, BLUE = 4, MAGENTA = 5, BRIGHT_BLUE = 12 };

static const struct {
    short of_256, of_16, of_8;
} table[THUD_ROLES] = {
    [THUD_ROLE_PLAIN] = {TEXT, TEXT, TEXT},
    [THUD_ROLE_TITLE] = {31, BRIGHT_BLUE, BLUE},
    [THUD_ROLE_BORDER] = {243, TEXT, TEXT},
    [THUD_ROLE_MUTED] = {243, TEXT, TEXT},
    [THUD_ROLE_VALUE] = {31, BRIGHT_BLUE, BLUE},
    [THUD_ROLE_GOOD] = {29, BRIGHT_BLUE, BLUE},
    [THUD_ROLE_WARN] = {166, MAGENTA, MAGENTA},
    [THUD_ROLE_ERROR] = {160, RED, RED},
    [THUD_ROLE_KEY] = {130, TEXT, TEXT},
    [THUD_ROLE_SERIES] = {32, BRIGHT_BLUE, BLUE},     /* blue */
    [THUD_ROLE_SERIES + 1] = {166, RED, RED},         /* vermilion */
    [THUD_ROLE_SERIES + 2] = {29, TEXT, TEXT},        /* bluish green */
    [THUD_ROLE_SERIES + 3] = {136, MAGENTA, MAGENTA}, /* orange */
    [THUD_ROLE_SERIES + 4] = {68, BRIGHT_BLUE, BLUE}, /* sky blue */
    [THUD_ROLE_SERIES + 5] = {169, MAGENTA, MAGENTA}, /* reddish purple */
    [THUD_ROLE_SERIES + 6] = {TEXT, TEXT, TEXT},      /* black */
    [THUD_ROLE_SERIES + 7] = {132, RED, RED},         /* wine */
};

int thud_role_color(int role, int colors)
{
    return colors >= 256 ? table[role].of_256 : colors >= 16 ? table[role].of_16 : table[role].of_8;
}

bool thud_role_bold(int role, int colors)
{
    return colors < 16 && table[role].of_8 == BLUE;
}
