/* A picture of small dots put into the cells of a pane: 2 x 4 braille dots a cell, or 1 x 2 with ' . : in ASCII. */
#pragma once

#include "tui/terminal/canvas.h"

struct thud_dots {
    struct thud_pane pane;
    int across, down;       /* dots in a cell */
    int width, height;      /* dots in all */
    unsigned char *mask;    /* (pane.h x pane.w) */
    struct thud_look *look; /* (pane.h x pane.w) of the last dot */
    unsigned char pattern;  /* of a line's dots along its longer direction, from the lowest bit; 0: all */
    int sign;               /* what a cell with dots shows in ASCII; 0: its dots */
};

/* Errors: THUD_MEMORY. */
enum thud_status thud_dots_init(struct thud_dots *dots, const struct thud_pane *pane, struct thud_error *err);
/* A straight line between two points, also far outside; NaN draws nothing. `every` > 1 draws every so many dots. */
void thud_dots_line(struct thud_dots *dots, double x0, double y0, double x1, double y1, int every,
                    struct thud_look look);
/* Puts the cells that have dots, and clears the dots. */
void thud_dots_put(struct thud_dots *dots);
void thud_dots_clear(struct thud_dots *dots);
