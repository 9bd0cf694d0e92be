/* The shelf: every figure there is now, each to be looked at, marked, written, and made part of the report. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/run/figure_files.h"
#include "tui/loop/loop.h"

enum { RUN = THUD_SCREEN_PLOTS, LEAST_BESIDE = 64 };

struct shelf {
    struct thud_shelved item[THUD_PICTURES_MAX]; /* (n) */
    int n, at, top;
    int panel;       /* shown alone, from 1; 0: all, or the one with the most curves */
    long made_of;    /* what they were made of; -1: nothing */
    char wanted[64]; /* the name of the one to be shown once it is there */
};

/* Of the cases that have a result, with the bumper's last: what `thud run --cases -o` draws. */
static int collect_run(const struct thud_tui *tui, struct thud_shelved *item, int room)
{
    struct thud_figure_source source[THUD_LIVE_CASES];
    int n = 0, count = 0;
    for (int i = THUD_LIVE_NONE; i < THUD_LIVE_CASES && tui->run.live.history == THUD_LIVE_WHOLE; i++) {
        const struct thud_live_case *c = &tui->run.live.which[i];
        if (c->state == THUD_LIVE_DONE)
            source[n++] = thud_run_source(thud_tui_case_name(tui, (enum thud_live_which)i), thud_case_compared(i),
                                          &tui->doc.scene, c->run);
    }
    for (int i = 0; n > 0 && i < THUD_RUN_FIGURES && count < room; i++)
        if (thud_run_figure_has((enum thud_run_figure)i, source, n))
            item[count++] = (struct thud_shelved){thud_run_figure((enum thud_run_figure)i, source, n), RUN};
    return count;
}

/* Makes the figures of one screen (-1: of all, with the one shown where there is but that), those of the run standing
 * for screens that have none of their own. */
static int collect(struct thud_tui *tui, int screen, struct thud_shelved *item)
{
    int n = screen < 0 || !tui->view[screen]->figures ? collect_run(tui, item, THUD_PICTURES_MAX) : 0;
    for (int i = 0; screen < 0 && i < tui->files.nmade && n < THUD_PICTURES_MAX; i++) {
        const struct thud_made *made = &tui->files.made[i];
        struct thud_figure *copy = thud_figure_copy(made->figure);
        thud_figure_title_add(copy, made->revision == tui->doc.revision ? "" : "before edits");
        item[n++] = (struct thud_shelved){copy, THUD_SCREEN_SWEEP};
    }
    for (int s = 0; s < tui->screens; s++) {
        const struct thud_view *view = tui->view[s];
        int count = view->figures && (screen < 0 || screen == s) ? view->figures(tui) : 0;
        const struct thud_figure *shown = screen < 0 && !view->figures && view->figure ? view->figure(tui) : NULL;
        for (int i = 0; i < count && n < THUD_PICTURES_MAX; i++)
            item[n++] = (struct thud_shelved){view->make(tui, i), s};
        if (shown && n < THUD_PICTURES_MAX)
            item[n++] = (struct thud_shelved){thud_figure_copy(shown), s};
    }
    int kept = 0;
    for (int i = 0; i < n; i++)
        if (thud_figure_check(item[i].figure, NULL) == THUD_OK)
            item[kept++] = item[i];
        else
            thud_figure_free(item[i].figure);
    return kept;
}

/* Where a name stands among those marked; NULL: it is not marked. */
static char *marked(struct thud_tui *tui, const struct thud_shelved *item)
{
    char line[sizeof tui->files.marked / 4];
    snprintf(line, sizeof line, "\n%d %s\n", item->screen, item->figure->name);
    return strstr(tui->files.marked, line);
}

static void mark(struct thud_tui *tui, const struct thud_shelved *item)
{
    char *at = marked(tui, item);
    size_t n = strlen(tui->files.marked);
    if (at) {
        const char *end = strchr(at + 1, '\n') + 1;
        memmove(at, end, strlen(end) + 1);
    } else {
        snprintf(tui->files.marked + n, sizeof tui->files.marked - n, "\n%d %s\n", item->screen, item->figure->name);
        if (!marked(tui, item))
            tui->files.marked[n] = '\0'; /* no room is left */
    }
}

typedef void deliver(struct thud_tui *tui, const struct thud_shelved *item, int count);

/* Takes all figures over: writes the marked ones, where none of them is marked all. */
static void write_figures(struct thud_tui *tui, struct thud_shelved *item, int n, deliver *to)
{
    int kept = 0, any = 0;
    for (int i = 0; i < n; i++)
        any += marked(tui, &item[i]) != NULL;
    for (int i = 0; i < n; i++)
        if (any == 0 || marked(tui, &item[i]))
            item[kept++] = item[i];
        else
            thud_figure_free(item[i].figure);
    if (kept > 0)
        to(tui, item, kept);
    else
        thud_tui_say(tui, THUD_ROLE_WARN, "There is no figure yet: r runs");
}

void thud_tui_pictures(struct thud_tui *tui)
{
    struct thud_shelved item[THUD_PICTURES_MAX];
    bool all = *tui->files.marked != '\0';
    tui->files.pictures_wanted = (all || !thud_tui_view(tui)->figures) && tui->run.live.history != THUD_LIVE_WHOLE;
    if (tui->files.pictures_wanted) {
        thud_tui_say(tui, THUD_ROLE_PLAIN, "Running with histories, for the figures");
        thud_tui_run(tui);
        return;
    }
    write_figures(tui, item, collect(tui, all ? -1 : tui->screen, item), thud_tui_figures);
}

/* ---- over the screen ---- */

static void empty(struct shelf *shelf)
{
    for (int i = 0; i < shelf->n; i++)
        thud_figure_free(shelf->item[i].figure);
    shelf->n = 0;
    shelf->made_of = -1;
}

static void release(struct thud_tui *tui)
{
    empty(tui->dialog.own);
}

/* The figures follow the runs that end while they are looked at. */
static void refresh(struct thud_tui *tui, struct shelf *shelf)
{
    long now = 2 * (long)tui->doc.revision + (tui->run.live.history == THUD_LIVE_WHOLE && !tui->run.live.running);
    now = 64 * now + (long)tui->files.arrived;
    for (int s = 0; s < tui->screens; s++)
        now = 64 * now + (tui->view[s]->figures ? tui->view[s]->figures(tui) : 0);
    if (now == shelf->made_of || tui->run.live.running)
        return;
    empty(shelf);
    shelf->n = collect(tui, -1, shelf->item);
    shelf->made_of = now;
    for (int i = 0; *shelf->wanted && i < shelf->n; i++)
        if (strcmp(shelf->item[i].figure->name, shelf->wanted) == 0) {
            shelf->at = i;
            shelf->wanted[0] = '\0';
        }
    thud_list_scroll(&shelf->at, &shelf->top, shelf->n, 0);
}

/* With the name of its file where another figure has the same title. */
static const char *line_of(const struct thud_tui *tui, const struct shelf *shelf, int i, char *text, size_t size)
{
    const char *own = thud_tui_figure_title(tui, shelf->item[i].figure);
    bool alike = false;
    for (int k = 0; k < shelf->n && !alike; k++)
        alike = k != i && strcmp(own, thud_tui_figure_title(tui, shelf->item[k].figure)) == 0;
    if (alike)
        snprintf(text, size, "%s: %s, %s", tui->view[shelf->item[i].screen]->title, shelf->item[i].figure->name, own);
    else
        snprintf(text, size, "%s", own);
    return text;
}

static void draw_list(struct thud_tui *tui, struct shelf *shelf, const struct thud_pane *pane)
{
    char title[40], fitted[200], line[300];
    int any = 0;
    for (int i = 0; i < shelf->n; i++)
        any += marked(tui, &shelf->item[i]) != NULL;
    if (any > 0)
        snprintf(title, sizeof title, "Figures: %d of %d marked", any, shelf->n);
    else
        snprintf(title, sizeof title, "%d figures", shelf->n);
    struct thud_pane in = thud_pane_frame(pane, title, true);
    thud_list_scroll(&shelf->at, &shelf->top, shelf->n, in.h);
    for (int row = 0; row < in.h && shelf->top + row < shelf->n; row++) {
        const struct thud_shelved *item = &shelf->item[shelf->top + row];
        line_of(tui, shelf, shelf->top + row, line, sizeof line);
        struct thud_look look = thud_look(THUD_ROLE_PLAIN, shelf->top + row == shelf->at ? THUD_REVERSE : 0);
        thud_pane_print(&in, 0, row, look, "%s %s", marked(tui, item) ? "*" : " ",
                        thud_utf8_fit(line, in.w - 3, fitted, sizeof fitted));
    }
    if (tui->run.live.running)
        thud_pane_put(&in, 1, in.h - 1, thud_look(THUD_ROLE_MUTED, 0), "running, for the others");
    else if (shelf->n == 0)
        thud_pane_put(&in, 1, 0, thud_look(THUD_ROLE_MUTED, 0), "none yet: r runs");
}

static void draw(struct thud_tui *tui, const struct thud_pane *area)
{
    struct shelf *shelf = tui->dialog.own;
    const struct thud_chart chart = {.cursor = NAN};
    bool beside = area->w >= LEAST_BESIDE;
    int w = beside ? area->w * 2 / 5 : area->w, h = beside ? area->h : area->h / 2;
    struct thud_pane list = thud_pane_inside(area, 0, 0, w, h),
                     right = thud_pane_inside(area, beside ? w : 0, beside ? 0 : h, beside ? area->w - w : w,
                                              beside ? area->h : area->h - h);
    refresh(tui, shelf);
    thud_pane_blank(area);
    draw_list(tui, shelf, &list);
    struct thud_pane in = thud_pane_frame(
        &right, shelf->at < shelf->n ? thud_tui_figure_title(tui, shelf->item[shelf->at].figure) : "", false);
    if (shelf->at < shelf->n)
        thud_chart_figure(&in, shelf->item[shelf->at].figure, shelf->panel - 1, &chart);
}

/* Writes the marked ones, or all, and leaves the shelf; the report is of the marked ones alone. */
static void deliver_all(struct thud_tui *tui, struct shelf *shelf, enum thud_action action)
{
    const bool report = action == THUD_DO_REPORT;
    if (report && !*tui->files.marked) {
        tui->dialog.next = action; /* its form, in place of the shelf */
        return;
    }
    const char *why = tui->files.work ? thud_tui_cannot(tui, THUD_DO_PICTURES)
                      : report        ? thud_tui_cannot(tui, action)
                                      : NULL;
    if (why) {
        thud_tui_say(tui, THUD_ROLE_WARN, "%s", why);
        return;
    }
    struct thud_shelved item[THUD_PICTURES_MAX];
    const int n = shelf->n;
    memcpy(item, shelf->item, (size_t)n * sizeof *item);
    shelf->n = 0;
    thud_tui_normal(tui);
    write_figures(tui, item, n, report ? thud_tui_figures_of_report : thud_tui_figures);
}

static void take_key(struct thud_tui *tui, int key)
{
    struct shelf *shelf = tui->dialog.own;
    const struct thud_figure *figure = shelf->at < shelf->n ? shelf->item[shelf->at].figure : NULL;
    int page = tui->canvas.height / 2, step = 0, panels = figure ? figure->rows * figure->columns : 0;
    enum thud_action action = thud_key_action(THUD_AT_SHELF, key);
    switch (action) {
    case THUD_DO_CANCEL:
        empty(shelf);
        thud_tui_normal(tui);
        break;
    case THUD_DO_PICTURES:
    case THUD_DO_REPORT:
        deliver_all(tui, shelf, action);
        return;
    case THUD_DO_SAVE:
        tui->dialog.next = action;
        return;
    case THUD_DO_MARK:
        if (shelf->at < shelf->n)
            mark(tui, &shelf->item[shelf->at]);
        step = 1;
        break;
    case THUD_DO_UP:
    case THUD_DO_PAGE_UP:
        step = action == THUD_DO_UP ? -1 : -page;
        break;
    case THUD_DO_DOWN:
    case THUD_DO_PAGE_DOWN:
        step = action == THUD_DO_DOWN ? 1 : page;
        break;
    case THUD_DO_NEXT_CONTACT:
    case THUD_DO_PREVIOUS_CONTACT:
        shelf->panel += action == THUD_DO_NEXT_CONTACT ? 1 : panels;
        shelf->panel %= panels + 1;
        return;
    default:
        break;
    }
    shelf->panel = step ? 0 : shelf->panel;
    shelf->at += step;
    thud_list_scroll(&shelf->at, &shelf->top, shelf->n, 0);
}

void thud_tui_shelf(struct thud_tui *tui)
{
    static const struct thud_over over = {.where = THUD_AT_SHELF,
                                          .size = sizeof(struct shelf),
                                          .whole = true,
                                          .key = take_key,
                                          .draw = draw,
                                          .free = release};
    struct shelf *shelf = thud_tui_over(tui, &over);
    if (shelf)
        shelf->made_of = -1;
}

void thud_tui_shelf_at(struct thud_tui *tui, const char *name)
{
    thud_tui_shelf(tui);
    if (tui->dialog.mode == THUD_MODE_OVER)
        snprintf(((struct shelf *)tui->dialog.own)->wanted, sizeof((struct shelf *)0)->wanted, "%.60s", name);
}
