/* What shows a canvas and reads keys: the terminal (term.c), or a script in tests (script.c). */
#pragma once

#include <stdbool.h>

#include "tui/terminal/canvas.h"
#include "tui/terminal/image.h"

/* Keys are code points (Ctrl-A is 1), or one of these. */
enum {
    THUD_KEY_NONE = 0,
    THUD_KEY_TAB = 9,
    THUD_KEY_ENTER = 13,
    THUD_KEY_ESC = 27,
    THUD_KEY_BACKSPACE = 127,
    THUD_KEY_FIRST = 0x200000,
    THUD_KEY_UP = THUD_KEY_FIRST,
    THUD_KEY_DOWN,
    THUD_KEY_LEFT,
    THUD_KEY_RIGHT,
    THUD_KEY_HOME,
    THUD_KEY_END,
    THUD_KEY_PAGE_UP,
    THUD_KEY_PAGE_DOWN,
    THUD_KEY_DELETE,
    THUD_KEY_BACKTAB,
    THUD_KEY_F1,
    THUD_KEY_F2,
    THUD_KEY_RESIZE,
    THUD_KEY_CLICK,    /* where: thud_backend.click_x, click_y */
    THUD_KEY_WHEEL_UP, /* as well */
    THUD_KEY_WHEEL_DOWN,
    THUD_KEY_DRAG,          /* moved with the button down */
    THUD_KEY_PASTE,         /* what: thud_backend.paste */
    THUD_KEY_HANGUP,        /* no more keys will come */
    THUD_KEY_ALT = 0x400000 /* added to a code point */
};
#define THUD_CTRL(c) ((c)&0x1f)

struct thud_backend {
    void *state;
    bool utf8, color, hues; /* what can be shown; the last: a colour of its own for each curve */
    int click_x, click_y;
    const char *paste; /* lasts until the next key */
    int also;          /* a file whose bytes wake key() as well; -1: none */
    void (*size)(struct thud_backend *backend, int *width, int *height);
    void (*show)(struct thud_backend *backend, const struct thud_canvas *canvas);
    /* Waits at most `timeout_ms` for a key (-1: until one comes); returns at once when a signal came. */
    int (*key)(struct thud_backend *backend, int timeout_ms);
    double (*now)(struct thud_backend *backend); /* s, from any start */
    int (*signal)(struct thud_backend *backend); /* INT, TERM or HUP that came; 0: none */
    void (*repaint)(struct thud_backend *backend);
    void (*mouse)(struct thud_backend *backend, bool on);
    void (*copy)(struct thud_backend *backend, const char *text); /* to the clipboard, where the terminal lets it */
    /* What pictures it draws, as far as is known now, and the size of its screen, px. */
    enum thud_image (*image)(struct thud_backend *backend, int *width_px, int *height_px);
    void (*raw)(struct thud_backend *backend, const char *bytes, size_t n); /* beside what show() draws */
};

/* The terminal. Errors: THUD_USAGE when there is none. `close` restores it, also where called twice. */
struct thud_config;
enum thud_status thud_term_open(struct thud_backend *backend, const struct thud_config *config, struct thud_error *err);
void thud_term_close(struct thud_backend *backend);

/* A script: keys come from text with names in angle brackets (`5<Enter>`, `<C-r>`, `<A-2>`, `<Size 80x24>`,
 * `<Click 12,3>`, `<Drag 12,3>`, `<WheelUp 12,3>`: column and row from 0); time stands still unless told. */
struct thud_script {
    const char *at;
    const char *paste; /* what `<Paste>` pastes */
    int width, height;
    double now;
    double tick; /* s that pass with each look at the clock */
    int signal;
    int shows;
    char copied[8192]; /* the beginning of what was last copied */
    enum thud_image image;
    struct thud_text raw; /* all that went there; to be cleared by who has the script */
};
void thud_script_open(struct thud_backend *backend, struct thud_script *script, int width, int height, bool utf8);
