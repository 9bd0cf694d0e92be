/* A block of intervals: the recurrence
 *
 *     q(t + dt)  = e0 q + e1 q' + p0 a(t) + p1 a(t + dt),   q'(t + dt) = e2 q + e3 q' + p2 a(t) + p3 a(t + dt)
 *
 * over all of them, the floors' values at their ends, and the energies as sums of products.
 *
 * Rows are modes or floors, and the ends of the intervals stand beside each other in them: the loops over ends, which are
 * the long ones, then take neighbours in memory. The energies of a block are not read interval by interval: each is a
 * quadratic form in (q - s, q', a0, a1) with the same coefficients in all of them (free_vibration_tables.c), so that sums
 * of the products over the intervals are all that is needed. */
#include "core/motion/free_vibration_parts.h"

#include <math.h>
#include <string.h>

#include "base/largest.h"
#include "core/numerics/vec.h"

enum { ROWS_AT_ONCE = 4 };

/* The recurrence of `count` modes at once: one mode alone is a chain in which each interval depends on the one before. */
static inline void batched_recurrence(struct thud_free_vibration *f, int j, const int count, int intervals,
                                      bool shifted)
{
    enum { N = THUD_FREE_VIBRATION_BATCH };
    double *q = f->q + j * ENDS, *qd = f->qd + j * ENDS, x[N], v[N], e[4][N], p[4][N], by_shift[2][N];
    for (int i = 0; i < count; i++) {
        x[i] = q[i * ENDS];
        v[i] = qd[i * ENDS];
        for (int k = 0; k < 4; k++) {
            e[k][i] = f->tables.e[k][j + i];
            p[k][i] = f->tables.p[k][j + i];
        }
        by_shift[0][i] = (1 - e[0][i]) * f->shift[j + i];
        by_shift[1][i] = -e[2][i] * f->shift[j + i];
    }
    for (int t = 0; t < intervals; t++) {
        double a0 = f->ground[t], a1 = f->after[t], next[N];
        for (int i = 0; i < count; i++)
            next[i] = (e[0][i] * x[i] + e[1][i] * v[i]) + (p[0][i] * a0 + p[1][i] * a1);
        for (int i = 0; i < count; i++)
            v[i] = (e[2][i] * x[i] + e[3][i] * v[i]) + (p[2][i] * a0 + p[3][i] * a1);
        for (int i = 0; i < count && shifted; i++) {
            next[i] += by_shift[0][i];
            v[i] += by_shift[1][i];
        }
        for (int i = 0; i < count; i++) {
            q[i * ENDS + t + 1] = x[i] = next[i];
            qd[i * ENDS + t + 1] = v[i];
        }
    }
}

/* All modes but those that damping couples, which have no tables; the last batch may be half empty. */
static inline void recurrence(struct thud_free_vibration *f, int intervals, bool shifted)
{
    enum { N = THUD_FREE_VIBRATION_BATCH };
    for (int j = 0; j < f->n; j += N) {
        if (thud_largest_size(f->tables.e[0] + j, N) == 0)
            continue;
        if (j + N / 2 < f->n)
            batched_recurrence(f, j, N, intervals, shifted);
        else
            batched_recurrence(f, j, N / 2, intervals, shifted);
    }
}

/* Where the modes would rest under the constant forces: s = -g F/omega^2. In a system with a storey that yields, the
 * inverse of Omega^2 + kappa g g^T is
 *
 *     Omega^-2 - kappa Omega^-2 g g^T Omega^-2/(1 + kappa g^T Omega^-2 g)     (Sherman and Morrison) */
static void shift_modes(struct thud_free_vibration *f, const struct thud_state *state)
{
    const struct thud_model *m = state->model;
    const bool now = state->nshifted > 0 || f->yields >= 0;
    if (!f->shifted && !now)
        return;
    f->shifted = now;
    memset(f->shift, 0, (size_t)f->n * sizeof *f->shift);
    for (int c = m->ncontacts; c < m->nrows; c++)
        for (int j = 0; j < f->n && f->shifted; j++)
            f->shift[j] -= m->jacobian[c * f->n + j] * thud_row_branch(state, c)->f0_n;
    for (int j = 0; j < f->n; j++)
        f->shift[j] = m->spring[j] > 0 ? f->shift[j] / m->spring[j] : 0; /* no force acts on a free body */
    if (f->yields < 0)
        return;
    const struct thud_coupled_motion *c = &f->coupled[f->nsystems + f->yields];
    double *s = f->shift + c->first_mode, by = 1, rest = thud_dot(c->n, c->soft, s);
    for (int j = 0; j < c->n; j++)
        by += c->soft_npm * c->soft[j] * c->soft[j] / m->spring[c->first_mode + j];
    for (int j = 0; j < c->n; j++)
        s[j] -= c->soft_npm * rest / by * c->soft[j] / m->spring[c->first_mode + j];
}

static void fill_speeds(struct thud_free_vibration *f, const struct thud_model *m)
{
    double energy[ENDS];
    for (int j = 0; j < f->n; j++) {
        const double *q = f->q + j * ENDS, *qd = f->qd + j * ENDS, s = f->shift[j], w2 = m->omega[j] * m->omega[j];
        for (int t = 0; t < f->ends; t++)
            energy[t] = qd[t] * qd[t] + w2 * ((q[t] - s) * (q[t] - s));
        f->speed[j] = sqrt(thud_largest(energy, f->ends));
    }
}

/* What ends a block of a system early: an isolator that may yield in blocks comes to its bound, or, while it yields, its
 * rate turns. What lies behind is not read. */
static struct thud_coupled_stop stop_of(const struct thud_free_vibration *f, const struct thud_state *state, int system)
{
    const struct thud_model *m = state->model;
    for (int k = 0; k < m->nstoreys; k++) {
        const struct thud_coupled_motion *c = &f->coupled[f->nsystems + k];
        const int direction = state->storey[k].direction;
        if (c->size == 0 || m->structure[m->storey[k].structure].system != system)
            continue;
        if (direction != 0)
            return (struct thud_coupled_stop){c->soft, true, direction < 0 ? -INFINITY : 0,
                                              direction < 0 ? 0 : INFINITY};
        const double most = m->storey[k].yield_m + 2 * state->touch_m,
                     middle = state->storey[k].plastic_m - thud_dot(c->n, c->soft, f->shift + c->first_mode);
        return (struct thud_coupled_stop){c->soft, false, middle - most, middle + most};
    }
    return (struct thud_coupled_stop){.row = NULL};
}

int thud_free_vibration_fill(struct thud_free_vibration *f, const struct thud_state *state, int intervals)
{
    shift_modes(f, state);
    for (int t = 0; t < intervals; t++)
        thud_state_ground(state, state->grid + t, &f->ground[t], &f->after[t]);
    for (int j = 0; j < f->n; j++) {
        f->q[j * ENDS] = state->q[j];
        f->qd[j * ENDS] = state->qd[j];
    }
    if (f->shifted)
        recurrence(f, intervals, true);
    else
        recurrence(f, intervals, false);
    for (int s = 0; s < f->nsystems; s++)
        if (f->coupled[s].size > 0)
            intervals = thud_coupled_motion_advance(thud_free_vibration_motion(f, s), f->q, f->qd, f->shift, f->moved,
                                                    f->ground, f->after, intervals, stop_of(f, state, s));
    f->ground_most = thud_larger(thud_largest_size(f->ground, intervals), thud_largest_size(f->after, intervals));
    f->slope = 0;
    for (int t = 0; t < intervals; t++)
        f->slope = thud_larger(f->slope, fabs(f->after[t] - f->ground[t]) / f->dt_s);
    for (int i = 0; i < THUD_FREE_VIBRATION_BOUNDS * f->nsystems; i++)
        f->bound[i] = NAN;
    for (int i = 0; i < THUD_FLOOR_QUANTITIES * state->model->nstructures; i++)
        f->margin[i] = NAN;
    memset(f->valued, 0, THUD_FLOOR_QUANTITIES * (size_t)state->model->nstructures * sizeof *f->valued);
    memset(f->series.has, 0, (size_t)f->nsystems * sizeof *f->series.has);
    f->series.piece = -1;
    const double h = f->dt_s / f->pieces;
    thud_segment_begin(state, &f->series.seg, h, thud_segment_all_terms(state, h)); /* forces, constant in the block */
    f->ends = intervals + 1;
    fill_speeds(f, state->model);
    return intervals;
}

/* `count` rows of a matrix (columns each) times rows of modes, by four ends at a time (rows are long enough): the more at
 * once, the fewer loads for each product. */
static inline void some_rows(const double *row, int columns, const int count, const double *from, int ends, double *to)
{
    for (int t = 0; t < ends; t += 4) {
        const double *x = from + t;
        thud_vec2 sum[ROWS_AT_ONCE][2] = {0};
        for (int j = 0; j < columns; j++, x += ENDS)
            for (int k = 0; k < count; k++) {
                sum[k][0] += row[k * columns + j] * thud_vec2_at(x);
                sum[k][1] += row[k * columns + j] * thud_vec2_at(x + 2);
            }
        for (int k = 0; k < count; k++) {
            thud_vec2_put(sum[k][0], to + k * ENDS + t);
            thud_vec2_put(sum[k][1], to + k * ENDS + t + 2);
        }
    }
}

/* A whole matrix (rows x columns). */
static void all_rows(const double *row, int rows, int columns, const double *from, int ends, double *to)
{
    int i = 0;
    for (; i + ROWS_AT_ONCE <= rows; i += ROWS_AT_ONCE)
        some_rows(row + i * columns, columns, ROWS_AT_ONCE, from, ends, to + (size_t)i * ENDS);
    for (; i + ROWS_AT_ONCE / 2 <= rows; i += ROWS_AT_ONCE / 2)
        some_rows(row + i * columns, columns, ROWS_AT_ONCE / 2, from, ends, to + (size_t)i * ENDS);
    for (; i < rows; i++)
        some_rows(row + i * columns, columns, 1, from, ends, to + (size_t)i * ENDS);
}

void thud_free_vibration_spring(const struct thud_free_vibration *f, const struct thud_model *m,
                                const struct thud_model_structure *p, const double *x, const double *v, double *out)
{
    const struct thud_coupled_motion *c = thud_free_vibration_motion(f, p->system);
    const bool couples = p->damping; /* no dashpots of single modes then */
    double drift[ENDS];              /* g^T x of a storey that yields, and takes back kappa g of it */
    if (couples)
        all_rows(p->damping, p->modes, p->modes, v + p->first_mode * ENDS, f->ends, out + p->first_mode * ENDS);
    if (c->soft)
        some_rows(c->soft, c->n, 1, x + p->first_mode * ENDS, f->ends, drift);
    for (int j = p->first_mode; j < p->first_mode + p->modes; j++) {
        const double spring = m->spring[j], by = couples ? 1 : m->dashpot[j], shift = couples ? 0 : f->shift[j];
        const double *damped = couples ? out : v, soft = c->soft ? c->soft_npm * c->soft[j - p->first_mode] : 0;
        for (int t = 0, at = j * ENDS; t < f->ends; t += 2, at += 2) { /* rows are long enough */
            thud_vec2 force = spring * (thud_vec2_at(x + at) - shift) + by * thud_vec2_at(damped + at);
            if (c->soft)
                force += soft * thud_vec2_at(drift + t);
            thud_vec2_put(-force, out + at);
        }
    }
}

static void drift_rows(struct thud_free_vibration *f, const struct thud_model_structure *p)
{
    for (int i = 0; i < p->n; i++) {
        const double *u = f->value[THUD_FLOOR_DISPLACEMENT] + (size_t)p->first * ENDS;
        double *drift = f->value[THUD_FLOOR_DRIFT] + (size_t)(p->first + i) * ENDS;
        for (int t = 0; t < f->ends; t++)
            drift[t] = !p->drifts ? 0 : thud_model_drift(p, u + t, ENDS, i);
    }
}

void thud_free_vibration_values(struct thud_free_vibration *f, const struct thud_model *m, int structure, int quantity)
{
    const struct thud_model_structure *p = &m->structure[structure];
    bool *valued = &f->valued[quantity * m->nstructures + structure];
    if (*valued)
        return;
    *valued = true;
    if (quantity == THUD_FLOOR_DRIFT) {
        thud_free_vibration_values(f, m, structure, THUD_FLOOR_DISPLACEMENT);
        drift_rows(f, p);
        return;
    }
    const bool bounded =
        p->damping && !isnan(f->bound[p->system * THUD_FREE_VIBRATION_BOUNDS + 2]); /* that made them */
    if (quantity == THUD_FLOOR_ACCELERATION && !bounded)
        thud_free_vibration_spring(f, m, p, p->damping ? f->moved : f->q, f->qd, f->acceleration);
    const double *from = quantity == THUD_FLOOR_DISPLACEMENT ? f->q
                         : quantity == THUD_FLOOR_VELOCITY   ? f->qd
                                                             : f->acceleration;
    all_rows(p->phi, p->dofs, p->modes, from + p->first_mode * ENDS, f->ends,
             f->value[quantity] + (size_t)p->first * ENDS);
}

/* Rate of a floor's total acceleration: that of -(Omega^2 (q - s) + D q'), in which the slope of the ground has no part. */
static double jerk(const struct thud_free_vibration *f, const struct thud_model *m, int structure, int floor, int t,
                   double ground)
{
    const struct thud_model_structure *p = &m->structure[structure];
    const struct thud_coupled_motion *c = thud_free_vibration_motion(f, p->system);
    const double *row = p->phi + floor * p->modes;
    double sum = 0, drift = 0, *damping = f->series.now; /* workspace: phi D, D symmetric */
    memset(damping, 0, (size_t)p->modes * sizeof *damping);
    if (p->damping)
        thud_add_rows(p->modes, p->modes, 1, row, p->damping, damping);
    for (int j = 0, k = p->first_mode; j < p->modes; j++, k++) {
        const double rate = f->qd[k * ENDS + t], second = f->acceleration[k * ENDS + t] - m->gamma[k] * ground;
        sum -= row[j] * (m->spring[k] * rate + m->dashpot[k] * second) + damping[j] * second;
        drift += c->soft ? c->soft[j] * rate : 0;
    }
    return c->soft ? sum - c->soft_npm * drift * thud_dot(p->modes, row, c->soft) : sum;
}

double thud_free_vibration_rate(struct thud_free_vibration *f, const struct thud_model *m, int structure, int floor,
                                int quantity, int t, double ground)
{
    const struct thud_model_structure *p = &m->structure[structure];
    const bool second = quantity == THUD_FLOOR_VELOCITY || quantity == THUD_FLOOR_ACCELERATION;
    const int of = second ? THUD_FLOOR_ACCELERATION : THUD_FLOOR_VELOCITY;
    const double *x = f->value[of] + (size_t)p->first * ENDS + t;
    thud_free_vibration_values(f, m, structure, of);
    if (quantity == THUD_FLOOR_ACCELERATION)
        return jerk(f, m, structure, floor, t, ground);
    return quantity == THUD_FLOOR_DRIFT
               ? thud_model_drift(p, x, ENDS, floor)
               : x[floor * ENDS] - (second ? m->ground_influence[p->first + floor] * ground : 0);
}

/* Sums over intervals of products of a mode's motion (x = q - s) and of the ground's. */
struct products {
    thud_vec2 xx, xv, vv, x0, x1, v0, v1;
};

static inline void add_products(struct products *p, thud_vec2 x, thud_vec2 v, thud_vec2 a0, thud_vec2 a1)
{
    p->xx += x * x;
    p->xv += x * v;
    p->vv += v * v;
    p->x0 += x * a0;
    p->x1 += x * a1;
    p->v0 += v * a0;
    p->v1 += v * a1;
}

/* Of mode j over the first intervals of the block, out (PRODUCTS). */
static void sum_products(const struct thud_free_vibration *f, int j, int intervals, double *out)
{
    const double *q = f->q + j * ENDS, *qd = f->qd + j * ENDS, *a0 = f->ground, *a1 = f->after, s = f->shift[j];
    struct products p = {0};
    int t = 0;
    for (; t + 2 <= intervals; t += 2)
        add_products(&p, thud_vec2_at(q + t) - s, thud_vec2_at(qd + t), thud_vec2_at(a0 + t), thud_vec2_at(a1 + t));
    if (t < intervals)
        add_products(&p, thud_vec2_set(q[t] - s, 0), thud_vec2_set(qd[t], 0), thud_vec2_set(a0[t], 0),
                     thud_vec2_set(a1[t], 0));
    const thud_vec2 sum[] = {p.xx, p.xv, p.vv, p.x0, p.x1, p.v0, p.v1};
    for (int i = 0; i < THUD_FREE_VIBRATION_PRODUCTS; i++)
        out[i] = thud_vec2_sum(sum[i]);
}

/* The two quadratic forms, in the sums of their products over the intervals. */
void thud_free_vibration_work(const struct thud_free_vibration *f, int intervals, double *input_j, double *viscous_j)
{
    const double *a0 = f->ground, *a1 = f->after;
    const double ground[] = {thud_dot(intervals, a0, a0), thud_dot(intervals, a0, a1), thud_dot(intervals, a1, a1)};
    double input = 0, viscous = 0;
    for (int i = 0; i < 3; i++) {
        viscous += f->tables.ground[0][i] * ground[i];
        input += f->tables.ground[1][i] * ground[i];
    }
    for (int j = 0; j < f->n; j++) {
        double product[THUD_FREE_VIBRATION_PRODUCTS];
        if (f->tables.e[0][j] == 0) /* damping couples it */
            continue;
        sum_products(f, j, intervals, product);
        for (int i = 0; i < THUD_FREE_VIBRATION_PRODUCTS; i++)
            viscous += f->tables.viscous[i][j] * product[i];
        input += f->tables.work[0][j] * product[3] + f->tables.work[1][j] * product[5] +
                 f->tables.work[2][j] * product[4] + f->tables.work[3][j] * product[6];
    }
    for (int s = 0; s < f->nsystems; s++)
        if (f->coupled[s].size > 0)
            thud_coupled_motion_work(thud_free_vibration_motion(f, s), &input, &viscous);
    *input_j = input;
    *viscous_j = viscous;
}

double thud_free_vibration_link_loss(const struct thud_free_vibration *f, const struct thud_model *model, int link)
{
    const int system = model->structure[model->link[link].structure].system;
    return thud_coupled_motion_link_loss(thud_free_vibration_motion(f, system), link);
}
