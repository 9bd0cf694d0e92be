/* Which value of the field under the cursor makes something hold, under the scene's own ground motion. */
#include "app/sweep/solve.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tui/document/form_over.h"
#include "tui/document/session_log.h"
#include "tui/loop/loop.h"

/* `value` is "KEY=VALUE". */
static void set_value(struct thud_tui *tui, const char *value)
{
    char key[sizeof tui->dialog.target];
    snprintf(key, sizeof key, "%s", value);
    char *equals = strchr(key, '=');
    if (equals) {
        *equals = '\0';
        thud_tui_set(tui, key, equals + 1);
    }
}

/* "CRITERION; KEY=FROM:TO", which is cut; `ask`: before the value is taken. */
static void solve(struct thud_tui *tui, char *what, bool ask)
{
    static const struct thud_question question = {.enter = true, .yes = set_value};
    char value[sizeof tui->dialog.target];
    struct thud_error err = {0};
    struct thud_criterion criterion;
    struct thud_record_list one = {0};
    struct thud_text words = {0};
    const struct thud_record *record = NULL;
    char *by = strchr(what, ';');
    if (!by) {
        thud_tui_say(tui, THUD_ROLE_ERROR, "! what has to hold; and the range: force < 10 MN; gap=2 cm:20 cm");
        return;
    }
    *by++ = '\0';
    for (size_t n = strlen(what); n > 0 && what[n - 1] == ' '; n--)
        what[n - 1] = '\0';
    by += strspn(by, " ");
    struct thud_solve *found = malloc(sizeof *found);
    enum thud_status status =
        found ? thud_criterion_parse(what, &criterion, &err) : thud_error_set(&err, THUD_MEMORY, "no memory to solve");
    if (status == THUD_OK)
        status = thud_doc_record(&tui->doc, &record, &err);
    one.n = record != NULL;
    one.record = (struct thud_record **)&tui->doc.record;
    if (status == THUD_OK)
        status = thud_solve_run(&tui->doc.scene, &one, by, &criterion, 1.0, NULL, found, &err);
    const struct thud_tried_row *answer = status == THUD_OK ? thud_solve_answer(found) : NULL;
    if (status == THUD_OK)
        thud_solve_words(found, &words);
    if (words.data)
        words.data[words.size - 1] = '\0';
    for (char *c = words.data; c && *c; c++)
        *c = *c == '\n' ? ';' : *c;
    if (answer)
        snprintf(value, sizeof value, "%s=%s", found->key, answer->value);
    if (status != THUD_OK)
        thud_tui_say_error(tui, &err);
    else if (answer && ask)
        thud_tui_ask(tui, &question, value, "%s. Enter takes it", words.data ? words.data : "");
    else {
        if (answer)
            set_value(tui, value);
        thud_tui_log(tui, "solve %s; %s", what, by);
        thud_tui_say(tui, answer ? THUD_ROLE_GOOD : THUD_ROLE_WARN, "%s", words.data ? words.data : "");
    }
    thud_text_clear(&words);
    free(found);
}

void thud_tui_solve(struct thud_tui *tui, char *text)
{
    solve(tui, text, false);
}

/* What has to hold, and the range of the field. */
enum { GOAL, FROM, TO };

static void ask(struct thud_tui *tui, struct thud_form_over *form)
{
    char text[THUD_LINE_MAX];
    snprintf(text, sizeof text, "%.120s; %.120s=%.60s:%.60s", form->row[GOAL].value[0].text, form->title,
             form->row[FROM].value[0].text, form->row[TO].value[0].text);
    thud_tui_normal(tui);
    solve(tui, text, true);
}

static const char *goal(const struct thud_over_row *row, int i)
{
    static const char *const goals[] = {"force < 10 MN", "acceleration < 1 g", "drift < 1 %",
                                        "ductility < 2", "no pounding",        NULL};
    (void)row;
    return goals[i];
}

/* Proposes a third to three times of the value. */
void thud_tui_solve_field(struct thud_tui *tui)
{
    const struct thud_field *field = thud_form_focus(&tui->form);
    char text[128] = "", bound[64];
    const char *unit = text;
    double value = 1.0;
    struct thud_form_over *form = field ? thud_form_over_begin(tui) : NULL;
    if (!form)
        return;
    thud_scene_get(&tui->doc.scene, field->path, text, sizeof text, NULL);
    thud_number_parse(text, &unit, &value);
    snprintf(form->title, sizeof form->title, "%s", field->path);
    thud_form_over_add(form, "has to hold", "Space: the next of these; or another value, as force < 5 MN. Enter solves",
                       goal(NULL, 0))
        ->choice = goal;
    for (int to = 0; to < 2; to++) {
        snprintf(bound, sizeof bound, "%.3g%s", to ? 3 * value : value / 3, unit);
        thud_form_over_add(form, to ? "up to" : "looked for from", "Of the value that is looked for, with its unit",
                           bound);
    }
    form->done = ask;
    thud_form_over_focus(form, GOAL, 0);
}
