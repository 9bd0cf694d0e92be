#include "core/relative_displacement.h"

#include <math.h>

#include "core/poly.h"

enum { ENDS = THUD_FREE_VIBRATION_ENDS };

/* Raises the closing of contact c by its polynomial in the run's segment. */
static void raise_closing(struct thud_run *run, int c, double s)
{
    double d[THUD_SEGMENT_TERMS], where, size = 0;
    int terms = run->seg.terms;
    thud_segment_indentation(&run->state, &run->seg, c, d);
    d[0] += thud_state_clearance(&run->state, c);
    for (int k = 0; k < terms; k++)
        size += fabs(d[k]);
    d[0] += size; /* so that the largest value is the largest absolute one */
    run->relative_m[c] =
        fmax(run->relative_m[c], thud_poly_peak(d, terms, s, run->relative_m[c] + size, &where) - size);
}

void thud_relative_displacement_segment(struct thud_run *run, double s)
{
    for (int c = 0; c < run->state.model->ncontacts; c++)
        raise_closing(run, c, s);
}

static void look_at(struct thud_run *run, struct thud_free_vibration *f, int c, int t)
{
    long base = run->state.grid;
    run->state.grid += t;
    for (int j = 0; j < f->n; j++) {
        f->now[j] = f->q[j * ENDS + t];
        f->now_rate[j] = f->qd[j * ENDS + t];
    }
    for (int piece = 0; piece < f->pieces; piece++) {
        run->state.offset_s = piece * run->state.grid_dt_s / f->pieces;
        thud_segment_begin(&run->state, &run->seg, run->state.grid_dt_s / f->pieces);
        thud_taylor_given(run->state.model, &run->seg, f->now, f->now_rate);
        raise_closing(run, c, 1);
        thud_segment_state(&run->seg, f->n, 1, f->now, f->now_rate);
    }
    run->state.grid = base;
    run->state.offset_s = 0;
}

void thud_relative_displacement_block(struct thud_run *run, struct thud_free_vibration *f, int intervals)
{
    const struct thud_model *m = run->state.model;
    for (int c = 0; c < m->ncontacts; c++) {
        double margin, most = thud_free_vibration_gap(f, m, c, intervals + 1, &margin);
        if (most + margin <= run->relative_m[c])
            continue;
        double limit = fmax(run->relative_m[c], most) - margin;
        for (int t = 0; t < intervals; t++)
            if (f->gap[t] >= limit || f->gap[t + 1] >= limit)
                look_at(run, f, c, t);
    }
}
