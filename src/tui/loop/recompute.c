/* Running the three cases whenever what they depend on changed. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "study/scene/answer.h"
#include "tui/screens/plots.h"

enum thud_live_history thud_tui_wants_history(const struct thud_tui *tui)
{
    if (tui->pictures_wanted || tui->whole_wanted != THUD_DO_NOTHING)
        return THUD_LIVE_WHOLE;
    if (tui->screen != THUD_SCREEN_PLOTS)
        return THUD_LIVE_NO_HISTORY;
    return thud_plots_energies(tui) ? THUD_LIVE_WHOLE : THUD_LIVE_LOOK;
}

static void start(struct thud_tui *tui)
{
    const struct thud_record *record;
    struct thud_error err;
    tui->ran_revision = tui->doc.revision;
    tui->started_s = tui->backend->now(tui->backend);
    tui->was_running = true;
    tui->dirty = true;
    thud_live_stop(&tui->live); /* its runs look at the record */
    if (thud_doc_record(&tui->doc, &record, &err) != THUD_OK) {
        thud_live_fail(&tui->live, &err);
        thud_tui_say_error(tui, &err);
        return;
    }
    thud_live_start(&tui->live, &tui->doc.scene, record, thud_tui_wants_history(tui));
}

void thud_tui_opened(struct thud_tui *tui)
{
    for (int i = 0; i < THUD_SCREENS; i++) /* what the screens keep belongs to the preset before */
        if (thud_view_of((enum thud_screen)i)->free)
            thud_view_of((enum thud_screen)i)->free(tui);
    tui->law_revision = 0;
    tui->pair = 0;
    tui->results_case = THUD_LIVE_BUMPER;
    thud_pin_take(&tui->pin, &tui->doc, false);
    tui->kept_before_n = NAN;
    tui->live_on = tui->live_wanted;
    start(tui);
}

void thud_tui_changed(struct thud_tui *tui)
{
    if (tui->ran_revision == tui->doc.revision) {
        if (thud_tui_wants_history(tui) > tui->live.history)
            start(tui); /* the same answer, with its histories */
        return;
    }
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

const struct thud_live *thud_tui_pinned(const struct thud_tui *tui)
{
    for (int i = 0; i < THUD_LIVE_CASES; i++)
        if (tui->live.which[i].state == THUD_LIVE_FAILED)
            return NULL; /* nothing to compare: a number beside it would be taken for its own */
    return thud_pin_live(&tui->pin, &tui->doc);
}

const char *thud_tui_pin_name(const struct thud_tui *tui)
{
    return tui->pin.own ? "pinned" : "saved";
}

bool thud_tui_shows_old(const struct thud_tui *tui)
{
    bool old = false;
    for (int i = 0; i < THUD_LIVE_CASES; i++)
        old = old || thud_live_is_old(&tui->live, (enum thud_live_which)i);
    return old;
}

void thud_tui_pin(struct thud_tui *tui)
{
    thud_pin_take(&tui->pin, &tui->doc, true);
    tui->law_revision = 0;
    thud_tui_say(tui, THUD_ROLE_GOOD, "Pinned: changes are told against this state now; V goes back to it");
}

void thud_tui_exchange(struct thud_tui *tui)
{
    struct thud_error err;
    struct thud_scene next = tui->pin.scene;
    memcpy(next.name, tui->doc.scene.name, sizeof next.name);
    memcpy(next.title, tui->doc.scene.title, sizeof next.title);
    next.study = tui->doc.scene.study;
    struct thud_pin before = {0};
    thud_pin_take(&before, &tui->doc, true);
    char what[64];
    const char *name = thud_tui_pin_name(tui);
    snprintf(what, sizeof what, "exchanged with the %s state", name);
    if (thud_doc_change(&tui->doc, &next, what, &err) != THUD_OK) {
        thud_pin_clear(&before);
        thud_tui_say_error(tui, &err);
        return;
    }
    thud_pin_clear(&tui->pin);
    tui->pin = before;
    if (tui->pair > next.nstructures - 2)
        tui->pair = next.nstructures > 1 ? next.nstructures - 2 : 0;
    thud_tui_say(tui, THUD_ROLE_GOOD, "This is the state that was %s; V goes back (u undoes)", name);
    thud_tui_changed(tui);
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
    tui->whole_wanted = THUD_DO_NOTHING;
    thud_live_clear(&tui->live);
    tui->was_running = false;
    tui->ran_revision = 0;
    thud_tui_say(tui, THUD_ROLE_WARN, "Stopped; nothing is shown of a run that was cut off. r runs again");
    return true;
}

void thud_tui_ran(struct thud_tui *tui)
{
    enum thud_action action = tui->whole_wanted;
    tui->whole_wanted = THUD_DO_NOTHING;
    if (tui->pictures_wanted)
        thud_tui_run_pictures(tui);
    if (action != THUD_DO_NOTHING && !thud_tui_cannot(tui, action))
        thud_tui_act(tui, action);
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
