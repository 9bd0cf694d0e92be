/* Remarks on the scene as written, and what its result rests on: a list that leads to the fields. */
#include <stdio.h>
#include <string.h>

#include "study/suite/scaling.h"
#include "study/sweep/remark.h"
#include "tui/loop/loop.h"

/* Of the case as written. */
static enum thud_live_which as_written(const struct thud_tui *tui)
{
    return tui->run.live.which[THUD_LIVE_BUMPER].state == THUD_LIVE_ABSENT ? THUD_LIVE_NONE : THUD_LIVE_BUMPER;
}

static const struct thud_result *own_result(const struct thud_tui *tui)
{
    bool current = !tui->run.live.running && tui->run.revision == tui->doc.revision;
    return current ? thud_live_result(&tui->run.live, as_written(tui)) : NULL;
}

/* The n-th (from 0); false when there are no more. */
static bool remark(const struct thud_tui *tui, int n, struct thud_error *out)
{
    int count;
    const struct thud_result *result = own_result(tui);
    if (!result)
        return false;
    const struct thud_impact *impact = thud_run_impacts(tui->run.live.which[as_written(tui)].run, &count);
    for (int i = 0; thud_result_remark(&tui->doc.scene, result, impact, count, i, out); i++)
        if (n-- == 0)
            return true;
    const struct thud_record *record = tui->doc.record;
    int from = 0;
    while (record && thud_suite_remark(&record, NULL, 1, &from, out))
        if (n-- == 0) {
            thud_error_key(out, "record.file");
            return true;
        }
    return false;
}

int thud_tui_count_remarks(const struct thud_tui *tui)
{
    struct thud_error out;
    int n = 0;
    while (remark(tui, n, &out))
        n++;
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
    struct thud_error out;
    char text[900], title[96];
    if (!result)
        return;
    int n = thud_tui_count_remarks(tui);
    snprintf(title, sizeof title, "%d remark%s, %s; Enter goes to the field", n, n == 1 ? "" : "s",
             thud_live_name(as_written(tui)));
    thud_tui_choose(tui, thud_tui_go_to_field, title);
    for (int i = 0; remark(tui, i, &out); i++) {
        snprintf(text, sizeof text, "! %s%s%s%s", out.what, *out.allowed ? " (" : "", out.allowed,
                 *out.allowed ? ")" : "");
        add(tui, out.key, text);
    }
    const struct thud_energy *e = &result->energy;
    char a[24], b[24], c[24];
    snprintf(text, sizeof text, "energy: input %s kJ, viscous %s, contacts %s; unaccounted for %.1e of the largest",
             thud_tui_number(1e-3 * (e->input_j + e->initial_j), a), thud_tui_number(1e-3 * e->viscous_j, b),
             thud_tui_number(1e-3 * e->contact_j, c), e->error_ratio);
    add(tui, "analysis.tolerance", text);
    char tolerance[96] = "";
    thud_scene_get(&tui->doc.scene, "analysis.tolerance", tolerance, sizeof tolerance, NULL);
    snprintf(text, sizeof text, "tolerance: %s, method %s, %ld steps, %ld events", tolerance,
             result->method ? result->method : "?", result->work.steps, result->work.events);
    add(tui, "analysis.tolerance", text);
    if (tui->doc.record && tui->doc.record->synthetic)
        add(tui, "record.file", "synthetic: the ground motion is " THUD_RECORD_COMPUTED);
    if (*tui->doc.scene.record.file)
        add(tui, "record.sign",
            tui->doc.scene.record.sign < 0
                ? "sign: -, the ground motion in reversed polarity; it may be worse as recorded"
                : "sign: +, the ground motion as recorded; reversed polarity may be worse");
}
