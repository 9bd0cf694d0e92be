#include "core/observe/observe_sums.h"

#include <math.h>

#include "base/arena.h"
#include "base/largest.h"
#include "core/contact/storey.h"
#include "core/motion/free_vibration.h"
#include "core/numerics/quadrature.h"
#include "core/numerics/tolerance.h"
#include "core/numerics/vec.h"
#include "core/observe/observe_peaks.h"
#include "core/observe/rest.h"

enum { ENDS = THUD_FREE_VIBRATION_ENDS };

/* The polynomial of a row's modal value in a segment and the sum of the sizes of its terms, kept for the sums that share
 * it. */
struct reading {
    const double *row;
    double value[THUD_SEGMENT_TERMS], size;
};

/* Sum of the sizes of a polynomial's terms: what it comes to at most. */
static double size_of(const double *p, int apart, int terms)
{
    double sum = 0;
    for (int k = 0; k < terms; k++)
        sum += fabs(p[k * apart]);
    return sum;
}

static const double *read_row(const struct thud_model *m, const struct thud_segment *seg, const struct thud_sum *sum,
                              const double *row, struct reading *kept)
{
    const struct thud_model_structure *p = &m->structure[sum->structure];
    if (kept->row == row)
        return kept->value;
    thud_dots(p->modes, row, seg->q + p->first_mode, m->nmodes, seg->terms, kept->value);
    kept->row = row;
    kept->size = size_of(kept->value, 1, seg->terms);
    return kept->value;
}

/* Terms of a row's force in a segment. */
static int terms_of(const struct thud_state *state, const struct thud_segment *seg, int row)
{
    return row >= state->model->ncontacts || thud_segment_has_force(state, seg, row) ? seg->terms : 0;
}

/* Most segments come nowhere near a peak, which a bound of their parts tells. */
static void look(const struct thud_state *state, const struct thud_segment *seg, const struct thud_sum *sum, double s,
                 struct reading *kept)
{
    const struct thud_model *m = state->model;
    const double *value = read_row(m, seg, sum, sum->row, kept);
    double x[THUD_SEGMENT_TERMS], most = sum->rate ? INFINITY : fabs(sum->by_row) * kept->size;
    for (const struct thud_sum_force *f = sum->force; f < sum->force + sum->forces; f++)
        most += fabs(f->by) * size_of(seg->force + f->row, m->nrows, terms_of(state, seg, f->row));
    if (sum->peak->value >= thud_smaller(sum->limit, most))
        return;
    for (int k = 0; k < seg->terms; k++)
        x[k] = sum->by_row * value[k];
    for (const struct thud_sum_force *f = sum->force; f < sum->force + sum->forces; f++)
        for (int k = 0; k < terms_of(state, seg, f->row); k++)
            x[k] += f->by * seg->force[k * m->nrows + f->row];
    if (sum->rate)
        value = read_row(m, seg, sum, sum->rate, kept);
    for (int k = 0; sum->rate && k + 1 < seg->terms; k++)
        x[k] += sum->by_rate * ((k + 1) / seg->h_s) * value[k + 1];
    thud_peak_raise(sum->peak, seg, x, seg->terms, s);
    sum->peak->value = fmin(sum->peak->value, sum->limit);
}

/* Loss in a link's dashpot, right to rounding for all that a segment may turn by; of a step whose events are not located by
 * its two ends, which are all that it knows. */
static double loss(const struct thud_model *m, const struct thud_observation *o, const struct thud_sum *sum,
                   struct reading *kept)
{
    const struct thud_segment *seg = o->seg;
    const struct thud_motion *a = seg->start, *b = seg->end;
    const struct thud_lobatto *by = &thud_lobatto[THUD_LOBATTO_RULES - 1];
    const int link = sum->index;
    double power = 0;
    if (b)
        return 0.5 * sum->by_rate * (thud_model_link(m, link, a->qd) + thud_model_link(m, link, b->qd)) *
               (thud_model_link(m, link, b->q) - thud_model_link(m, link, a->q));
    const double *d = read_row(m, seg, sum, sum->row, kept);
    for (int i = -1; i <= by->inner; i++) {
        const bool inside = i >= 0 && i < by->inner;
        double rate = 0, at = inside ? o->s * by->node[i] : i < 0 ? 0 : o->s;
        for (int k = seg->terms - 1; k > 0; k--)
            rate = rate * at + k * d[k];
        power += (inside ? by->weight[i] : by->end_weight) * rate * rate;
    }
    return sum->by_rate * o->s / seg->h_s * power;
}

/* While a link slips its force stays where it is, whatever rounding makes of it. */
static bool slips(const struct thud_state *state, const struct thud_sum *sum)
{
    return sum->limit < INFINITY && state->storey[sum->force->row - state->model->ncontacts].direction != 0;
}

/* Whether the sum may pass its peak in a segment whose events have been looked for, by the bounds of its modes. */
static bool may_pass(const struct thud_observation *o, const struct thud_sum *sum)
{
    const struct thud_model_structure *p = &o->state->model->structure[sum->structure];
    const double *bound = o->seg->notes->bound + p->first_mode, *q = o->seg->q + p->first_mode;
    double most =
        fabs(thud_dot(p->modes, sum->row, q)) + fabs(thud_dot(p->modes, sum->row, q + o->state->model->nmodes));
    if (!o->state->locates || sum->rate || sum->forces > 0)
        return true;
    for (int j = 0; j < p->modes; j++)
        most += fabs(sum->row[j]) * bound[j];
    return !(fabs(sum->by_row) * most <= sum->peak->value);
}

static enum thud_status segment(void *own, const struct thud_observation *o, struct thud_error *err)
{
    const struct thud_sums *sums = own;
    struct reading kept = {.row = NULL};
    (void)err;
    for (int i = 0; i < sums->count; i++) {
        const struct thud_sum *sum = &sums->sum[i];
        if (slips(o->state, sum) && sum->peak->value < sum->limit)
            *sum->peak = (struct thud_peak){sum->limit, o->seg->start_s};
        if (may_pass(o, sum))
            look(o->state, o->seg, sum, o->s, &kept);
        if (sum->lost_j)
            *sum->lost_j += loss(o->state->model, o, sum, &kept);
    }
    return THUD_OK;
}

/* Largest size that the modes of the block can give the sum, without the forces of storeys, at the ends of its intervals;
 * *margin: how far one inside an interval may lie above. */
static double largest_sum(struct thud_free_vibration *f, const struct thud_model *m, const struct thud_sum *sum,
                          double *margin)
{
    const struct thud_model_structure *p = &m->structure[sum->structure];
    double most = 0, bend = fabs(sum->by_row) * thud_free_vibration_bend(f, m, sum->structure, sum->row, 2);
    if (sum->rate)
        bend += fabs(sum->by_rate) * thud_free_vibration_bend(f, m, sum->structure, sum->rate, 3);
    for (int j = 0; j < p->modes; j++) {
        const int mode = p->first_mode + j;
        const double row = fabs(sum->by_row * sum->row[j]), rate = sum->rate ? fabs(sum->by_rate * sum->rate[j]) : 0;
        most += row * (f->speed[mode] / m->omega[mode] + fabs(f->shift[mode])) + rate * f->speed[mode];
    }
    *margin = bend * f->dt_s * f->dt_s / 8;
    return most;
}

static void sum_block(const struct thud_state *state, struct thud_free_vibration *f, const struct thud_sum *sum,
                      int intervals)
{
    const struct thud_model *m = state->model;
    const struct thud_model_structure *p = &m->structure[sum->structure];
    double margin, held = 0, upper[THUD_FREE_VIBRATION_BLOCK];
    for (int i = 0; i < sum->forces; i++)
        if (sum->force[i].row >= m->ncontacts) /* no contact has a force */
            held += sum->force[i].by * thud_row_branch(state, sum->force[i].row)->f0_n;
    if (largest_sum(f, m, sum, &margin) + fabs(held) + margin <= sum->peak->value)
        return;
    for (int t = 0; t < ENDS; t++)
        f->gap[t] = held;
    thud_add_rows(ENDS, p->modes, sum->by_row, sum->row, f->q + p->first_mode * ENDS, f->gap);
    if (sum->rate)
        thud_add_rows(ENDS, p->modes, sum->by_rate, sum->rate, f->qd + p->first_mode * ENDS, f->gap);
    const struct thud_peak_row row = {sum->structure, 0, 0, f->gap, sum->peak, margin, sum};
    int list[THUD_FREE_VIBRATION_BLOCK], count = thud_peak_row_intervals(m, f, &row, intervals, upper, list);
    for (int i = 0; i < count; i++)
        for (int piece = 0; piece < f->pieces && upper[list[i]] > sum->peak->value; piece++)
            look(state, thud_free_vibration_series(f, state, sum->structure, list[i], piece), sum, 1,
                 &(struct reading){.row = NULL});
}

static enum thud_status block(void *own, const struct thud_state *state, struct thud_free_vibration *f, int intervals,
                              struct thud_error *err)
{
    const struct thud_sums *sums = own;
    (void)err;
    for (int i = 0; i < sums->count; i++) {
        const struct thud_sum *sum = &sums->sum[i];
        sum_block(state, f, sum, intervals);
        if (sum->lost_j)
            *sum->lost_j += thud_free_vibration_link_loss(f, state->model, sum->index);
    }
    return THUD_OK;
}

/* Nothing bounds the rest of a motion in links that always act. */
static double most_of_rest(const struct thud_rest *rest, const struct thud_sum *sum)
{
    switch (sum->kind) {
    case THUD_SUM_SHEAR:
        return thud_rest_shear(rest, sum->structure, sum->index);
    case THUD_SUM_LEAN:
        return thud_rest_lean(rest, sum->structure, sum->index);
    case THUD_SUM_MOMENT:
        return thud_rest_moment(rest, sum->structure);
    case THUD_SUM_COLUMN:
        return fabs(sum->by_row) * thud_rest_drift(rest, &rest->model->column[sum->index]);
    case THUD_SUM_LINK:
        break;
    }
    return INFINITY;
}

static bool may_jump(const void *own, const struct thud_rest *rest)
{
    const struct thud_sums *sums = own;
    for (int i = 0; i < sums->count; i++)
        if (!(most_of_rest(rest, &sums->sum[i]) <= sums->sum[i].peak->value))
            return false;
    return true;
}

const struct thud_observer thud_observe_sums = {.segment = segment, .block = block, .may_jump = may_jump};

/* ---- making them ---- */

/* What the force of a row adds to the sum. */
static double by_force(const struct thud_model *m, const struct thud_sum *sum, int row)
{
    const struct thud_model_storey *storey = thud_model_row_storey(m, row);
    if (sum->kind == THUD_SUM_LINK)
        return storey && storey->link == sum->index && sum->limit < INFINITY;
    if (sum->kind == THUD_SUM_COLUMN && !storey)
        return m->contact[row].column == sum->index ? m->contact[row].per_force[sum->quantity] : 0;
    if (sum->kind == THUD_SUM_COLUMN)
        return m->column[sum->index].yielding == row ? m->column[sum->index].per_yield[sum->quantity] : 0;
    if (sum->kind != THUD_SUM_MOMENT || !storey || storey->link >= 0 || storey->structure != sum->structure ||
        storey->floor == 0)
        return 0;
    const double *level = m->structure[sum->structure].level_m;
    return level[storey->floor - 1] - level[storey->floor];
}

/* Notes the rows whose forces have a part; returns where the next ones are noted. */
static struct thud_sum_force *add_forces(const struct thud_model *m, struct thud_sum *sum, struct thud_sum_force *next)
{
    sum->force = next;
    for (int row = 0; row < m->nrows; row++) {
        *next = (struct thud_sum_force){row, by_force(m, sum, row)};
        next += next->by != 0;
    }
    sum->forces = (int)(next - sum->force);
    return next;
}

static struct thud_sum *add(struct thud_sums *sums, enum thud_sum_kind kind, int structure, int index,
                            const double *row, struct thud_peak *peak)
{
    struct thud_sum *sum = &sums->sum[sums->count++];
    *sum = (struct thud_sum){kind, structure, index, .row = row, .by_row = 1, .limit = INFINITY, .peak = peak};
    return sum;
}

/* Shears from below, on soil the drifts on which the weight acts, then the moment. */
static void add_structure(struct thud_sums *sums, const struct thud_model *m, int s, struct thud_result *result)
{
    const struct thud_model_structure *p = &m->structure[s];
    struct thud_floor_result *floor = result->structure[s].floor;
    for (int i = 0; i < p->n && p->shear; i++)
        add(sums, THUD_SUM_SHEAR, s, i, p->shear + i * p->modes, &floor[i].shear);
    for (int i = 0; i < p->n && p->rise; i++)
        add(sums, THUD_SUM_LEAN, s, i, p->lean + i * p->modes, &floor[i].lean);
    if (!p->moment)
        return;
    struct thud_sum *moment = add(sums, THUD_SUM_MOMENT, s, 0, p->moment, &floor[0].moment);
    moment->rate = p->moment + p->modes;
    moment->by_rate = 1;
}

static void add_column(struct thud_sums *sums, const struct thud_model *m, int column, struct thud_result *result)
{
    const struct thud_model_column *p = &m->column[column];
    for (int q = 0; q < THUD_COLUMN_QUANTITIES; q++) {
        struct thud_sum *sum =
            add(sums, THUD_SUM_COLUMN, p->structure, column, p->row, &result->column[column].peak[q]);
        sum->quantity = q;
        sum->by_row = p->per_drift[q];
    }
}

/* A link that always acts: d, and k d + c d'; one of friction has k (d - d_p), no larger than its slip force. */
static void add_link(struct thud_sums *sums, const struct thud_model *m, int link, struct thud_result *result)
{
    const struct thud_model_link *p = &m->link[link];
    struct thud_link_result *r = &result->link[link];
    if (p->contact >= 0)
        return;
    add(sums, THUD_SUM_LINK, p->structure, link, p->row, &r->stroke);
    struct thud_sum *force = add(sums, THUD_SUM_LINK, p->structure, link, p->row, &r->force);
    force->by_row = p->stiffness_npm;
    force->by_rate = p->damping_nspm;
    force->rate = p->damping_nspm != 0 ? p->row : NULL;
    force->lost_j = p->damping_nspm != 0 ? &r->lost_j : NULL;
    if (p->storey >= 0)
        force->limit = m->storey[p->storey].stiffness_npm * m->storey[p->storey].yield_m;
}

enum thud_status thud_sums_init(struct thud_sums *sums, const struct thud_state *state, struct thud_result *result,
                                struct thud_error *err)
{
    const struct thud_model *m = state->model;
    const int most = 2 * m->ndof + m->nstructures + THUD_COLUMN_QUANTITIES * m->ncolumns + 2 * m->nlinks;
    struct thud_sum_force *next;
    const enum thud_status status = THUD_LAY_IN(state->memory, err, THUD_PIECE(sums->sum, most),
                                                THUD_PIECE(next, (size_t)most * (size_t)m->nrows + 1));
    if (status != THUD_OK)
        return status;
    for (int i = 0; i < m->ncolumns; i++)
        add_column(sums, m, i, result);
    for (int i = 0; i < m->nlinks; i++)
        add_link(sums, m, i, result);
    for (int s = 0; s < m->nstructures; s++)
        add_structure(sums, m, s, result);
    for (int i = 0; i < sums->count; i++)
        next = add_forces(m, &sums->sum[i], next);
    return THUD_OK;
}

void thud_links_finish(const struct thud_state *state, struct thud_result *result)
{
    const struct thud_model *m = state->model;
    for (int i = 0; i < m->nlinks; i++) {
        const struct thud_model_link *p = &m->link[i];
        const struct thud_storey_state *slip = p->storey >= 0 ? &state->storey[p->storey] : NULL;
        struct thud_link_result *r = &result->link[i];
        const double d = thud_model_link(m, i, state->q),
                     held = slip ? d - thud_storey_plastic(state, p->storey, d) : d;
        r->contact = slip ? m->ncontacts + p->storey : p->contact;
        r->stored_j = 0.5 * p->stiffness_npm * held * held;
        r->residual_m = slip ? slip->plastic_m : NAN;
        if (slip) {
            r->lost_j = slip->hysteretic_j;
            r->engaged = slip->excursions;
        }
        if (p->contact < 0)
            continue;
        const struct thud_contact_result *from = &result->contact[p->contact];
        const double least_j = THUD_TOL_LINK_LOSS * from->force.value * from->indentation.value;
        *r = (struct thud_link_result){.force = from->force,
                                       .stroke = from->indentation,
                                       .lost_j = fabs(from->dissipated_j) > least_j ? from->dissipated_j : 0,
                                       .stored_j = from->stored_j,
                                       .residual_m = from->residual_m,
                                       .engaged = from->impacts,
                                       .contact = p->contact};
    }
}
