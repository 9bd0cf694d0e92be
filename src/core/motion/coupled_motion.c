#include "core/motion/coupled_motion.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "base/largest.h"
#include "core/numerics/quadrature.h"
#include "core/numerics/vec.h"

enum { POINTS = THUD_QUADRATURE_POINTS, TERMS = 24, ENDS = THUD_FREE_VIBRATION_ENDS }; /* 2^24/24! is below rounding */
enum { LOOKS_APART = 4 }; /* intervals from one look at what ends a block to the next: it costs half of one */

/* Longest part of the interval that the series are made of, by the fastest rate in it: each doubling adds rounding. */
static const double longest_rad = 2;

/* out (rows x columns, an even number) += scale a b, where a is (rows x inner), or (inner x rows) if turned. */
static void add_product(int rows, int inner, int columns, double scale, const double *a, bool turned, const double *b,
                        double *out)
{
    for (int i = 0; i < rows; i++)
        for (int k = 0; k < inner; k++) {
            double x = scale * (turned ? a[k * rows + i] : a[i * inner + k]);
            for (int j = 0; j < columns && x != 0; j += 2)
                thud_vec2_put(thud_vec2_at(out + i * columns + j) + x * thud_vec2_at(b + k * columns + j),
                              out + i * columns + j);
        }
}

/* out (n, an even number) += factor x. */
static void add(int n, double factor, const double *x, double *out)
{
    for (int i = 0; i < n; i += 2)
        thud_vec2_put(thud_vec2_at(out + i) + factor * thud_vec2_at(x + i), out + i);
}

/* What is made of one part of the interval, and doubled. */
struct part {
    double h_s, dt_s;
    double *damping; /* (n x n) D */
    double *rate;    /* (size x size) A */
    double *flow;    /* (size x size) */
    double *rates;   /* (POINTS x n x size) q' at the quadrature points, by the x at the start */
    double *temp;    /* (2 x size x size) */
};

static bool dashpot_acts(const struct thud_model *m, int link, int system)
{
    const struct thud_model_link *p = &m->link[link];
    return p->contact < 0 && p->damping_nspm != 0 && m->structure[p->structure].system == system;
}

static enum thud_status allocate(struct thud_coupled_motion *c, struct part *part, int links,
                                 struct thud_blocks *memory, struct thud_error *err)
{
    const size_t n = (size_t)c->n, size = (size_t)c->size, all = size * size;
    enum thud_status status =
        THUD_LAY_IN(memory, err, THUD_PIECE(c->step, 2 * n * size), THUD_PIECE(c->loss, (size_t)(1 + links) * all),
                    THUD_PIECE(c->now, 2 * size), THUD_PIECE(c->input, all), THUD_PIECE(c->product, all),
                    THUD_PIECE(c->link, links));
    if (status != THUD_OK)
        return status;
    c->work[0] = c->input + 2 * n * size;
    c->work[1] = c->work[0] + size;
    return THUD_LAY(err, THUD_PIECE(part->flow, all), THUD_PIECE(part->rate, all), THUD_PIECE(part->temp, 2 * all),
                    THUD_PIECE(part->rates, POINTS * n * size), THUD_PIECE(part->damping, n * n));
}

/* D and A. */
static void fill_rate(const struct thud_coupled_motion *c, struct part *part, const struct thud_model *m,
                      const struct thud_model_structure *p)
{
    const int n = c->n, size = c->size, first = c->first_mode;
    for (int i = 0; i < n; i++) {
        double *row = part->rate + (n + i) * size, *damping = part->damping + i * n;
        for (int j = 0; j < n && p->damping; j++)
            damping[j] = p->damping[i * n + j];
        damping[i] += m->dashpot[first + i];
        for (int j = 0; j < n; j++)
            row[n + j] = -damping[j];
        part->rate[i * size + n + i] = 1;
        for (int j = 0; j < n && c->soft; j++)
            row[j] = -c->soft_npm * c->soft[i] * c->soft[j];
        row[i] -= m->spring[first + i];
        row[2 * n] = -m->gamma[first + i];
    }
    part->rate[2 * n * size + 2 * n + 1] = 1 / part->dt_s;
}

/* The flow, sum of (A h)^k/k!, and the rates on the way, sums of s^k (A h)^k/k!. */
static void fill_flow(const struct thud_coupled_motion *c, struct part *part)
{
    const int n = c->n, size = c->size, all = size * size;
    double *term = part->temp, *next = term + all, power[POINTS];
    for (int i = 0; i < size; i++)
        term[i * size + i] = 1;
    for (int i = 0; i < POINTS; i++)
        power[i] = 1;
    for (int k = 0; k < TERMS; k++) {
        add(all, 1, term, part->flow);
        for (int i = 0; i < POINTS; power[i] *= thud_quadrature_node[i], i++)
            add(n * size, power[i], term + n * size, part->rates + i * n * size);
        memset(next, 0, (size_t)all * sizeof *next);
        add_product(size, size, size, part->h_s / (k + 1), part->rate, false, term, next);
        memcpy(term, next, (size_t)all * sizeof *term);
    }
}

/* L, of it the links' parts, and W of the part, by quadrature. */
static void add_forms(struct thud_coupled_motion *c, struct part *part, const struct thud_model *m)
{
    const int n = c->n, size = c->size;
    const double *gamma = m->gamma + c->first_mode;
    for (int i = 0; i < POINTS; i++) {
        const double *rate = part->rates + i * n * size, weight = thud_quadrature_weight[i] * part->h_s;
        memset(part->temp, 0, (size_t)n * (size_t)size * sizeof *part->temp);
        add_product(n, n, size, weight, part->damping, false, rate, part->temp);
        add_product(size, n, size, 1, rate, true, part->temp, c->loss);
        for (int l = 0; l < c->links; l++) {
            const struct thud_model_link *link = &m->link[c->link[l]];
            memset(part->temp, 0, (size_t)size * sizeof *part->temp);
            add_product(1, n, size, 1, link->row, false, rate, part->temp);
            add_product(size, 1, size, weight * link->damping_nspm, part->temp, false, part->temp,
                        c->loss + (l + 1) * size * size);
        }
        add_product(1, n, size, -weight, gamma, false, rate, c->work[0]);
        add_product(1, n, size, -weight * thud_quadrature_node[i] * part->h_s / part->dt_s, gamma, false, rate,
                    c->work[1]);
    }
}

static void double_part(struct thud_coupled_motion *c, struct part *part)
{
    const int size = c->size;
    const size_t bytes = (size_t)size * (size_t)size * sizeof(double);
    double *flow = part->flow, *temp = part->temp, *row = c->now;
    for (int l = 0; l <= c->links; l++) {
        double *loss = c->loss + l * size * size;
        memset(temp, 0, bytes);
        add_product(size, size, size, 1, loss, false, flow, temp);
        add_product(size, size, size, 1, flow, true, temp, loss);
    }
    /* in the second half the ground acceleration is (a + b h/dt) + b t/dt */
    memset(row, 0, 2 * (size_t)size * sizeof *row);
    add_product(2, size, size, 1, c->work[0], false, flow, row);
    for (int j = 0; j < size; j++) {
        c->work[0][j] += row[j];
        c->work[1][j] += row[size + j] + part->h_s / part->dt_s * row[j];
    }
    memset(temp, 0, bytes);
    add_product(size, size, size, 1, flow, false, flow, temp);
    memcpy(flow, temp, bytes);
    part->h_s *= 2;
}

/* A form by the ground accelerations at both ends in place of the first one and the change, its upper part alone. */
static void finish_form(int n, double *form)
{
    const int size = 2 * n + 2;
    for (int i = 0; i < size; i++)
        form[i * size + 2 * n] -= form[i * size + 2 * n + 1];
    for (int i = 0; i < size; i++)
        form[2 * n * size + i] -= form[(2 * n + 1) * size + i];
    for (int i = 0; i < size; i++)
        for (int j = i + 1; j < size; j++)
            form[i * size + j] += form[j * size + i];
}

enum thud_status thud_coupled_motion_init(struct thud_coupled_motion *motion, const struct thud_state *state,
                                          int system, int mode, int storey, struct thud_blocks *memory,
                                          struct thud_error *err)
{
    const struct thud_model *m = state->model;
    const struct thud_model_structure *p = &m->structure[m->system[system]];
    const int n = mode < 0 ? p->modes : 1;
    struct part part = {.dt_s = state->grid_dt_s};
    *motion = (struct thud_coupled_motion){.n = n, .size = 2 * n + 2, .first_mode = mode < 0 ? p->first_mode : mode};
    if (storey >= 0) {
        motion->soft = m->jacobian + (m->ncontacts + storey) * m->nmodes + p->first_mode;
        motion->soft_npm = (m->storey[storey].hardening - 1) * m->storey[storey].stiffness_npm;
    }
    int links = 0;
    for (int i = 0; mode < 0 && i < m->nlinks; i++)
        links += dashpot_acts(m, i, system);
    enum thud_status status = allocate(motion, &part, links, memory, err);
    if (status != THUD_OK)
        return status;
    for (int i = 0; motion->links < links; i++)
        if (dashpot_acts(m, i, system))
            motion->link[motion->links++] = i;
    int doublings = 0;
    const double rate = mode < 0 ? state->fastest_radps : thud_larger(m->omega[mode], m->dashpot[mode]);
    while (ldexp(rate * part.dt_s, -doublings) > longest_rad)
        doublings++;
    part.h_s = ldexp(part.dt_s, -doublings);
    fill_rate(motion, &part, m, p);
    fill_flow(motion, &part);
    add_forms(motion, &part, m);
    for (int i = 0; i < doublings; i++)
        double_part(motion, &part);
    for (int i = 0; i < 2 * n; i++)
        for (int j = 0; j < motion->size; j++)
            motion->step[j * 2 * n + i] = part.flow[i * motion->size + j];
    memset(motion->now, 0, 2 * (size_t)motion->size * sizeof(double));
    for (int l = 0; l <= motion->links; l++)
        finish_form(n, motion->loss + l * motion->size * motion->size);
    finish_form(n, motion->input);
    free(part.flow);
    return THUD_OK;
}

/* So many pairs of the next q and q', out, by their columns of the propagator. */
static inline void some_pairs(const struct thud_coupled_motion *c, int first, const int pairs, double *out)
{
    const double *column = c->step + 2 * first;
    thud_vec2 sum[8] = {0};
    for (int k = 0; k < c->size; k++, column += 2 * c->n)
        for (int i = 0; i < pairs; i++)
            sum[i] += c->now[k] * ((const thud_vec2_aligned *)column)[i];
    for (int i = 0; i < pairs; i++)
        thud_vec2_put(sum[i], out + 2 * (first + i));
}

/* One by one: pairs would have to wait for what has just been stored alone. */
static bool stops(const struct thud_coupled_stop *stop, int n, const double *now)
{
    double value = 0;
    for (int j = 0; j < n; j++)
        value += stop->row[j] * now[stop->rates ? n + j : j];
    return value < stop->low || value > stop->high;
}

int thud_coupled_motion_advance(struct thud_coupled_motion *c, double *q, double *qd, const double *s, double *x,
                                const double *ground, const double *after, int intervals, struct thud_coupled_stop stop)
{
    const int n = c->n, row = c->first_mode * ENDS, apart = stop.row ? LOOKS_APART : intervals;
    double *now = c->now, *next = now + c->size;
    s += c->first_mode;
    for (int j = 0; j < n; j++) {
        now[j] = x[row + j * ENDS] = q[row + j * ENDS] - s[j];
        now[n + j] = qd[row + j * ENDS];
    }
    for (int t = 0, end = apart; t < intervals; end = t + apart) {
        for (; t < end && t < intervals; t++) {
            int first = 0;
            now[2 * n] = ground[t];
            now[2 * n + 1] = after[t] - ground[t];
            for (; first + 8 <= n; first += 8)
                some_pairs(c, first, 8, next);
            for (; first + 6 <= n; first += 6)
                some_pairs(c, first, 6, next);
            for (; first + 5 <= n; first += 5)
                some_pairs(c, first, 5, next);
            for (; first < n; first++)
                some_pairs(c, first, 1, next);
            for (int j = 0, at = row + t + 1; j < n; j++, at += ENDS) {
                q[at] = next[j] + s[j];
                qd[at] = now[n + j] = next[n + j];
                now[j] = x[at] = q[at] - s[j]; /* as it were if the block began here */
            }
        }
        if (stop.row && stops(&stop, n, now))
            return t;
    }
    return intervals;
}

void thud_coupled_motion_sum(struct thud_coupled_motion *c, const double *x, const double *qd, const double *ground,
                             const double *after, int intervals)
{
    const int n = c->n, size = c->size, first = c->first_mode;
    for (int i = 0; i < size; i++) {
        double *out = c->product + i * size;
        const int rate = i < n ? 0 : i - n; /* of the rows behind q */
        const double *a = i < n        ? x + (first + i) * ENDS
                          : i < 2 * n  ? qd + (first + rate) * ENDS
                          : i == 2 * n ? ground
                                       : after;
        if (i < n)
            thud_dots(intervals, a, a, ENDS, n - i, out + i);
        if (i < 2 * n)
            thud_dots(intervals, a, qd + (first + rate) * ENDS, ENDS, n - rate, out + n + rate);
        out[2 * n] = thud_dot(intervals, a, ground);
        out[2 * n + 1] = thud_dot(intervals, a, after);
    }
}

/* A form in these sums. */
static double work_of(const struct thud_coupled_motion *c, const double *form)
{
    double sum = 0;
    for (int i = 0; i < c->size; i++)
        sum += thud_dot(c->size - i, form + i * c->size + i, c->product + i * c->size + i);
    return sum;
}

double thud_coupled_motion_link_loss(const struct thud_coupled_motion *c, int link)
{
    int l = 0;
    while (l < c->links && c->link[l] != link)
        l++;
    return l < c->links ? work_of(c, c->loss + (l + 1) * c->size * c->size) : 0;
}

void thud_coupled_motion_work(const struct thud_coupled_motion *c, double *input_j, double *viscous_j)
{
    *input_j += work_of(c, c->input);
    *viscous_j += work_of(c, c->loss);
}
