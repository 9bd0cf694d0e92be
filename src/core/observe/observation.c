/* What a segment may be asked (observer.h): the one place that knows which of its parts a method has filled. */
#include <math.h>
#include <string.h>

#include "core/observe/observer.h"

/* The nearest end of steps that have no polynomials. */
static const struct thud_motion *end_at(const struct thud_observation *o, double s)
{
    const int left = (int)ceil((1 - s / o->s) * o->seg->steps - 0.5);
    return left == o->seg->steps ? o->seg->start : o->seg->end - left;
}

void thud_observation_state(const struct thud_observation *o, double s, double *q, double *qd)
{
    const size_t bytes = (size_t)o->state->model->nmodes * sizeof *q;
    if (o->seg->terms > 0) {
        thud_segment_state(o->seg, o->state->model->nmodes, s, q, qd);
        return;
    }
    memcpy(q, end_at(o, s)->q, bytes);
    memcpy(qd, end_at(o, s)->qd, bytes);
}

void thud_observation_forces(const struct thud_observation *o, double s, double *force)
{
    const struct thud_model *m = o->state->model;
    const int rows = m->nrows;
    for (int c = 0; c < rows; c++) {
        force[c] = o->seg->terms > 0 ? 0 : end_at(o, s)->force[c];
        for (int k = o->seg->terms - 1; k >= 0; k--)
            force[c] = force[c] * s + o->seg->force[k * rows + c];
        const bool pushes = c < m->ncontacts && !(m->contact[c].law->flags & THUD_LAW_PULLS);
        if (s <= o->seg->notes->begun[c] || s >= thud_segment_ended(o->seg, c) ||
            (pushes && force[c] < 0)) /* but for the tolerance */
            force[c] = 0;
    }
}

void thud_observation_acceleration(const struct thud_observation *o, double s, const double *q, const double *qd,
                                   const double *force, double *out)
{
    const struct thud_model *m = o->state->model;
    const struct thud_segment *seg = o->seg;
    if (seg->interpolates) {
        thud_model_acceleration(m, q, qd, 0, out);
        thud_model_apply_contact_forces(m, force, out);
        return;
    }
    for (int j = 0; j < m->nmodes; j++) {
        double sum = 0;
        for (int k = seg->terms - 3; k >= 0; k--)
            sum = sum * s + (k + 1) * (k + 2) * seg->q[(k + 2) * m->nmodes + j];
        out[j] = sum / (seg->h_s * seg->h_s) + m->gamma[j] * thud_observation_ground(o, s);
    }
}

bool thud_observer_jumps(const void *own, const struct thud_rest *rest)
{
    (void)own, (void)rest;
    return true;
}
