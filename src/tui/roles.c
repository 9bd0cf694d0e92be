/* Nobody asks the terminal for its background, so by default a colour has to be read on black and on white. Contrast is
 * that of WCAG 2.1, (L1 + 0.05)/(L2 + 0.05) with the relative luminance L. Of the 256 colours those from 16 on are the
 * same in every terminal; the ones chosen here have a contrast of at least 3.3 with both, those of a theme for one
 * background at least 4.5 with that. The first sixteen are each terminal's own: red, magenta and bright blue can be read
 * on both in all that were looked at; yellow, green and cyan cannot be on white, bright black not everywhere on black,
 * so what would have these is in the terminal's own text colour, but for the theme of black.
 *
 * Series have the hues of the figures (plot/figure.h: Okabe and Ito 2008). */
#include "tui/roles.h"

#include "tui/canvas.h"

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

struct colors {
    short of_256, of_16, of_8;
};

static const struct colors both[THUD_ROLES] = {
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

static const struct colors dark[THUD_ROLES] = {
    [THUD_ROLE_PLAIN] = {TEXT, TEXT, TEXT},
    [THUD_ROLE_TITLE] = {81, BRIGHT_CYAN, CYAN},
    [THUD_ROLE_BORDER] = {245, TEXT, TEXT},
    [THUD_ROLE_MUTED] = {247, TEXT, TEXT},
    [THUD_ROLE_VALUE] = {117, BRIGHT_CYAN, CYAN},
    [THUD_ROLE_GOOD] = {78, BRIGHT_GREEN, GREEN},
    [THUD_ROLE_WARN] = {215, BRIGHT_YELLOW, YELLOW},
    [THUD_ROLE_ERROR] = {203, BRIGHT_RED, RED},
    [THUD_ROLE_KEY] = {180, BRIGHT_YELLOW, YELLOW},
    [THUD_ROLE_SERIES] = {39, BRIGHT_CYAN, CYAN},
    [THUD_ROLE_SERIES + 1] = {208, BRIGHT_RED, RED},
    [THUD_ROLE_SERIES + 2] = {42, BRIGHT_GREEN, GREEN},
    [THUD_ROLE_SERIES + 3] = {214, BRIGHT_YELLOW, YELLOW},
    [THUD_ROLE_SERIES + 4] = {123, BRIGHT_CYAN, CYAN},
    [THUD_ROLE_SERIES + 5] = {176, BRIGHT_MAGENTA, MAGENTA},
    [THUD_ROLE_SERIES + 6] = {TEXT, TEXT, TEXT},
    [THUD_ROLE_SERIES + 7] = {168, BRIGHT_RED, RED},
};

static const struct colors light[THUD_ROLES] = {
    [THUD_ROLE_PLAIN] = {TEXT, TEXT, TEXT},
    [THUD_ROLE_TITLE] = {25, BLUE, BLUE},
    [THUD_ROLE_BORDER] = {241, TEXT, TEXT},
    [THUD_ROLE_MUTED] = {240, TEXT, TEXT},
    [THUD_ROLE_VALUE] = {25, BLUE, BLUE},
    [THUD_ROLE_GOOD] = {22, BLUE, BLUE},
    [THUD_ROLE_WARN] = {130, MAGENTA, MAGENTA},
    [THUD_ROLE_ERROR] = {124, RED, RED},
    [THUD_ROLE_KEY] = {94, TEXT, TEXT},
    [THUD_ROLE_SERIES] = {25, BLUE, BLUE},
    [THUD_ROLE_SERIES + 1] = {130, RED, RED},
    [THUD_ROLE_SERIES + 2] = {23, TEXT, TEXT},
    [THUD_ROLE_SERIES + 3] = {94, MAGENTA, MAGENTA},
    [THUD_ROLE_SERIES + 4] = {61, BLUE, BLUE},
    [THUD_ROLE_SERIES + 5] = {127, MAGENTA, MAGENTA},
    [THUD_ROLE_SERIES + 6] = {TEXT, TEXT, TEXT},
    [THUD_ROLE_SERIES + 7] = {89, RED, RED},
};

static const struct colors *of(enum thud_theme theme, int role)
{
    return theme == THUD_THEME_DARK ? &dark[role] : theme == THUD_THEME_LIGHT ? &light[role] : &both[role];
}

const char *thud_theme_name(enum thud_theme theme)
{
    static const char *const name[THUD_THEMES] = {"auto", "dark", "light", "mono", "16"};
    return name[theme];
}

int thud_role_color(enum thud_theme theme, int role, int colors)
{
    const struct colors *c = of(theme, role);
    if (theme == THUD_THEME_MONO)
        return TEXT;
    if (theme == THUD_THEME_16 && colors > 16)
        colors = 16;
    return colors >= 256 ? c->of_256 : colors >= 16 ? c->of_16 : c->of_8;
}

bool thud_role_bold(enum thud_theme theme, int role, int colors)
{
    return theme != THUD_THEME_MONO && theme != THUD_THEME_LIGHT && colors < 16 && of(theme, role)->of_8 == BLUE;
}
