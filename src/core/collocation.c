#include "core/collocation.h"

#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/largest.h"
#include "core/poly.h"
#include "core/radau.h"
#include "core/run_private.h"

enum { NODES = 7, LEVELS = 48, NEWTON_MAX = 12, FIXED_POINT_MAX = 12, BLOCK = NODES * NODES };

/* Indentation and rate at point i from the force at point j of another contact, per step size: blocks (NODES x NODES),
 * made when first needed. */
struct response {
    double *indentation, *rate;
};

struct thud_collocation {
    double node[NODES], lagrange[BLOCK], check[NODES];
    double h_top; /* step of level 0 */
    double h, h_touch;
    bool just_touched;
    bool has_source; /* run->seg holds forces that go on into this step, from s = source on */
    double source;
    int nc, nmodes, loads; /* loads: 1 where modes are uncoupled, else one per contact */
    double *modal[LEVELS]; /* (loads x NODES x NODES x 2 x nmodes): q and h q' of each mode by load, power and point */
    struct response *pair[LEVELS]; /* (nc x nc) */
    struct thud_segment seg;       /* of unit loads, and of the motion without contact forces */
    double *seg_block;
    /* The system: unknowns are the forces of the active contacts at the points */
    int *active; /* (nc) */
    int nactive, capacity;
    double *force, *d0, *v0, *d, *v, *residual, *matrix, *previous; /* (nactive x NODES); matrix square */
    lapack_int *pivot;
};

static void *allocate(size_t count, size_t size)
{
    return calloc(count ? count : 1, size);
}

enum thud_status thud_collocation_create(const struct thud_run *run, struct thud_collocation **out,
                                         struct thud_error *err)
{
    const struct thud_model *m = run->model;
    struct thud_collocation *x = *out = allocate(1, sizeof *x);
    if (!x)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    x->nc = m->ncontacts;
    x->nmodes = m->ndof;
    x->loads = 1;
    double fastest = 0;
    for (int j = 0; j < m->ndof; j++)
        fastest = thud_larger(fastest, m->omega[j]);
    for (int s = 0; s < m->nstructures; s++)
        if (m->structure[s].damping)
            x->loads = m->ncontacts;
    x->h_top = fastest > 0 ? fmin(run->grid_dt_s, 1.4 / fastest) : run->grid_dt_s;
    x->h = x->h_top;
    thud_radau_nodes(NODES, x->node);
    thud_lagrange_coefficients(NODES, x->node, x->lagrange);
    for (int i = 0; i < NODES; i++)
        x->check[i] = 0.5 * (x->node[i] + (i > 0 ? x->node[i - 1] : 0));
    size_t q = (THUD_SEGMENT_TERMS + 1) * (size_t)m->ndof, f = THUD_SEGMENT_TERMS * (size_t)m->ncontacts;
    x->seg_block = allocate(q + f, sizeof(double));
    x->active = allocate((size_t)m->ncontacts, sizeof(int));
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
    for (int l = 0; l < LEVELS; l++) {
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
    size_t size = (size_t)n * NODES;
    double *block = allocate(7 * size, sizeof *block), *matrix = allocate(size * size, sizeof *matrix);
    lapack_int *pivot = allocate(size, sizeof *pivot);
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
    x->previous = block + 6 * size;
    x->matrix = matrix;
    x->pivot = pivot;
    x->capacity = n;
    return true;
}

/* Motion of every mode at the points under unit loads s^power. */
static bool fill_modal(const struct thud_run *run, struct thud_collocation *x, int level, double h)
{
    size_t n = (size_t)x->nmodes;
    double *table = allocate((size_t)x->loads * BLOCK * 2 * n, sizeof *table), *ones = allocate(n, sizeof *ones);
    x->modal[level] = table;
    if (!table || !ones) {
        free(ones);
        return false;
    }
    for (size_t j = 0; j < n; j++)
        ones[j] = 1;
    x->seg.terms = THUD_SEGMENT_TERMS;
    x->seg.h_s = h;
    x->seg.a0 = x->seg.a1 = 0;
    memset(x->seg.force, 0, THUD_SEGMENT_TERMS * (size_t)x->nc * sizeof(double));
    for (int load = 0; load < x->loads; load++)
        for (int power = 0; power < NODES; power++) {
            thud_taylor_load(run->model, &x->seg, x->loads == 1 ? ones : run->model->g + (size_t)load * n, power);
            for (int i = 0; i < NODES; i++, table += 2 * n)
                thud_segment_state(&x->seg, x->nmodes, x->node[i], table, table + n);
        }
    free(ones);
    return true;
}

/* Response of contact a to forces of contact b. A force pushes the two apart: indentation falls. */
static bool fill_pair(const struct thud_run *run, struct thud_collocation *x, int level, double h, int a, int b)
{
    size_t n = (size_t)x->nmodes;
    if (!x->modal[level] && !fill_modal(run, x, level, h))
        return false;
    struct response *r = &x->pair[level][a * x->nc + b];
    double *block = allocate(2 * BLOCK, sizeof *block);
    if (!block)
        return false;
    r->indentation = block;
    r->rate = block + BLOCK;
    const double *ga = run->model->g + (size_t)a * n, *gb = run->model->g + (size_t)b * n;
    const double *table = x->modal[level] + (x->loads == 1 ? 0 : (size_t)b * BLOCK * 2 * n);
    for (int power = 0; power < NODES; power++)
        for (int i = 0; i < NODES; i++, table += 2 * n) {
            double d = 0, v = 0;
            for (size_t j = 0; j < n; j++) {
                double w = x->loads == 1 ? ga[j] * gb[j] : ga[j];
                d -= w * table[j];
                v -= w * table[n + j];
            }
            for (int k = 0; k < NODES; k++) {
                r->indentation[i * NODES + k] += d * x->lagrange[power * NODES + k];
                r->rate[i * NODES + k] += v * x->lagrange[power * NODES + k];
            }
        }
    return true;
}

static const struct response *response(const struct thud_run *run, struct thud_collocation *x, int level, double h,
                                       int a, int b)
{
    if (!x->pair[level])
        x->pair[level] = allocate((size_t)x->nc * (size_t)x->nc, sizeof(struct response));
    if (!x->pair[level])
        return NULL;
    struct response *r = &x->pair[level][a * x->nc + b];
    return r->indentation || fill_pair(run, x, level, h, a, b) ? r : NULL;
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
        for (int i = 0; i < NODES; i++) {
            thud_poly_value3(p, x->seg.terms, x->node[i], v);
            x->d0[a * NODES + i] = v[0];
            x->v0[a * NODES + i] = v[1] / h;
        }
    }
}

static bool motion_under_forces(struct thud_run *run, struct thud_collocation *x, int level, double h)
{
    int n = x->nactive * NODES;
    memcpy(x->d, x->d0, (size_t)n * sizeof *x->d);
    memcpy(x->v, x->v0, (size_t)n * sizeof *x->v);
    for (int a = 0; a < x->nactive; a++)
        for (int b = 0; b < x->nactive; b++) {
            const struct response *r = response(run, x, level, h, x->active[a], x->active[b]);
            if (!r)
                return false;
            const double *f = x->force + b * NODES;
            for (int i = 0; i < NODES; i++)
                for (int j = 0; j < NODES; j++) {
                    x->d[a * NODES + i] += r->indentation[i * NODES + j] * f[j];
                    x->v[a * NODES + i] += r->rate[i * NODES + j] * f[j];
                }
        }
    return true;
}

/* Residual of the force equations and their derivative by the forces (column-major). */
static void linearize(struct thud_run *run, struct thud_collocation *x, int level)
{
    int n = x->nactive * NODES;
    for (int a = 0; a < x->nactive; a++) {
        const struct thud_contact_state *s = &run->contact[x->active[a]];
        for (int i = 0; i < NODES; i++) {
            int row = a * NODES + i;
            double fd = 0, fv = -1, own = 0;
            if (s->mode == THUD_STUCK) {
                x->residual[row] = x->v[row];
            } else {
                own = 1;
                x->residual[row] = x->force[row] - thud_branch_force(&s->branch, x->d[row], x->v[row], &fd, &fv);
            }
            for (int b = 0; b < x->nactive; b++) {
                const struct response *r = &x->pair[level][x->active[a] * x->nc + x->active[b]];
                double *column = x->matrix + (size_t)(b * NODES) * (size_t)n + row;
                for (int j = 0; j < NODES; j++, column += n)
                    *column = -fd * r->indentation[i * NODES + j] - fv * r->rate[i * NODES + j];
            }
            x->matrix[(size_t)row * (size_t)n + (size_t)row] += own;
        }
    }
    run->result.work.force_evaluations += n;
}

/* Scale on which an error of contact a's force counts: the largest force it has had, has now, or will have by its
 * closing velocity. */
static double force_scale(const struct thud_run *run, const struct thud_collocation *x, int a)
{
    int c = x->active[a];
    double scale = run->result.contact[c].force.value;
    for (int i = 0; i < NODES; i++)
        scale = thud_larger(scale, fabs(x->force[a * NODES + i]));
    if (run->contact[c].phase == THUD_APPROACH)
        scale = thud_larger(scale, run->contact[c].expected_force_n);
    return thud_larger(scale, run->model->contact[c].setup.mass_kg * thud_larger(1e-6 * run->ground_mps2, 1e-9));
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
            for (int i = a * NODES; i < (a + 1) * NODES; i++) {
                double f = thud_branch_force(&s->branch, x->d[i], x->v[i], NULL, NULL);
                worst = thud_larger(worst, fabs(f - x->force[i]));
                x->force[i] = f;
            }
            change = thud_larger(change, worst / force_scale(run, x, a));
        }
        run->result.work.force_evaluations += x->nactive * NODES;
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
    int n = x->nactive * NODES;
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
            double scale = force_scale(run, x, a);
            for (int i = 0; i < NODES; i++) {
                x->force[a * NODES + i] -= x->residual[a * NODES + i];
                change = thud_larger(change, fabs(x->residual[a * NODES + i]) / scale);
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
        for (int i = 0; i < NODES; i++) {
            double f = 0, at = x->source + x->node[i] * h / seg->h_s;
            if (x->has_source) {
                for (int k = NODES - 1; k >= 0; k--)
                    f = f * at + seg->force[k * x->nc + c];
            } else {
                f = run->force_now[c];
                if (deeper)
                    f = thud_larger(f,
                                    0.5 * thud_branch_force(&s->branch, d + 0.5 * v * h * x->node[i], v, NULL, NULL));
            }
            x->force[a * NODES + i] = f;
        }
    }
}

static void write_segment(struct thud_run *run, struct thud_collocation *x, double h)
{
    const struct thud_model *m = run->model;
    thud_segment_begin(run, &run->seg, h);
    for (int a = 0; a < x->nactive; a++)
        for (int p = 0; p < NODES; p++) {
            double f = 0;
            for (int i = 0; i < NODES; i++)
                f += x->lagrange[p * NODES + i] * x->force[a * NODES + i];
            run->seg.force[p * m->ncontacts + x->active[a]] = f;
        }
    thud_taylor_given(m, &run->seg, run->q, run->qd);
}

/* Whether a contact is so young that its force has no smooth past: most of the indentation at the end of the step is
 * made in it, with the speed hardly lost. */
static bool has_just_begun(const double *indentation, int terms)
{
    double start[3], end[3];
    thud_poly_value3(indentation, terms, 0, start);
    thud_poly_value3(indentation, terms, 1, end);
    return start[0] < 0.5 * end[0] && end[1] > 0.5 * start[1];
}

/* How far rounding alone may put a force off: indentation and rate are differences of the floors' own. */
static double force_noise(const struct thud_run *run, int c, double fd, double fv)
{
    static const double part = 2e-15;
    const struct thud_model_contact *p = &run->model->contact[c];
    double d = thud_run_shift(run, c), v = 0;
    for (int side = 0; side < 2; side++) {
        int dof = side == 0 ? p->left_dof : p->right_dof;
        d += dof < 0 ? 0 : fabs(thud_model_floor(run->model, dof, run->q));
        v += dof < 0 ? 0 : fabs(thud_model_floor(run->model, dof, run->qd));
    }
    return part * (fabs(fd) * d + fabs(fv) * v);
}

/* Largest difference between the polynomial of contact a's force and the law, between the points. */
static double force_difference(struct thud_run *run, const struct thud_collocation *x, int c, const double *p, double h)
{
    const struct thud_contact_state *s = &run->contact[c];
    double v[3], worst = 0, mass = run->model->contact[c].setup.mass_kg;
    for (int i = 0; i < NODES; i++) {
        double f = 0, fd, fv;
        thud_poly_value3(p, run->seg.terms, x->check[i], v);
        for (int k = NODES - 1; k >= 0; k--)
            f = f * x->check[i] + run->seg.force[k * run->model->ncontacts + c];
        if (s->mode == THUD_STUCK) { /* the force that would undo the rate in one step, but for rounding */
            worst = thud_larger(worst, mass * thud_larger(fabs(v[1]) - 1e-15, 0) / (h * h));
            continue;
        }
        double difference = fabs(thud_branch_force(&s->branch, v[0], v[1] / h, &fd, &fv) - f);
        if (difference > worst && isfinite(fd))
            difference -= force_noise(run, c, fd, fv);
        worst = thud_larger(worst, difference);
    }
    return worst;
}

/* Error of contact a's force: the largest difference between its polynomial and the law between the points, over the
 * force scale. Where a force begins without a smooth start (d^(1/4), d^(3/2)) no step is short enough for that; there
 * what counts is the impulse that the difference makes up. */
static double contact_error(struct thud_run *run, const struct thud_collocation *x, int a, double h)
{
    int c = x->active[a];
    const struct thud_contact_state *s = &run->contact[c];
    double p[THUD_SEGMENT_TERMS], mass = run->model->contact[c].setup.mass_kg;
    thud_segment_indentation(run, &run->seg, c, p);
    double difference = force_difference(run, x, c, p, h);
    double error = difference / force_scale(run, x, a);
    if (s->mode == THUD_CLOSED && s->phase == THUD_APPROACH && has_just_begun(p, run->seg.terms)) {
        double ground = run->fastest_radps > 0 ? run->ground_mps2 / run->fastest_radps : 0;
        double speed = s->memory.v_imp_mps < 1e-7 * ground ? ground : s->memory.v_imp_mps; /* pushed, or thrown */
        if (speed > 0)
            error = fmin(error, 10 * difference * h / (mass * speed));
    }
    return error;
}

static double force_error(struct thud_run *run, const struct thud_collocation *x, double h)
{
    double worst = 0;
    for (int a = 0; a < x->nactive; a++)
        worst = thud_larger(worst, contact_error(run, x, a, h));
    run->result.work.force_evaluations += x->nactive * NODES;
    return worst;
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
    while (level + 1 < LEVELS && (h > want || 0.5 * h >= remaining)) {
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
            error = force_error(run, x, h);
        }
        double factor =
            isfinite(error) ? 0.85 * pow(tolerance / thud_larger(error, 1e-3 * tolerance), 1.0 / NODES) : 0.25;
        x->h = h * fmin(4, thud_larger(0.1, factor));
        if (error <= tolerance) {
            if (first)
                x->h_touch = x->h;
            return THUD_OK;
        }
        x->h = fmin(x->h, 0.5 * h);
        run->result.work.rejected++;
        if (level + 1 >= LEVELS)
            return thud_error_set(err, THUD_DIVERGED, "no step is short enough for the contact forces at t = %.6g s",
                                  thud_run_now(run));
    }
}
