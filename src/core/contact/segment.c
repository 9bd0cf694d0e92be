/* Motion of the model as power series in time: exact to rounding for constant or polynomial forces, and for linear
 * contact (thud-methods(7), "Power series").
 *
 * Glossary, for a segment of length h from t0 with s = (t - t0)/h; k is an order of the series, j a mode, c a row.
 *
 *     q_jk         seg->q[k * nmodes + j]: coefficient of s^k of modal coordinate j, m kg^1/2
 *     F_ck         seg->force[k * nrows + c]: of the force of row c, N; 0 from order seg->loaded on
 *     a_0, a_1     seg->a0, a1: ground acceleration at t0, and its change over h, m/s^2
 *     d_ck         notes->indentation: of the indentation (drift) of row c, m
 *     load factor  -h^2/((k + 1)(k + 2)): what a load of order k adds to q_j,k+2
 *
 * The recurrence is eq. (6) there, q_k+2 = load factor * (Omega^2 q_k + D (k + 1)/h q_k+1 + gamma a_k + sum_c g_c F_ck),
 * order by order (next_order); the forces are given, or follow from the orders below by eq. (7) (linear_forces). */
#include <assert.h>
#include <math.h>
#include <string.h>

#include "base/arena.h"
#include "base/largest.h"
#include "core/contact/segment.h"
#include "core/numerics/tolerance.h"
#include "core/numerics/vec.h"

/* No indentation has been read yet. */
static void forget(const struct thud_segment *seg, int nrows)
{
    seg->notes->quiet = false;
    for (int c = 0; c < nrows; c++) {
        seg->notes->cached[c] = -1;
        seg->notes->released[c] = seg->notes->parted[c] = INFINITY;
        seg->notes->begun[c] = -1;
    }
}

enum thud_status thud_segment_init(struct thud_segment *seg, const struct thud_state *state, struct thud_error *err)
{
    const struct thud_model *model = state->model;
    const size_t n = (size_t)model->nmodes, nc = (size_t)model->nrows, ns = (size_t)model->nstructures,
                 terms = THUD_SEGMENT_TERMS;
    struct thud_segment_notes notes;
    *seg = (struct thud_segment){0};
    const enum thud_status status =
        THUD_LAY_IN(state->memory, err, THUD_PIECE(seg->q, terms * n), THUD_PIECE(notes.bound, 2 * n),
                    THUD_PIECE(seg->force, terms * nc), THUD_PIECE(notes.indentation, terms * nc),
                    THUD_PIECE(notes.floors, ns), THUD_PIECE(notes.drifts, ns), THUD_PIECE(notes.thirds, ns),
                    THUD_PIECE(notes.released, nc), THUD_PIECE(notes.parted, nc), THUD_PIECE(notes.begun, nc),
                    THUD_PIECE(notes.end, 2 * n), THUD_PIECE(notes.falling, terms), THUD_PIECE(seg->row, nc),
                    THUD_PIECE(notes.cached, nc), THUD_PIECE(seg->notes, 1));
    if (status == THUD_OK) {
        *seg->notes = notes;
        forget(seg, model->nrows);
        for (int k = 2; k < THUD_SEGMENT_TERMS; k++)
            notes.falling[k] = (thud_vec2){1, 1} * (k * (k - 1) * (k - 2));
    }
    return status;
}

/* Bounds of two modes, or one: sums of the sizes of their terms; and their state at s, by Horner's scheme. */
static inline void read_modes(const struct thud_segment *seg, int nmodes, double s, int j, const bool single)
{
    const struct thud_segment_notes *notes = seg->notes;
    thud_vec2 x = {0, 0}, v = {0, 0}, sum = {0, 0}, third = {0, 0};
    const double *q = seg->q + (seg->terms - 1) * nmodes + j;
    for (int k = seg->terms - 1; k >= 2; k--, q -= nmodes) {
        const thud_vec2 term = thud_vec2_some(q, single), size = thud_vec2_abs(term);
        v = v * s + x;
        x = x * s + term;
        sum += size;
        third += notes->falling[k] * size;
    }
    for (int k = 1; k >= 0; k--, q -= nmodes) {
        v = v * s + x;
        x = x * s + thud_vec2_some(q, single);
    }
    thud_vec2_put_some(sum, notes->bound + j, single);
    thud_vec2_put_some(third, notes->bound + nmodes + j, single);
    thud_vec2_put_some(x, notes->end + j, single);
    thud_vec2_put_some(v / seg->h_s, notes->end + nmodes + j, single);
}

void thud_segment_bounds(const struct thud_segment *seg, const struct thud_model *model, double s)
{
    const int n = model->nmodes;
    for (int j = 0; j + 2 <= n; j += 2)
        read_modes(seg, n, s, j, false);
    if (n % 2)
        read_modes(seg, n, s, n - 1, true);
    seg->notes->end_s = s;
    for (int i = 0; i < model->nstructures; i++) {
        const struct thud_model_structure *p = &model->structure[i];
        const double *bound = seg->notes->bound + p->first_mode;
        seg->notes->floors[i] = thud_dot(p->modes, model->mode_max + p->first_mode, bound);
        if (model->nstoreys > 0)
            seg->notes->drifts[i] = thud_dot(p->modes, model->mode_max + n + p->first_mode, bound);
        seg->notes->thirds[i] = thud_dot(p->modes, model->mode_max + p->first_mode, bound + n);
    }
}

bool thud_segment_has_any(const struct thud_state *state, const struct thud_segment *seg, int c)
{
    const double *force = seg->force + c;
    for (int k = 0; k < seg->terms; k++)
        if (force[k * state->model->nrows] != 0)
            return true;
    return false;
}

int thud_segment_terms(double angle, double least, int fewest)
{
    double power = 1, factorial = 1; /* apart: a division in each term would wait for the one before */
    int k = 1;
    for (; k < THUD_SEGMENT_TERMS && (power > least * factorial || k < fewest); k++) {
        power *= angle;
        factorial *= k;
    }
    return k;
}

double thud_segment_rate(const struct thud_state *state)
{
    const struct thud_model *m = state->model;
    double stiffer = state->fastest_radps * state->fastest_radps, softer = 0, rate = 0;
    for (int c = 0; c < m->nrows && !thud_state_is_free(state); c++)
        if (thud_row_by_branch(state, c)) {
            const double k = thud_row_branch(state, c)->k_npm * m->delassus[c * m->nrows + c];
            *(k > 0 ? &stiffer : &softer) += fabs(k);
            rate += fabs(thud_row_branch(state, c)->c_nspm) * m->delassus[c * m->nrows + c];
        }
    /* l^2 = c l + k: of k = A - B, both of them stiffnesses, the size is at most the larger one's */
    return 0.5 * (rate + sqrt(rate * rate + 4 * thud_larger(stiffer, softer)));
}

/* Forces of order 0 of elastic storeys with a plastic drift: constant. */
static void constant_forces(const struct thud_state *state, struct thud_segment *seg)
{
    const struct thud_model *m = state->model;
    for (int k = 0; k < m->nstoreys && state->nshifted > 0; k++)
        if (state->storey[k].direction == 0 || !state->locates)
            seg->force[m->ncontacts + k] = state->storey[k].branch.f0_n;
    seg->loaded = state->nshifted > 0;
}

void thud_segment_ground(const struct thud_state *state, struct thud_segment *seg, long grid, double offset_s,
                         double h_s)
{
    double a0, a1;
    thud_state_ground(state, grid, &a0, &a1);
    double slope = (a1 - a0) / state->grid_dt_s;
    seg->start_s = (double)grid * state->grid_dt_s + offset_s;
    seg->h_s = h_s;
    seg->a0 = a0 + slope * offset_s;
    seg->a1 = slope * h_s;
}

int thud_segment_all_terms(const struct thud_state *state, double h_s)
{
    return thud_segment_terms(thud_segment_rate(state) * h_s, THUD_TOL_SERIES, THUD_SEGMENT_TERMS_LEAST);
}

/* Sets the forces to 0 and lists the rows that can have one: those of the last segment, as only rows that acted at its
 * start have any, or all after a step of a stepping method. */
static void clear_forces(const struct thud_state *state, struct thud_segment *seg)
{
    const struct thud_model *m = state->model;
    if (seg->interpolates)
        memset(seg->force, 0, THUD_SEGMENT_TERMS * (size_t)m->nrows * sizeof(double));
    for (int i = 0; i < seg->rows && !seg->interpolates; i++)
        for (int k = 0; k == 0 || k < seg->loaded; k++) /* a constant one stands where no order counts any more */
            seg->force[k * m->nrows + seg->row[i]] = 0;
    seg->loaded = 0;
    seg->rows = 0;
    for (int c = 0; c < m->nrows; c++)
        if (thud_row_acts(state, c) || thud_row_branch(state, c)->f0_n != 0)
            seg->row[seg->rows++] = c;
}

void thud_segment_begin(const struct thud_state *state, struct thud_segment *seg, double h_s, int terms)
{
    assert(h_s > 0 && isfinite(h_s));
    clear_forces(state, seg);
    thud_segment_ground(state, seg, state->grid, state->offset_s, h_s);
    seg->terms = terms;
    seg->interpolates = false;
    seg->start = seg->end = NULL;
    seg->steps = 1;
    seg->nodes = NULL;
    constant_forces(state, seg);
    forget(seg, state->model->nrows);
}

/* Modes of some systems that stand one after the other: of one, or of all. */
struct slice {
    int system, systems;
    int mode, modes;
};

/* All systems. */
static struct slice all_of(const struct thud_model *m)
{
    return (struct slice){0, m->nsystems, 0, m->nmodes};
}

/* Orders 0 and 1: displacement, and velocity times h. */
static void first_terms(const struct thud_model *m, struct thud_segment *seg, const struct slice *of, const double *q,
                        const double *qd)
{
    for (int j = of->mode; j < of->mode + of->modes; j++) {
        seg->q[j] = q[j];
        seg->q[m->nmodes + j] = seg->h_s * qd[j];
    }
}

/* -h^2/((k + 1)(k + 2)) */
static double load_factor(const struct thud_segment *seg, int k)
{
    return -seg->h_s * seg->h_s / ((k + 1) * (k + 2));
}

/* Order k of the ground acceleration, a straight line. */
static double ground_term(const struct thud_segment *seg, int k)
{
    return k == 0 ? seg->a0 : k == 1 ? seg->a1 : 0;
}

/* Adds the forces of order k to order k + 2 of the modes, of two rows at a time. */
static void push_rows(const struct thud_model *m, const struct thud_segment *seg, const struct slice *of, int k,
                      double *q2)
{
    const double *force = seg->force + k * m->nrows, by_load = load_factor(seg, k);
    const int end = of->mode + of->modes;
    for (int i = 0; i < seg->rows; i += 2) {
        const int row = seg->row[i], other = seg->row[i + 1 < seg->rows ? i + 1 : i];
        const double by_g = by_load * force[row], by_h = other == row ? 0 : by_load * force[other],
                     *g = m->jacobian + (size_t)row * (size_t)m->nmodes,
                     *h = m->jacobian + (size_t)other * (size_t)m->nmodes;
        int j = of->mode;
        for (; j + 2 <= end; j += 2)
            thud_vec2_put(thud_vec2_at(q2 + j) + (by_g * thud_vec2_at(g + j) + by_h * thud_vec2_at(h + j)), q2 + j);
        if (j < end)
            q2[j] += by_g * g[j] + by_h * h[j];
    }
}

/* The part of damping that couples modes in q2 = by_q1 D q1; D is symmetric. */
static void couple_modes(const struct thud_model *m, const struct slice *of, double by_q1, const double *q1, double *q2)
{
    for (int s = of->system; s < of->system + of->systems; s++) {
        const struct thud_model_structure *p = &m->structure[m->system[s]];
        if (p->damping)
            thud_add_rows(p->modes, p->modes, by_q1, q1 + p->first_mode, p->damping, q2 + p->first_mode);
    }
}

/* Order k + 2 of the modes from orders k and k + 1 and the loads of order k:
 *     (k + 1) (k + 2) q[k + 2] = -h^2 (spring q[k] + load[k]) - h (k + 1) (dashpot q[k + 1] + D q[k + 1]) */
static inline void next_order(const struct thud_model *m, struct thud_segment *seg, const struct slice *of, int k)
{
    const int end = of->mode + of->modes;
    const double *q = seg->q + k * m->nmodes, *q1 = q + m->nmodes, *spring = m->spring, *dashpot = m->dashpot,
                 *gamma = m->gamma;
    const double by_q = load_factor(seg, k), by_q1 = -seg->h_s / (k + 2), ground = by_q * ground_term(seg, k);
    double *q2 = seg->q + (k + 2) * m->nmodes;
    int j = of->mode;
    for (; j + 2 <= end; j += 2)
        thud_vec2_put(by_q * (thud_vec2_at(spring + j) * thud_vec2_at(q + j)) +
                          by_q1 * (thud_vec2_at(dashpot + j) * thud_vec2_at(q1 + j)) + ground * thud_vec2_at(gamma + j),
                      q2 + j);
    if (j < end)
        q2[j] = by_q * (spring[j] * q[j]) + by_q1 * (dashpot[j] * q1[j]) + ground * gamma[j];
    if (m->couples)
        couple_modes(m, of, by_q1, q1, q2);
    if (k < seg->loaded)
        push_rows(m, seg, of, k, q2);
}

/* What the tail of the accelerations counts beside that of the displacements, which says little of a stiff mode's. */
static const double in_accelerations = 1e-4;

double thud_segment_tail(const struct thud_segment *seg, const struct thud_model *model)
{
    double tail = 0;
    for (int s = 0; s < model->nstructures; s++) {
        const struct thud_model_structure *p = &model->structure[s];
        double all = 0, bend = 0, last = 0;
        for (int k = 0; k < seg->terms; k++) {
            double most = thud_largest_size(seg->q + k * model->nmodes + p->first_mode, p->modes);
            all = thud_larger(all, most);
            bend = thud_larger(bend, k * (k - 1) * most);
            last = k + 2 < seg->terms ? 0 : thud_larger(last, most);
        }
        all = thud_smaller(all, bend / (in_accelerations * (seg->terms - 1) * (seg->terms - 2)));
        tail = thud_larger(tail, last == 0 ? 0 : last / all);
    }
    return tail;
}

void thud_segment_trim(struct thud_segment *seg, const struct thud_model *model, double least)
{
    const int n = model->nmodes;
    int terms = seg->loaded + 3 < seg->terms ? seg->loaded + 3 : seg->terms;
    for (int s = 0; s < model->nsystems; s++) {
        const struct thud_model_structure *p = &model->structure[model->system[s]];
        const double *q = seg->q + p->first_mode, most = least * 2 * thud_largest_size(q + 2 * n, p->modes);
        int k = seg->terms;
        while (k > terms && (k - 1) * (k - 2) * thud_largest_size(q + (k - 1) * n, p->modes) <= most)
            k--;
        terms = k > terms ? k : terms;
    }
    seg->terms = terms;
}

enum { DENSE_MOST = 8 }; /* modes of a system whose orders are made in registers */

/* A system's matrices with its rows that act, whose forces are no loads then. */
struct folded {
    int system;                                                               /* -1: none */
    double spring[DENSE_MOST * DENSE_MOST], dashpot[DENSE_MOST * DENSE_MOST]; /* sum k g g^T; D + sum c g g^T */
};

/* Of n modes from `first` on that damping couples, the orders from k + 2 on, where there are no loads, as r = k! q_k over
 * what that factorial is of the first:
 *     r_k+2 = -h^2 Omega^2 r_k - h D r_k+1
 * The two that the next one needs stay in registers, as n is a constant, and sums are short, as each order waits for the
 * one before. folded may be NULL. */
static inline void dense_orders(const struct thud_model *m, const struct thud_segment *seg, int first, int k,
                                const int n, const double *folded, const double *damping)
{
    double *next = seg->q + k * m->nmodes + first, factor = 1.0 / (k + 1), by_r1[DENSE_MOST * DENSE_MOST];
    const double h = seg->h_s;
    thud_vec2 r[DENSE_MOST / 2], r1[DENSE_MOST / 2];
    for (int i = 0; i < n * n; i++)
        by_r1[i] = -h * damping[i];
    for (int i = 0; i < n; i += 2) {
        r[i / 2] = thud_vec2_some(next + i, i + 1 == n);
        r1[i / 2] = (k + 1) * thud_vec2_some(next + m->nmodes + i, i + 1 == n);
    }
    for (next += 2 * m->nmodes; k + 2 < seg->terms; k++, next += m->nmodes) {
        thud_vec2 sum[2][DENSE_MOST / 2] = {0};
        factor /= k + 2;
        for (int i = 0; i < n; i += 2)
            sum[0][i / 2] = thud_vec2_some(m->spring + first + i, i + 1 == n) * r[i / 2];
        for (int j = 0; j < n && folded; j++)
            for (int i = 0; i < n; i += 2)
                sum[0][i / 2] += r[j / 2][j % 2] * thud_vec2_some(folded + j * n + i, i + 1 == n);
        for (int i = 0; i < n; i += 2) {
            sum[0][i / 2] *= -h * h;
            r[i / 2] = r1[i / 2];
        }
        for (int j = 0; j < n; j++)
            for (int i = 0; i < n; i += 2)
                sum[j % 2][i / 2] += r1[j / 2][j % 2] * thud_vec2_some(by_r1 + j * n + i, i + 1 == n);
        for (int i = 0; i < n; i += 2) {
            r1[i / 2] = sum[0][i / 2] + sum[1][i / 2];
            thud_vec2_put_some(factor * r1[i / 2], next + i, i + 1 == n);
        }
    }
}

/* The orders of a slice from k + 2 on where there are no loads, system by system. */
static void unloaded_orders(const struct thud_model *m, struct thud_segment *seg, const struct slice *of, int k,
                            const struct folded *folded)
{
    for (int s = of->system; s < of->system + of->systems; s++) {
        const struct thud_model_structure *p = &m->structure[m->system[s]];
        const struct slice one = {s, 1, p->first_mode, p->modes};
        const double *spring = folded && folded->system == s ? folded->spring : NULL,
                     *damping = spring ? folded->dashpot : p->damping;
        switch (damping ? p->modes : 0) {
#define DENSE(n)                                                                                                       \
    case n:                                                                                                            \
        dense_orders(m, seg, p->first_mode, k, n, spring, damping);                                                    \
        break;
            DENSE(1)
            DENSE(2)
            DENSE(3)
            DENSE(4)
            DENSE(5)
            DENSE(6)
            DENSE(7)
            DENSE(DENSE_MOST)
        default:
            for (int i = k; i + 2 < seg->terms && p->modes > 0; i++)
                next_order(m, seg, &one, i);
        }
    }
}

/* All orders of a slice of the modes from q and q' at t0, under the forces of the segment. */
static inline void series_of(const struct thud_model *m, struct thud_segment *seg, const struct slice *of,
                             const double *q, const double *qd)
{
    const int loaded = seg->loaded > 2 ? seg->loaded : 2, /* orders 0 and 1 have the ground's */
        end = m->couples && loaded < seg->terms - 2 ? loaded : seg->terms - 2;
    first_terms(m, seg, of, q, qd);
    for (int k = 0; k < end; k++)
        next_order(m, seg, of, k);
    if (end < seg->terms - 2)
        unloaded_orders(m, seg, of, end, NULL);
}

void thud_taylor_given(const struct thud_model *model, struct thud_segment *seg, const double *q, const double *qd)
{
    const struct slice all = all_of(model);
    series_of(model, seg, &all, q, qd);
}

void thud_taylor_load(const struct thud_model *model, struct thud_segment *seg, double h_s, int terms,
                      const double *load)
{
    const struct slice all = all_of(model);
    seg->h_s = h_s;
    seg->terms = terms;
    seg->a0 = seg->a1 = 0;
    seg->loaded = 0;
    memset(seg->q, 0, (size_t)seg->terms * (size_t)model->nmodes * sizeof(double));
    for (int j = 0; j < model->nmodes; j++)
        seg->q[2 * model->nmodes + j] = -load_factor(seg, 0) * load[j];
    for (int k = 1; k + 2 < seg->terms; k++)
        next_order(model, seg, &all, k);
}

/* Eq. (7): F_ck = k d_ck + c (k + 1)/h d_c,k+1 (+ f0 for k = 0) of every closed contact with a linear branch. d_ck and
 * d_c,k+1 are left in the notes, where thud_segment_contact would put them. At an event at d = 0 the order 0, and at rest
 * the order 1, are exactly 0: what rounding has left there a stiff spring or a dashpot would make a force of. */
static void linear_forces(const struct thud_state *state, struct thud_segment *seg, int k)
{
    const struct thud_model *m = state->model;
    for (int i = 0; i < seg->rows; i++) {
        const int c = seg->row[i];
        const struct thud_branch *branch = thud_row_branch(state, c);
        const bool at_zero = k == 0 && thud_row_starts_at_zero(state, c);
        double *d = seg->notes->indentation + c * THUD_SEGMENT_TERMS, f = 0;
        if (!thud_row_by_branch(state, c))
            continue;
        if (k == 0) {
            thud_model_gap_pair(m, c, seg->q, m->nmodes, d);
            d[0] = at_zero ? 0 : d[0] - thud_state_clearance(state, c);
            d[1] = at_zero && state->contact[c].suppressed.rate > 0 ? 0 : d[1];
            f = branch->f0_n;
        } else if (k + 1 < seg->terms) {
            d[k + 1] = thud_model_gap_sum(m, c, seg->q + (k + 1) * m->nmodes);
        }
        const double d1 = k + 1 < seg->terms ? d[k + 1] : 0;
        seg->force[k * m->nrows + c] = f + branch->k_npm * d[k] + branch->c_nspm * (k + 1) / seg->h_s * d1;
    }
}

/* Order k of the constraint forces, which keep d'' = 0 of sticking contacts: q2 holds order k + 2 of the modes under all
 * other loads; the forces are those that bring order k + 2 of the indentations to 0 (Delassus system), and q2 takes them. */
static void constraint_forces(const struct thud_state *state, struct thud_segment *seg, int k)
{
    const struct thud_model *m = state->model;
    double *q2 = seg->q + (k + 2) * m->nmodes, *force = state->force_now;
    memset(force, 0, (size_t)m->nrows * sizeof *force);
    thud_contact_constraint_forces(state, q2, force);
    for (int i = 0; i < seg->rows; i++) {
        const int c = seg->row[i];
        if (!thud_row_sticks(state, c))
            continue;
        thud_model_apply_contact_force(m, c, force[c], q2);
        seg->force[k * m->nrows + c] = -force[c] / load_factor(seg, k);
    }
}

/* Folds a row that acts; false: it sticks, it is of two systems or not of that of the others, or of one without D. */
static bool fold_row(const struct thud_state *state, int c, struct folded *to)
{
    const struct thud_model *m = state->model;
    int structure[2] = {0}, systems = thud_model_row_structures(m, c, structure);
    const struct thud_model_structure *p = &m->structure[structure[0]];
    const struct thud_branch *branch = thud_row_branch(state, c);
    const double *g = m->jacobian + (size_t)c * (size_t)m->nmodes + p->first_mode;
    if (thud_row_sticks(state, c) || systems > 1 || (to->system >= 0 && to->system != p->system) || !p->damping ||
        p->modes > DENSE_MOST)
        return false;
    for (int i = 0, at = 0; i < p->modes; i++)
        for (int j = 0; j < p->modes; j++, at++) {
            to->spring[at] = (to->system < 0 ? 0 : to->spring[at]) + branch->k_npm * g[i] * g[j];
            to->dashpot[at] = (to->system < 0 ? p->damping : to->dashpot)[at] + branch->c_nspm * g[i] * g[j];
        }
    to->system = p->system;
    return true;
}

/* Forces from order 2 on of the rows that act, by the modes of their system. */
static void read_forces(const struct thud_state *state, struct thud_segment *seg, const struct thud_model_structure *p)
{
    const struct thud_model *m = state->model;
    for (int i = 0; i < seg->rows; i++) {
        const int c = seg->row[i];
        const struct thud_branch *branch = thud_row_branch(state, c);
        const double by_rate = branch->c_nspm / seg->h_s;
        double *d = seg->notes->indentation + c * THUD_SEGMENT_TERMS;
        if (!thud_row_by_branch(state, c))
            continue;
        thud_dots(p->modes, m->jacobian + c * m->nmodes + p->first_mode, seg->q + 2 * m->nmodes + p->first_mode,
                  m->nmodes, seg->terms - 2, d + 2);
        for (int k = 2; k < seg->terms; k++)
            seg->force[k * m->nrows + c] =
                branch->k_npm * d[k] + (k + 1 < seg->terms ? by_rate * (k + 1) * d[k + 1] : 0);
    }
}

static void linear_series(const struct thud_state *state, struct thud_segment *seg, const struct slice *of,
                          bool sticking, const double *q, const double *qd)
{
    struct folded folded; /* large: what is not used stays as it is */
    bool folds = true;
    folded.system = -1;
    for (int i = 0; i < seg->rows && folds; i++)
        folds = !thud_row_acts(state, seg->row[i]) || fold_row(state, seg->row[i], &folded);
    first_terms(state->model, seg, of, q, qd);
    seg->loaded = folds && seg->terms > 2 ? 2 : seg->terms; /* orders 0 and 1 of an indentation may be exactly 0 */
    for (int k = 0; k < seg->loaded; k++) {
        linear_forces(state, seg, k);
        if (k + 2 < seg->terms)
            next_order(state->model, seg, of, k);
        if (k + 2 < seg->terms && sticking)
            constraint_forces(state, seg, k);
    }
    if (folds) {
        unloaded_orders(state->model, seg, of, 2, &folded);
        if (folded.system >= 0) /* else none acts */
            read_forces(state, seg, &state->model->structure[state->model->system[folded.system]]);
    }
    seg->loaded = seg->terms;
}

void thud_taylor_structure(const struct thud_state *state, struct thud_segment *seg, int structure, bool yields,
                           const double *q, const double *qd)
{
    const struct thud_model_structure *p = &state->model->structure[structure];
    const struct slice of = {p->system, 1, p->first_mode, p->modes};
    if (yields)
        linear_series(state, seg, &of, false, q, qd);
    else
        series_of(state->model, seg, &of, q, qd);
}

double thud_taylor_linear(const struct thud_state *state, struct thud_segment *seg)
{
    const struct thud_model *m = state->model;
    const struct slice all = all_of(m);
    bool sticking = false;
    for (int i = 0; i < seg->rows; i++)
        sticking |= thud_row_sticks(state, seg->row[i]);
    if (thud_state_is_free(state))
        series_of(m, seg, &all, state->q, state->qd);
    else
        linear_series(state, seg, &all, sticking, state->q, state->qd);
    for (int c = 0; c < m->nrows; c++)
        if (thud_row_by_branch(state, c) && !thud_row_starts_at_zero(state, c))
            seg->notes->cached[c] = 0;
    /* fewer terms than there may be are enough by the bound of the fastest rate */
    return seg->terms < THUD_SEGMENT_TERMS_TRIED ? 0 : thud_segment_tail(seg, m);
}

void thud_segment_shorten(struct thud_segment *seg, int nmodes, int nrows, double factor)
{
    double scale = 1;
    assert(factor > 0 && factor < 1);
    for (int k = 0; k < seg->terms; k++, scale *= factor) {
        for (int j = 0; j < nmodes; j++)
            seg->q[k * nmodes + j] *= scale;
        for (int c = 0; c < nrows; c++)
            seg->force[k * nrows + c] *= scale;
    }
    seg->h_s *= factor;
    seg->a1 *= factor;
    forget(seg, nrows);
}

/* q and q' of so many pairs of modes, or of one mode, at s by Horner's scheme: x is the polynomial, v its derivative. */
static inline void pairs_at(const struct thud_segment *seg, int nmodes, double s, int j, const int pairs,
                            const bool single, double *q, double *qd)
{
    thud_vec2 x[2] = {0}, v[2] = {0};
    for (int k = seg->terms - 1; k >= 0; k--)
        for (int i = 0; i < pairs; i++) {
            v[i] = v[i] * s + x[i];
            x[i] = x[i] * s + thud_vec2_some(seg->q + k * nmodes + j + 2 * i, single);
        }
    for (int i = 0; i < pairs; i++) {
        thud_vec2_put_some(x[i], q + j + 2 * i, single);
        thud_vec2_put_some(v[i] / seg->h_s, qd + j + 2 * i, single);
    }
}

void thud_segment_state(const struct thud_segment *seg, int nmodes, double s, double *q, double *qd)
{
    int j = 0;
    for (; j + 4 <= nmodes; j += 4) /* two side by side, as each is a chain of products */
        pairs_at(seg, nmodes, s, j, 2, false, q, qd);
    for (; j < nmodes; j += 2)
        pairs_at(seg, nmodes, s, j, 1, j + 1 == nmodes, q, qd);
}

/* What rounding may leave of the difference of two neighbours' terms of order k. A stepping method's higher terms are
 * differences of its end states, whose rounding is that of the largest term. */
static double term_noise(const struct thud_state *state, bool interpolates, int k, const double *size, double largest)
{
    if (k == 0)
        return state->touch_m;
    double least =
        fmax(THUD_TOL_LEAST_COEFFICIENT * state->length_m, (k == 1 ? THUD_TOL_RATE : THUD_TOL_COEFFICIENT) * size[k]);
    if (k > 1) /* a sum of modes, each of which follows from the two orders before */
        least = fmax(least, THUD_TOL_STATE * fmax(size[k - 1], size[k - 2]));
    return interpolates && k > 1 ? fmax(least, THUD_TOL_STEP_COEFFICIENT * largest) : least;
}

int thud_segment_indentation(const struct thud_state *state, const struct thud_segment *seg, int c, double *out)
{
    const struct thud_model *m = state->model;
    const struct thud_model_side *l = &m->contact[c].left, *r = &m->contact[c].right;
    double left[THUD_SEGMENT_TERMS], right[THUD_SEGMENT_TERMS], size[THUD_SEGMENT_TERMS], largest = 0;
    int suppressed = 0;
    if (!thud_row_starts_at_zero(state, c)) {
        const int first =
                      r->modes == 0 || (l->modes > 0 && l->first_mode < r->first_mode) ? l->first_mode : r->first_mode,
                  end_l = l->first_mode + l->modes, end_r = r->first_mode + r->modes;
        thud_model_gap_pair(m, c, seg->q, m->nmodes, out); /* the bits of the state */
        thud_dots((end_l > end_r ? end_l : end_r) - first, m->jacobian + c * m->nmodes + first,
                  seg->q + 2 * m->nmodes + first, m->nmodes, seg->terms - 2, out + 2);
        out[0] -= thud_state_clearance(state, c);
        return 0;
    }
    /* side by side: neighbours that move alike have exactly no relative motion */
    thud_dots(l->modes, l->row, seg->q + l->first_mode, m->nmodes, seg->terms, left);
    thud_dots(r->modes, r->row, seg->q + r->first_mode, m->nmodes, seg->terms, right);
    for (int k = 0; k < seg->terms; k++) {
        out[k] = left[k] - right[k];
        size[k] = fabs(left[k]) + fabs(right[k]);
        largest = thud_larger(largest, size[k]);
    }
    out[0] -= thud_state_clearance(state, c);
    while (suppressed < seg->terms &&
           fabs(out[suppressed]) <= term_noise(state, seg->interpolates, suppressed, size, largest))
        suppressed++;
    return suppressed;
}

int thud_segment_contact(const struct thud_state *state, const struct thud_segment *seg, int c)
{
    struct thud_segment_notes *notes = seg->notes;
    assert(c >= 0 && c < state->model->nrows);
    if (notes->cached[c] < 0)
        notes->cached[c] = thud_segment_indentation(state, seg, c, notes->indentation + c * THUD_SEGMENT_TERMS);
    return notes->cached[c];
}
