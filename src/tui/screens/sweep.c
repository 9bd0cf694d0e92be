/* Sweep: one or two parameters, records, cases; the figures fill as the study runs. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/file/file.h"
#include "plot/figures/figures_sweep.h"
#include "tui/document/field.h"
#include "tui/document/motions.h"
#include "tui/document/session_log.h"
#include "tui/screens/moment.h"
#include "tui/screens/sweep_screen.h"
#include "tui/widgets/chart.h"

enum { FORM, CHART, MOVE };

static int layout(struct thud_tui *tui, struct thud_rect area, struct thud_rect *pane)
{
    (void)tui;
    int left = area.w >= 160 ? area.w / 4 : area.w >= 110 ? 40 : area.w * 2 / 5;
    pane[FORM] = (struct thud_rect){area.x, area.y, left, area.h};
    pane[CHART] = (struct thud_rect){area.x + left, area.y, area.w - left, area.h};
    if (area.w < THUD_MOMENT_WIDE || area.h < THUD_MOMENT_TALL)
        return 2;
    pane[FORM].h = area.h < 48 ? area.h / 2 - 6 : 18; /* as many rows as a study says */
    pane[MOVE] = (struct thud_rect){area.x, area.y + pane[FORM].h, left, area.h - pane[FORM].h};
    return 3;
}

/* The figure on show. One that an edit started again appears whole, if that does not take long: until then the one
 * before stays. */
static void refresh(struct thud_tui *tui)
{
    static const double patience_s = 0.4;
    struct thud_sweep_state *s = thud_sweep_state(tui);
    size_t rows = s->data.out.rows.table.nrows;
    if (s->shown && s->shown_of == s->begun && s->shown_rows == rows && s->shown_figure == s->figure &&
        s->shown_complete == s->data.complete)
        return;
    bool wait = s->data.running && s->by_itself && tui->backend->now(tui->backend) - s->begun_s < patience_s;
    if (s->shown && (wait || (rows == 0 && s->data.running)))
        return;
    thud_figure_free(s->shown);
    s->shown = NULL;
    int count = thud_live_study_figures(&s->data);
    if (count == 0)
        return;
    s->shown = thud_live_study_figure(&s->data, s->figure % count);
    s->shown_of = s->begun;
    s->shown_rows = rows;
    s->shown_figure = s->figure;
    s->shown_complete = s->data.complete;
    if (thud_figure_check(s->shown, NULL) != THUD_OK) {
        thud_figure_free(s->shown);
        s->shown = NULL;
    }
}

/* Whether the figure on show is of a study before this one, or of the scene or the words before edits. */
static bool is_old(struct thud_tui *tui, struct thud_sweep_state *s)
{
    return s->shown && (s->shown_of != s->begun || !thud_sweep_current(tui, s));
}

/* The first varied key, which the figures of the study have along x, where it is a number and such a figure is shown;
 * NULL: not now. */
static const struct thud_sweep_axis *along_x(const struct thud_sweep_state *s)
{
    const struct thud_sweep_table *table = &s->data.out.rows.table;
    if (!s->shown || table->nrows == 0 || s->data.plan.naxes == 0 || s->data.plan.axis[0].words)
        return NULL;
    int own = thud_sweep_figure_count(table), n = thud_live_study_figures((struct thud_live_study *)&s->data);
    return n == 0 || s->shown_figure % n >= own ? NULL : &s->data.plan.axis[0];
}

/* The value of that key in the scene, as the figure's x; NaN where there is none. */
static double here(const struct thud_tui *tui, const struct thud_sweep_state *s)
{
    const struct thud_sweep_axis *axis = along_x(s);
    char text[96];
    struct thud_quantity value;
    if (!axis || thud_scene_get(&tui->doc.scene, axis->key, text, sizeof text, NULL) != THUD_OK ||
        thud_quantity_parse(text, axis->param->dimension, axis->param->unit, &value, NULL) != THUD_OK)
        return NAN;
    return value.value * thud_varied_factor(axis);
}

static void pane_title(struct thud_tui *tui, int index, char *text, size_t size)
{
    struct thud_sweep_state *s = thud_sweep_state(tui);
    if (index != CHART) {
        snprintf(text, size, "Study");
        if (index == MOVE)
            thud_moment_title(tui, text, size);
        return;
    }
    refresh(tui);
    int count = thud_live_study_figures(&s->data);
    if (s->shown && count > 0)
        snprintf(text, size, "%d/%d %s%.100s", s->figure % count + 1, count, is_old(tui, s) ? "before edits: " : "",
                 thud_tui_figure_title(tui, s->shown));
    else if (s->shown)
        snprintf(text, size, "before edits: %.100s", thud_tui_figure_title(tui, s->shown));
    else
        snprintf(text, size, "Amplification");
}

static void dim(const struct thud_pane *pane)
{
    for (int y = pane->y; y < pane->y + pane->h; y++)
        for (int x = pane->x; x < pane->x + pane->w; x++)
            pane->canvas->cell[y * pane->canvas->width + x].style = thud_look(THUD_ROLE_MUTED, 0);
}

static int draw(struct thud_tui *tui, int index, struct thud_pane *pane)
{
    struct thud_sweep_state *s = thud_sweep_state(tui);
    if (index == FORM)
        return thud_sweep_form_draw(tui, FORM, pane);
    if (index == MOVE)
        return thud_moment_draw(tui, pane);
    refresh(tui);
    if (s->shown) {
        struct thud_chart chart = thud_tui_reading(tui, tui->reading[tui->screen]);
        chart.here = here(tui, s);
        chart.has_here = !isnan(chart.here);
        thud_chart_figure(pane, s->shown, s->panel, &chart);
        if (is_old(tui, s))
            dim(pane);
    } else {
        thud_field_note(pane, 0, s->data.points || *s->why ? "nothing to show yet" : "r runs the study");
    }
    return pane->h;
}

/* Runs of the plan, as far as the words say them. */
static long runs_of(const struct thud_live_study *data)
{
    return thud_sweep_points(&data->plan) * (data->plan.ncases > 0 ? data->plan.ncases : 1);
}

static void begin(struct thud_tui *tui, bool by_itself);
static const char skipped[] = ":unreadable=skip";

/* The motions without those that cannot be read; brackets around the list are left out. */
static void skip(struct thud_tui *tui, const char *records)
{
    char text[THUD_VARY_TEXT] = "";
    size_t used = 0;
    for (const char *at = records + strspn(records, "["); *at && used < sizeof text; at += strspn(at, ",]")) {
        const int length = (int)strcspn(at, ",]");
        used += (size_t)snprintf(text + used, sizeof text - used, "%s%.*s%s", used ? "," : "", length, at, skipped);
        at += length;
    }
    if (used >= sizeof text) {
        thud_tui_say(tui, THUD_ROLE_ERROR, "! there is no room for that in the preset: a NAME.list names the others");
        return;
    }
    thud_tui_set(tui, "study.records", text);
    begin(tui, false);
}

static const struct thud_question ask_skip = {.yes = skip};

/* Whether records name more than one file. */
static bool several(const char *records)
{
    char name[THUD_VARY_TEXT];
    snprintf(name, sizeof name, "%.*s", (int)strcspn(records, ":"), records);
    return strchr(records, ',') || thud_record_is_list(name) || thud_path_is_folder(name);
}

static void begin(struct thud_tui *tui, bool by_itself)
{
    static const double wait_s = 5;
    struct thud_sweep_state *s = thud_sweep_state(tui);
    struct thud_error err = {0};
    if (!by_itself) { /* what was read is read again */
        thud_live_study_clear(&s->data);
        thud_figure_free(s->shown);
        s->shown = NULL;
    }
    s->why[0] = '\0';
    const char *records = tui->doc.scene.study.records;
    struct thud_session *session = thud_doc_session(&tui->doc);
    enum thud_status status = session ? thud_live_study_prepare(&s->data, session, &err)
                                      : thud_error_set(&err, THUD_MEMORY, "no memory for the study");
    free(session);
    /* two of the live cases have contacts, and the runs of a study share much: a tenth was measured on the towers */
    double expected_s = 0.2 * tui->run.plain_s * (double)runs_of(&s->data);
    if (status == THUD_OK && by_itself && expected_s > wait_s)
        snprintf(s->why, sizeof s->why, "%ld runs, about %.0f s: r runs them", runs_of(&s->data), expected_s);
    else if (status == THUD_OK)
        status = thud_live_study_start(&s->data, &err);
    if (status != THUD_OK)
        thud_error_text(&err, s->why, sizeof s->why);
    bool unread = status == THUD_INPUT && several(records) && !s->data.read && !strstr(records, skipped);
    if (unread && !by_itself)
        thud_tui_ask(tui, &ask_skip, records,
                     "%.300s. Skip what cannot be read? (DIR:dt=0.01 s:unit=g in records says for all what is missing)",
                     s->why);
    else if (status != THUD_OK && !by_itself)
        thud_tui_say_error(tui, &err);
    if (!s->base)
        s->base = malloc(sizeof *s->base);
    if (s->base) {
        *s->base = tui->doc.scene;
        for (int i = 0; i < s->data.plan.naxes; i++)
            thud_scene_set(s->base, s->data.plan.axis[i].key, s->data.plan.axis[i].text[0], NULL);
    }
    s->current = true;
    s->revision = tui->doc.revision;
    s->study = tui->doc.scene.study;
    s->begun++;
    s->by_itself = by_itself;
    s->begun_s = tui->backend->now(tui->backend);
}

/* After an edit the study is run again, once the live cases are. */
static void live(struct thud_tui *tui)
{
    struct thud_sweep_state *s = thud_sweep_state(tui);
    if (!thud_sweep_current(tui, s))
        begin(tui, true);
}

/* The cursor goes from one value of the varied key to the next. */
static bool read_on(struct thud_tui *tui, const struct thud_sweep_state *s, int step)
{
    const struct thud_sweep_axis *axis = along_x(s);
    double *at = &tui->reading[THUD_SCREEN_SWEEP], from = isnan(*at) ? here(tui, s) : *at;
    if (!axis || thud_form_focus(&tui->form))
        return false;
    int next = -1;
    for (int i = 0; i < axis->n; i++) {
        double x = axis->value[i] * thud_varied_factor(axis), much = 1e-9 * fabs(x);
        if (step > 0 ? x > from + much && (next < 0 || axis->value[i] < axis->value[next])
                     : x < from - much && (next < 0 || axis->value[i] > axis->value[next]))
            next = i;
    }
    if (next < 0 && isnan(from))
        next = 0;
    if (next >= 0)
        *at = axis->value[next] * thud_varied_factor(axis);
    return true;
}

/* The scene gets the value that the cursor reads. */
static bool set_to_cursor(struct thud_tui *tui)
{
    const struct thud_sweep_state *s = thud_sweep_state(tui);
    const struct thud_sweep_axis *axis = along_x(s);
    double at = tui->reading[THUD_SCREEN_SWEEP];
    char text[64];
    if (!axis || isnan(at))
        return false;
    thud_quantity_format(at / thud_varied_factor(axis), axis->param->unit, text, sizeof text);
    for (int i = 0; i < axis->n; i++)
        if (fabs(axis->value[i] * thud_varied_factor(axis) - at) <= 1e-9 * fabs(at))
            snprintf(text, sizeof text, "%.60s", axis->text[i]);
    if (thud_tui_set(tui, axis->key, text))
        thud_tui_say(tui, THUD_ROLE_GOOD, "%s is %s now (u undoes)", axis->key, text);
    return true;
}

static void next_figure(struct thud_tui *tui)
{
    struct thud_sweep_state *s = thud_sweep_state(tui);
    s->figure++;
    s->panel = -1;
}

static enum thud_reaction act(struct thud_tui *tui, enum thud_action action)
{
    struct thud_sweep_state *s = thud_sweep_state(tui);
    int panels = s->shown ? s->shown->rows * s->shown->columns : 0;
    switch (action) {
    case THUD_DO_RUN:
        thud_tui_log(tui, "sweep");
        begin(tui, false);
        return THUD_DONE;
    case THUD_DO_LEFT:
    case THUD_DO_RIGHT:
        return s->shown && read_on(tui, s, action == THUD_DO_LEFT ? -1 : 1) ? THUD_DONE : THUD_NOT_MINE;
    case THUD_DO_BACK:
        if (!s->data.running)
            return THUD_NOT_MINE;
        thud_live_study_stop(&s->data);
        thud_tui_say(tui, THUD_ROLE_WARN, "Stopped; what is done stays");
        return THUD_DONE;
    case THUD_DO_QUANTITY:
        next_figure(tui);
        return THUD_DONE;
    case THUD_DO_NEXT_CONTACT:
    case THUD_DO_PREVIOUS_CONTACT: /* -1: all of them */
        do
            s->panel = (s->panel + 1 + (action == THUD_DO_NEXT_CONTACT ? 1 : panels)) % (panels + 1) - 1;
        while (s->panel >= 0 && !s->shown->panel[s->panel].used);
        return THUD_DONE;
    default:
        return THUD_NOT_MINE;
    }
}

static const struct thud_figure *figure(struct thud_tui *tui)
{
    refresh(tui);
    return thud_sweep_state(tui)->shown;
}

static const char *cannot(struct thud_tui *tui, enum thud_action action)
{
    bool written = action == THUD_DO_PICTURE || action == THUD_DO_PICTURES || action == THUD_DO_EXPORT;
    if (written && figure(tui) && is_old(tui, thud_sweep_state(tui)))
        return tui->run.live.running || thud_sweep_state(tui)->data.running
                   ? "The study is being run again after the edit: its figure is written once it is there"
                   : "This study is of before the edits, and is not written: r runs it again";
    bool of_figure = action == THUD_DO_QUANTITY || action == THUD_DO_NEXT_CONTACT || action == THUD_DO_PREVIOUS_CONTACT;
    if (!of_figure)
        return NULL;
    refresh(tui);
    return thud_sweep_state(tui)->shown ? NULL : "There is no figure yet: r runs the study";
}

static const struct thud_panel *read_panel(struct thud_tui *tui)
{
    if (tui->form.pane[THUD_SCREEN_SWEEP] != CHART || !figure(tui))
        return NULL;
    const struct thud_figure *shown = thud_sweep_state(tui)->shown;
    int panel = thud_sweep_state(tui)->panel < 0 ? 0 : thud_sweep_state(tui)->panel;
    return panel < shown->rows * shown->columns && shown->panel[panel].used ? &shown->panel[panel] : NULL;
}

static bool busy(struct thud_tui *tui)
{
    return thud_sweep_state(tui)->data.running;
}

static bool work(struct thud_tui *tui)
{
    struct thud_error err = {0};
    if (thud_live_study_advance(&thud_sweep_state(tui)->data, &err) != THUD_OK)
        thud_tui_say_error(tui, &err);
    return thud_sweep_state(tui)->data.running;
}

static enum thud_live_history history(const struct thud_tui *tui)
{
    return tui->canvas.height >= THUD_MOMENT_TALL ? thud_moment_history(tui) : THUD_LIVE_NO_HISTORY;
}

static double progress(struct thud_tui *tui)
{
    const struct thud_live_study *d = &thud_sweep_state(tui)->data;
    return d->running && d->points > 0 ? (double)d->next / (double)d->points : -1.0;
}

static int figures(struct thud_tui *tui)
{
    return thud_live_study_figures(&thud_sweep_state(tui)->data);
}

static struct thud_figure *make(struct thud_tui *tui, int index)
{
    return thud_live_study_figure(&thud_sweep_state(tui)->data, index);
}

static void export_csv(struct thud_tui *tui)
{
    struct thud_error err;
    char stem[200];
    thud_tui_file_name(tui, "sweep", "", stem, sizeof stem);
    enum thud_status status = thud_folder_make(thud_tui_folder(tui), &err);
    if (status == THUD_OK)
        status = thud_live_study_export(&thud_sweep_state(tui)->data, thud_tui_folder(tui), stem, &err);
    if (status != THUD_OK)
        thud_tui_say_error(tui, &err);
    else
        thud_tui_say(tui, THUD_ROLE_GOOD, "Written %s.csv, -contacts.csv, -needed-gaps.csv%s into %s", stem,
                     thud_sweep_state(tui)->data.suite ? ", -suite.csv" : "", thud_tui_folder(tui));
}

static void begin_screen(struct thud_tui *tui)
{
    thud_sweep_state(tui)->panel = -1;
}

static void release(struct thud_tui *tui)
{
    struct thud_sweep_state *s = tui->own[THUD_SCREEN_SWEEP];
    thud_live_study_clear(&s->data);
    thud_figure_free(s->shown);
    free(s->base);
}

THUD_VIEW(sweep, "Sweep", SWEEP, .keys = "study.", .many = true, .size = sizeof(struct thud_sweep_state),
          .begin = begin_screen, .free = release, .act = act, .cannot = cannot, .command = thud_sweep_command,
          .row = thud_sweep_form_row, .hint = thud_sweep_form_hint, .figure = figure, .next_figure = next_figure,
          .read = read_panel, .take = set_to_cursor, .live = live, .busy = busy, .work = work, .progress = progress,
          .history = history, .figures = figures, .make = make, .export_csv = export_csv);
