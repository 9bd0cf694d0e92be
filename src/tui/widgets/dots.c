#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tui/widgets/dots.h"

enum thud_status thud_dots_init(struct thud_dots *dots, const struct thud_pane *pane, struct thud_error *err)
{
    size_t cells = (size_t)(pane->w > 0 ? pane->w : 1) * (size_t)(pane->h > 0 ? pane->h : 1);
    bool ascii = pane->canvas->ascii;
    *dots = (struct thud_dots){.pane = *pane, .across = ascii ? 1 : 2, .down = ascii ? 2 : 4};
    dots->width = pane->w * dots->across;
    dots->height = pane->h * dots->down;
    dots->mask = calloc(cells, 1);
    dots->look = calloc(cells, sizeof *dots->look);
    if (dots->mask && dots->look)
        return THUD_OK;
    thud_dots_clear(dots);
    return thud_error_set(err, THUD_MEMORY, "no memory for a chart");
}

void thud_dots_clear(struct thud_dots *dots)
{
    free(dots->mask);
    free(dots->look);
    dots->mask = NULL;
    dots->look = NULL;
}

/* Dot coordinates run right and down from 0; what lies outside vanishes. */
static void set_dot(struct thud_dots *dots, int x, int y, struct thud_look look)
{
    /* the bits of U+2800, by row and column of the dot */
    static const unsigned char braille[4][2] = {{0x01, 0x08}, {0x02, 0x10}, {0x04, 0x20}, {0x40, 0x80}};
    if (x < 0 || y < 0 || x >= dots->width || y >= dots->height)
        return;
    int cell = y / dots->down * dots->pane.w + x / dots->across;
    int row = y % dots->down, column = x % dots->across;
    unsigned bit = dots->down == 4 ? braille[row][column] : 1U << row;
    bool first = dots->mask[cell] == 0;
    dots->mask[cell] = (unsigned char)(dots->mask[cell] | bit);
    if (first || (cell % dots->pane.w + cell / dots->pane.w) % 2 == 0) /* lines in the same cells take turns */
        dots->look[cell] = look;
}

/* Cuts one end of the stretch [*t0, *t1] of a line where p + t d leaves [low, high]; false when nothing is left. */
static bool cut(double p, double d, double low, double high, double *t0, double *t1)
{
    if (d == 0.0)
        return p >= low && p <= high;
    double a = (low - p) / d, b = (high - p) / d;
    *t0 = fmax(*t0, fmin(a, b));
    *t1 = fmin(*t1, fmax(a, b));
    return *t0 <= *t1;
}

void thud_dots_line(struct thud_dots *dots, double x0, double y0, double x1, double y1, int every,
                    struct thud_look look)
{
    double dx = x1 - x0, dy = y1 - y0, t0 = 0.0, t1 = 1.0;
    if (!isfinite(dx) || !isfinite(dy) || !cut(x0, dx, -0.5, dots->width - 0.51, &t0, &t1) ||
        !cut(y0, dy, -0.5, dots->height - 0.51, &t0, &t1))
        return;
    x1 = x0 + t1 * dx;
    y1 = y0 + t1 * dy;
    x0 += t0 * dx;
    y0 += t0 * dy;
    int n = (int)ceil(fmax(fabs(x1 - x0), fabs(y1 - y0)));
    bool flat = fabs(x1 - x0) >= fabs(y1 - y0);
    for (int i = 0; i <= n; i++) {
        double t = n ? (double)i / n : 0.0;
        int x = (int)lround(x0 + t * (x1 - x0)), y = (int)lround(y0 + t * (y1 - y0));
        bool end = n >= 3 && (i == 0 || i == n); /* of a spike */
        if (i % every == 0 && (end || !dots->pattern || dots->pattern >> ((flat ? x : y) & 7) & 1))
            set_dot(dots, x, y, look);
    }
}

void thud_dots_put(struct thud_dots *dots)
{
    static const char ascii[] = " '.:";
    for (int y = 0; y < dots->pane.h; y++)
        for (int x = 0; x < dots->pane.w; x++) {
            int cell = y * dots->pane.w + x;
            unsigned mask = dots->mask[cell];
            if (!mask)
                continue;
            uint32_t dot = dots->sign ? (uint32_t)dots->sign : (uint32_t)(unsigned char)ascii[mask & 3];
            uint32_t glyph = dots->down == 4 ? 0x2800U + mask : dot;
            thud_pane_glyph(&dots->pane, x, y, dots->look[cell], glyph);
        }
    memset(dots->mask, 0, (size_t)dots->pane.w * (size_t)dots->pane.h);
}
