#include "core/observe_columns.h"

#include <math.h>

#include "core/double_pair.h"
#include "core/free_vibration.h"
#include "core/poly.h"

enum { ENDS = THUD_FREE_VIBRATION_ENDS };

/* Drift by which untouched columns come to a peak that is none yet. */
static double least_drift(const struct thud_model_column *p, const struct thud_column_result *r)
{
    double least = INFINITY;
    for (int q = 0; q < THUD_COLUMN_QUANTITIES; q++)
        if (p->per_drift[q] != 0)
            least = fmin(least, r->peak[q].value / fabs(p->per_drift[q]));
    return least;
}

bool thud_columns_below(const struct thud_model *model, const struct thud_result *result, int column, double drift_m)
{
    return drift_m <= least_drift(&model->column[column], &result->column[column]);
}

/* Coefficients of the storey's drift. */
static void drift_polynomial(const struct thud_model_column *p, const struct thud_segment *seg, int nmodes, double *out)
{
    for (int k = 0; k < seg->terms; k++)
        out[k] = thud_dot(p->modes, p->row, seg->q + k * nmodes + p->first_mode);
}

static void raise(const struct thud_segment *seg, struct thud_peak *peak, const double *p, double s)
{
    double where, value = thud_poly_peak(p, seg->terms, s, peak->value, &where);
    if (value > peak->value)
        *peak = (struct thud_peak){value, seg->start_s + where * seg->h_s};
}

/* Of untouched columns. */
static void by_drift(const struct thud_model *m, const struct thud_segment *seg, int column,
                     struct thud_column_result *r, double s)
{
    const struct thud_model_column *p = &m->column[column];
    double drift[THUD_SEGMENT_TERMS], x[THUD_SEGMENT_TERMS];
    drift_polynomial(p, seg, m->nmodes, drift);
    for (int q = 0; q < THUD_COLUMN_QUANTITIES; q++) {
        for (int k = 0; k < seg->terms; k++)
            x[k] = p->per_drift[q] * drift[k] +
                   (p->yielding >= 0 ? p->per_yield[q] * seg->force[k * m->nrows + p->yielding] : 0);
        raise(seg, &r->peak[q], x, s);
    }
}

static void by_drift_and_force(const struct thud_observation *o, int column, struct thud_column_result *r)
{
    const struct thud_model *m = o->state->model;
    const struct thud_model_column *p = &m->column[column];
    double drift[THUD_SEGMENT_TERMS], x[THUD_SEGMENT_TERMS];
    drift_polynomial(p, o->seg, m->nmodes, drift);
    for (int q = 0; q < THUD_COLUMN_QUANTITIES; q++) {
        for (int k = 0; k < o->seg->terms; k++) {
            x[k] = p->per_drift[q] * drift[k];
            if (p->yielding >= 0)
                x[k] += p->per_yield[q] * o->seg->force[k * m->nrows + p->yielding];
            for (int c = 0; c < m->ncontacts; c++)
                if (m->contact[c].column == column)
                    x[k] += m->contact[c].per_force[q] * o->seg->force[k * m->nrows + c];
        }
        raise(o->seg, &r->peak[q], x, o->s);
    }
}

/* Or what the drift alone does not tell. */
static bool is_touched(const struct thud_observation *o, int column)
{
    const struct thud_model *m = o->state->model;
    if (m->column[column].yielding >= 0)
        return true;
    for (int c = 0; c < m->ncontacts; c++)
        if (m->contact[c].column == column && thud_segment_has_force(o->state, o->seg, c))
            return true;
    return false;
}

static enum thud_status segment(void *own, const struct thud_observation *o, struct thud_error *err)
{
    struct thud_result *result = own;
    (void)err;
    for (int i = 0; i < o->state->model->ncolumns; i++) {
        if (is_touched(o, i))
            by_drift_and_force(o, i, &result->column[i]);
        else if (o->state->model->column[i].per_drift[0] != 0)
            by_drift(o->state->model, o->seg, i, &result->column[i], o->s);
    }
    return THUD_OK;
}

/* Largest drift that the modes of the block can make. */
static double largest_drift(const struct thud_free_vibration *f, const struct thud_model *m,
                            const struct thud_model_column *p)
{
    double sum = 0;
    for (int j = 0; j < p->modes; j++)
        sum += fabs(p->row[j]) * f->speed[p->first_mode + j] / m->omega[p->first_mode + j];
    return sum;
}

/* Drifts at the ends into f->gap; the largest. */
static double drifts(struct thud_free_vibration *f, const struct thud_model_column *p, int ends)
{
    const double *u = f->value[THUD_FLOOR_DISPLACEMENT] + (size_t)p->dof * ENDS,
                 *below = p->below < 0 ? NULL : f->value[THUD_FLOOR_DISPLACEMENT] + (size_t)p->below * ENDS;
    double most = 0;
    for (int t = 0; t < ends; t++) {
        f->gap[t] = fabs(u[t] - (below ? below[t] : 0));
        most = fmax(most, f->gap[t]);
    }
    return most;
}

/* Size of what a storey that has yielded adds to its drift in the columns' part of its shear. */
static double plastic_drift(const struct thud_state *state, const struct thud_model_column *p)
{
    if (p->yielding < 0)
        return 0;
    return fabs(state->contact[p->yielding].branch.f0_n * p->per_yield[0] / p->per_drift[0]);
}

static enum thud_status block(void *own, const struct thud_state *state, struct thud_free_vibration *f, int intervals,
                              struct thud_error *err)
{
    struct thud_result *result = own;
    const struct thud_model *m = state->model;
    (void)err;
    for (int i = 0; i < m->ncolumns; i++) {
        const struct thud_model_column *p = &m->column[i];
        double least = least_drift(p, &result->column[i]), shift = plastic_drift(state, p),
               margin = f->margin[THUD_FLOOR_DRIFT * m->nstructures + p->structure];
        if (least == INFINITY || largest_drift(f, m, p) + shift + margin <= least)
            continue;
        double most = drifts(f, p, intervals + 1);
        if (most + shift + margin <= least)
            continue;
        double limit = fmax(least - shift, most - 2 * shift) - margin;
        for (int t = 0; t < intervals; t++)
            for (int piece = 0; piece < f->pieces && fmax(f->gap[t], f->gap[t + 1]) >= limit; piece++)
                by_drift(m, thud_free_vibration_series(f, state, p->structure, t, piece), i, &result->column[i], 1);
    }
    return THUD_OK;
}

const struct thud_observer thud_observe_columns = {segment, block};
