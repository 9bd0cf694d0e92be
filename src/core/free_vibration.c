/* Free flight over whole intervals of the ground motion by the exact 2x2 recurrence of every mode (Nigam and Jennings
 * 1969), a block of intervals at a time. Bounds show in which intervals neither a contact nor a new peak is possible;
 * only the others are looked at as power series. The motion itself is the recurrence's in any case, so that gaps
 * that do not close change nothing. */
#include "core/free_vibration.h"

#include <math.h>
#include <string.h>

#include "core/double_pair.h"
#include "core/early_end.h"
#include "core/largest.h"
#include "core/poly.h"
#include "core/relative_displacement.h"
#include "core/tolerance.h"

enum { ENDS = THUD_FREE_VIBRATION_ENDS, SHORT_BLOCK = 8 };

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

void thud_free_vibration_series(struct thud_run *run, struct thud_free_vibration *f, int piece)
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
