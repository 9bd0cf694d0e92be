/* Nobody asks the terminal for its background, so by default a colour has to be read on black and on white. Contrast is
 * that of WCAG 2.1, (L1 + 0.05)/(L2 + 0.05) with the relative luminance L. Of the 256 colours those from 16 on are the
 * same in every terminal; the ones chosen here have a contrast of at least 3.3 with both, those of a theme for one
 * background at least 4.5 with that. The first sixteen are the terminal's own: red, magenta and bright blue can be read
 * on both in all that were looked at; yellow, green and cyan cannot be on white, bright black not everywhere on black,
 * so what would have these is in the terminal's own text colour, but for the theme of black.
 *
 * Series have the hues of the figures (plot/figure.h: Okabe and Ito 2008). */
#include "tui/terminal/roles.h"

#include "tui/terminal/canvas.h"

enum {
    TEXT = -1,
    RED = 1,
    GREEN,
    YELLOW,
    BLUE,
    MAGENTA,
    CYAN,
    BRIGHT_RED = 9,
    BRIGHT_GREEN,
    BRIGHT_YELLOW,
    BRIGHT_BLUE,
    BRIGHT_MAGENTA,
    BRIGHT_CYAN
};

/* Of each role, of 256, 16 and 8 colours: on a background that is not known, on black, on white. */
enum { OF_256, OF_16, OF_8, DEPTHS };
static const short table[THUD_ROLES][3 * DEPTHS] = {
    [THUD_ROLE_PLAIN] = {TEXT, TEXT, TEXT, TEXT, TEXT, TEXT, TEXT, TEXT, TEXT},
    [THUD_ROLE_TITLE] = {31, BRIGHT_BLUE, BLUE, 81, BRIGHT_CYAN, CYAN, 25, BLUE, BLUE},
    [THUD_ROLE_BORDER] = {243, TEXT, TEXT, 245, TEXT, TEXT, 241, TEXT, TEXT},
    [THUD_ROLE_MUTED] = {243, TEXT, TEXT, 247, TEXT, TEXT, 240, TEXT, TEXT},
    [THUD_ROLE_VALUE] = {31, BRIGHT_BLUE, BLUE, 117, BRIGHT_CYAN, CYAN, 25, BLUE, BLUE},
    [THUD_ROLE_RESULT] = {TEXT, TEXT, TEXT, TEXT, TEXT, TEXT, TEXT, TEXT, TEXT},
    [THUD_ROLE_GOOD] = {29, BRIGHT_BLUE, BLUE, 78, BRIGHT_GREEN, GREEN, 22, BLUE, BLUE},
    [THUD_ROLE_WARN] = {166, MAGENTA, MAGENTA, 215, BRIGHT_YELLOW, YELLOW, 130, MAGENTA, MAGENTA},
    [THUD_ROLE_ERROR] = {160, RED, RED, 203, BRIGHT_RED, RED, 124, RED, RED},
    [THUD_ROLE_KEY] = {30, TEXT, TEXT, 80, BRIGHT_MAGENTA, MAGENTA, 23, TEXT, TEXT},
    [THUD_ROLE_SERIES] = {32, BRIGHT_BLUE, BLUE, 39, BRIGHT_BLUE, CYAN, 25, BLUE, BLUE}, /* blue */
    [THUD_ROLE_SERIES + 1] = {166, RED, RED, 208, BRIGHT_RED, RED, 130, RED, RED},       /* vermilion */
    [THUD_ROLE_SERIES + 2] = {29, TEXT, TEXT, 42, BRIGHT_GREEN, GREEN, 23, TEXT, TEXT},  /* bluish green */
    [THUD_ROLE_SERIES + 3] = {136, MAGENTA, MAGENTA, 214, BRIGHT_YELLOW, YELLOW, 94, MAGENTA, MAGENTA}, /* orange */
    [THUD_ROLE_SERIES + 4] = {68, BRIGHT_BLUE, BLUE, 123, BRIGHT_CYAN, CYAN, 61, BLUE, BLUE},           /* sky blue */
    [THUD_ROLE_SERIES + 5] = {169, MAGENTA, MAGENTA, 176, BRIGHT_MAGENTA, MAGENTA, 127, MAGENTA,
                              MAGENTA},                                              /* reddish purple */
    [THUD_ROLE_SERIES + 6] = {TEXT, TEXT, TEXT, TEXT, TEXT, TEXT, TEXT, TEXT, TEXT}, /* black */
    [THUD_ROLE_SERIES + 7] = {132, RED, RED, 168, MAGENTA, RED, 89, RED, RED},       /* wine */
};

static const short *of(enum thud_theme theme, int role)
{
    return table[role] + DEPTHS * (theme == THUD_THEME_DARK ? 1 : theme == THUD_THEME_LIGHT ? 2 : 0);
}

const char *thud_theme_name(enum thud_theme theme)
{
    static const char *const name[THUD_THEMES] = {"auto", "dark", "light", "mono", "16"};
    return name[theme];
}

int thud_role_color(enum thud_theme theme, int role, int colors)
{
    const short *c = of(theme, role);
    if (theme == THUD_THEME_MONO)
        return TEXT;
    if (theme == THUD_THEME_16 && colors > 16)
        colors = 16;
    return colors >= 256 ? c[OF_256] : colors >= 16 ? c[OF_16] : c[OF_8];
}

bool thud_role_bold(enum thud_theme theme, int role, int colors)
{
    return theme != THUD_THEME_MONO && theme != THUD_THEME_LIGHT && colors < 16 && of(theme, role)[OF_8] == BLUE;
}
