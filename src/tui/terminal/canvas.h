/* A canvas of cells that all drawing goes to; a back end shows it. No terminal here. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/status.h"
#include "base/utf8.h"

/* What a cell is for; the terminal turns roles into colours where it may. A role is never the only sign of anything. */
enum thud_role {
    THUD_ROLE_PLAIN,
    THUD_ROLE_TITLE,
    THUD_ROLE_BORDER,
    THUD_ROLE_MUTED,
    THUD_ROLE_VALUE,  /* to be edited */
    THUD_ROLE_RESULT, /* computed */
    THUD_ROLE_GOOD,
    THUD_ROLE_WARN,
    THUD_ROLE_ERROR,
    THUD_ROLE_KEY,
    THUD_ROLE_SERIES, /* and the next seven */
    THUD_ROLES = THUD_ROLE_SERIES + 8
};
enum { THUD_BOLD = 1, THUD_REVERSE = 2, THUD_UNDERLINE = 4 };

struct thud_look {
    unsigned char role, attr;
};

enum { THUD_CELL_TAIL = 0x110000 };
struct thud_cell {
    uint32_t glyph; /* one code point; THUD_CELL_TAIL: the second column of the one before */
    struct thud_look style;
};

struct thud_canvas {
    int width, height;
    struct thud_cell *cell; /* (height x width) */
    bool ascii;             /* every glyph is brought down to ASCII when it is put */
    bool hues;              /* each curve has a colour of its own */
    int cursor_x, cursor_y; /* -1: no cursor */
};

/* A window on a canvas: what is drawn outside it vanishes. `scroll` rows are above its top. */
struct thud_pane {
    struct thud_canvas *canvas;
    int x, y, w, h;
    int scroll;
};

/* Empty after it. On THUD_MEMORY the canvas is as it was. */
enum thud_status thud_canvas_resize(struct thud_canvas *canvas, int width, int height, struct thud_error *err);
void thud_canvas_clear(struct thud_canvas *canvas);
void thud_canvas_free(struct thud_canvas *canvas);
/* Rows without trailing blanks, each ended by a newline (free with free()); NULL when out of memory. */
char *thud_canvas_text(const struct thud_canvas *canvas);

struct thud_pane thud_canvas_pane(struct thud_canvas *canvas);
struct thud_pane thud_pane_inside(const struct thud_pane *pane, int x, int y, int w, int h);

void thud_pane_glyph(const struct thud_pane *pane, int x, int y, struct thud_look style, uint32_t glyph);
/* Puts UTF-8 text and returns the columns it took (also where it was cut off). Control characters and what is not one
 * column wide show as `?`. */
int thud_pane_put(const struct thud_pane *pane, int x, int y, struct thud_look style, const char *text);
int thud_pane_print(const struct thud_pane *pane, int x, int y, struct thud_look style, const char *fmt, ...)
    THUD_PRINTF(5, 6);
void thud_pane_blank(const struct thud_pane *pane); /* what it shows */
/* Whether these `w` cells, all inside the pane, are blank. */
bool thud_pane_is_free(const struct thud_pane *pane, int x, int y, int w);
/* Ends at column x (exclusive). */
void thud_pane_right(const struct thud_pane *pane, int x, int y, struct thud_look style, const char *text);
/* A frame with a title in its upper edge; returns the inside. */
struct thud_pane thud_pane_frame(const struct thud_pane *pane, const char *title, bool focused);
/* A block of text, wrapped at blanks; returns the rows it took. */
int thud_pane_wrap(const struct thud_pane *pane, int x, int y, int w, struct thud_look style, const char *text);

static inline struct thud_look thud_look(int role, int attr)
{
    return (struct thud_look){(unsigned char)role, (unsigned char)attr};
}
