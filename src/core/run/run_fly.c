/* Between contacts, where the method leaves free flight to the recurrence of the modes. */
#include "core/contact/storey.h"
#include "core/run/run_private.h"

enum thud_status thud_run_fly(struct thud_run *run, long *budget, bool *passed, struct thud_error *err)
{
    struct thud_free_vibration *f = run->free_vibration;
    struct thud_state *state = &run->state;
    *passed = false;
    if (!f || state->nactive > 0)
        return THUD_OK;
    if (run->early_end && thud_early_end_holds(run->early_end, state, &run->result, run->end)) {
        thud_ledger_close(&run->ledger, state);
        run->work.samples_jumped += thud_early_end_jump(run->early_end, state);
        *passed = true;
        return THUD_OK;
    }
    const long made = f->made;
    int intervals = thud_free_vibration_march(f, state);
    if (intervals == 0) {
        *budget -= f->made - made;
        return THUD_OK;
    }
    enum thud_status status = THUD_OK;
    for (int i = 0; i < run->observers && status == THUD_OK; i++)
        status = run->observer[i].table->block(run->observer[i].own, state, f, intervals, err);
    thud_free_vibration_end(f, intervals, state->q, state->qd);
    state->grid += intervals;
    thud_contact_moved(state);
    thud_storeys_moved(state);
    run->work.samples_fast += intervals;
    *budget -= f->made - made;
    *passed = true;
    return status;
}
