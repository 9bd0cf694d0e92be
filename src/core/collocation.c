#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/collocation_private.h"
#include "core/largest.h"
#include "core/poly.h"
#include "core/radau.h"

enum { NEWTON_MAX = 12, FIXED_POINT_MAX = 12 };

enum thud_status thud_collocation_create(const struct thud_run *run, struct thud_collocation **out,
                                         struct thud_error *err)
{
    const struct thud_model *m = run->model;
    struct thud_collocation *x = *out = thud_collocation_allocate(1, sizeof *x);
    if (!x)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    x->nc = m->ncontacts;
    x->nmodes = m->ndof;
    x->loads = 1;
    for (int s = 0; s < m->nstructures; s++)
        if (m->structure[s].damping)
            x->loads = m->ncontacts;
    x->h_top = run->fastest_radps > 0 ? fmin(run->grid_dt_s, 1.4 / run->fastest_radps) : run->grid_dt_s;
    x->h = x->h_top;
    thud_radau_nodes(THUD_NODES, x->node);
    thud_lagrange_coefficients(THUD_NODES, x->node, x->lagrange);
    for (int i = 0; i < THUD_NODES; i++)
        x->check[i] = 0.5 * (x->node[i] + (i > 0 ? x->node[i - 1] : 0));
    size_t q = (THUD_SEGMENT_TERMS + 1) * (size_t)m->ndof, f = THUD_SEGMENT_TERMS * (size_t)m->ncontacts;
    x->seg_block = thud_collocation_allocate(q + f, sizeof(double));
    x->active = thud_collocation_allocate((size_t)m->ncontacts, sizeof(int));
    if (!x->seg_block || !x->active) {
        thud_collocation_free(x);
        *out = NULL;
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    x->seg.q = x->seg_block;
    x->seg.force = x->seg_block + q;
    return THUD_OK;
}

void thud_collocation_free(struct thud_collocation *x)
{
    if (!x)
        return;
    for (int l = 0; l < THUD_LEVELS; l++) {
        for (int p = 0; x->pair[l] && p < x->nc * x->nc; p++)
            free(x->pair[l][p].indentation);
        free(x->pair[l]);
        free(x->modal[l]);
    }
    free(x->seg_block);
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
}

/* Room for n active contacts. */
static bool reserve(struct thud_collocation *x, int n)
{
    if (n <= x->capacity)
        return true;
    size_t size = (size_t)n * THUD_NODES;
    double *block = thud_collocation_allocate(6 * size, sizeof *block),
           *matrix = thud_collocation_allocate(size * size, sizeof *matrix);
    lapack_int *pivot = thud_collocation_allocate(size, sizeof *pivot);
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
    x->matrix = matrix;
    x->pivot = pivot;
    x->capacity = n;
    return true;
}

/* Indentations and rates at the points if no contact force acted. */
static void free_motion(struct thud_run *run, struct thud_collocation *x, double h)
{
    double p[THUD_SEGMENT_TERMS], v[3];
    thud_segment_begin(run, &x->seg, h);
    thud_taylor_given(run->model, &x->seg, run->q, run->qd);
    for (int a = 0; a < x->nactive; a++) {
        int c = x->active[a];
        thud_segment_indentation(run, &x->seg, c, p);
        if (run->contact[c].zeros.indentation > 0)
            p[0] = 0;
        for (int i = 0; i < THUD_NODES; i++) {
            thud_poly_value3(p, x->seg.terms, x->node[i], v);
            x->d0[a * THUD_NODES + i] = v[0];
            x->v0[a * THUD_NODES + i] = v[1] / h;
        }
    }
}

static bool motion_under_forces(struct thud_run *run, struct thud_collocation *x, int level, double h)
{
    int n = x->nactive * THUD_NODES;
    memcpy(x->d, x->d0, (size_t)n * sizeof *x->d);
    memcpy(x->v, x->v0, (size_t)n * sizeof *x->v);
    for (int a = 0; a < x->nactive; a++)
        for (int b = 0; b < x->nactive; b++) {
            const struct thud_response *r = thud_collocation_response(run, x, level, h, x->active[a], x->active[b]);
            if (!r)
                return false;
            const double *f = x->force + b * THUD_NODES;
            for (int i = 0; i < THUD_NODES; i++)
                for (int j = 0; j < THUD_NODES; j++) {
                    x->d[a * THUD_NODES + i] += r->indentation[i * THUD_NODES + j] * f[j];
                    x->v[a * THUD_NODES + i] += r->rate[i * THUD_NODES + j] * f[j];
                }
        }
    return true;
}

/* Residual of the force equations and their derivative by the forces (column-major). */
static void linearize(struct thud_run *run, struct thud_collocation *x, int level)
{
    int n = x->nactive * THUD_NODES;
    for (int a = 0; a < x->nactive; a++) {
        const struct thud_contact_state *s = &run->contact[x->active[a]];
        for (int i = 0; i < THUD_NODES; i++) {
            int row = a * THUD_NODES + i;
            double fd = 0, fv = -1, own = 0;
            if (s->mode == THUD_STUCK) {
                x->residual[row] = x->v[row];
            } else {
                own = 1;
                x->residual[row] = x->force[row] - thud_branch_force(&s->branch, x->d[row], x->v[row], &fd, &fv);
            }
            for (int b = 0; b < x->nactive; b++) {
                const struct thud_response *r = &x->pair[level][x->active[a] * x->nc + x->active[b]];
                double *column = x->matrix + (size_t)(b * THUD_NODES) * (size_t)n + row;
                for (int j = 0; j < THUD_NODES; j++, column += n)
                    *column = -fd * r->indentation[i * THUD_NODES + j] - fv * r->rate[i * THUD_NODES + j];
            }
            x->matrix[(size_t)row * (size_t)n + (size_t)row] += own;
        }
    }
    run->result.work.force_evaluations += n;
}

/* Fixed-point iteration for the forces: cheap, and fast where contacts are soft on the scale of the step. */
static enum thud_status iterate(struct thud_run *run, struct thud_collocation *x, int level, double h, double tolerance,
                                bool *converged, struct thud_error *err)
{
    double before = INFINITY;
    *converged = false;
    for (int iteration = 0; iteration < FIXED_POINT_MAX; iteration++) {
        double change = 0;
        if (!motion_under_forces(run, x, level, h))
            return thud_error_set(err, THUD_MEMORY, "out of memory");
        for (int a = 0; a < x->nactive; a++) {
            const struct thud_contact_state *s = &run->contact[x->active[a]];
            double worst = 0;
            if (s->mode == THUD_STUCK)
                return THUD_OK;
            for (int i = a * THUD_NODES; i < (a + 1) * THUD_NODES; i++) {
                double f = thud_branch_force(&s->branch, x->d[i], x->v[i], NULL, NULL);
                worst = thud_larger(worst, fabs(f - x->force[i]));
                x->force[i] = f;
            }
            change = thud_larger(change, worst / thud_collocation_scale(run, x, a));
        }
        run->result.work.force_evaluations += x->nactive * THUD_NODES;
        if (change <= tolerance) {
            *converged = true;
            return THUD_OK;
        }
        if (!(change < 0.3 * before) && iteration > 0)
            return THUD_OK;
        before = change;
    }
    return THUD_OK;
}

/* Newton's method for the forces. */
static enum thud_status solve(struct thud_run *run, struct thud_collocation *x, int level, double h, double tolerance,
                              bool *converged, struct thud_error *err)
{
    int n = x->nactive * THUD_NODES;
    *converged = false;
    double before = INFINITY;
    for (int iteration = 0; iteration < NEWTON_MAX; iteration++) {
        if (!motion_under_forces(run, x, level, h))
            return thud_error_set(err, THUD_MEMORY, "out of memory");
        linearize(run, x, level);
        if (LAPACKE_dgesv_work(LAPACK_COL_MAJOR, n, 1, x->matrix, n, x->pivot, x->residual, n) != 0)
            return THUD_OK;
        double change = 0;
        for (int a = 0; a < x->nactive; a++) {
            double scale = thud_collocation_scale(run, x, a);
            for (int i = 0; i < THUD_NODES; i++) {
                x->force[a * THUD_NODES + i] -= x->residual[a * THUD_NODES + i];
                change = thud_larger(change, fabs(x->residual[a * THUD_NODES + i]) / scale);
            }
        }
        if (!isfinite(change))
            return THUD_OK;
        if (change <= tolerance || (change < 1e-7 && change >= 0.5 * before)) { /* or no better for rounding */
            *converged = true;
            return THUD_OK;
        }
        before = change;
    }
    return THUD_OK;
}

/* First guess: the forces of the last segment go on; after a switch, the force as it is now, with the indentation going
 * on at its rate. */
static void guess(struct thud_run *run, struct thud_collocation *x, double h)
{
    const struct thud_segment *seg = &run->seg;
    if (!x->has_source)
        thud_contact_forces(run, run->force_now);
    for (int a = 0; a < x->nactive; a++) {
        int c = x->active[a];
        const struct thud_contact_state *s = &run->contact[c];
        bool deeper = s->mode == THUD_CLOSED && s->phase == THUD_APPROACH;
        double d = thud_contact_indentation(run, c), v = thud_contact_rate(run, c);
        for (int i = 0; i < THUD_NODES; i++) {
            double f = 0, at = x->source + x->node[i] * h / seg->h_s;
            if (x->has_source) {
                for (int k = THUD_NODES - 1; k >= 0; k--)
                    f = f * at + seg->force[k * x->nc + c];
            } else {
                f = run->force_now[c];
                if (deeper)
                    f = thud_larger(f,
                                    0.5 * thud_branch_force(&s->branch, d + 0.5 * v * h * x->node[i], v, NULL, NULL));
            }
            x->force[a * THUD_NODES + i] = f;
        }
    }
}

static void write_segment(struct thud_run *run, struct thud_collocation *x, double h)
{
    const struct thud_model *m = run->model;
    thud_segment_begin(run, &run->seg, h);
    for (int a = 0; a < x->nactive; a++)
        for (int p = 0; p < THUD_NODES; p++) {
            double f = 0;
            for (int i = 0; i < THUD_NODES; i++)
                f += x->lagrange[p * THUD_NODES + i] * x->force[a * THUD_NODES + i];
            run->seg.force[p * m->ncontacts + x->active[a]] = f;
        }
    thud_taylor_given(m, &run->seg, run->q, run->qd);
}

static void find_active(const struct thud_run *run, struct thud_collocation *x)
{
    x->nactive = 0;
    for (int c = 0; c < x->nc; c++)
        if (thud_contact_acts(&run->contact[c]))
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

enum thud_status thud_collocation_step(struct thud_run *run, struct thud_collocation *x, struct thud_error *err)
{
    find_active(run, x);
    if (!reserve(x, x->nactive))
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    /* the polynomials through the points carry no more than eleven digits */
    double tolerance = thud_larger(0.1 * run->options.tolerance, 6e-11), remaining = thud_run_remaining(run);
    bool first = x->just_touched;
    if (first && x->h_touch > 0)
        x->h = fmin(x->h, x->h_touch);
    for (;;) {
        int level = level_for(x, x->h, remaining);
        double h = ldexp(x->h_top, -level), error = INFINITY;
        bool converged;
        free_motion(run, x, h);
        guess(run, x, h);
        enum thud_status status = iterate(run, x, level, h, 1e-2 * tolerance, &converged, err);
        if (status == THUD_OK && !converged)
            status = solve(run, x, level, h, 1e-2 * tolerance, &converged, err);
        if (status != THUD_OK)
            return status;
        x->has_source = x->has_source && !converged;
        if (converged) {
            write_segment(run, x, h);
            x->has_source = true; /* should it be too long, a shorter one begins with these forces */
            x->source = 0;
            error = thud_collocation_error(run, x, h);
        }
        double factor =
            isfinite(error) ? 0.85 * pow(tolerance / thud_larger(error, 1e-3 * tolerance), 1.0 / THUD_NODES) : 0.25;
        x->h = h * fmin(4, thud_larger(0.1, factor));
        if (error <= tolerance) {
            if (first)
                x->h_touch = x->h;
            return THUD_OK;
        }
        x->h = fmin(x->h, 0.5 * h);
        run->result.work.rejected++;
        if (level + 1 >= THUD_LEVELS)
            return thud_error_set(err, THUD_DIVERGED, "no step is short enough for the contact forces at t = %.6g s",
                                  thud_run_now(run));
    }
}
