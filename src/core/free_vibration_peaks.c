/* Peaks of free flight. Bounds show which interval holds the peak of a floor's value; until a higher one comes or the
 * result is asked for, that it is there is enough, and no series is made. */
#include <math.h>
#include <string.h>

#include "core/free_vibration.h"
#include "core/largest.h"
#include "core/tolerance.h"

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
    size_t n = (size_t)f->n;
    int index = quantity * run->state.model->ndof + run->state.model->structure[structure].first + floor;
    struct thud_deferred_peak *deferred = &f->deferred[index];
    const double offset = run->state.offset_s;
    const long grid = run->state.grid;
    deferred->waits = false;
    run->state.grid = deferred->grid;
    memcpy(f->now, f->kept + (size_t)index * 2 * n, n * sizeof *f->now);
    memcpy(f->now_rate, f->kept + ((size_t)index * 2 + 1) * n, n * sizeof *f->now_rate);
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
    double *q = f->kept + (size_t)index * 2 * (size_t)f->n;
    for (int j = 0; j < f->n; j++) {
        q[j] = f->q[j * ENDS + t];
        q[f->n + j] = f->qd[j * ENDS + t];
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

void thud_free_vibration_peaks(struct thud_run *run, struct thud_free_vibration *f, int intervals)
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
