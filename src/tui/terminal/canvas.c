#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tui/terminal/canvas.h"

static const struct thud_cell blank = {' ', {THUD_ROLE_PLAIN, 0}};

enum thud_status thud_canvas_resize(struct thud_canvas *canvas, int width, int height, struct thud_error *err)
{
    if (width < 1)
        width = 1;
    if (height < 1)
        height = 1;
    struct thud_cell *cell = malloc((size_t)width * (size_t)height * sizeof *cell);
    if (!cell)
        return thud_error_set(err, THUD_MEMORY, "no memory for a screen of %d x %d", width, height);
    free(canvas->cell);
    canvas->cell = cell;
    canvas->width = width;
    canvas->height = height;
    thud_canvas_clear(canvas);
    return THUD_OK;
}

void thud_canvas_clear(struct thud_canvas *canvas)
{
    for (int i = 0; i < canvas->width * canvas->height; i++)
        canvas->cell[i] = blank;
    canvas->cursor_x = canvas->cursor_y = -1;
}

void thud_canvas_free(struct thud_canvas *canvas)
{
    free(canvas->cell);
    canvas->cell = NULL;
    canvas->width = canvas->height = 0;
}

char *thud_canvas_text(const struct thud_canvas *canvas)
{
    char *text = malloc((size_t)canvas->height * ((size_t)canvas->width * 4 + 1) + 1);
    if (!text)
        return NULL;
    char *to = text;
    for (int y = 0; y < canvas->height; y++) {
        const struct thud_cell *row = canvas->cell + (size_t)y * (size_t)canvas->width;
        int last = canvas->width;
        while (last > 0 && row[last - 1].glyph == ' ')
            last--;
        for (int x = 0; x < last; x++) {
            char utf8[5];
            if (row[x].glyph == THUD_CELL_TAIL)
                continue;
            int n = thud_utf8_put(row[x].glyph, utf8);
            memcpy(to, utf8, (size_t)n);
            to += n;
        }
        *to++ = '\n';
    }
    *to = '\0';
    return text;
}

struct thud_pane thud_canvas_pane(struct thud_canvas *canvas)
{
    return (struct thud_pane){canvas, 0, 0, canvas->width, canvas->height, 0};
}

struct thud_pane thud_pane_inside(const struct thud_pane *pane, int x, int y, int w, int h)
{
    if (x + w > pane->w)
        w = pane->w - x;
    if (y + h > pane->h)
        h = pane->h - y;
    return (struct thud_pane){pane->canvas, pane->x + x, pane->y + y, w > 0 ? w : 0, h > 0 ? h : 0, 0};
}

/* The nearest ASCII sign, where the terminal has no more. */
static uint32_t to_ascii(uint32_t glyph)
{
    static const struct {
        uint32_t glyph;
        char ascii;
    } table[] = {
        {0x2500, '-'}, {0x2502, '|'}, {0x250c, '+'}, {0x2510, '+'}, {0x2514, '+'}, {0x2518, '+'}, {0x251c, '+'},
        {0x2524, '+'}, {0x252c, '+'}, {0x2534, '+'}, {0x253c, '+'}, {0x2550, '='}, {0x2506, ':'}, {0x25b8, '>'},
        {0x2192, '>'}, {0x2190, '<'}, {0x2191, '^'}, {0x2193, 'v'}, {0x00b7, '.'}, {0x2013, '-'}, {0x2026, '~'},
        {0x00b2, '2'}, {0x00d7, 'x'}, {0x03b4, 'd'}, {0x03b6, 'z'}, {0x03be, 'x'}, {0x03c9, 'w'}, {0x2588, '#'},
        {0x2593, '#'}, {0x2591, ':'}, {0x2592, '%'}, {0x25cf, 'o'}, {0x2264, '<'}, {0x2265, '>'}, {0x00b5, 'u'},
        {0x2714, '*'}, {0x25c6, '*'}, {0x25b2, '^'}, {0x25bc, 'v'},
    };
    if (glyph < 0x80)
        return glyph;
    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
        if (table[i].glyph == glyph)
            return (uint32_t)(unsigned char)table[i].ascii;
    return '?';
}

static bool shown(uint32_t c)
{
    return !(c < 0x20 || (c >= 0x7f && c < 0xa0) || c == 0xad || (c >= 0xd800 && c <= 0xf8ff) || c > 0x3ffff ||
             (c >= 0x2028 && c <= 0x202e));
}

/* A cell is written; of a sign two columns wide that it was half of, the other half goes. */
static void write_cell(struct thud_canvas *canvas, int x, int y, struct thud_cell cell)
{
    struct thud_cell *row = canvas->cell + (size_t)y * (size_t)canvas->width;
    if (row[x].glyph == THUD_CELL_TAIL && x > 0 && cell.glyph != THUD_CELL_TAIL)
        row[x - 1].glyph = ' ';
    if (x + 1 < canvas->width && row[x + 1].glyph == THUD_CELL_TAIL)
        row[x + 1].glyph = ' ';
    row[x] = cell;
}

void thud_pane_glyph(const struct thud_pane *pane, int x, int y, struct thud_look style, uint32_t glyph)
{
    int width = shown(glyph) ? thud_utf8_width(glyph) : 1;
    y -= pane->scroll;
    if (x < 0 || y < 0 || x >= pane->w || y >= pane->h || width == 0)
        return;
    bool cut = x + width > pane->w;
    x += pane->x;
    y += pane->y;
    struct thud_canvas *canvas = pane->canvas;
    if (x < 0 || y < 0 || x >= canvas->width || y >= canvas->height)
        return;
    if (!shown(glyph) || cut || x + width > canvas->width || (canvas->ascii && width > 1))
        glyph = '?';
    if (canvas->ascii)
        glyph = to_ascii(glyph);
    write_cell(canvas, x, y, (struct thud_cell){glyph, style});
    if (width > 1 && !cut && x + 1 < canvas->width)
        write_cell(canvas, x + 1, y, (struct thud_cell){glyph == '?' ? ' ' : THUD_CELL_TAIL, style});
}

int thud_pane_put(const struct thud_pane *pane, int x, int y, struct thud_look style, const char *text)
{
    int start = x;
    for (uint32_t c; (c = thud_utf8_next(&text)) != 0;) {
        thud_pane_glyph(pane, x, y, style, c);
        x += shown(c) ? thud_utf8_width(c) : 1;
    }
    return x - start;
}

int thud_pane_print(const struct thud_pane *pane, int x, int y, struct thud_look style, const char *fmt, ...)
{
    char text[1024];
    va_list args;
    va_start(args, fmt);
    vsnprintf(text, sizeof text, fmt, args);
    va_end(args);
    return thud_pane_put(pane, x, y, style, text);
}

void thud_pane_right(const struct thud_pane *pane, int x, int y, struct thud_look style, const char *text)
{
    thud_pane_put(pane, x - thud_utf8_columns(text), y, style, text);
}

void thud_pane_blank(const struct thud_pane *pane)
{
    for (int y = 0; y < pane->h; y++)
        for (int x = 0; x < pane->w; x++)
            thud_pane_glyph(pane, x, y + pane->scroll, thud_look(THUD_ROLE_PLAIN, 0), ' ');
}

bool thud_pane_is_free(const struct thud_pane *pane, int x, int y, int w)
{
    for (int i = 0; i < w; i++)
        if (pane->canvas->cell[(pane->y + y) * pane->canvas->width + pane->x + x + i].glyph != ' ')
            return false;
    return true;
}

struct thud_pane thud_pane_frame(const struct thud_pane *pane, const char *title, bool focused)
{
    struct thud_look line = thud_look(THUD_ROLE_BORDER, focused ? THUD_BOLD : 0);
    int right = pane->w - 1, bottom = pane->h - 1;
    for (int x = 1; x < right; x++) {
        thud_pane_glyph(pane, x, 0, line, 0x2500);
        thud_pane_glyph(pane, x, bottom, line, 0x2500);
    }
    for (int y = 1; y < bottom; y++) {
        thud_pane_glyph(pane, 0, y, line, 0x2502);
        thud_pane_glyph(pane, right, y, line, 0x2502);
    }
    thud_pane_glyph(pane, 0, 0, line, 0x250c);
    thud_pane_glyph(pane, right, 0, line, 0x2510);
    thud_pane_glyph(pane, 0, bottom, line, 0x2514);
    thud_pane_glyph(pane, right, bottom, line, 0x2518);
    struct thud_pane top = thud_pane_inside(pane, 1, 0, pane->w - 2, 1);
    struct thud_look heading = thud_look(THUD_ROLE_TITLE, focused ? THUD_BOLD | THUD_REVERSE : THUD_BOLD);
    char fitted[256];
    if (title && *title)
        thud_pane_print(&top, 0, 0, heading, " %s ", thud_utf8_fit(title, top.w - 2, fitted, sizeof fitted));
    return thud_pane_inside(pane, 1, 1, pane->w - 2, pane->h - 2);
}

int thud_pane_wrap(const struct thud_pane *pane, int x, int y, int w, struct thud_look style, const char *text)
{
    int row = 0;
    while (*text && w > 0) {
        const char *end = text, *cut = NULL;
        int columns = 0;
        while (*end && *end != '\n' && columns < w) {
            if (*end == ' ')
                cut = end;
            columns += thud_utf8_width(thud_utf8_next(&end));
        }
        if (*end && *end != '\n' && *end != ' ' && cut)
            end = cut;
        char line[1024];
        int size = (int)(end - text) < (int)sizeof line ? (int)(end - text) : (int)sizeof line - 1;
        memcpy(line, text, (size_t)size);
        line[size] = '\0';
        thud_pane_put(pane, x, y + row++, style, line);
        text = *end ? end + (*end == ' ' || *end == '\n') : end;
    }
    return row;
}
