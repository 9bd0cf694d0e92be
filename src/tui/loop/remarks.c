/* Remarks on the scene as written, and what its result rests on: a list that leads to the fields. */
#include <stdio.h>
#include <string.h>

#include "plot/figures/figures_run.h"
#include "study/sweep/remark.h"
#include "tui/loop/loop.h"

/* Of the case as written. */
static const struct thud_result *own_result(const struct thud_tui *tui)
{
    bool current = !tui->run.live.running && tui->run.revision == tui->doc.revision;
    return current ? thud_live_result(&tui->run.live, thud_live_written(&tui->run.live)) : NULL;
}

/* None without a result. */
static struct thud_remarks find(const struct thud_tui *tui)
{
    struct thud_remark_scope scope = {.scene = &tui->doc.scene, .result = own_result(tui)};
    const struct thud_record *record = tui->doc.record;
    scope.record = &record;
    scope.nrecords = record != NULL;
    if (scope.result)
        scope.impact = thud_run_impacts(tui->run.live.which[thud_live_written(&tui->run.live)].run, &scope.nimpacts);
    return thud_remarks_find(
        &scope, scope.result ? THUD_REMARK_RESULT | THUD_REMARK_MOTIONS | THUD_REMARK_COMPUTED | THUD_REMARK_SCENE : 0);
}

int thud_tui_count_remarks(const struct thud_tui *tui)
{
    struct thud_remarks found = find(tui);
    const int n = found.n;
    thud_remarks_clear(&found);
    return n;
}

/* Lines of the list, all of which lead to the same field. */
static void add(struct thud_tui *tui, const char *key, const char *text)
{
    enum { COLUMNS = 72 };
    for (int line = 0; *text; line++) {
        size_t n = strlen(text), room = COLUMNS - (line > 0 ? 2 : 0);
        if (n > room)
            for (n = room; n > 1 && text[n] != ' ';)
                n--;
        thud_chooser_add(&tui->dialog.chooser, key, "%s%.*s", line > 0 ? "  " : "", (int)n, text);
        text += n;
        text += strspn(text, " ");
    }
}

const char *thud_tui_cannot_list_remarks(const struct thud_tui *tui)
{
    return own_result(tui) ? NULL : "There are no results yet: r runs";
}

void thud_tui_list_remarks(struct thud_tui *tui)
{
    const struct thud_result *result = own_result(tui);
    char text[900], title[96];
    if (!result)
        return;
    struct thud_remarks found = find(tui);
    const int n = found.n;
    snprintf(title, sizeof title, "%d remark%s, %s; Enter goes to the field", n, n == 1 ? "" : "s",
             thud_tui_case_name(tui, thud_live_written(&tui->run.live)));
    thud_tui_choose(tui, thud_tui_go_to_field, title);
    for (int i = 0; i < n; i++) {
        const struct thud_error *said = &found.item[i].said;
        snprintf(text, sizeof text, "! %s%s%s%s", said->what, *said->allowed ? " (" : "", said->allowed,
                 *said->allowed ? ")" : "");
        add(tui, *said->key ? said->key : "record.file", text);
    }
    thud_remarks_clear(&found);
    const struct thud_energy *e = &result->energy;
    const struct thud_shown_unit shown = thud_shown_energy(e->input_j + e->initial_j);
    char a[24], b[24], c[24];
    snprintf(text, sizeof text, "energy: input %s %s, damping %s, contact %s; unaccounted for %.1e of the largest",
             thud_tui_number(shown.factor * (e->input_j + e->initial_j), a), shown.unit,
             thud_tui_number(shown.factor * e->viscous_j, b), thud_tui_number(shown.factor * e->contact_j, c),
             e->error_ratio);
    add(tui, "analysis.tolerance", text);
    char tolerance[96] = "";
    thud_scene_get(&tui->doc.scene, "analysis.tolerance", tolerance, sizeof tolerance, NULL);
    snprintf(text, sizeof text, "tolerance: %s, method %s, %ld steps, %ld events", tolerance,
             result->method ? result->method : "?", result->work.steps, result->work.events);
    add(tui, "analysis.tolerance", text);
    if (*tui->doc.scene.record.file)
        add(tui, "record.sign",
            tui->doc.scene.record.sign < 0
                ? "sign: -, the ground motion in reversed polarity; it may be worse as recorded"
                : "sign: +, the ground motion as recorded; reversed polarity may be worse");
}
