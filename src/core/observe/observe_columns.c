/* Peaks of what struck columns feel: shears and moments at their two ends. Each is
 *     x = per_drift d + per_yield F_storey + sum_c per_force_c F_c
 * with the factors of model.h: linear in the storey's drift, in the force of its row where it yields, and in the slabs'
 * forces. Where no slab acts it is the drift alone, whose bounds in a block the floors' drifts have. */
#include "core/observe/observe_columns.h"

#include <math.h>

#include "core/motion/free_vibration.h"
#include "core/numerics/vec.h"
#include "core/observe/rest.h"

enum { ENDS = THUD_FREE_VIBRATION_ENDS };

/* Drift by which columns not struck come to a peak that is none yet. */
static double least_drift(const struct thud_model_column *p, const struct thud_column_result *r)
{
    double least = INFINITY;
    for (int q = 0; q < THUD_COLUMN_QUANTITIES; q++)
        if (p->per_drift[q] != 0)
            least = fmin(least, r->peak[q].value / fabs(p->per_drift[q]));
    return least;
}

/* Coefficients of the storey's drift. */
static void drift_polynomial(const struct thud_model_column *p, const struct thud_segment *seg, int nmodes, double *out)
{
    thud_dots(p->modes, p->row, seg->q + p->first_mode, nmodes, seg->terms, out);
}

/* Bound of a polynomial up to s: coefficients `stride` apart. */
static double bound(const double *p, int stride, int terms, double s)
{
    double sum = 0, power = 1;
    for (int k = 0; k < terms; k++, power *= s)
        sum += power * fabs(p[k * stride]);
    return sum;
}

/* Adds `per` times the size of a part to what the quantities can come to. */
static void add_bound(double most[THUD_COLUMN_QUANTITIES], const double per[THUD_COLUMN_QUANTITIES], double size)
{
    for (int q = 0; q < THUD_COLUMN_QUANTITIES; q++)
        most[q] += fabs(per[q]) * size;
}

static void add_part(double *x, double per, const double *p, int stride, int terms)
{
    for (int k = 0; per != 0 && k < terms; k++)
        x[k] += per * p[k * stride];
}

/* From the drift and, where there are any, the forces of the storey's row and of the slabs. Most segments come nowhere
 * near a peak, which a bound of their parts tells. */
static void look(const struct thud_model *m, const struct thud_segment *seg, int column, bool forces,
                 struct thud_column_result *r, double s)
{
    const struct thud_model_column *p = &m->column[column];
    double drift[THUD_SEGMENT_TERMS], most[THUD_COLUMN_QUANTITIES] = {0};
    drift_polynomial(p, seg, m->nmodes, drift);
    add_bound(most, p->per_drift, bound(drift, 1, seg->terms, s));
    if (p->yielding >= 0)
        add_bound(most, p->per_yield, bound(seg->force + p->yielding, m->nrows, seg->terms, s));
    for (int c = 0; forces && c < m->ncontacts; c++)
        if (m->contact[c].column == column)
            add_bound(most, m->contact[c].per_force, bound(seg->force + c, m->nrows, seg->terms, s));
    for (int q = 0; q < THUD_COLUMN_QUANTITIES; q++) {
        double x[THUD_SEGMENT_TERMS] = {0};
        if (most[q] <= r->peak[q].value)
            continue;
        add_part(x, p->per_drift[q], drift, 1, seg->terms);
        if (p->yielding >= 0)
            add_part(x, p->per_yield[q], seg->force + p->yielding, m->nrows, seg->terms);
        for (int c = 0; forces && c < m->ncontacts; c++)
            if (m->contact[c].column == column)
                add_part(x, m->contact[c].per_force[q], seg->force + c, m->nrows, seg->terms);
        thud_peak_raise(&r->peak[q], seg, x, seg->terms, s);
    }
}

/* Or what the drift alone does not tell. */
static bool is_struck(const struct thud_observation *o, int column)
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
        if (is_struck(o, i))
            look(o->state->model, o->seg, i, true, &result->column[i], o->s);
        else if (o->state->model->column[i].per_drift[0] != 0)
            look(o->state->model, o->seg, i, false, &result->column[i], o->s);
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
static double drifts(struct thud_free_vibration *f, const struct thud_model *m, const struct thud_model_column *p,
                     int ends)
{
    thud_free_vibration_values(f, m, p->structure, THUD_FLOOR_DISPLACEMENT);
    const struct thud_model_structure *of = &m->structure[p->structure];
    const double *u = f->value[THUD_FLOOR_DISPLACEMENT] + (size_t)of->first * ENDS;
    double most = 0;
    for (int t = 0; t < ends; t++) {
        f->gap[t] = fabs(thud_model_drift(of, u + t, ENDS, p->storey - 1));
        most = fmax(most, f->gap[t]);
    }
    return most;
}

/* Size of what a storey that has yielded adds to its drift in the columns' part of its shear. */
static double plastic_drift(const struct thud_state *state, const struct thud_model_column *p)
{
    if (p->yielding < 0)
        return 0;
    return fabs(thud_row_branch(state, p->yielding)->f0_n * p->per_yield[0] / p->per_drift[0]);
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
        double most = drifts(f, m, p, intervals + 1);
        if (most + shift + margin <= least)
            continue;
        double limit = fmax(least - shift, most - 2 * shift) - margin;
        for (int t = 0; t < intervals; t++)
            for (int piece = 0; piece < f->pieces && fmax(f->gap[t], f->gap[t + 1]) >= limit; piece++)
                look(m, thud_free_vibration_series(f, state, p->structure, t, piece), i, false, &result->column[i], 1);
    }
    return THUD_OK;
}

static bool may_jump(const void *own, const struct thud_rest *rest)
{
    const struct thud_result *result = own;
    for (int i = 0; i < rest->model->ncolumns; i++) {
        const struct thud_model_column *p = &rest->model->column[i];
        if (!(thud_rest_drift(rest, p) <= least_drift(p, &result->column[i])))
            return false;
    }
    return true;
}

const struct thud_observer thud_observe_columns = {.segment = segment, .block = block, .may_jump = may_jump};
