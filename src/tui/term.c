/* The terminal: the one file that knows ncurses, and the one place that opens and restores it. */
#define _XOPEN_SOURCE          700
#define _XOPEN_SOURCE_EXTENDED 1
#include <errno.h>
#include <langinfo.h>
#include <locale.h>
#include <poll.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>
#include <wchar.h>

#include <curses.h>

#include "tui/backend.h"
#include "tui/term_signal.h"

struct term {
    bool open, repaint;
    int pending; /* a key read ahead; 0: none */
};
static struct term the_terminal; /* there is one per process, as in curses itself */

static bool can_move(const char *term)
{
    return term && *term && strcmp(term, "dumb") != 0 && strcmp(term, "unknown") != 0;
}

static void color_pairs(void)
{
    static const struct {
        int role;
        short color;
    } table[] = {
        {THUD_ROLE_TITLE, COLOR_CYAN},         {THUD_ROLE_VALUE, COLOR_CYAN},      {THUD_ROLE_GOOD, COLOR_GREEN},
        {THUD_ROLE_WARN, COLOR_YELLOW},        {THUD_ROLE_ERROR, COLOR_RED},       {THUD_ROLE_KEY, COLOR_YELLOW},
        {THUD_ROLE_SERIES, COLOR_BLUE},        {THUD_ROLE_SERIES + 1, COLOR_RED},  {THUD_ROLE_SERIES + 2, COLOR_GREEN},
        {THUD_ROLE_SERIES + 3, COLOR_MAGENTA}, {THUD_ROLE_SERIES + 4, COLOR_CYAN}, {THUD_ROLE_SERIES + 5, COLOR_YELLOW},
        {THUD_ROLE_SERIES + 6, COLOR_WHITE},   {THUD_ROLE_SERIES + 7, COLOR_BLUE},
    };
    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
        init_pair((short)table[i].role, table[i].color, -1);
}

static void term_size(struct thud_backend *backend, int *width, int *height)
{
    (void)backend;
    getmaxyx(stdscr, *height, *width);
}

static attr_t attributes(struct thud_look style)
{
    attr_t attr = 0;
    if (style.attr & THUD_BOLD)
        attr |= A_BOLD;
    if (style.attr & THUD_REVERSE)
        attr |= A_REVERSE;
    if (style.attr & THUD_UNDERLINE)
        attr |= A_UNDERLINE;
    return attr;
}

static void term_show(struct thud_backend *backend, const struct thud_canvas *canvas)
{
    struct term *term = backend->state;
    int rows, columns;
    getmaxyx(stdscr, rows, columns);
    for (int y = 0; y < canvas->height && y < rows; y++)
        for (int x = 0; x < canvas->width && x < columns; x++) {
            const struct thud_cell *cell = &canvas->cell[(size_t)y * (size_t)canvas->width + (size_t)x];
            const wchar_t glyph[2] = {(wchar_t)cell->glyph, 0};
            cchar_t out;
            setcchar(&out, glyph, attributes(cell->style), backend->color ? (short)cell->style.role : 0, NULL);
            /* writing the last cell may report an error because the cursor cannot go on; the cell is there */
            (void)mvadd_wch(y, x, &out);
        }
    bool cursor = canvas->cursor_x >= 0 && canvas->cursor_x < columns && canvas->cursor_y < rows;
    curs_set(cursor ? 1 : 0);
    move(cursor ? canvas->cursor_y : rows - 1, cursor ? canvas->cursor_x : columns - 1);
    if (term->repaint)
        clearok(stdscr, TRUE);
    term->repaint = false;
    refresh();
}

static int translate_key(wint_t code)
{
    switch (code) {
    case KEY_UP:
        return THUD_KEY_UP;
    case KEY_DOWN:
        return THUD_KEY_DOWN;
    case KEY_LEFT:
        return THUD_KEY_LEFT;
    case KEY_RIGHT:
        return THUD_KEY_RIGHT;
    case KEY_HOME:
        return THUD_KEY_HOME;
    case KEY_END:
        return THUD_KEY_END;
    case KEY_PPAGE:
        return THUD_KEY_PAGE_UP;
    case KEY_NPAGE:
        return THUD_KEY_PAGE_DOWN;
    case KEY_DC:
        return THUD_KEY_DELETE;
    case KEY_BACKSPACE:
        return THUD_KEY_BACKSPACE;
    case KEY_BTAB:
        return THUD_KEY_BACKTAB;
    case KEY_ENTER:
        return THUD_KEY_ENTER;
    case KEY_F(1):
        return THUD_KEY_F1;
    case KEY_F(2):
        return THUD_KEY_F2;
    case KEY_RESIZE:
        return THUD_KEY_RESIZE;
    default:
        return THUD_KEY_NONE;
    }
}

static int click(struct thud_backend *backend)
{
    MEVENT event;
    if (getmouse(&event) != OK || !(event.bstate & (BUTTON1_CLICKED | BUTTON1_PRESSED)))
        return THUD_KEY_NONE;
    backend->click_x = event.x;
    backend->click_y = event.y;
    return THUD_KEY_CLICK;
}

/* One key without waiting: -1 when there is none. */
static int take_key(struct thud_backend *backend)
{
    wint_t code;
    int kind = get_wch(&code);
    if (kind == ERR)
        return -1;
    if (kind == KEY_CODE_YES)
        return code == KEY_MOUSE ? click(backend) : translate_key(code);
    if (code == 8)
        return THUD_KEY_BACKSPACE;
    if (code == '\n' || code == '\r')
        return THUD_KEY_ENTER;
    return (int)code;
}

/* ESC with a key right behind it is Alt and that key; where that means nothing it is taken apart again by the caller.
 */
static int take_with_alt(struct thud_backend *backend)
{
    struct term *term = backend->state;
    if (term->pending) {
        int key = term->pending;
        term->pending = 0;
        return key;
    }
    int key = take_key(backend);
    if (key != THUD_KEY_ESC)
        return key;
    int next = take_key(backend);
    if (next < 0)
        return key;
    if (next >= '0' && next <= '9')
        return THUD_KEY_ALT + next;
    term->pending = next;
    return key;
}

static int term_key(struct thud_backend *backend, int timeout_ms)
{
    if (thud_term_signal_suspend())
        return THUD_KEY_RESIZE; /* back again: everything is drawn anew */
    int key = take_with_alt(backend);
    if (key >= 0)
        return key;
    struct pollfd wait[3] = {{STDIN_FILENO, POLLIN, 0}, {thud_term_signal_fd(), POLLIN, 0}, {backend->also, POLLIN, 0}};
    int ready = poll(wait, 3, timeout_ms);
    thud_term_signal_drain();
    if (ready > 0 && (wait[0].revents & (POLLHUP | POLLERR | POLLNVAL)) && !(wait[0].revents & POLLIN))
        return THUD_KEY_HANGUP;
    key = take_with_alt(backend);
    if (key >= 0)
        return key;
    /* readable without a key in it, twice running, is the end of the input */
    char byte;
    if (ready > 0 && (wait[0].revents & POLLIN) && poll(wait, 1, 0) > 0 && read(STDIN_FILENO, &byte, 1) == 0)
        return THUD_KEY_HANGUP;
    return THUD_KEY_NONE;
}

static double term_now(struct thud_backend *backend)
{
    (void)backend;
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static int term_signal(struct thud_backend *backend)
{
    (void)backend;
    return thud_term_signal_fatal();
}

static void term_repaint(struct thud_backend *backend)
{
    ((struct term *)backend->state)->repaint = true;
}

static void term_mouse(struct thud_backend *backend, bool on)
{
    (void)backend;
    mousemask(on ? BUTTON1_CLICKED | BUTTON1_PRESSED : 0, NULL);
}

enum thud_status thud_term_open(struct thud_backend *backend, bool ascii, bool color, struct thud_error *err)
{
    const char *name = getenv("TERM");
    if (!isatty(STDIN_FILENO) || !isatty(STDOUT_FILENO))
        return thud_error_set(err, THUD_USAGE,
                              "no terminal: the screens need one; `thud help` lists what works without");
    if (!can_move(name))
        return thud_error_set(err, THUD_USAGE, "TERM is \"%s\": the screens need a terminal with a movable cursor",
                              name ? name : "");
    setlocale(LC_CTYPE, "");
    bool utf8 = strcmp(nl_langinfo(CODESET), "UTF-8") == 0 && strcmp(name, "linux") != 0;
    thud_term_signal_open();
    SCREEN *screen = newterm(NULL, stdout, stdin);
    if (!screen) {
        thud_term_signal_close();
        return thud_error_set(err, THUD_USAGE, "TERM is \"%s\", which this machine does not know", name);
    }
    the_terminal = (struct term){.open = true};
    set_escdelay(25);
    cbreak();
    noecho();
    nonl();
    intrflush(stdscr, FALSE);
    keypad(stdscr, TRUE);
    nodelay(stdscr, TRUE);
    mouseinterval(0);
    const char *no_color = getenv("NO_COLOR");
    if (no_color && *no_color)
        color = false;
    if (color && has_colors() && start_color() == OK && use_default_colors() == OK)
        color_pairs();
    else
        color = false;
    thud_term_signal_ready();
    *backend = (struct thud_backend){.state = &the_terminal,
                                     .utf8 = utf8 && !ascii,
                                     .color = color,
                                     .also = -1,
                                     .size = term_size,
                                     .show = term_show,
                                     .key = term_key,
                                     .now = term_now,
                                     .signal = term_signal,
                                     .repaint = term_repaint,
                                     .mouse = term_mouse};
    return THUD_OK;
}

void thud_term_close(struct thud_backend *backend)
{
    if (!the_terminal.open)
        return;
    the_terminal.open = false;
    term_mouse(backend, false);
    endwin();
    thud_term_signal_close();
}
