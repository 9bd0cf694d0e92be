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

enum { THREE_DIGITS = -1 };
/* "34.5 -> 33.1 MN", with so many decimals, or one number where it is shown alike; empty without one. */
static void change_words(double before, double now, int decimals, const char *unit, char text[64])
{
    char a[24], b[24];
    snprintf(a, sizeof a, "%.*f", decimals, before);
    snprintf(b, sizeof b, "%.*f", decimals, now);
    if (decimals == THREE_DIGITS) {
        thud_tui_number(before, a);
        thud_tui_number(now, b);
    }
    if (isnan(now))
        *text = '\0';
    else if (isnan(before) || strcmp(a, b) == 0)
        snprintf(text, 64, "%s %s", b, unit);
    else
        snprintf(text, 64, "%s -> %s %s", a, b, unit);
}

/* The scene as it is written against the state before the change, or the chosen design, whose name stands before it:
 * what has no room is left off, last of all the gap that is needed. False: there is nothing to compare. */
static bool words_of_change(const struct thud_tui *tui, int columns, char *text, size_t size, bool *pounds)
{
    enum { WIDE = 60, NARROW = 45 };
    const int i = tui->interface;
    const struct thud_design_result *before = &tui->base.result;
    struct thud_design_result now;
    char force[64], impacts[64], need[64], gap[64], at[64], bare[24], name[48] = "";
    thud_design_measure(&tui->doc.scene, &tui->run.live, &now);
    if (!before->known || !now.known || !thud_base_differs(&tui->base, &tui->doc) ||
        i + 1 >= tui->base.scene.nstructures)
        return false;
    change_words(1e-6 * before->force_n[i], 1e-6 * now.force_n[i], THREE_DIGITS, "MN", force);
    change_words(before->impacts[i], now.impacts[i], 0, now.impacts[i] == 1 ? "impact" : "impacts", impacts);
    change_words(thud_summary_gap_cm(before->with_bumper_m[i]), thud_summary_gap_cm(now.with_bumper_m[i]), 1, "cm",
                 gap);
    snprintf(need, sizeof need, "%s%.50s", *gap ? "needs " : "", gap);
    if (tui->base.chosen)
        snprintf(name, sizeof name, "%.20s: ", tui->base.name);
    *pounds = now.impacts[i] > 0;
    thud_interface_gap_text(&tui->doc.scene.interface[i], at, sizeof at);
    if (columns < NARROW)
        snprintf(text, size, "%s", need);
    else if (columns < WIDE)
        snprintf(text, size, "%s  %s", *pounds || before->impacts[i] > 0 ? force : "no contact", need);
    else
        snprintf(text, size, "%s%s at %s: %s%s%s  %.60s", name, *pounds ? "POUNDS" : "NO CONTACT", at,
                 *pounds || before->impacts[i] > 0 ? force : "", *pounds || before->impacts[i] > 0 ? "  " : "", impacts,
                 need);
    thud_summary_bare(now.need_m[i], now.with_bumper_m[i] - now.need_m[i], bare);
    if (columns >= WIDE && strlen(text) + strlen(bare) <= (size_t)columns)
        snprintf(text + strlen(text), size - strlen(text), "%s", bare);
    return true;
}

static void words_of_pair(const struct thud_tui *tui, int columns, char *text, size_t size, bool *pounds)
{
    const struct thud_scene *scene = &tui->doc.scene;
    const struct thud_live_need *need = &tui->run.live.need[tui->interface];
    struct thud_summary_line line = {.need_m = NAN, .in_row = scene->nstructures > 2};
    *text = '\0';
    line.force_n = thud_live_force(&tui->run.live, THUD_LIVE_NONE, tui->interface + 1, &line.impacts);
    line.impulse_ns = thud_live_impulse(&tui->run.live, THUD_LIVE_NONE, tui->interface + 1);
    *pounds = line.impacts > 0;
    if (tui->interface + 1 >= scene->nstructures)
        return;
    thud_interface_gap_text(&scene->interface[tui->interface], line.gap, sizeof line.gap);
    line.by_level = scene->interface[tui->interface].gap.n > 0;
    bool free_body =
        scene->structure[tui->interface].kind == THUD_RIGID || scene->structure[tui->interface + 1].kind == THUD_RIGID;
    if (!free_body) { /* that goes on for ever */
        line.need_m = need->relative_displacement_m;
        line.need_with = scene->nlinks > 0;
        line.bumper_m = line.need_with ? need->with_bumper_m - line.need_m : 0; /* else that of the case without */
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

/* In at most `columns`; empty where there is nothing to say. In a row of buildings with the number of the gap that it
 * applies to. *pounds: whether there is contact without a bumper. */
static void words_of(const struct thud_tui *tui, int columns, char *text, size_t size, bool *pounds)
{
    const int gaps = tui->doc.scene.nstructures - 1,
              head =
                  gaps > 1 && tui->interface < gaps ? snprintf(text, size, "%d of %d: ", tui->interface + 1, gaps) : 0;
    if (!words_of_change(tui, columns - head, text + head, size - (size_t)head, pounds))
        words_of_pair(tui, columns - head, text + head, size - (size_t)head, pounds);
    if (!text[head])
        *text = '\0';
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
