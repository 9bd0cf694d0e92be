#include <stdio.h>
#include <string.h>

#include "tui/widgets/line.h"

void thud_line_set(struct thud_line *line, const char *text)
{
    snprintf(line->text, sizeof line->text, "%s", text);
    line->cursor = (int)strlen(line->text);
    line->selected = false;
}

void thud_line_select(struct thud_line *line, const char *text)
{
    thud_line_set(line, text);
    line->selected = *line->text != '\0';
}

static bool continuation(char c)
{
    return ((unsigned char)c & 0xc0) == 0x80;
}

static int before(const struct thud_line *line, int at)
{
    while (--at > 0)
        if (!continuation(line->text[at]))
            return at;
    return 0;
}

static int after(const struct thud_line *line, int at)
{
    if (!line->text[at])
        return at;
    do
        at++;
    while (continuation(line->text[at]));
    return at;
}

static void cut(struct thud_line *line, int from, int to)
{
    memmove(line->text + from, line->text + to, strlen(line->text + to) + 1);
    line->cursor = from;
}

static bool insert(struct thud_line *line, int key)
{
    if (line->selected)
        thud_line_set(line, "");
    char utf8[5];
    int n = thud_utf8_put((uint32_t)key, utf8);
    size_t size = strlen(line->text);
    if (size + (size_t)n >= sizeof line->text)
        return true;
    char *at = line->text + line->cursor;
    memmove(at + n, at, size - (size_t)line->cursor + 1);
    memcpy(at, utf8, (size_t)n);
    line->cursor += n;
    return true;
}

void thud_line_type(struct thud_line *line, const char *text)
{
    for (uint32_t c; (c = thud_utf8_next(&text)) >= ' ';)
        if (c != THUD_KEY_BACKSPACE)
            insert(line, (int)c);
}

static bool edit(struct thud_line *line, int key)
{
    switch (key) {
    case THUD_KEY_LEFT:
        line->cursor = before(line, line->cursor);
        return true;
    case THUD_KEY_RIGHT:
        line->cursor = after(line, line->cursor);
        return true;
    case THUD_KEY_HOME:
    case THUD_CTRL('a'):
        line->cursor = 0;
        return true;
    case THUD_KEY_END:
    case THUD_CTRL('e'):
        line->cursor = (int)strlen(line->text);
        return true;
    case THUD_KEY_BACKSPACE:
        cut(line, before(line, line->cursor), line->cursor);
        return true;
    case THUD_KEY_DELETE:
        cut(line, line->cursor, after(line, line->cursor));
        return true;
    case THUD_CTRL('u'):
        thud_line_set(line, "");
        return true;
    default:
        return key >= ' ' && key != THUD_KEY_BACKSPACE && key < 0x110000 ? insert(line, key) : false;
    }
}

bool thud_line_key(struct thud_line *line, int key)
{
    bool selected = line->selected, deletes = key == THUD_KEY_BACKSPACE || key == THUD_KEY_DELETE;
    if (selected && deletes) {
        thud_line_set(line, "");
        return true;
    }
    if (selected && key == ' ') { /* it would leave nothing but itself */
        line->selected = false;
        return true;
    }
    if (!edit(line, key))
        return false;
    line->selected = false;
    return true;
}

void thud_line_draw(const struct thud_line *line, const struct thud_pane *pane, int x, int y, int w,
                    struct thud_look style)
{
    if (w < 1)
        return;
    char head[THUD_LINE_MAX];
    snprintf(head, sizeof head, "%.*s", line->cursor, line->text);
    int at = thud_utf8_columns(head), first = 0;
    const char *text = line->text;
    while (at - first >= w)
        first += thud_utf8_width(thud_utf8_next(&text));
    for (int i = 0; i < w;) {
        uint32_t c = thud_utf8_next(&text);
        struct thud_look look = thud_look(style.role, c && line->selected ? style.attr | THUD_REVERSE : style.attr);
        thud_pane_glyph(pane, x + i, y, look, c ? c : ' ');
        i += c ? thud_utf8_width(c) : 1;
    }
    int row = y - pane->scroll;
    if (x + at - first >= pane->w || row < 0 || row >= pane->h)
        return;
    pane->canvas->cursor_x = pane->x + x + at - first;
    pane->canvas->cursor_y = pane->y + row;
}
