/* The form of the Sweep screen: the study in words, and how far it has come. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tui/field.h"
#include "tui/sweep_screen.h"

enum { CASES = THUD_VARY_MAX, RECORDS, SENSITIVITY, WORDS };

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
struct thud_sweep_state *thud_sweep_state(struct thud_tui *tui)
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
    struct thud_sweep_state *s = thud_sweep_state(tui);
    size_t size;
    if (!s)
        return;
    struct thud_study_words words = s->words;
    struct thud_scene next = tui->doc.scene;
    struct thud_error err = {0};
    char *word = word_of(&words, s->typed, &size), what[200];
    bool kept = true;
    snprintf(word, size, "%s", text);
    close_up(&words);
    snprintf(what, sizeof what, "study: %s %.120s", word_name(s->typed), *text ? text : "(none)");
    enum thud_status status = s->typed == RECORDS ? THUD_OK : thud_study_words_keep(&words, &next, &kept, &err);
    if (status == THUD_OK)
        status = thud_doc_change(&tui->doc, &next, what, &err);
    if (status != THUD_OK) {
        thud_tui_say_error(tui, &err);
        thud_tui_prompt(tui, THUD_TYPE_STUDY, text);
        return;
    }
    s->words = words;
    s->study = tui->doc.scene.study;
    if (!kept)
        thud_tui_say(tui, THUD_ROLE_WARN, "r runs it; a preset has no room for so many values: w does not save this");
}

void thud_tui_sweep_word(struct thud_tui *tui, const char *word, const char *text)
{
    struct thud_sweep_state *s = thud_sweep_state(tui);
    for (int i = 0; s && i < WORDS; i++)
        if (strcmp(word_name(i), word) == 0) {
            s->typed = i;
            snprintf(tui->target, sizeof tui->target, "%s: ", word);
            thud_tui_sweep_typed(tui, text);
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
    if (work->total.reused)
        thud_field_note(pane, y++, "%ld shared: they have no bumper", work->total.reused);
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

int thud_sweep_form_draw(struct thud_tui *tui, int index, const struct thud_pane *pane)
{
    struct thud_sweep_state *s = thud_sweep_state(tui);
    int y = 0;
    for (int i = 0; s && i < WORDS; i++) {
        char key[32], text[THUD_VARY_TEXT + 8];
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
        thud_field_line(tui, index, pane, y++, i, key, text);
    }
    return s ? draw_progress(tui, s, pane, y + 1) : y;
}

void thud_sweep_form_row(struct thud_tui *tui, const struct thud_field *field)
{
    struct thud_sweep_state *s = thud_sweep_state(tui);
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
