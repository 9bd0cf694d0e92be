/* Sweep: one or two parameters, records, cases; the figures fill as the study runs. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/file.h"
#include "plot/figures_sweep.h"
#include "tui/chart.h"
#include "tui/field.h"
#include "tui/sweep_work.h"

enum { FORM, CHART };
enum { CASES = THUD_VARY_MAX, RECORDS, SENSITIVITY, WORDS };

struct thud_sweep_state {
    struct thud_study_words words;  /* as shown and run */
    struct thud_study_choice study; /* the scene's, when the words were taken from it */
    struct thud_study_words ran;    /* what the study on show was made with */
    struct thud_sweep_work work;
    unsigned long revision; /* of the scene the study was made with */
    int figure, panel;      /* which is shown; panel -1: all */
    struct thud_figure *shown;
    size_t shown_rows;
    int shown_figure;
    int typed; /* the line being typed */
};

static const char *word_name(int index)
{
    static const char *const last[] = {"cases", "records", "sensitivity"};
    return index == 0 ? "vary" : index < CASES ? "vary too" : last[index - CASES];
}

static char *word_of(struct thud_study_words *words, int index, size_t *size)
{
    switch (index) {
    case CASES:
        *size = sizeof words->cases;
        return words->cases;
    case RECORDS:
        *size = sizeof words->records;
        return words->records;
    case SENSITIVITY:
        *size = sizeof words->sensitivity;
        return words->sensitivity;
    default:
        *size = sizeof words->vary[0];
        return words->vary[index];
    }
}

/* The words follow the scene's study, also when that is undone. */
static struct thud_sweep_state *state(struct thud_tui *tui)
{
    const struct thud_study_choice *study = &tui->doc.scene.study;
    bool first = !tui->sweep;
    if (first)
        tui->sweep = calloc(1, sizeof *tui->sweep);
    if (tui->sweep && (first || memcmp(&tui->sweep->study, study, sizeof *study) != 0)) {
        tui->sweep->study = *study;
        thud_study_words_of(&tui->doc.scene, &tui->sweep->words);
    }
    if (tui->sweep && first)
        tui->sweep->panel = -1;
    return tui->sweep;
}

/* Axes behind one that was emptied move up. */
static void close_up(struct thud_study_words *words)
{
    for (int i = 0, n = 0; i < THUD_VARY_MAX; i++) {
        if (!*words->vary[i])
            continue;
        if (i != n) {
            memcpy(words->vary[n], words->vary[i], sizeof words->vary[n]);
            words->vary[i][0] = '\0';
        }
        n++;
    }
}

/* Refused words stay in the prompt. Those that a preset can say become its study, to be saved with it. */
void thud_tui_sweep_typed(struct thud_tui *tui, const char *text)
{
    struct thud_sweep_state *s = state(tui);
    size_t size;
    if (!s)
        return;
    struct thud_study_words words = s->words;
    struct thud_scene next = tui->doc.scene;
    struct thud_error err = {0};
    char *word = word_of(&words, s->typed, &size), what[200];
    snprintf(word, size, "%s", text);
    close_up(&words);
    snprintf(what, sizeof what, "study: %s %.120s", word_name(s->typed), *text ? text : "(none)");
    enum thud_status status = s->typed == RECORDS ? THUD_OK : thud_study_words_keep(&words, &next, &err);
    if (status == THUD_OK)
        status = thud_doc_change(&tui->doc, &next, what, &err);
    if (status != THUD_OK) {
        thud_tui_say_error(tui, &err);
        thud_tui_prompt(tui, THUD_TYPE_STUDY, text);
        return;
    }
    s->words = words;
    s->study = tui->doc.scene.study;
    if (!thud_study_words_fit(&words))
        thud_tui_say(tui, THUD_ROLE_WARN, "r runs it; a preset keeps ranges, no lists of values: w does not save this");
}

void thud_tui_sweep_word(struct thud_tui *tui, const char *word, const char *text)
{
    struct thud_sweep_state *s = state(tui);
    for (int i = 0; s && i < WORDS; i++)
        if (strcmp(word_name(i), word) == 0) {
            s->typed = i;
            snprintf(tui->target, sizeof tui->target, "%s: ", word);
            thud_tui_sweep_typed(tui, text);
            return;
        }
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

static bool same_words(struct thud_study_words *a, struct thud_study_words *b)
{
    size_t size;
    for (int i = 0; i < WORDS; i++)
        if (strcmp(word_of(a, i, &size), word_of(b, i, &size)) != 0)
            return false;
    return true;
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
    bool scene = s->revision == tui->doc.revision, words = same_words(&s->words, &s->ran);
    if (!scene || !words) {
        thud_pane_put(pane, 1, y++, thud_look(THUD_ROLE_WARN, THUD_BOLD),
                      scene ? "! of the study before edits" : "! of the scene before edits");
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
        const char *word = word_of(&s->words, i, &size);
        if (i >= 2 && i < CASES && !*word && !*s->words.vary[i - 1])
            continue; /* one empty line for one more key is enough */
        snprintf(key, sizeof key, "study %d", i);
        thud_pane_put(pane, 1, y++, thud_look(THUD_ROLE_MUTED, 0), word_name(i));
        snprintf(text, sizeof text, " %s",
                 *word          ? word
                 : i == RECORDS ? "(the scene's own)"
                 : i == CASES   ? "(as written)"
                                : "-");
        thud_field_line(tui, FORM, pane, y++, i, key, text);
    }
    return s ? draw_progress(tui, s, pane, y + 1) : y;
}

static int draw(struct thud_tui *tui, int index, struct thud_pane *pane)
{
    struct thud_sweep_state *s = state(tui);
    if (index == FORM || !s)
        return draw_form(tui, pane);
    refresh(tui);
    if (s->shown)
        thud_chart_figure(pane, s->shown, s->panel);
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
    s->ran = s->words;
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
    snprintf(tui->target, sizeof tui->target, "%s: ", word_name(field->index));
    thud_tui_say(tui, THUD_ROLE_PLAIN, "%s",
                 field->index == 0             ? "KEY=FROM:TO:STEP or KEY=V1,V2,...: gap=5 cm:25 cm:1 cm"
                 : field->index < CASES        ? "one more key, for a grid; empty: none"
                 : field->index == RECORDS     ? "files with commas; empty: the scene's own"
                 : field->index == SENSITIVITY ? "spread when gap, motion, stiffness change by this: 0.1 %; empty: none"
                                               : "of none, bumper, cavity, as-written, with commas");
    thud_tui_prompt(tui, THUD_TYPE_STUDY, word_of(&s->words, field->index, &size));
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

THUD_VIEW(sweep, "Sweep", SWEEP, .act = act, .cannot = cannot, .row = row, .figure = figure, .busy = busy, .work = work,
          .progress = progress, .pictures = pictures, .export_csv = export_csv, .free = release);
