/* The form of the Sweep screen: the study in words, and how far it has come. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tui/document/field.h"
#include "tui/document/session_log.h"
#include "tui/screens/sweep_screen.h"

enum { CASES = THUD_VARY_MAX, RECORDS, SIGNS, EVENTS, SENSITIVITY, WORDS };

static const char *word_name(int index)
{
    static const char *const last[] = {"cases", "records", "signs", "events", "sensitivity"};
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
    case SIGNS:
        *size = sizeof words->signs;
        return words->signs;
    case EVENTS:
        *size = sizeof words->events;
        return words->events;
    case SENSITIVITY:
        *size = sizeof words->sensitivity;
        return words->sensitivity;
    default:
        *size = sizeof words->vary[0];
        return words->vary[index];
    }
}

/* The words follow the scene's study, also when that is undone. */
struct thud_sweep_state *thud_sweep_state(const struct thud_tui *tui)
{
    struct thud_sweep_state *s = tui->own[THUD_SCREEN_SWEEP];
    const struct thud_study_choice *study = &tui->doc.scene.study;
    if (memcmp(&s->study, study, sizeof *study) != 0) {
        s->study = *study;
        thud_study_words_of(&tui->doc.scene, &s->words);
    }
    return s;
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

static enum thud_status check(const struct thud_study_words *words, struct thud_error *err)
{
    struct thud_event event[THUD_EVENTS_MAX];
    int n;
    if (*words->signs && strcmp(words->signs, "both") != 0)
        return thud_error_set(err, THUD_USAGE, "signs: both, or nothing");
    return thud_events_parse(words->events, event, &n, err);
}

static void typed(struct thud_tui *tui, const char *text);
static const struct thud_prompt prompt = {.done = typed};

/* Refused words stay in the prompt. The others become the preset's study, to be saved with it. */
static void typed(struct thud_tui *tui, const char *text)
{
    struct thud_sweep_state *s = thud_sweep_state(tui);
    size_t size;
    struct thud_study_words words = s->words;
    struct thud_scene next = tui->doc.scene;
    struct thud_error err = {0};
    char *word = word_of(&words, s->typed, &size), what[200];
    bool kept = true;
    if (s->typed == RECORDS || s->typed == EVENTS)
        thud_study_close_commas(text, word, size);
    else
        snprintf(word, size, "%s", text);
    close_up(&words);
    snprintf(what, sizeof what, "study: %s %.120s", word_name(s->typed), *text ? text : "(none)");
    enum thud_status status = check(&words, &err);
    if (status == THUD_OK)
        status = thud_study_words_keep(&words, &next, &kept, &err);
    if (status == THUD_OK)
        status = thud_doc_change(&tui->doc, &next, what, &err);
    if (status != THUD_OK) {
        thud_tui_say_error(tui, &err);
        thud_tui_prompt(tui, &prompt, text);
        return;
    }
    s->words = words;
    s->study = tui->doc.scene.study;
    if (s->typed > 0 && s->typed < CASES)
        thud_tui_log(tui, "vary%d %s", s->typed + 1, text);
    else
        thud_tui_log(tui, "%s %s", word_name(s->typed), text);
    if (!kept)
        thud_tui_say(tui, THUD_ROLE_WARN, "r runs it; a preset has no room for so many values: w does not save this");
}

void thud_sweep_offer(struct thud_tui *tui)
{
    size_t size;
    for (int i = 0; i < WORDS; i++) {
        struct thud_field line = {.index = i};
        char command[32];
        snprintf(command, sizeof command, "line %d", i);
        thud_tui_offer(tui, THUD_SCREEN_SWEEP, command, "study %-11s %s  %s", word_name(i),
                       word_of(&thud_sweep_state(tui)->words, i, &size), thud_sweep_form_hint(&line));
    }
}

void thud_sweep_command(struct thud_tui *tui, const char *word, const char *rest)
{
    if (strcmp(word, "line") == 0)
        thud_sweep_form_row(tui, &(struct thud_field){.index = atoi(rest)});
    for (int i = 0; i < WORDS; i++)
        if (i > 0 && i < CASES ? strncmp(word, "vary", 4) == 0 && word[4] == '1' + i
                               : strcmp(word_name(i), word) == 0) {
            thud_sweep_state(tui)->typed = i;
            snprintf(tui->dialog.target, sizeof tui->dialog.target, "%s: ", word);
            typed(tui, rest);
            return;
        }
}

static bool same_words(struct thud_study_words *a, struct thud_study_words *b)
{
    size_t size;
    for (int i = 0; i < WORDS; i++)
        if (strcmp(word_of(a, i, &size), word_of(b, i, &size)) != 0)
            return false;
    return true;
}

/* Varied keys at the first of the plan's values. */
static bool same_scene(const struct thud_tui *tui, const struct thud_sweep_state *s)
{
    struct thud_scene *now = malloc(sizeof *now);
    bool same = false;
    if (now) {
        *now = tui->doc.scene;
        for (int i = 0; i < s->data.plan.naxes; i++)
            thud_scene_set(now, s->data.plan.axis[i].key, s->data.plan.axis[i].text[0], NULL);
        same = thud_doc_runs_alike(now, s->base);
    }
    free(now);
    return same;
}

bool thud_sweep_current(struct thud_tui *tui, struct thud_sweep_state *s)
{
    if (!s->base || !same_words(&s->words, &s->ran))
        return false;
    if (s->revision != tui->doc.revision) {
        s->current = s->data.points > 0 && same_scene(tui, s);
        s->revision = tui->doc.revision;
    }
    return s->current;
}

static int draw_progress(struct thud_tui *tui, struct thud_sweep_state *s, const struct thud_pane *pane, int y)
{
    struct thud_sweep_data *data = &s->data;
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
    thud_field_note(pane, y++, "%ld runs made, %ld answered", data->total.made, data->total.free);
    thud_field_note(pane, y++, "  without one (no contact)");
    if (data->total.reused)
        thud_field_note(pane, y++, "%ld the same as another", data->total.reused);
    if (data->total.impossible)
        thud_field_note(pane, y++, "%ld not possible (bumper > gap)", data->total.impossible);
    if (data->total.diverged)
        thud_pane_print(pane, 1, y++, thud_look(THUD_ROLE_ERROR, THUD_BOLD), "%ld FAILED", data->total.diverged);
    bool words = same_words(&s->words, &s->ran);
    if (!thud_sweep_current(tui, s)) {
        thud_pane_put(pane, 1, y++, thud_look(THUD_ROLE_WARN, THUD_BOLD),
                      words ? "! of the scene before edits" : "! of the study before edits");
        thud_field_note(pane, y++, "r runs it again");
    }
    return y;
}

/* A line of the form that is left out now: one empty line for one more key is enough, and what is asked of several
 * motions has no place with one. */
static bool left_out(struct thud_study_words *words, int i)
{
    size_t size;
    const char *word = word_of(words, i, &size);
    if (*word)
        return false;
    return i >= 2 && i < CASES ? !*words->vary[i - 1] : (i == SIGNS || i == EVENTS) && !*words->records;
}

int thud_sweep_form_draw(struct thud_tui *tui, int index, const struct thud_pane *pane)
{
    struct thud_sweep_state *s = thud_sweep_state(tui);
    int y = 0;
    for (int i = 0; i < WORDS; i++) {
        char key[32], text[THUD_VARY_TEXT + 32];
        size_t size;
        const char *word = word_of(&s->words, i, &size), *none = i == RECORDS  ? "(the scene's own)"
                                                                 : i == CASES  ? "(as written)"
                                                                 : i == EVENTS ? "pounding,worse"
                                                                               : "-";
        if (left_out(&s->words, i))
            continue;
        snprintf(key, sizeof key, "study %d", i);
        if (i < CASES) {
            thud_pane_put(pane, 1, y++, thud_look(THUD_ROLE_MUTED, 0), word_name(i));
            snprintf(text, sizeof text, " %s", *word ? word : none);
        } else {
            snprintf(text, sizeof text, "%-8s %s", i == SENSITIVITY ? "spread" : word_name(i), *word ? word : none);
        }
        thud_field_line(tui, index, pane, y++, i, key, text);
    }
    return draw_progress(tui, s, pane, y + 1);
}

const char *thud_sweep_form_hint(const struct thud_field *field)
{
    return field->index == 0             ? "KEY=FROM:TO:STEP or KEY=V1,V2,...: gap=5 cm:25 cm:1 cm"
           : field->index < CASES        ? "one more key, for a grid; empty: none"
           : field->index == RECORDS     ? "files, folders, lists with commas, :peak=0.5g behind; empty: own"
           : field->index == SIGNS       ? "both: each motion also in reversed polarity; empty: as given"
           : field->index == EVENTS      ? "pounding, worse, force:5 MN, acceleration:1 g, drift:1 %"
           : field->index == SENSITIVITY ? "spread when gap, motion, stiffness change by this: 0.1 %; empty: none"
                                         : "of none, bumper, cavity, link, as-written, with commas";
}

void thud_sweep_form_row(struct thud_tui *tui, const struct thud_field *field)
{
    struct thud_sweep_state *s = thud_sweep_state(tui);
    size_t size;
    s->typed = field->index;
    snprintf(tui->dialog.target, sizeof tui->dialog.target, "%s: ", word_name(field->index));
    thud_tui_say(tui, THUD_ROLE_PLAIN, "%s", thud_sweep_form_hint(field));
    thud_tui_prompt(tui, &prompt, word_of(&s->words, field->index, &size));
}
