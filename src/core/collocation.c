#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/collocation_private.h"
#include "core/largest.h"
#include "core/radau.h"
#include "core/tolerance.h"

enum { NEWTON_MAX = 12, ITERATIONS_MAX = 12 };
enum { PATIENCE = 16 };                  /* steps of one size before a longer one is tried */
static const double longest_angle = 1.8; /* a step times the fastest mode: the series' terms are enough for that */
static const double slowest_contraction = 0.3; /* of the Gauss-Seidel sweeps; slower ones are left to Newton's method */

enum thud_status thud_collocation_create(const struct thud_state *state, struct thud_collocation **out,
                                         struct thud_error *err)
{
    const struct thud_model *m = state->model;
    struct thud_collocation *x = *out = thud_collocation_allocate(1, sizeof *x);
    if (!x)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    x->nc = m->ncontacts;
    x->nmodes = m->nmodes;
    x->loads = m->couples ? m->ncontacts : 1;
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
    size_t f = THUD_POINTS * (size_t)m->ncontacts;
    x->seg_block = thud_collocation_allocate(2 * THUD_BATCH * (size_t)m->nmodes + f, sizeof(double));
    x->active = thud_collocation_allocate((size_t)m->ncontacts, sizeof(int));
    if (!x->seg_block || !x->active || thud_segment_init(&x->seg, m, err) != THUD_OK) {
        thud_collocation_free(x);
        *out = NULL;
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    x->last = x->seg_block;
    x->moved = x->last + f;
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
        free(x->unforced[l]);
    }
    free(x->seg_block);
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
    double *block = thud_collocation_allocate(5 * size + unknowns + 2 * (size_t)n, sizeof *block),
           *matrix = thud_collocation_allocate(unknowns * unknowns, sizeof *matrix);
    lapack_int *pivot = thud_collocation_allocate(unknowns, sizeof *pivot);
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
            if (!thud_collocation_response(state, x, level, h, x->active[a], x->active[b]))
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
        x->scale[a] = thud_collocation_scale(state, x, a);
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
            double scale = thud_collocation_scale(state, x, a);
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

/* First guess: the forces of the last segment go on; after a switch, the force as it is now, with the indentation going
 * on at its rate. */
static void guess(const struct thud_state *state, struct thud_collocation *x, double h)
{
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
    thud_collocation_begin(state, seg, h);
    seg->loaded = THUD_POINTS;
    for (int a = 0; a < x->nactive; a++)
        for (int p = 0; p < THUD_POINTS; p++) {
            double f = 0;
            for (int i = 0; i < THUD_POINTS; i++)
                f += x->lagrange[p * THUD_POINTS + i] * x->force[a * THUD_BATCH + i];
            seg->force[p * m->ncontacts + x->active[a]] = f;
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
    int stuck = 0;
    for (int a = 0; a < x->nactive; a++)
        stuck += state->contact[x->active[a]].mode == THUD_STICKING;
    if (stuck > 1 && state->model->left_out > 0) /* all modes tell any floors apart */
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
        if (!prepare_responses(state, x, level, h) || !thud_collocation_unforced(state, x, level, h))
            return thud_error_set(err, THUD_MEMORY, "out of memory");
        guess(state, x, h);
        bool converged = iterate(state, x, level, 1e-2 * tolerance) || solve(state, x, level, 1e-2 * tolerance);
        x->has_source = x->has_source && !converged;
        if (converged) {
            write_segment(state, seg, x, h);
            x->has_source = true; /* should it be too long, a shorter one begins with these forces */
            x->source = 0;
            error = thud_collocation_error(state, seg, x, h);
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
