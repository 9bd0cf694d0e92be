#include "tui/document/form_over.h"

#include <stdio.h>
#include <string.h>

#include "base/ascii.h"
#include "base/utf8.h"

enum { LABEL = 22, VALUE = 24, LEAST_HELP = 3 };

static struct thud_over_row *here(struct thud_form_over *form)
{
    return &form->row[form->at];
}

static struct thud_line *line_here(struct thud_form_over *form)
{
    return &here(form)->value[form->side];
}

static bool applies(const struct thud_form_over *form, int row, int side)
{
    return (side == 0 || form->row[row].two) && (!form->applies || form->applies(form, row, side));
}

struct thud_over_row *thud_form_over_add(struct thud_form_over *form, const char *label, const char *help,
                                         const char *value)
{
    struct thud_over_row *row = &form->row[form->n < THUD_OVER_ROWS ? form->n++ : THUD_OVER_ROWS - 1];
    *row = (struct thud_over_row){.help = help};
    snprintf(row->label, sizeof row->label, "%s", label);
    thud_line_set(&row->value[0], value);
    thud_line_set(&row->value[1], value);
    return row;
}

void thud_form_over_focus(struct thud_form_over *form, int row, int side)
{
    if (form->left && strcmp(line_here(form)->text, form->was) != 0)
        form->left(form);
    form->at = row;
    form->side = side;
    form->prefix[0] = '\0';
    struct thud_line *line = line_here(form);
    line->cursor = (int)strlen(line->text);
    line->selected = *line->text != '\0';
    snprintf(form->was, sizeof form->was, "%s", line->text);
}

/* The next value in a direction that there is. */
static void go(struct thud_form_over *form, int rows, int sides)
{
    int at = 2 * form->at + form->side;
    for (int i = 0; i < 2 * form->n; i++) {
        at = (at + 2 * rows + sides + 2 * form->n) % (2 * form->n);
        int row = at / 2, side = rows != 0 && !form->row[at / 2].two ? 0 : at % 2;
        if (applies(form, row, side)) {
            thud_form_over_focus(form, row, side);
            return;
        }
    }
}

/* The i-th file whose name holds what was typed; -1: there are no more. Folders only once they were typed. */
static int matching(struct thud_form_over *form, int i)
{
    const struct thud_line *line = line_here(form);
    const char *typed = line->selected ? "" : line->text, *slash = strrchr(typed, '/');
    for (int k = 0; k < form->files.n; k++)
        if (thud_ascii_find(thud_path_name(form->files.item[k].name), slash ? slash + 1 : typed) && i-- == 0)
            return k;
    return -1;
}

/* The list follows the folder that is typed. */
static void list_files(struct thud_tui *tui, struct thud_form_over *form)
{
    const char *text = line_here(form)->text, *slash = strrchr(text, '/');
    char folder[THUD_LINE_MAX];
    snprintf(folder, sizeof folder, "%.*s", slash ? (int)(slash - text) + 1 : 0, text);
    thud_browse_list(&form->files, THUD_BROWSE_RECORDS, tui->doc.paths, "", folder);
}

/* The first file that fits what was typed, in its place; false: there is none, or it is one already. */
static bool take_file(struct thud_tui *tui, struct thud_form_over *form)
{
    struct thud_line *line = line_here(form);
    int k = here(form)->motion && *line->text ? matching(form, 0) : -1;
    if (k < 0 || strcmp(form->files.item[k].name, line->text) == 0)
        return false;
    thud_line_set(line, form->files.item[k].name);
    list_files(tui, form);
    return true;
}

/* The next of the words in a direction; after the last nothing, where that is allowed. */
static void cycle(struct thud_form_over *form, int step)
{
    const struct thud_over_row *row = here(form);
    int n = 0, now = -1;
    for (; row->choice(row, n); n++)
        now = strcmp(row->choice(row, n), line_here(form)->text) == 0 ? n : now;
    const int count = n + !row->only;
    now = ((now < 0 ? (step > 0 ? -1 : count) : now) + step + count) % count;
    thud_line_select(line_here(form), now < n ? row->choice(row, now) : "");
}

/* The first word that begins with the letters typed so far; false: none does, which is said. */
static bool begin_with(struct thud_tui *tui, struct thud_form_over *form, int key)
{
    const struct thud_over_row *row = here(form);
    char prefix[sizeof form->prefix], words[200] = "";
    snprintf(prefix, sizeof prefix, "%.22s%c", form->prefix, key);
    for (int i = 0; row->choice(row, i); i++) {
        thud_append(words, sizeof words, "%s%s", i ? ", " : "", row->choice(row, i));
        if (strncmp(row->choice(row, i), prefix, strlen(prefix)) != 0)
            continue;
        thud_line_select(line_here(form), row->choice(row, i));
        memcpy(form->prefix, prefix, sizeof prefix);
        return true;
    }
    thud_tui_say(tui, THUD_ROLE_WARN, "%s: none begins with \"%s\": %s", row->label, prefix, words);
    return false;
}

static void type(struct thud_tui *tui, struct thud_form_over *form, int key)
{
    const struct thud_over_row *row = here(form);
    const struct thud_line *line = line_here(form);
    const bool begins = row->only || line->selected || !*line->text, /* a word typed may have a blank in it */
        turns = (key == ' ' && begins) || (row->only && (key == THUD_KEY_RIGHT || key == THUD_KEY_LEFT));
    if (row->choice && turns) {
        form->prefix[0] = '\0';
        cycle(form, key == THUD_KEY_LEFT ? -1 : 1);
    } else if (row->only) {
        if (key <= ' ' || key >= 0x7f || !begin_with(tui, form, key))
            return;
    } else if (!thud_line_key(line_here(form), key))
        return;
    else if (row->motion)
        list_files(tui, form);
    if (!*form->prefix)
        thud_tui_hush(tui);
}

static void take_key(struct thud_tui *tui, int key)
{
    struct thud_form_over *form = tui->dialog.own;
    switch (thud_key_action(THUD_AT_NEW, key)) {
    case THUD_DO_CANCEL:
        thud_tui_normal(tui);
        thud_tui_hush(tui);
        break;
    case THUD_DO_ACCEPT:
        take_file(tui, form);
        thud_form_over_focus(form, form->at, form->side);
        form->done(tui, form);
        break;
    case THUD_DO_ACCEPT_NEXT:
        if (!take_file(tui, form))
            go(form, 0, 1);
        break;
    case THUD_DO_ACCEPT_PREVIOUS:
        go(form, 0, -1);
        break;
    case THUD_DO_ACCEPT_DOWN:
        go(form, 1, 0);
        break;
    case THUD_DO_ACCEPT_UP:
        go(form, -1, 0);
        break;
    default:
        type(tui, form, key);
    }
}

static void draw_row(struct thud_form_over *form, const struct thud_pane *in, int index, int y)
{
    const struct thud_over_row *row = &form->row[index];
    char fitted[THUD_LINE_MAX];
    const int label = in->w < 2 * LABEL ? in->w / 2 : LABEL + 8 * (form->row[0].of != NULL);
    thud_pane_put(in, 1, y, thud_look(THUD_ROLE_PLAIN, 0), thud_utf8_fit(row->label, label - 2, fitted, sizeof fitted));
    for (int side = 0; side < (row->two ? 2 : 1); side++) {
        const int x = label + side * VALUE, most = row->two ? VALUE - 2 : in->w - x - 1,
                  room = x + most > in->w ? in->w - x : most;
        const bool focus = index == form->at && side == form->side, there = applies(form, index, side);
        const char *text = !there ? "-" : *row->value[side].text ? row->value[side].text : "(none)";
        if (focus)
            thud_pane_glyph(in, x - 1, y, thud_look(THUD_ROLE_KEY, THUD_BOLD), 0x25b8);
        if (focus && !row->only)
            thud_line_draw(&row->value[side], in, x, y, room, thud_look(THUD_ROLE_VALUE, THUD_UNDERLINE));
        else
            thud_pane_put(in, x, y, thud_look(there ? THUD_ROLE_VALUE : THUD_ROLE_MUTED, focus ? THUD_REVERSE : 0),
                          thud_utf8_fit(text, room, fitted, sizeof fitted));
    }
}

/* The files that fit, or the words to choose from, and the help in full width. */
static void draw_below(struct thud_form_over *form, const struct thud_pane *in, int y)
{
    const struct thud_over_row *row = here(form);
    char name[300];
    for (int i = 0, k; row->motion && y < in->h && (k = matching(form, i)) >= 0; i++, y++) {
        const bool first = i == 0 && *line_here(form)->text && !line_here(form)->selected;
        thud_pane_put(in, 3, y, thud_look(first ? THUD_ROLE_VALUE : THUD_ROLE_PLAIN, 0),
                      thud_utf8_fit(form->files.item[k].name, in->w - 24, name, sizeof name));
        thud_pane_put(in, in->w - 19, y, thud_look(THUD_ROLE_MUTED, 0), thud_browse_about(&form->files, k));
    }
    int x = 1;
    for (int i = 0; row->choice && row->choice(row, i); i++) {
        const char *word = row->choice(row, i);
        const bool now = strcmp(word, line_here(form)->text) == 0;
        if (x > 1 && x + thud_utf8_columns(word) > in->w - 1) {
            x = 1;
            y++;
        }
        x += 2 + thud_pane_put(in, x, y, thud_look(THUD_ROLE_VALUE, now ? THUD_REVERSE : 0), word);
    }
    if (row->help && !row->motion)
        thud_pane_wrap(in, 1, y + (x > 1), in->w - 2, thud_look(THUD_ROLE_MUTED, 0), row->help);
}

static void draw(struct thud_tui *tui, const struct thud_pane *area)
{
    struct thud_form_over *form = tui->dialog.own;
    thud_pane_blank(area);
    struct thud_pane in = thud_pane_frame(area, form->title, true);
    const int below = in.h > form->n + LEAST_HELP ? in.h - form->n - 1
                      : in.h > 2 * LEAST_HELP     ? LEAST_HELP
                                                  : 0,
              rows = in.h - below > 0 ? in.h - below : 1;
    thud_list_scroll(&form->at, &form->top, form->n, rows);
    for (int i = form->top; i < form->n && i < form->top + rows; i++)
        draw_row(form, &in, i, i - form->top);
    draw_below(form, &in, in.h - below + (form->n < rows));
}

static struct thud_line *line(struct thud_tui *tui)
{
    struct thud_form_over *form = tui->dialog.own;
    return form->n > 0 && !here(form)->only ? line_here(form) : NULL;
}

static void release(struct thud_tui *tui)
{
    struct thud_form_over *form = tui->dialog.own;
    thud_browse_clear(&form->files);
}

struct thud_form_over *thud_form_over_begin(struct thud_tui *tui)
{
    static const struct thud_over over = {.where = THUD_AT_NEW,
                                          .size = sizeof(struct thud_form_over),
                                          .key = take_key,
                                          .draw = draw,
                                          .line = line,
                                          .free = release};
    return thud_tui_over(tui, &over);
}
