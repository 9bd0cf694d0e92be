/* The lists that a run keeps where it is asked to: one entry for each impact that is over and for each event. Nothing
 * that moves reads them. */
#include "core/contact/contact_log.h"

#include <math.h>
#include <stdlib.h>

#include "base/arena.h"
#include "base/grow.h"
#include "core/contact/storey.h"

enum thud_status thud_contact_log_init(struct thud_contact_log *log, const struct thud_state *state,
                                       struct thud_contact_result *contact, bool keep_impacts, struct thud_error *err)
{
    const int ncontacts = state->model->ncontacts;
    *log = (struct thud_contact_log){.contact = contact, .keep_impacts = keep_impacts};
    return THUD_LAY_IN(state->memory, err, THUD_PIECE(log->now, ncontacts), THUD_PIECE(log->counted, ncontacts),
                       THUD_PIECE(log->waiting_s, ncontacts));
}

void thud_contact_log_begin(struct thud_contact_log *log, int contact, double time_s, double approach_mps)
{
    log->now[contact] =
        (struct thud_impact){.contact = contact, .start_s = time_s, .approach_mps = approach_mps, .restitution = NAN};
    log->counted[contact] = false;
    log->waiting_s[contact] = 0;
}

enum thud_status thud_contact_log_add(struct thud_contact_log *log, const struct thud_impact *impact,
                                      struct thud_error *err)
{
    if (!log->keep_impacts)
        return THUD_OK;
    struct thud_impact *larger = thud_grow(log->impact, (size_t)log->count, sizeof *larger);
    if (!larger)
        return thud_error_set(err, THUD_MEMORY, "out of memory for the list of impacts");
    log->impact = larger;
    log->impact[log->count++] = *impact;
    return THUD_OK;
}

/* The state that the event has led to, in the words of the list of events. */
static const char *state_of(const struct thud_state *state, int row)
{
    const struct thud_contact_state *s = thud_row_contact(state, row);
    if (!s) {
        int direction = state->storey[row - state->model->ncontacts].direction;
        if (thud_model_row_storey(state->model, row)->link >= 0)
            return direction == 0 ? "held" : direction > 0 ? "slips, d rising" : "slips, d falling";
        return direction == 0 ? "elastic" : direction > 0 ? "yields, d rising" : "yields, d falling";
    }
    if (s->mode == THUD_CLOSED)
        return s->phase == THUD_APPROACH ? "closed, approach" : "closed, restitution";
    return s->mode == THUD_OPEN ? "open" : s->mode == THUD_STICKING ? "sticking" : "closed without force";
}

static double force_of(const struct thud_state *state, int row)
{
    const int storey = row - state->model->ncontacts;
    if (storey >= 0)
        return thud_storey_shear(state, storey, thud_model_gap_sum(state->model, row, state->q));
    thud_contact_forces(state, state->force_now);
    return state->force_now[row];
}

enum thud_status thud_contact_log_event(struct thud_contact_log *log, const struct thud_state *state, double time_s,
                                        int row, enum thud_event event, int order, struct thud_error *err)
{
    if (!log->keep_events)
        return THUD_OK;
    struct thud_event_entry *larger = thud_grow(log->event, (size_t)log->nevents, sizeof *larger);
    if (!larger)
        return thud_error_set(err, THUD_MEMORY, "out of memory for the list of events");
    log->event = larger;
    int at = log->nevents++; /* a contact may have begun in a segment before another one parted */
    for (; at > 0 && log->event[at - 1].time_s > time_s; at--)
        log->event[at] = log->event[at - 1];
    const bool falls = event == THUD_EVENT_COLLAPSE; /* its row is beyond those that have a force */
    log->event[at] = (struct thud_event_entry){.time_s = time_s,
                                               .row = row,
                                               .event = thud_event_words[event].name,
                                               .guard = thud_event_words[event].guard,
                                               .then = falls ? "collapsed" : state_of(state, row),
                                               .order = order,
                                               .force_n = falls ? 0 : force_of(state, row)};
    return THUD_OK;
}

void thud_contact_log_clear(struct thud_contact_log *log)
{
    free(log->impact);
    free(log->event);
}
