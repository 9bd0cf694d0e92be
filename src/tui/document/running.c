/* Running the three cases whenever what they depend on changed. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "study/scene/solution.h"
#include "tui/document/session_log.h"
#include "tui/document/state.h"

enum thud_live_history thud_tui_wants_history(const struct thud_tui *tui)
{
    const struct thud_view *view = thud_tui_view(tui);
    bool drawn = tui->dialog.mode == THUD_MODE_OVER && tui->dialog.over->whole;
    if (drawn || tui->files.pictures_wanted || tui->files.whole_wanted != THUD_DO_NOTHING)
        return THUD_LIVE_WHOLE;
    return view->history ? view->history(tui) : THUD_LIVE_NO_HISTORY;
}

void thud_tui_run(struct thud_tui *tui)
{
    const struct thud_record *record;
    struct thud_error err;
    if (!tui->run.on && tui->run.revision != tui->doc.revision) /* not by itself, after an edit */
        thud_tui_log(tui, "run");
    tui->run.revision = tui->run.seen = tui->doc.revision;
    tui->run.seen_history = thud_tui_wants_history(tui);
    tui->run.started_s = tui->backend->now(tui->backend);
    tui->run.was_running = true;
    thud_tui_redraw(tui, false);
    thud_live_stop(&tui->run.live); /* its runs look at the record */
    if (thud_doc_record(&tui->doc, &record, &err) != THUD_OK) {
        thud_live_fail(&tui->run.live, &err);
        thud_tui_say_error(tui, &err);
        return;
    }
    thud_live_start(&tui->run.live, &tui->doc.scene, record, thud_tui_wants_history(tui));
}

void thud_tui_forget_made(struct thud_tui *tui)
{
    for (int i = 0; i < tui->files.nmade; i++)
        thud_figure_free(tui->files.made[i].figure);
    tui->files.nmade = 0;
}

void thud_tui_opened(struct thud_tui *tui)
{
    thud_tui_forget_made(tui);
    for (int i = 0; i < tui->screens; i++) { /* what the screens keep belongs to the preset before */
        const struct thud_view *view = tui->view[i];
        if (view->free)
            view->free(tui);
        if (view->size > 0)
            memset(tui->own[i], 0, view->size);
        if (view->begin)
            view->begin(tui);
    }
    memset(tui->window, 0, sizeof tui->window);
    tui->interface = 0;
    tui->look_at.wanted = false;
    thud_designs_clear(&tui->designs);
    thud_base_clear(&tui->base);
    tui->run.design = 0;
    tui->kept.before_n = NAN;
    tui->run.on = tui->run.usual;
    thud_tui_run(tui);
}

void thud_tui_forget_run(struct thud_tui *tui)
{
    thud_live_clear(&tui->run.live);
    tui->run.was_running = false;
    tui->run.revision = 0;
}

/* What the scene is compared with after a change: the state that was run before it, where no design was chosen and it
 * is not one more step of the same value. */
static void remember_before(struct thud_tui *tui)
{
    const bool step = tui->run.stepping && tui->run.stepped_to == tui->doc.revision;
    if (tui->base.chosen || (step && tui->base.scene.nstructures > 0))
        return;
    for (int i = 0; i < tui->designs.n; i++) {
        const struct thud_design *d = &tui->designs.item[i];
        if (d->number == tui->run.design &&
            memcmp(&d->scene->record, &tui->doc.record_choice, sizeof d->scene->record) == 0)
            thud_base_take(&tui->base, d, tui->doc.record, false);
    }
}

void thud_tui_follow(struct thud_tui *tui)
{
    enum thud_live_history wanted = thud_tui_wants_history(tui);
    const int last = tui->doc.scene.nstructures - 2;
    bool changed = tui->run.seen != tui->doc.revision;
    if (tui->interface > last)
        tui->interface = last > 0 ? last : 0;
    if (!changed && wanted <= tui->run.seen_history)
        return;
    if (changed)
        remember_before(tui);
    bool same = tui->run.revision == tui->doc.revision; /* the same result, with its histories */
    tui->run.seen = tui->doc.revision;
    tui->run.seen_history = wanted;
    if (same ? wanted > tui->run.live.history : tui->run.on) {
        thud_tui_run(tui);
    } else if (!same) {
        const struct thud_record *record;
        struct thud_error err;
        thud_tui_forget_run(tui);
        thud_doc_record(&tui->doc, &record, &err);
        thud_tui_redraw(tui, false);
    }
}

const struct thud_live *thud_tui_compared(const struct thud_tui *tui)
{
    if (thud_live_failed(&tui->run.live))
        return NULL; /* nothing to compare: a number beside it would be taken for its own */
    return thud_base_live(&tui->base, &tui->doc);
}

bool thud_tui_shows_old(const struct thud_tui *tui)
{
    bool old = false;
    for (int i = 0; i < THUD_LIVE_CASES; i++)
        old = old || thud_live_is_old(&tui->run.live, (enum thud_live_which)i);
    return old;
}

const struct thud_model *thud_tui_model(struct thud_tui *tui)
{
    if (tui->run.model_of != tui->doc.revision) {
        thud_model_free(tui->run.model);
        tui->run.model = NULL;
        tui->run.model_of = tui->doc.revision;
        if (thud_scene_assemble(&tui->doc.scene, &tui->run.model, NULL) != THUD_OK)
            tui->run.model = NULL;
    }
    return tui->run.model;
}

bool thud_tui_cancel(struct thud_tui *tui)
{
    if (!tui->run.live.running)
        return false;
    tui->files.pictures_wanted = false;
    tui->files.whole_wanted = THUD_DO_NOTHING;
    thud_tui_forget_run(tui);
    thud_tui_say(tui, THUD_ROLE_WARN, "Stopped; nothing is shown of a run that was cut off. r runs again");
    return true;
}
