/* What the keys do on every screen. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "app/run/command.h"
#include "tui/document/command_work.h"
#include "tui/document/session_log.h"
#include "tui/loop/loop.h"

static void undo(struct thud_tui *tui, int back)
{
    const char *what = back ? thud_doc_undo(&tui->doc) : thud_doc_redo(&tui->doc);
    if (!what)
        return;
    thud_tui_log(tui, back ? "undo" : "redo");
    thud_tui_say(tui, THUD_ROLE_PLAIN, "%s: %s", back ? "Undone" : "Done again", what);
}

static void back(struct thud_tui *tui)
{
    if (tui->files.command) {
        thud_command_work_stop(tui->files.command);
        return;
    }
    if (tui->files.work) { /* it lasts longest */
        thud_picture_work_stop(tui->files.work);
        return;
    }
    if (thud_tui_cancel(tui))
        return;
    if (!*tui->said.text)
        thud_tui_go(tui, tui->before); /* from a screen chosen by mistake */
    thud_tui_hush(tui);
}

/* Moves the cursor that reads the chart in focus, by a hundredth of what is shown; false where there is no chart. */
static bool read_on(struct thud_tui *tui, enum thud_action action)
{
    const struct thud_view *view = thud_tui_view(tui);
    const struct thud_panel *panel = !thud_form_focus(&tui->form) && view->read ? view->read(tui) : NULL;
    if (!panel || (action != THUD_DO_LEFT && action != THUD_DO_RIGHT))
        return false;
    const struct thud_chart_window *window = &tui->window[tui->screen];
    struct thud_range x = thud_panel_range(panel, THUD_X);
    bool log = panel->axis[THUD_X].log;
    double *at = &tui->reading[tui->screen], along = isnan(*at) ? NAN : thud_chart_along(&x, log, *at);
    double shown = window->to > window->from
                       ? thud_chart_along(&x, log, window->to) - thud_chart_along(&x, log, window->from)
                       : 1.0;
    along = isnan(along) ? 0.5 : fmin(1.0, fmax(0.0, along + 0.01 * shown * (action == THUD_DO_LEFT ? -1.0 : 1.0)));
    *at = thud_chart_at(&x, log, along);
    return true;
}

/* Shows less or more of the chart around `at`. */
static void zoom(struct thud_tui *tui, bool more, double at)
{
    static const double step = 3.0;
    tui->window[tui->screen] = thud_chart_zoom(&tui->chart, more ? 1.0 / step : step, at);
}

static void rows(struct thud_tui *tui, int step)
{
    thud_form_move(&tui->form, 0, step);
}

static void columns(struct thud_tui *tui, int step)
{
    thud_form_move(&tui->form, step, 0);
}

static void pages(struct thud_tui *tui, int step)
{
    thud_form_page(&tui->form, step);
}

static void edge(struct thud_tui *tui, int last)
{
    thud_form_edge(&tui->form, last);
}

static void panes(struct thud_tui *tui, int step)
{
    struct thud_rect rect[THUD_PANES_MAX], area = thud_tui_area(tui);
    thud_form_pane(&tui->form, step, thud_tui_view(tui)->layout(tui, area, rect));
}

static void edit(struct thud_tui *tui, int select)
{
    const struct thud_view *view = thud_tui_view(tui);
    if (select && !thud_form_focus(&tui->form) && view->take)
        view->take(tui);
    else
        thud_tui_edit(tui, select);
}

/* "picture plots impact-force": the screen, and of one figure its name. */
static void log_output(struct thud_tui *tui, const char *word, bool one)
{
    const struct thud_view *view = thud_tui_view(tui);
    const struct thud_figure *figure = one && view->figure ? view->figure(tui) : NULL;
    thud_tui_log(tui, "%s %s%s%s", word, view->title, figure ? " " : "", figure ? figure->name : "");
}

static void picture(struct thud_tui *tui)
{
    log_output(tui, "picture", true);
    thud_tui_picture(tui);
}

static void pictures(struct thud_tui *tui)
{
    log_output(tui, "figures", false);
    thud_tui_pictures(tui);
}

static void table(struct thud_tui *tui)
{
    log_output(tui, "table", thud_tui_view(tui)->figure && !thud_tui_view(tui)->export_csv);
    thud_tui_export(tui);
}

static void save(struct thud_tui *tui)
{
    thud_tui_save(tui, NULL, false);
}

static void quit(struct thud_tui *tui)
{
    thud_tui_quit(tui, false);
}

static void command_line(struct thud_tui *tui)
{
    thud_tui_command_line(tui, "");
}

static void zoom_here(struct thud_tui *tui, int more)
{
    zoom(tui, more, tui->reading[tui->screen]);
}

static void screens(struct thud_tui *tui, int step)
{
    thud_tui_go(tui, (tui->screen + tui->screens + step) % tui->screens);
}

static void ask_screen(struct thud_tui *tui)
{
    thud_tui_say(tui, THUD_ROLE_PLAIN, "the number of a screen, 1 to %d", tui->screens);
}

static void turn_mouse(struct thud_tui *tui)
{
    tui->mouse = !tui->mouse;
    tui->backend->mouse(tui->backend, tui->mouse);
    thud_tui_say(tui, THUD_ROLE_PLAIN, tui->mouse ? "Mouse on: clicks and the wheel" : "Mouse off");
}

static void repaint(struct thud_tui *tui)
{
    tui->backend->repaint(tui->backend);
}

/* What an action does on every screen that does nothing else: a function, or one with a number. */
static const struct {
    void (*done)(struct thud_tui *tui);
    void (*by)(struct thud_tui *tui, int how);
    int how;
    bool seen; /* the field is to be seen then */
} actions[THUD_ACTIONS] = {
    [THUD_DO_UP] = {.by = rows, .how = -1},
    [THUD_DO_DOWN] = {.by = rows, .how = 1},
    [THUD_DO_LEFT] = {.by = columns, .how = -1},
    [THUD_DO_RIGHT] = {.by = columns, .how = 1},
    [THUD_DO_PAGE_UP] = {.by = pages, .how = -1},
    [THUD_DO_PAGE_DOWN] = {.by = pages, .how = 1},
    [THUD_DO_FIRST] = {.by = edge, .how = 0},
    [THUD_DO_LAST] = {.by = edge, .how = 1},
    [THUD_DO_NEXT_PANE] = {.by = panes, .how = 1},
    [THUD_DO_PREVIOUS_PANE] = {.by = panes, .how = -1},
    [THUD_DO_EDIT] = {.by = edit, .how = 1, .seen = true},
    [THUD_DO_EDIT_OLD] = {.by = edit, .how = 0, .seen = true},
    [THUD_DO_MARK] = {.done = thud_tui_toggle, .seen = true},
    [THUD_DO_TOGGLE] = {.done = thud_tui_toggle, .seen = true},
    [THUD_DO_STEP_UP] = {.by = thud_tui_step_value, .how = 1, .seen = true},
    [THUD_DO_STEP_DOWN] = {.by = thud_tui_step_value, .how = -1, .seen = true},
    [THUD_DO_LEAP_UP] = {.by = thud_tui_step_value, .how = 10, .seen = true},
    [THUD_DO_LEAP_DOWN] = {.by = thud_tui_step_value, .how = -10, .seen = true},
    [THUD_DO_UNDO] = {.by = undo, .how = 1, .seen = true},
    [THUD_DO_REDO] = {.by = undo, .how = 0, .seen = true},
    [THUD_DO_ZOOM] = {.by = zoom_here, .how = 1},
    [THUD_DO_UNZOOM] = {.by = zoom_here, .how = 0},
    [THUD_DO_REPORT] = {.by = thud_tui_verb_form, .how = THUD_COMMAND_REPORT},
    [THUD_DO_HELP] = {.by = thud_tui_go, .how = THUD_SCREEN_HELP},
    [THUD_DO_NEXT_SCREEN] = {.by = screens, .how = 1},
    [THUD_DO_PREVIOUS_SCREEN] = {.by = screens, .how = -1},
    [THUD_DO_SAVE] = {.done = save},
    [THUD_DO_PICTURE] = {.done = picture},
    [THUD_DO_PICTURES] = {.done = pictures},
    [THUD_DO_EXPORT] = {.done = table},
    [THUD_DO_RUN] = {.done = thud_tui_run},
    [THUD_DO_NEW] = {.done = thud_tui_new},
    [THUD_DO_OPEN] = {.done = thud_tui_list_presets},
    [THUD_DO_SAVE_AS] = {.done = thud_tui_save_as},
    [THUD_DO_COPY] = {.done = thud_tui_copy},
    [THUD_DO_SOLVE] = {.done = thud_tui_solve_field},
    [THUD_DO_MESSAGES] = {.done = thud_tui_show_log},
    [THUD_DO_DESIGNS] = {.done = thud_tui_list_designs},
    [THUD_DO_SHELF] = {.done = thud_tui_shelf},
    [THUD_DO_REMARKS] = {.done = thud_tui_list_remarks},
    [THUD_DO_FIND] = {.done = thud_tui_palette},
    [THUD_DO_BACK] = {.done = back},
    [THUD_DO_COMMAND] = {.done = command_line},
    [THUD_DO_QUIT] = {.done = quit},
    [THUD_DO_GO] = {.done = ask_screen},
    [THUD_DO_MOUSE] = {.done = turn_mouse},
    [THUD_DO_REPAINT] = {.done = repaint},
};

void thud_tui_act(struct thud_tui *tui, enum thud_action action)
{
    const struct thud_view *view = thud_tui_view(tui);
    const char *why = thud_tui_cannot(tui, action);
    thud_tui_hush(tui);
    if (why) {
        thud_tui_say(tui, THUD_ROLE_WARN, "%s", why);
        return;
    }
    int before = tui->before;
    tui->taken[action]++;
    if (action != THUD_DO_BACK && tui->screen != THUD_SCREEN_HELP)
        tui->before = tui->screen; /* it was not chosen by mistake */
    enum thud_reaction reaction = view->act ? view->act(tui, action) : THUD_NOT_MINE;
    if (reaction == THUD_LEAVE)
        thud_tui_go(tui, before);
    if (reaction != THUD_NOT_MINE || read_on(tui, action))
        return;
    if (actions[action].done)
        actions[action].done(tui);
    else if (actions[action].by)
        actions[action].by(tui, actions[action].how);
    if (actions[action].seen)
        tui->form.loose[tui->screen] = false;
}

/* What a column of the chart that is read stands for; NaN: it is not drawn at that place. */
static double chart_at(const struct thud_tui *tui, int x, int y)
{
    const struct thud_chart_frame *f = &tui->chart;
    if (f->plot.w < 2 || x < f->plot.x || x >= f->plot.x + f->plot.w || y < f->plot.y || y >= f->plot.y + f->plot.h)
        return NAN;
    return thud_chart_at(&f->x, f->x_log, (double)(x - f->plot.x) / (f->plot.w - 1));
}

/* The cursor of a chart goes to a column of it; false: there is no chart at that place. */
static bool click_chart(struct thud_tui *tui, int x, int y)
{
    double at = chart_at(tui, x, y);
    if (isnan(at))
        return false;
    tui->reading[tui->screen] = at;
    if (thud_tui_view(tui)->read_at)
        thud_tui_view(tui)->read_at(tui, at);
    return true;
}

/* The pane at a place, and where it is; -1: none is. */
static int pane_at(struct thud_tui *tui, int x, int y, struct thud_rect *at)
{
    struct thud_rect rect[THUD_PANES_MAX], area = thud_tui_area(tui);
    const int n = thud_tui_view(tui)->layout(tui, area, rect);
    for (int i = 0; i < n; i++) {
        *at = thud_tui_one_pane(tui) ? area : rect[i]; /* the one with the cursor has all the room */
        if ((!thud_tui_one_pane(tui) || i == tui->form.pane[tui->screen]) && x >= at->x && y >= at->y &&
            x < at->x + at->w && y < at->y + at->h)
            return i;
    }
    return -1;
}

/* A click on a name of a screen goes there, on a field puts the cursor on it and, when it is there, edits it. */
void thud_tui_click(struct thud_tui *tui)
{
    const int x = tui->backend->click_x, y = tui->backend->click_y;
    struct thud_rect at;
    tui->dragged_x = x;
    tui->grabbed = false;
    tui->run.stepped[0] = '\0';
    if (tui->dialog.mode == THUD_MODE_CHOOSING) {
        if (thud_chooser_click(&tui->dialog.chooser, x, y))
            thud_tui_chosen(tui);
        return;
    }
    if (tui->dialog.mode != THUD_MODE_NORMAL)
        return;
    if (y == 1 && thud_tui_tab_at(tui, x) >= 0) {
        thud_tui_go(tui, thud_tui_tab_at(tui, x));
        return;
    }
    const int i = pane_at(tui, x, y, &at);
    if (i < 0)
        return;
    const int row = y - at.y - 1 + tui->form.scroll[tui->screen][i];
    const struct thud_field *field = thud_form_at(&tui->form, i, x - at.x - 1, row);
    bool again = field && field == thud_form_focus(&tui->form);
    tui->form.pane[tui->screen] = i;
    tui->grabbed = thud_tui_typable(tui, field);
    if (again)
        thud_tui_act(tui, THUD_DO_EDIT);
    else if (field)
        thud_form_focus_on(&tui->form, tui->screen, field->path);
    else if (!click_chart(tui, x, y) && thud_tui_view(tui)->click) {
        struct thud_pane page = thud_canvas_pane(&tui->canvas),
                         in = thud_pane_inside(&page, at.x + 1, at.y + 1, at.w - 2, at.h - 2);
        thud_tui_view(tui)->click(tui, i, &in, x - at.x - 1, row);
    }
}

/* A number goes a step a column, also one that the button going down began to edit. */
static void drag_value(struct thud_tui *tui, int columns)
{
    if (thud_tui_types_field(tui) && tui->dialog.line.selected)
        thud_tui_normal(tui);
    if (tui->dialog.mode == THUD_MODE_NORMAL && columns != 0)
        thud_tui_step_value(tui, columns);
}

void thud_tui_drag(struct thud_tui *tui)
{
    int x = tui->backend->click_x, y = tui->backend->click_y;
    const struct thud_chart_window *window = &tui->window[tui->screen];
    struct thud_rect at;
    if (tui->grabbed) {
        drag_value(tui, x - tui->dragged_x);
        tui->dragged_x = x;
        return;
    }
    if (tui->dialog.mode != THUD_MODE_NORMAL)
        return;
    const int pane = thud_tui_view(tui)->drag ? pane_at(tui, x, y, &at) : -1;
    const bool taken = pane >= 0 && thud_tui_view(tui)->drag(tui, pane, x - tui->dragged_x);
    if (!taken && isnan(chart_at(tui, x, y)))
        return;
    if (!taken && window->to > window->from) {
        tui->window[tui->screen] = thud_chart_pan(&tui->chart, (double)(tui->dragged_x - x) / (tui->chart.plot.w - 1));
        tui->reading[tui->screen] = NAN; /* else what is shown would follow it back */
    } else if (!taken)
        click_chart(tui, x, y);
    tui->dragged_x = x;
}

void thud_tui_wheel(struct thud_tui *tui, int step)
{
    double at = chart_at(tui, tui->backend->click_x, tui->backend->click_y);
    if (tui->dialog.mode == THUD_MODE_NORMAL && !isnan(at)) {
        zoom(tui, step < 0, at);
        return;
    }
    if (tui->dialog.mode == THUD_MODE_CHOOSING)
        thud_chooser_key(&tui->dialog.chooser, step < 0 ? THUD_KEY_UP : THUD_KEY_DOWN);
    else if (tui->dialog.mode == THUD_MODE_OVER)
        tui->dialog.over->key(tui, step < 0 ? THUD_KEY_UP : THUD_KEY_DOWN);
    else if (tui->dialog.mode == THUD_MODE_NORMAL)
        thud_tui_act(tui, step < 0 ? THUD_DO_UP : THUD_DO_DOWN);
}
