/* Running the three cases whenever what they depend on changed. */
#include <math.h>
#include <string.h>

#include "study/answer.h"
#include "tui/state.h"

static bool wants_history(const struct thud_tui *tui)
{
    return tui->screen == THUD_SCREEN_PLOTS || tui->pictures_wanted;
}

/* The peaks on show, to say afterwards what a change did. */
static struct thud_peaks peaks_now(const struct thud_tui *tui)
{
    struct thud_peaks peaks = {0};
    int impacts;
    enum thud_live_which which =
        tui->live.which[THUD_LIVE_BUMPER].state == THUD_LIVE_DONE ? THUD_LIVE_BUMPER : THUD_LIVE_NONE;
    if (tui->live.which[which].state != THUD_LIVE_DONE)
        return peaks;
    peaks.known = true;
    peaks.which = which;
    for (int i = 0; i < 2; i++) {
        peaks.acceleration[i] = thud_live_peak(&tui->live, which, tui->pair + i, THUD_PEAK_ACCELERATION);
        peaks.drift[i] = thud_live_peak(&tui->live, which, tui->pair + i, THUD_PEAK_DRIFT);
    }
    peaks.force = thud_live_force(&tui->live, which, tui->pair + 1, &impacts);
    return peaks;
}

static void start(struct thud_tui *tui)
{
    const struct thud_record *record;
    struct thud_error err;
    tui->ran_revision = tui->doc.revision;
    tui->started_s = tui->backend->now(tui->backend);
    tui->was_running = true;
    tui->dirty = true;
    if (thud_doc_record(&tui->doc, &record, &err) != THUD_OK) {
        thud_live_fail(&tui->live, &err);
        thud_tui_say_error(tui, &err);
        return;
    }
    thud_live_start(&tui->live, &tui->doc.scene, record, wants_history(tui));
}

void thud_tui_opened(struct thud_tui *tui)
{
    for (int i = 0; i < THUD_SCREENS; i++) /* what the screens keep belongs to the preset before */
        if (thud_view_of((enum thud_screen)i)->free)
            thud_view_of((enum thud_screen)i)->free(tui);
    tui->law_revision = 0;
    tui->pair = 0;
    tui->results_case = THUD_LIVE_BUMPER;
    tui->before = (struct thud_peaks){0};
    tui->kept_before_n = NAN;
    tui->live_on = true;
    start(tui);
}

void thud_tui_changed(struct thud_tui *tui)
{
    if (tui->ran_revision == tui->doc.revision) {
        if (wants_history(tui) && !tui->live.history)
            start(tui); /* the same answer, with its histories */
        return;
    }
    struct thud_peaks now = peaks_now(tui);
    if (now.known)
        tui->before = now;
    if (tui->live_on) {
        start(tui);
        return;
    }
    thud_live_clear(&tui->live);
    tui->was_running = false;
    tui->ran_revision = 0;
    const struct thud_record *record;
    struct thud_error err;
    thud_doc_record(&tui->doc, &record, &err);
    tui->dirty = true;
}

const struct thud_model *thud_tui_model(struct thud_tui *tui)
{
    const struct thud_model *model = tui->live.which[THUD_LIVE_FREE].model;
    if (model && tui->ran_revision == tui->doc.revision)
        return model;
    if (tui->own_revision != tui->doc.revision) {
        thud_model_free(tui->own_model);
        tui->own_model = NULL;
        tui->own_revision = tui->doc.revision;
        if (thud_scene_assemble(&tui->doc.scene, &tui->own_model, NULL) != THUD_OK)
            tui->own_model = NULL;
    }
    return tui->own_model;
}

void thud_tui_run(struct thud_tui *tui)
{
    start(tui);
}

bool thud_tui_cancel(struct thud_tui *tui)
{
    if (!tui->live.running)
        return false;
    tui->pictures_wanted = false;
    thud_live_clear(&tui->live);
    tui->was_running = false;
    tui->ran_revision = 0;
    thud_tui_say(tui, THUD_ROLE_WARN, "Stopped; nothing is shown of a run that was cut off. r runs again");
    return true;
}

void thud_tui_ran(struct thud_tui *tui)
{
    if (tui->pictures_wanted)
        thud_tui_run_pictures(tui);
    for (int i = 0; i < THUD_LIVE_CASES; i++) {
        const struct thud_live_case *c = &tui->live.which[i];
        if (c->state != THUD_LIVE_FAILED)
            continue;
        char text[600];
        thud_error_text(&c->error, text, sizeof text);
        if (c->run)
            thud_tui_say(tui, THUD_ROLE_ERROR, "! FAILED (%s) at t = %.4g s: %s",
                         thud_live_name((enum thud_live_which)i), c->failed_s, text);
        else
            thud_tui_say(tui, THUD_ROLE_ERROR, "! FAILED (%s): %s", thud_live_name((enum thud_live_which)i), text);
        return;
    }
}
