/* Plots: one figure of many, and the buildings moving at the time of its cursor. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tui/chart.h"
#include "tui/field.h"
#include "tui/figures.h"
#include "tui/movement.h"

enum { CHART, MOVE, SETUP };
static const double frame_s = 0.05;

struct thud_plots_state {
    enum thud_plot plot;
    struct thud_sight sight;
    double time_s, span_s; /* cursor, and how much time is shown; span 0: all */
    bool playing;
    double speed, last_s;
    struct thud_figure *figure;
    const char *why;
    unsigned long revision;
    bool fresh; /* `figure` belongs to what is above */
};

static struct thud_plots_state *state(struct thud_tui *tui)
{
    if (!tui->plots) {
        tui->plots = calloc(1, sizeof *tui->plots);
        if (tui->plots)
            *tui->plots = (struct thud_plots_state){.sight = {-1, -1, THUD_LIVE_BUMPER}, .speed = 0.25};
    }
    return tui->plots;
}

static const struct thud_live_case *shown(struct thud_tui *tui)
{
    struct thud_plots_state *p = state(tui);
    const struct thud_live_case *c = &tui->live.which[p->sight.which];
    if (c->state == THUD_LIVE_ABSENT)
        p->sight.which = THUD_LIVE_NONE;
    c = &tui->live.which[p->sight.which];
    return c->state == THUD_LIVE_DONE && tui->live.history ? c : NULL;
}

static double end_of(struct thud_tui *tui)
{
    const struct thud_live_case *c = shown(tui);
    return c ? thud_run_end(c->run) : 0.0;
}

/* The contact with the largest force, where none was chosen; its left floor with it. */
static void choose_sight(struct thud_tui *tui)
{
    struct thud_plots_state *p = state(tui);
    const struct thud_live_case *c = shown(tui);
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
            p->time_s = result->contact[p->sight.contact].force.time_s;
    }
    if (p->sight.dof < 0 && p->sight.contact >= 0)
        p->sight.dof = c->model->contact[p->sight.contact].left_dof >= 0
                           ? c->model->contact[p->sight.contact].left_dof
                           : c->model->contact[p->sight.contact].right_dof;
    if (p->sight.dof < 0 && c->model->ndof > 0)
        p->sight.dof = 0;
}

static bool over_time(enum thud_plot plot)
{
    return plot != THUD_PLOT_LOOP && plot != THUD_PLOT_ENVELOPE_ACCELERATION && plot != THUD_PLOT_ENVELOPE_DRIFT;
}

static void refresh(struct thud_tui *tui)
{
    struct thud_plots_state *p = state(tui);
    if (p->fresh && p->revision == tui->doc.revision && !tui->live.running && p->figure)
        return;
    choose_sight(tui);
    thud_figure_free(p->figure);
    p->figure = thud_plot_make(&tui->live, &tui->doc.scene, p->plot, &p->sight, &p->why);
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
        return 3;
    }
    int right = area.w * 3 / 8;
    pane[CHART] = (struct thud_rect){area.x, area.y, area.w - right, area.h};
    pane[MOVE] = (struct thud_rect){area.x + area.w - right, area.y, right, area.h};
    return 2;
}

static void pane_title(struct thud_tui *tui, int index, char *text, size_t size)
{
    struct thud_plots_state *p = state(tui);
    if (!p)
        return;
    refresh(tui);
    if (index == CHART)
        snprintf(text, size, "%d/%d %s%s", (int)p->plot + 1, THUD_PLOTS,
                 p->figure ? p->figure->title : thud_plot_title(p->plot),
                 p->span_s > 0.0 && over_time(p->plot) ? ", zoom" : "");
    else if (index == MOVE)
        snprintf(text, size, "t=%.3f s x%g%s", p->time_s, p->speed, p->playing ? "" : " paused");
    else
        snprintf(text, size, "Parameters and changes");
}

static int draw_chart(struct thud_tui *tui, const struct thud_pane *pane)
{
    struct thud_plots_state *p = state(tui);
    if (!p)
        return 0;
    refresh(tui);
    if (!p->figure) {
        thud_field_note(pane, 0, "%s", p->why);
        return 1;
    }
    struct thud_chart chart = {.cursor = over_time(p->plot) ? p->time_s : NAN};
    double end = end_of(tui), from = fmax(0.0, fmin(p->time_s - 0.5 * p->span_s, end - p->span_s));
    for (int i = 0; i < p->figure->columns; i++) {
        struct thud_pane part =
            thud_pane_inside(pane, i * pane->w / p->figure->columns, 0, pane->w / p->figure->columns, pane->h);
        if (over_time(p->plot))
            thud_panel_limits(&p->figure->panel[i], THUD_X, p->span_s > 0.0 ? from : 0.0,
                              p->span_s > 0.0 ? from + p->span_s : end);
        thud_chart_draw(&part, &p->figure->panel[i], &chart);
    }
    return pane->h;
}

static int draw_movement(struct thud_tui *tui, const struct thud_pane *pane)
{
    const struct thud_live_case *c = state(tui) ? shown(tui) : NULL;
    if (!c) {
        thud_field_note(pane, 0, "no histories to move by");
        return 1;
    }
    thud_pane_put(pane, 0, 0, thud_look(THUD_ROLE_MUTED, 0), thud_live_name(state(tui)->sight.which));
    thud_movement_draw(pane, &tui->doc.scene, c->model, thud_run_history(c->run),
                       state(tui)->sight.which == THUD_LIVE_BUMPER, state(tui)->time_s);
    return pane->h;
}

static int draw_setup(struct thud_tui *tui, const struct thud_pane *pane)
{
    static const char *const key[] = {"gap",         "bumper.thickness", "bumper.cavity",     "record.file",
                                      "record.peak", "analysis.method",  "analysis.tolerance"};
    int y = 0;
    for (size_t i = 0; i < sizeof key / sizeof *key; i++) {
        char path[THUD_PATH_MAX], text[96];
        if (i < 3)
            snprintf(path, sizeof path, "interfaces.%d.%s", tui->pair + 1, key[i]);
        else
            snprintf(path, sizeof path, "%s", key[i]);
        if (thud_scene_get(&tui->doc.scene, path, text, sizeof text, NULL) == THUD_OK)
            thud_pane_print(pane, 1, y++, thud_look(THUD_ROLE_PLAIN, 0), "%-18s %s", key[i], text);
    }
    for (int i = THUD_LIVE_NONE; i < THUD_LIVE_CASES; i++) {
        int impacts;
        double force = thud_live_force(&tui->live, (enum thud_live_which)i, 0, &impacts);
        if (!isnan(force))
            thud_pane_print(pane, 1, y++, thud_look(THUD_ROLE_PLAIN, 0), "%-18s %d, up to %.2f MN",
                            i == THUD_LIVE_NONE ? "impacts, bare" : "impacts, bumper", impacts, 1e-6 * force);
    }
    y++;
    thud_pane_put(pane, 1, y++, thud_look(THUD_ROLE_PLAIN, THUD_BOLD), "Changes (u undoes)");
    const char *what;
    for (int i = 0; (what = thud_undo_what(&tui->doc.undo, i)) != NULL && i < 100; i++)
        y += thud_pane_wrap(pane, 1, y, pane->w - 2, thud_look(THUD_ROLE_MUTED, 0), what);
    if (tui->doc.undo.at == 0)
        thud_field_note(pane, y++, "none yet");
    return y;
}

static int draw(struct thud_tui *tui, int index, struct thud_pane *pane)
{
    return index == CHART ? draw_chart(tui, pane) : index == MOVE ? draw_movement(tui, pane) : draw_setup(tui, pane);
}

static void set_time(struct thud_tui *tui, double t)
{
    double end = end_of(tui);
    state(tui)->time_s = fmax(0.0, fmin(end, t));
}

/* The floor of a contact that is no wall's. */
static int floor_of(const struct thud_contact_result *contact)
{
    return contact->left_floor > 0 ? contact->left_floor : contact->right_floor;
}

/* To the nearest impact of the case after or before the cursor; `largest`: to the one with the largest force. */
static void to_impact(struct thud_tui *tui, int direction, bool largest)
{
    struct thud_plots_state *p = state(tui);
    const struct thud_live_case *c = shown(tui);
    int count, best = -1;
    const struct thud_impact *impact = thud_run_impacts(c->run, &count);
    for (int i = 0; i < count; i++) {
        double ahead = direction * (impact[i].start_s - p->time_s);
        if (largest ? best < 0 || impact[i].force_n > impact[best].force_n
                    : ahead > 1e-9 && (best < 0 || ahead < direction * (impact[best].start_s - p->time_s)))
            best = i;
    }
    if (best < 0) {
        thud_tui_say(tui, THUD_ROLE_WARN, count ? "No impact further on" : "There are no impacts in this case");
        return;
    }
    p->sight.contact = impact[best].contact;
    p->time_s = largest ? impact[best].start_s + 0.5 * impact[best].duration_s : impact[best].start_s;
    p->fresh = false;
    thud_tui_say(tui, THUD_ROLE_PLAIN, "Impact at %.4f s for %.1f ms: floor %d, %.3g m/s, %.3g MN, %.3g mm",
                 impact[best].start_s, 1e3 * impact[best].duration_s,
                 floor_of(&thud_run_result(c->run)->contact[impact[best].contact]), impact[best].approach_mps,
                 1e-6 * impact[best].force_n, 1e3 * impact[best].indentation_m);
}

static void other_sight(struct thud_tui *tui, int step)
{
    struct thud_plots_state *p = state(tui);
    const struct thud_live_case *c = shown(tui);
    bool of_contact = p->plot == THUD_PLOT_FORCE || p->plot == THUD_PLOT_CLOSING || p->plot == THUD_PLOT_LOOP;
    int n = of_contact ? thud_run_result(c->run)->ncontacts : c->model->ndof,
        *at = of_contact ? &p->sight.contact : &p->sight.dof;
    if (n > 0)
        *at = (*at + step + n) % n;
    p->fresh = false;
}

static void zoom(struct thud_tui *tui, double factor)
{
    struct thud_plots_state *p = state(tui);
    double end = end_of(tui), span = (p->span_s > 0.0 ? p->span_s : end) * factor;
    p->span_s = span >= end ? 0.0 : fmax(span, 1e-3);
}

static bool act_on_time(struct thud_tui *tui, enum thud_action action)
{
    struct thud_plots_state *p = state(tui);
    double step = (p->span_s > 0.0 ? p->span_s : end_of(tui)) / 100.0;
    switch (action) {
    case THUD_DO_PLAY:
        p->playing = !p->playing;
        if (p->playing && p->time_s >= end_of(tui))
            p->time_s = 0.0;
        p->last_s = tui->backend->now(tui->backend);
        return true;
    case THUD_DO_FASTER:
    case THUD_DO_SLOWER:
        p->speed *= action == THUD_DO_FASTER ? 2.0 : 0.5;
        p->speed = fmin(16.0, fmax(1.0 / 256.0, p->speed));
        return true;
    case THUD_DO_SCRUB_BACK:
    case THUD_DO_SCRUB_FORWARD:
        set_time(tui, p->time_s + (action == THUD_DO_SCRUB_FORWARD ? step : -step));
        return true;
    case THUD_DO_NEXT_IMPACT:
    case THUD_DO_PREVIOUS_IMPACT:
        to_impact(tui, action == THUD_DO_NEXT_IMPACT ? 1 : -1, false);
        return true;
    case THUD_DO_LARGEST_IMPACT:
        to_impact(tui, 1, true);
        return true;
    case THUD_DO_ZOOM:
    case THUD_DO_UNZOOM:
        zoom(tui, action == THUD_DO_ZOOM ? 1.0 / 3.0 : 3.0);
        return true;
    default:
        return false;
    }
}

static bool act(struct thud_tui *tui, enum thud_action action)
{
    struct thud_plots_state *p = state(tui);
    if (!p || act_on_time(tui, action))
        return p != NULL;
    switch (action) {
    case THUD_DO_FIRST:
    case THUD_DO_LAST:
        set_time(tui, action == THUD_DO_FIRST ? 0.0 : end_of(tui));
        return true;
    case THUD_DO_NEXT_FIGURE:
    case THUD_DO_PREVIOUS_FIGURE:
        p->plot = (enum thud_plot)(((int)p->plot + (action == THUD_DO_NEXT_FIGURE ? 1 : THUD_PLOTS - 1)) % THUD_PLOTS);
        p->fresh = false;
        return true;
    case THUD_DO_NEXT_CONTACT:
    case THUD_DO_PREVIOUS_CONTACT:
        other_sight(tui, action == THUD_DO_NEXT_CONTACT ? 1 : -1);
        return true;
    case THUD_DO_CASE:
        p->sight.which = (enum thud_live_which)(((int)p->sight.which + 1) % THUD_LIVE_CASES);
        p->fresh = false;
        return true;
    default:
        return false;
    }
}

static const char *cannot(struct thud_tui *tui, enum thud_action action)
{
    bool of_time = action == THUD_DO_PLAY || action == THUD_DO_SCRUB_BACK || action == THUD_DO_SCRUB_FORWARD ||
                   action == THUD_DO_NEXT_IMPACT || action == THUD_DO_PREVIOUS_IMPACT ||
                   action == THUD_DO_LARGEST_IMPACT || action == THUD_DO_ZOOM || action == THUD_DO_UNZOOM ||
                   action == THUD_DO_NEXT_CONTACT || action == THUD_DO_PREVIOUS_CONTACT;
    return of_time && (!state(tui) || !shown(tui)) ? "There are no histories of this case: r runs, b is another case"
                                                   : NULL;
}

static const struct thud_figure *figure(struct thud_tui *tui)
{
    if (state(tui))
        refresh(tui);
    return tui->plots ? tui->plots->figure : NULL;
}

static double pause(struct thud_tui *tui)
{
    return tui->plots && tui->plots->playing ? frame_s : -1.0;
}

static void tick(struct thud_tui *tui)
{
    struct thud_plots_state *p = tui->plots;
    double now = tui->backend->now(tui->backend);
    set_time(tui, p->time_s + p->speed * fmin(now - p->last_s, 4.0 * frame_s));
    p->last_s = now;
    if (p->time_s >= end_of(tui))
        p->playing = false;
    tui->dirty = true;
}

static void release(struct thud_tui *tui)
{
    if (tui->plots)
        thud_figure_free(tui->plots->figure);
    free(tui->plots);
    tui->plots = NULL;
}

void thud_tui_show_impact(struct thud_tui *tui, enum thud_live_which which, int contact, double time_s)
{
    struct thud_plots_state *p = state(tui);
    if (!p)
        return;
    p->plot = THUD_PLOT_FORCE;
    p->sight.which = which;
    p->sight.contact = contact;
    p->time_s = time_s;
    p->span_s = 0.5;
    p->fresh = false;
    thud_tui_go(tui, THUD_SCREEN_PLOTS);
}

void thud_tui_show_floor(struct thud_tui *tui, int structure, int floor)
{
    struct thud_plots_state *p = state(tui);
    const struct thud_live_case *c = &tui->live.which[THUD_LIVE_NONE];
    if (!p || c->state != THUD_LIVE_DONE)
        return;
    p->plot = THUD_PLOT_ACCELERATION;
    p->sight.dof = c->model->structure[structure].first + floor;
    p->span_s = 0.0;
    p->fresh = false;
    thud_tui_go(tui, THUD_SCREEN_PLOTS);
}

const struct thud_view thud_view_plots = {
    .title = "Plots",
    .where = THUD_AT_PLOTS,
    .layout = layout,
    .draw = draw,
    .pane_title = pane_title,
    .act = act,
    .cannot = cannot,
    .figure = figure,
    .pause = pause,
    .tick = tick,
    .free = release,
};
