/* The next segment of a run, up to its first event; and what is done about events that have no end. */
#include <math.h>
#include <stdio.h>

#include "core/run/run_private.h"

/* Number of successive events at one instant, for each contact and in addition, before that instant is skipped; and how often, each time for twice as long.
 * After some times the events are as many times that number: a light body between heavy ones has thousands of bounces. */
enum { STALLS_EACH = 4, STALLS_MORE = 12, PASSES_FEW = 8, PASSES_MAX = 36 };

/* Events that a run may take in a part of its duration. 20 buildings of 200 storeys that pound at every floor take
 * fewer than this in all; a bounce that loses no energy and is pressed on takes ever more, and would never end. */
static const long crowd = 100000;
static const double crowd_part = 0.01;

/* The first event of the proposed segment, where events are located: its s, else INFINITY. */
static double next_event(struct thud_run *run, struct thud_proposal *p)
{
    return run->state.locates ? thud_event_first(&run->state, &run->seg, p->limit, &p->contact, &p->event, &p->order)
                              : INFINITY;
}

/* A method that can blow up has its step looked at before anything is read from it. */
static enum thud_status check_proposal(struct thud_run *run, struct thud_error *err)
{
    if (run->method->order == 0 || (run->seg.end && run->seg.end_energy <= run->state.energy_most))
        return THUD_OK;
    if (run->seg.end)
        return thud_run_check_state(run, run->seg.end->q, run->seg.end->qd, err);
    double *q = run->end, *qd = q + run->state.model->nmodes;
    thud_segment_state(&run->seg, run->state.model->nmodes, 1, q, qd);
    return thud_run_check_state(run, q, qd, err);
}

/* A step of the method, checked, with its first event. */
static enum thud_status propose(struct thud_run *run, struct thud_proposal *p, struct thud_error *err)
{
    enum thud_status status = run->method->stepper->step(&run->state, run->own, &run->seg, err);
    if (status == THUD_OK)
        status = check_proposal(run, err);
    if (status != THUD_OK)
        return status;
    double remaining = thud_state_remaining(&run->state);
    p->limit = run->seg.h_s >= remaining * (1 - THUD_TOL_SEGMENT_END) ? thud_smaller(1, remaining / run->seg.h_s) : 1;
    p->s = next_event(run, p);
    p->switched = p->s <= p->limit;
    p->s = p->switched ? p->s : p->limit;
    if (p->switched && run->method->order == 0 && !run->seg.nodes) { /* what is left of it needs fewer terms */
        const int terms = thud_segment_all_terms(&run->state, p->s * run->seg.h_s);
        run->seg.terms = terms < run->seg.terms ? terms : run->seg.terms;
    }
    return THUD_OK;
}

/* Where a contact begins or ends. */
static bool is_boundary(enum thud_event event)
{
    return event == THUD_EVENT_ONSET || event == THUD_EVENT_SEPARATION || event == THUD_EVENT_RELEASE;
}

/* The same, and where a stepping method meets an event, a second step that ends just behind it, and where a contact
 * begins or ends a third that ends still closer: between its ends a segment is less accurate than at them, and by a
 * bias that would add up from impact to impact. Turns are left at the second: nothing jumps there. */
enum thud_status thud_run_propose(struct thud_run *run, struct thud_proposal *p, struct thud_error *err)
{
    static const double behind[] = {1.02, 1.0002};
    run->state.step_cap_s = INFINITY;
    enum thud_status status = propose(run, p, err);
    for (int i = 0; i < 2 && status == THUD_OK && p->switched && run->method->order > 0; i++) {
        double cap = behind[i] * p->s * run->seg.h_s, before = run->state.step_cap_s;
        if (p->s * behind[i] >= p->limit || (i > 0 && !is_boundary(p->event)) ||
            p->s * run->seg.h_s <= THUD_TOL_MOMENT_S)
            continue; /* so near that a step up to it would be none */
        run->state.step_cap_s = cap;
        run->work.rejected++;
        status = propose(run, p, err);
        if (i > 0 && status == THUD_OK && !p->switched) { /* too close: the end of this step lies before the event */
            run->state.step_cap_s = before;
            return propose(run, p, err);
        }
    }
    return status;
}

/* Whose row this is, in the words of a message, and its key. */
struct row_name {
    char words[80], key[64];
};

static struct row_name name_row(const struct thud_model *model, int row)
{
    struct row_name name;
    const struct thud_model_storey *storey = thud_model_row_storey(model, row);
    const struct thud_model_contact *contact = &model->contact[row];
    int link = storey ? storey->link : -1;
    for (int i = 0; i < model->nlinks && !storey; i++)
        link = model->link[i].contact == row ? i : link;
    if (link >= 0) {
        snprintf(name.words, sizeof name.words, "link %d", link + 1);
        snprintf(name.key, sizeof name.key, "links.%d", link + 1);
    } else if (storey) {
        snprintf(name.words, sizeof name.words, "storey %d of structure %d", storey->floor + 1, storey->structure + 1);
        snprintf(name.key, sizeof name.key, "structures.%d.yield.%d", storey->structure + 1, storey->floor + 1);
    } else {
        snprintf(name.words, sizeof name.words, "contact between floors %d and %d", contact->left_floor,
                 contact->right_floor);
        snprintf(name.key, sizeof name.key, "interfaces.%d", contact->interface);
    }
    return name;
}

static enum thud_status stalled(struct thud_run *run, int row, struct thud_error *err)
{
    double now_s = thud_state_now(&run->state);
    if (row < 0)
        return thud_error_set(err, THUD_DIVERGED, "no step is long enough to continue at t = %.9g s", now_s);
    struct row_name name = name_row(run->state.model, row);
    return thud_error_refuse(err, THUD_DIVERGED, name.key, NULL, "%s %s endlessly at t = %.9g s", name.words,
                             thud_model_row_storey(run->state.model, row) ? "yields and unloads" : "switches", now_s);
}

/* Contacts that switch endlessly at one instant: their motion is below the resolution of the method or of rounding
 * (neighbours that stand together at rest, a bounce that has died down). A moment later, nothing switched, it shows
 * which way they go. */
static enum thud_status skip_accumulating(struct thud_run *run, struct thud_proposal *p, struct thud_error *err)
{
    if (run->progress.passes >= PASSES_MAX)
        return stalled(run, p->contact, err);
    p->switched = false;
    p->passed = true;
    p->s = fmin(p->limit, ldexp(THUD_TOL_MOMENT_S, run->progress.passes++) / run->seg.h_s);
    run->progress.stalls = 0;
    return THUD_OK;
}

/* Endlessly accumulating events, each with a step of its own. */
static enum thud_status watch_crowd(struct thud_run *run, const struct thud_proposal *p, struct thud_error *err)
{
    struct thud_progress *progress = &run->progress;
    double now_s = thud_state_now(&run->state);
    if (now_s - progress->from_s > crowd_part * run->state.end_s) {
        progress->from_s = now_s;
        progress->events = 0;
    }
    progress->events += p->switched;
    if (progress->events < crowd)
        return THUD_OK;
    struct row_name name = name_row(run->state.model, p->contact);
    const bool storey = thud_model_row_storey(run->state.model, p->contact) != NULL;
    return thud_error_refuse(
        err, THUD_DIVERGED, name.key,
        storey ? "more hardening, or a larger tolerance, lets a storey come to rest at its yield drift"
               : "a restitution below 1, a larger tolerance or a law with a force lets bounces come to rest",
        "%s %ld times from t = %.9g s to %.9g s, last %s", storey ? "storeys yield and unload" : "contacts switch",
        crowd, progress->from_s, now_s, name.words);
}

/* Counts the steps that stay at one moment, or so near to it that no motion lies between, and what it took to leave it.
 */
enum thud_status thud_run_watch_progress(struct thud_run *run, struct thud_proposal *p, struct thud_error *err)
{
    double moved_s = p->s * run->seg.h_s;
    enum thud_status status = p->switched ? watch_crowd(run, p, err) : THUD_OK;
    if (status != THUD_OK)
        return status;
    if (moved_s > THUD_TOL_MOMENT_S) {
        run->progress.stalls = 0;
        if (run->progress.passes > 0 && moved_s > 4 * ldexp(THUD_TOL_MOMENT_S, run->progress.passes))
            run->progress.passes = 0;
        return THUD_OK;
    }
    /* of two events that follow each other at one instant, now this one, now the other is passed over: one opens */
    const int passes = run->progress.passes, each = STALLS_MORE + STALLS_EACH * run->state.model->nrows;
    const int most = each * (passes < PASSES_FEW ? 1 : passes) + passes % 2;
    return ++run->progress.stalls > most ? skip_accumulating(run, p, err) : THUD_OK;
}
