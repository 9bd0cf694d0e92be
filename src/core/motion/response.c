#include "core/motion/response.h"

#include <math.h>
#include <string.h>

#include "base/arena.h"
#include "core/contact/segment.h"
#include "core/numerics/tolerance.h"
#include "core/numerics/vec.h"

/* Tables of eq. (8) of thud-methods(7): how the gaps move in a step, without contact forces and under each other's.
 *
 * In a step of length h from t0, with s = (t - t0)/h, the modes obey
 *
 *     q'' + D q' + Omega^2 q = -gamma a_g(s) - sum_b g_b F_b(s),   d_a = g_a . q - clearance_a
 *     F_b(s) = sum_k F_b(s_k) l_k(s)                               l_k: Lagrange polynomials of the nodes
 *
 * This is linear in F. So d_a(s_i) = d0_a(s_i) - sum_b sum_k R_ab,ik F_b(s_k), where d0 is the motion without the forces.
 *
 * Glossary; a, b are rows (contacts, storeys), j a mode, i a point, k a node, p a power of s.
 *
 *     level          h = h_top/2^level; the tables of a level are made when it is first needed
 *     x_p            motion from rest of a mode under the load s^p alone, one for all rows where modes are uncoupled (load
 *                    1 on each mode), else one for each row b (load g_b). Its rate starts at 0 and is p times the motion
 *                    under s^(p - 1): x_p = p int x_(p-1) ds, so that the series of x_0 is all that is made
 *     R_ab, R'_ab    level->pair: sums of g_a x_p times the coefficients of l_k, below 0 where the force pushes apart
 *     r0, rise       x->at_start, x->rise: modal accelerations at t0 without contact forces, and by how much ground and
 *                    velocity change them in h (m kg^1/2/s^2). q = q0 + q0' h s + r0 x_0 + rise x_1 */
enum { LEVELS = 48 };

struct level {
    int terms; /* of a series; 0: not yet known */
    struct load {
        double *series;   /* (terms x nmodes) of x_0; NULL: not yet made */
        thud_vec2 *start; /* (2 x nmodes x points) x_0 and x_1 with their rates */
    } * load;             /* (loads) */
    thud_vec2 *
        *pair; /* (nrows x nrows) of a <= b: (points x n) R_ab and R'_ab; NULL: not yet made. R_ba is the same, as
                         stiffness and damping are symmetric (Betti and Maxwell) */
};

struct thud_responses {
    const struct thud_model *model;
    struct thud_blocks *memory;
    int n, points, loads; /* nodes; points in all; tables in level->load */
    double h_top;
    double lagrange[THUD_NODES_MAX * THUD_NODES_MAX], point[THUD_POINTS_MAX];
    struct level level[LEVELS];
    struct thud_segment seg; /* workspace: series of the motion under unit loads */
    double *at_start, *rise; /* (nmodes) */
    double *zero, *ones;     /* (nmodes) no displacements; 1 */
    double *weight;      /* (n + 1 x points x terms) of a series of x_0 for its rate at the points, and its integrals */
    thud_vec2 *unforced; /* (nmodes x points) modes that start at rest, and their rates */
};

/* Fills x->weight: a term of x_0 integrated p times is k!/(k + p)! s^p times its own; p = -1: its rate. */
static void fill_weights(struct thud_responses *x)
{
    for (int i = 0; i < x->points; i++) {
        double power = 1; /* s^(k - 1) */
        for (int k = 1; k < THUD_SEGMENT_TERMS; k++, power *= x->point[i]) {
            double value = k * power;
            for (int p = -1; p < x->n; p++, value *= x->point[i] / (k + p))
                x->weight[((p + 1) * x->points + i) * THUD_SEGMENT_TERMS + k] = value;
        }
    }
}

enum thud_status thud_responses_create(const struct thud_state *state, int n, int points, const double *point,
                                       const double *lagrange, double h_top, struct thud_responses **out,
                                       struct thud_error *err)
{
    const struct thud_model *m = state->model;
    const size_t modes = (size_t)m->nmodes;
    struct thud_responses *x, to = {.model = m,
                                    .memory = state->memory,
                                    .n = n,
                                    .points = points,
                                    .loads = m->couples ? m->nrows : 1,
                                    .h_top = h_top};
    const enum thud_status status = THUD_LAY_IN(
        state->memory, err, THUD_PIECE(x, 1), THUD_PIECE(to.at_start, modes), THUD_PIECE(to.rise, modes),
        THUD_PIECE(to.zero, modes), THUD_PIECE(to.ones, modes), THUD_PIECE(to.unforced, modes * (size_t)points),
        THUD_PIECE(to.weight, (n + 1) * points * THUD_SEGMENT_TERMS));
    *out = x;
    if (status != THUD_OK)
        return status;
    *x = to;
    memcpy(x->lagrange, lagrange, (size_t)(n * n) * sizeof *lagrange);
    memcpy(x->point, point, (size_t)points * sizeof *point);
    for (size_t j = 0; j < modes; j++)
        x->ones[j] = 1;
    fill_weights(x);
    return thud_segment_init(&x->seg, state, err);
}

/* ---- R and R' ---- */

/* The series under the load b on the modes, and what of it is read at the points. */
static bool fill_load(struct thud_responses *x, struct load *out, const double *b, int terms, double h)
{
    const int n = x->model->nmodes, size = n * x->points;
    struct thud_segment *seg = &x->seg;
    if (THUD_LAY_IN(x->memory, NULL, THUD_PIECE(out->series, terms * n), THUD_PIECE(out->start, 2 * size)) != THUD_OK)
        return false;
    thud_taylor_load(x->model, seg, h, terms, b);
    memcpy(out->series, seg->q, (size_t)(terms * n) * sizeof *out->series);
    for (int p = 0; p < 2; p++) {
        for (int i = 0; i < x->points; i++) {
            thud_segment_state(seg, n, x->point[i], x->at_start, x->rise);
            for (int j = 0; j < n; j++)
                out->start[p * size + j * x->points + i] = thud_vec2_set(x->at_start[j], x->rise[j]);
        }
        for (int k = terms * n - 1; k >= n; k--) /* the series of x_1 */
            seg->q[k] = seg->q[k - n] / (k / n);
    }
    return true;
}

/* Uncoupled modes, one table for all contacts, respond to a contact's force as much as its row has of them;
 * where damping couples them, each contact has its own table. */
static struct load *load_of(const struct thud_responses *x, const struct level *level, int c)
{
    return &level->load[x->model->couples ? c : 0];
}

/* Sums over the modes of a row's structures, by these weights, of modes at the points (nmodes x points), which are 0 at the
 * first: to what out (points) holds. */
static inline void sum_at(const struct thud_model *m, int row, const double *weight, const thud_vec2 *modes,
                          thud_vec2 *out, const int points)
{
    thud_vec2 sum[THUD_POINTS_MAX];
    int structure[2], structures = thud_model_row_structures(m, row, structure);
    for (int i = 1; i < points; i++)
        sum[i] = out[i];
    for (int k = 0; k < structures; k++) {
        const struct thud_model_structure *s = &m->structure[structure[k]];
        const int end = s->first_mode + s->modes;
        const thud_vec2 *mode = modes + s->first_mode * points;
        for (int j = s->first_mode; j < end; j++, mode += points)
            for (int i = 1; i < points; i++)
                sum[i] += weight[j] * mode[i];
    }
    for (int i = 1; i < points; i++)
        out[i] = sum[i];
}

/* R_ab and R'_ab: motion of gap a under the loads s^p on row b, put together to the Lagrange polynomial of each node. */
static bool fill_pair(struct thud_responses *x, const struct level *level, double h, int a, int b, thud_vec2 **out)
{
    const struct thud_model *m = x->model;
    const double *ga = m->jacobian + a * m->nmodes, *gb = m->jacobian + b * m->nmodes;
    double gap[THUD_SEGMENT_TERMS], value[(THUD_NODES_MAX + 1) * THUD_POINTS_MAX], factorial = 1;
    if (THUD_LAY_IN(x->memory, NULL, THUD_PIECE(*out, x->points * x->n)) != THUD_OK)
        return false;
    const int n = x->n, points = x->points;
    thud_vec2 *motion = *out;
    for (int j = 0; j < m->nmodes; j++)
        x->rise[j] = m->couples ? -ga[j] : -ga[j] * gb[j];
    thud_dots(m->nmodes, x->rise, load_of(x, level, b)->series, m->nmodes, level->terms, gap);
    thud_dots(level->terms, gap, x->weight, THUD_SEGMENT_TERMS, (x->n + 1) * x->points, value);
    for (int p = 0; p < n; p++, factorial *= p) { /* x_p is p! times that integral */
        double share[THUD_NODES_MAX];
        for (int k = 0; k < n; k++)
            share[k] = factorial * x->lagrange[p * n + k];
        for (int i = 0; i < points; i++) {
            const double *at = value + p * points + i;
            const thud_vec2 term = thud_vec2_set(at[points], at[0] / h);
            for (int k = 0; k < n; k++)
                motion[i * n + k] += share[k] * term;
        }
    }
    return true;
}

enum thud_status thud_responses_make(struct thud_responses *x, int at, const int *contact, int n, const thud_vec2 **out,
                                     struct thud_error *err)
{
    struct level *level = &x->level[at];
    const struct thud_model *m = x->model;
    const size_t rows = (size_t)m->nrows;
    const double h = thud_level_step(x->h_top, at);
    bool made = level->pair || THUD_LAY_IN(x->memory, NULL, THUD_PIECE(level->pair, rows * rows),
                                           THUD_PIECE(level->load, rows)) == THUD_OK;
    if (level->terms == 0)
        level->terms = thud_segment_terms(m->fastest_radps * h, THUD_TOL_SERIES, THUD_SEGMENT_TERMS_LEAST);
    for (int b = 0; b < n && made; b++) {
        struct load *load = load_of(x, level, contact[b]);
        made = load->series ||
               fill_load(x, load, m->couples ? m->jacobian + contact[b] * m->nmodes : x->ones, level->terms, h);
    }
    for (int a = 0; a < n && made; a++)
        for (int b = 0; b < n && made; b++) {
            const int low = contact[a < b ? a : b], high = contact[a < b ? b : a];
            thud_vec2 **pair = &level->pair[(size_t)low * rows + (size_t)high];
            made = *pair || fill_pair(x, level, h, low, high, pair);
            *out++ = *pair;
        }
    return made ? THUD_OK : thud_error_set(err, THUD_MEMORY, "out of memory");
}

/* ---- without contact forces ---- */

/* r0 and rise. Apart from the straight line q0 + q0' t each mode starts at rest under the load r0 + rise s. */
static void find_loads(struct thud_responses *x, const struct thud_state *state, double h)
{
    const struct thud_model *m = x->model;
    double start, end;
    thud_state_ground(state, state->grid, &start, &end);
    double slope = (end - start) / state->grid_dt_s;
    thud_model_acceleration(m, state->q, state->qd, start + slope * state->offset_s, x->at_start);
    thud_model_acceleration(m, state->qd, x->zero, slope, x->rise);
    for (int j = 0; j < m->nmodes; j++)
        x->rise[j] *= h;
    if (state->nshifted > 0) { /* storeys with a plastic drift push too */
        thud_segment_begin(state, &x->seg, h, 0);
        thud_model_apply_contact_forces(m, x->seg.force, x->at_start);
    }
}

/* r0 x_0 + rise x_1 of all modes, which no damping couples, into x->unforced; at the first point it is 0. */
static inline void move_modes(struct thud_responses *x, const struct level *level, const int points)
{
    const int n = x->model->nmodes;
    const thud_vec2 *table = level->load->start, *rising = table + n * points;
    thud_vec2 *restrict out = x->unforced;
    for (int j = 0; j < n; j++, out += points, table += points, rising += points)
        for (int i = 1; i < points; i++)
            out[i] = x->at_start[j] * table[i] + x->rise[j] * rising[i];
}

/* Of so many points: a constant, so that compilers keep the sums in registers. */
static inline void unforced_at(struct thud_responses *x, int at, double h, const int *contact, int n,
                               const thud_vec2 *start, thud_vec2 *out, const int points)
{
    const struct thud_model *m = x->model;
    if (!m->couples)
        move_modes(x, &x->level[at], points);
    for (int a = 0; a < n; a++, start += points, out += points) {
        const thud_vec2 *table = load_of(x, &x->level[at], contact[a])->start;
        for (int i = 0; i < points; i++)
            out[i] = thud_vec2_set(start[0][0] + start[0][1] * h * x->point[i], start[0][1]);
        if (m->couples)
            sum_at(m, contact[a], x->rise, table + m->nmodes * points, out, points);
        sum_at(m, contact[a], m->couples ? x->at_start : m->jacobian + contact[a] * m->nmodes,
               m->couples ? table : x->unforced, out, points);
    }
}

void thud_responses_unforced(struct thud_responses *x, const struct thud_state *state, int at, const int *contact,
                             int n, const thud_vec2 *start, thud_vec2 *out)
{
    const double h = thud_level_step(x->h_top, at);
    find_loads(x, state, h);
    if (x->points == 4)
        unforced_at(x, at, h, contact, n, start, out, 4);
    else if (x->points == 6)
        unforced_at(x, at, h, contact, n, start, out, 6);
    else if (x->points == 7)
        unforced_at(x, at, h, contact, n, start, out, 7);
    else
        unforced_at(x, at, h, contact, n, start, out, THUD_POINTS_MAX);
}
