#include "tui/loop/new_scene.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "app/run/new_preset.h"
#include "base/ascii.h"
#include "tui/document/session_log.h"

struct thud_new_scene {
    struct thud_new_preset preset;
    bool own[THUD_NEW_ROWS]; /* the right value was typed; else it goes with the left one */
    int row, side;           /* the value being typed */
    struct thud_line line;
    struct thud_browse files; /* ground motions to choose from */
};

enum { LABEL = 22, VALUE = 24, LIST_ROWS = 6 };

static bool single(int row)
{
    return thud_new_about((enum thud_new_row)row)->single;
}

static bool applies(const struct thud_new_scene *f, int row, int side)
{
    return thud_new_applies(&f->preset, (enum thud_new_row)row, side);
}

static bool exists(const char *name)
{
    char path[THUD_NEW_TEXT + 8];
    snprintf(path, sizeof path, "%.240s.yaml", name);
    return access(path, F_OK) == 0;
}

/* The first name that no file here has. */
static void free_name(char *name, size_t size)
{
    snprintf(name, size, "buildings");
    for (int i = 2; i < 1000 && exists(name); i++)
        snprintf(name, size, "buildings-%d", i);
}

static void focus(struct thud_new_scene *f, int row, int side)
{
    f->row = row;
    f->side = side;
    thud_line_select(&f->line, f->preset.text[row][side]);
}

static const struct thud_over over;

void thud_new_scene_begin(struct thud_tui *tui)
{
    struct thud_new_scene *f = thud_tui_over(tui, &over);
    if (!f)
        return;
    thud_new_preset_init(&f->preset);
    f->preset.text[THUD_NEW_RECORD][0][0] = '\0'; /* is chosen from the list */
    free_name(f->preset.text[THUD_NEW_NAME][0], sizeof f->preset.text[THUD_NEW_NAME][0]);
    f->own[THUD_NEW_STOREYS] = true;
    thud_browse_list(&f->files, THUD_BROWSE_RECORDS, tui->doc.paths, "", "");
    focus(f, THUD_NEW_STOREYS, 0);
}

static void keep(struct thud_new_scene *f)
{
    char *text = f->preset.text[f->row][f->side];
    bool changed = strcmp(text, f->line.text) != 0;
    snprintf(text, sizeof f->preset.text[0][0], "%.250s", f->line.text);
    if (f->side == 1 && changed)
        f->own[f->row] = true;
    if (f->side == 0 && !single(f->row) && !f->own[f->row])
        memcpy(f->preset.text[f->row][1], text, sizeof f->preset.text[0][0]);
}

/* The next value in a direction that the kinds have. */
static void go(struct thud_new_scene *f, int rows, int sides)
{
    int at = f->row * 2 + f->side;
    keep(f);
    for (int i = 0; i < 2 * THUD_NEW_ROWS; i++) {
        at = (at + 2 * rows + sides + 2 * THUD_NEW_ROWS) % (2 * THUD_NEW_ROWS);
        int row = at / 2, side = at % 2;
        if (rows != 0 && single(row))
            side = 0;
        if (applies(f, row, side)) {
            focus(f, row, side);
            return;
        }
    }
}

/* The i-th file whose name holds what was typed; -1: there are no more. Folders only once they were typed. */
static int matching(const struct thud_new_scene *f, int i)
{
    const char *typed = f->row == THUD_NEW_RECORD && f->line.selected ? "" : f->line.text, *slash = strrchr(typed, '/');
    for (int k = 0; k < f->files.n; k++) {
        const struct thud_browse_item *item = &f->files.item[k];
        if (thud_ascii_find(thud_path_name(item->name), slash ? slash + 1 : typed) && i-- == 0)
            return k;
    }
    return -1;
}

/* The list follows the folder that is typed. */
static void list_again(struct thud_tui *tui)
{
    struct thud_new_scene *f = tui->dialog.own;
    const char *slash = strrchr(f->line.text, '/');
    char folder[THUD_NEW_TEXT];
    snprintf(folder, sizeof folder, "%.*s", slash ? (int)(slash - f->line.text) + 1 : 0, f->line.text);
    thud_browse_list(&f->files, THUD_BROWSE_RECORDS, tui->doc.paths, "", folder);
}

/* Tab on the ground motion: the first that fits what was typed; a folder is gone into. False: it is one already. */
static bool take_file(struct thud_tui *tui)
{
    struct thud_new_scene *f = tui->dialog.own;
    int k = *f->line.text ? matching(f, 0) : -1;
    if (k < 0 || strcmp(f->files.item[k].name, f->line.text) == 0)
        return false;
    thud_line_set(&f->line, f->files.item[k].name);
    list_again(tui);
    return true;
}

static void log_values(struct thud_tui *tui, const struct thud_new_scene *f)
{
    char line[THUD_LINE_MAX] = "";
    for (int row = 0; row < THUD_NEW_ROWS; row++) {
        size_t n = strlen(line);
        if (row == THUD_NEW_RECORD && !*f->preset.text[THUD_NEW_RECORD][0])
            continue;
        snprintf(line + n, sizeof line - n, "%s%s: %s%s%s", row ? "; " : "",
                 thud_new_about((enum thud_new_row)row)->word, f->preset.text[row][0], single(row) ? "" : ", ",
                 single(row) ? "" : f->preset.text[row][1]);
    }
    thud_tui_log(tui, "new %s", line);
}

static void make(struct thud_tui *tui)
{
    struct thud_new_scene *f = tui->dialog.own;
    struct thud_text text = {0};
    struct thud_error err = {0};
    char path[THUD_NEW_TEXT + 16], found[512];
    if (f->row == THUD_NEW_RECORD)
        take_file(tui);
    keep(f);
    snprintf(path, sizeof path, "%.240s.yaml", f->preset.text[THUD_NEW_NAME][0]);
    enum thud_status status = THUD_OK;
    if (!*f->preset.text[THUD_NEW_NAME][0] || exists(f->preset.text[THUD_NEW_NAME][0]))
        status = thud_error_set(&err, THUD_INPUT, "%s: a name that no file here has", path);
    if (status == THUD_OK && *f->preset.text[THUD_NEW_RECORD][0])
        status = thud_paths_record(tui->doc.paths, path, f->preset.text[THUD_NEW_RECORD][0], found, sizeof found, &err);
    if (status == THUD_OK)
        status = thud_new_preset_text(&f->preset, &text, &err);
    thud_tui_forget_run(tui);
    if (status == THUD_OK)
        status = thud_doc_new(&tui->doc, text.data, text.size, path, &err);
    thud_text_clear(&text);
    if (status != THUD_OK) {
        err.line = err.column = 0; /* of a file that nobody sees */
        err.file[0] = '\0';
        thud_tui_say_error(tui, &err);
        tui->run.seen = 0;
        focus(f, f->row, f->side);
        return;
    }
    thud_tui_normal(tui);
    log_values(tui, f);
    thud_tui_opened(tui);
    thud_tui_go(tui, THUD_SCREEN_MODEL);
    thud_tui_say(tui, THUD_ROLE_GOOD, "%s: each value can be changed here now; w saves", path);
}

static void cycle(struct thud_new_scene *f, int step)
{
    int now = 0, kinds = 0;
    for (; thud_new_kind(kinds); kinds++)
        now = strcmp(f->line.text, thud_new_kind(kinds)) == 0 ? kinds : now;
    thud_line_select(&f->line, thud_new_kind((now + step + kinds) % kinds));
    keep(f);
}

static void take_key(struct thud_tui *tui, int key)
{
    struct thud_new_scene *f = tui->dialog.own;
    bool of_kind = f->row == THUD_NEW_KIND;
    if (key == THUD_KEY_ESC) {
        thud_tui_normal(tui);
        thud_tui_hush(tui);
    } else if (key == THUD_KEY_ENTER) {
        make(tui);
    } else if (key == THUD_KEY_TAB && f->row == THUD_NEW_RECORD && take_file(tui)) {
        thud_tui_hush(tui);
    } else if (key == THUD_KEY_TAB || key == THUD_KEY_BACKTAB) {
        go(f, 0, key == THUD_KEY_TAB ? 1 : -1);
    } else if (key == THUD_KEY_DOWN || key == THUD_KEY_UP) {
        go(f, key == THUD_KEY_DOWN ? 1 : -1, 0);
    } else if (of_kind) {
        if (key == ' ' || key == THUD_KEY_RIGHT || key == THUD_KEY_LEFT)
            cycle(f, key == THUD_KEY_LEFT ? -1 : 1);
    } else if (thud_line_key(&f->line, key)) {
        thud_tui_hush(tui);
        if (f->row == THUD_NEW_RECORD)
            list_again(tui);
    }
}

static void draw_files(struct thud_new_scene *f, const struct thud_pane *in, int y)
{
    for (int i = 0, k; y < in->h && (k = matching(f, i)) >= 0; i++, y++) {
        char name[300];
        const char *about = thud_browse_about(&f->files, k);
        thud_pane_put(in, 3, y,
                      thud_look(i == 0 && *f->line.text && !f->line.selected ? THUD_ROLE_VALUE : THUD_ROLE_PLAIN, 0),
                      thud_utf8_fit(f->files.item[k].name, in->w - 24, name, sizeof name));
        thud_pane_put(in, in->w - 19, y, thud_look(THUD_ROLE_MUTED, 0), about);
    }
}

static void draw(struct thud_tui *tui, const struct thud_pane *area)
{
    struct thud_new_scene *f = tui->dialog.own;
    int w = area->w < 78 ? area->w : 78,
        h = area->h < THUD_NEW_ROWS + LIST_ROWS + 3 ? area->h : THUD_NEW_ROWS + LIST_ROWS + 3;
    struct thud_pane box = thud_pane_inside(area, (area->w - w) / 2, (area->h - h) / 2, w, h);
    thud_pane_blank(area);
    struct thud_pane in = thud_pane_frame(&box, "New scene: two neighbours", true);
    int scroll = f->row >= in.h ? f->row - in.h + 1 : 0;
    for (int row = 0; row < THUD_NEW_ROWS; row++) {
        int y = row - scroll;
        if (y < 0 || y >= in.h)
            continue;
        thud_pane_put(&in, 1, y, thud_look(THUD_ROLE_PLAIN, 0), thud_new_about((enum thud_new_row)row)->label);
        for (int side = 0; side < (single(row) ? 1 : 2); side++) {
            int x = LABEL + side * VALUE,
                room = row == THUD_NEW_NAME || row == THUD_NEW_RECORD ? in.w - x - 1 : VALUE - 2;
            if (x + room > in.w)
                room = in.w - x;
            bool here = row == f->row && side == f->side;
            if (here)
                thud_pane_glyph(&in, x - 1, y, thud_look(THUD_ROLE_KEY, THUD_BOLD), 0x25b8);
            if (here && row != THUD_NEW_KIND)
                thud_line_draw(&f->line, &in, x, y, room, thud_look(THUD_ROLE_VALUE, THUD_UNDERLINE));
            else
                thud_pane_put(
                    &in, x, y,
                    thud_look(applies(f, row, side) ? THUD_ROLE_VALUE : THUD_ROLE_MUTED, here ? THUD_REVERSE : 0),
                    !applies(f, row, side)       ? "-"
                    : *f->preset.text[row][side] ? f->preset.text[row][side]
                                                 : "(none)");
        }
    }
    if (f->row == THUD_NEW_RECORD)
        draw_files(f, &in, THUD_NEW_ROWS - scroll);
    else
        thud_pane_wrap(&in, 1, THUD_NEW_ROWS + 1 - scroll, in.w - 2, thud_look(THUD_ROLE_MUTED, 0),
                       thud_new_about((enum thud_new_row)f->row)->help);
}

static struct thud_line *line(struct thud_tui *tui)
{
    struct thud_new_scene *f = tui->dialog.own;
    return &f->line;
}

static void release(struct thud_tui *tui)
{
    struct thud_new_scene *f = tui->dialog.own;
    thud_browse_clear(&f->files);
}

static const struct thud_over over = {.where = THUD_AT_NEW,
                                      .size = sizeof(struct thud_new_scene),
                                      .key = take_key,
                                      .draw = draw,
                                      .line = line,
                                      .free = release};

/* Cuts blanks off both ends. */
static char *trimmed(char *text)
{
    text += strspn(text, " ");
    for (size_t n = strlen(text); n > 0 && text[n - 1] == ' '; n--)
        text[n - 1] = '\0';
    return text;
}

void thud_new_scene_command(struct thud_tui *tui, const char *text)
{
    char copy[THUD_LINE_MAX], *rest = copy;
    snprintf(copy, sizeof copy, "%s", text);
    thud_new_scene_begin(tui);
    struct thud_new_scene *f = tui->dialog.own;
    if (!f || !*text)
        return;
    f->files.n = 0; /* names are meant as they are */
    for (char *part; (part = strtok_r(rest, ";", &rest)) != NULL;) {
        char *value = strchr(part, ':');
        int row = 0;
        if (value)
            *value++ = '\0';
        part = trimmed(part);
        while (row < THUD_NEW_ROWS && strcmp(part, thud_new_about((enum thud_new_row)row)->word) != 0)
            row++;
        if (!value || row == THUD_NEW_ROWS) {
            thud_tui_normal(tui);
            thud_tui_say(tui, THUD_ROLE_ERROR,
                         "! new: \"%.40s\" is none of name, kind, storeys, mass, stiffness, height, "
                         "damping, gap, record, soil, damper",
                         part);
            return;
        }
        thud_new_preset_put(&f->preset, (enum thud_new_row)row, value);
    }
    focus(f, THUD_NEW_STOREYS, 0);
    make(tui);
    if (tui->dialog.mode == THUD_MODE_OVER)
        thud_tui_normal(tui);
}
