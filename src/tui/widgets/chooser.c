#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
#include "base/grow.h"
#include "tui/widgets/chooser.h"

void thud_chooser_begin(struct thud_chooser *chooser, const char *title)
{
    chooser->n = chooser->at = chooser->top = 0;
    chooser->fuzzy = false;
    snprintf(chooser->title, sizeof chooser->title, "%s", title);
    thud_line_set(&chooser->filter, "");
}

void thud_chooser_add(struct thud_chooser *chooser, const char *value, const char *fmt, ...)
{
    struct thud_choice *larger = thud_grow(chooser->choice, (size_t)chooser->n, sizeof *larger);
    if (!larger)
        return;
    chooser->choice = larger;
    struct thud_choice *choice = &larger[chooser->n++];
    snprintf(choice->value, sizeof choice->value, "%s", value);
    va_list args;
    va_start(args, fmt);
    vsnprintf(choice->text, sizeof choice->text, fmt, args);
    va_end(args);
}

void thud_list_scroll(int *at, int *top, int n, int rows)
{
    *at = *at < n ? *at : n - 1;
    *at = *at > 0 ? *at : 0;
    *top = *at < *top ? *at : rows > 0 && *at >= *top + rows ? *at - rows + 1 : *top;
}

/* Whether the letters stand in one word of the text in their order. */
static bool scattered(const char *text, const char *letters)
{
    const char *next = letters;
    for (; *text && *next; text++)
        next = *text == ' ' ? letters : next + (thud_ascii_lower(*text) == thud_ascii_lower(*next));
    return !*next;
}

/* How well a line fits: 0 where every word typed is in it; 1 where only the letters of some are, in their order, and
 * that is enough; -1: not at all. */
static int fit(const struct thud_chooser *chooser, int index)
{
    char words[THUD_LINE_MAX], *rest = words;
    int worst = 0;
    snprintf(words, sizeof words, "%s", chooser->filter.text);
    for (char *word; (word = strtok_r(rest, " ", &rest)) != NULL;) {
        const char *text = chooser->choice[index].text;
        if (thud_ascii_find(text, word))
            continue;
        if (!chooser->fuzzy || strlen(word) < 3 || !scattered(text, word))
            return -1;
        worst = 1;
    }
    return worst;
}

/* The n-th line that fits, the better ones first; -1: there are no more. */
static int fitting(const struct thud_chooser *chooser, int n)
{
    for (int how = 0; how <= chooser->fuzzy; how++)
        for (int i = 0; i < chooser->n; i++)
            if (fit(chooser, i) == how && n-- == 0)
                return i;
    return -1;
}

static int count_fitting(const struct thud_chooser *chooser)
{
    int n = 0;
    for (int i = 0; i < chooser->n; i++)
        n += fit(chooser, i) >= 0;
    return n;
}

void thud_chooser_mark(struct thud_chooser *chooser, const char *value)
{
    for (int i = 0; i < chooser->n; i++)
        if (strcmp(chooser->choice[i].value, value) == 0)
            chooser->at = i;
}

const struct thud_choice *thud_chooser_marked(const struct thud_chooser *chooser)
{
    int i = fitting(chooser, chooser->at);
    return i < 0 ? NULL : &chooser->choice[i];
}

void thud_chooser_key(struct thud_chooser *chooser, int key)
{
    int step = key == THUD_KEY_UP          ? -1
               : key == THUD_KEY_DOWN      ? 1
               : key == THUD_KEY_PAGE_UP   ? -8
               : key == THUD_KEY_PAGE_DOWN ? 8
                                           : 0;
    if (step)
        chooser->at += step;
    else if (thud_line_key(&chooser->filter, key))
        chooser->at = 0;
    thud_list_scroll(&chooser->at, &chooser->top, count_fitting(chooser), 0);
}

bool thud_chooser_click(struct thud_chooser *chooser, int x, int y)
{
    const struct thud_pane *lines = &chooser->drawn;
    int row = y - lines->y, before = chooser->at;
    if (x < lines->x || x >= lines->x + lines->w || row < 0 || row >= lines->h ||
        chooser->top + row >= count_fitting(chooser))
        return false;
    chooser->at = chooser->top + row;
    return chooser->at == before;
}

void thud_chooser_draw(struct thud_chooser *chooser, const struct thud_pane *area)
{
    int widest = 72;
    for (int i = 0; i < chooser->n; i++) {
        int n = thud_utf8_columns(chooser->choice[i].text);
        widest = n > widest ? n : widest;
    }
    int w = area->w < widest + 4 ? area->w : widest + 4, h = chooser->n + 4 < area->h ? chooser->n + 4 : area->h;
    struct thud_pane box = thud_pane_inside(area, (area->w - w) / 2, (area->h - h) / 2, w, h);
    thud_pane_blank(&box);
    struct thud_pane in = thud_pane_frame(&box, chooser->title, true);
    int at = thud_pane_put(&in, 1, 0, thud_look(THUD_ROLE_MUTED, 0), "only: ");
    int rows = in.h - 1;
    chooser->drawn = thud_pane_inside(&in, 0, 1, in.w, rows);
    thud_list_scroll(&chooser->at, &chooser->top, chooser->n, rows);
    for (int row = 1, i; row <= rows && (i = fitting(chooser, chooser->top + row - 1)) >= 0; row++) {
        bool marked = chooser->top + row - 1 == chooser->at;
        struct thud_look look = thud_look(THUD_ROLE_PLAIN, marked ? THUD_REVERSE : 0);
        thud_pane_glyph(&in, 0, row, look, marked ? 0x25b8 : ' ');
        thud_pane_put(&in, 1, row, look, chooser->choice[i].text);
    }
    if (count_fitting(chooser) == 0)
        thud_pane_put(&in, 1, 1, thud_look(THUD_ROLE_MUTED, 0), "nothing fits what was typed");
    thud_line_draw(&chooser->filter, &in, 1 + at, 0, in.w - 2 - at, thud_look(THUD_ROLE_VALUE, THUD_UNDERLINE));
}

void thud_chooser_free(struct thud_chooser *chooser)
{
    free(chooser->choice);
    chooser->choice = NULL;
    chooser->n = 0;
}
