/* Between contacts, where the method leaves the response to the recurrence of the modes. */
#include "core/contact/storey.h"
#include "core/run/run_private.h"

/* The intervals of the block, one after the other. */
static enum thud_status show_segments(struct thud_run *run, const struct thud_listener *to, int intervals,
                                      struct thud_error *err)
{
    const int n = run->state.model->nmodes;
    enum thud_status status = THUD_OK;
    for (int t = 0; t < intervals; t++)
        for (int piece = 0; piece < run->free_vibration->pieces && status == THUD_OK; piece++) {
            const struct thud_segment *seg = thud_free_vibration_all_series(run->free_vibration, &run->state, t, piece);
            struct thud_observation o = {.state = &run->state, .seg = seg, .s = 1, .q = run->end, .qd = run->end + n};
            thud_segment_state(seg, n, 1, run->end, run->end + n);
            status = to->table->segment(to->own, &o, err);
        }
    return status;
}

static enum thud_status show_block(struct thud_run *run, int intervals, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (int i = 0; i < run->observers && status == THUD_OK; i++) {
        const struct thud_listener *to = &run->observer[i];
        if (to->table->block)
            status = to->table->block(to->own, &run->state, run->free_vibration, intervals, err);
        else if (to->table->segment)
            status = show_segments(run, to, intervals, err);
    }
    return status;
}

/* To the end of the record in one step, where no contact can close any more and no observer needs what is left out. */
static bool jump(struct thud_run *run)
{
    struct thud_rest rest;
    if (!run->early_end || !thud_early_end_holds(run->early_end, &run->state, run->end, &rest))
        return false;
    for (int i = 0; i < run->observers; i++)
        if (!run->observer[i].table->may_jump || !run->observer[i].table->may_jump(run->observer[i].own, &rest))
            return false;
    for (int i = 0; i < run->observers; i++)
        if (run->observer[i].table->jumped)
            run->observer[i].table->jumped(run->observer[i].own, &run->state);
    run->work.samples_jumped += thud_early_end_jump(run->early_end, &run->state);
    return true;
}

enum thud_status thud_run_contact_free(struct thud_run *run, long *budget, bool *passed, struct thud_error *err)
{
    struct thud_free_vibration *f = run->free_vibration;
    struct thud_state *state = &run->state;
    *passed = false;
    if (!f || state->nactive > 0)
        return THUD_OK;
    if ((*passed = jump(run)))
        return THUD_OK;
    const long made = f->made;
    int intervals = thud_free_vibration_advance(f, state);
    if (intervals == 0) {
        *budget -= f->made - made;
        return THUD_OK;
    }
    enum thud_status status = show_block(run, intervals, err);
    thud_free_vibration_end(f, intervals, state->q, state->qd);
    state->grid += intervals;
    thud_contact_moved(state);
    thud_storeys_moved(state);
    run->work.samples_fast += intervals;
    *budget -= f->made - made;
    *passed = true;
    return status == THUD_OK ? thud_run_check_state(run, state->q, state->qd, err) : status;
}
