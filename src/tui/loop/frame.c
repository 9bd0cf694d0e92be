/* What every screen has around it: the top lines, the panes' frames, the lines at the bottom. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "tui/document/field.h"
#include "tui/loop/loop.h"
#include "tui/loop/verdict.h"

/* Returns the column it starts at. */
static int run_status(struct thud_tui *tui, const struct thud_pane *row)
{
    char text[64];
    int role = THUD_ROLE_MUTED;
    double own = -1.0;
    for (int i = 0; i < tui->screens && own < 0.0; i++)
        if (tui->view[i]->progress)
            own = tui->view[i]->progress(tui);
    if (tui->files.command) {
        snprintf(text, sizeof text, "%.30s  Esc stops ", tui->files.written);
        role = THUD_ROLE_WARN;
    } else if (tui->files.work) {
        snprintf(text, sizeof text, "figures %d/%d  Esc stops ", tui->files.done, tui->files.count);
        role = THUD_ROLE_WARN;
    } else if (tui->run.live.running || own >= 0.0) {
        int tenths = (int)(10.0 * (tui->run.live.running ? thud_live_progress(&tui->run.live) : own));
        char bar[16] = "..........";
        memset(bar, '#', (size_t)(tenths < 0 ? 0 : tenths > 10 ? 10 : tenths));
        snprintf(text, sizeof text, "[%s] Esc stops ", bar);
        role = THUD_ROLE_WARN;
    } else if (tui->run.revision != tui->doc.revision) {
        snprintf(text, sizeof text, "not run: r runs ");
        role = THUD_ROLE_WARN;
    } else if (thud_live_failed(&tui->run.live)) {
        snprintf(text, sizeof text, "FAILED ");
        role = THUD_ROLE_ERROR;
    } else {
        char number[24];
        snprintf(text, sizeof text, "run %s ms  ok ", thud_tui_number(1e3 * tui->run.elapsed_s, number));
        role = THUD_ROLE_GOOD;
    }
    thud_pane_right(row, row->w, 0, thud_look(role, THUD_BOLD), text);
    return row->w - thud_utf8_columns(text);
}

/* The name gives way where there is less room, the numbers do not. */
static void record_words(const struct thud_tui *tui, int columns, char *text, size_t size)
{
    const struct thud_record_choice *choice = &tui->doc.scene.record;
    const char *slash = strrchr(choice->file, '/');
    if (!*choice->file) {
        snprintf(text, size, "no ground motion");
        return;
    }
    char peak[32] = "", number[24];
    if (tui->doc.record)
        snprintf(peak, sizeof peak, " %s g", thud_tui_number(thud_record_peak(tui->doc.record) / THUD_GRAVITY, number));
    bool part = !isnan(choice->from_s) || !isnan(choice->to_s);
    char scaled[48] = "";
    double scale = tui->doc.record ? fabs(tui->doc.record->scale) : 1.0;
    if (fabs(scale - 1.0) > 5e-4)
        snprintf(scaled, sizeof scaled, " scaled x%s", thud_tui_number(scale, number));
    char rest[160], name[300];
    snprintf(rest, sizeof rest, "%s%s %c%s", peak, scaled, choice->sign < 0 ? '-' : '+', part ? " part" : "");
    int room = columns - thud_utf8_columns(rest);
    thud_utf8_fit(slash ? slash + 1 : choice->file, room < 4 ? 4 : room, name, sizeof name);
    snprintf(text, size, "%s%s", name, rest);
}

/* Draws the screens' names, or finds the one at a column: -1 where there is none. */
static int tabs(struct thud_tui *tui, const struct thud_pane *row, int column)
{
    int at = 0;
    for (int i = 0; i < tui->screens; i++) {
        bool here = i == tui->screen, named = here || row->w >= THUD_DESIGN_WIDTH - 8;
        char text[64];
        if (named)
            snprintf(text, sizeof text, "%c%d %s%c", here ? '[' : ' ', i + 1, tui->view[i]->title, here ? ']' : ' ');
        else
            snprintf(text, sizeof text, " %d ", i + 1);
        int role = here ? THUD_ROLE_TITLE : named ? THUD_ROLE_PLAIN : THUD_ROLE_MUTED, from = at;
        if (column < 0)
            thud_pane_put(row, at, 0, thud_look(role, here ? THUD_BOLD | THUD_REVERSE : 0), text);
        at += thud_utf8_columns(text);
        if (column >= from && column < at)
            return i;
    }
    return -1;
}

int thud_tui_tab_at(struct thud_tui *tui, int column)
{
    struct thud_pane page = thud_canvas_pane(&tui->canvas);
    return tabs(tui, &page, column);
}

static void top_lines(struct thud_tui *tui, const struct thud_pane *page)
{
    struct thud_pane row = thud_pane_inside(page, 0, 0, page->w, 1);
    char text[512];
    int at = 1 + thud_pane_put(&row, 1, 0, thud_look(THUD_ROLE_TITLE, THUD_BOLD), "thud");
    at += 2 + thud_pane_print(&row, at + 2, 0, thud_look(THUD_ROLE_PLAIN, THUD_BOLD), "%s%s", tui->doc.scene.name,
                              thud_doc_unsaved(&tui->doc) ? " [+]" : "");
    struct thud_pane middle = thud_pane_inside(&row, 0, 0, run_status(tui, &row) - 1, 1);
    record_words(tui, middle.w - at - 3, text, sizeof text);
    thud_pane_put(&middle, at + 3, 0, thud_look(THUD_ROLE_PLAIN, 0), text);
    row = thud_pane_inside(page, 0, 1, page->w, 1);
    tabs(tui, &row, -1);
}

/* Meaning, unit, bounds and default of the field under the cursor. */
static void field_words(struct thud_tui *tui, char *text, size_t size)
{
    const struct thud_field *field = thud_form_focus(&tui->form);
    int floor;
    *text = '\0';
    const struct thud_view *view = thud_tui_view(tui);
    const bool list = tui->dialog.mode == THUD_MODE_CHOOSING;
    if (tui->dialog.mode == THUD_MODE_OVER || (list && (!field || strcmp(tui->dialog.chooser.title, field->path) != 0)))
        return; /* a form or a list of something else stands over the screen */
    if (field && field->kind == THUD_FIELD_ROW && view->hint)
        snprintf(text, size, "%s", view->hint(field));
    const struct thud_panel *panel = !field && view->read ? view->read(tui) : NULL;
    if (!field && view->words)
        view->words(tui, text, size);
    else if (panel && isnan(tui->reading[tui->screen]))
        snprintf(text, size, "Left and Right read values off the chart%s", view->take ? ", Enter takes one" : "");
    else if (panel) {
        thud_chart_words(panel, tui->reading[tui->screen], text, size);
        thud_append(text, size, "%s", view->take ? ". Enter: the scene takes it" : "");
    }
    if (!field || field->kind != THUD_FIELD_VALUE)
        return;
    const struct thud_param *param = thud_scene_param(&tui->doc.scene, field->path, &floor);
    if (!param)
        return;
    thud_param_words(param, text, size);
}

static void bottom_keys(struct thud_tui *tui, const struct thud_pane *row)
{
    int where = thud_tui_where(tui);
    bool normal = tui->dialog.mode == THUD_MODE_NORMAL;
    const char *always = normal ? "? help  q quit " : "";
    int at = 1, room = row->w - thud_utf8_columns(always);
    if (tui->dialog.mode == THUD_MODE_ASKING)
        at += thud_pane_put(row, at, 0, thud_look(THUD_ROLE_KEY, 0),
                            tui->dialog.question->unsaved ? "s save  y lose  Esc stay" : "y yes   n no   Esc cancel");
    int keys = tui->dialog.mode == THUD_MODE_ASKING ? 0 : thud_key_count();
    for (int i = 0; i < 2 * keys; i++) { /* those that stand only where there is room come behind */
        const struct thud_key_entry *key = thud_key_at(i % keys);
        const char *label = key->label + (*key->label == '+');
        if (!(key->where & where) || !*label || (label > key->label) != (i >= keys) || key->action == THUD_DO_HELP ||
            key->action == THUD_DO_QUIT || thud_key_action(where, key->key) != key->action ||
            (normal && thud_tui_cannot(tui, key->action)))
            continue;
        bool between_fields = key->action == THUD_DO_ACCEPT_NEXT || key->action == THUD_DO_ACCEPT_DOWN;
        if (between_fields && tui->dialog.mode == THUD_MODE_TYPING && tui->dialog.prompt)
            continue;
        bool alone = *label == '~';
        char text[64];
        snprintf(text, sizeof text, "%s%s%s", alone ? "" : key->written, alone ? "" : " ", label + alone);
        int width = thud_utf8_columns(text);
        if (at + width + 2 > room)
            continue;
        thud_pane_put(row, at, 0, thud_look(THUD_ROLE_KEY, 0), text);
        at += width + 2;
    }
    thud_pane_right(row, row->w, 0, thud_look(THUD_ROLE_KEY, 0), always);
}

/* Leaves off sentences at the end until the rest fits into so many rows. */
static void fit_words(const struct thud_pane *lines, int rows, char *words)
{
    struct thud_pane nowhere = thud_pane_inside(lines, 0, 0, lines->w, 0);
    while (thud_pane_wrap(&nowhere, 1, 0, lines->w - 2, thud_look(THUD_ROLE_PLAIN, 0), words) > rows) {
        char *end = NULL;
        for (char *at = words; (at = strstr(at, ". ")) != NULL; at++)
            end = at + 1;
        if (!end)
            return;
        *end = '\0';
    }
}

/* What newcomers can do next; each goes once it was done twice. */
static void next_steps(const struct thud_tui *tui, char *text, size_t size)
{
    const struct {
        int taken;
        const char *words;
    } step[] = {{tui->taken[THUD_ACTIONS + THUD_SCREEN_SWEEP], "6 finds the gap"},
                {tui->taken[THUD_DO_DESIGNS], "U keeps this design"},
                {tui->taken[THUD_DO_REPORT], "R reports"}};
    *text = '\0';
    for (size_t i = 0; i < sizeof step / sizeof *step; i++)
        if (step[i].taken < 2)
            thud_append(text, size, "%s%s", *text ? ", " : "next: ", step[i].words);
}

static void bottom_lines(struct thud_tui *tui, const struct thud_pane *page, int rows)
{
    struct thud_pane lines = thud_pane_inside(page, 0, page->h - rows, page->w, rows);
    char words[1024];
    field_words(tui, words, sizeof words);
    struct thud_look said = thud_look((int)tui->said.role, THUD_BOLD), muted = thud_look(THUD_ROLE_PLAIN, 0);
    struct thud_pane upper = thud_pane_inside(&lines, 0, 0, lines.w, rows - 1);
    struct thud_pane nowhere = thud_pane_inside(&lines, 0, 0, lines.w, 0);
    int needed = thud_pane_wrap(&nowhere, 1, 0, lines.w - 2, said, tui->said.text);
    if (needed > upper.h && needed < page->h / 2) { /* over the panes, as long as it is said */
        upper = thud_pane_inside(page, 0, page->h - 1 - needed, page->w, needed);
        thud_pane_blank(&upper);
    }
    if (tui->dialog.mode == THUD_MODE_TYPING && tui->dialog.prompt) {
        const char *before = tui->dialog.prompt->words ? tui->dialog.prompt->words : tui->dialog.target;
        int at = 1 + thud_pane_put(&upper, 1, upper.h - 1, thud_look(THUD_ROLE_KEY, THUD_BOLD), before);
        if (*tui->said.text && upper.h > 1)
            thud_pane_put(&upper, 1, 0, said, tui->said.text);
        thud_line_draw(&tui->dialog.line, &upper, at, upper.h - 1, upper.w - at,
                       thud_look(THUD_ROLE_VALUE, THUD_UNDERLINE));
    } else {
        int used = *tui->said.text ? thud_pane_wrap(&upper, 1, 0, upper.w - 2, said, tui->said.text) : 0;
        if (used == 0 && upper.h > 1 && thud_utf8_columns(words) <= upper.w - 2) {
            char next[80];
            next_steps(tui, next, sizeof next);
            if (tui->dialog.mode == THUD_MODE_NORMAL)
                thud_pane_put(&upper, 1, 0, thud_look(THUD_ROLE_MUTED, 0), next);
            used = 1;
        }
        fit_words(&upper, upper.h - used, words);
        if (used < upper.h)
            thud_pane_wrap(&upper, 1, used, upper.w - 2, muted, words);
    }
    struct thud_pane keys = thud_pane_inside(&lines, 0, rows - 1, lines.w, 1);
    bottom_keys(tui, &keys);
}

static void draw_pane(struct thud_tui *tui, const struct thud_view *view, const struct thud_pane *page, int index,
                      struct thud_rect at)
{
    struct thud_form *form = &tui->form;
    char title[128] = "";
    view->pane_title(tui, index, title, sizeof title);
    struct thud_pane outer = thud_pane_inside(page, at.x, at.y, at.w, at.h);
    struct thud_pane in = thud_pane_frame(&outer, title, form->pane[tui->screen] == index);
    in.scroll = form->scroll[tui->screen][index];
    form->height[index] = in.h;
    form->used[index] = view->draw(tui, index, &in);
    int more = form->used[index] - in.scroll - in.h;
    char text[32];
    if (more > 0 && outer.w > 16 && in.h > 0) {
        snprintf(text, sizeof text, " %d more ↓ ", more);
        thud_pane_right(&outer, outer.w - 1, outer.h - 1, thud_look(THUD_ROLE_MUTED, 0), text);
    }
    if (in.scroll > 0 && outer.w > 16 && in.h > 0) {
        snprintf(text, sizeof text, " %d above ↑ ", in.scroll);
        thud_pane_right(&outer, outer.w - 1, 0, thud_look(THUD_ROLE_MUTED, 0), text);
    }
}

/* All panes; returns how many there are. Where the terminal is small the one with the cursor takes all the room. */
static int draw_panes(struct thud_tui *tui, const struct thud_pane *page, struct thud_rect area)
{
    const struct thud_view *view = thud_tui_view(tui);
    struct thud_rect rect[THUD_PANES_MAX];
    int n = view->layout(tui, area, rect);
    bool small = thud_tui_one_pane(tui);
    int here = tui->form.pane[tui->screen];
    if (here < 0 || here >= n)
        here = 0;
    thud_form_begin(&tui->form, tui->screen);
    tui->chart.plot.w = tui->chart.plot.h = 0;
    for (int i = 0; i < n; i++) {
        struct thud_rect hidden = {0, 0, 0, 0};
        draw_pane(tui, view, page, i, !small ? rect[i] : i == here ? area : hidden);
    }
    return n;
}

static void say_too_small(const struct thud_tui *tui, const struct thud_pane *page)
{
    char text[80];
    snprintf(text, sizeof text, "thud needs %dx%d, here %dx%d", THUD_LEAST_WIDTH, THUD_LEAST_HEIGHT, page->w, page->h);
    int y = thud_pane_wrap(page, 0, 0, page->w, thud_look(THUD_ROLE_PLAIN, 0), text);
    if (tui->dialog.mode == THUD_MODE_ASKING)
        thud_pane_wrap(page, 0, y, page->w, thud_look(THUD_ROLE_WARN, THUD_BOLD), tui->said.text);
}

void thud_tui_draw(struct thud_tui *tui)
{
    int width, height;
    if (tui->files.picture != THUD_IMAGE_NONE)
        return;
    tui->backend->size(tui->backend, &width, &height);
    if ((width != tui->canvas.width || height != tui->canvas.height) &&
        thud_canvas_resize(&tui->canvas, width, height, NULL) != THUD_OK)
        return;
    for (int pass = 0; pass < 3; pass++) {
        thud_canvas_clear(&tui->canvas);
        struct thud_pane page = thud_canvas_pane(&tui->canvas);
        if (page.w < THUD_LEAST_WIDTH || page.h < THUD_LEAST_HEIGHT) {
            say_too_small(tui, &page);
            break;
        }
        struct thud_rect area = thud_tui_area(tui);
        int rows = page.h - area.y - area.h;
        int panes = draw_panes(tui, &page, area);
        bool again = thud_form_end(&tui->form, panes);
        top_lines(tui, &page);
        if (area.y > 2) {
            struct thud_pane verdict = thud_pane_inside(&page, 0, 2, page.w, 1);
            thud_verdict_draw(tui, &verdict);
        }
        if (tui->dialog.mode == THUD_MODE_CHOOSING) {
            struct thud_pane over = thud_pane_inside(&page, 0, area.y, area.w, area.h);
            thud_chooser_draw(&tui->dialog.chooser, &over);
        }
        if (tui->dialog.mode == THUD_MODE_OVER) {
            struct thud_pane over = thud_pane_inside(&page, 0, 2, page.w, page.h - 2 - rows);
            tui->dialog.over->draw(tui, &over);
        }
        bottom_lines(tui, &page, rows);
        if (!again)
            break;
    }
    tui->backend->show(tui->backend, &tui->canvas);
    thud_tui_drawn(tui);
}
