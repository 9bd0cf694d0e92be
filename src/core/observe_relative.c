#include "core/observe_relative.h"

#include <math.h>

#include "core/free_vibration.h"
#include "core/poly.h"

/* Raises the largest value of contact c by its polynomial in the segment up to s. */
static void raise_value(double *largest, const struct thud_state *state, const struct thud_segment *seg, int c,
                        double s)
{
    double d[THUD_SEGMENT_TERMS], where, size = 0;
    thud_segment_indentation(state, seg, c, d);
    d[0] += thud_state_clearance(state, c);
    for (int k = 0; k < seg->terms; k++)
        size += fabs(d[k]);
    d[0] += size; /* so that the largest value is the largest absolute one */
    *largest = fmax(*largest, thud_poly_peak(d, seg->terms, s, *largest + size, &where) - size);
}

static enum thud_status segment(void *own, const struct thud_observation *o, struct thud_error *err)
{
    double *largest = own;
    (void)err;
    for (int c = 0; c < o->state->model->ncontacts; c++)
        if (o->seg->end)
            largest[c] = fmax(largest[c], thud_model_gap_sum(o->state->model, c, o->q));
        else
            raise_value(&largest[c], o->state, o->seg, c, o->s);
    return THUD_OK;
}

static enum thud_status block(void *own, const struct thud_state *state, struct thud_free_vibration *f, int intervals,
                              struct thud_error *err)
{
    double *largest = own;
    (void)err;
    for (int c = 0; c < state->model->ncontacts; c++) {
        double margin, most = thud_free_vibration_gap(f, state->model, c, intervals + 1, &margin);
        if (most + margin <= largest[c])
            continue;
        double limit = fmax(largest[c], most) - margin;
        for (int t = 0; t < intervals; t++)
            for (int piece = 0; piece < f->pieces && fmax(f->gap[t], f->gap[t + 1]) >= limit; piece++)
                raise_value(&largest[c], state, thud_free_vibration_series(f, state, t, piece), c, 1);
    }
    return THUD_OK;
}

const struct thud_observer thud_observe_relative = {segment, block};
