/* The terminal: the one file that knows ncurses, and the one place that opens and restores it. */
#define _XOPEN_SOURCE          700
#define _XOPEN_SOURCE_EXTENDED 1
#include <errno.h>
#include <fcntl.h>
#include <langinfo.h>
#include <locale.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>
#include <wchar.h>

#include <curses.h>

#include "tui/terminal/backend.h"
#include "tui/terminal/config.h"
#include "tui/terminal/decode.h"
#include "tui/terminal/term_signal.h"

/* The bytes of one key come together: what begins like one and stays alone for so long is not the beginning of one. */
enum { ESCAPE_MS = 25 };

struct term {
    bool open, repaint, mouse;
    struct thud_decode decode;
    double read_s; /* when bytes were last read */
    enum thud_theme theme;
    enum thud_image image;
    bool asked; /* what it can */
    double asked_s;
};
static struct term the_terminal; /* there is one per process, as in curses itself */

static bool can_move(const char *term)
{
    return term && *term && strcmp(term, "dumb") != 0 && strcmp(term, "unknown") != 0;
}

static void color_pairs(void)
{
    for (int role = 1; role < THUD_ROLES; role++)
        init_pair((short)role, (short)thud_role_color(the_terminal.theme, role, COLORS), -1);
}

static void term_size(struct thud_backend *backend, int *width, int *height)
{
    (void)backend;
    getmaxyx(stdscr, *height, *width);
}

static attr_t attributes(struct thud_look style, bool color)
{
    attr_t attr = 0;
    if ((style.attr & THUD_BOLD) || (color && thud_role_bold(the_terminal.theme, style.role, COLORS)))
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
            if (cell->glyph == THUD_CELL_TAIL)
                continue;
            const wchar_t glyph[2] = {(wchar_t)cell->glyph, 0};
            cchar_t out;
            setcchar(&out, glyph, attributes(cell->style, backend->color), backend->color ? (short)cell->style.role : 0,
                     NULL);
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

static double term_now(struct thud_backend *backend)
{
    (void)backend;
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* What goes to the terminal beside ncurses' own drawing. */
static void tell(const char *text)
{
    fputs(text, stdout);
    fflush(stdout);
}

/* Bytes that are there; false at the end of the input. */
static bool read_bytes(struct term *term)
{
    char bytes[512];
    size_t room = thud_decode_room(&term->decode);
    if (room == 0)
        return true;
    ssize_t n = read(STDIN_FILENO, bytes, room < sizeof bytes ? room : sizeof bytes);
    if (n > 0)
        thud_decode_add(&term->decode, bytes, (size_t)n);
    return n != 0 && !(n < 0 && errno == EIO);
}

/* ncurses draws, and so has to know how large the terminal is; keys it does not read. */
static bool resized(void)
{
    struct winsize size;
    if (!thud_term_signal_resized() || ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_row == 0 ||
        size.ws_col == 0)
        return false;
    resizeterm(size.ws_row, size.ws_col);
    return true;
}

/* A key among the bytes read so far. */
static int take_key(struct thud_backend *backend, bool ended, bool *more)
{
    struct term *term = backend->state;
    int key = thud_decode_next(&term->decode, ended, more);
    backend->click_x = term->decode.mouse_x;
    backend->click_y = term->decode.mouse_y;
    backend->paste = term->decode.paste;
    return key;
}

static int term_key(struct thud_backend *backend, int timeout_ms)
{
    struct term *term = backend->state;
    bool more, suspended = thud_term_signal_suspend();
    if (suspended)
        tell(term->mouse ? THUD_PASTE_ON THUD_MOUSE_ON : THUD_PASTE_ON);
    if (resized() || suspended)
        return THUD_KEY_RESIZE; /* also when it goes on after a stop: everything is redrawn */
    int key = take_key(backend, false, &more);
    if (key != THUD_KEY_NONE)
        return key;
    struct pollfd wait[3] = {{STDIN_FILENO, POLLIN, 0}, {thud_term_signal_fd(), POLLIN, 0}, {backend->also, POLLIN, 0}};
    bool begun = more && (timeout_ms < 0 || timeout_ms > ESCAPE_MS);
    int ready = poll(wait, 3, begun ? ESCAPE_MS : timeout_ms);
    thud_term_signal_drain();
    if (ready > 0 && (wait[0].revents & POLLIN)) {
        if (!read_bytes(term))
            return THUD_KEY_HANGUP;
        term->read_s = term_now(backend);
    } else if (ready > 0 && (wait[0].revents & (POLLHUP | POLLERR | POLLNVAL))) {
        return THUD_KEY_HANGUP;
    }
    key = take_key(backend, false, &more);
    if (key == THUD_KEY_NONE && more && 1e3 * (term_now(backend) - term->read_s) >= ESCAPE_MS)
        key = take_key(backend, true, &more);
    return key;
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

/* Clicks and the wheel, in decimal numbers where the terminal can. */
static void term_mouse(struct thud_backend *backend, bool on)
{
    ((struct term *)backend->state)->mouse = on;
    tell(on ? THUD_MOUSE_ON : THUD_MOUSE_OFF);
}

/* OSC 52 with base64, which xterm, tmux, kitty, foot, iTerm2 and others take; the rest drop it. */
static void term_copy(struct thud_backend *backend, const char *text)
{
    struct thud_text out = {0};
    (void)backend;
    thud_text_append(&out, "\033]52;c;");
    thud_text_base64(&out, text, strlen(text));
    thud_text_append(&out, "\a");
    if (!out.failed)
        tell(out.data);
    thud_text_clear(&out);
}

static void term_raw(struct thud_backend *backend, const char *bytes, size_t n)
{
    (void)backend;
    fwrite(bytes, 1, n, stdout);
    fflush(stdout);
}

/* Where the terminal does not say how large it is, cells of 8 x 16 px: a picture that is too small does no harm. */
static enum thud_image term_image(struct thud_backend *backend, int *width_px, int *height_px)
{
    const struct term *term = backend->state;
    struct winsize size = {0};
    ioctl(STDOUT_FILENO, TIOCGWINSZ, &size);
    *width_px = size.ws_xpixel > 0 ? size.ws_xpixel : 8 * COLS;
    *height_px = size.ws_ypixel > 0 ? size.ws_ypixel : 16 * LINES;
    return term->asked && term->decode.sixel ? THUD_IMAGE_SIXEL : term->image;
}

/* An answer that comes after the end would be taken for typing by the shell. */
static void wait_for_answer(struct term *term)
{
    enum { PATIENCE_MS = 100 };
    static const double late_s = 2.0; /* what has not answered by then does not */
    struct pollfd input = {STDIN_FILENO, POLLIN, 0};
    bool wait = term->asked && term_now(NULL) - term->asked_s < late_s;
    for (bool more; wait && !term->decode.attributes && poll(&input, 1, PATIENCE_MS) > 0;) {
        if (!(input.revents & POLLIN) || !read_bytes(term))
            return;
        while (thud_decode_next(&term->decode, false, &more) != THUD_KEY_NONE)
            ;
    }
}

/* What it is known to draw; what is not known it is asked for. */
static void learn_images(struct term *term, enum thud_image_choice choice, const char *name)
{
    const struct thud_image_variables of = {name, getenv("KITTY_WINDOW_ID"), getenv("TMUX"), getenv("STY")};
    term->image = thud_image_known(choice, &of, &term->asked);
    term->asked_s = term_now(NULL);
    if (term->asked)
        tell(thud_image_question);
}

/* The keys as this terminal's description has them. */
static void learn_keys(struct thud_decode *decode)
{
    static const struct {
        const char *capability;
        int key;
    } table[] = {{"kcuu1", THUD_KEY_UP},     {"kcud1", THUD_KEY_DOWN},    {"kcub1", THUD_KEY_LEFT},
                 {"kcuf1", THUD_KEY_RIGHT},  {"khome", THUD_KEY_HOME},    {"kend", THUD_KEY_END},
                 {"kpp", THUD_KEY_PAGE_UP},  {"knp", THUD_KEY_PAGE_DOWN}, {"kdch1", THUD_KEY_DELETE},
                 {"kcbt", THUD_KEY_BACKTAB}, {"kf1", THUD_KEY_F1},        {"kf2", THUD_KEY_F2}};
    thud_decode_init(decode);
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        const char *sequence = tigetstr(table[i].capability);
        if (sequence && sequence != (const char *)-1)
            thud_decode_learn(decode, sequence, table[i].key);
    }
}

/* Ctrl-C is a key here, so that it can ask about what is unsaved; Ctrl-Z and Ctrl-\ stay the terminal's own. */
static void take_interrupt_key(void)
{
    struct termios mode;
    if (tcgetattr(STDIN_FILENO, &mode) != 0)
        return;
    mode.c_cc[VINTR] = (cc_t)fpathconf(STDIN_FILENO, _PC_VDISABLE);
    tcsetattr(STDIN_FILENO, TCSANOW, &mode);
    def_prog_mode();
}

enum thud_status thud_term_open(struct thud_backend *backend, const struct thud_config *config, struct thud_error *err)
{
    const char *name = getenv("TERM"), *no_color = getenv("NO_COLOR");
    bool color = config->color && config->theme != THUD_THEME_MONO && !(no_color && *no_color);
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
    the_terminal = (struct term){.open = true, .theme = config->theme};
    cbreak();
    noecho();
    nonl();
    intrflush(stdscr, FALSE);
    keypad(stdscr, TRUE);
    typeahead(-1);
    take_interrupt_key();
    learn_keys(&the_terminal.decode);
    if (color && has_colors() && start_color() == OK && use_default_colors() == OK)
        color_pairs();
    else
        color = false;
    thud_term_signal_ready();
    tell(THUD_PASTE_ON);
    learn_images(&the_terminal, config->images, name);
    *backend = (struct thud_backend){.state = &the_terminal,
                                     .utf8 = utf8 && !config->ascii,
                                     .color = color,
                                     .hues = color && COLORS >= 256 && config->theme != THUD_THEME_16,
                                     .also = -1,
                                     .size = term_size,
                                     .show = term_show,
                                     .key = term_key,
                                     .now = term_now,
                                     .signal = term_signal,
                                     .repaint = term_repaint,
                                     .mouse = term_mouse,
                                     .copy = term_copy,
                                     .image = term_image,
                                     .raw = term_raw};
    return THUD_OK;
}

void thud_term_close(struct thud_backend *backend)
{
    if (!the_terminal.open)
        return;
    the_terminal.open = false;
    (void)backend;
    tell(THUD_MOUSE_OFF THUD_PASTE_OFF);
    wait_for_answer(&the_terminal);
    endwin();
    thud_term_signal_close();
}
