#include "core/motion/response.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/contact/segment.h"
#include "core/numerics/tolerance.h"

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
 *     x_p            motion from rest of a mode under the load s^p alone: level->load, one table for all rows where modes
 *                    are uncoupled (load 1 on each mode), else one for each row b (load g_b); power -1, the first of
 *                    POWERS, is an impulse, whose motion is h times the rate of x_0
 *     R_ab, R'_ab    thud_response.indentation and .rate: sums of g_a x_p times the coefficients of l_k, below 0 where
 *                    the force pushes apart
 *     r0, rise       x->at_start, x->rise: modal accelerations at t0 without contact forces, and by how much ground and
 *                    velocity change them in h (m kg^1/2/s^2). q = q0 + q0' h s + r0 x_0 + rise x_1
 *     bend           by how much the slope of a_g changes at a sample inside the step, times h_top (m/s^2)
 *     ramp           indentation under a ground acceleration that rises by 1 m/s^2 in h_top: a power series of t/h_top,
 *                    from its third power on */
enum { LEVELS = 48, POWERS = THUD_NODES + 1 };
enum { RAMP_ORDER = 3 };

struct level {
    double *load;               /* (loads x POWERS x nmodes x THUD_POINTS) */
    struct thud_response *pair; /* (nrows x nrows) R_ab and R'_ab; NULL inside where not yet made */
};

struct thud_responses {
    const struct thud_model *model;
    int loads; /* tables in level->load */
    double h_top, tolerance;
    double lagrange[THUD_NODES * THUD_NODES], point[THUD_POINTS];
    struct thud_nodes first, last; /* the points: a batch, and those behind it */
    struct level level[LEVELS];
    struct thud_segment seg; /* workspace: series of the motion under unit loads */
    double *at_start, *rise; /* (nmodes) */
    double *zero;            /* (nmodes) no displacements */
    double *ramp_modes;      /* (THUD_SEGMENT_TERMS x nmodes) modes under the ramp */
    double *ramp;            /* (nrows x THUD_SEGMENT_TERMS) indentations under it, made when needed */
    int *ramp_terms;         /* (nrows) terms that count; 0: not made */
};

/* An empty segment of length h for the series of a motion under a unit load. */
static struct thud_segment *unit_segment(struct thud_responses *x, double h)
{
    struct thud_segment *seg = &x->seg;
    /* a load's own power comes on top */
    seg->terms = thud_segment_terms(x->model->fastest_radps * h, THUD_TOL_SERIES) + THUD_NODES;
    seg->terms = seg->terms < THUD_SEGMENT_TERMS ? seg->terms : THUD_SEGMENT_TERMS;
    seg->h_s = h;
    seg->a0 = seg->a1 = 0;
    seg->loaded = 0;
    return seg;
}

enum thud_status thud_responses_create(const struct thud_model *m, const double *point, const double *lagrange,
                                       double h_top, double tolerance, struct thud_responses **out,
                                       struct thud_error *err)
{
    size_t n = (size_t)m->nmodes, nc = (size_t)m->nrows, terms = THUD_SEGMENT_TERMS;
    struct thud_responses *x = *out = calloc(1, sizeof *x);
    if (x) {
        *x = (struct thud_responses){
            .model = m, .loads = m->couples ? m->nrows : 1, .h_top = h_top, .tolerance = tolerance};
        memcpy(x->lagrange, lagrange, sizeof x->lagrange);
        memcpy(x->point, point, sizeof x->point);
        x->at_start = calloc(3 * n + terms * (n + nc) + 1, sizeof *x->at_start);
        x->ramp_terms = calloc(nc + 1, sizeof *x->ramp_terms);
    }
    if (!x || !x->at_start || !x->ramp_terms || thud_segment_init(&x->seg, m, err) != THUD_OK) {
        thud_responses_free(x);
        *out = NULL;
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    thud_nodes_set(&x->first, THUD_BATCH, point, 1, THUD_SEGMENT_TERMS);
    thud_nodes_set(&x->last, THUD_POINTS - THUD_BATCH, point + THUD_BATCH, 1, THUD_SEGMENT_TERMS);
    x->rise = x->at_start + n;
    x->zero = x->rise + n;
    x->ramp_modes = x->zero + n;
    x->ramp = x->ramp_modes + terms * n;
    struct thud_segment *seg = unit_segment(x, h_top);
    for (size_t j = 0; j < n; j++)
        x->rise[j] = -m->gamma[j];
    thud_taylor_load(m, seg, x->rise, 1);
    memcpy(x->ramp_modes, seg->q, (size_t)seg->terms * n * sizeof *seg->q);
    return THUD_OK;
}

void thud_responses_free(struct thud_responses *x)
{
    if (!x)
        return;
    for (int l = 0; l < LEVELS; l++) {
        struct level *level = &x->level[l];
        for (int p = 0; level->pair && p < x->model->nrows * x->model->nrows; p++)
            if (!level->pair[p].shared)
                free(level->pair[p].indentation);
        free(level->pair);
        free(level->load);
    }
    free(x->at_start);
    free(x->ramp_terms);
    thud_segment_clear(&x->seg);
    free(x);
}

/* ---- R and R' ---- */

/* Modal displacements of the segment at the points, out (nmodes x THUD_POINTS). */
static void read_modes(const struct thud_responses *x, double *out)
{
    const struct thud_segment *seg = &x->seg;
    int n = x->model->nmodes;
    for (int j = 0; j < n; j++, out += THUD_POINTS) {
        double last[THUD_BATCH];
        thud_nodes_values(&x->first, seg->q + j, n, seg->terms, out);
        thud_nodes_values(&x->last, seg->q + j, n, seg->terms, last);
        memcpy(out + THUD_BATCH, last, (THUD_POINTS - THUD_BATCH) * sizeof *last);
    }
}

/* out += factor x at all points */
static void add_to(double factor, const double *restrict x, double *restrict out)
{
    for (int i = 0; i < THUD_POINTS; i++)
        out[i] += factor * x[i];
}

/* x_(p-2) from x_(p-1) and x_p, (nmodes x THUD_POINTS) each, for loads b s^p. The rate of x_p is p x_(p-1), so that the
 * equation of motion x_p'' + h D x_p' + h^2 Omega^2 x_p = h^2 b s^p reads
 *
 *     p (p - 1) x_(p-2) = h^2 (b s^p - Omega^2 x_p) - h p D x_(p-1)
 *
 * and nothing cancels on the way down. For p = 1 the left side is the rate of x_0 (times h). */
static void step_down(const struct thud_responses *x, double h, int p, const double *b, const double *xp,
                      const double *below, double *out)
{
    const struct thud_model *m = x->model;
    double s[THUD_POINTS], scale = p > 1 ? 1.0 / (p * (p - 1)) : 1;
    memcpy(s, x->first.power[p], sizeof x->first.power[p]);
    memcpy(s + THUD_BATCH, x->last.power[p], (THUD_POINTS - THUD_BATCH) * sizeof *s);
    for (int j = 0; j < m->nmodes; j++) {
        double *to = out + j * THUD_POINTS;
        memset(to, 0, THUD_POINTS * sizeof *to);
        add_to(scale * h * h * b[j], s, to);
        add_to(-scale * h * h * m->spring[j], xp + j * THUD_POINTS, to);
        add_to(-scale * h * p * m->dashpot[j], below + j * THUD_POINTS, to);
    }
    for (int i = 0; i < m->nsystems; i++) {
        const struct thud_model_structure *t = &m->structure[m->system[i]];
        for (int j = 0; t->damping && j < t->modes; j++)
            for (int k = 0; k < t->modes; k++)
                add_to(-scale * h * p * t->damping[j * t->modes + k], below + (t->first_mode + k) * THUD_POINTS,
                       out + (t->first_mode + j) * THUD_POINTS);
    }
}

/* All x_p for loads b, table (POWERS x nmodes x THUD_POINTS): the highest two by their power series, the others down
 * from them. */
static void fill_powers(struct thud_responses *x, double h, const double *b, double *table)
{
    const struct thud_model *m = x->model;
    struct thud_segment *seg = unit_segment(x, h);
    const int size = m->nmodes * THUD_POINTS;
    for (int p = THUD_NODES - 2; p < THUD_NODES; p++) {
        thud_taylor_load(m, seg, b, p);
        read_modes(x, table + (p + 1) * size);
    }
    for (int p = THUD_NODES - 1; p >= 1; p--)
        step_down(x, h, p, b, table + (p + 1) * size, table + p * size, table + (p - 1) * size);
}

static bool fill_level(struct thud_responses *x, struct level *level, double h)
{
    const struct thud_model *m = x->model;
    size_t n = (size_t)m->nmodes, nc = (size_t)m->nrows, size = POWERS * n * THUD_POINTS;
    level->pair = calloc(nc * nc + 1, sizeof *level->pair);
    level->load = calloc((size_t)x->loads * size + 1, sizeof *level->load);
    if (!level->pair || !level->load)
        return false;
    double *ones = x->rise;
    for (size_t j = 0; j < n; j++)
        ones[j] = 1;
    for (int load = 0; load < x->loads; load++)
        fill_powers(x, h, m->couples ? m->jacobian + (size_t)load * n : ones, level->load + (size_t)load * size);
    return true;
}

/* Uncoupled modes, one table for all contacts, respond to a contact's force as much as its row has of them;
 * where damping couples them, each contact has its own table. */
static const double *table_of(const struct thud_responses *x, const struct level *level, int c)
{
    return level->load + (x->model->couples ? c : 0) * POWERS * x->model->nmodes * THUD_POINTS;
}

/* Motion of gap a under the loads of row b, by power: power (POWERS x THUD_POINTS). Only modes of a's structures count. */
static void gap_powers(const struct thud_responses *x, const struct level *level, int a, int b,
                       double power[POWERS][THUD_POINTS])
{
    const struct thud_model *m = x->model;
    const double *ga = m->jacobian + a * m->nmodes, *gb = m->jacobian + b * m->nmodes, *table = table_of(x, level, b);
    int structure[2], structures = thud_model_row_structures(m, a, structure);
    for (int p = 0; p < POWERS; p++, table += m->nmodes * THUD_POINTS)
        for (int i = 0; i < structures; i++) {
            const struct thud_model_structure *s = &m->structure[structure[i]];
            for (int j = s->first_mode; j < s->first_mode + s->modes; j++)
                add_to(m->couples ? -ga[j] : -ga[j] * gb[j], table + j * THUD_POINTS, power[p]);
        }
}

/* R_ab and R'_ab: the powers of s put together to the Lagrange polynomial of each node; the rate of x_p is p/h x_(p-1). */
static bool fill_pair(const struct thud_responses *x, const struct level *level, double h, int a, int b)
{
    struct thud_response *r = &level->pair[a * x->model->nrows + b];
    double *block = calloc(2 * THUD_NODES * THUD_POINTS + 2 * THUD_BATCH + 1, sizeof *block),
           power[POWERS][THUD_POINTS] = {0};
    if (!block)
        return false;
    r->indentation = block;
    r->rate = block + THUD_NODES * THUD_POINTS;
    r->own_indentation = r->rate + THUD_NODES * THUD_POINTS;
    r->own_rate = r->own_indentation + THUD_BATCH;
    gap_powers(x, level, a, b, power);
    for (int k = 0; k < THUD_NODES; k++) {
        for (int p = 0; p < THUD_NODES; p++) {
            double part = x->lagrange[p * THUD_NODES + k];
            add_to(part, power[p + 1], r->indentation + k * THUD_POINTS);
            add_to(part * (p > 0 ? p : 1) / h, power[p], r->rate + k * THUD_POINTS);
        }
        r->own_indentation[k] = r->indentation[k * THUD_POINTS + k];
        r->own_rate[k] = r->rate[k * THUD_POINTS + k];
    }
    return true;
}

/* R_ab = R_ba, as stiffness and damping are symmetric (Betti and Maxwell). */
static bool mirror_pair(const struct thud_responses *x, const struct level *level, int a, int b)
{
    const struct thud_response *other = &level->pair[b * x->model->nrows + a];
    if (!other->indentation)
        return false;
    level->pair[a * x->model->nrows + b] = *other;
    level->pair[a * x->model->nrows + b].shared = true;
    return true;
}

enum thud_status thud_responses_make(struct thud_responses *x, int at, const int *contact, int n,
                                     const struct thud_response **out, struct thud_error *err)
{
    struct level *level = &x->level[at];
    double h = ldexp(x->h_top, -at);
    bool made = level->pair || fill_level(x, level, h);
    for (int a = 0; a < n && made; a++) {
        const struct thud_response *row = level->pair + contact[a] * x->model->nrows;
        for (int b = 0; b < n && made; b++, out++) {
            *out = row + contact[b];
            made = (*out)->indentation || mirror_pair(x, level, contact[a], contact[b]) ||
                   fill_pair(x, level, h, contact[a], contact[b]);
        }
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
        thud_segment_begin(state, &x->seg, h);
        thud_model_apply_contact_forces(m, x->seg.force, x->at_start);
    }
}

/* Indentation and its rate at all points, in pairs. */
struct motion {
    thud_vec2 value[THUD_POINTS / 2], rate[THUD_POINTS / 2];
};

/* Adds r0 x_0 + rise x_1 and its rate (r0 x_-1 + rise x_0)/h of one mode. */
static inline void add_mode(struct motion *sum, double at_start, double rise, double h, const double *impulse,
                            const double *constant, const double *ramp)
{
    double start_rate = at_start / h, rise_rate = rise / h;
    for (int i = 0; i < THUD_POINTS / 2; i++) {
        thud_vec2 x = thud_vec2_at(constant + 2 * i);
        sum->value[i] += at_start * x + rise * thud_vec2_at(ramp + 2 * i);
        sum->rate[i] += start_rate * thud_vec2_at(impulse + 2 * i) + rise_rate * x;
    }
}

/* d and v (THUD_POINTS each) of row c without contact forces and without bends of the ground acceleration. */
static void move_contact(const struct thud_responses *x, const struct thud_state *state, const struct level *level,
                         double h, int c, double *d, double *v)
{
    const struct thud_model *m = x->model;
    const int size = m->nmodes * THUD_POINTS;
    const double *g = m->jacobian + c * m->nmodes, *table = table_of(x, level, c);
    /* at contact onset a contact has not moved yet, whatever rounding says */
    double start = thud_row_starts_at_zero(state, c) ? 0 : thud_contact_indentation(state, c);
    double rate = thud_contact_rate(state, c);
    struct motion sum;
    for (int i = 0; i < THUD_POINTS / 2; i++) {
        sum.value[i] = start + rate * h * thud_vec2_at(x->point + 2 * i);
        sum.rate[i] = thud_vec2_set(rate, rate);
    }
    int structure[2], structures = thud_model_row_structures(m, c, structure);
    for (int i = 0; i < structures; i++) {
        const struct thud_model_structure *s = &m->structure[structure[i]];
        for (int j = s->first_mode; j < s->first_mode + s->modes; j++) {
            const double *mode = table + j * THUD_POINTS;
            double part = m->couples ? 1 : g[j];
            add_mode(&sum, part * x->at_start[j], part * x->rise[j], h, mode, mode + size, mode + 2 * size);
        }
    }
    memcpy(d, sum.value, sizeof sum.value);
    memcpy(v, sum.rate, sizeof sum.rate);
}

/* Makes the ramp of row c; returns how many of its terms count. */
static int ramp_of(struct thud_responses *x, int c)
{
    /* what is left out of what a bend adds is far below that of the rest */
    const double least = fmin(1e-6, fmax(1e-14, 1e-3 * x->tolerance));
    double *ramp = x->ramp + c * THUD_SEGMENT_TERMS, largest = 0;
    if (x->ramp_terms[c] > 0)
        return x->ramp_terms[c];
    for (int k = 0; k < THUD_SEGMENT_TERMS; k++) {
        ramp[k] = thud_model_gap_sum(x->model, c, x->ramp_modes + k * x->model->nmodes);
        largest = fmax(largest, fabs(ramp[k]));
    }
    int terms = THUD_SEGMENT_TERMS;
    while (terms > RAMP_ORDER + 1 && fabs(ramp[terms - 1]) <= least * largest)
        terms--;
    return x->ramp_terms[c] = terms;
}

/* Adds the effect of a bend `after_s` into the step: bend times the ramp, from there on. */
static void add_kink(struct thud_responses *x, int c, double bend, double h, double after_s, double *d, double *v)
{
    const double *ramp = x->ramp + c * THUD_SEGMENT_TERMS;
    int terms = ramp_of(x, c);
    for (int i = 0; i < THUD_POINTS; i += 2) {
        thud_vec2 at = thud_vec2_at(x->point + i) * h - after_s, value = {0, 0}, rate = {0, 0};
        if (at[0] <= 0 && at[1] <= 0)
            continue;
        at = thud_vec2_set(at[0] > 0 ? at[0] : 0, at[1] > 0 ? at[1] : 0) / x->h_top;
        for (int k = terms - 1; k >= RAMP_ORDER; k--) {
            rate = rate * at + value;
            value = value * at + ramp[k];
        }
        thud_vec2 square = bend * at * at;
        thud_vec2_put(thud_vec2_at(d + i) + square * at * value, d + i);
        thud_vec2_put(thud_vec2_at(v + i) + square / x->h_top * (RAMP_ORDER * value + at * rate), v + i);
    }
}

/* The same of every sample of the ground motion inside the step where it bends. */
static void add_kinks(struct thud_responses *x, const struct thud_state *state, double h, double end_s,
                      const int *contact, int n, double *d, double *v)
{
    const double dt = state->grid_dt_s;
    double before, at, same, after;
    for (long g = state->grid + 1;; g++) {
        double after_s = (double)(g - state->grid) * dt - state->offset_s;
        if (after_s >= fmin(h, end_s) * (1 - THUD_TOL_TIME))
            return;
        thud_state_ground(state, g - 1, &before, &at);
        thud_state_ground(state, g, &same, &after);
        double bend = (after - at - (at - before)) / dt * x->h_top;
        for (int a = 0; a < n && bend != 0; a++)
            add_kink(x, contact[a], bend, h, after_s, d + a * THUD_POINTS, v + a * THUD_POINTS);
    }
}

void thud_responses_unforced(struct thud_responses *x, const struct thud_state *state, int at, double end_s,
                             const int *contact, int n, double *d, double *v)
{
    double h = ldexp(x->h_top, -at);
    find_loads(x, state, h);
    for (int a = 0; a < n; a++)
        move_contact(x, state, &x->level[at], h, contact[a], d + a * THUD_POINTS, v + a * THUD_POINTS);
    add_kinks(x, state, h, end_s, contact, n, d, v);
}
