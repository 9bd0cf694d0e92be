#include "core/observe/observe_shear.h"

#include <math.h>

#include "base/largest.h"
#include "core/motion/free_vibration.h"
#include "core/numerics/vec.h"
#include "core/observe/rest.h"

enum { ENDS = THUD_FREE_VIBRATION_ENDS };

/* A sum over the floors of a structure: by its modal values, of a moment also by their rates and by the forces of storeys
 * that yield. */
struct sum {
    enum { SHEAR, LEAN, MOMENT } kind;
    int structure, floor;
    const double *row, *rate; /* (modes); rate of a moment alone */
    struct thud_peak *peak;
};

/* The sums of a structure: shears from below, on soil the drifts on which the weight acts, then the moment. */
static bool get_sum(const struct thud_model *m, const struct thud_result *result, int structure, int i, struct sum *out)
{
    const struct thud_model_structure *p = &m->structure[structure];
    struct thud_floor_result *floor = result->structure[structure].floor;
    const int shears = p->shear ? p->n : 0, leans = p->rise ? p->n : 0, k = i - shears;
    if (i < shears)
        *out = (struct sum){SHEAR, structure, i, p->shear + i * p->modes, NULL, &floor[i].shear};
    else if (k < leans)
        *out = (struct sum){LEAN, structure, k, p->lean + k * p->modes, NULL, &floor[k].lean};
    else if (k == leans && p->moment)
        *out = (struct sum){MOMENT, structure, 0, p->moment, p->moment + p->modes, &floor[0].moment};
    else
        return false;
    return true;
}

/* What the force of storey k, which yields, adds to the sum. */
static double by_force(const struct thud_model *m, const struct sum *sum, int k)
{
    const struct thud_model_storey *storey = &m->storey[k];
    const double *level = m->structure[sum->structure].level_m;
    if (!sum->rate || storey->link >= 0 || storey->structure != sum->structure || storey->floor == 0)
        return 0;
    return level[storey->floor - 1] - level[storey->floor];
}

static void look(const struct thud_model *m, const struct thud_segment *seg, const struct sum *sum, double s)
{
    const struct thud_model_structure *p = &m->structure[sum->structure];
    const double *q = seg->q + p->first_mode;
    double x[THUD_SEGMENT_TERMS];
    thud_dots(p->modes, sum->row, q, m->nmodes, seg->terms, x);
    for (int k = 0; sum->rate && k + 1 < seg->terms; k++)
        x[k] += (k + 1) / seg->h_s * thud_dot(p->modes, sum->rate, q + (k + 1) * m->nmodes);
    for (int i = 0; i < m->nstoreys; i++) {
        const double arm = by_force(m, sum, i);
        for (int k = 0; arm != 0 && k < seg->terms; k++)
            x[k] += arm * seg->force[k * m->nrows + m->ncontacts + i];
    }
    thud_peak_raise(sum->peak, seg, x, seg->terms, s);
}

static enum thud_status segment(void *own, const struct thud_observation *o, struct thud_error *err)
{
    const struct thud_model *m = o->state->model;
    struct sum sum;
    (void)err;
    for (int s = 0; s < m->nstructures; s++)
        for (int i = 0; get_sum(m, own, s, i, &sum); i++)
            look(m, o->seg, &sum, o->s);
    return THUD_OK;
}

/* Largest size that the modes of the block can give the sum, without the forces of storeys, at the ends of its intervals;
 * *margin: how far one inside an interval may lie above. */
static double largest_sum(const struct thud_free_vibration *f, const struct thud_model *m, const struct sum *sum,
                          double *margin)
{
    const struct thud_model_structure *p = &m->structure[sum->structure];
    double most = 0, bend = 0;
    for (int j = 0; j < p->modes; j++) {
        const int mode = p->first_mode + j;
        const double rate = sum->rate ? fabs(sum->rate[j]) : 0;
        most += fabs(sum->row[j]) * (f->speed[mode] / m->omega[mode] + fabs(f->shift[mode])) + rate * f->speed[mode];
        bend += fabs(sum->row[j]) * thud_free_vibration_bend(f, m, sum->structure, mode, 2);
        bend += rate > 0 ? rate * thud_free_vibration_bend(f, m, sum->structure, mode, 3) : 0;
    }
    *margin = bend * f->dt_s * f->dt_s / 8;
    return most;
}

/* Values at the ends into f->gap, which all have `held`; the largest. */
static double values(struct thud_free_vibration *f, const struct thud_model_structure *p, const struct sum *sum,
                     double held, int ends)
{
    for (int t = 0; t < ends; t++)
        f->gap[t] = held;
    for (int j = 0; j < p->modes; j++) {
        const size_t at = (size_t)(p->first_mode + j) * ENDS;
        for (int t = 0; t < ends; t++)
            f->gap[t] += sum->row[j] * f->q[at + (size_t)t];
        for (int t = 0; sum->rate && t < ends; t++)
            f->gap[t] += sum->rate[j] * f->qd[at + (size_t)t];
    }
    return thud_largest_size(f->gap, ends);
}

static void sum_block(const struct thud_state *state, struct thud_free_vibration *f, const struct sum *sum,
                      int intervals)
{
    const struct thud_model *m = state->model;
    double margin, held = 0;
    for (int i = 0; i < m->nstoreys; i++) {
        const double arm = by_force(m, sum, i);
        held += arm != 0 ? arm * thud_row_branch(state, m->ncontacts + i)->f0_n : 0;
    }
    if (largest_sum(f, m, sum, &margin) + fabs(held) + margin <= sum->peak->value)
        return;
    double most = values(f, &m->structure[sum->structure], sum, held, intervals + 1);
    if (most + margin <= sum->peak->value)
        return;
    double limit = fmax(sum->peak->value, most) - margin;
    for (int t = 0; t < intervals; t++)
        for (int piece = 0; piece < f->pieces && fmax(fabs(f->gap[t]), fabs(f->gap[t + 1])) >= limit; piece++)
            look(m, thud_free_vibration_series(f, state, sum->structure, t, piece), sum, 1);
}

static enum thud_status block(void *own, const struct thud_state *state, struct thud_free_vibration *f, int intervals,
                              struct thud_error *err)
{
    struct sum sum;
    (void)err;
    for (int s = 0; s < state->model->nstructures; s++)
        for (int i = 0; get_sum(state->model, own, s, i, &sum); i++)
            sum_block(state, f, &sum, intervals);
    return THUD_OK;
}

static double most_of_rest(const struct thud_rest *rest, const struct sum *sum)
{
    return sum->kind == SHEAR  ? thud_rest_shear(rest, sum->structure, sum->floor)
           : sum->kind == LEAN ? thud_rest_lean(rest, sum->structure, sum->floor)
                               : thud_rest_moment(rest, sum->structure);
}

static bool may_jump(const void *own, const struct thud_rest *rest)
{
    struct sum sum;
    for (int s = 0; s < rest->model->nstructures; s++)
        for (int i = 0; get_sum(rest->model, own, s, i, &sum); i++)
            if (!(most_of_rest(rest, &sum) <= sum.peak->value))
                return false;
    return true;
}

const struct thud_observer thud_observe_shear = {.segment = segment, .block = block, .may_jump = may_jump};
