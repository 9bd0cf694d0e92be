/* Motion inside an interval as power series, of one system at a time, made only where it is asked for; all that the
 * segment has are of one piece. */
#include "core/motion/free_vibration_parts.h"

#include <assert.h>
#include <math.h>

/* Modal state of a system at the start of a piece: that of the block, or of the piece before it at its end. */
static void start_piece(struct thud_free_vibration *f, const struct thud_model_structure *p, int t, int piece)
{
    double *q = f->series.now, *qd = f->series.now_rate, rate = 1 / f->series.seg.h_s;
    const int first = p->first_mode, end = first + p->modes;
    for (int j = first; j < end; j++) {
        q[j] = piece > 0 ? 0 : f->q[j * ENDS + t];
        qd[j] = piece > 0 ? 0 : f->qd[j * ENDS + t];
    }
    for (int k = f->series.seg.terms - 1; piece > 0 && k >= 0; k--)
        for (int j = first; j < end; j++) {
            qd[j] += q[j];
            q[j] += f->series.seg.q[k * f->n + j];
        }
    for (int j = first; j < end && piece > 0; j++)
        qd[j] *= rate;
}

/* The coefficients of a system's modes at the segment's time, out of its state at the start of the piece. */
static void make_series(struct thud_free_vibration *f, const struct thud_state *state, int structure)
{
    const struct thud_coupled_motion *by = thud_free_vibration_motion(f, state->model->structure[structure].system);
    thud_taylor_structure(state, &f->series.seg, structure, by->soft, f->series.now, f->series.now_rate);
    f->made++;
}

/* Of systems that have not been made at the segment's time it has no number. */
static void forget_series(struct thud_free_vibration *f, const struct thud_model_structure *p)
{
    for (int k = 0; k < f->series.seg.terms; k++)
        for (int j = p->first_mode; j < p->first_mode + p->modes; j++)
            f->series.seg.q[k * f->n + j] = NAN;
}

/* Takes the segment to another piece; to the next one of the same interval with the systems that it has. */
static void place_series(struct thud_free_vibration *f, const struct thud_state *state, int t, int piece)
{
    struct thud_free_vibration_series *series = &f->series;
    const struct thud_model *m = state->model;
    const double h = f->dt_s / f->pieces;
    if (series->t == t && series->piece == piece)
        return;
    const bool goes_on = series->t == t && series->piece >= 0 && piece == series->piece + 1;
    thud_segment_ground(state, &series->seg, state->grid + t, piece * h, h);
    series->t = t;
    series->piece = piece;
    for (int s = 0; s < m->nsystems; s++) {
        if (series->has[s] && goes_on) {
            start_piece(f, &m->structure[m->system[s]], t, piece);
            make_series(f, state, m->system[s]);
        } else if (series->has[s]) {
            forget_series(f, &m->structure[m->system[s]]);
            series->has[s] = false;
        }
    }
}

const struct thud_segment *thud_free_vibration_series(struct thud_free_vibration *f, const struct thud_state *state,
                                                      int structure, int t, int piece)
{
    const double h = f->dt_s / f->pieces;
    bool *has = &f->series.has[state->model->structure[structure].system];
    assert(t >= 0 && t + 1 < f->ends && piece >= 0 && piece < f->pieces);
    place_series(f, state, t, piece);
    for (int i = 0; i <= piece && !*has; i++) {
        start_piece(f, &state->model->structure[structure], t, i);
        thud_segment_ground(state, &f->series.seg, state->grid + t, i * h, h);
        make_series(f, state, structure);
    }
    *has = true;
    return &f->series.seg;
}

const struct thud_segment *thud_free_vibration_row_series(struct thud_free_vibration *f, const struct thud_state *state,
                                                          int c, int t, int piece)
{
    int structure[2], n = thud_model_row_structures(state->model, c, structure);
    for (int i = 0; i < n; i++)
        thud_free_vibration_series(f, state, structure[i], t, piece);
    return &f->series.seg;
}

const struct thud_segment *thud_free_vibration_all_series(struct thud_free_vibration *f, const struct thud_state *state,
                                                          int t, int piece)
{
    const struct thud_model *m = state->model;
    for (int s = 0; s < m->nsystems; s++)
        if (m->structure[m->system[s]].modes > 0)
            thud_free_vibration_series(f, state, m->system[s], t, piece);
    return &f->series.seg;
}
