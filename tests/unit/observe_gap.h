/* An observer as one writes it who needs another quantity: the gap of the first contact in time, whose clearance grows
 * by what impacts leave. It asks for segments and for contacts that have switched, and for nothing else. */
#pragma once

#include <math.h>

#include "core/observe/observer.h"

struct observe_gap {
    double gap_m, until_s; /* where it has been followed to */
    double covered_s;      /* sum of all pieces' lengths */
    double hole_s;         /* largest time between the end of a piece and the start of the next */
    double widened_m;      /* sum of what the gap has grown by at one moment */
    double narrowest_m;    /* least gap at ends of pieces */
    long switches;
};

static double observe_gap_at(const struct thud_state *state, const double *q)
{
    return thud_state_clearance(state, 0) - thud_model_gap_sum(state->model, 0, q);
}

static enum thud_status observe_gap_segment(void *own, const struct thud_observation *o, struct thud_error *err)
{
    struct observe_gap *g = own;
    (void)err;
    g->hole_s = fmax(g->hole_s, fabs(o->seg->start_s - g->until_s));
    g->until_s = o->seg->start_s + o->s * o->seg->h_s;
    g->covered_s += o->s * o->seg->h_s;
    g->gap_m = observe_gap_at(o->state, o->q);
    g->narrowest_m = fmin(g->narrowest_m, g->gap_m);
    return THUD_OK;
}

static void observe_gap_switched(void *own, const struct thud_state *state, int row, enum thud_event event)
{
    struct observe_gap *g = own;
    (void)row, (void)event;
    g->widened_m += observe_gap_at(state, state->q) - g->gap_m;
    g->gap_m = observe_gap_at(state, state->q);
    g->switches++;
}

static const struct thud_observer observe_gap = {.segment = observe_gap_segment, .switched = observe_gap_switched};
