#include "core/observe/observe_shear.h"

#include <math.h>

#include "base/largest.h"
#include "core/motion/free_vibration.h"
#include "core/numerics/poly.h"
#include "core/numerics/vec.h"
#include "core/observe/rest.h"

enum { ENDS = THUD_FREE_VIBRATION_ENDS };

static struct thud_peak *peak_of(struct thud_result *result, int structure, int storey)
{
    return &result->structure[structure].floor[storey].shear;
}

/* Whether the coefficients of the modes let the shear pass its peak up to s. */
static bool may_pass(const struct thud_model_structure *p, const struct thud_segment *seg, int nmodes,
                     const double *row, double least, double s)
{
    double sum = 0;
    for (int j = 0; j < p->modes && !(sum > least); j++) {
        const double *q = seg->q + p->first_mode + j;
        double most = 0;
        for (int k = seg->terms - 1; k >= 0; k--)
            most = most * s + fabs(q[k * nmodes]);
        sum += fabs(row[j]) * most;
    }
    return sum > least;
}

static void look(const struct thud_model *m, const struct thud_segment *seg, int structure, int storey,
                 struct thud_peak *peak, double s)
{
    const struct thud_model_structure *p = &m->structure[structure];
    const double *row = p->shear + storey * p->modes;
    double x[THUD_SEGMENT_TERMS], where;
    if (!may_pass(p, seg, m->nmodes, row, peak->value, s))
        return;
    for (int k = 0; k < seg->terms; k++)
        x[k] = thud_dot(p->modes, row, seg->q + k * m->nmodes + p->first_mode);
    double value = thud_poly_peak(x, seg->terms, s, peak->value, &where);
    if (value > peak->value)
        *peak = (struct thud_peak){value, seg->start_s + where * seg->h_s};
}

static enum thud_status segment(void *own, const struct thud_observation *o, struct thud_error *err)
{
    struct thud_result *result = own;
    const struct thud_model *m = o->state->model;
    (void)err;
    for (int s = 0; s < m->nstructures; s++)
        for (int i = 0; m->structure[s].shear && i < m->structure[s].n; i++)
            look(m, o->seg, s, i, peak_of(result, s, i), o->s);
    return THUD_OK;
}

/* Largest shear that the modes of the block can make at the ends of its intervals; *margin: how far one inside an
 * interval may lie above. */
static double largest_shear(const struct thud_free_vibration *f, const struct thud_model *m, int structure,
                            const double *row, double *margin)
{
    const struct thud_model_structure *p = &m->structure[structure];
    double sum = 0, bend = 0;
    for (int j = 0; j < p->modes; j++) {
        const int mode = p->first_mode + j;
        sum += fabs(row[j]) * (f->speed[mode] / m->omega[mode] + fabs(f->shift[mode]));
        bend += fabs(row[j]) * thud_free_vibration_bend(f, m, structure, mode);
    }
    *margin = bend * f->dt_s * f->dt_s / 8;
    return sum;
}

/* Shears at the ends into f->gap; the largest. */
static double shears(struct thud_free_vibration *f, const struct thud_model_structure *p, const double *row, int ends)
{
    for (int t = 0; t < ends; t++)
        f->gap[t] = 0;
    for (int j = 0; j < p->modes; j++) {
        const double *q = f->q + (size_t)(p->first_mode + j) * ENDS;
        for (int t = 0; t < ends; t++)
            f->gap[t] += row[j] * q[t];
    }
    return thud_largest_size(f->gap, ends);
}

static void storey_block(const struct thud_state *state, struct thud_free_vibration *f, int structure, int storey,
                         int intervals, struct thud_peak *peak)
{
    const struct thud_model *m = state->model;
    const struct thud_model_structure *p = &m->structure[structure];
    const double *row = p->shear + storey * p->modes;
    double margin;
    if (largest_shear(f, m, structure, row, &margin) + margin <= peak->value)
        return;
    double most = shears(f, p, row, intervals + 1);
    if (most + margin <= peak->value)
        return;
    double limit = fmax(peak->value, most) - margin;
    for (int t = 0; t < intervals; t++)
        for (int piece = 0; piece < f->pieces && fmax(fabs(f->gap[t]), fabs(f->gap[t + 1])) >= limit; piece++)
            look(m, thud_free_vibration_series(f, state, structure, t, piece), structure, storey, peak, 1);
}

static enum thud_status block(void *own, const struct thud_state *state, struct thud_free_vibration *f, int intervals,
                              struct thud_error *err)
{
    struct thud_result *result = own;
    const struct thud_model *m = state->model;
    (void)err;
    for (int s = 0; s < m->nstructures; s++)
        for (int i = 0; m->structure[s].shear && i < m->structure[s].n; i++)
            storey_block(state, f, s, i, intervals, peak_of(result, s, i));
    return THUD_OK;
}

static bool may_jump(const void *own, const struct thud_rest *rest)
{
    const struct thud_result *result = own;
    for (int s = 0; s < rest->model->nstructures; s++)
        for (int i = 0; rest->model->structure[s].shear && i < rest->model->structure[s].n; i++)
            if (!(thud_rest_shear(rest, s, i) <= result->structure[s].floor[i].shear.value))
                return false;
    return true;
}

const struct thud_observer thud_observe_shear = {.segment = segment, .block = block, .may_jump = may_jump};
