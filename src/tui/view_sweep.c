/* Sweep: one or two parameters, records, cases; the figures fill as the study runs. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/file.h"
#include "plot/figures_sweep.h"
#include "tui/chart.h"
#include "tui/field.h"
#include "tui/sweep_screen.h"

enum { FORM, CHART };

static int layout(struct thud_tui *tui, struct thud_rect area, struct thud_rect *pane)
{
    (void)tui;
    int left = area.w >= 110 ? 40 : area.w * 2 / 5;
    pane[FORM] = (struct thud_rect){area.x, area.y, left, area.h};
    pane[CHART] = (struct thud_rect){area.x + left, area.y, area.w - left, area.h};
    return 2;
}

static void refresh(struct thud_tui *tui)
{
    struct thud_sweep_state *s = thud_sweep_state(tui);
    if (!s || (s->shown && s->shown_rows == s->work.rows.table.nrows && s->shown_figure == s->figure))
        return;
    thud_figure_free(s->shown);
    s->shown = NULL;
    int count = s->work.rows.table.nrows > 0 ? thud_sweep_figure_count(&s->work.rows.table) : 0;
    if (count == 0)
        return;
    s->figure %= count;
    s->shown = thud_sweep_figure(&s->work.rows.table, s->figure);
    s->shown_rows = s->work.rows.table.nrows;
    s->shown_figure = s->figure;
    if (thud_figure_check(s->shown, NULL) != THUD_OK) {
        thud_figure_free(s->shown);
        s->shown = NULL;
    }
}

static void pane_title(struct thud_tui *tui, int index, char *text, size_t size)
{
    struct thud_sweep_state *s = thud_sweep_state(tui);
    if (index == FORM || !s) {
        snprintf(text, size, "Study");
        return;
    }
    refresh(tui);
    int count = s->work.rows.table.nrows > 0 ? thud_sweep_figure_count(&s->work.rows.table) : 0;
    if (s->shown)
        snprintf(text, size, "%d/%d %.100s", s->figure + 1, count, s->shown->title);
    else
        snprintf(text, size, "Amplification");
}

static int draw(struct thud_tui *tui, int index, struct thud_pane *pane)
{
    struct thud_sweep_state *s = thud_sweep_state(tui);
    if (index == FORM || !s)
        return thud_sweep_form_draw(tui, FORM, pane);
    refresh(tui);
    if (s->shown) {
        struct thud_chart chart = thud_tui_reading(tui);
        thud_chart_figure(pane, s->shown, s->panel, &chart);
    } else
        thud_field_note(pane, 0, s->work.points ? "nothing to show yet" : "r runs the study");
    return pane->h;
}

static void start(struct thud_tui *tui)
{
    struct thud_sweep_state *s = thud_sweep_state(tui);
    struct thud_error err;
    if (!s)
        return;
    thud_figure_free(s->shown);
    s->shown = NULL;
    s->panel = -1;
    if (thud_sweep_work_start(&s->work, &tui->doc.scene, &s->words, tui->doc.paths, tui->doc.path, &err) != THUD_OK)
        thud_tui_say_error(tui, &err);
    s->revision = tui->doc.revision;
    s->ran = s->words;
}

static bool act(struct thud_tui *tui, enum thud_action action)
{
    struct thud_sweep_state *s = thud_sweep_state(tui);
    int panels = s && s->shown ? s->shown->rows * s->shown->columns : 0;
    if (!s)
        return false;
    switch (action) {
    case THUD_DO_RUN:
        start(tui);
        return true;
    case THUD_DO_BACK:
        if (!s->work.running)
            return false;
        thud_sweep_work_stop(&s->work);
        thud_tui_say(tui, THUD_ROLE_WARN, "Stopped; what is done stays");
        return true;
    case THUD_DO_QUANTITY:
        s->figure++;
        s->panel = -1;
        return true;
    case THUD_DO_NEXT_CONTACT:
        s->panel = s->panel + 1 < panels ? s->panel + 1 : -1;
        return true;
    case THUD_DO_PREVIOUS_CONTACT:
        s->panel = s->panel < 0 ? panels - 1 : s->panel - 1;
        return true;
    default:
        return false;
    }
}

static const char *cannot(struct thud_tui *tui, enum thud_action action)
{
    bool of_figure = action == THUD_DO_QUANTITY || action == THUD_DO_NEXT_CONTACT || action == THUD_DO_PREVIOUS_CONTACT;
    if (!of_figure)
        return NULL;
    refresh(tui);
    return tui->sweep && tui->sweep->shown ? NULL : "There is no figure yet: r runs the study";
}

static const struct thud_figure *figure(struct thud_tui *tui)
{
    refresh(tui);
    return tui->sweep ? tui->sweep->shown : NULL;
}

static const struct thud_panel *read_panel(struct thud_tui *tui)
{
    if (tui->form.pane[THUD_SCREEN_SWEEP] != CHART || !figure(tui))
        return NULL;
    const struct thud_figure *shown = tui->sweep->shown;
    int panel = tui->sweep->panel < 0 ? 0 : tui->sweep->panel;
    return panel < shown->rows * shown->columns && shown->panel[panel].used ? &shown->panel[panel] : NULL;
}

static bool busy(struct thud_tui *tui)
{
    return tui->sweep && tui->sweep->work.running;
}

static bool work(struct thud_tui *tui)
{
    struct thud_error err = {0};
    if (thud_sweep_work_advance(&tui->sweep->work, &err) != THUD_OK)
        thud_tui_say_error(tui, &err);
    tui->dirty = tui->dirty || !tui->sweep->work.running;
    return tui->sweep->work.running;
}

static double progress(struct thud_tui *tui)
{
    const struct thud_sweep_work *w = tui->sweep ? &tui->sweep->work : NULL;
    return w && w->running && w->points > 0 ? (double)w->next / (double)w->points : -1.0;
}

static struct thud_figure *study_figure(const void *from, int index)
{
    return thud_sweep_figure(from, index);
}

static void pictures(struct thud_tui *tui)
{
    if (!tui->sweep || tui->sweep->work.rows.table.nrows == 0)
        thud_tui_say(tui, THUD_ROLE_WARN, "There is no study yet: r runs it");
    else
        thud_tui_figures(tui, thud_sweep_figure_count(&tui->sweep->work.rows.table), study_figure,
                         &tui->sweep->work.rows.table);
}

static void export_csv(struct thud_tui *tui)
{
    struct thud_error err;
    enum thud_status status = thud_folder_make(thud_tui_folder(tui), &err);
    if (status == THUD_OK)
        status = thud_sweep_work_export(&tui->sweep->work, thud_tui_folder(tui), &err);
    if (status != THUD_OK)
        thud_tui_say_error(tui, &err);
    else
        thud_tui_say(tui, THUD_ROLE_GOOD, "Written sweep.csv, contacts.csv and needed-gaps.csv into %s",
                     thud_tui_folder(tui));
}

static void release(struct thud_tui *tui)
{
    if (!tui->sweep)
        return;
    thud_sweep_work_clear(&tui->sweep->work);
    thud_figure_free(tui->sweep->shown);
    free(tui->sweep);
    tui->sweep = NULL;
}

THUD_VIEW(sweep, "Sweep", SWEEP, .act = act, .cannot = cannot, .row = thud_sweep_form_row, .figure = figure,
          .read = read_panel, .busy = busy, .work = work, .progress = progress, .pictures = pictures,
          .export_csv = export_csv, .free = release);
