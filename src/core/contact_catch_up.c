/* Contacts of a run that does not locate events: each catches up with the state at the end of a step, as a program
 * does that only looks at its steps. Nothing sticks. */
#include <math.h>

#include "core/contact.h"
#include "core/tolerance.h"

void thud_contact_read(struct thud_run *run)
{
    for (int c = 0; c < run->model->ncontacts; c++)
        thud_segment_indentation(run, &run->seg, c, run->indentation + c * THUD_SEGMENT_TERMS);
}

bool thud_contact_felt(const struct thud_run *run, int c)
{
    if (run->locates || thud_contact_acts(&run->contact[c]))
        return thud_contact_acts(&run->contact[c]);
    const double *force = run->seg.force + c;
    for (int k = 0; k < run->seg.terms; k++)
        if (force[k * run->model->ncontacts] != 0)
            return true;
    return false;
}

/* What a contact that is not open does next; -1: it goes on. */
static int closed_event(const struct thud_run *run, int c, double d, double v)
{
    const struct thud_contact_state *s = &run->contact[c];
    const struct thud_law *law = run->model->contact[c].law;
    if (d <= 0)
        return THUD_EVENT_GONE;
    bool pushes = thud_branch_force(&s->branch, d, v, NULL, NULL) > 0;
    if (s->mode == THUD_SLACK)
        return pushes ? THUD_EVENT_REENGAGE : -1;
    if (law->flags & THUD_LAW_TURNS && (s->phase == THUD_APPROACH ? v < 0 : v > 0))
        return THUD_EVENT_TURN;
    if ((d > s->knee_m) != s->past_knee)
        return THUD_EVENT_KNEE;
    return !pushes && !(law->flags & THUD_LAW_PULLS) ? THUD_EVENT_RELEASE : -1;
}

static int next_event(const struct thud_run *run, int c)
{
    double d = thud_contact_indentation(run, c), v = thud_contact_rate(run, c);
    unsigned flags = run->model->contact[c].law->flags;
    switch (run->contact[c].mode) {
    case THUD_OPEN:
        if (flags & THUD_LAW_SILENT || d <= THUD_TOL_INDENTATION_M || (flags & THUD_LAW_IMPULSIVE && v <= 0))
            return -1;
        return THUD_EVENT_TOUCH;
    case THUD_STUCK: /* an impulse has brought it to rest: looked at afresh */
        return THUD_EVENT_HOLD_DOWN;
    case THUD_CLOSED:
    case THUD_SLACK:
        break;
    }
    return closed_event(run, c, d, v);
}

enum thud_status thud_contact_catch_up(struct thud_run *run, bool *switched, struct thud_error *err)
{
    enum { EVENTS_MAX = 4 }; /* touch, turn, knee and release may all lie in one step */
    enum thud_status status = THUD_OK;
    *switched = false;
    for (int c = 0; c < run->model->ncontacts; c++) {
        enum thud_contact_mode before = run->contact[c].mode;
        for (int i = 0; i < EVENTS_MAX && status == THUD_OK; i++) {
            int event = next_event(run, c);
            if (event < 0)
                break;
            *switched = true;
            status = thud_contact_switch(run, c, event, err);
            if (run->contact[c].mode == THUD_OPEN || run->contact[c].mode == THUD_STUCK)
                break; /* it may touch again only at the end of another step */
        }
        if (before == THUD_OPEN && run->contact[c].mode == THUD_STUCK)
            status = status == THUD_OK ? thud_contact_switch(run, c, THUD_EVENT_HOLD_DOWN, err) : status;
        run->contact[c].zeros = (struct thud_zeros){0};
    }
    return status;
}
