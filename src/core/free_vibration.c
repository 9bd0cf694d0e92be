#include "core/free_vibration.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/double_pair.h"
#include "core/early_end.h"
#include "core/largest.h"
#include "core/poly.h"
#include "core/quadrature.h"
#include "core/relative_displacement.h"
#include "core/tolerance.h"

/* free_vibration.c: motion of one piece of the run's interval as a series, from f->now. */
static void thud_free_vibration_series(struct thud_run *run, struct thud_free_vibration *f, int piece);

/* Free flight: the tables of one interval of the ground motion. */

/* Unit motions over one interval: initial q, initial q', ground acceleration falling from 1 to 0, and rising from 0
 * to 1. */
enum { UNIT_Q, UNIT_QD, UNIT_A0, UNIT_A1, UNITS };

static bool allocate(struct thud_free_vibration *f, const struct thud_model *m)
{
    size_t n = (size_t)m->nmodes, floors = (size_t)m->ndof,
           rows = (n + THUD_FREE_VIBRATION_BATCH - 1) / THUD_FREE_VIBRATION_BATCH * THUD_FREE_VIBRATION_BATCH,
           many = rows * THUD_FREE_VIBRATION_ENDS, high = floors * THUD_FREE_VIBRATION_ENDS;
    double **by_mode[32], **by_end[] = {&f->q, &f->qd, &f->spring, &f->bound[0], &f->bound[1], &f->bound[2]};
    double **single[] = {&f->gap, &f->energy, &f->ground, &f->after, &f->lower, &f->upper};
    size_t count = 0, ends = sizeof by_end / sizeof *by_end, singles = sizeof single / sizeof *single;
    for (int i = 0; i < 4; i++) {
        by_mode[count++] = &f->e[i];
        by_mode[count++] = &f->p[i];
        by_mode[count++] = &f->work[i];
    }
    for (int i = 0; i < 7; i++)
        by_mode[count++] = &f->viscous[i];
    double **rest[] = {&f->now, &f->now_rate, &f->speed};
    for (size_t i = 0; i < sizeof rest / sizeof *rest; i++)
        by_mode[count++] = rest[i];
    for (int s = 0; s < m->nstructures; s++)
        f->stride = f->stride > m->structure[s].modes ? f->stride : m->structure[s].modes;
    size_t total = count * rows + ends * many + THUD_FLOOR_QUANTITIES * high + singles * THUD_FREE_VIBRATION_ENDS +
                   THUD_FLOOR_QUANTITIES * (size_t)m->nstructures +
                   2 * THUD_FLOOR_QUANTITIES * floors * (size_t)f->stride + (size_t)m->ncontacts;
    double *next = f->block = calloc(total, sizeof *next);
    if (!next)
        return false;
    for (size_t i = 0; i < count; i++, next += rows)
        *by_mode[i] = next;
    for (size_t i = 0; i < ends; i++, next += many)
        *by_end[i] = next;
    for (int x = 0; x < THUD_FLOOR_QUANTITIES; x++, next += high)
        f->value[x] = next;
    for (size_t i = 0; i < singles; i++, next += THUD_FREE_VIBRATION_ENDS)
        *single[i] = next;
    f->margin = next;
    f->kept = f->margin + THUD_FLOOR_QUANTITIES * m->nstructures;
    f->limit = f->kept + 2 * THUD_FLOOR_QUANTITIES * floors * (size_t)f->stride;
    f->deferred = calloc(THUD_FLOOR_QUANTITIES * floors, sizeof *f->deferred);
    f->looked = calloc(2 * (size_t)m->nstructures + (size_t)m->ncontacts + 1, sizeof *f->looked);
    f->bounded = f->looked + m->nstructures;
    f->near = f->bounded + m->nstructures;
    return f->deferred != NULL && f->looked != NULL;
}

/* Rates of the four unit motions at one quadrature point enter the integrals of their products. */
static void add_point(struct thud_free_vibration *f, const struct thud_model *m, double weight, double s,
                      double *const rate[UNITS])
{
    double a[2] = {1 - s, s};
    for (int j = 0; j < f->n; j++) {
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

enum { POINTS = THUD_QUADRATURE_POINTS };

/* Moves unit motion u over one piece; its rates at the quadrature points into rate (POINTS x n). */
static void move_unit(struct thud_run *run, const struct thud_free_vibration *f, int u, int piece, double *q,
                      double *qd, double *rate)
{
    struct thud_segment *seg = &run->seg;
    double s0 = (double)piece / f->pieces, ds = 1.0 / f->pieces;
    thud_segment_begin(&run->state, seg, run->state.grid_dt_s * ds);
    seg->a0 = u == UNIT_A0 ? 1 - s0 : u == UNIT_A1 ? s0 : 0;
    seg->a1 = u == UNIT_A0 ? -ds : u == UNIT_A1 ? ds : 0;
    thud_taylor_given(run->state.model, seg, q, qd);
    for (int i = 0; i < POINTS; i++)
        thud_segment_state(seg, f->n, thud_quadrature_node[i], f->now, rate + i * f->n);
    thud_segment_state(seg, f->n, 1, q, qd);
}

/* Marches the four unit motions through one interval in pieces short enough for the series. */
static enum thud_status unit_motions(struct thud_run *run, struct thud_free_vibration *f, struct thud_error *err)
{
    size_t n = (size_t)run->state.model->nmodes, size = (2 + POINTS) * n;
    double *state = calloc(UNITS * size + 1, sizeof *state), *q[UNITS], *qd[UNITS], *rate[UNITS];
    if (!state)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    for (size_t u = 0; u < UNITS; u++) {
        q[u] = state + u * size;
        qd[u] = q[u] + n;
    }
    for (size_t j = 0; j < n; j++)
        q[UNIT_Q][j] = qd[UNIT_QD][j] = 1;
    f->pieces = 1 + (int)(run->state.fastest_radps * run->state.grid_dt_s / 1.8);
    for (int piece = 0; piece < f->pieces; piece++) {
        for (int u = 0; u < UNITS; u++)
            move_unit(run, f, u, piece, q[u], qd[u], qd[u] + n);
        for (int i = 0; i < POINTS; i++) {
            for (int u = 0; u < UNITS; u++)
                rate[u] = qd[u] + n + (size_t)i * n;
            double ds = 1.0 / f->pieces, s = (piece + thud_quadrature_node[i]) * ds;
            add_point(f, run->state.model, thud_quadrature_weight[i] * ds * run->state.grid_dt_s, s, rate);
        }
    }
    for (int u = 0; u < UNITS; u++) {
        memcpy(u < 2 ? f->e[u] : f->p[u - 2], q[u], n * sizeof(double));
        memcpy(u < 2 ? f->e[u + 2] : f->p[u], qd[u], n * sizeof(double));
    }
    free(state);
    return THUD_OK;
}

enum thud_status thud_free_vibration_create(struct thud_run *run, struct thud_error *err)
{
    run->free_vibration = NULL;
    if (run->state.model->couples || run->state.model->nmodes == 0)
        return THUD_OK;
    struct thud_free_vibration *f = calloc(1, sizeof *f);
    if (!f || !allocate(f, run->state.model)) {
        thud_free_vibration_free(f);
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    f->n = run->state.model->nmodes;
    f->size = THUD_FREE_VIBRATION_BLOCK;
    enum thud_status status = unit_motions(run, f, err);
    if (status != THUD_OK) {
        thud_free_vibration_free(f);
        return status;
    }
    run->free_vibration = f;
    return THUD_OK;
}

void thud_free_vibration_free(struct thud_free_vibration *flight)
{
    if (!flight)
        return;
    free(flight->deferred);
    free(flight->looked);
    free(flight->block);
    free(flight);
}

/* Peaks of free flight. Bounds show which interval holds the peak of a floor's value; until a higher one comes or the
 * result is asked for, that it is there is enough, and no series is made. */

enum { ENDS = THUD_FREE_VIBRATION_ENDS };

/* One floor's row of the block. */
struct row {
    int structure, floor, quantity;
    const double *x;
    struct thud_peak *peak;
    double margin;
};

/* Rate of a row's value at end t of an interval whose ground acceleration there is `ground`. */
static double rate_at(const struct thud_run *run, const struct thud_free_vibration *f, const struct row *row, int t,
                      double ground)
{
    const struct thud_model *m = run->state.model;
    const struct thud_model_structure *p = &m->structure[row->structure];
    const double *v = f->value[THUD_FLOOR_VELOCITY] + (p->first + row->floor) * ENDS + t;
    if (row->quantity == THUD_FLOOR_DISPLACEMENT)
        return *v;
    if (row->quantity == THUD_FLOOR_DRIFT)
        return row->floor > 0 ? *v - v[-ENDS] : *v;
    if (row->quantity == THUD_FLOOR_VELOCITY)
        return f->value[THUD_FLOOR_ACCELERATION][(p->first + row->floor) * ENDS + t] -
               m->ground_influence[p->first + row->floor] * ground;
    double jerk = 0;
    for (int j = 0; j < p->modes; j++) {
        int k = p->first_mode + j;
        double second = f->spring[k * ENDS + t] - m->gamma[k] * ground;
        jerk -= p->phi[row->floor * p->modes + j] * m->omega[k] *
                (m->omega[k] * f->qd[k * ENDS + t] + 2 * m->zeta[k] * second);
    }
    return jerk;
}

/* Largest |p| on [0, 1] of the cubic with values x0, x1 and rates (by s) r0, r1 at the ends. */
static double cubic_peak(double x0, double x1, double r0, double r1)
{
    double c2 = 3 * (x1 - x0) - 2 * r0 - r1, c3 = 2 * (x0 - x1) + r0 + r1;
    double most = thud_larger(fabs(x0), fabs(x1)), root = c2 * c2 - 3 * c3 * r0;
    if (root < 0)
        return most;
    root = sqrt(root);
    double u = -(c2 + (c2 < 0 ? -root : root)); /* 3 c3 s^2 + 2 c2 s + r0 = 0, without cancellation */
    double s[2] = {u / (3 * c3), r0 / u};
    for (int i = 0; i < 2; i++)
        if (s[i] > 0 && s[i] < 1)
            most = thud_larger(most, fabs(x0 + s[i] * (r0 + s[i] * (c2 + s[i] * c3))));
    return most;
}

/* Bounds of the fourth, fifth and sixth derivative of the modes of a structure in each interval of the block. */
static void bound_derivatives(const struct thud_run *run, struct thud_free_vibration *f, int structure, int intervals)
{
    const struct thud_model *m = run->state.model;
    const struct thud_model_structure *p = &m->structure[structure];
    double dt = run->state.grid_dt_s, *restrict fourth = f->bound[0], *restrict fifth = f->bound[1],
           *restrict sixth = f->bound[2];
    const double *restrict a0 = f->ground, *restrict a1 = f->after;
    for (int j = p->first_mode; j < p->first_mode + p->modes; j++) {
        double w = m->omega[j], w2 = w * w, z = 2 * m->zeta[j] * w, reach = fabs(m->gamma[j]);
        const double *restrict q = f->q + j * ENDS, *restrict qd = f->qd + j * ENDS;
        for (int t = 0; t < intervals; t++) {
            double strain = w * fabs(q[t]), rate = fabs(qd[t]), ground = reach * thud_larger(fabs(a0[t]), fabs(a1[t]));
            /* above the root of the squares' sum, by an eighth at most */
            double speed = thud_larger(strain + 0.5 * rate, rate + 0.5 * strain) + dt * ground;
            double second = (w + z) * speed + ground;
            double third = w2 * speed + z * second + reach * fabs(a1[t] - a0[t]) / dt;
            fourth[j * ENDS + t] = w2 * second + z * third;
            fifth[j * ENDS + t] = w2 * third + z * fourth[j * ENDS + t];
            sixth[j * ENDS + t] = w2 * fourth[j * ENDS + t] + z * fifth[j * ENDS + t];
        }
    }
    f->bounded[structure] = true;
}

/* How far a row's value in interval t may lie from the cubic through values and rates at its ends: dt^4/384 times a
 * bound of its fourth derivative there. */
static double cubic_margin(const struct thud_run *run, const struct thud_free_vibration *f, const struct row *row,
                           int t)
{
    const struct thud_model_structure *p = &run->state.model->structure[row->structure];
    const double *shape = p->phi + row->floor * p->modes, *below = row->floor > 0 ? shape - p->modes : NULL;
    bool drift = row->quantity == THUD_FLOOR_DRIFT && below;
    /* an acceleration is omega^2 q + 2 zeta omega q' */
    const double *bound = row->quantity == THUD_FLOOR_VELOCITY       ? f->bound[1]
                          : row->quantity == THUD_FLOOR_ACCELERATION ? f->bound[2]
                                                                     : f->bound[0];
    double dt = run->state.grid_dt_s, sum = 0;
    for (int j = 0; j < p->modes; j++)
        sum += fabs(drift ? shape[j] - below[j] : shape[j]) * bound[(p->first_mode + j) * ENDS + t];
    return sum * dt * dt * dt * dt / 384;
}

/* Reads the peak of a row in the interval that was kept for it. */
static void read_deferred(struct thud_run *run, struct thud_free_vibration *f, int structure, int floor, int quantity)
{
    const struct thud_model_structure *p = &run->state.model->structure[structure];
    size_t n = (size_t)f->n, modes = (size_t)p->modes;
    int index = quantity * run->state.model->ndof + p->first + floor;
    struct thud_deferred_peak *deferred = &f->deferred[index];
    const double offset = run->state.offset_s;
    const long grid = run->state.grid;
    deferred->waits = false;
    run->state.grid = deferred->grid;
    const double *q = f->kept + (size_t)index * 2 * (size_t)f->stride;
    memset(f->now, 0, n * sizeof *f->now); /* the other structures do not matter to this one's motion */
    memset(f->now_rate, 0, n * sizeof *f->now_rate);
    memcpy(f->now + p->first_mode, q, modes * sizeof *f->now);
    memcpy(f->now_rate + p->first_mode, q + f->stride, modes * sizeof *f->now_rate);
    for (int piece = 0; piece < f->pieces; piece++) {
        thud_free_vibration_series(run, f, piece);
        if (quantity == THUD_FLOOR_ACCELERATION)
            thud_peaks_prepare(&run->peaks, &run->state, &run->seg);
        thud_peaks_floor(&run->peaks, &run->state, &run->seg, structure, floor, quantity, 1);
        if (piece + 1 < f->pieces)
            thud_segment_state(&run->seg, f->n, 1, f->now, f->now_rate);
    }
    run->state.grid = grid;
    run->state.offset_s = offset;
}

void thud_free_vibration_read_deferred(struct thud_run *run)
{
    struct thud_free_vibration *f = run->free_vibration;
    for (int s = 0; s < run->state.model->nstructures; s++)
        for (int i = 0; i < run->state.model->structure[s].n; i++)
            for (int x = 0; x < THUD_FLOOR_QUANTITIES; x++)
                if (f->deferred[x * run->state.model->ndof + run->state.model->structure[s].first + i].waits)
                    read_deferred(run, f, s, i, x);
}

/* Keeps interval t for the row, whose peak in it is at least `least`, at most `most`. */
static void defer_peak(struct thud_run *run, struct thud_free_vibration *f, const struct row *row, int t, double least,
                       double most)
{
    int index = row->quantity * run->state.model->ndof + run->state.model->structure[row->structure].first + row->floor;
    struct thud_deferred_peak *kept = &f->deferred[index];
    if (kept->waits && kept->most > least)
        read_deferred(run, f, row->structure, row->floor, row->quantity);
    if (most <= row->peak->value)
        return;
    const struct thud_model_structure *p = &run->state.model->structure[row->structure];
    double *q = f->kept + (size_t)index * 2 * (size_t)f->stride;
    for (int j = 0; j < p->modes; j++) {
        q[j] = f->q[(p->first_mode + j) * ENDS + t];
        q[f->stride + j] = f->qd[(p->first_mode + j) * ENDS + t];
    }
    *kept = (struct thud_deferred_peak){true, run->state.grid + t, most};
    least *= 1 - THUD_TOL_PEAK_BOUND; /* so that what is read in the end is above it */
    if (least > row->peak->value)
        *row->peak = (struct thud_peak){least, (double)(run->state.grid + t) * run->state.grid_dt_s};
}

/* Intervals with an end at `near` or above, in order; how many. */
static int intervals_near(const double *x, int intervals, double near, int *list)
{
    int count = 0;
    bool before = fabs(x[0]) >= near;
    for (int t = 0; t < intervals; t++) {
        bool after = fabs(x[t + 1]) >= near;
        list[count] = t;
        count += before | after;
        before = after;
    }
    return count;
}

/* Finds the intervals inside which the row may pass both its peak so far and what it surely reaches in the block. */
static void find_deferred(struct thud_run *run, struct thud_free_vibration *f, const struct row *row, int intervals)
{
    const double *x = row->x;
    double most = thud_largest_size(x, intervals + 1), dt = run->state.grid_dt_s;
    if (most + row->margin <= row->peak->value)
        return;
    if (!f->bounded[row->structure])
        bound_derivatives(run, f, row->structure, intervals);
    double limit = thud_larger(row->peak->value, most);
    int list[THUD_FREE_VIBRATION_BLOCK], count = intervals_near(x, intervals, limit - row->margin, list);
    for (int i = 0; i < count; i++) {
        int t = list[i];
        double r0 = rate_at(run, f, row, t, f->ground[t]), r1 = rate_at(run, f, row, t + 1, f->after[t]);
        double cubic = cubic_peak(x[t], x[t + 1], dt * r0, dt * r1), margin = cubic_margin(run, f, row, t);
        f->upper[t] = cubic + margin;
        f->lower[t] = cubic - margin;
        limit = thud_larger(limit, f->lower[t]);
    }
    for (int i = 0; i < count; i++) {
        int t = list[i];
        if (f->upper[t] >= limit && f->upper[t] > row->peak->value)
            defer_peak(run, f, row, t, f->lower[t], f->upper[t]);
    }
}

/* Peaks of the structures that are looked at in a marched block. */
static void thud_free_vibration_peaks(struct thud_run *run, struct thud_free_vibration *f, int intervals)
{
    const struct thud_model *m = run->state.model;
    for (int s = 0; s < m->nstructures; s++) {
        f->bounded[s] = false;
        for (int i = 0; i < m->structure[s].n && f->looked[s]; i++)
            for (int x = 0; x < (m->structure[s].stiffness_npm ? THUD_FLOOR_QUANTITIES : THUD_FLOOR_DRIFT); x++) {
                struct row row = {s,
                                  i,
                                  x,
                                  f->value[x] + (m->structure[s].first + i) * ENDS,
                                  thud_floor_peak(&run->result, s, i, x),
                                  f->margin[x * m->nstructures + s]};
                find_deferred(run, f, &row, intervals);
            }
    }
}

/* Free flight over whole intervals of the ground motion by the exact 2x2 recurrence of every mode (Nigam and Jennings
 * 1969), a block of intervals at a time. Bounds show in which intervals neither a contact nor a new peak is possible;
 * only the others are looked at as power series. The motion itself is the recurrence's in any case, so that gaps
 * that do not close change nothing. */

enum { SHORT_BLOCK = 8 };

/* The recurrence of several modes at once: one mode alone is a chain in which each interval depends on the one before. */
static void batched_recurrence(struct thud_free_vibration *f, int j, int intervals)
{
    enum { N = THUD_FREE_VIBRATION_BATCH };
    double *q = f->q + j * ENDS, *qd = f->qd + j * ENDS, x[N], v[N], e[4][N], p[4][N];
    for (int i = 0; i < N; i++) {
        x[i] = q[i * ENDS];
        v[i] = qd[i * ENDS];
        for (int k = 0; k < 4; k++) {
            e[k][i] = f->e[k][j + i];
            p[k][i] = f->p[k][j + i];
        }
    }
    for (int t = 0; t < intervals; t++) {
        double a0 = f->ground[t], a1 = f->after[t], next[N];
        for (int i = 0; i < N; i++)
            next[i] = (e[0][i] * x[i] + e[1][i] * v[i]) + (p[0][i] * a0 + p[1][i] * a1);
        for (int i = 0; i < N; i++)
            v[i] = (e[2][i] * x[i] + e[3][i] * v[i]) + (p[2][i] * a0 + p[3][i] * a1);
        for (int i = 0; i < N; i++) {
            q[i * ENDS + t + 1] = x[i] = next[i];
            qd[i * ENDS + t + 1] = v[i];
        }
    }
}

static void march(struct thud_free_vibration *f, const struct thud_run *run, int intervals)
{
    for (int t = 0; t < intervals; t++)
        thud_state_ground(&run->state, run->state.grid + t, &f->ground[t], &f->after[t]);
    for (int j = 0; j < f->n; j++) {
        f->q[j * ENDS] = run->state.q[j];
        f->qd[j * ENDS] = run->state.qd[j];
    }
    for (int j = 0; j < f->n; j += THUD_FREE_VIBRATION_BATCH)
        batched_recurrence(f, j, intervals);
}

/* Largest energy norm sqrt(q'^2 + omega^2 q^2) of mode j at the ends. */
static double largest_speed(const struct thud_free_vibration *f, int j, double omega, int ends)
{
    const double *q = f->q + j * ENDS, *qd = f->qd + j * ENDS;
    double w2 = omega * omega;
    for (int t = 0; t < ends; t++)
        f->energy[t] = qd[t] * qd[t] + w2 * q[t] * q[t];
    return sqrt(thud_largest_size(f->energy, ends));
}

/* One floor's values at the ends from those of its modes, by four ends at a time: rows are long enough. */
static void floor_row(struct thud_free_vibration *f, const struct thud_model_structure *p, int i, int quantity,
                      const double *from, int ends)
{
    double *to = f->value[quantity] + (size_t)(p->first + i) * ENDS;
    const double *row = p->phi + i * p->modes;
    for (int t = 0; t < ends; t += 4) {
        const double *x = from + p->first_mode * ENDS + t;
        thud_pair a = {0, 0}, b = {0, 0};
        for (int j = 0; j < p->modes; j++, x += ENDS) {
            a += row[j] * thud_pair_at(x);
            b += row[j] * thud_pair_at(x + 2);
        }
        *(thud_pair *)(to + t) = a;
        *(thud_pair *)(to + t + 2) = b;
    }
}

/* Velocity, total acceleration and drift of a structure's floors at the ends. */
static void other_values(struct thud_free_vibration *f, const struct thud_model *m,
                         const struct thud_model_structure *p, int ends)
{
    for (int j = p->first_mode; j < p->first_mode + p->modes; j++) {
        double w2 = m->omega[j] * m->omega[j], z = 2 * m->zeta[j] * m->omega[j];
        const double *q = f->q + j * ENDS, *qd = f->qd + j * ENDS;
        double *a = f->spring + j * ENDS;
        for (int t = 0; t < ends; t++)
            a[t] = -(w2 * q[t] + z * qd[t]);
    }
    for (int i = 0; i < p->n; i++) {
        floor_row(f, p, i, THUD_FLOOR_VELOCITY, f->qd, ends);
        floor_row(f, p, i, THUD_FLOOR_ACCELERATION, f->spring, ends);
        const double *u = f->value[THUD_FLOOR_DISPLACEMENT] + (size_t)(p->first + i) * ENDS;
        double *drift = f->value[THUD_FLOOR_DRIFT] + (size_t)(p->first + i) * ENDS;
        for (int t = 0; t < ends; t++)
            drift[t] = !p->stiffness_npm ? 0 : i > 0 ? u[t] - (u - ENDS)[t] : u[t];
    }
}

static void displacements(struct thud_free_vibration *f, const struct thud_model *m, int ends)
{
    for (int s = 0; s < m->nstructures; s++)
        for (int i = 0; i < m->structure[s].n; i++)
            floor_row(f, &m->structure[s], i, THUD_FLOOR_DISPLACEMENT, f->q, ends);
    for (int j = 0; j < f->n; j++)
        f->speed[j] = largest_speed(f, j, m->omega[j], ends);
}

/* The other values of structures that move enough for a new peak. */
static void look_for_peaks(struct thud_free_vibration *f, struct thud_run *run, double ground, int ends)
{
    const struct thud_model *m = run->state.model;
    for (int s = 0; s < m->nstructures; s++) {
        const struct thud_model_structure *p = &m->structure[s];
        double energy = 0, gamma = 0;
        for (int j = p->first_mode; j < p->first_mode + p->modes; j++) {
            energy += f->speed[j] * f->speed[j];
            gamma += m->gamma[j] * m->gamma[j];
        }
        struct thud_response_bound reach = {sqrt(energy) + run->state.grid_dt_s * sqrt(gamma) * ground, 0};
        f->looked[s] =
            run->early_end_to_fill || thud_response_bound_structure(&run->peaks, run->state.model, s, &reach);
        if (f->looked[s])
            other_values(f, m, p, ends);
    }
}

/* Bounds of the derivatives of the modes of one structure in the block, by order (from 2 on), summed into margins:
 * dt^2/8 times the second derivative of a value bounds how far it may lie above its ends. */
static void structure_margins(struct thud_free_vibration *f, const struct thud_run *run, int s, double ground,
                              double slope)
{
    const struct thud_model *m = run->state.model;
    const struct thud_model_structure *p = &m->structure[s];
    double dt = run->state.grid_dt_s, sum[THUD_FLOOR_QUANTITIES] = {0};
    for (int j = p->first_mode; j < p->first_mode + p->modes; j++) {
        double w2 = m->omega[j] * m->omega[j], z = 2 * m->zeta[j] * m->omega[j], reach = fabs(m->gamma[j]);
        double speed = f->speed[j] + dt * reach * ground, bound[4];
        bound[2] = (m->omega[j] + z) * speed + reach * ground;
        bound[3] = w2 * speed + z * bound[2] + reach * slope;
        double most = run->peaks.mode_max[j], drift = run->peaks.mode_max[m->nmodes + j];
        sum[THUD_FLOOR_DISPLACEMENT] += most * bound[2];
        sum[THUD_FLOOR_VELOCITY] += most * bound[3];
        sum[THUD_FLOOR_ACCELERATION] += most * (w2 * bound[2] + z * bound[3]); /* of omega^2 q + 2 zeta omega q' */
        sum[THUD_FLOOR_DRIFT] += drift * bound[2];
    }
    for (int x = 0; x < THUD_FLOOR_QUANTITIES; x++)
        f->margin[x * m->nstructures + s] = sum[x] * dt * dt / 8;
}

static double largest_ground(const struct thud_free_vibration *f, int intervals)
{
    return thud_larger(thud_largest_size(f->ground, intervals), thud_largest_size(f->after, intervals));
}

static void margins(struct thud_free_vibration *f, const struct thud_run *run, double ground, int intervals)
{
    double slope = 0;
    for (int t = 0; t < intervals; t++)
        slope = thud_larger(slope, fabs(f->after[t] - f->ground[t]));
    slope /= run->state.grid_dt_s;
    for (int s = 0; s < run->state.model->nstructures; s++)
        structure_margins(f, run, s, ground, slope);
}

static void thud_free_vibration_series(struct thud_run *run, struct thud_free_vibration *f, int piece)
{
    double h = run->state.grid_dt_s / f->pieces;
    run->state.offset_s = piece * h;
    thud_segment_begin(&run->state, &run->seg, h);
    thud_taylor_given(run->state.model, &run->seg, f->now, f->now_rate);
}

static void start_interval(const struct thud_free_vibration *f, int t)
{
    for (int j = 0; j < f->n; j++) {
        f->now[j] = f->q[j * ENDS + t];
        f->now_rate[j] = f->qd[j * ENDS + t];
    }
}

/* Whether contact c closes in the piece of interval t that the run's segment holds. */
static bool closes_in_piece(const struct thud_run *run, int c, bool first)
{
    double d[THUD_SEGMENT_TERMS];
    int zeros = thud_segment_indentation(&run->state, &run->seg, c, d),
        least = run->state.contact[c].suppressed.indentation;
    if (!first || least == 0)
        zeros = 0;
    else if (zeros < least)
        zeros = least;
    return zeros < run->seg.terms && thud_poly_first_above(d, run->seg.terms, 1, 1, zeros, THUD_TOL_INDENTATION_M) <= 1;
}

/* Whether one of the contacts that are near it closes in interval t. */
static bool closes(struct thud_run *run, struct thud_free_vibration *f, int t)
{
    long base = run->state.grid;
    bool found = false;
    run->state.grid += t;
    start_interval(f, t);
    for (int piece = 0; piece < f->pieces && !found; piece++) {
        thud_free_vibration_series(run, f, piece);
        for (int c = 0; c < run->state.model->ncontacts && !found; c++)
            found = f->near[c] && closes_in_piece(run, c, t == 0 && piece == 0);
        if (piece + 1 < f->pieces)
            thud_segment_state(&run->seg, f->n, 1, f->now, f->now_rate);
    }
    run->state.grid = base;
    run->state.offset_s = 0;
    return found;
}

double thud_free_vibration_gap(struct thud_free_vibration *f, const struct thud_model *model, int c, int ends,
                               double *margin)
{
    const struct thud_model_contact *p = &model->contact[c];
    const double *u = f->value[THUD_FLOOR_DISPLACEMENT];
    const double *left = p->left_dof < 0 ? NULL : u + (size_t)p->left_dof * ENDS;
    const double *right = p->right_dof < 0 ? NULL : u + (size_t)p->right_dof * ENDS;
    *margin = left ? f->margin[model->dof_structure[p->left_dof]] : 0;
    *margin += right ? f->margin[model->dof_structure[p->right_dof]] : 0;
    for (int t = 0; t < ends; t++)
        f->gap[t] = (left ? left[t] : 0) - (right ? right[t] : 0);
    return thud_largest(f->gap, ends);
}

/* Gaps above which the contacts may close in an interval; whether any comes so far in the block. */
static bool set_limits(struct thud_run *run, struct thud_free_vibration *f, int intervals)
{
    bool any = false;
    for (int c = 0; c < run->state.model->ncontacts; c++) {
        f->limit[c] = INFINITY;
        if (run->state.model->contact[c].law->flags & THUD_LAW_NO_FORCE)
            continue;
        double margin, most = thud_free_vibration_gap(f, run->state.model, c, intervals + 1, &margin);
        if (most <= thud_state_clearance(&run->state, c) - margin)
            continue;
        f->limit[c] = thud_state_clearance(&run->state, c) - margin;
        any = true;
    }
    return any;
}

/* Marks the contacts that may close in interval t; whether there are any. */
static bool find_near(const struct thud_run *run, struct thud_free_vibration *f, int t)
{
    const struct thud_model *m = run->state.model;
    const double *u = f->value[THUD_FLOOR_DISPLACEMENT] + t;
    bool any = false;
    for (int c = 0; c < m->ncontacts; c++) {
        int left = m->contact[c].left_dof, right = m->contact[c].right_dof;
        double start = 0, end = 0;
        if (left >= 0) {
            start += u[left * ENDS];
            end += u[left * ENDS + 1];
        }
        if (right >= 0) {
            start -= u[right * ENDS];
            end -= u[right * ENDS + 1];
        }
        f->near[c] = start > f->limit[c] || end > f->limit[c];
        any |= f->near[c];
    }
    return any;
}

/* Intervals until a contact closes, at most `intervals`. */
static int until_contact(struct thud_run *run, struct thud_free_vibration *f, int intervals)
{
    if (!set_limits(run, f, intervals))
        return intervals;
    for (int t = 0; t < intervals; t++)
        if (find_near(run, f, t) && closes(run, f, t))
            return t;
    return intervals;
}

static double sum(const double *x, int n)
{
    double total = 0;
    for (int t = 0; t < n; t++)
        total += x[t];
    return total;
}

static void add_energies(struct thud_free_vibration *f, struct thud_run *run, int intervals)
{
    double *restrict e = f->energy;
    const double *a0 = f->ground, *a1 = f->after, *gv = f->viscous_ground, *gw = f->work_ground;
    for (int t = 0; t < intervals; t++)
        e[t] = gv[0] * a0[t] * a0[t] + gv[1] * a0[t] * a1[t] + gv[2] * a1[t] * a1[t];
    for (int j = 0; j < f->n; j++) {
        const double *q = f->q + j * ENDS, *v = f->qd + j * ENDS;
        double c[7];
        for (int i = 0; i < 7; i++)
            c[i] = f->viscous[i][j];
        for (int t = 0; t < intervals; t++)
            e[t] += q[t] * (c[0] * q[t] + c[1] * v[t] + c[3] * a0[t] + c[4] * a1[t]) +
                    v[t] * (c[2] * v[t] + c[5] * a0[t] + c[6] * a1[t]);
    }
    run->ledger.viscous_j += sum(e, intervals);
    for (int t = 0; t < intervals; t++)
        e[t] = gw[0] * a0[t] * a0[t] + gw[1] * a0[t] * a1[t] + gw[2] * a1[t] * a1[t];
    for (int j = 0; j < f->n; j++) {
        const double *q = f->q + j * ENDS, *v = f->qd + j * ENDS;
        double w0 = f->work[0][j], w1 = f->work[1][j], w2 = f->work[2][j], w3 = f->work[3][j];
        for (int t = 0; t < intervals; t++)
            e[t] += a0[t] * (w0 * q[t] + w1 * v[t]) + a1[t] * (w2 * q[t] + w3 * v[t]);
    }
    run->ledger.input_j += sum(e, intervals);
    thud_ledger_mark(run);
}

static enum thud_status rows(struct thud_run *run, struct thud_free_vibration *f, int intervals, struct thud_error *err)
{
    long base = run->state.grid;
    const struct thud_ledger before = run->ledger; /* goes on with the rows, and then by the whole block */
    enum thud_status status = THUD_OK;
    for (int t = 0; t < intervals && status == THUD_OK; t++) {
        run->state.grid = base + t;
        start_interval(f, t);
        for (int piece = 0; piece < f->pieces && status == THUD_OK; piece++) {
            thud_free_vibration_series(run, f, piece);
            status = thud_history_segment(run, 1, false, err);
            thud_ledger_segment(run, 1);
            thud_segment_state(&run->seg, f->n, 1, f->now, f->now_rate);
        }
    }
    run->state.grid = base;
    run->state.offset_s = 0;
    run->ledger = before;
    return status;
}

static bool may_fly(const struct thud_run *run)
{
    if (run->state.offset_s != 0)
        return false;
    for (int c = 0; c < run->state.model->ncontacts; c++)
        if (run->state.contact[c].mode != THUD_OPEN)
            return false;
    return true;
}

static void commit(struct thud_run *run, const struct thud_free_vibration *f, int intervals)
{
    for (int j = 0; j < f->n; j++) {
        run->state.q[j] = f->q[j * ENDS + intervals];
        run->state.qd[j] = f->qd[j * ENDS + intervals];
    }
    run->state.grid += intervals;
    thud_contact_moved(&run->state);
    run->work.samples_fast += intervals;
}

enum thud_status thud_free_vibration_go(struct thud_run *run, int *passed, struct thud_error *err)
{
    struct thud_free_vibration *f = run->free_vibration;
    *passed = 0;
    long left = (long)floor(run->state.end_s / run->state.grid_dt_s * (1 + THUD_TOL_TIME)) - run->state.grid;
    if (!may_fly(run) || left <= 0)
        return THUD_OK;
    if (run->early_end) {
        long jumped = thud_early_end_jump(run->early_end, run);
        *passed = jumped > 0;
        run->work.samples_jumped += jumped;
        if (jumped > 0)
            return THUD_OK;
    }
    if (run->early_end || run->early_end_to_fill) {
        int stride = thud_early_end_stride(run->state.grid);
        f->size = f->size < stride ? f->size : stride;
    }
    int tried = left < f->size ? (int)left : f->size;
    march(f, run, tried);
    double ground = largest_ground(f, tried);
    displacements(f, run->state.model, tried + 1);
    margins(f, run, ground, tried);
    int intervals = until_contact(run, f, tried);
    f->size = intervals < tried                         ? SHORT_BLOCK
              : 2 * f->size < THUD_FREE_VIBRATION_BLOCK ? 2 * f->size
                                                        : THUD_FREE_VIBRATION_BLOCK;
    if (intervals == 0)
        return THUD_OK;
    look_for_peaks(f, run, ground, intervals + 1);
    thud_free_vibration_peaks(run, f, intervals);
    if (run->relative_m)
        thud_relative_displacement_block(run, f, intervals);
    if (run->early_end_to_fill)
        thud_early_end_record(run->early_end_to_fill, run, f, intervals);
    enum thud_status status = THUD_OK;
    if (run->options.keep_history) {
        thud_free_vibration_read_deferred(run); /* rows stand at the peaks */
        status = rows(run, f, intervals, err);
    }
    add_energies(f, run, intervals);
    commit(run, f, intervals);
    thud_ledger_watch(run);
    *passed = intervals;
    return status;
}
