#include "core/motion/free_vibration.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/largest.h"
#include "core/numerics/poly.h"
#include "core/numerics/quadrature.h"
#include "core/numerics/tolerance.h"
#include "core/numerics/vec.h"

/* PIECES_MOST: of a block of more than one interval, so that a slice of work ends soon where modes are very fast. */
enum {
    ENDS = THUD_FREE_VIBRATION_ENDS,
    SHORT_BLOCK = 8,
    PIECES_MOST = 16384,
    POINTS = THUD_QUADRATURE_POINTS,
    FLOORS_AT_ONCE = 4,
    BOUNDS = 7 /* of derivatives up to the sixth */
};

/* Interval times the norm of damping that couples modes, and times the fastest rate there: above, the bounds of a block
 * are worth nothing, and power series alone are as fast. */
static const double damping_most_rad = 1, coupled_most_rad = 1e3;

/* The tables of one interval of the ground motion. */

/* Unit motions over one interval: initial q, initial q', ground acceleration falling from 1 to 0, and rising from 0
 * to 1. */
enum { UNIT_Q, UNIT_QD, UNIT_A0, UNIT_A1, UNITS };

static bool allocate(struct thud_free_vibration *f, const struct thud_model *m)
{
    size_t n = (size_t)m->nmodes, floors = (size_t)m->ndof, ns = (size_t)m->nstructures,
           rows = (n + THUD_FREE_VIBRATION_BATCH - 1) / THUD_FREE_VIBRATION_BATCH * THUD_FREE_VIBRATION_BATCH,
           count = 0;
    double **by_mode[4 + 4 + 4 + 2 * THUD_FREE_VIBRATION_PRODUCTS + 4];
    double **by_end[] = {&f->q, &f->qd, &f->spring}, **single[] = {&f->gap, &f->ground, &f->after};
    size_t ends = sizeof by_end / sizeof *by_end, singles = sizeof single / sizeof *single;
    for (int i = 0; i < 4; i++) {
        by_mode[count++] = &f->e[i];
        by_mode[count++] = &f->p[i];
        by_mode[count++] = &f->work[i];
    }
    for (int i = 0; i < THUD_FREE_VIBRATION_PRODUCTS; i++) {
        by_mode[count++] = &f->viscous[i];
        by_mode[count++] = &f->product[i];
    }
    by_mode[count++] = &f->now;
    by_mode[count++] = &f->now_rate;
    by_mode[count++] = &f->speed;
    by_mode[count++] = &f->shift;
    double *next = f->block =
        calloc(count * rows + (ends * rows + THUD_FLOOR_QUANTITIES * floors + singles) * (size_t)ENDS +
                   2 * THUD_FLOOR_QUANTITIES * ns + (size_t)m->ncontacts + (m->couples ? BOUNDS * n : 0),
               sizeof *next);
    f->valued = calloc(THUD_FLOOR_QUANTITIES * ns + (size_t)m->ncontacts + 1, sizeof *f->valued);
    f->at = calloc(ns + 1, sizeof *f->at);
    f->coupled = calloc(ns + 1, sizeof *f->coupled);
    if (!next || !f->valued || !f->at || !f->coupled)
        return false;
    for (size_t i = 0; i < count; i++, next += rows)
        *by_mode[i] = next;
    for (size_t i = 0; i < ends; i++, next += rows * (size_t)ENDS)
        *by_end[i] = next;
    for (int x = 0; x < THUD_FLOOR_QUANTITIES; x++, next += floors * (size_t)ENDS)
        f->value[x] = next;
    for (size_t i = 0; i < singles; i++, next += ENDS)
        *single[i] = next;
    f->margin = next;
    f->cubic_margin = f->margin + THUD_FLOOR_QUANTITIES * ns;
    f->limit = f->cubic_margin + THUD_FLOOR_QUANTITIES * ns;
    f->bound = f->limit + m->ncontacts;
    f->near = f->valued + THUD_FLOOR_QUANTITIES * ns;
    return true;
}

/* Rates of the four unit motions at one quadrature point enter the integrals of their products; of a structure whose
 * modes are not coupled. */
static void add_point(struct thud_free_vibration *f, const struct thud_model *m, const struct thud_model_structure *p,
                      double weight, double s, double *const rate[UNITS])
{
    double a[2] = {1 - s, s};
    for (int j = p->first_mode; j < p->first_mode + p->modes; j++) {
        double w[UNITS], loss = 2 * m->zeta[j] * m->omega[j] * weight, drive = -m->gamma[j] * weight;
        for (int u = 0; u < UNITS; u++)
            w[u] = rate[u][j];
        f->viscous[0][j] += loss * w[0] * w[0];
        f->viscous[1][j] += loss * 2 * w[0] * w[1];
        f->viscous[2][j] += loss * w[1] * w[1];
        f->viscous[3][j] += loss * 2 * w[0] * w[2];
        f->viscous[4][j] += loss * 2 * w[0] * w[3];
        f->viscous[5][j] += loss * 2 * w[1] * w[2];
        f->viscous[6][j] += loss * 2 * w[1] * w[3];
        f->viscous_ground[0] += loss * w[2] * w[2];
        f->viscous_ground[1] += loss * 2 * w[2] * w[3];
        f->viscous_ground[2] += loss * w[3] * w[3];
        f->work[0][j] += drive * a[0] * w[0];
        f->work[1][j] += drive * a[0] * w[1];
        f->work[2][j] += drive * a[1] * w[0];
        f->work[3][j] += drive * a[1] * w[1];
        f->work_ground[0] += drive * a[0] * w[2];
        f->work_ground[1] += drive * (a[0] * w[3] + a[1] * w[2]);
        f->work_ground[2] += drive * a[1] * w[3];
    }
}

/* Moves unit motion u over one piece; its rates at the quadrature points into rate (POINTS x n). */
static void move_unit(const struct thud_state *state, struct thud_free_vibration *f, int u, int piece, double *q,
                      double *qd, double *rate)
{
    struct thud_segment *seg = &f->seg;
    double s0 = (double)piece / f->pieces, ds = 1.0 / f->pieces;
    thud_segment_begin(state, seg, f->dt_s * ds);
    seg->a0 = u == UNIT_A0 ? 1 - s0 : u == UNIT_A1 ? s0 : 0;
    seg->a1 = u == UNIT_A0 ? -ds : u == UNIT_A1 ? ds : 0;
    thud_taylor_given(state->model, seg, q, qd);
    for (int i = 0; i < POINTS; i++)
        thud_segment_state(seg, f->n, thud_quadrature_node[i], f->now, rate + i * f->n);
    thud_segment_state(seg, f->n, 1, q, qd);
}

/* Marches the four unit motions through one interval in pieces short enough for the series. */
static enum thud_status unit_motions(const struct thud_state *state, struct thud_free_vibration *f,
                                     struct thud_error *err)
{
    const struct thud_model *m = state->model;
    size_t n = (size_t)m->nmodes, size = (2 + POINTS) * n;
    double *block = calloc(UNITS * size + 1, sizeof *block), *q[UNITS], *qd[UNITS], *rate[UNITS];
    if (!block)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    for (size_t u = 0; u < UNITS; u++) {
        q[u] = block + u * size;
        qd[u] = q[u] + n;
    }
    for (size_t j = 0; j < n; j++)
        q[UNIT_Q][j] = qd[UNIT_QD][j] = 1;
    for (int piece = 0; piece < f->pieces; piece++) {
        for (int u = 0; u < UNITS; u++)
            move_unit(state, f, u, piece, q[u], qd[u], qd[u] + n);
        for (int i = 0; i < POINTS; i++) {
            for (int u = 0; u < UNITS; u++)
                rate[u] = qd[u] + n + (size_t)i * n;
            double ds = 1.0 / f->pieces, s = (piece + thud_quadrature_node[i]) * ds;
            for (int k = 0; k < m->nstructures; k++)
                if (!m->structure[k].damping)
                    add_point(f, m, &m->structure[k], thud_quadrature_weight[i] * ds * f->dt_s, s, rate);
        }
    }
    for (int u = 0; u < UNITS; u++) {
        memcpy(u < 2 ? f->e[u] : f->p[u - 2], q[u], n * sizeof(double));
        memcpy(u < 2 ? f->e[u + 2] : f->p[u], qd[u], n * sizeof(double));
    }
    free(block);
    return THUD_OK;
}

/* Whether coupled damping is weak enough in an interval for the bounds of a block. */
static bool suits(const struct thud_state *state)
{
    const struct thud_model *m = state->model;
    if (m->nmodes == 0 || (m->couples && state->fastest_radps * state->grid_dt_s > coupled_most_rad))
        return false;
    for (int s = 0; s < m->nstructures; s++) {
        const struct thud_model_structure *p = &m->structure[s];
        for (int i = 0; p->damping && i < p->modes; i++) {
            double row = 0;
            for (int j = 0; j < p->modes; j++)
                row += fabs(p->damping[i * p->modes + j]);
            if (row * state->grid_dt_s > damping_most_rad)
                return false;
        }
    }
    return true;
}

/* The propagators of structures whose modes are coupled, in place of the recurrence. */
static enum thud_status couple(struct thud_free_vibration *f, const struct thud_state *state, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (int s = 0; s < state->model->nstructures && status == THUD_OK; s++) {
        const struct thud_model_structure *p = &state->model->structure[s];
        if (!p->damping)
            continue;
        status = thud_coupled_flight_init(&f->coupled[s], state, s, &f->seg, err);
        for (int k = 0; k < 4; k++) {
            memset(f->e[k] + p->first_mode, 0, (size_t)p->modes * sizeof(double));
            memset(f->p[k] + p->first_mode, 0, (size_t)p->modes * sizeof(double));
        }
    }
    return status;
}

static bool same(const double *a, const double *b, int n)
{
    return memcmp(a, b, (size_t)n * sizeof *a) == 0;
}

/* Whether the tables of `like` are those of f, to the last bit: no modes are coupled, and no contact is closed, whose
 * rate would give the series more terms. */
static bool has_tables(const struct thud_free_vibration *like, const struct thud_free_vibration *f,
                       const struct thud_state *state)
{
    const struct thud_model *m = f->model, *l = like->model;
    return !m->couples && !l->couples && state->nactive == 0 && like->n == f->n && like->dt_s == f->dt_s &&
           like->pieces == f->pieces && l->nstructures == m->nstructures && same(l->omega, m->omega, f->n) &&
           same(l->zeta, m->zeta, f->n) && same(l->gamma, m->gamma, f->n);
}

static void copy_tables(struct thud_free_vibration *f, const struct thud_free_vibration *like)
{
    const size_t bytes = (size_t)f->n * sizeof(double);
    for (int i = 0; i < 4; i++) {
        memcpy(f->e[i], like->e[i], bytes);
        memcpy(f->p[i], like->p[i], bytes);
        memcpy(f->work[i], like->work[i], bytes);
    }
    for (int i = 0; i < THUD_FREE_VIBRATION_PRODUCTS; i++)
        memcpy(f->viscous[i], like->viscous[i], bytes);
    memcpy(f->viscous_ground, like->viscous_ground, sizeof f->viscous_ground);
    memcpy(f->work_ground, like->work_ground, sizeof f->work_ground);
}

enum thud_status thud_free_vibration_create(const struct thud_state *state, const struct thud_free_vibration *like,
                                            struct thud_free_vibration **out, struct thud_error *err)
{
    const struct thud_model *m = state->model;
    *out = NULL;
    if (!suits(state))
        return THUD_OK;
    struct thud_free_vibration *f = calloc(1, sizeof *f);
    enum thud_status status = f && allocate(f, m) ? THUD_OK : thud_error_set(err, THUD_MEMORY, "out of memory");
    if (status == THUD_OK)
        status = thud_segment_init(&f->seg, m, err);
    if (status == THUD_OK) {
        f->model = m;
        f->n = m->nmodes;
        f->dt_s = state->grid_dt_s;
        f->pieces = 1 + (int)(state->fastest_radps * f->dt_s / 1.8);
        f->size = THUD_FREE_VIBRATION_BLOCK;
        f->nstructures = m->nstructures;
        if (like && has_tables(like, f, state))
            copy_tables(f, like);
        else
            status = unit_motions(state, f, err);
    }
    if (status == THUD_OK)
        status = couple(f, state, err);
    if (status != THUD_OK) {
        thud_free_vibration_free(f);
        return status;
    }
    *out = f;
    return THUD_OK;
}

void thud_free_vibration_free(struct thud_free_vibration *f)
{
    if (!f)
        return;
    thud_segment_clear(&f->seg);
    for (int s = 0; s < f->nstructures; s++)
        thud_coupled_flight_clear(&f->coupled[s]);
    free(f->coupled);
    free(f->valued);
    free(f->at);
    free(f->block);
    free(f);
}

/* The block. */

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
            e[k][i] = f->e[k][j + i];
            p[k][i] = f->p[k][j + i];
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

/* All modes; the last batch may be half empty. */
static inline void recurrence(struct thud_free_vibration *f, int intervals, bool shifted)
{
    enum { N = THUD_FREE_VIBRATION_BATCH };
    int j = 0;
    for (; j + N / 2 < f->n; j += N)
        batched_recurrence(f, j, N, intervals, shifted);
    if (j < f->n)
        batched_recurrence(f, j, N / 2, intervals, shifted);
}

/* Where the modes would rest under the constant forces: s = -g F/omega^2. */
static void shift_modes(struct thud_free_vibration *f, const struct thud_state *state)
{
    const struct thud_model *m = state->model;
    if (!f->shifted && state->nshifted == 0)
        return;
    f->shifted = state->nshifted > 0;
    memset(f->shift, 0, (size_t)f->n * sizeof *f->shift);
    for (int c = m->ncontacts; c < m->nrows; c++)
        for (int j = 0; j < f->n && f->shifted; j++)
            f->shift[j] -= m->jacobian[c * f->n + j] * state->contact[c].branch.f0_n;
    for (int j = 0; j < f->n; j++)
        f->shift[j] = m->spring[j] > 0 ? f->shift[j] / m->spring[j] : 0; /* no force acts on a free body */
    for (int s = 0; s < m->nstructures; s++)
        if (f->coupled[s].size > 0)
            thud_coupled_flight_shift(&f->coupled[s], f->shift + m->structure[s].first_mode);
}

static void march(struct thud_free_vibration *f, const struct thud_state *state, int intervals)
{
    shift_modes(f, state);
    for (int t = 0; t < intervals; t++)
        thud_state_ground(state, state->grid + t, &f->ground[t], &f->after[t]);
    f->ground_most = thud_larger(thud_largest_size(f->ground, intervals), thud_largest_size(f->after, intervals));
    for (int j = 0; j < f->n; j++) {
        f->q[j * ENDS] = state->q[j];
        f->qd[j * ENDS] = state->qd[j];
    }
    if (f->shifted)
        recurrence(f, intervals, true);
    else
        recurrence(f, intervals, false);
    for (int s = 0; s < state->model->nstructures; s++) {
        const int row = state->model->structure[s].first_mode * ENDS;
        if (f->coupled[s].size > 0)
            thud_coupled_flight_march(&f->coupled[s], f->q + row, f->qd + row, ENDS, f->ground, f->after, intervals);
    }
    memset(f->valued, 0, THUD_FLOOR_QUANTITIES * (size_t)state->model->nstructures * sizeof *f->valued);
    for (int i = 0; i < state->model->nstructures; i++)
        f->at[i].piece = -1;
    thud_segment_begin(state, &f->seg, f->dt_s / f->pieces); /* the forces, constant in the block */
    f->ends = intervals + 1;
}

/* Sums over intervals of products of a mode's motion (x = q - s) and of the ground's, of which the energies of a block
 * are made; and the largest energy norm squared, q'^2 + omega^2 x^2, at their starts. */
struct products {
    thud_vec2 xx, xv, vv, x0, x1, v0, v1;
    double most[2];
};

static inline void add_products(struct products *p, thud_vec2 x, thud_vec2 v, thud_vec2 a0, thud_vec2 a1, double w2)
{
    const thud_vec2 xx = x * x, vv = v * v, energy = vv + w2 * xx;
    p->xx += xx;
    p->xv += x * v;
    p->vv += vv;
    p->x0 += x * a0;
    p->x1 += x * a1;
    p->v0 += v * a0;
    p->v1 += v * a1;
    p->most[0] = energy[0] > p->most[0] ? energy[0] : p->most[0];
    p->most[1] = energy[1] > p->most[1] ? energy[1] : p->most[1];
}

/* Of mode j over the first intervals of the block, its sums into f->product; returns the largest norm squared. */
static double sum_products(struct thud_free_vibration *f, int j, double omega, int intervals)
{
    const double *q = f->q + j * ENDS, *qd = f->qd + j * ENDS, *a0 = f->ground, *a1 = f->after;
    const double w2 = omega * omega, s = f->shift[j];
    struct products p = {0};
    int t = 0;
    for (; t + 2 <= intervals; t += 2)
        add_products(&p, thud_vec2_at(q + t) - s, thud_vec2_at(qd + t), thud_vec2_at(a0 + t), thud_vec2_at(a1 + t), w2);
    if (t < intervals)
        add_products(&p, thud_vec2_set(q[t] - s, 0), thud_vec2_set(qd[t], 0), thud_vec2_set(a0[t], 0),
                     thud_vec2_set(a1[t], 0), w2);
    const thud_vec2 sum[] = {p.xx, p.xv, p.vv, p.x0, p.x1, p.v0, p.v1};
    for (int i = 0; i < THUD_FREE_VIBRATION_PRODUCTS; i++)
        f->product[i][j] = thud_vec2_sum(sum[i]);
    return thud_larger(p.most[0], p.most[1]);
}

/* Sums of the modes and their largest speeds in the block. */
static void sum_block(struct thud_free_vibration *f, const struct thud_model *m, int intervals)
{
    for (int j = 0; j < f->n; j++) {
        const double w2 = m->omega[j] * m->omega[j], x = f->q[j * ENDS + intervals] - f->shift[j],
                     v = f->qd[j * ENDS + intervals];
        const double most = thud_larger(sum_products(f, j, m->omega[j], intervals), v * v + w2 * x * x);
        f->speed[j] = sqrt(most);
    }
    f->summed = intervals;
}

/* Values at the ends of `count` floors from those of their modes, by four ends at a time (rows are long enough): the
 * more floors at once, the fewer loads for each product. */
static inline void some_rows(const struct thud_model_structure *p, int i, const int count, const double *from, int ends,
                             double *to)
{
    const double *row = p->phi + i * p->modes;
    for (int t = 0; t < ends; t += 4) {
        const double *x = from + p->first_mode * ENDS + t;
        thud_vec2 sum[FLOORS_AT_ONCE][2] = {0};
        for (int j = 0; j < p->modes; j++, x += ENDS)
            for (int k = 0; k < count; k++) {
                sum[k][0] += row[k * p->modes + j] * thud_vec2_at(x);
                sum[k][1] += row[k * p->modes + j] * thud_vec2_at(x + 2);
            }
        for (int k = 0; k < count; k++) {
            thud_vec2_put(sum[k][0], to + k * ENDS + t);
            thud_vec2_put(sum[k][1], to + k * ENDS + t + 2);
        }
    }
}

static void floor_rows(struct thud_free_vibration *f, const struct thud_model_structure *p, int quantity,
                       const double *from, int ends)
{
    double *to = f->value[quantity] + (size_t)p->first * ENDS;
    int i = 0;
    for (; i + FLOORS_AT_ONCE <= p->n; i += FLOORS_AT_ONCE)
        some_rows(p, i, FLOORS_AT_ONCE, from, ends, to + (size_t)i * ENDS);
    for (; i + FLOORS_AT_ONCE / 2 <= p->n; i += FLOORS_AT_ONCE / 2)
        some_rows(p, i, FLOORS_AT_ONCE / 2, from, ends, to + (size_t)i * ENDS);
    for (; i < p->n; i++)
        some_rows(p, i, 1, from, ends, to + (size_t)i * ENDS);
}

/* Fills f->spring of one structure. */
static void spring_rows(struct thud_free_vibration *f, const struct thud_model *m, const struct thud_model_structure *p)
{
    for (int j = p->first_mode; j < p->first_mode + p->modes; j++) {
        const double *q = f->q + j * ENDS, *qd = f->qd + j * ENDS;
        double *a = f->spring + j * ENDS, s = f->shift[j];
        for (int t = 0; t < f->ends; t++)
            a[t] = -(m->spring[j] * (q[t] - s) + m->dashpot[j] * qd[t]);
        for (int k = 0; p->damping && k < p->modes; k++) {
            const double d = p->damping[(j - p->first_mode) * p->modes + k], *rate = f->qd + (p->first_mode + k) * ENDS;
            for (int t = 0; t < f->ends; t++)
                a[t] -= d * rate[t];
        }
    }
}

static void drift_rows(struct thud_free_vibration *f, const struct thud_model_structure *p)
{
    for (int i = 0; i < p->n; i++) {
        const double *u = f->value[THUD_FLOOR_DISPLACEMENT] + (size_t)(p->first + i) * ENDS;
        double *drift = f->value[THUD_FLOOR_DRIFT] + (size_t)(p->first + i) * ENDS;
        for (int t = 0; t < f->ends; t++)
            drift[t] = !p->stiffness_npm ? 0 : i > 0 ? u[t] - (u - ENDS)[t] : u[t];
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
    if (quantity == THUD_FLOOR_ACCELERATION)
        spring_rows(f, m, p);
    floor_rows(f, p, quantity,
               quantity == THUD_FLOOR_DISPLACEMENT ? f->q
               : quantity == THUD_FLOOR_VELOCITY   ? f->qd
                                                   : f->spring,
               f->ends);
}

/* Acceleration of mode j of a structure without the ground's, at end t. */
static double spring_at(const struct thud_free_vibration *f, const struct thud_model *m,
                        const struct thud_model_structure *p, int j, int t)
{
    const int k = p->first_mode + j;
    double sum = m->spring[k] * (f->q[k * ENDS + t] - f->shift[k]) + m->dashpot[k] * f->qd[k * ENDS + t];
    for (int i = 0; p->damping && i < p->modes; i++)
        sum += p->damping[j * p->modes + i] * f->qd[(p->first_mode + i) * ENDS + t];
    return -sum;
}

/* Third derivative of a floor's displacement. */
static double jerk(const struct thud_free_vibration *f, const struct thud_model *m, int structure, int floor, int t,
                   double ground)
{
    const struct thud_model_structure *p = &m->structure[structure];
    const double *row = p->phi + floor * p->modes, *damped = f->coupled[structure].by_floor;
    double sum = 0;
    for (int j = 0; j < p->modes; j++) {
        const int k = p->first_mode + j;
        double second = spring_at(f, m, p, j, t) - m->gamma[k] * ground;
        sum -= row[j] * (m->spring[k] * f->qd[k * ENDS + t] + m->dashpot[k] * second);
        if (damped)
            sum -= damped[floor * p->modes + j] * second;
    }
    return sum;
}

double thud_free_vibration_rate(const struct thud_free_vibration *f, const struct thud_model *m, int structure,
                                int floor, int quantity, int t, double ground)
{
    const struct thud_model_structure *p = &m->structure[structure];
    const double *row = p->phi + floor * p->modes,
                 *below = quantity == THUD_FLOOR_DRIFT && floor > 0 ? row - p->modes : NULL;
    double sum = 0;
    if (quantity == THUD_FLOOR_ACCELERATION)
        return jerk(f, m, structure, floor, t, ground);
    for (int j = 0; j < p->modes; j++)
        sum += quantity == THUD_FLOOR_VELOCITY
                   ? row[j] * (spring_at(f, m, p, j, t) - m->gamma[p->first_mode + j] * ground)
                   : (row[j] - (below ? below[j] : 0)) * f->qd[(p->first_mode + j) * ENDS + t];
    return sum;
}

/* Bounds of a mode's derivatives in the block, by order from 2 on. */
static void mode_bounds(const struct thud_free_vibration *f, const struct thud_model *m, int j, double slope,
                        double bound[BOUNDS])
{
    double w2 = m->spring[j], z = m->dashpot[j], gamma = fabs(m->gamma[j]);
    double speed = f->speed[j] + f->dt_s * gamma * f->ground_most;
    bound[2] = (m->omega[j] + z) * speed + gamma * f->ground_most;
    bound[3] = w2 * speed + z * bound[2] + gamma * slope;
    for (int k = 4; k < BOUNDS; k++)
        bound[k] = w2 * bound[k - 2] + z * bound[k - 1];
}

/* Size of the forces by which damping couples mode i of the structure, for rates of these sizes. */
static double coupling(const struct thud_model_structure *p, int i, const double *rate)
{
    double sum = 0;
    for (int k = 0; k < p->modes; k++)
        sum += fabs(p->damping[i * p->modes + k]) * rate[k];
    return sum;
}

/* The same where damping couples the modes: f->bound. The energy norm S of all modes together grows at most by the
 * ground's part, damping or not; a mode's own speed also by what couples it, for which S is a first bound of every
 * other's. */
static void coupled_bounds(struct thud_free_vibration *f, const struct thud_model *m,
                           const struct thud_model_structure *p, double slope)
{
    enum { TIMES = 3 };
    const int n = p->modes, first = p->first_mode;
    const double dt = f->dt_s, ground = f->ground_most;
    double energy = 0, influence = 0;
    double *row[BOUNDS];
    for (int k = 0; k < BOUNDS; k++)
        row[k] = f->bound + k * f->n + first;
    for (int j = first; j < first + n; j++) {
        energy += f->speed[j] * f->speed[j];
        influence += m->gamma[j] * m->gamma[j];
    }
    const double all = sqrt(energy) + dt * sqrt(influence) * ground;
    for (int i = 0; i < n; i++)
        row[1][i] = all;
    for (int time = 0; time < TIMES; time++) {
        for (int i = 0; i < n; i++) {
            double own = f->speed[first + i] + dt * (fabs(m->gamma[first + i]) * ground + coupling(p, i, row[1]));
            row[0][i] = own < all ? own : all;
        }
        memcpy(row[1], row[0], (size_t)n * sizeof(double));
    }
    for (int k = 2; k < BOUNDS; k++)
        for (int i = 0; i < n; i++) {
            const double w = m->omega[first + i], gamma = fabs(m->gamma[first + i]);
            row[k][i] = (k == 2   ? w * row[1][i]
                         : k == 3 ? w * w * row[1][i]
                                  : w * w * row[k - 2][i]) +
                        coupling(p, i, row[k - 1]) +
                        (k == 2   ? gamma * ground
                         : k == 3 ? gamma * slope
                                  : 0);
        }
}

/* Bounds of the derivatives of the modes of one structure in the block, summed into margins: dt^2/8 times the second
 * derivative of a value bounds how far it may lie above its ends, and dt^4/384 times the fourth how far from the cubic
 * through values and rates at them. An acceleration is omega^2 q + 2 zeta omega q' (or + D q'): its derivatives have the
 * bounds of two orders more. */
static void structure_margins(struct thud_free_vibration *f, const struct thud_model *m, int s, double slope)
{
    const struct thud_model_structure *p = &m->structure[s];
    double dt = f->dt_s, sum[THUD_FLOOR_QUANTITIES] = {0}, cubic[THUD_FLOOR_QUANTITIES] = {0}, bound[BOUNDS];
    if (p->damping)
        coupled_bounds(f, m, p, slope);
    for (int j = p->first_mode; j < p->first_mode + p->modes; j++) {
        double most = m->mode_max[j], drift = m->mode_max[f->n + j];
        if (p->damping)
            for (int k = 2; k < BOUNDS; k++)
                bound[k] = f->bound[k * f->n + j];
        else
            mode_bounds(f, m, j, slope, bound);
        sum[THUD_FLOOR_DISPLACEMENT] += most * bound[2];
        sum[THUD_FLOOR_VELOCITY] += most * bound[3];
        sum[THUD_FLOOR_ACCELERATION] += most * bound[4];
        sum[THUD_FLOOR_DRIFT] += drift * bound[2];
        cubic[THUD_FLOOR_DISPLACEMENT] += most * bound[4];
        cubic[THUD_FLOOR_VELOCITY] += most * bound[5];
        cubic[THUD_FLOOR_ACCELERATION] += most * bound[6];
        cubic[THUD_FLOOR_DRIFT] += drift * bound[4];
    }
    for (int x = 0; x < THUD_FLOOR_QUANTITIES; x++) {
        f->margin[x * m->nstructures + s] = sum[x] * dt * dt / 8;
        f->cubic_margin[x * m->nstructures + s] = cubic[x] * dt * dt * dt * dt / 384;
    }
}

static void margins(struct thud_free_vibration *f, const struct thud_model *m, int intervals)
{
    double slope = 0;
    for (int t = 0; t < intervals; t++)
        slope = thud_larger(slope, fabs(f->after[t] - f->ground[t]));
    for (int s = 0; s < m->nstructures; s++)
        structure_margins(f, m, s, slope / f->dt_s);
}

/* Modal state of a structure at the start of a piece: that of the block, or of the piece before it at its end. */
static void start_piece(struct thud_free_vibration *f, const struct thud_model_structure *p, int t, int piece)
{
    double *q = f->now, *qd = f->now_rate, rate = 1 / f->seg.h_s;
    const int first = p->first_mode, end = first + p->modes;
    for (int j = first; j < end; j++) {
        q[j] = piece > 0 ? 0 : f->q[j * ENDS + t];
        qd[j] = piece > 0 ? 0 : f->qd[j * ENDS + t];
    }
    for (int k = f->seg.terms - 1; piece > 0 && k >= 0; k--)
        for (int j = first; j < end; j++) {
            qd[j] += q[j];
            q[j] += f->seg.q[k * f->n + j];
        }
    for (int j = first; j < end && piece > 0; j++)
        qd[j] *= rate;
}

const struct thud_segment *thud_free_vibration_series(struct thud_free_vibration *f, const struct thud_state *state,
                                                      int structure, int t, int piece)
{
    struct thud_free_vibration_place *at = &f->at[structure];
    const double h = f->dt_s / f->pieces;
    if (at->t != t || at->piece > piece)
        *at = (struct thud_free_vibration_place){t, -1};
    while (at->piece < piece) {
        start_piece(f, &state->model->structure[structure], t, ++at->piece);
        thud_segment_place(state, &f->seg, state->grid + t, at->piece * h, h);
        thud_taylor_structure(state->model, &f->seg, structure, f->now, f->now_rate);
        f->made++;
    }
    thud_segment_place(state, &f->seg, state->grid + t, piece * h, h); /* it may be another structure's */
    return &f->seg;
}

const struct thud_segment *thud_free_vibration_row_series(struct thud_free_vibration *f, const struct thud_state *state,
                                                          int c, int t, int piece)
{
    int structure[2], n = thud_model_row_structures(state->model, c, structure);
    for (int i = 0; i < n; i++)
        thud_free_vibration_series(f, state, structure[i], t, piece);
    return &f->seg;
}

const struct thud_segment *thud_free_vibration_all_series(struct thud_free_vibration *f, const struct thud_state *state,
                                                          int t, int piece)
{
    for (int s = 0; s < state->model->nstructures; s++)
        if (state->model->structure[s].modes > 0)
            thud_free_vibration_series(f, state, s, t, piece);
    return &f->seg;
}

/* The first interval in which a contact closes. */

static bool closes_in_piece(const struct thud_state *state, const struct thud_segment *seg, int c, bool first)
{
    double d[THUD_SEGMENT_TERMS];
    int zeros = thud_segment_indentation(state, seg, c, d), least = state->contact[c].suppressed.indentation;
    if (!first || least == 0)
        zeros = 0;
    else if (zeros < least)
        zeros = least;
    return zeros < seg->terms && thud_poly_first_above(d, seg->terms, 1, 1, zeros, THUD_TOL_INDENTATION_M) <= 1;
}

/* Whether one of the contacts that are near it closes in interval t. */
static bool closes(struct thud_free_vibration *f, const struct thud_state *state, int t)
{
    for (int piece = 0; piece < f->pieces; piece++)
        for (int c = 0; c < state->model->ncontacts; c++)
            if (f->near[c] &&
                closes_in_piece(state, thud_free_vibration_row_series(f, state, c, t, piece), c, t == 0 && piece == 0))
                return true;
    return false;
}

/* Of one side of a contact, from the floors' displacements at one end, rows ENDS apart. */
static double side_value(const struct thud_model_side *side, const double *u)
{
    double value = side->dof < 0 ? 0 : side->share * u[(size_t)side->dof * ENDS];
    return value + (side->below < 0 ? 0 : (1 - side->share) * u[(size_t)side->below * ENDS]);
}

double thud_free_vibration_side(struct thud_free_vibration *f, const struct thud_model *model,
                                const struct thud_model_side *side, int ends, double *margin)
{
    thud_free_vibration_values(f, model, side->structure, THUD_FLOOR_DISPLACEMENT);
    const double *u = f->value[THUD_FLOOR_DISPLACEMENT];
    *margin = f->margin[side->structure];
    for (int t = 0; t < ends; t++)
        f->gap[t] = fabs(side_value(side, u + t));
    return thud_largest(f->gap, ends);
}

/* How far the displacement of one side less that of the other, also of what lies between two floors, may lie above its
 * values at the ends. */
static double gap_margin(const struct thud_free_vibration *f, const struct thud_model_contact *p)
{
    return (p->left_dof < 0 ? 0 : f->margin[p->left.structure]) +
           (p->right_dof < 0 ? 0 : f->margin[p->right.structure]);
}

double thud_free_vibration_gap(struct thud_free_vibration *f, const struct thud_model *model, int c, int ends,
                               double *margin)
{
    const struct thud_model_contact *p = &model->contact[c];
    const double *u = f->value[THUD_FLOOR_DISPLACEMENT];
    const double *left = p->left_dof < 0 ? NULL : u + (size_t)p->left_dof * ENDS;
    const double *right = p->right_dof < 0 ? NULL : u + (size_t)p->right_dof * ENDS;
    *margin = gap_margin(f, p);
    if (left)
        thud_free_vibration_values(f, model, p->left.structure, THUD_FLOOR_DISPLACEMENT);
    if (right)
        thud_free_vibration_values(f, model, p->right.structure, THUD_FLOOR_DISPLACEMENT);
    if (p->struck != 0) {
        for (int t = 0; t < ends; t++)
            f->gap[t] = side_value(&p->left, u + t) - side_value(&p->right, u + t);
        return thud_largest(f->gap, ends);
    }
    for (int t = 0; t < ends; t++)
        f->gap[t] = (left ? left[t] : 0) - (right ? right[t] : 0);
    return thud_largest(f->gap, ends);
}

/* What the modes of the block can bring the sides of contact c together by, each at its largest speed; no number where
 * one of them is a free body's. */
static double gap_bound(const struct thud_free_vibration *f, const struct thud_model *m, int c)
{
    const double *g = m->jacobian + c * f->n;
    double sum = 0;
    for (int j = 0; j < f->n; j++)
        sum += fabs(g[j]) * f->speed[j] / m->omega[j] + g[j] * f->shift[j];
    return sum;
}

/* Gaps above which the contacts may close in an interval; whether any comes so far in the block. */
static bool set_limits(struct thud_free_vibration *f, const struct thud_state *state, int intervals)
{
    bool any = false;
    for (int c = 0; c < state->model->ncontacts; c++) {
        const struct thud_model_contact *p = &state->model->contact[c];
        const double limit = thud_state_clearance(state, c) - gap_margin(f, p);
        double margin;
        f->limit[c] = INFINITY;
        if (p->law->flags & THUD_LAW_NO_FORCE || gap_bound(f, state->model, c) <= limit)
            continue;
        if (thud_free_vibration_gap(f, state->model, c, intervals + 1, &margin) <= limit)
            continue;
        f->limit[c] = limit;
        any = true;
    }
    return any;
}

/* Marks the contacts that may close in interval t; whether there are any. */
static bool find_near(struct thud_free_vibration *f, const struct thud_state *state, int t)
{
    const struct thud_model *m = state->model;
    const double *u = f->value[THUD_FLOOR_DISPLACEMENT] + t;
    bool any = false;
    for (int c = 0; c < m->ncontacts; c++) {
        f->near[c] = false;
        if (f->limit[c] == INFINITY) /* where its displacements may not have been made */
            continue;
        const struct thud_model_side *left = &m->contact[c].left, *right = &m->contact[c].right;
        double start = side_value(left, u) - side_value(right, u),
               end = side_value(left, u + 1) - side_value(right, u + 1);
        f->near[c] = start > f->limit[c] || end > f->limit[c];
        any |= f->near[c];
    }
    return any;
}

/* Intervals until a contact closes, at most `intervals`. */
static int until_contact(struct thud_free_vibration *f, const struct thud_state *state, int intervals)
{
    if (!set_limits(f, state, intervals))
        return intervals;
    for (int t = 0; t < intervals; t++)
        if (find_near(f, state, t) && closes(f, state, t))
            return t;
    return intervals;
}

/* Whether storey k comes to its bound in interval t. */
static bool yields(struct thud_free_vibration *f, const struct thud_state *state, int k, int t)
{
    const struct thud_storey_state *s = &state->storey[k];
    double d[THUD_SEGMENT_TERMS];
    for (int piece = 0; piece < f->pieces; piece++) {
        const int row = state->model->ncontacts + k;
        const struct thud_segment *seg = thud_free_vibration_row_series(f, state, row, t, piece);
        thud_segment_indentation(state, seg, row, d);
        double drift = d[0];
        for (int side = -1; side <= 1; side += 2) {
            int zeros = t == 0 && piece == 0 && s->zero_side == side ? s->zeros : 0;
            d[0] = drift - s->plastic_m - side * state->model->storey[k].yield_m;
            if (thud_poly_first_above(d, seg->terms, 1, side, zeros, THUD_TOL_INDENTATION_M) <= 1)
                return true;
        }
    }
    return false;
}

/* Intervals until a storey yields, at most `intervals`. */
static int until_yield(struct thud_free_vibration *f, const struct thud_state *state, int intervals)
{
    const struct thud_model *m = state->model;
    const double *u = f->value[THUD_FLOOR_DISPLACEMENT];
    for (int k = 0; k < m->nstoreys; k++) {
        const struct thud_model_contact *row = &m->contact[m->ncontacts + k];
        const double *above = u + row->left_dof * ENDS, *below = row->right_dof < 0 ? NULL : u + row->right_dof * ENDS;
        const double plastic = state->storey[k].plastic_m,
                     limit =
                         m->storey[k].yield_m - f->margin[THUD_FLOOR_DRIFT * m->nstructures + m->storey[k].structure];
        thud_free_vibration_values(f, m, m->storey[k].structure, THUD_FLOOR_DISPLACEMENT);
        for (int t = 0; t <= intervals; t++)
            f->gap[t] = above[t] - (below ? below[t] : 0) - plastic;
        if (thud_largest_size(f->gap, intervals + 1) <= limit && state->storey[k].zeros == 0)
            continue;
        for (int t = 0; t < intervals; t++)
            if ((fabs(f->gap[t]) > limit || fabs(f->gap[t + 1]) > limit) && yields(f, state, k, t))
                intervals = t;
    }
    return intervals;
}

/* The two quadratic forms, in the sums of their products over the intervals. */
void thud_free_vibration_work(struct thud_free_vibration *f, const struct thud_model *model, int intervals,
                              double *input_j, double *viscous_j)
{
    const double *a0 = f->ground, *a1 = f->after;
    double ground[3] = {0}, input = 0, viscous = 0;
    for (int t = 0; t < intervals; t++) {
        ground[0] += a0[t] * a0[t];
        ground[1] += a0[t] * a1[t];
        ground[2] += a1[t] * a1[t];
    }
    for (int i = 0; i < 3; i++) {
        viscous += f->viscous_ground[i] * ground[i];
        input += f->work_ground[i] * ground[i];
    }
    for (int j = 0; j < f->n; j++) {
        if (f->summed != intervals)
            sum_products(f, j, model->omega[j], intervals);
        for (int i = 0; i < THUD_FREE_VIBRATION_PRODUCTS; i++)
            viscous += f->viscous[i][j] * f->product[i][j];
        input += f->work[0][j] * f->product[3][j] + f->work[1][j] * f->product[5][j] +
                 f->work[2][j] * f->product[4][j] + f->work[3][j] * f->product[6][j];
    }
    f->summed = intervals;
    for (int s = 0; s < f->nstructures; s++) {
        const struct thud_coupled_flight *c = &f->coupled[s];
        const int row = c->first_mode * ENDS;
        for (int t = 0; t < intervals && c->size > 0; t++)
            thud_coupled_flight_work(c, f->q + row, f->qd + row, ENDS, f->shift + c->first_mode, a0[t], a1[t], t,
                                     &input, &viscous);
    }
    *input_j = input;
    *viscous_j = viscous;
}

void thud_free_vibration_end(const struct thud_free_vibration *f, int intervals, double *q, double *qd)
{
    for (int j = 0; j < f->n; j++) {
        q[j] = f->q[j * ENDS + intervals];
        qd[j] = f->qd[j * ENDS + intervals];
    }
}

/* Intervals to try: to the end of the run and of the aligned block at most. */
static int room(const struct thud_free_vibration *f, const struct thud_state *state)
{
    long left = (long)floor(state->end_s / f->dt_s * (1 + THUD_TOL_TIME)) - state->grid,
         aligned = THUD_FREE_VIBRATION_BLOCK - state->grid % THUD_FREE_VIBRATION_BLOCK;
    if (state->offset_s != 0 || left <= 0 || state->nyielding > 0)
        return 0;
    for (int c = 0; c < state->model->ncontacts; c++)
        if (state->contact[c].mode != THUD_OPEN)
            return 0;
    left = left < aligned ? left : aligned;
    if (left * f->pieces > PIECES_MOST)
        left = f->pieces < PIECES_MOST ? PIECES_MOST / f->pieces : 1;
    return left < f->size ? (int)left : f->size;
}

int thud_free_vibration_march(struct thud_free_vibration *f, const struct thud_state *state)
{
    const struct thud_model *m = state->model;
    int tried = room(f, state);
    if (tried == 0)
        return 0;
    march(f, state, tried);
    sum_block(f, m, tried);
    margins(f, m, tried);
    int intervals = until_yield(f, state, until_contact(f, state, tried));
    f->size = intervals < tried                         ? SHORT_BLOCK
              : 2 * f->size < THUD_FREE_VIBRATION_BLOCK ? 2 * f->size
                                                        : THUD_FREE_VIBRATION_BLOCK;
    return intervals;
}
