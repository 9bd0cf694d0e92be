/* Plots: one figure of many, and the buildings moving at the time of its cursor. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ground/intensity.h"
#include "tui/document/field.h"
#include "tui/document/scene_edit.h"
#include "tui/screens/moment.h"
#include "tui/screens/movement.h"
#include "tui/screens/plots.h"
#include "tui/widgets/chart.h"

enum { CHART, MOVE, SETUP };

/* What is shown first: from a little before 5 % of the Arias intensity to 95 % of it, with the cursor in it. */
static void open_on_strong_motion(struct thud_tui *tui)
{
    struct thud_plots_state *p = thud_plots(tui);
    if (p->opened || !tui->doc.record)
        return;
    const struct thud_intensity m = thud_intensity_of(tui->doc.record);
    double margin = 0.1 * m.d5_95_s, from = fmax(0.0, fmin(m.t5_s, p->time_s) - margin),
           to = fmax(m.t95_s, p->time_s) + margin;
    p->opened = true;
    if (to - from < 0.8 * thud_plots_end(tui))
        tui->window[THUD_SCREEN_PLOTS] = (struct thud_chart_window){from, to};
}

/* The contact with the largest force, where none was chosen; its left floor with it. */
static void choose_sight(struct thud_tui *tui)
{
    struct thud_plots_state *p = thud_plots(tui);
    const struct thud_live_case *c = thud_plots_case(tui);
    if (!c)
        return;
    const struct thud_result *result = thud_run_result(c->run);
    if (p->sight.contact >= result->ncontacts)
        p->sight.contact = -1;
    if (p->sight.dof >= c->model->ndof)
        p->sight.dof = -1;
    if (p->sight.contact < 0) {
        for (int i = 0; i < result->ncontacts; i++)
            if (p->sight.contact < 0 || result->contact[i].force.value > result->contact[p->sight.contact].force.value)
                p->sight.contact = i;
        if (p->sight.contact >= 0)
            thud_plots_set_time(tui, result->contact[p->sight.contact].force.time_s);
    }
    if (p->sight.dof < 0 && p->sight.contact >= 0)
        p->sight.dof = c->model->contact[p->sight.contact].left_dof >= 0
                           ? c->model->contact[p->sight.contact].left_dof
                           : c->model->contact[p->sight.contact].right_dof;
    if (p->sight.dof < 0 && c->model->ndof > 0)
        p->sight.dof = 0;
    open_on_strong_motion(tui);
}

static bool over_time(enum thud_plot plot)
{
    return plot != THUD_PLOT_LOOP && plot != THUD_PLOT_HYSTERESIS && plot != THUD_PLOT_ENVELOPE;
}

/* What another screen asked for: an impact around its beginning, or a floor over the whole time. */
static void look_at(struct thud_tui *tui)
{
    struct thud_plots_state *p = thud_plots(tui);
    const struct thud_look_at *at = &tui->look_at;
    const struct thud_live_case *c = &tui->run.live.which[THUD_LIVE_NONE];
    if (!at->wanted || (!at->impact && c->state != THUD_LIVE_DONE))
        return;
    if (!at->impact && at->structure >= c->model->nstructures) { /* it was taken away since */
        tui->look_at.wanted = false;
        return;
    }
    p->plot = at->impact ? THUD_PLOT_FORCE : THUD_PLOT_ACCELERATION;
    p->opened = true;
    tui->window[THUD_SCREEN_PLOTS] = at->impact
                                         ? (struct thud_chart_window){fmax(0.0, at->time_s - 0.25), at->time_s + 0.25}
                                         : (struct thud_chart_window){0.0, 0.0};
    p->fresh = tui->look_at.wanted = false;
    if (at->impact) {
        p->sight.which = at->which;
        p->sight.contact = at->contact;
        p->time_s = tui->reading[THUD_SCREEN_PLOTS] = at->time_s; /* its histories may not be there yet */
    } else {
        p->sight.dof = c->model->structure[at->structure].first + at->floor;
    }
}

static void refresh(struct thud_tui *tui)
{
    struct thud_plots_state *p = thud_plots(tui);
    look_at(tui);
    const struct thud_live *compared = thud_tui_compared(tui);
    bool with_base = compared && compared->history;
    if (p->fresh && p->revision == tui->doc.revision && !tui->run.live.running && p->figure &&
        p->compared == with_base && p->base == tui->base.number)
        return;
    p->compared = with_base;
    p->base = tui->base.number;
    if ((int)p->plot >= thud_plot_count(&tui->doc.scene))
        p->plot = THUD_PLOT_FORCE; /* no storey yields any more */
    choose_sight(tui);
    thud_figure_free(p->figure);
    p->figure =
        thud_plot_make(&tui->run.live, with_base ? &tui->base : NULL, &tui->doc.scene, p->plot, &p->sight, &p->why);
    p->revision = tui->doc.revision;
    p->fresh = true;
}

static int layout(struct thud_tui *tui, struct thud_rect area, struct thud_rect *pane)
{
    (void)tui;
    if (area.w >= 110) {
        int left = 40, upper = area.h * 3 / 5;
        pane[CHART] = (struct thud_rect){area.x + left, area.y, area.w - left, upper};
        pane[MOVE] = (struct thud_rect){area.x + left, area.y + upper, area.w - left, area.h - upper};
        pane[SETUP] = (struct thud_rect){area.x, area.y, left, area.h};
        if (area.h >= THUD_MOMENT_TALL) { /* the movement below the form */
            left = area.w * 3 / 10;
            pane[CHART] = (struct thud_rect){area.x + left, area.y, area.w - left, area.h};
            pane[SETUP] = (struct thud_rect){area.x, area.y, left, area.h / 2};
            pane[MOVE] = (struct thud_rect){area.x, area.y + pane[SETUP].h, left, area.h - pane[SETUP].h};
        }
        return 3;
    }
    int right = area.w * 3 / 8;
    pane[CHART] = (struct thud_rect){area.x, area.y, area.w - right, area.h};
    pane[MOVE] = (struct thud_rect){area.x + area.w - right, area.y, right, area.h};
    return 2;
}

/* Whether the movement shows a storey that has collapsed. */
static bool has_fallen(struct thud_tui *tui, const struct thud_plots_state *p)
{
    const struct thud_live_case *c = thud_plots_case(tui);
    return c && thud_run_result(c->run)->collapse.happened && p->time_s >= thud_run_result(c->run)->end_s;
}

static void pane_title(struct thud_tui *tui, int index, char *text, size_t size)
{
    struct thud_plots_state *p = thud_plots(tui);
    refresh(tui);
    if (index == CHART) {
        const char *title = p->figure ? thud_tui_figure_title(tui, p->figure) : thud_plot_title(p->plot);
        snprintf(text, size, "%d/%d %.*s%s", (int)p->plot + 1, thud_plot_count(&tui->doc.scene),
                 (int)strcspn(title, ";"), title,
                 over_time(p->plot) && tui->window[THUD_SCREEN_PLOTS].to > 0.0 ? ", zoom" : "");
    } else if (index == MOVE)
        snprintf(text, size, "t=%.3f s x%g%s", p->time_s, p->speed,
                 has_fallen(tui, p) ? " COLLAPSED"
                 : p->playing       ? ""
                                    : " paused");
    else
        snprintf(text, size, "Parameters and changes");
}

/* While the movement plays the scale stands still: it holds all of the history. Else it fits what is shown. */
static struct thud_range still_range(const struct thud_panel *panel, bool still)
{
    struct thud_panel whole = *panel;
    const struct thud_range fits = {NAN, NAN, 0.0};
    thud_panel_limits(&whole, THUD_X, NAN, NAN);
    thud_panel_limits(&whole, THUD_Y, NAN, NAN);
    return still ? thud_panel_range(&whole, THUD_Y) : fits;
}

/* The curves' values at the cursor. */
static void words(struct thud_tui *tui, char *text, size_t size)
{
    struct thud_plots_state *p = thud_plots(tui);
    refresh(tui);
    if (!p->figure || !over_time(p->plot))
        return;
    thud_chart_words(&p->figure->panel[p->panel > 0 ? p->panel : 0], p->time_s, text, size);
}

/* The cursor, but while the chart is dragged away from under it. */
static double dragged(const struct thud_tui *tui)
{
    const struct thud_chart_window *window = &tui->window[THUD_SCREEN_PLOTS];
    double at = thud_plots(tui)->time_s;
    return isnan(tui->reading[THUD_SCREEN_PLOTS]) && (at < window->from || at > window->to) ? NAN : at;
}

static int draw_chart(struct thud_tui *tui, const struct thud_pane *pane)
{
    struct thud_plots_state *p = thud_plots(tui);
    refresh(tui);
    if (!p->figure) {
        return thud_pane_wrap(pane, 1, 0, pane->w - 2, thud_look(THUD_ROLE_MUTED, 0), p->why);
    }
    if (!over_time(p->plot)) {
        thud_chart_figure(pane, p->figure, p->panel, &(struct thud_chart){.cursor = NAN});
        return pane->h;
    }
    const struct thud_chart chart = thud_tui_reading(tui, dragged(tui));
    struct thud_panel *panel = &p->figure->panel[p->panel > 0 ? p->panel : 0];
    thud_panel_limits(panel, THUD_X, 0.0, thud_plots_end(tui));
    const struct thud_range whole = still_range(panel, p->playing);
    thud_panel_limits(panel, THUD_Y, whole.least, whole.most);
    thud_chart_draw(pane, panel, &chart);
    return pane->h;
}

static int draw_movement(struct thud_tui *tui, const struct thud_pane *pane)
{
    const struct thud_live_case *c = thud_plots_case(tui);
    if (!c) {
        thud_field_note(pane, 0, "no histories to move by");
        return 1;
    }
    thud_pane_put(pane, 0, 0, thud_look(THUD_ROLE_MUTED, 0), thud_tui_case_name(tui, thud_plots(tui)->sight.which));
    thud_movement_draw(pane, &tui->doc.scene, c->model, c->run, thud_plots(tui)->sight.which == THUD_LIVE_BUMPER,
                       thud_plots(tui)->time_s);
    return pane->h;
}

static int draw(struct thud_tui *tui, int index, struct thud_pane *pane)
{
    return index == CHART  ? draw_chart(tui, pane)
           : index == MOVE ? draw_movement(tui, pane)
                           : thud_plots_side_draw(tui, SETUP, pane);
}

static void other_plot(struct thud_tui *tui, int step)
{
    struct thud_plots_state *p = thud_plots(tui);
    int n = thud_plot_count(&tui->doc.scene);
    p->plot = (enum thud_plot)(((int)p->plot + step + n) % n);
    p->panel = -1;
    p->fresh = false;
}

static void next_figure(struct thud_tui *tui)
{
    other_plot(tui, 1);
}

/* Energies are kept for their own figure alone, the motion without pounding where it is seen. */
static enum thud_live_history history(const struct thud_tui *tui)
{
    const struct thud_plots_state *p = thud_plots(tui);
    const bool contact = p->plot == THUD_PLOT_FORCE || p->plot == THUD_PLOT_LOOP;
    return p->plot == THUD_PLOT_ENERGY                   ? THUD_LIVE_WHOLE
           : contact && p->sight.which != THUD_LIVE_FREE ? THUD_LIVE_CONTACTS
                                                         : THUD_LIVE_LOOK;
}

/* Another contact or floor; of a figure that shows all of them another panel, after the last all. */
static void other_sight(struct thud_tui *tui, int step)
{
    struct thud_plots_state *p = thud_plots(tui);
    const struct thud_live_case *c = thud_plots_case(tui);
    const bool contact = thud_plot_is_of_contact(p->plot), floor = thud_plot_is_of_floor(p->plot);
    const int panels = p->figure ? p->figure->rows * p->figure->columns : 0,
              n = contact ? thud_run_result(c->run)->ncontacts
                  : floor ? c->model->ndof
                          : panels + 1;
    int *at = contact ? &p->sight.contact : floor ? &p->sight.dof : &p->panel;
    if (contact || floor)
        *at = n > 0 ? (*at + step + n) % n : -1;
    else
        *at = (*at + 1 + step + n) % n - 1;
    p->fresh = false;
}

/* The wide layout has fields, on which the keys are those of a form. */
static int place(const struct thud_tui *tui)
{
    return tui->form.pane[THUD_SCREEN_PLOTS] == SETUP ? THUD_AT_SIDE : THUD_AT_PLOTS;
}

static enum thud_reaction act(struct thud_tui *tui, enum thud_action action)
{
    struct thud_plots_state *p = thud_plots(tui);
    if (action == THUD_DO_TOGGLE_BUMPER)
        thud_tui_edit_scene(tui, "bumper %d", tui->interface + 1);
    if (action == THUD_DO_TOGGLE_BUMPER || place(tui) == THUD_AT_SIDE)
        return action == THUD_DO_TOGGLE_BUMPER ? THUD_DONE : THUD_NOT_MINE;
    if (thud_plots_act_on_time(tui, action))
        return THUD_DONE;
    switch (action) {
    case THUD_DO_FIRST:
    case THUD_DO_LAST:
        thud_plots_set_time(tui, action == THUD_DO_FIRST ? 0.0 : thud_plots_end(tui));
        return THUD_DONE;
    case THUD_DO_NEXT_FIGURE:
    case THUD_DO_PREVIOUS_FIGURE:
        other_plot(tui, action == THUD_DO_NEXT_FIGURE ? 1 : -1);
        return THUD_DONE;
    case THUD_DO_NEXT_CONTACT:
    case THUD_DO_PREVIOUS_CONTACT:
        other_sight(tui, action == THUD_DO_NEXT_CONTACT ? 1 : -1);
        return THUD_DONE;
    case THUD_DO_CASE:
        p->sight.which = (enum thud_live_which)(((int)p->sight.which + 1) % THUD_LIVE_CASES);
        p->fresh = false;
        return THUD_DONE;
    default:
        return THUD_NOT_MINE;
    }
}

static const char *cannot(struct thud_tui *tui, enum thud_action action)
{
    if (action == THUD_DO_TOGGLE_BUMPER)
        return tui->interface + 1 < tui->doc.scene.nstructures ? NULL : "There is no interface";
    bool of_time = action == THUD_DO_PLAY || action == THUD_DO_SCRUB_BACK || action == THUD_DO_SCRUB_FORWARD ||
                   action == THUD_DO_NEXT_IMPACT || action == THUD_DO_PREVIOUS_IMPACT ||
                   action == THUD_DO_LARGEST_IMPACT || action == THUD_DO_NEXT_CONTACT ||
                   action == THUD_DO_PREVIOUS_CONTACT;
    return of_time && (!thud_plots_case(tui)) ? "There are no histories of this case: r runs, b is another case" : NULL;
}

static const struct thud_figure *figure(struct thud_tui *tui)
{
    refresh(tui);
    return thud_plots(tui)->figure;
}

static void offer(struct thud_tui *tui)
{
    for (int i = 0; i < thud_plot_count(&tui->doc.scene); i++) {
        char command[32];
        snprintf(command, sizeof command, "figure %d", i);
        thud_tui_offer(tui, THUD_SCREEN_PLOTS, command, "figure %s", thud_plot_title((enum thud_plot)i));
    }
}

static void command(struct thud_tui *tui, const char *word, const char *rest)
{
    (void)word;
    thud_plots(tui)->plot = (enum thud_plot)atoi(rest);
    thud_plots(tui)->panel = -1;
    thud_plots(tui)->fresh = false;
}

/* A floor of the buildings that move leads to its row of the model. */
static void click(struct thud_tui *tui, int index, const struct thud_pane *pane, int x, int y)
{
    const struct thud_live_case *c = thud_plots_case(tui);
    int structure = 0,
        floor = c && index == MOVE ? thud_movement_floor(pane, &tui->doc.scene, c->model, c->run, x, y, &structure) : 0;
    char key[THUD_PATH_MAX];
    if (floor < 1)
        return;
    snprintf(key, sizeof key, "structures.%d.mass.%d", structure + 1, floor);
    thud_tui_go_to_field(tui, key);
}

static void begin(struct thud_tui *tui)
{
    *thud_plots(tui) = (struct thud_plots_state){.sight = {-1, -1, THUD_LIVE_BUMPER}, .panel = -1, .speed = 0.25};
}

static void release(struct thud_tui *tui)
{
    thud_figure_free(thud_plots(tui)->figure);
}

THUD_VIEW(plots, "Plots", PLOTS, .compares = true, .moved = true, .size = sizeof(struct thud_plots_state),
          .begin = begin, .free = release, .offer = offer, .command = command, .place = place, .act = act,
          .cannot = cannot, .figure = figure, .next_figure = next_figure, .read_at = thud_plots_set_time,
          .click = click, .history = history, .words = words, .pause = thud_plots_pause, .tick = thud_plots_tick);
