/* Motion inside an interval as power series, of one structure and one piece at a time, made only where it is asked
 * for. */
#include "core/motion/free_vibration_parts.h"

#include <string.h>

/* Modal state of a structure at the start of a piece: that of the block, or of the piece before it at its end. */
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

const struct thud_segment *thud_free_vibration_series(struct thud_free_vibration *f, const struct thud_state *state,
                                                      int structure, int t, int piece)
{
    struct thud_free_vibration_place *at = &f->series.at[structure];
    const double h = f->dt_s / f->pieces;
    if (at->t != t || at->piece > piece)
        *at = (struct thud_free_vibration_place){t, -1};
    while (at->piece < piece) {
        start_piece(f, &state->model->structure[structure], t, ++at->piece);
        thud_segment_place(state, &f->series.seg, state->grid + t, at->piece * h, h);
        thud_taylor_structure(state->model, &f->series.seg, structure, f->series.now, f->series.now_rate);
        f->made++;
    }
    thud_segment_place(state, &f->series.seg, state->grid + t, piece * h, h); /* it may be another structure's */
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
    for (int s = 0; s < state->model->nstructures; s++)
        if (state->model->structure[s].modes > 0)
            thud_free_vibration_series(f, state, s, t, piece);
    return &f->series.seg;
}
