/* The run: propose a segment, locate its first event, show it up to there to the observers, commit, switch the contact or
 * the storey, and so on. */
#include <assert.h>
#include <math.h>
#include <string.h>

#include "core/contact/storey.h"
#include "core/observe/contact_work.h"
#include "core/run/run_private.h"

static enum thud_status observe(struct thud_run *run, const struct thud_proposal *p, struct thud_error *err)
{
    size_t n = (size_t)run->state.model->nmodes;
    struct thud_observation o = {.state = &run->state,
                                 .seg = &run->seg,
                                 .s = p->s,
                                 .q = run->end,
                                 .qd = run->end + n,
                                 .switches = p->switched || !run->state.locates,
                                 .work = run->contact_work};
    enum thud_status status = THUD_OK;
    if (run->seg.end) {
        o.q = run->seg.end->q;
        o.qd = run->seg.end->qd;
    } else {
        if (run->state.locates && !p->switched && run->seg.notes->end_s == p->s) /* the search for events has read it */
            memcpy(run->end, run->seg.notes->end, 2 * n * sizeof *run->end);
        else
            thud_segment_state(&run->seg, run->state.model->nmodes, p->s, run->end, run->end + n);
    }
    if (run->observers > 0)
        o.works = thud_contact_works(&o, run->contact_work);
    for (int i = 0; i < run->observers && status == THUD_OK; i++)
        if (run->observer[i].table->segment)
            status = run->observer[i].table->segment(run->observer[i].own, &o, err);
    return status;
}

/* Puts the run where the segment was taken to. */
static void commit(struct thud_run *run, const struct thud_proposal *p)
{
    struct thud_state *state = &run->state;
    size_t n = (size_t)state->model->nmodes;
    double to_kink = state->grid_dt_s - state->offset_s;
    memcpy(state->q, run->seg.end ? run->seg.end->q : run->end, n * sizeof *state->q);
    memcpy(state->qd, run->seg.end ? run->seg.end->qd : run->end + n, n * sizeof *state->qd);
    /* what many steps' rounding leaves before the kink is nothing to take a step for */
    if (to_kink - p->s * run->seg.h_s > THUD_TOL_TIME * state->grid_dt_s) {
        state->offset_s += p->s * run->seg.h_s;
    } else {
        state->grid++;
        state->offset_s = 0;
    }
    if (!state->inside) /* of such steps nothing is asked but their ends, and no storey yields */
        return;
    thud_contact_moved(state);
    thud_storeys_moved(state);
}

/* One proposed segment: events located, read out, committed, contacts switched. */
static enum thud_status segment(struct thud_run *run, struct thud_error *err)
{
    struct thud_proposal p = {.contact = -1, .event = THUD_EVENT_NONE};
    enum thud_status status = thud_run_propose(run, &p, err);
    run->work.steps += run->seg.steps;
    if (status == THUD_OK)
        status = thud_run_watch_progress(run, &p, err);
    if (status == THUD_OK && p.s > 0)
        status = thud_contacts_begin(&run->state, &run->log, &run->seg, p.s, err);
    if (status == THUD_OK && p.s > 0)
        status = observe(run, &p, err);
    if (status != THUD_OK)
        return status;
    const bool falls = p.switched && p.event == THUD_EVENT_COLLAPSE;
    bool switched = p.switched;
    if (p.s > 0) {
        commit(run, &p);
        status = thud_contacts_end(&run->state, &run->log, &run->seg, p.s, err);
    }
    if (status == THUD_OK && !run->seg.end) /* else it has been looked at as a proposal */
        status = thud_run_check_state(run, run->state.q, run->state.qd, err);
    if (status == THUD_OK && falls)
        thud_run_collapse(run, p.contact - run->state.model->nrows);
    else if (status == THUD_OK && switched && thud_model_row_storey(run->state.model, p.contact))
        thud_storey_switch(&run->state, p.contact, p.event);
    else if (status == THUD_OK && switched)
        status = thud_contact_switch(&run->state, &run->log, p.contact, p.event, err);
    if (status == THUD_OK && switched)
        status = thud_contact_log_event(&run->log, &run->state, thud_state_now(&run->state), p.contact, p.event,
                                        p.order, err);
    if (status == THUD_OK && !run->state.locates)
        status = thud_contact_update(&run->state, &run->log, run->seg.end && run->seg.end->apart, &switched, err);
    for (int i = 0; i < run->observers && switched && !falls; i++)
        if (run->observer[i].table->switched)
            run->observer[i].table->switched(run->observer[i].own, &run->state, p.contact, p.event);
    if (status == THUD_OK && run->method->stepper->committed)
        run->method->stepper->committed(&run->state, run->own, &run->seg, p.s * run->seg.h_s, switched || p.passed);
    return status;
}

enum thud_status thud_run_advance(struct thud_run *run, long budget, bool *done, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    assert(budget > 0);
    while (budget-- > 0 && !run->done && status == THUD_OK) {
        bool passed = false;
        status = thud_run_contact_free(run, &budget, &passed, err);
        if (!passed && status == THUD_OK)
            status = segment(run, err);
        thud_run_watch_collapse(run);
        run->done = run->result.collapse.happened ||
                    run->state.end_s - thud_state_now(&run->state) <= THUD_TOL_TIME * run->state.end_s;
    }
    thud_run_finish(run);
    *done = run->done;
    return status == THUD_OK && run->done ? thud_run_judge(run, err) : status;
}
