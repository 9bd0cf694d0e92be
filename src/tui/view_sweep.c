/* Sweep: one or two parameters, records, cases; the figures fill as the study runs. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/run_figures.h"
#include "io/file.h"
#include "plot/figures_sweep.h"
#include "tui/chart.h"
#include "tui/field.h"
#include "tui/sweep_work.h"

enum { FORM, CHART };
enum { VARY_1, VARY_2, CASES, RECORDS, WORDS };

struct thud_sweep_state {
    struct thud_study_words words;
    struct thud_sweep_work work;
    unsigned long revision; /* of the scene the study was made with */
    int figure, panel;      /* which is shown; panel -1: all */
    struct thud_figure *shown;
    size_t shown_rows;
    int shown_figure;
    int typed; /* the line being typed */
};

static const char *const word_name[WORDS] = {"vary", "vary too", "cases", "records"};

static char *word_of(struct thud_sweep_state *s, int index, size_t *size)
{
    *size = index == CASES     ? sizeof s->words.cases
            : index == RECORDS ? sizeof s->words.records
                               : sizeof s->words.vary[0];
    return index == CASES ? s->words.cases : index == RECORDS ? s->words.records : s->words.vary[index];
}

/* The preset's own study, in the command line's words; else the paper's. */
static void first_words(const struct thud_scene *scene, struct thud_study_words *words)
{
    bool bumper = false;
    for (int i = 0; i + 1 < scene->nstructures; i++)
        bumper = bumper || scene->interface[i].has_bumper;
    for (int i = 0; i < scene->study.nvary && i < 2; i++) {
        const struct thud_vary *vary = &scene->study.vary[i];
        const struct thud_param *param = thud_scene_param(scene, vary->key, &(int){0});
        const char *unit = param && param->unit ? param->unit : "";
        char from[64], to[64], step[64];
        thud_quantity_format(vary->from, unit, from, sizeof from);
        thud_quantity_format(vary->to, unit, to, sizeof to);
        thud_quantity_format(vary->step, unit, step, sizeof step);
        snprintf(words->vary[i], sizeof words->vary[i], "%.60s=%.40s:%.40s:%.40s", vary->key, from, to, step);
    }
    if (scene->study.nvary == 0)
        snprintf(words->vary[0], sizeof words->vary[0], "gap=5 cm:25 cm:1 cm");
    for (int i = 0; i < scene->study.ncases; i++) {
        size_t n = strlen(words->cases);
        snprintf(words->cases + n, sizeof words->cases - n, "%s%s", i ? "," : "",
                 thud_case_name(scene->study.cases[i]));
    }
    if (scene->study.ncases == 0)
        snprintf(words->cases, sizeof words->cases, "%s", bumper ? "none,bumper" : "none");
}

static struct thud_sweep_state *state(struct thud_tui *tui)
{
    if (!tui->sweep) {
        tui->sweep = calloc(1, sizeof *tui->sweep);
        if (tui->sweep) {
            first_words(&tui->doc.scene, &tui->sweep->words);
            tui->sweep->panel = -1;
        }
    }
    return tui->sweep;
}

void thud_tui_sweep_typed(struct thud_tui *tui, const char *text)
{
    struct thud_sweep_state *s = state(tui);
    size_t size;
    if (!s)
        return;
    char *word = word_of(s, s->typed, &size);
    snprintf(word, size, "%s", text);
}

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
    struct thud_sweep_state *s = state(tui);
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
    struct thud_sweep_state *s = state(tui);
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

static int draw_progress(struct thud_tui *tui, struct thud_sweep_state *s, const struct thud_pane *pane, int y)
{
    struct thud_sweep_work *work = &s->work;
    if (work->points == 0) {
        thud_field_note(pane, y, "r runs the study");
        return y + 1;
    }
    const char *how = work->running ? "running, Esc stops" : work->complete ? "done" : "stopped: what is done stays";
    thud_pane_print(pane, 1, y++, thud_look(THUD_ROLE_PLAIN, THUD_BOLD), "%s", how);
    thud_field_note(pane, y++, "%ld of %ld points", work->next, work->points);
    thud_field_note(pane, y++, "%ld runs made, %ld answered", work->total.made, work->total.free);
    thud_field_note(pane, y++, "  without one (no contact)");
    if (work->total.impossible)
        thud_field_note(pane, y++, "%ld not possible (bumper > gap)", work->total.impossible);
    if (work->total.diverged)
        thud_pane_print(pane, 1, y++, thud_look(THUD_ROLE_ERROR, THUD_BOLD), "%ld FAILED", work->total.diverged);
    if (s->revision != tui->doc.revision) {
        thud_pane_put(pane, 1, y++, thud_look(THUD_ROLE_WARN, THUD_BOLD), "! of the scene before edits");
        thud_field_note(pane, y++, "r runs it again");
    }
    return y;
}

static int draw_form(struct thud_tui *tui, const struct thud_pane *pane)
{
    struct thud_sweep_state *s = state(tui);
    int y = 0;
    for (int i = 0; s && i < WORDS; i++) {
        char key[32], text[600];
        size_t size;
        const char *word = word_of(s, i, &size);
        snprintf(key, sizeof key, "study %d", i);
        thud_pane_put(pane, 1, y++, thud_look(THUD_ROLE_MUTED, 0), word_name[i]);
        snprintf(text, sizeof text, " %s", *word ? word : i == RECORDS ? "(the scene's own)" : "-");
        thud_field_line(tui, FORM, pane, y++, i, key, text);
    }
    return s ? draw_progress(tui, s, pane, y + 1) : y;
}

/* All panels in their grid, or one of them. */
static void draw_figure(const struct thud_pane *pane, const struct thud_figure *figure, int only)
{
    struct thud_chart chart = {.cursor = NAN};
    int count = figure->rows * figure->columns;
    if (only < 0 && count > 1 && (pane->w / figure->columns < 34 || pane->h / figure->rows < 9))
        only = 0; /* too little room for all of them */
    for (int i = 0; i < count; i++) {
        int row = i / figure->columns, column = i % figure->columns;
        struct thud_pane part = *pane;
        if (!figure->panel[i].used || (only >= 0 && only != i))
            continue;
        if (only < 0) {
            int x = column * pane->w / figure->columns, y = row * pane->h / figure->rows;
            part = thud_pane_inside(pane, x, y, (column + 1) * pane->w / figure->columns - x,
                                    (row + 1) * pane->h / figure->rows - y);
        }
        thud_chart_draw(&part, &figure->panel[i], &chart);
    }
}

static int draw(struct thud_tui *tui, int index, struct thud_pane *pane)
{
    struct thud_sweep_state *s = state(tui);
    if (index == FORM || !s)
        return draw_form(tui, pane);
    refresh(tui);
    if (s->shown)
        draw_figure(pane, s->shown, s->panel);
    else
        thud_field_note(pane, 0, s->work.points ? "nothing to show yet" : "r runs the study");
    return pane->h;
}

static void start(struct thud_tui *tui)
{
    struct thud_sweep_state *s = state(tui);
    struct thud_error err;
    if (!s)
        return;
    thud_figure_free(s->shown);
    s->shown = NULL;
    s->panel = -1;
    if (thud_sweep_work_start(&s->work, &tui->doc.scene, &s->words, tui->doc.paths, tui->doc.path, &err) != THUD_OK)
        thud_tui_say_error(tui, &err);
    s->revision = tui->doc.revision;
}

static bool act(struct thud_tui *tui, enum thud_action action)
{
    struct thud_sweep_state *s = state(tui);
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

static void row(struct thud_tui *tui, const struct thud_field *field)
{
    struct thud_sweep_state *s = state(tui);
    size_t size;
    if (!s)
        return;
    s->typed = field->index;
    snprintf(tui->target, sizeof tui->target, "%s: ", word_name[field->index]);
    static const char *const example[WORDS] = {
        "KEY=FROM:TO:STEP or KEY=V1,V2,...: gap=5 cm:25 cm:1 cm", "a second key, for a grid; empty: none",
        "of none, bumper, cavity, as-written, with commas", "files with commas; empty: the scene's own"};
    thud_tui_say(tui, THUD_ROLE_PLAIN, "%s", example[field->index]);
    thud_tui_prompt(tui, THUD_TYPE_STUDY, word_of(s, field->index, &size));
}

static const struct thud_figure *figure(struct thud_tui *tui)
{
    refresh(tui);
    return tui->sweep ? tui->sweep->shown : NULL;
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

static void pictures(struct thud_tui *tui)
{
    struct thud_error err;
    if (!tui->sweep || tui->sweep->work.rows.table.nrows == 0)
        thud_tui_say(tui, THUD_ROLE_WARN, "There is no study yet: r runs it");
    else if (thud_sweep_figures_save(&tui->sweep->work.rows.table, thud_tui_folder(tui), NULL, &err) != THUD_OK)
        thud_tui_say_error(tui, &err);
    else
        thud_tui_say(tui, THUD_ROLE_GOOD, "Written all figures of the study into %s", thud_tui_folder(tui));
}

static void export_csv(struct thud_tui *tui)
{
    struct thud_error err;
    enum thud_status status = thud_folder_make(thud_tui_folder(tui), &err);
    for (int i = 0; i < THUD_SWEEP_CSVS && status == THUD_OK; i++) {
        char path[600];
        const struct thud_text *csv = &tui->sweep->work.csv[i];
        snprintf(path, sizeof path, "%s/%s", thud_tui_folder(tui), thud_sweep_csv_name((enum thud_sweep_csv)i));
        status = csv->failed ? thud_error_set(&err, THUD_MEMORY, "no memory for %s", path)
                             : thud_file_write(path, csv->data, csv->size, &err);
    }
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

const struct thud_view thud_view_sweep = {
    .title = "Sweep",
    .where = THUD_AT_SWEEP,
    .layout = layout,
    .draw = draw,
    .pane_title = pane_title,
    .act = act,
    .cannot = cannot,
    .row = row,
    .figure = figure,
    .busy = busy,
    .work = work,
    .progress = progress,
    .pictures = pictures,
    .export_csv = export_csv,
    .free = release,
};
