#include "tui/loop/verdict.h"
#include "study/scene/level.h"
#include "tui/loop/loop.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "app/run/summary_line.h"

/* With P-Delta: that a case ends in a collapse. */
static void say_collapse(const struct thud_tui *tui, enum thud_live_which which, char *text, size_t size)
{
    const struct thud_result *result = thud_live_result(&tui->run.live, which);
    if (!result || !result->collapse.happened)
        return;
    const struct thud_structure *s = &tui->doc.scene.structure[result->collapse.structure];
    snprintf(text, size, "%sCOLLAPSES at %.2f s: storey %d of %.20s", which == THUD_LIVE_BUMPER ? "bumper: " : "",
             result->collapse.time_s, thud_structure_storey(s, result->collapse.floor), s->name);
}

static void words_of_pair(const struct thud_tui *tui, int columns, char *text, size_t size, bool *pounds)
{
    const struct thud_scene *scene = &tui->doc.scene;
    const struct thud_live_need *need = &tui->run.live.need[tui->interface];
    struct thud_summary_line line = {.need_m = NAN};
    *text = '\0';
    line.force_n = thud_live_force(&tui->run.live, THUD_LIVE_NONE, tui->interface + 1, &line.impacts);
    line.impulse_ns = thud_live_impulse(&tui->run.live, THUD_LIVE_NONE, tui->interface + 1);
    *pounds = line.impacts > 0;
    if (tui->interface + 1 >= scene->nstructures)
        return;
    double most_m;
    thud_interface_gaps(&scene->interface[tui->interface], &line.gap_m, &most_m);
    bool free_body =
        scene->structure[tui->interface].kind == THUD_RIGID || scene->structure[tui->interface + 1].kind == THUD_RIGID;
    if (!free_body) { /* that goes on for ever */
        line.need_m = need->relative_displacement_m;
        line.abs_m = need->abs_m;
        line.srss_m = need->srss_m;
    }
    line.without = thud_live_short_name(scene, THUD_LIVE_NONE);
    line.with = thud_live_short_name(scene, THUD_LIVE_BUMPER);
    line.bumper_force_n = thud_live_force(&tui->run.live, THUD_LIVE_BUMPER, tui->interface + 1, &line.bumper_impacts);
    say_collapse(tui, THUD_LIVE_NONE, text, size);
    if (!*text)
        say_collapse(tui, THUD_LIVE_BUMPER, text, size);
    *pounds = *pounds || *text;
    const size_t said = strlen(text), room = *text ? 3 : 0;
    if (columns < (int)(said + room + 16))
        return;
    if (*text)
        snprintf(text + said, size - said, "   ");
    thud_summary_line(&line, columns - (int)(said + room), text + said + room, size - said - room);
}

/* In at most `columns`; empty where there is nothing to say. In a row of buildings with the number of the gap that it is
 * said of. *pounds: whether there is contact without a bumper. */
static void words_of(const struct thud_tui *tui, int columns, char *text, size_t size, bool *pounds)
{
    const int gaps = tui->doc.scene.nstructures - 1,
              head =
                  gaps > 1 && tui->interface < gaps ? snprintf(text, size, "%d of %d: ", tui->interface + 1, gaps) : 0;
    words_of_pair(tui, columns - head, text + head, size - (size_t)head, pounds);
    if (!text[head])
        *text = '\0';
}

void thud_verdict_words(const struct thud_tui *tui, int columns, char *text, size_t size)
{
    bool pounds;
    words_of(tui, columns, text, size, &pounds);
}

void thud_verdict_draw(struct thud_tui *tui, const struct thud_pane *row)
{
    char words[sizeof tui->verdict.text];
    bool pounds, running = tui->run.live.running;
    int remarks = thud_tui_count_remarks(tui);
    char count[32] = "";
    if (remarks > 0)
        snprintf(count, sizeof count, "! %d ", remarks);
    words_of(tui, row->w - 2 - (*count ? (int)strlen(count) + 1 : 0), words, sizeof words, &pounds);
    if (!running) {
        memcpy(tui->verdict.text, words, sizeof words);
        tui->verdict.role = pounds ? THUD_ROLE_WARN : THUD_ROLE_GOOD;
    }
    thud_pane_put(row, 1, 0, thud_look(running ? THUD_ROLE_MUTED : tui->verdict.role, THUD_BOLD), tui->verdict.text);
    thud_pane_right(row, row->w, 0, thud_look(THUD_ROLE_WARN, THUD_BOLD), count);
}
