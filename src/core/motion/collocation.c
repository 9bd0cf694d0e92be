#include "core/motion/collocation.h"

#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/largest.h"
#include "core/motion/nodes.h"
#include "core/motion/response.h"
#include "core/numerics/poly.h"
#include "core/numerics/radau.h"
#include "core/numerics/tolerance.h"

/* Glossary, for one step of length h from the state at t0; a, b are active contacts, i, j points of the step.
 *
 *     s_i            points in [0, 1]: the NODES Radau points first, then the points where the error is measured
 *     F_b(s_j)       x->force, unknown at the nodes; between them the polynomial of degree NODES - 1 through them
 *     d0_a, v0_a     x->d0, x->v0: indentation and rate without the forces of the active contacts
 *     R_ab,ij        x->response: d_a(s_i) by F_b(s_j), below 0 where the force pushes apart; R' of v_a(s_i)
 *     d_a, v_a       x->d, x->v = d0 + R F, v0 + R' F
 *     law_a          x->law, at (d_a, v_a); law_d, law_v its derivatives
 *     level l        h = h_top/2^l, so that R is made once for each size that occurs
 *     contraction    by which a Gauss-Seidel sweep reduces the change of the forces
 *     x->h           size asked for next; h_onset: that of the last step that began at an onset
 *
 * The equations are F_a(s_i) = law_a(d_a(s_i), v_a(s_i)), and v_a(s_i) = 0 where a sticks. */
enum { NODES = THUD_NODES, LEVELS = 48 };
enum { LAST = THUD_POINTS - THUD_BATCH }; /* a batch that ends with the last point begins here */
enum { NEWTON_MAX = 12, ITERATIONS_MAX = 12 };
enum { PATIENCE = 16 };                  /* steps of one size before a longer one is tried */
enum { REPEATS = 2 };                    /* shorter steps with no smaller error: it is rounding */
static const double longest_angle = 1.8; /* a step times the fastest mode: the series' terms are enough for that */
static const double slowest_contraction = 0.3; /* of the Gauss-Seidel sweeps; slower ones are left to Newton's method */
static const double step_part = 0.1;           /* of the run's tolerance, for the error of a step */
static const double solution_part = 1e-2;      /* of that, for the solution of the equations */
static const double safety = 0.85, unsolved = 0.25, most_growth = 4, most_shrink = 0.1; /* factors of the step size */
static const double least_error = 1e-5; /* of the tolerance: below it the error says nothing of the next step */
static const double same_error = 0.95, near_tolerance = 100;

/* A step: the forces as polynomials over h from the state that it began at, valid across kinks of the ground motion. The
 * run takes it piece by piece, up to one kink or event at a time. */
struct step {
    bool goes_on;        /* nothing has switched since, and something is left of it */
    double h, done_s;    /* length, and how far the state has come since its start */
    double *coefficient; /* (nc x THUD_BATCH) by order */
    struct branch_name { /* (nc) what each force belongs to */
        bool known;      /* it is in the step and nothing has switched there since */
        enum thud_contact_mode mode;
        enum thud_phase phase;
        bool past_ultimate;
    } * of;
    double ahead_s; /* from its start to where no step goes on: the end of the ground motion, which may be a jump */
};

struct thud_collocation {
    double point[THUD_POINTS];          /* nodes, and behind them where the error is measured */
    double lagrange[NODES][THUD_BATCH]; /* [k]: coefficients of the polynomial that is 1 at node k, 0 at the others, */
    double last[NODES][THUD_BATCH];     /* and its values at the last points */
    struct thud_responses *responses;
    double h_top; /* step of level 0 */
    double h, h_onset;
    int steady;         /* steps since one that let the next be longer */
    double contraction; /* of the fixed-point iteration, as last measured and with a margin */
    bool at_onset;
    struct step step;
    int nc;
    /* The system: unknowns are the forces of the active contacts at the nodes; values at the points of a contact stand
     * THUD_POINTS apart */
    double *largest_n; /* (nc) force so far: scale on which errors count */
    int *active;       /* (nc) */
    int nactive, capacity;
    const struct thud_response **response; /* (nactive x nactive) of one to the force of the other */
    double *force, *d0, *v0, *d, *v;       /* (nactive x THUD_POINTS) */
    double *law, *law_d, *law_v;           /* (nactive x THUD_BATCH) force by the law, and its derivatives */
    double *part; /* (nactive x THUD_BATCH) of a force's difference from the law that it has to change by */
    double *residual, *matrix; /* (nactive x nodes); square */
    double *scale, *change;    /* (nactive) 1 over that on which a change of the force counts; the last one */
    lapack_int *pivot;
};

/* How far the force polynomials of a step are from the laws. */

/* A closed contact (NULL: a storey) on its way in. */
static bool is_approach(const struct thud_contact_state *contact)
{
    return contact && contact->mode == THUD_CLOSED && contact->phase == THUD_APPROACH;
}

/* Scale on which an error of contact a's force counts: the largest force it has had, has now, or will have by its
 * approach velocity. */
static double force_scale(const struct thud_state *state, const struct thud_collocation *x, int a)
{
    int c = x->active[a];
    double scale = x->largest_n[c];
    for (int i = 0; i < NODES; i++)
        scale = thud_larger(scale, fabs(x->force[a * THUD_POINTS + i]));
    const struct thud_contact_state *contact = thud_row_contact(state, c);
    if (contact && contact->phase == THUD_APPROACH)
        scale = thud_larger(scale, contact->expected_force_n);
    return thud_larger(scale, thud_contact_least_force(state, c));
}

/* The law (N) and its derivatives at points `from` to n - 1. At d <= 0 the linear part alone counts: a power below 1
 * has no slope at d = 0 that Newton's method could use. */
static void law_at_points(const struct thud_branch *b, int from, int n, const double *d, const double *v, double *force,
                          double *df_dd, double *df_dv)
{
    for (int i = from; i < n; i++) {
        force[i] = thud_branch_force(b, d[i], v[i], &df_dd[i], &df_dv[i]);
        if (!(d[i] > 0))
            df_dd[i] = b->k_npm;
    }
}

/* Indentation at the state, as the step takes it: at contact onset the contact has not moved yet. */
static double indentation_now(const struct thud_state *state, int c)
{
    return thud_row_starts_at_zero(state, c) ? 0 : thud_contact_indentation(state, c);
}

/* Whether a contact is so young that its force has no smooth past: most of the indentation at the end of the step is
 * made in it, with the speed hardly lost. */
static bool has_just_begun(const struct thud_state *state, const struct thud_collocation *x, int a)
{
    int c = x->active[a], end = a * THUD_POINTS + NODES - 1;
    return indentation_now(state, c) < 0.5 * x->d[end] && x->v[end] > 0.5 * thud_contact_rate(state, c);
}

/* How far rounding alone may put a force off, by the displacements and rates that an indentation and its rate are
 * differences of. */
static double force_noise(const struct thud_state *state, int c, double fd, double fv)
{
    double left, right, left_rate, right_rate;
    thud_model_sides(state->model, c, state->q, &left, &right);
    thud_model_sides(state->model, c, state->qd, &left_rate, &right_rate);
    double d = thud_state_clearance(state, c) + fabs(left) + fabs(right), v = fabs(left_rate) + fabs(right_rate);
    return THUD_TOL_STATE * (fabs(fd) * d + fabs(fv) * v);
}

/* What the polynomial misses of contact a's force at the start of the step, where the contact opens before the first
 * point: behind it the law is 0 everywhere, and the polynomial 0 would have no error. */
static double start_difference(const struct thud_state *state, const struct thud_collocation *x, int a)
{
    const int c = x->active[a];
    const double d = indentation_now(state, c);
    if (d <= 0 || x->d[a * THUD_POINTS + NODES] > 0)
        return 0;
    double force = 0;
    for (int k = 0; k < NODES; k++)
        force += x->force[a * THUD_POINTS + k] * x->lagrange[k][0];
    state->work->force_evaluations++;
    return fabs(thud_row_force(state, c, d, thud_contact_rate(state, c)) - force);
}

/* Largest difference between the polynomial of contact a's force and the law, between the nodes; of one above `small`,
 * what rounding may have made is taken off. */
static double force_difference(const struct thud_state *state, const struct thud_collocation *x, int a, double h,
                               double small)
{
    int c = x->active[a];
    double worst = 0, mass = state->model->contact[c].setup.mass_kg;
    const double *d = x->d + a * THUD_POINTS, *v = x->v + a * THUD_POINTS;
    const double *force = x->force + a * THUD_POINTS;
    double law[THUD_BATCH] = {0}, law_d[THUD_BATCH], law_v[THUD_BATCH];
    if (thud_row_sticks(state, c)) { /* the force that would undo the rate in one step, but for rounding */
        for (int i = NODES; i < THUD_POINTS; i++)
            worst = thud_larger(worst, mass * thud_larger(fabs(v[i]) - THUD_TOL_STICKING_M / h, 0) / h);
        return worst;
    }
    worst = start_difference(state, x, a);
    law_at_points(thud_row_branch(state, c), NODES - LAST, THUD_BATCH, d + LAST, v + LAST, law, law_d, law_v);
    struct thud_batch difference = thud_batch_at(law);
    for (int k = 0; k < NODES; k++)
        thud_batch_add(&difference, -force[k], x->last[k]);
    thud_batch_put(&difference, law);
    for (int i = NODES - LAST; i < THUD_BATCH; i++) {
        double most = fabs(law[i]);
        if (most > thud_larger(worst, small))
            most -= force_noise(state, c, law_d[i], law_v[i]);
        worst = thud_larger(worst, most);
    }
    return worst;
}

/* Error of contact a's force: the largest difference between its polynomial and the law between the nodes, over the
 * force scale. Where a force begins without a smooth start (d^(1/4), d^(3/2)) no step is short enough for that; there
 * what counts is the impulse that the difference makes up. */
static double contact_error(const struct thud_state *state, const struct thud_collocation *x, int a, double h,
                            double tolerance)
{
    int c = x->active[a];
    const struct thud_contact_state *s = thud_row_contact(state, c);
    double mass = state->model->contact[c].setup.mass_kg, scale = force_scale(state, x, a),
           difference = force_difference(state, x, a, h, 1e-2 * tolerance * scale);
    double error = thud_larger(difference / scale - THUD_TOL_POLYNOMIAL, 0);
    if (is_approach(s) && has_just_begun(state, x, a)) {
        double ground = state->fastest_radps > 0 ? state->ground_mps2 / state->fastest_radps : 0;
        double speed = s->onset_mps < 1e-7 * ground ? ground : s->onset_mps; /* pushed, or thrown */
        if (speed > 0)
            error = fmin(error, 10 * difference * h / (mass * speed));
    }
    return error;
}

static double error_of_step(const struct thud_state *state, const struct thud_collocation *x, double h,
                            double tolerance)
{
    double worst = 0;
    for (int a = 0; a < x->nactive; a++)
        worst = thud_larger(worst, contact_error(state, x, a, h, tolerance));
    state->work->force_evaluations += x->nactive * (THUD_POINTS - NODES);
    return worst;
}

/* The error is measured in the middle between nodes; a law is dear, and most of the error lies in the first half. */
static void set_points(struct thud_collocation *x, double *lagrange)
{
    static const int interval[THUD_POINTS - NODES] = {0, 1, 3};
    thud_radau_nodes(NODES, x->point);
    thud_lagrange_coefficients(NODES, x->point, lagrange);
    for (int i = NODES; i < THUD_POINTS; i++) {
        int right = interval[i - NODES];
        x->point[i] = 0.5 * (x->point[right] + (right > 0 ? x->point[right - 1] : 0));
    }
    for (int k = 0; k < NODES; k++) {
        for (int p = 0; p < NODES; p++)
            x->lagrange[k][p] = lagrange[p * NODES + k];
        for (int i = 0; i < THUD_BATCH; i++)
            x->last[k][i] = thud_poly_value(x->lagrange[k], NODES, x->point[LAST + i]);
    }
}

/* The longest step: intervals of the ground motion, or parts of one, that a series is enough for. */
static double longest_step(const struct thud_state *state)
{
    const double dt = state->grid_dt_s, intervals = longest_angle / (state->fastest_radps * dt);
    if (intervals < 1)
        return dt / ceil(1 / intervals);
    return intervals >= 4 ? 4 * dt : intervals >= 2 ? 2 * dt : dt;
}

enum thud_status thud_collocation_create(const struct thud_state *state, struct thud_collocation **out,
                                         struct thud_error *err)
{
    const struct thud_model *m = state->model;
    struct thud_collocation *x = *out = calloc(1, sizeof *x);
    if (!x)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    x->nc = m->nrows;
    x->h = x->h_top = longest_step(state);
    x->contraction = slowest_contraction;
    double lagrange[NODES * NODES];
    set_points(x, lagrange);
    size_t nc = (size_t)m->nrows;
    x->step.coefficient = calloc(THUD_BATCH * nc + 1, sizeof(double));
    x->step.of = calloc(nc + 1, sizeof *x->step.of);
    x->active = calloc(nc + 1, sizeof(int));
    x->largest_n = calloc(nc + 1, sizeof *x->largest_n);
    if (!x->step.coefficient || !x->step.of || !x->active || !x->largest_n ||
        thud_responses_create(m, x->point, lagrange, x->h_top, state->tolerance, &x->responses, err) != THUD_OK) {
        thud_collocation_free(x);
        *out = NULL;
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    for (int k = 0; k < m->nstoreys; k++)
        x->largest_n[m->ncontacts + k] =
            (1 - m->storey[k].hardening) * m->storey[k].stiffness_npm * m->storey[k].yield_m;
    return THUD_OK;
}

void thud_collocation_free(struct thud_collocation *x)
{
    if (!x)
        return;
    thud_responses_free(x->responses);
    free(x->step.coefficient);
    free(x->step.of);
    free(x->active);
    free(x->largest_n);
    free(x->response);
    free(x->force);
    free(x->matrix);
    free(x->pivot);
    free(x);
}

static struct branch_name name_of(const struct thud_state *state, int row)
{
    const struct thud_contact_state *s = thud_row_contact(state, row);
    const bool acts = thud_row_acts(state, row);
    return s ? (struct branch_name){acts, s->mode, s->phase, s->past_ultimate}
             : (struct branch_name){.known = acts, .mode = acts ? THUD_CLOSED : THUD_OPEN};
}

/* Forces of contacts that have switched say nothing about those that follow. */
static void forget_switched(const struct thud_state *state, struct thud_collocation *x)
{
    for (int c = 0; c < x->nc; c++) {
        struct branch_name *was = &x->step.of[c], is = name_of(state, c);
        was->known = was->known && is.known && was->mode == is.mode && was->phase == is.phase &&
                     was->past_ultimate == is.past_ultimate;
    }
}

/* Raises the largest forces by those of the piece of a segment that the state has just come through. */
static void raise_largest(struct thud_collocation *x, const struct thud_model *m, const struct thud_segment *seg,
                          double s)
{
    double p[THUD_SEGMENT_TERMS], where;
    for (int i = 0; i < seg->rows && seg->loaded > 0; i++) {
        const int c = seg->row[i];
        for (int k = 0; k < seg->loaded; k++)
            p[k] = seg->force[k * m->nrows + c];
        if (c < m->ncontacts)
            x->largest_n[c] = thud_poly_peak(p, seg->loaded, s, x->largest_n[c], &where);
    }
}

void thud_collocation_committed(const struct thud_state *state, struct thud_collocation *x,
                                const struct thud_segment *seg, double moved_s, bool switched, bool onset)
{
    if (moved_s > 0)
        raise_largest(x, state->model, seg, moved_s / seg->h_s);
    x->step.done_s += moved_s;
    x->at_onset = onset;
    if (!switched)
        return;
    x->step.goes_on = false;
    forget_switched(state, x);
    x->contraction = slowest_contraction;
}

/* Room for n active contacts. */
static bool reserve(struct thud_collocation *x, int n)
{
    if (n <= x->capacity)
        return true;
    size_t contacts = (size_t)n, size = contacts * THUD_POINTS, batch = contacts * THUD_BATCH,
           unknowns = contacts * (size_t)NODES;
    double *block = calloc(5 * size + 4 * batch + unknowns + 2 * contacts + 1, sizeof *block),
           *matrix = calloc(unknowns * unknowns + 1, sizeof *matrix);
    const struct thud_response **response = calloc(contacts * contacts + 1, sizeof *response);
    lapack_int *pivot = calloc(unknowns + 1, sizeof *pivot);
    if (!block || !matrix || !response || !pivot) {
        free(block);
        free(matrix);
        free(response);
        free(pivot);
        return false;
    }
    free(x->force);
    free(x->matrix);
    free(x->response);
    free(x->pivot);
    x->force = block;
    x->d0 = block + size;
    x->v0 = block + 2 * size;
    x->d = block + 3 * size;
    x->v = block + 4 * size;
    x->law = block + 5 * size;
    x->law_d = x->law + batch;
    x->law_v = x->law_d + batch;
    x->part = x->law_v + batch;
    x->residual = x->part + batch;
    x->scale = x->residual + unknowns;
    x->change = x->scale + n;
    x->matrix = matrix;
    x->response = response;
    x->pivot = pivot;
    x->capacity = n;
    return true;
}

/* Indentation and rate of the active contacts at the first batch of points, or those behind it, under all forces: out of
 * what they are without. */
static void motion_under_forces(const struct thud_collocation *x)
{
    for (int a = 0; a < x->nactive; a++) {
        struct thud_batch d = thud_batch_at(x->d0 + a * THUD_POINTS), v = thud_batch_at(x->v0 + a * THUD_POINTS);
        for (int b = 0; b < x->nactive; b++) {
            const struct thud_response *r = x->response[a * x->nactive + b];
            for (int j = 0; j < NODES; j++) {
                double force = x->force[b * THUD_POINTS + j];
                thud_batch_add(&d, force, r->indentation + j * THUD_POINTS);
                thud_batch_add(&v, force, r->rate + j * THUD_POINTS);
            }
        }
        thud_batch_put(&d, x->d + a * THUD_POINTS);
        thud_batch_put(&v, x->v + a * THUD_POINTS);
    }
}

static void motion_behind(const struct thud_collocation *x)
{
    for (int a = 0; a < x->nactive; a++) {
        for (int i = THUD_BATCH; i < THUD_POINTS; i += 2) {
            thud_vec2 d = thud_vec2_at(x->d0 + a * THUD_POINTS + i), v = thud_vec2_at(x->v0 + a * THUD_POINTS + i);
            for (int b = 0; b < x->nactive; b++) {
                const struct thud_response *r = x->response[a * x->nactive + b];
                for (int j = 0; j < NODES; j++) {
                    double force = x->force[b * THUD_POINTS + j];
                    d += force * thud_vec2_at(r->indentation + j * THUD_POINTS + i);
                    v += force * thud_vec2_at(r->rate + j * THUD_POINTS + i);
                }
            }
            thud_vec2_put(d, x->d + a * THUD_POINTS + i);
            thud_vec2_put(v, x->v + a * THUD_POINTS + i);
        }
    }
}

/* The laws and their derivatives along the motion under the last forces. */
static void evaluate_laws(const struct thud_state *state, struct thud_collocation *x)
{
    for (int a = 0; a < x->nactive; a++) {
        const int c = x->active[a];
        int at = a * THUD_BATCH, point = a * THUD_POINTS;
        if (!thud_row_sticks(state, c))
            law_at_points(thud_row_branch(state, c), 0, NODES, x->d + point, x->v + point, x->law + at, x->law_d + at,
                          x->law_v + at);
    }
    state->work->force_evaluations += x->nactive * NODES;
}

/* Residual of the force equations and their derivative by the forces (column-major). */
static void linearize(const struct thud_state *state, struct thud_collocation *x)
{
    int n = x->nactive * NODES;
    evaluate_laws(state, x);
    for (int a = 0; a < x->nactive; a++) {
        bool sticks = thud_row_sticks(state, x->active[a]);
        for (int i = 0; i < NODES; i++) {
            int row = a * NODES + i, at = a * THUD_POINTS + i, in_batch = a * THUD_BATCH + i;
            double fd = sticks ? 0 : x->law_d[in_batch], fv = sticks ? -1 : x->law_v[in_batch];
            x->residual[row] = sticks ? x->v[at] : x->force[at] - x->law[in_batch];
            for (int b = 0; b < x->nactive; b++) {
                const struct thud_response *r = x->response[a * x->nactive + b];
                double *column = x->matrix + (size_t)(b * NODES) * (size_t)n + row;
                for (int j = 0; j < NODES; j++, column += n)
                    *column = -fd * r->indentation[j * THUD_POINTS + i] - fv * r->rate[j * THUD_POINTS + i];
            }
            x->matrix[(size_t)row * (size_t)n + (size_t)row] += sticks ? 0 : 1;
        }
    }
}

/* Contact a's law as a straight line f0 + law_d d + law_v v, of which law keeps f0. */
static void straighten_law(struct thud_collocation *x, int a)
{
    const struct thud_response *self = x->response[a * x->nactive + a];
    const struct thud_batch d = thud_batch_at(x->d + a * THUD_POINTS), v = thud_batch_at(x->v + a * THUD_POINTS);
    const struct thud_batch by_d = thud_batch_at(x->law_d + a * THUD_BATCH),
                            by_v = thud_batch_at(x->law_v + a * THUD_BATCH),
                            own_d = thud_batch_at(self->own_indentation), own_v = thud_batch_at(self->own_rate);
    struct thud_batch law = thud_batch_at(x->law + a * THUD_BATCH), part;
    for (int i = 0; i < THUD_BATCH / 2; i++) {
        law.pair[i] -= by_d.pair[i] * d.pair[i] + by_v.pair[i] * v.pair[i];
        part.pair[i] = 1 / (1 - by_d.pair[i] * own_d.pair[i] - by_v.pair[i] * own_v.pair[i]);
    }
    thud_batch_put(&law, x->law + a * THUD_BATCH);
    thud_batch_put(&part, x->part + a * THUD_BATCH);
}

/* All contacts at all points feel the changes of the forces at point j. */
static void spread(struct thud_collocation *x, int j)
{
    const struct thud_response *const *r = x->response;
    for (int b = 0; b < x->nactive; b++) {
        struct thud_batch d = thud_batch_at(x->d + b * THUD_POINTS), v = thud_batch_at(x->v + b * THUD_POINTS);
        for (int a = 0; a < x->nactive; a++, r++) {
            thud_batch_add(&d, x->change[a], (*r)->indentation + j * THUD_POINTS);
            thud_batch_add(&v, x->change[a], (*r)->rate + j * THUD_POINTS);
        }
        thud_batch_put(&d, x->d + b * THUD_POINTS);
        thud_batch_put(&v, x->v + b * THUD_POINTS);
    }
}

/* One step of Newton's method, its linear system by one Gauss-Seidel sweep over the nodes of the step, earliest first.
 * Returns the largest change of a force, over the force scale. */
static double renew_forces(const struct thud_state *state, struct thud_collocation *x)
{
    double most = 0;
    evaluate_laws(state, x);
    for (int a = 0; a < x->nactive; a++)
        straighten_law(x, a);
    for (int j = 0; j < NODES; j++) {
        for (int a = 0; a < x->nactive; a++) {
            int i = a * THUD_BATCH + j, at = a * THUD_POINTS + j;
            double law = x->law[i] + x->law_d[i] * x->d[at] + x->law_v[i] * x->v[at];
            double change = (law - x->force[at]) * x->part[i];
            x->force[at] += change;
            x->change[a] = change;
            most = thud_larger(most, fabs(change) * x->scale[a]);
        }
        spread(x, j);
    }
    return most;
}

/* Iteration for the forces: cheap, and fast where contacts are soft on the scale of the step, as what acts later hardly
 * shows in what was before. What is left after an iteration is its change times the contraction, which is known from
 * the step before; should it be worse, the error of the step shows it. */
static bool iterate(const struct thud_state *state, struct thud_collocation *x, double tolerance)
{
    double before = 0;
    for (int a = 0; a < x->nactive; a++) {
        if (thud_row_sticks(state, x->active[a]))
            return false;
        x->scale[a] = 1 / force_scale(state, x, a);
    }
    motion_under_forces(x);
    for (int iteration = 0; iteration < ITERATIONS_MAX; iteration++) {
        double change = renew_forces(state, x);
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
static bool solve(const struct thud_state *state, struct thud_collocation *x, double tolerance)
{
    int n = x->nactive * NODES;
    double before = INFINITY;
    for (int iteration = 0; iteration < NEWTON_MAX; iteration++) {
        motion_under_forces(x);
        linearize(state, x);
        if (LAPACKE_dgesv_work(LAPACK_COL_MAJOR, n, 1, x->matrix, n, x->pivot, x->residual, n) != 0)
            return false;
        double change = 0;
        for (int a = 0; a < x->nactive; a++) {
            double scale = force_scale(state, x, a);
            for (int i = 0; i < NODES; i++) {
                x->force[a * THUD_POINTS + i] -= x->residual[a * NODES + i];
                change = thud_larger(change, fabs(x->residual[a * NODES + i]) / scale);
            }
        }
        if (!isfinite(change))
            return false;
        if (change <= tolerance ||
            (change < THUD_TOL_COLLOCATION_STALL && change >= 0.5 * before)) { /* or no better for rounding */
            motion_under_forces(x);
            return true;
        }
        before = change;
    }
    return false;
}

/* What the forces of the last step come to if they go on over h. */
static void extrapolate(const struct thud_collocation *x, int c, double h, double *force)
{
    const struct step *last = &x->step;
    const double *coefficient = last->coefficient + c * THUD_BATCH;
    const double from = last->done_s / last->h, part = h / last->h;
    struct thud_batch f = {0}, at;
    for (int i = 0; i < THUD_BATCH / 2; i++)
        at.pair[i] = from + part * thud_vec2_at(x->point + 2 * i);
    for (int k = NODES - 1; k >= 0; k--)
        for (int i = 0; i < THUD_BATCH / 2; i++)
            f.pair[i] = f.pair[i] * at.pair[i] + coefficient[k];
    thud_batch_put(&f, force);
}

/* The force now; where the contact goes deeper, at least half of what the law makes of the indentation going on
 * at half its rate. */
static void begin_force(const struct thud_state *state, const struct thud_collocation *x, int c, double h,
                        double *force)
{
    double now, d[THUD_BATCH], v[THUD_BATCH], fd[THUD_BATCH], fv[THUD_BATCH];
    double place = thud_contact_indentation(state, c), rate = thud_contact_rate(state, c);
    if (thud_row_sticks(state, c)) {
        thud_contact_forces(state, state->force_now);
        now = state->force_now[c];
    } else {
        now = thud_row_force(state, c, place, rate);
    }
    if (is_approach(thud_row_contact(state, c))) {
        for (int i = 0; i < THUD_BATCH; i++) {
            d[i] = place + 0.5 * rate * h * x->point[i];
            v[i] = rate;
        }
        law_at_points(thud_row_branch(state, c), 0, THUD_BATCH, d, v, force, fd, fv);
        for (int i = 0; i < THUD_BATCH; i++)
            force[i] = thud_larger(now, 0.5 * force[i]);
    } else {
        for (int i = 0; i < THUD_BATCH; i++)
            force[i] = now;
    }
}

/* First guess: the forces of the last step go on where their contact has not switched; the others begin. */
static void guess(const struct thud_state *state, struct thud_collocation *x, double h)
{
    static const double farthest = 32; /* times the last step: its sixth power is 1e9 */
    const struct step *last = &x->step;
    for (int a = 0; a < x->nactive; a++) {
        int c = x->active[a];
        double *force = x->force + a * THUD_POINTS;
        if (last->of[c].known && last->done_s + h <= farthest * last->h)
            extrapolate(x, c, h, force);
        else
            begin_force(state, x, c, h, force);
    }
}

/* Keeps the forces at the nodes as polynomials of a step that begins at the state. */
static void keep_step(const struct thud_state *state, struct thud_collocation *x, double h)
{
    for (int c = 0; c < x->nc; c++)
        x->step.of[c] = name_of(state, c);
    for (int a = 0; a < x->nactive; a++) {
        struct thud_batch f = {0};
        for (int k = 0; k < NODES; k++)
            thud_batch_add(&f, x->force[a * THUD_POINTS + k], x->lagrange[k]);
        thud_batch_put(&f, x->step.coefficient + x->active[a] * THUD_BATCH);
    }
    x->step.h = h;
    x->step.done_s = 0;
}

/* Forces of the step over the next h seconds of the state. */
static void write_forces(const struct thud_collocation *x, double h, double *force)
{
    const struct step *step = &x->step;
    double from = step->done_s / step->h, part = h / step->h;
    for (int a = 0; a < x->nactive; a++) {
        int c = x->active[a];
        double p[NODES], scale = 1;
        for (int k = 0; k < NODES; k++)
            p[k] = step->coefficient[c * THUD_BATCH + k];
        for (int i = 0; i + 1 < NODES && from > 0; i++) /* p(from + s) by Horner's scheme */
            for (int k = NODES - 2; k >= i; k--)
                p[k] += from * p[k + 1];
        for (int k = 0; k < NODES; k++, scale *= part)
            force[k * x->nc + c] = scale * p[k];
    }
}

/* What of the step comes before the next kink. */
static void write_segment(const struct thud_state *state, struct thud_segment *seg, struct thud_collocation *x)
{
    double left = x->step.h - x->step.done_s, remaining = thud_state_remaining(state);
    double h = left > remaining * (1 - THUD_TOL_SEGMENT_END) ? remaining : left;
    double least = fmax(THUD_TOL_SERIES, 1e-4 * state->tolerance);
    thud_segment_begin(state, seg, h);
    seg->terms = thud_segment_terms(state->fastest_radps * h, least);
    seg->loaded = NODES;
    write_forces(x, h, seg->force);
    thud_taylor_given(state->model, seg, state->q, state->qd);
}

static void find_active(const struct thud_state *state, struct thud_collocation *x)
{
    x->nactive = 0;
    for (int c = 0; c < x->nc; c++)
        if (thud_row_acts(state, c))
            x->active[x->nactive++] = c;
}

/* Time to the end of the run or, before it, of the ground motion, which may end with a jump. */
static double time_ahead(const struct thud_state *state)
{
    double ahead = state->end_s - thud_state_now(state);
    long left = state->record ? (long)state->record->samples - 1 - state->grid : 0;
    return left > 0 ? fmin(ahead, (double)left * state->grid_dt_s - state->offset_s) : ahead;
}

/* Smallest level whose step is at most `want`, but no shorter than needed to reach what ends the step. */
static int level_for(const struct thud_collocation *x, double want, double ahead)
{
    int level = 0;
    double h = x->h_top;
    while (level + 1 < LEVELS && (h > want || 0.5 * h >= ahead)) {
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
        sticking += thud_row_sticks(state, x->active[a]);
    if (sticking > 1 && state->model->left_out > 0) /* all modes tell any floors apart */
        return thud_state_too_few_modes(state, err);
    return thud_error_set(err, THUD_DIVERGED, "no step is short enough for the contact forces at t = %.6g s",
                          thud_state_now(state));
}

/* The first step size of a step: that of the last, no longer than the last that began at an onset where it does so too;
 * and now and then twice as long, as the error of a longer step may be the smaller one where contacts are stiff. */
static void choose_size(struct thud_collocation *x)
{
    if (x->at_onset && x->h_onset > 0)
        x->h = fmin(x->h, x->h_onset);
    if (++x->steady > PATIENCE) {
        x->h *= 2;
        x->steady = 0;
    }
}

/* The forces of a step of one level: *error is theirs, INFINITY where they could not be found. Errors: THUD_MEMORY. */
static enum thud_status solve_level(const struct thud_state *state, struct thud_collocation *x, int level,
                                    double tolerance, double ahead, double *error, struct thud_error *err)
{
    const double h = ldexp(x->h_top, -level), least = solution_part * tolerance;
    *error = INFINITY;
    enum thud_status status = thud_responses_make(x->responses, level, x->active, x->nactive, x->response, err);
    if (status != THUD_OK)
        return status;
    thud_responses_unforced(x->responses, state, level, ahead, x->active, x->nactive, x->d0, x->v0);
    guess(state, x, h);
    if (iterate(state, x, least) || solve(state, x, least)) {
        keep_step(state, x, h); /* should it be too long, a shorter one begins with these forces */
        motion_behind(x);
        *error = error_of_step(state, x, h, tolerance);
    } else {
        memset(x->step.of, 0, (size_t)x->nc * sizeof *x->step.of);
    }
    return THUD_OK;
}

/* The size at which the error would be the tolerance: it falls with h^NODES. */
static double next_size(double h, double error, double tolerance)
{
    if (!isfinite(error))
        return h * unsolved;
    const double factor = safety * pow(tolerance / thud_larger(error, least_error * tolerance), 1.0 / NODES);
    return h * fmin(most_growth, thud_larger(most_shrink, factor));
}

/* What the step that is taken leaves for the next: h its size, `want` the one that was asked for, x->h proposed. */
static void accept(struct thud_collocation *x, int level, double h, double want)
{
    if (level > 0 && 2 * h <= want) /* only short because the end is near */
        x->h = thud_larger(x->h, want);
    if (x->at_onset)
        x->h_onset = x->h;
    if (x->h >= 2 * h)
        x->steady = 0;
}

/* A step accurate to the run's tolerance. Tries sizes until one of these holds:
 *   1) taken: the error of the step is at most the tolerance;
 *   2) taken: REPEATS times in a row no shorter step has had less than `same_error` of the error before, and that error
 *      is near the tolerance: it is rounding, of rates where a contact is stiff. The next step is four times as long;
 *   3) THUD_DIVERGED: the shortest size of the ladder has been tried;
 *   4) THUD_MEMORY. */
static enum thud_status make_step(const struct thud_state *state, struct thud_collocation *x, struct thud_error *err)
{
    if (!reserve(x, x->nactive))
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    const double tolerance = thud_larger(step_part * state->tolerance, THUD_TOL_COLLOCATION), ahead = time_ahead(state);
    double before = INFINITY, error;
    choose_size(x);
    for (int same = 0;;) {
        const int level = level_for(x, x->h, ahead);
        const double want = x->h, h = ldexp(x->h_top, -level);
        enum thud_status status = solve_level(state, x, level, tolerance, ahead, &error, err);
        if (status != THUD_OK)
            return status;
        same = error > same_error * before && error <= near_tolerance * tolerance ? same + 1 : 0;
        before = error;
        x->h = same >= REPEATS ? most_growth * h : next_size(h, error, tolerance);
        if (error <= tolerance || same >= REPEATS) {
            accept(x, level, h, want);
            x->step.ahead_s = ahead;
            return THUD_OK;
        }
        x->h = fmin(x->h, 0.5 * h);
        state->work->rejected++;
        if (level + 1 >= LEVELS)
            return too_short(state, x, err);
    }
}

/* Whether what is left of the step is worth a piece of its own: it reaches the next kink. */
static bool goes_on(const struct thud_state *state, const struct step *step)
{
    double left = step->h - step->done_s, remaining = thud_state_remaining(state);
    bool at_kink = state->offset_s == 0;
    if (step->done_s >= step->ahead_s * (1 - THUD_TOL_SEGMENT_END))
        return false;
    return step->goes_on && left > (at_kink ? remaining * (1 - THUD_TOL_SEGMENT_END) : THUD_TOL_TIME * step->h);
}

enum thud_status thud_collocation_step(const struct thud_state *state, struct thud_segment *seg,
                                       struct thud_collocation *x, struct thud_error *err)
{
    find_active(state, x);
    enum thud_status status = goes_on(state, &x->step) ? THUD_OK : make_step(state, x, err);
    if (status != THUD_OK)
        return status;
    x->step.goes_on = true;
    write_segment(state, seg, x);
    return THUD_OK;
}
