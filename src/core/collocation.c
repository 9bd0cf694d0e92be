#include "core/collocation.h"

#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/largest.h"
#include "core/nodes.h"
#include "core/poly.h"
#include "core/radau.h"
#include "core/tolerance.h"

/* Values at the points of a contact stand THUD_BATCH apart; those past the last point are padding. */
enum { THUD_POINTS = 7, THUD_LEVELS = 48, THUD_BLOCK = THUD_POINTS * THUD_BATCH };

/* Indentation and rate at point i from the force at point j of another contact, per step size: blocks (THUD_POINTS x
 * THUD_BATCH) by [j][i], made when first needed. */
struct thud_response {
    double *indentation, *rate;
    bool shared; /* the memory is another's */
};

struct thud_collocation {
    double node[THUD_POINTS], lagrange[THUD_POINTS * THUD_POINTS];
    struct thud_nodes nodes, checks; /* the points, and those between them where the error is measured */
    double h_top;                    /* step of level 0 */
    double h, h_touch;
    int steady;         /* steps since one that let the next be longer */
    double contraction; /* of the fixed-point iteration, as last measured and with a margin */
    bool just_touched;
    bool has_source; /* the forces of the last segment go on into this step */
    double *last;    /* (THUD_POINTS x nc): their coefficients, in a segment of last_h, from s = source on */
    double last_h, source;
    int nc, nmodes, loads;      /* loads: 1 where modes are uncoupled, else one per contact */
    double *modal[THUD_LEVELS]; /* (loads x THUD_POINTS x nmodes x 2 x THUD_BATCH): q and q' of each mode at the
                                   points, by load and power */
    struct thud_response *pair[THUD_LEVELS]; /* (nc x nc) */
    struct thud_segment seg;                 /* of unit loads, and of the motion without contact forces */
    /* The system: unknowns are the forces of the active contacts at the points */
    int *active; /* (nc) */
    int nactive, capacity;
    double *force, *d0, *v0, *d, *v; /* (nactive x THUD_BATCH) */
    double *residual, *matrix;       /* (nactive x THUD_POINTS); square */
    double *scale, *change;          /* (nactive) on which a change of the force counts, and the last one */
    lapack_int *pivot;
};

/* How contacts would move through a step if no contact force acted. */

/* calloc of at least one element. */
static void *allocate(size_t count, size_t size)
{
    return calloc(count ? count : 1, size);
}

static void begin_segment(const struct thud_state *state, struct thud_segment *seg, double h)
{
    thud_segment_begin(state, seg, h);
    double least = fmin(1e-15, fmax(THUD_TOL_SERIES, 1e-9 * state->tolerance));
    seg->terms = thud_segment_terms(state->fastest_radps * h, least);
}

/* Indentations and rates of the active contacts at the points. */
static void fill_unforced(const struct thud_state *state, struct thud_collocation *x, double h)
{
    double p[THUD_SEGMENT_TERMS];
    begin_segment(state, &x->seg, h);
    thud_taylor_given(state->model, &x->seg, state->q, state->qd);
    for (int a = 0; a < x->nactive; a++) {
        int c = x->active[a];
        thud_segment_indentation(state, &x->seg, c, p);
        if (state->contact[c].suppressed.indentation > 0)
            p[0] = 0;
        thud_nodes_values(&x->nodes, p, 1, x->seg.terms, x->d0 + a * THUD_BATCH);
        thud_nodes_rates(&x->nodes, p, 1, x->seg.terms, h, x->v0 + a * THUD_BATCH);
    }
}

/* How contacts respond to each other's forces at the points of a step. */

/* Motion of every mode at the points under unit loads s^power. */
static bool fill_modal(const struct thud_state *state, struct thud_collocation *x, int level, double h)
{
    size_t n = (size_t)x->nmodes;
    double *table = allocate((size_t)x->loads * THUD_POINTS * n * 2 * THUD_BATCH, sizeof *table),
           *ones = allocate(n, sizeof *ones);
    x->modal[level] = table;
    if (!table || !ones) {
        free(ones);
        return false;
    }
    for (size_t j = 0; j < n; j++)
        ones[j] = 1;
    struct thud_segment *seg = &x->seg;
    seg->terms = THUD_SEGMENT_TERMS;
    seg->h_s = h;
    seg->a0 = seg->a1 = 0;
    seg->loaded = 0;
    for (int load = 0; load < x->loads; load++)
        for (int power = 0; power < THUD_POINTS; power++) {
            thud_taylor_load(state->model, seg,
                             !state->model->couples ? ones : state->model->jacobian + (size_t)load * n, power);
            for (int j = 0; j < x->nmodes; j++, table += 2 * THUD_BATCH) {
                thud_nodes_values(&x->nodes, seg->q + j, x->nmodes, seg->terms, table);
                thud_nodes_rates(&x->nodes, seg->q + j, x->nmodes, seg->terms, h, table + THUD_BATCH);
            }
        }
    free(ones);
    return true;
}

/* Response of contact a to forces of contact b. A force pushes the two apart: indentation falls. */
static bool fill_pair(const struct thud_state *state, struct thud_collocation *x, int level, double h, int a, int b)
{
    size_t n = (size_t)x->nmodes;
    if (!x->modal[level] && !fill_modal(state, x, level, h))
        return false;
    struct thud_response *r = &x->pair[level][a * x->nc + b];
    double *block = allocate(2 * THUD_BLOCK, sizeof *block);
    if (!block)
        return false;
    r->indentation = block;
    r->rate = block + THUD_BLOCK;
    const bool couples = state->model->couples;
    const double *ga = state->model->jacobian + (size_t)a * n, *gb = state->model->jacobian + (size_t)b * n;
    const double *table = x->modal[level] + (couples ? (size_t)b * THUD_POINTS * n * 2 * THUD_BATCH : 0);
    for (int power = 0; power < THUD_POINTS; power++) {
        struct thud_batch d = {0}, v = {0};
        double moved[2 * THUD_BATCH];
        for (size_t j = 0; j < n; j++, table += 2 * THUD_BATCH) {
            double w = couples ? -ga[j] : -ga[j] * gb[j];
            thud_batch_add(&d, w, table);
            thud_batch_add(&v, w, table + THUD_BATCH);
        }
        thud_batch_put(&d, moved);
        thud_batch_put(&v, moved + THUD_BATCH);
        for (int k = 0; k < THUD_POINTS; k++)
            for (int i = 0; i < THUD_POINTS; i++) {
                r->indentation[k * THUD_BATCH + i] += moved[i] * x->lagrange[power * THUD_POINTS + k];
                r->rate[k * THUD_BATCH + i] += moved[THUD_BATCH + i] * x->lagrange[power * THUD_POINTS + k];
            }
    }
    return true;
}

/* Where modes do not couple, each of two contacts responds to the other in the same way. */
static bool mirror_pair(const struct thud_state *state, struct thud_collocation *x, int level, int a, int b)
{
    const struct thud_response *other = &x->pair[level][b * x->nc + a];
    if (state->model->couples || !other->indentation)
        return false;
    x->pair[level][a * x->nc + b] = *other;
    x->pair[level][a * x->nc + b].shared = true;
    return true;
}

static const struct thud_response *response_of(const struct thud_state *state, struct thud_collocation *x, int level,
                                               double h, int a, int b)
{
    if (!x->pair[level])
        x->pair[level] = allocate((size_t)x->nc * (size_t)x->nc, sizeof(struct thud_response));
    if (!x->pair[level])
        return NULL;
    struct thud_response *r = &x->pair[level][a * x->nc + b];
    return r->indentation || mirror_pair(state, x, level, a, b) || fill_pair(state, x, level, h, a, b) ? r : NULL;
}

/* How far the force polynomials of a step are from the laws. */

/* Scale on which an error of contact a's force counts: the largest force it has had, has now, or will have by its
 * closing velocity. */
static double force_scale(const struct thud_state *state, const struct thud_collocation *x, int a)
{
    int c = x->active[a];
    double scale = state->contact[c].largest_force_n;
    for (int i = 0; i < THUD_POINTS; i++)
        scale = thud_larger(scale, fabs(x->force[a * THUD_BATCH + i]));
    if (state->contact[c].phase == THUD_APPROACH)
        scale = thud_larger(scale, state->contact[c].expected_force_n);
    return thud_larger(scale,
                       state->model->contact[c].setup.mass_kg *
                           thud_larger(THUD_TOL_GROUND_FORCE * state->ground_mps2, THUD_TOL_LEAST_ACCELERATION_MPS2));
}

/* Whether a contact is so young that its force has no smooth past: most of the indentation at the end of the step is
 * made in it, with the speed hardly lost. */
static bool has_just_begun(const double *indentation, int terms)
{
    double end[3];
    thud_poly_value3(indentation, terms, 1, end);
    return indentation[0] < 0.5 * end[0] && end[1] > 0.5 * indentation[1];
}

/* Sizes of what an indentation and a rate are differences of. */
struct sizes {
    double d, v;
};

static struct sizes sizes_of(const struct thud_state *state, int c)
{
    double left, right, left_rate, right_rate;
    thud_model_sides(state->model, c, state->q, &left, &right);
    thud_model_sides(state->model, c, state->qd, &left_rate, &right_rate);
    return (struct sizes){thud_state_clearance(state, c) + fabs(left) + fabs(right),
                          fabs(left_rate) + fabs(right_rate)};
}

/* How far rounding alone may put a force off. */
static double force_noise(const struct sizes *of, double fd, double fv)
{
    return THUD_TOL_STATE * (fabs(fd) * of->d + fabs(fv) * of->v);
}

/* Largest difference between the polynomial of contact a's force and the law, between the points. */
static double force_difference(const struct thud_state *state, struct thud_segment *seg,
                               const struct thud_collocation *x, int c, const double *p, double h)
{
    const struct thud_contact_state *s = &state->contact[c];
    double d[THUD_BATCH], v[THUD_BATCH], f[THUD_BATCH], worst = 0, mass = state->model->contact[c].setup.mass_kg;
    thud_nodes_values(&x->checks, p, 1, seg->terms, d);
    thud_nodes_rates(&x->checks, p, 1, seg->terms, h, v);
    thud_nodes_values(&x->checks, seg->force + c, state->model->nrows, THUD_POINTS, f);
    const struct sizes sizes = sizes_of(state, c);
    for (int i = 0; i < THUD_POINTS;
         i += s->mode == THUD_STICKING ? 1 : 2) { /* a law is dear; the largest is at the start */
        double fd, fv;
        if (s->mode == THUD_STICKING) { /* the force that would undo the rate in one step, but for rounding */
            worst = thud_larger(worst, mass * thud_larger(fabs(v[i]) - THUD_TOL_STICKING_M / h, 0) / h);
            continue;
        }
        double difference = fabs(thud_branch_force(&s->branch, d[i], v[i], &fd, &fv) - f[i]);
        if (difference > worst && isfinite(fd))
            difference -= force_noise(&sizes, fd, fv);
        worst = thud_larger(worst, difference);
    }
    return worst;
}

/* Error of contact a's force: the largest difference between its polynomial and the law between the points, over the
 * force scale. Where a force begins without a smooth start (d^(1/4), d^(3/2)) no step is short enough for that; there
 * what counts is the impulse that the difference makes up. */
static double contact_error(const struct thud_state *state, struct thud_segment *seg, const struct thud_collocation *x,
                            int a, double h)
{
    int c = x->active[a];
    const struct thud_contact_state *s = &state->contact[c];
    double *p = seg->indentation + c * THUD_SEGMENT_TERMS, mass = state->model->contact[c].setup.mass_kg;
    thud_segment_contact(state, seg, c);
    if (s->suppressed.indentation > 0)
        p[0] = 0; /* just touched, as the forces at the points take it */
    double difference = force_difference(state, seg, x, c, p, h);
    double error = thud_larger(difference / force_scale(state, x, a) - THUD_TOL_POLYNOMIAL, 0);
    if (s->mode == THUD_CLOSED && s->phase == THUD_APPROACH && has_just_begun(p, seg->terms)) {
        double ground = state->fastest_radps > 0 ? state->ground_mps2 / state->fastest_radps : 0;
        double speed = s->memory.v_imp_mps < 1e-7 * ground ? ground : s->memory.v_imp_mps; /* pushed, or thrown */
        if (speed > 0)
            error = fmin(error, 10 * difference * h / (mass * speed));
    }
    return error;
}

static double error_of_step(const struct thud_state *state, struct thud_segment *seg, const struct thud_collocation *x,
                            double h)
{
    double worst = 0;
    for (int a = 0; a < x->nactive; a++)
        worst = thud_larger(worst, contact_error(state, seg, x, a, h));
    state->work->force_evaluations += x->nactive * (THUD_POINTS + 1) / 2;
    return worst;
}

enum { NEWTON_MAX = 12, ITERATIONS_MAX = 12 };
enum { PATIENCE = 16 };                  /* steps of one size before a longer one is tried */
static const double longest_angle = 1.8; /* a step times the fastest mode: the series' terms are enough for that */
static const double slowest_contraction = 0.3; /* of the Gauss-Seidel sweeps; slower ones are left to Newton's method */

enum thud_status thud_collocation_create(const struct thud_state *state, struct thud_collocation **out,
                                         struct thud_error *err)
{
    const struct thud_model *m = state->model;
    struct thud_collocation *x = *out = allocate(1, sizeof *x);
    if (!x)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    x->nc = m->nrows;
    x->nmodes = m->nmodes;
    x->loads = m->couples ? m->nrows : 1;
    x->h_top = state->grid_dt_s / fmax(1, ceil(state->fastest_radps * state->grid_dt_s / longest_angle));
    x->h = x->h_top;
    x->contraction = slowest_contraction;
    thud_radau_nodes(THUD_POINTS, x->node);
    thud_lagrange_coefficients(THUD_POINTS, x->node, x->lagrange);
    double check[THUD_POINTS];
    for (int i = 0; i < THUD_POINTS; i++)
        check[i] = 0.5 * (x->node[i] + (i > 0 ? x->node[i - 1] : 0));
    thud_nodes_set(&x->nodes, THUD_POINTS, x->node, 1, THUD_SEGMENT_TERMS);
    thud_nodes_set(&x->checks, THUD_POINTS, check, 1, THUD_SEGMENT_TERMS);
    size_t f = THUD_POINTS * (size_t)m->nrows;
    x->last = allocate(f, sizeof(double));
    x->active = allocate((size_t)m->nrows, sizeof(int));
    if (!x->last || !x->active || thud_segment_init(&x->seg, m, err) != THUD_OK) {
        thud_collocation_free(x);
        *out = NULL;
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    return THUD_OK;
}

void thud_collocation_free(struct thud_collocation *x)
{
    if (!x)
        return;
    for (int l = 0; l < THUD_LEVELS; l++) {
        for (int p = 0; x->pair[l] && p < x->nc * x->nc; p++)
            if (!x->pair[l][p].shared)
                free(x->pair[l][p].indentation);
        free(x->pair[l]);
        free(x->modal[l]);
    }
    free(x->last);
    thud_segment_clear(&x->seg);
    free(x->active);
    free(x->force);
    free(x->matrix);
    free(x->pivot);
    free(x);
}

void thud_collocation_committed(struct thud_collocation *x, double s, bool switched, bool touched)
{
    x->has_source = !switched;
    x->source = s;
    x->just_touched = touched;
    if (switched)
        x->contraction = slowest_contraction;
}

/* Room for n active contacts. */
static bool reserve(struct thud_collocation *x, int n)
{
    if (n <= x->capacity)
        return true;
    size_t size = (size_t)n * THUD_BATCH, unknowns = (size_t)n * THUD_POINTS;
    double *block = allocate(5 * size + unknowns + 2 * (size_t)n, sizeof *block),
           *matrix = allocate(unknowns * unknowns, sizeof *matrix);
    lapack_int *pivot = allocate(unknowns, sizeof *pivot);
    if (!block || !matrix || !pivot) {
        free(block);
        free(matrix);
        free(pivot);
        return false;
    }
    free(x->force);
    free(x->matrix);
    free(x->pivot);
    x->force = block;
    x->d0 = block + size;
    x->v0 = block + 2 * size;
    x->d = block + 3 * size;
    x->v = block + 4 * size;
    x->residual = block + 5 * size;
    x->scale = x->residual + unknowns;
    x->change = x->scale + n;
    x->matrix = matrix;
    x->pivot = pivot;
    x->capacity = n;
    return true;
}

/* Indentation and rate of the a-th active contact at the points under all forces: out of what they are without. */
static void respond(const struct thud_collocation *x, const struct thud_response *row, int a)
{
    struct thud_batch d = thud_batch_at(x->d0 + a * THUD_BATCH), v = thud_batch_at(x->v0 + a * THUD_BATCH);
    for (int b = 0; b < x->nactive; b++) {
        const double *by_d = row[x->active[b]].indentation, *by_v = row[x->active[b]].rate;
        for (int j = 0; j < THUD_POINTS; j++) {
            double force = x->force[b * THUD_BATCH + j];
            thud_batch_add(&d, force, by_d + j * THUD_BATCH);
            thud_batch_add(&v, force, by_v + j * THUD_BATCH);
        }
    }
    thud_batch_put(&d, x->d + a * THUD_BATCH);
    thud_batch_put(&v, x->v + a * THUD_BATCH);
}

static void motion_under_forces(const struct thud_collocation *x, int level)
{
    for (int a = 0; a < x->nactive; a++)
        respond(x, x->pair[level] + x->active[a] * x->nc, a);
}

/* Makes the responses of the active contacts to each other at this step size. */
static bool prepare_responses(const struct thud_state *state, struct thud_collocation *x, int level, double h)
{
    for (int a = 0; a < x->nactive; a++)
        for (int b = 0; b < x->nactive; b++)
            if (!response_of(state, x, level, h, x->active[a], x->active[b]))
                return false;
    return true;
}

/* Residual of the force equations and their derivative by the forces (column-major). */
static void linearize(const struct thud_state *state, struct thud_collocation *x, int level)
{
    int n = x->nactive * THUD_POINTS;
    for (int a = 0; a < x->nactive; a++) {
        const struct thud_contact_state *s = &state->contact[x->active[a]];
        for (int i = 0; i < THUD_POINTS; i++) {
            int row = a * THUD_POINTS + i, at = a * THUD_BATCH + i;
            double fd = 0, fv = -1, own = 0;
            if (s->mode == THUD_STICKING) {
                x->residual[row] = x->v[at];
            } else {
                own = 1;
                x->residual[row] = x->force[at] - thud_branch_force(&s->branch, x->d[at], x->v[at], &fd, &fv);
            }
            for (int b = 0; b < x->nactive; b++) {
                const struct thud_response *r = &x->pair[level][x->active[a] * x->nc + x->active[b]];
                double *column = x->matrix + (size_t)(b * THUD_POINTS) * (size_t)n + row;
                for (int j = 0; j < THUD_POINTS; j++, column += n)
                    *column = -fd * r->indentation[j * THUD_BATCH + i] - fv * r->rate[j * THUD_BATCH + i];
            }
            x->matrix[(size_t)row * (size_t)n + (size_t)row] += own;
        }
    }
    state->work->force_evaluations += n;
}

/* By how much the force of the a-th active contact at point j is off: the law's along the motion under the last forces,
 * and by how much that moves with the force itself. */
static double correction(const struct thud_state *state, const struct thud_collocation *x, int level, int a, int j)
{
    int c = x->active[a], at = a * THUD_BATCH + j, own = j * THUD_BATCH + j;
    const struct thud_response *self = &x->pair[level][c * x->nc + c];
    double fd, fv, force = thud_branch_force(&state->contact[c].branch, x->d[at], x->v[at], &fd, &fv);
    double slope = 1 - fd * self->indentation[own] - fv * self->rate[own];
    return (force - x->force[at]) / (isfinite(slope) ? slope : 1);
}

/* All contacts at all points feel the changes of the forces at point j. */
static void spread(struct thud_collocation *x, int level, int j)
{
    for (int b = 0; b < x->nactive; b++) {
        const struct thud_response *row = x->pair[level] + x->active[b] * x->nc;
        struct thud_batch d = thud_batch_at(x->d + b * THUD_BATCH), v = thud_batch_at(x->v + b * THUD_BATCH);
        for (int a = 0; a < x->nactive; a++) {
            thud_batch_add(&d, x->change[a], row[x->active[a]].indentation + j * THUD_BATCH);
            thud_batch_add(&v, x->change[a], row[x->active[a]].rate + j * THUD_BATCH);
        }
        thud_batch_put(&d, x->d + b * THUD_BATCH);
        thud_batch_put(&v, x->v + b * THUD_BATCH);
    }
}

/* One Gauss-Seidel sweep over the nodes of the step, earliest first. Returns the largest change of a force, over the
 * force scale. */
static double renew_forces(const struct thud_state *state, struct thud_collocation *x, int level)
{
    double most = 0;
    for (int j = 0; j < THUD_POINTS; j++) {
        for (int a = 0; a < x->nactive; a++) {
            x->change[a] = correction(state, x, level, a, j);
            x->force[a * THUD_BATCH + j] += x->change[a];
            most = thud_larger(most, fabs(x->change[a]) / x->scale[a]);
        }
        spread(x, level, j);
    }
    state->work->force_evaluations += x->nactive * THUD_POINTS;
    return most;
}

/* Iteration for the forces: cheap, and fast where contacts are soft on the scale of the step, as what acts later hardly
 * shows in what was before. What is left after an iteration is its change times the contraction, which is known from
 * the step before; should it be worse, the error of the step shows it. */
static bool iterate(const struct thud_state *state, struct thud_collocation *x, int level, double tolerance)
{
    double before = 0;
    for (int a = 0; a < x->nactive; a++) {
        if (state->contact[x->active[a]].mode == THUD_STICKING)
            return false;
        x->scale[a] = force_scale(state, x, a);
    }
    motion_under_forces(x, level);
    for (int iteration = 0; iteration < ITERATIONS_MAX; iteration++) {
        double change = renew_forces(state, x, level);
        if (iteration > 0)
            x->contraction = fmin(slowest_contraction, 4 * change / before);
        if (change * x->contraction <= tolerance) {
            if (iteration == 0) /* not measured this time */
                x->contraction = fmin(slowest_contraction, 2 * x->contraction);
            return true;
        }
        if (iteration > 0 && !(change < slowest_contraction * before))
            return false;
        before = change;
    }
    return false;
}

/* Newton's method for the forces. */
static bool solve(const struct thud_state *state, struct thud_collocation *x, int level, double tolerance)
{
    int n = x->nactive * THUD_POINTS;
    double before = INFINITY;
    for (int iteration = 0; iteration < NEWTON_MAX; iteration++) {
        motion_under_forces(x, level);
        linearize(state, x, level);
        if (LAPACKE_dgesv_work(LAPACK_COL_MAJOR, n, 1, x->matrix, n, x->pivot, x->residual, n) != 0)
            return false;
        double change = 0;
        for (int a = 0; a < x->nactive; a++) {
            double scale = force_scale(state, x, a);
            for (int i = 0; i < THUD_POINTS; i++) {
                x->force[a * THUD_BATCH + i] -= x->residual[a * THUD_POINTS + i];
                change = thud_larger(change, fabs(x->residual[a * THUD_POINTS + i]) / scale);
            }
        }
        if (!isfinite(change))
            return false;
        if (change <= tolerance ||
            (change < THUD_TOL_COLLOCATION_STALL && change >= 0.5 * before)) /* or no better for rounding */
            return true;
        before = change;
    }
    return false;
}

/* First guess: the forces of the last segment go on; after a switch, or where the last segment was a sliver before a kink
 * of the ground motion, the force as it is now, with the indentation going on at its rate. */
static void guess(const struct thud_state *state, struct thud_collocation *x, double h)
{
    static const double farthest = 32; /* times the last segment: its sixth power is 1e9 */
    x->has_source = x->has_source && h <= farthest * x->last_h;
    if (!x->has_source)
        thud_contact_forces(state, state->force_now);
    for (int a = 0; a < x->nactive; a++) {
        int c = x->active[a];
        const struct thud_contact_state *s = &state->contact[c];
        bool deeper = s->mode == THUD_CLOSED && s->phase == THUD_APPROACH;
        double d = thud_contact_indentation(state, c), v = thud_contact_rate(state, c);
        for (int i = 0; i < THUD_POINTS; i++) {
            double f = 0, at = x->source + x->node[i] * h / x->last_h;
            if (x->has_source) {
                for (int k = THUD_POINTS - 1; k >= 0; k--)
                    f = f * at + x->last[k * x->nc + c];
            } else {
                f = state->force_now[c];
                if (deeper)
                    f = thud_larger(f,
                                    0.5 * thud_branch_force(&s->branch, d + 0.5 * v * h * x->node[i], v, NULL, NULL));
            }
            x->force[a * THUD_BATCH + i] = f;
        }
    }
}

static void write_segment(const struct thud_state *state, struct thud_segment *seg, struct thud_collocation *x,
                          double h)
{
    const struct thud_model *m = state->model;
    begin_segment(state, seg, h);
    seg->loaded = THUD_POINTS;
    for (int a = 0; a < x->nactive; a++)
        for (int p = 0; p < THUD_POINTS; p++) {
            double f = 0;
            for (int i = 0; i < THUD_POINTS; i++)
                f += x->lagrange[p * THUD_POINTS + i] * x->force[a * THUD_BATCH + i];
            seg->force[p * m->nrows + x->active[a]] = f;
        }
    memcpy(x->last, seg->force, THUD_POINTS * (size_t)x->nc * sizeof *x->last);
    x->last_h = h;
    thud_taylor_given(m, seg, state->q, state->qd);
}

static void find_active(const struct thud_state *state, struct thud_collocation *x)
{
    x->nactive = 0;
    for (int c = 0; c < x->nc; c++)
        if (thud_contact_acts(&state->contact[c]))
            x->active[x->nactive++] = c;
}

/* Smallest level whose step is at most `want`, but no shorter than needed to reach the next kink. */
static int level_for(const struct thud_collocation *x, double want, double remaining)
{
    int level = 0;
    double h = x->h_top;
    while (level + 1 < THUD_LEVELS && (h > want || 0.5 * h >= remaining)) {
        h *= 0.5;
        level++;
    }
    return level;
}

static enum thud_status too_short(const struct thud_state *state, const struct thud_collocation *x,
                                  struct thud_error *err)
{
    int sticking = 0;
    for (int a = 0; a < x->nactive; a++)
        sticking += state->contact[x->active[a]].mode == THUD_STICKING;
    if (sticking > 1 && state->model->left_out > 0) /* all modes tell any floors apart */
        return thud_state_too_few_modes(state, err);
    return thud_error_set(err, THUD_DIVERGED, "no step is short enough for the contact forces at t = %.6g s",
                          thud_state_now(state));
}

enum thud_status thud_collocation_step(const struct thud_state *state, struct thud_segment *seg,
                                       struct thud_collocation *x, struct thud_error *err)
{
    find_active(state, x);
    if (!reserve(x, x->nactive))
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    double tolerance = thud_larger(0.1 * state->tolerance, THUD_TOL_COLLOCATION),
           remaining = thud_state_remaining(state);
    bool first = x->just_touched;
    if (first && x->h_touch > 0)
        x->h = fmin(x->h, x->h_touch);
    if (++x->steady > PATIENCE) { /* where contacts are stiff, the error of a longer step may be the smaller one */
        x->h *= 2;
        x->steady = 0;
    }
    double before = INFINITY;
    for (int same = 0;;) {
        int level = level_for(x, x->h, remaining);
        double want = x->h, h = ldexp(x->h_top, -level), error = INFINITY;
        if (!prepare_responses(state, x, level, h))
            return thud_error_set(err, THUD_MEMORY, "out of memory");
        fill_unforced(state, x, h);
        guess(state, x, h);
        bool converged = iterate(state, x, level, 1e-2 * tolerance) || solve(state, x, level, 1e-2 * tolerance);
        x->has_source = x->has_source && !converged;
        if (converged) {
            write_segment(state, seg, x, h);
            x->has_source = true; /* should it be too long, a shorter one begins with these forces */
            x->source = 0;
            error = error_of_step(state, seg, x, h);
        }
        double factor =
            isfinite(error) ? 0.85 * pow(tolerance / thud_larger(error, 1e-5 * tolerance), 1.0 / THUD_POINTS) : 0.25;
        x->h = h * fmin(4, thud_larger(0.1, factor));
        same = error > 0.95 * before && error <= 100 * tolerance ? same + 1 : 0;
        before = error;
        if (same >= 2) /* no shorter step would have less of it: rounding, of rates where a contact is stiff */
            x->h = 4 * h;
        if (error <= tolerance || same >= 2) {
            if (level > 0 && 2 * h <= want) /* only short because the next kink is near */
                x->h = thud_larger(x->h, want);
            if (first)
                x->h_touch = x->h;
            if (x->h >= 2 * h)
                x->steady = 0;
            return THUD_OK;
        }
        x->h = fmin(x->h, 0.5 * h);
        state->work->rejected++;
        if (level + 1 >= THUD_LEVELS)
            return too_short(state, x, err);
    }
}
