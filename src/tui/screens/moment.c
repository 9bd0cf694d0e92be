#include "tui/screens/moment.h"

#include <stdio.h>

#include "study/scene/solution.h"
#include "tui/document/field.h"
#include "tui/screens/movement.h"

/* The case as it is written; the run that is shown of it, with its model: while it goes on the last one. NULL: none. */
static const struct thud_run *shown_run(const struct thud_tui *tui, enum thud_live_which *which,
                                        const struct thud_model **model)
{
    *which = thud_live_written(&tui->run.live);
    const struct thud_live_case *c = &tui->run.live.which[*which];
    const bool old = thud_live_is_old(&tui->run.live, *which);
    const struct thud_run *run = old ? c->old : c->state == THUD_LIVE_DONE ? c->run : NULL;
    *model = old ? c->old_model : c->model;
    const struct thud_history *history = run ? thud_run_history(run) : NULL;
    return history && history->rows > 0 && (*model)->nstructures == tui->doc.scene.nstructures ? run : NULL;
}

/* When the largest force of the interface shown acts, s. */
static double time_of_largest(const struct thud_tui *tui, const struct thud_result *result)
{
    const struct thud_contact_result *most = thud_contact_hardest(result, tui->interface + 1);
    return most ? most->force.time_s : 0.0;
}

void thud_moment_title(const struct thud_tui *tui, char *text, size_t size)
{
    enum thud_live_which which;
    const struct thud_model *model;
    const struct thud_run *run = shown_run(tui, &which, &model);
    snprintf(text, size, run ? "At the largest impact, t = %.3f s" : "The buildings",
             run ? time_of_largest(tui, thud_run_result(run)) : 0.0);
}

int thud_moment_draw(const struct thud_tui *tui, const struct thud_pane *pane)
{
    enum thud_live_which which;
    const struct thud_model *model;
    const struct thud_run *run = shown_run(tui, &which, &model);
    if (run)
        thud_movement_draw(pane, &tui->doc.scene, model, run, which == THUD_LIVE_BUMPER,
                           time_of_largest(tui, thud_run_result(run)));
    else
        thud_field_note(pane, 0, "no motions to show");
    return pane->h;
}

enum thud_live_history thud_moment_history(const struct thud_tui *tui)
{
    return tui->canvas.width >= THUD_MOMENT_WIDE ? THUD_LIVE_CONTACTS : THUD_LIVE_NO_HISTORY;
}
