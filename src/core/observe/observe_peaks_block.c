/* Peaks of a block of free vibration. Bounds show in which intervals the peak of a floor's value x can lie: inside one,
 *
 *     |x| <= max(|x_0|, |x_1|) + margin           by a bound of its second derivative,
 *     |x| <= max |cubic| + its margin              by a bound of its fourth: the cubic through values and rates at both ends
 *
 * Of the intervals that are left the power series is made, and the peak read from it.
 *
 *     row       one quantity of one floor: its values at the ends of the intervals
 *     upper     bound of a row inside an interval; 0: it need not be read
 *     due       rows to be read in the interval at hand */
#include <math.h>
#include <string.h>

#include "base/largest.h"
#include "core/motion/free_vibration.h"
#include "core/numerics/tolerance.h"
#include "core/numerics/vec.h"
#include "core/observe/observe_peaks_parts.h"
#include "core/observe/observe_sums.h"

enum { ENDS = THUD_FREE_VIBRATION_ENDS };

/* What each mode of a structure can come to at the ends of a block by its largest speed there: displacement, velocity
 * and acceleration, rows of peaks->modal. */
static void bound_modes(struct thud_peaks *peaks, const struct thud_model *m, const struct thud_free_vibration *f,
                        const struct thud_model_structure *p)
{
    const double *speed = f->speed + p->first_mode;
    for (int j = 0; j < p->modes; j++) {
        const double w = m->omega[p->first_mode + j], z = m->dashpot[p->first_mode + j];
        double *out = peaks->modal + j;
        out[THUD_FLOOR_DISPLACEMENT * peaks->stride] = speed[j] / w + fabs(f->shift[p->first_mode + j]);
        out[THUD_FLOOR_VELOCITY * peaks->stride] =
            f->yields < 0 ? speed[j] : thud_largest_size(f->qd + (p->first_mode + j) * ENDS, f->ends);
        out[THUD_FLOOR_ACCELERATION * peaks->stride] = sqrt(w * w + z * z) * speed[j];
    }
}

/* What one quantity of the floors can come to inside the intervals, out (stride), two at a time: by the modes, and by how
 * far a value may lie above its ends. Where damping couples modes that bound has its price for rates: the change of a
 * velocity from the nearest end, and an acceleration, are at most the floor's norm over the modes times their size (Cauchy
 * and Schwarz). */
static void bound_floors(const struct thud_peaks *peaks, const struct thud_model *m, struct thud_free_vibration *f,
                         int structure, int quantity, double *out)
{
    const struct thud_model_structure *p = &m->structure[structure];
    const bool drift = quantity == THUD_FLOOR_DRIFT, rate = !drift && quantity != THUD_FLOOR_DISPLACEMENT,
               by_modes = !p->damping || quantity != THUD_FLOOR_ACCELERATION;
    const int stride = peaks->stride;
    const double *shape = peaks->shape + ((drift ? m->nshapes : 0) + p->first_shape) * stride,
                 *modes = peaks->modal + (drift ? THUD_FLOOR_DISPLACEMENT : quantity) * stride,
                 *norm = peaks->per_speed + THUD_FLOOR_VELOCITY * m->ndof + p->first;
    const double size = p->damping && rate ? thud_free_vibration_size(f, m, structure, quantity) : 0,
                 margin = p->damping && rate ? 0 : thud_free_vibration_margin(f, m, structure, quantity);
    for (int i = 0; i < p->dofs; i += 2) { /* rows are long enough */
        thud_vec2 sum = margin + size * thud_vec2_some(norm + i, i + 1 == p->dofs);
        for (int j = 0; j < p->modes && by_modes; j++)
            sum += modes[j] * thud_vec2_abs(thud_vec2_at(shape + j * stride + i));
        thud_vec2_put(sum, out + i);
    }
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

/* Intervals with an end at `near` or above, in order; how many. They are few. */
static int intervals_near(const double *x, int intervals, double near, int *list)
{
    enum { GROUP = 16 };
    int count = 0;
    for (int first = 0; first < intervals; first += GROUP) {
        const int end = first + GROUP < intervals ? first + GROUP : intervals;
        if (thud_largest_size(x + first, end - first + 1) < near)
            continue;
        for (int t = first; t < end; t++) {
            list[count] = t;
            count += (fabs(x[t]) >= near) | (fabs(x[t + 1]) >= near);
        }
    }
    return count;
}

/* Rate of a sum at an end of the intervals; 0 of one that has a part of rates itself. */
static double sum_rate(const struct thud_free_vibration *f, const struct thud_model *m, const struct thud_sum *sum,
                       int t)
{
    const struct thud_model_structure *p = &m->structure[sum->structure];
    double rate = 0;
    for (int j = 0; j < p->modes && !sum->rate; j++)
        rate += sum->row[j] * f->qd[(p->first_mode + j) * THUD_FREE_VIBRATION_ENDS + t];
    return sum->by_row * rate;
}

/* Rate of a row's value at end t of an interval whose ground acceleration there is `ground`. */
static double rate_at(const struct thud_model *m, struct thud_free_vibration *f, const struct thud_peak_row *row, int t,
                      double ground)
{
    return row->sum ? sum_rate(f, m, row->sum, t)
                    : thud_free_vibration_rate(f, m, row->structure, row->floor, row->quantity, t, ground);
}

/* Bound of the difference of a row's value from the cubic; of a sum whose rate is not known, from its ends. */
static double cubic_margin(const struct thud_model *m, struct thud_free_vibration *f, const struct thud_peak_row *row)
{
    const double square = f->dt_s * f->dt_s,
                 fourth = row->sum ? fabs(row->sum->by_row) *
                                         thud_free_vibration_bend(f, m, row->structure, row->sum->row, 4)
                                   : thud_free_vibration_floor_bend(f, m, row->structure, row->quantity, 4);
    return row->sum && row->sum->rate ? row->margin : square * square / 384 * fourth;
}

int thud_peak_row_intervals(const struct thud_model *m, struct thud_free_vibration *f, const struct thud_peak_row *row,
                            int intervals, double *upper, int *list)
{
    const double *x = row->x;
    double most = thud_largest_size(x, intervals + 1);
    if (most + row->margin <= row->peak->value)
        return 0;
    double limit = thud_larger(row->peak->value, most) * (1 - THUD_TOL_PEAK_BOUND), rate[2] = {0};
    int near = intervals_near(x, intervals, limit - row->margin, list), count = 0;
    const double margin = near > 0 ? cubic_margin(m, f, row) : 0;
    memset(upper, 0, (size_t)intervals * sizeof *upper);
    for (int i = 0; i < near; i++) {
        const int t = list[i];
        const bool follows = i > 0 && list[i - 1] == t - 1 && f->after[t - 1] == f->ground[t]; /* a record may jump */
        rate[0] = follows ? rate[1] : rate_at(m, f, row, t, f->ground[t]);
        rate[1] = rate_at(m, f, row, t + 1, f->after[t]);
        double cubic = cubic_peak(x[t], x[t + 1], f->dt_s * rate[0], f->dt_s * rate[1]);
        upper[t] = (cubic + margin) * (1 + THUD_TOL_PEAK_BOUND);
        limit = thud_larger(limit, (cubic - margin) * (1 - THUD_TOL_PEAK_BOUND));
    }
    for (int i = 0; i < near; i++) {
        const int t = list[i];
        if (upper[t] < limit || upper[t] <= row->peak->value)
            upper[t] = 0;
        else
            list[count++] = t;
    }
    return count;
}

/* Peaks of the rows of one structure that are due in interval t. */
static void read_interval(struct thud_peaks *peaks, const struct thud_state *state, struct thud_free_vibration *f,
                          int structure, const int *due, int count, int t)
{
    for (int piece = 0; piece < f->pieces; piece++) {
        const struct thud_segment *seg = thud_free_vibration_series(f, state, structure, t, piece);
        thud_peaks_forget_series(peaks, &state->model->structure[structure]);
        for (int i = 0; i < count; i++)
            thud_peaks_read_floor(peaks, state->model, seg, structure, peaks->row[due[i]].floor,
                                  peaks->row[due[i]].quantity, 1);
    }
}

/* Rows of one structure that are to be read in some interval, with their bounds; how many. due[t]: one in interval t. */
static int find_rows(struct thud_peaks *peaks, const struct thud_state *state, struct thud_free_vibration *f,
                     int structure, int intervals, bool *due)
{
    const struct thud_model *m = state->model;
    const struct thud_model_structure *p = &m->structure[structure];
    int rows = 0, list[THUD_FREE_VIBRATION_BLOCK];
    for (int x = 0; x < (p->drifts ? THUD_FLOOR_QUANTITIES : THUD_FLOOR_DRIFT); x++) {
        bound_floors(peaks, m, f, structure, x, peaks->value);
        for (int i = 0; i < (x == THUD_FLOOR_DISPLACEMENT ? p->dofs : p->n); i++) {
            struct thud_peak *peak = thud_floor_peak(peaks->result, structure, i, x);
            if (peaks->value[i] <= peak->value)
                continue;
            const double margin = thud_free_vibration_margin(f, m, structure, x);
            thud_free_vibration_values(f, m, structure, x);
            struct thud_peak_row *row = &peaks->row[rows];
            double *upper = peaks->upper + rows * THUD_FREE_VIBRATION_BLOCK;
            *row = (struct thud_peak_row){structure, i,      x,   f->value[x] + (size_t)(p->first + i) * ENDS,
                                          peak,      margin, NULL};
            int count = thud_peak_row_intervals(m, f, row, intervals, upper, list);
            for (int k = 0; k < count; k++)
                due[list[k]] = true;
            rows += count > 0;
        }
    }
    return rows;
}

/* Interval by interval, so that one series serves all rows of the structure. */
static void structure_rows(struct thud_peaks *peaks, const struct thud_state *state, struct thud_free_vibration *f,
                           int structure, int intervals)
{
    bool due[THUD_FREE_VIBRATION_BLOCK] = {false};
    const int rows = find_rows(peaks, state, f, structure, intervals, due);
    for (int t = 0; t < intervals && rows > 0; t++) {
        int count = 0;
        for (int i = 0; i < rows && due[t]; i++)
            if (peaks->upper[i * THUD_FREE_VIBRATION_BLOCK + t] > peaks->row[i].peak->value)
                peaks->due[count++] = i;
        if (count > 0)
            read_interval(peaks, state, f, structure, peaks->due, count, t);
    }
}

enum thud_status thud_peaks_block(void *own, const struct thud_state *state, struct thud_free_vibration *f,
                                  int intervals, struct thud_error *err)
{
    struct thud_peaks *peaks = own;
    const struct thud_model *m = state->model;
    (void)err;
    for (int s = 0; s < m->nstructures; s++) {
        bound_modes(peaks, m, f, &m->structure[s]);
        structure_rows(peaks, state, f, s, intervals);
    }
    return THUD_OK;
}
