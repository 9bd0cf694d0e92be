/* The form of the Sweep screen: the study in words, and how far it has come. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "app/sweep/study_keys.h"
#include "tui/document/field.h"
#include "tui/document/form_over.h"
#include "tui/document/session_log.h"
#include "tui/screens/sweep_screen.h"

struct thud_sweep_state *thud_sweep_state(const struct thud_tui *tui)
{
    return tui->own[THUD_SCREEN_SWEEP];
}

static const char *name_of(int index)
{
    return index == 0 ? "vary" : "vary too";
}

/* The varied keys become the preset's study, to be saved with it; false: they were refused. */
static bool keep(struct thud_tui *tui, char vary[THUD_VARY_MAX][THUD_VARY_TEXT])
{
    struct thud_scene next = tui->doc.scene;
    struct thud_error err = {0};
    char words[THUD_VARY_MAX * (THUD_VARY_TEXT + 2)] = "vary", what[200];
    for (int i = 0; i < THUD_VARY_MAX; i++)
        if (*vary[i])
            thud_append(words, sizeof words, "%s%s", words[4] ? "; " : " ", vary[i]);
    snprintf(what, sizeof what, "study: %.180s", words);
    enum thud_status status = thud_study_vary_keep(vary, &next, &err);
    if (status == THUD_OK)
        status = thud_doc_change(&tui->doc, &next, what, &err);
    if (!thud_tui_succeeded(tui, status, &err))
        return false;
    thud_tui_log(tui, "%s", words);
    return true;
}

/* "vary KEY=...; KEY=...": all of them together, as from the form. */
void thud_sweep_command(struct thud_tui *tui, const char *word, const char *rest)
{
    char vary[THUD_VARY_MAX][THUD_VARY_TEXT] = {""};
    (void)word;
    for (int i = 0; i < THUD_VARY_MAX && *rest; i++) {
        const size_t n = i + 1 < THUD_VARY_MAX ? strcspn(rest, ";") : strlen(rest);
        snprintf(vary[i], sizeof vary[i], "%.*s", (int)n, rest);
        rest += n;
        rest += strspn(rest, "; ");
    }
    keep(tui, vary);
}

/* Varied keys at the first of the plan's values. */
static bool same_scene(const struct thud_tui *tui, const struct thud_sweep_state *s)
{
    struct thud_scene now = tui->doc.scene;
    for (int i = 0; i < s->data.plan.naxes; i++)
        thud_scene_set(&now, s->data.plan.axis[i].key, s->data.plan.axis[i].text[0], NULL);
    return thud_doc_runs_alike(&now, s->base);
}

bool thud_sweep_current(struct thud_tui *tui, struct thud_sweep_state *s)
{
    if (!s->base || memcmp(&s->study, &tui->doc.scene.study, sizeof s->study) != 0)
        return false;
    if (s->revision != tui->doc.revision) {
        s->current = s->data.points > 0 && same_scene(tui, s);
        s->revision = tui->doc.revision;
    }
    return s->current;
}

static int draw_progress(struct thud_tui *tui, struct thud_sweep_state *s, const struct thud_pane *pane, int y)
{
    struct thud_live_study *data = &s->data;
    if (*s->why)
        y += thud_pane_wrap(pane, 1, y, pane->w - 2, thud_look(THUD_ROLE_WARN, THUD_BOLD), s->why);
    if (data->points == 0 && !*s->why)
        thud_field_note(pane, y++, "r runs the study");
    if (data->points == 0 || (*s->why && data->next == 0)) /* it waits to be asked for, or cannot begin */
        return y;
    const char *how = data->running ? "running, Esc stops" : data->complete ? "done" : "stopped: what is done stays";
    thud_pane_print(pane, 1, y++, thud_look(THUD_ROLE_PLAIN, THUD_BOLD), "%s", how);
    thud_field_note(pane, y++, "%ld of %ld points", data->next, data->points);
    double took_s = tui->backend->now(tui->backend) - s->begun_s;
    if (data->running && data->next > 0 && took_s > 0.5)
        thud_field_note(pane, y++, "%.3g a second, %.0f s left", (double)data->next / took_s,
                        ceil(took_s * (double)(data->points - data->next) / (double)data->next));
    if (data->records.n > 1)
        thud_field_note(pane, y++, "%d ground motions", data->records.n);
    if (data->records.skipped > 0)
        thud_pane_print(pane, 1, y++, thud_look(THUD_ROLE_WARN, 0), "%d files skipped", data->records.skipped);
    thud_field_note(pane, y++, "%ld runs made, %ld answered", data->out.total.made, data->out.total.free);
    thud_field_note(pane, y++, "  without one (no contact)");
    if (data->out.total.reused)
        thud_field_note(pane, y++, "%ld the same as another", data->out.total.reused);
    if (data->out.total.impossible)
        thud_field_note(pane, y++, "%ld not possible (bumper > gap)", data->out.total.impossible);
    if (data->out.total.diverged)
        thud_pane_print(pane, 1, y++, thud_look(THUD_ROLE_ERROR, THUD_BOLD), "%ld FAILED", data->out.total.diverged);
    const bool words = memcmp(&s->study, &tui->doc.scene.study, sizeof s->study) == 0;
    if (!thud_sweep_current(tui, s)) {
        thud_pane_put(pane, 1, y++, thud_look(THUD_ROLE_WARN, THUD_BOLD),
                      words ? "! of the scene before edits" : "! of the study before edits");
        thud_field_note(pane, y++, "r runs it again");
    }
    return y;
}

/* The keys varied, and the other keys of the preset's study; one empty line for one more key is enough, and what is
 * asked of several motions has no place with one. */
int thud_sweep_form_draw(struct thud_tui *tui, int index, const struct thud_pane *pane)
{
    static const struct thud_labelled field[] = {{"cases", "study.cases"},
                                                 {"records", "study.records"},
                                                 {"signs", "study.signs"},
                                                 {"events", "study.events"},
                                                 {"spread", "study.sensitivity"}};
    enum { LABEL = 10 };
    const struct thud_study_choice *study = &tui->doc.scene.study;
    const char *cases = thud_study_proposed_cases(&tui->doc.scene);
    char vary[THUD_VARY_MAX][THUD_VARY_TEXT];
    int y = 0;
    thud_study_vary_texts(&tui->doc.scene, vary);
    for (int i = 0; i < THUD_VARY_MAX && (i < 2 || *vary[i - 1]); i++) {
        char key[32] = "study.vary", text[THUD_VARY_TEXT + 8];
        if (i > 0)
            snprintf(key, sizeof key, "study.vary.%d", i + 1);
        snprintf(text, sizeof text, " %.*s", THUD_VARY_TEXT, *vary[i] ? vary[i] : "-");
        thud_pane_put(pane, 1, y++, thud_look(THUD_ROLE_MUTED, 0), name_of(i));
        thud_field_line(tui, index, pane, y++, i, key, text);
    }
    for (size_t i = 0; i < sizeof field / sizeof *field; i++) {
        const char *key = field[i].key + strlen("study.");
        if (!*study->records && (strcmp(key, "signs") == 0 || strcmp(key, "events") == 0) && !study->both_signs &&
            !*study->events)
            continue;
        thud_field_labelled(tui, index, pane, 1, y++, field[i].label, LABEL, pane->w - LABEL - 1, field[i].key);
    }
    if (cases)
        thud_field_note(pane, y++, "by default, cases %s", cases);
    return draw_progress(tui, thud_sweep_state(tui), pane, y + 1);
}

const char *thud_sweep_form_hint(const struct thud_field *field)
{
    return field->index == 0 ? "KEY=FROM:TO:STEP or KEY=V1,V2,...: gap=5 cm:25 cm:1 cm"
                             : "one more key, for a grid; empty: none";
}

static void done(struct thud_tui *tui, struct thud_form_over *form)
{
    char vary[THUD_VARY_MAX][THUD_VARY_TEXT];
    for (int i = 0; i < THUD_VARY_MAX; i++)
        snprintf(vary[i], sizeof vary[i], "%s", form->row[i].value[0].text);
    if (keep(tui, vary))
        thud_tui_normal(tui);
}

void thud_sweep_form_row(struct thud_tui *tui, const struct thud_field *field)
{
    char vary[THUD_VARY_MAX][THUD_VARY_TEXT];
    struct thud_form_over *form = thud_form_over_begin(tui);
    if (!form)
        return;
    thud_study_vary_texts(&tui->doc.scene, vary);
    snprintf(form->title, sizeof form->title, "Study: what is varied");
    for (int i = 0; i < THUD_VARY_MAX; i++)
        thud_form_over_add(form, name_of(i), thud_sweep_form_hint(&(struct thud_field){.index = i}), vary[i]);
    form->done = done;
    thud_form_over_focus(form, field->index, 0);
}
