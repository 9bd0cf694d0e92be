/* The run: propose a segment, locate its first event, observe it up to there, commit, switch the contact, and so on. */
#include <math.h>
#include <string.h>

#include "core/relative_displacement.h"
#include "core/run_private.h"

enum { LOOKS_APART = 64 }; /* segments between two looks at the balance of energy */

/* Peaks, histories and energies of the segment up to s. */
static enum thud_status read_segment(struct thud_run *run, double s, bool switches, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    double *end = run->peaks.ends + 3 * run->state.model->nmodes; /* q, q' at s: read by the peaks, and committed */
    thud_segment_state(&run->seg, run->state.model->nmodes, s, end, end + run->state.model->nmodes);
    thud_peaks_segment(&run->peaks, &run->state, &run->seg, &run->log, s);
    if (run->relative_m)
        thud_relative_displacement_segment(run, s);
    if (run->options.keep_history)
        status = thud_history_segment(run, s, switches || !run->state.locates, err);
    thud_ledger_segment(run, s);
    return status;
}

/* Puts the run at s of its segment; `limit` is the s of the next kink or the end. */
static void commit(struct thud_run *run, double s, double limit)
{
    if (s <= 0)
        return;
    double to_end = run->state.end_s - thud_state_now(&run->state),
           to_kink = run->state.grid_dt_s - run->state.offset_s;
    size_t n = (size_t)run->state.model->nmodes;
    memcpy(run->state.q, run->peaks.ends + 3 * n, n * sizeof *run->state.q);
    memcpy(run->state.qd, run->peaks.ends + 4 * n, n * sizeof *run->state.qd);
    /* what many steps' rounding leaves before the kink is nothing to take a step for */
    if (to_kink - s * run->seg.h_s > THUD_TOL_TIME * run->state.grid_dt_s) {
        run->state.offset_s += s * run->seg.h_s;
    } else {
        run->state.grid++;
        run->state.offset_s = 0;
    }
    if (s >= limit && to_end <= to_kink * (1 + THUD_TOL_SEGMENT_END))
        run->done = run->done || run->state.end_s - thud_state_now(&run->state) <= THUD_TOL_TIME * run->state.end_s;
    for (int c = 0; c < run->state.model->ncontacts; c++)
        run->state.contact[c].largest_force_n = run->result.contact[c].force.value;
    thud_contact_moved(&run->state);
}

/* One proposed segment: events located, read out, committed, contacts switched. */
static enum thud_status segment(struct thud_run *run, struct thud_error *err)
{
    struct thud_proposal p = {.contact = -1, .event = THUD_EVENT_NONE};
    enum thud_status status = thud_run_propose(run, &p, err);
    if (status != THUD_OK)
        return status;
    if (++run->work.steps % LOOKS_APART == 0)
        thud_ledger_watch(run);
    status = thud_run_watch_progress(run, &p, err);
    if (status == THUD_OK && p.s > 0)
        status = read_segment(run, p.s, p.switched, err);
    if (status != THUD_OK)
        return status;
    bool switched = p.switched;
    commit(run, p.s, p.limit);
    status = thud_run_check_state(run, run->state.q, run->state.qd, err);
    if (status == THUD_OK && switched)
        status = thud_contact_switch(&run->state, &run->log, p.contact, p.event, err);
    if (status == THUD_OK && !run->state.locates)
        status = thud_contact_update(&run->state, &run->log, &switched, err);
    thud_ledger_impulses(run);
    run->switched = run->switched || switched;
    if (status == THUD_OK && run->method->committed)
        run->method->committed(&run->state, run->own, &run->seg, p.s * run->seg.h_s, switched || p.passed);
    return status;
}

enum thud_status thud_run_advance(struct thud_run *run, long budget, bool *done, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    while (budget-- > 0 && !run->done && status == THUD_OK) {
        int passed = 0;
        if (run->free_vibration && run->state.nactive == 0)
            status = thud_free_vibration_go(run, &passed, err);
        run->done = run->state.end_s - thud_state_now(&run->state) <= THUD_TOL_TIME * run->state.end_s;
        if (passed == 0 && !run->done && status == THUD_OK)
            status = segment(run, err);
    }
    thud_run_finish(run);
    *done = run->done;
    return status == THUD_OK && run->done ? thud_ledger_judge(run, err) : status;
}
