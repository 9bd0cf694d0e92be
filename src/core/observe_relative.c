#include "core/observe_relative.h"

#include <math.h>

#include "core/double_pair.h"
#include "core/free_vibration.h"
#include "core/poly.h"

/* Raises the largest value by a polynomial up to s: of p itself, or of its size. */
static void raise(double *largest, double *p, int terms, double s, bool size)
{
    double where, shift = 0;
    for (int k = 0; k < terms && !size; k++)
        shift += fabs(p[k]);
    p[0] += shift; /* so that the largest value is the largest absolute one */
    *largest = fmax(*largest, thud_poly_peak(p, terms, s, *largest + shift, &where) - shift);
}

static void raise_relative(double *largest, const struct thud_state *state, const struct thud_segment *seg, int c,
                           double s)
{
    double d[THUD_SEGMENT_TERMS];
    thud_segment_indentation(state, seg, c, d);
    d[0] += thud_state_clearance(state, c);
    raise(largest, d, seg->terms, s, false);
}

/* The side of contact c that is no floor; NULL where both are. */
static const struct thud_model_side *struck_side(const struct thud_model *m, int c)
{
    return m->contact[c].struck == 0 ? NULL : m->contact[c].struck < 0 ? &m->contact[c].left : &m->contact[c].right;
}

static void raise_struck(double *largest, const struct thud_model *m, const struct thud_segment *seg,
                         const struct thud_model_side *side, double s)
{
    double u[THUD_SEGMENT_TERMS];
    for (int k = 0; k < seg->terms; k++)
        u[k] = thud_dot(side->modes, side->row, seg->q + k * m->nmodes + side->first_mode);
    raise(largest, u, seg->terms, s, true);
}

static enum thud_status segment(void *own, const struct thud_observation *o, struct thud_error *err)
{
    double *largest = own;
    (void)err;
    for (int c = 0; c < o->state->model->ncontacts; c++)
        if (o->seg->end)
            largest[c] = fmax(largest[c], thud_model_gap_sum(o->state->model, c, o->q));
        else
            raise_relative(&largest[c], o->state, o->seg, c, o->s);
    for (int c = 0; c < o->state->model->ncontacts; c++)
        if (struck_side(o->state->model, c))
            raise_struck(&largest[o->state->model->ncontacts + c], o->state->model, o->seg,
                         struck_side(o->state->model, c), o->s);
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
                raise_relative(&largest[c], state, thud_free_vibration_series(f, state, t, piece), c, 1);
    }
    for (int c = 0; c < state->model->ncontacts; c++) {
        const struct thud_model_side *side = struck_side(state->model, c);
        double *peak = &largest[state->model->ncontacts + c];
        double margin, most = side ? thud_free_vibration_side(f, side, intervals + 1, &margin) : 0;
        if (!side || most + margin <= *peak)
            continue;
        double limit = fmax(*peak, most) - margin;
        for (int t = 0; t < intervals; t++)
            for (int piece = 0; piece < f->pieces && fmax(f->gap[t], f->gap[t + 1]) >= limit; piece++)
                raise_struck(peak, state->model, thud_free_vibration_series(f, state, t, piece), side, 1);
    }
    return THUD_OK;
}

const struct thud_observer thud_observe_relative = {segment, block};
