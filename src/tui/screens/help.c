/* Help: keys, fields, the model in short; scrolls, and can be searched. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tui/screens/help_text.h"

struct thud_help_state {
    struct thud_help_text text;
    int of; /* what the text was made for */
    int columns;
    char word[96]; /* what is searched for; empty: nothing */
    int at;        /* the line of the last match; -1: none */
};

static struct thud_help_state *state(const struct thud_tui *tui)
{
    return tui->own[THUD_SCREEN_HELP];
}

static void begin(struct thud_tui *tui)
{
    state(tui)->at = -1;
}

static int layout(struct thud_tui *tui, struct thud_rect area, struct thud_rect *pane)
{
    (void)tui;
    pane[0] = area;
    return 1;
}

static void pane_title(struct thud_tui *tui, int index, char *text, size_t size)
{
    const struct thud_help_state *help = state(tui);
    (void)index;
    snprintf(text, size, "Help for %s", tui->view[tui->before]->title);
    if (*help->word)
        thud_append(text, size, ", \"%.40s\"%s", help->word, help->at < 0 ? " not found" : "");
}

/* A line with every match marked, the one gone to in another way than the rest. */
static void draw_line(const struct thud_pane *pane, int y, const struct thud_help_line *line, const char *word,
                      bool here)
{
    int role = line->kind == THUD_HELP_HEAD ? THUD_ROLE_TITLE : THUD_ROLE_PLAIN;
    thud_pane_put(pane, 0, y, thud_look(role, line->kind == THUD_HELP_HEAD ? THUD_BOLD : 0), line->text);
    if (line->key > 0) {
        int n = 0;
        for (const char *at = line->text; n < line->key && *at; n++)
            thud_utf8_next(&at);
        thud_pane_print(pane, 0, y, thud_look(THUD_ROLE_KEY, THUD_BOLD), "%.*s", n, line->text);
    }
    for (int at = 0; *word && (at = thud_help_line_find(line, word, at)) >= 0; at++) {
        char before[sizeof line->text], match[96];
        snprintf(before, sizeof before, "%.*s", at, line->text);
        snprintf(match, sizeof match, "%.*s", (int)strlen(word), line->text + at);
        thud_pane_put(pane, thud_utf8_columns(before), y,
                      thud_look(THUD_ROLE_WARN, here ? THUD_REVERSE | THUD_BOLD : THUD_UNDERLINE | THUD_BOLD), match);
    }
    if (here)
        thud_pane_glyph(pane, 0, y, thud_look(THUD_ROLE_KEY, THUD_BOLD), 0x25b8);
}

static void make(struct thud_tui *tui, int columns)
{
    struct thud_help_state *help = state(tui);
    if (help->text.n > 0 && help->of == tui->before && help->columns == columns)
        return;
    thud_help_text_make(&help->text, tui, tui->before, columns - 1);
    help->of = tui->before;
    help->columns = columns;
    help->at = *help->word ? thud_help_text_find(&help->text, help->word, 0, 1) : -1;
}

static int draw(struct thud_tui *tui, int index, struct thud_pane *pane)
{
    struct thud_help_state *help = state(tui);
    (void)index;
    make(tui, pane->w);
    for (int i = 0; i < help->text.n; i++)
        draw_line(pane, i, &help->text.line[i], help->word, i == help->at);
    return help->text.n;
}

/* To a match, with a line or two before it. */
static void go_to(struct thud_tui *tui, int line)
{
    int *scroll = &tui->form.scroll[THUD_SCREEN_HELP][0], height = tui->form.height[0];
    state(tui)->at = line;
    if (line < *scroll || line >= *scroll + height)
        *scroll = line - (height > 6 ? 2 : 0);
}

static void typed(struct thud_tui *tui, const char *text)
{
    struct thud_help_state *help = state(tui);
    snprintf(help->word, sizeof help->word, "%.90s", text);
    help->at = -1;
    int line = *text ? thud_help_text_find(&help->text, help->word, tui->form.scroll[THUD_SCREEN_HELP][0], 1) : -1;
    if (line >= 0)
        go_to(tui, line);
    else if (*text)
        thud_tui_say(tui, THUD_ROLE_WARN, "\"%s\" is nowhere in the help", help->word);
}

/* Its heads and names; the rest is found by its search. */
static void offer(struct thud_tui *tui)
{
    struct thud_help_text text = {0};
    thud_help_text_make(&text, tui, tui->screen, THUD_HELP_COLUMNS);
    for (int i = 0; i < text.n; i++) {
        char command[128];
        const char *words = text.line[i].text + strspn(text.line[i].text, " ");
        snprintf(command, sizeof command, "search %.60s", words);
        if (text.line[i].kind != THUD_HELP_PLAIN)
            thud_tui_offer(tui, THUD_SCREEN_HELP, command, "help %s", words);
    }
    thud_help_text_clear(&text);
}

static void command(struct thud_tui *tui, const char *word, const char *rest)
{
    (void)word;
    make(tui, tui->canvas.width - 2);
    typed(tui, rest);
}

static enum thud_reaction act(struct thud_tui *tui, enum thud_action action)
{
    static const struct thud_prompt prompt = {.words = "search: ", .done = typed};
    struct thud_help_state *help = state(tui);
    int step = action == THUD_DO_NEXT_MATCH ? 1 : -1;
    switch (action) {
    case THUD_DO_SEARCH:
        thud_tui_prompt(tui, &prompt, "");
        return THUD_DONE;
    case THUD_DO_NEXT_MATCH:
    case THUD_DO_PREVIOUS_MATCH:
        go_to(tui, thud_help_text_find(&help->text, help->word, help->at + step, step));
        return THUD_DONE;
    case THUD_DO_QUIT:
    case THUD_DO_BACK:
        return *tui->said.text && action == THUD_DO_BACK ? THUD_NOT_MINE : THUD_LEAVE;
    default:
        return THUD_NOT_MINE;
    }
}

static const char *cannot(struct thud_tui *tui, enum thud_action action)
{
    if (action == THUD_DO_NEXT_MATCH || action == THUD_DO_PREVIOUS_MATCH)
        return state(tui)->at >= 0 ? NULL : "Nothing is searched for: / asks";
    return NULL;
}

static void release(struct thud_tui *tui)
{
    thud_help_text_clear(&state(tui)->text);
}

THUD_VIEW(help, "Help", HELP, .size = sizeof(struct thud_help_state), .begin = begin, .free = release, .offer = offer,
          .command = command, .act = act, .cannot = cannot);
