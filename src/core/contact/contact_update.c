/* Contacts of a run that does not locate events: each catches up with the state at the end of a step, as a program
 * does that only looks at its steps. Nothing sticks. */
#include <math.h>

#include "core/contact/contact.h"
#include "core/numerics/tolerance.h"

/* What a contact that is not open does next; -1: it goes on. */
static int closed_event(const struct thud_state *state, int c, double d, double v)
{
    const struct thud_contact_state *s = &state->contact[c];
    const struct thud_law *law = state->model->contact[c].law;
    if (d <= 0)
        return THUD_EVENT_SEPARATION;
    bool pushes = thud_branch_force(&s->branch, d, v, NULL, NULL) > 0;
    if (s->mode == THUD_CLOSED_NO_FORCE)
        return pushes ? THUD_EVENT_REENGAGE : -1;
    if (law->flags & THUD_LAW_REVERSES && (s->phase == THUD_APPROACH ? v < 0 : v > 0))
        return THUD_EVENT_REVERSAL;
    if ((d > s->ultimate_m) != s->past_ultimate)
        return THUD_EVENT_BRANCH;
    return !pushes && !(law->flags & THUD_LAW_PULLS) ? THUD_EVENT_RELEASE : -1;
}

/* The next change that the end of the step asks of contact c; -1: none. */
static int next_event(const struct thud_state *state, int c)
{
    double d = thud_contact_indentation(state, c), v;
    unsigned flags = state->model->contact[c].law->flags;
    if (state->contact[c].mode == THUD_OPEN && (flags & THUD_LAW_NO_FORCE || d <= state->touch_m))
        return -1;
    v = thud_contact_rate(state, c);
    if (state->contact[c].mode == THUD_OPEN)
        return flags & THUD_LAW_IMPULSIVE && v <= 0 ? -1 : THUD_EVENT_ONSET;
    if (state->contact[c].mode == THUD_STICKING) /* an impulse has brought it to rest: looked at afresh */
        return THUD_EVENT_UNSTICK_OUT;
    return closed_event(state, c, d, v);
}

enum thud_status thud_contact_update(struct thud_state *state, struct thud_contact_log *log, bool apart, bool *switched,
                                     struct thud_error *err)
{
    enum { EVENTS_MAX = 4 }; /* onset, reversal, change of branch and release may all lie in one step */
    enum thud_status status = THUD_OK;
    *switched = false;
    if (apart && state->nindented == 0)
        return THUD_OK;
    for (int c = 0; c < state->model->ncontacts; c++) {
        enum thud_contact_mode before = state->contact[c].mode;
        if (apart && before == THUD_OPEN)
            continue;
        for (int i = 0; i < EVENTS_MAX && status == THUD_OK; i++) {
            int event = next_event(state, c);
            if (event < 0)
                break;
            *switched = true;
            status = thud_contact_switch(state, log, c, event, err);
            if (status == THUD_OK)
                status = thud_contact_log_event(log, state, thud_state_now(state), c, event, 0, err);
            if (state->contact[c].mode == THUD_OPEN || state->contact[c].mode == THUD_STICKING)
                break; /* it may touch again only at the end of another step */
        }
        if (before == THUD_OPEN && state->contact[c].mode == THUD_STICKING)
            status = status == THUD_OK ? thud_contact_switch(state, log, c, THUD_EVENT_UNSTICK_OUT, err) : status;
        state->contact[c].suppressed = (struct thud_suppressed){0};
    }
    return status;
}
