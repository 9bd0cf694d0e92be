#include "core/motion/collocation.h"

#include <lapacke.h>
#include <math.h>
#include <string.h>

#include "base/arena.h"
#include "base/largest.h"
#include "core/motion/response.h"
#include "core/numerics/poly.h"
#include "core/numerics/quadrature.h"
#include "core/numerics/tolerance.h"

/* Glossary, for one step of length h from the state at t0; a, b are active contacts, i, j points of the step.
 *
 *     s_i            points in [0, 1]: n Lobatto points first, then those where the error is measured
 *     F_b(s_j)       x->force: known at the start of the step (see `begins`), unknown at the other nodes; between them the
 *                    polynomial of degree n - 1 through them
 *     d0_a, v0_a     x->free: indentation and rate without the forces of the active contacts
 *     R_ab,ij        x->response: d_a(s_i) by F_b(s_j), below 0 where the force pushes apart; R' of v_a(s_i)
 *     d_a, v_a       x->motion: x->free and what the forces do
 *     level l        h = h_top/2^l, so that R is made once for each size that occurs
 *     contraction    by which a Gauss-Seidel sweep reduces the change of the forces
 *     x->h           size asked for next; h_onset: that of the last step that began at an onset
 *
 * The equations are F_a(s_i) = law_a(d_a(s_i), v_a(s_i)), and v_a(s_i) = 0 where a sticks. */
enum { NODES_MAX = THUD_NODES_MAX, POINTS_MAX = THUD_POINTS_MAX, CHECKS = POINTS_MAX - NODES_MAX, LEVELS = 48 };
enum { ROW = NODES_MAX + 1 }; /* an even number */
enum { NEWTON_MAX = 12, ITERATIONS_MAX = 12 };
enum { PATIENCE = 16 };                        /* steps of one size before a longer one is tried */
enum { REPEATS = 2 };                          /* shorter steps with no smaller error: it is rounding */
static const double slowest_contraction = 0.3; /* of the Gauss-Seidel sweeps; slower ones are left to Newton's method */
static const double stiff = 1;                 /* change of a force by the motion it makes in a step, over itself */
static const double least_of_three = 3e-3;     /* tolerance at or above which so many nodes are enough, and */
static const double least_of_four = 3e-4;
/* Of the run's tolerance, for the error of a step: below least_of_four, and from there on. */
static const double step_part[] = {0.1, 0.3};
static const double begins_below = 1;     /* of the run's tolerance: the force of a contact that begins in a step */
static const double solution_part = 0.01; /* of that, for the solution of the equations */
static const double series_part = 1e-4;   /* of the run's tolerance, for terms left out of a series */
static const double safety = 0.85, unsolved = 0.25, most_growth = 4, most_shrink = 0.1; /* factors of the step size */
static const double same_error = 0.95, near_tolerance = 100;

/* The last step: the forces as polynomials over h from the state that it began at. */
struct step {
    double h, done_s;    /* length, and how far the state has come since its start */
    int n;               /* nodes */
    double *coefficient; /* (nc x ROW) by order */
    struct branch_name { /* (nc) what each force belongs to */
        bool known;      /* it is in the step and nothing has switched there since */
        enum thud_contact_mode mode;
        enum thud_phase phase;
        bool past_ultimate;
    } * of;
};

/* Points of a step, and the tables for them. */
struct scheme {
    int n, points; /* nodes; and with those behind them where the error is measured */
    double point[POINTS_MAX], weight[NODES_MAX];
    int terms[LEVELS];                 /* of the series of a step of each level; 0: not yet known */
    double lagrange[NODES_MAX][ROW];   /* [k]: coefficients of the polynomial that is 1 at node k, 0 at the others */
    double between[NODES_MAX][CHECKS]; /* and its values where the error is measured */
    double back
        [NODES_MAX]; /* [k]: value at the start of the polynomial that is 1 at node k, 0 at the others but the first */
    struct thud_responses *responses;
    struct thud_segment_nodes nodes; /* of the segment */
};

struct thud_collocation {
    struct scheme few, many, *by; /* the one at hand */
    double h_top;                 /* step of level 0 */
    double h, h_onset;
    int steady;               /* steps since one that let the next be longer */
    double contraction, at_h; /* of the fixed-point iteration, as last measured and with a margin; in a step of at_h */
    bool at_onset;
    struct step step;
    int nc;
    /* The system: unknowns are the forces of the active contacts at the nodes but the first */
    double *largest_n; /* (nc) force so far: scale on which errors count */
    int *active, *at;  /* (nc); place of a row among them, or -1 */
    int nactive, capacity;
    const thud_vec2 **response;   /* (nactive x nactive) of one to the force of the other: of */
    const struct scheme *made_by; /* this scheme, NULL: of another set of rows, and */
    int made_level;               /* this level */
    double *force;                /* (nactive x n) */
    thud_vec2 *free, *motion;     /* (nactive x points), of the motion at the nodes alone; at the start already */
    struct beginning {
        const struct thud_branch *branch;
        bool sticks;
        double force, by_d, by_v; /* the law at the start */
        bool rough;               /* what follows does not go on smoothly from there */
        double scale;             /* on which an error of its force counts, but for the forces of the step */
        double per_scale;         /* 1 over that */
    } * begins;                   /* (nactive) */
    double *residual, *matrix;    /* (unknowns); square */
    lapack_int *pivot;
};

/* How far the force polynomials of a step are from the laws. */

/* A closed contact (NULL: a storey) on its way in. */
static bool is_approach(const struct thud_contact_state *contact)
{
    return contact && contact->mode == THUD_CLOSED && contact->phase == THUD_APPROACH;
}

/* Of the force scale, for the error of a step. */
static double step_tolerance(const struct thud_state *state)
{
    return thud_larger(step_part[state->tolerance >= least_of_four] * state->tolerance, THUD_TOL_COLLOCATION);
}

/* Scale on which an error of contact a's force counts: the largest force it has had, has now, or will have by its
 * approach velocity. Of a yielding storey it is the yield force: the rest cancels the elastic spring's, but for rounding. */
static double scale_at_start(const struct thud_state *state, const struct thud_collocation *x, int a)
{
    const int c = x->active[a];
    const struct thud_contact_state *contact = thud_row_contact(state, c);
    const double least = thud_larger(x->largest_n[c], thud_contact_least_force(state, c));
    return contact && contact->phase == THUD_APPROACH ? thud_larger(least, contact->expected_force_n) : least;
}

static inline double force_scale(const struct thud_state *state, const struct thud_collocation *x, int a, const int n)
{
    const double part = x->active[a] < state->model->ncontacts ? 1 : THUD_TOL_CANCELLED / step_tolerance(state);
    double most = 0;
    for (int i = 0; i < n; i++)
        most = thud_larger(most, fabs(x->force[a * n + i]));
    return thud_larger(x->begins[a].scale, part * most);
}

/* The law (N) and its derivatives at a motion. At d <= 0 the linear part alone counts: a power below 1 has no slope at
 * d = 0 that Newton's method could use. */
static inline double law_at(const struct thud_branch *b, thud_vec2 motion, double *by_d, double *by_v)
{
    const double force = thud_branch_force(b, motion[0], motion[1], by_d, by_v);
    if (!(motion[0] > 0))
        *by_d = b->k_npm;
    return force;
}

/* Whether a contact is so young that its force has no smooth past: most of the indentation at the end of the step is
 * made in it, with the speed hardly lost. */
static bool has_just_begun(const struct thud_collocation *x, int a)
{
    const thud_vec2 *start = x->motion + a * x->by->points, *end = start + x->by->n - 1;
    return (*start)[0] < 0.5 * (*end)[0] && (*end)[1] > 0.5 * (*start)[1];
}

/* Difference between the polynomial of contact a's force and the law where i of the checks finds this motion; of one above
 * `small`, what rounding may have made is taken off. */
static inline double force_difference(const struct thud_state *state, const struct thud_collocation *x, int a, int i,
                                      thud_vec2 motion, double h, double small, const int n)
{
    const int c = x->active[a];
    const double *force = x->force + a * n;
    if (x->begins[a].sticks) /* the force that would undo the rate in one step, but for rounding */
        return state->model->contact[c].setup.mass_kg * thud_larger(fabs(motion[1]) - state->touch_m / h, 0) / h;
    double by_d, by_v, difference = law_at(x->begins[a].branch, motion, &by_d, &by_v);
    for (int k = 0; k < n; k++)
        difference -= force[k] * x->by->between[k][i];
    difference = fabs(difference);
    return difference > small ? difference - thud_row_force_noise(state, c, by_d, by_v) : difference;
}

/* Motion of contact a at a point under all forces. */
static inline thud_vec2 motion_at(const struct thud_collocation *x, int a, int i, const int n)
{
    const thud_vec2 *const *response = x->response + a * x->nactive;
    const double *force = x->force;
    thud_vec2 even = x->free[a * x->by->points + i], odd = {0, 0};
    for (int b = 0; b < x->nactive; b++, force += n) {
        const thud_vec2 *r = response[b] + i * n;
        for (int k = 0; k + 2 <= n; k += 2) {
            even += force[k] * r[k];
            odd += force[k + 1] * r[k + 1];
        }
        if (n % 2)
            even += force[n - 1] * r[n - 1];
    }
    return even + odd;
}

/* Force of a contact that has begun at the start and is open again at the first check, which is at this motion after t
 * seconds: at the top of the parabola through both. No node lies in so short a contact. */
static double missed_force(const struct thud_collocation *x, int a, thud_vec2 motion, double t)
{
    const double way = x->motion[a * x->by->points][1] * t;
    if (!(motion[0] <= 0 && way > 0)) /* below 0 by rounding */
        return 0;
    const double top = 0.25 * way * way / (way - motion[0]);
    return fabs(thud_branch_force(x->begins[a].branch, top, 0, NULL, NULL));
}

/* Error of contact a's force: the largest difference between its polynomial and the law between the nodes, over the
 * force scale. Where a force begins without a smooth start (d^(1/4), d^(3/2)) no step is short enough for that; there
 * what counts is the impulse that the difference makes up. Where the first is small, so are the others. */
static inline double contact_error(const struct thud_state *state, const struct thud_collocation *x, int a, double h,
                                   double tolerance, const int n)
{
    const struct thud_contact_state *s = thud_row_contact(state, x->active[a]);
    const double mass = state->model->contact[x->active[a]].setup.mass_kg, scale = force_scale(state, x, a, n),
                 small = 1e-2 * tolerance * scale;
    double most = 0;
    for (int i = 0; i < x->by->points - n && (i == 0 || most > 10 * small); i++) {
        const thud_vec2 motion = motion_at(x, a, n + i, n);
        state->work->force_evaluations++;
        most = thud_larger(most, force_difference(state, x, a, i, motion, h, small, n));
        if (i == 0 && thud_row_starts_at_zero(state, x->active[a]))
            most = thud_larger(most, missed_force(x, a, motion, x->by->point[n] * h));
    }
    double error = thud_larger(most / scale - THUD_TOL_POLYNOMIAL, 0);
    if (is_approach(s) && has_just_begun(x, a)) {
        const bool sways = state->ground_mps2 > 0 && state->fastest_radps > 0;
        const double pushed = sways ? state->ground_mps2 / state->fastest_radps : state->speed_mps,
                     speed = s->onset_mps < 1e-7 * pushed ? pushed : s->onset_mps; /* else thrown */
        if (speed > 0)
            error = fmin(error, 10 * most * h / (mass * speed));
    }
    return error;
}

static inline double contact_errors(const struct thud_state *state, const struct thud_collocation *x, double h,
                                    double tolerance, const int n)
{
    double worst = 0;
    for (int a = 0; a < x->nactive; a++)
        worst = thud_larger(worst, contact_error(state, x, a, h, tolerance, n));
    return worst;
}

static double error_of_step(const struct thud_state *state, const struct thud_collocation *x, double h,
                            double tolerance)
{
    return x->by->n == 3   ? contact_errors(state, x, h, tolerance, 3)
           : x->by->n == 4 ? contact_errors(state, x, h, tolerance, 4)
           : x->by->n == 5 ? contact_errors(state, x, h, tolerance, 5)
                           : contact_errors(state, x, h, tolerance, NODES_MAX);
}

/* The error is measured in the middle of two intervals between nodes, the first and one about the middle: a law is dear. */
static enum thud_status set_points(const struct thud_state *state, const struct thud_collocation *x, int n,
                                   struct scheme *by, struct thud_error *err)
{
    const int last = n - 1, interval[CHECKS] = {0, last / 2};
    double lagrange[NODES_MAX * NODES_MAX];
    *by = (struct scheme){.n = n, .points = n == 3 ? 4 : n + CHECKS};
    const struct thud_lobatto *rule = thud_lobatto_of(n);
    by->nodes = (struct thud_segment_nodes){.count = n,
                                            .point = by->point,
                                            .weight = n < NODES_MAX ? by->weight : NULL,
                                            .lagrange = by->lagrange[0],
                                            .apart = ROW,
                                            .at = x->at,
                                            .points = by->points};
    for (int i = 1; i < last; i++) {
        by->point[i] = rule->node[i - 1];
        by->weight[i] = rule->weight[i - 1];
    }
    by->point[last] = 1;
    by->weight[0] = by->weight[last] = rule->end_weight;
    for (int i = 0; i < last; i++)
        by->nodes.widest = thud_larger(by->nodes.widest, by->point[i + 1] - by->point[i]);
    thud_lagrange_coefficients(last, by->point + 1, lagrange);
    for (int k = 1; k <= last; k++)
        by->back[k] = lagrange[k - 1];
    thud_lagrange_coefficients(n, by->point, lagrange);
    for (int i = 0; i < by->points - n; i++)
        by->point[n + i] = 0.5 * (by->point[interval[i]] + by->point[interval[i] + 1]);
    for (int k = 0; k < n; k++) {
        for (int p = 0; p < n; p++)
            by->lagrange[k][p] = lagrange[p * n + k];
        for (int i = 0; i < by->points - n; i++)
            by->between[k][i] = thud_poly_value(by->lagrange[k], n, by->point[n + i]);
    }
    return thud_responses_create(state, n, by->points, by->point, lagrange, x->h_top, &by->responses, err);
}

enum thud_status thud_collocation_create(const struct thud_state *state, struct thud_collocation **out,
                                         struct thud_error *err)
{
    const struct thud_model *m = state->model;
    const bool loose = state->tolerance >= least_of_four;
    const int few = state->tolerance >= least_of_three ? 3 : loose ? 4 : 5, many = loose ? 5 : NODES_MAX;
    struct thud_collocation *x, to = {.nc = m->nrows, .contraction = slowest_contraction};
    /* an interval of the ground motion, or a part of one that a series is enough for */
    to.h = to.h_top =
        state->grid_dt_s / ceil(thud_larger(1, state->fastest_radps * state->grid_dt_s / THUD_SEGMENT_ANGLE));
    enum thud_status status =
        THUD_LAY_IN(state->memory, err, THUD_PIECE(x, 1), THUD_PIECE(to.step.coefficient, ROW * m->nrows),
                    THUD_PIECE(to.step.of, m->nrows), THUD_PIECE(to.active, m->nrows), THUD_PIECE(to.at, m->nrows),
                    THUD_PIECE(to.largest_n, m->nrows));
    *out = x;
    if (status != THUD_OK)
        return status;
    *x = to;
    x->by = &x->few;
    status = set_points(state, x, few, &x->few, err);
    if (status == THUD_OK)
        status = set_points(state, x, many, &x->many, err);
    for (int k = 0; k < m->nstoreys; k++)
        x->largest_n[m->ncontacts + k] =
            (1 - m->storey[k].hardening) * m->storey[k].stiffness_npm * m->storey[k].yield_m;
    return status;
}

/* An open contact that the step is solved for. */
static bool is_awaited(const struct thud_state *state, const struct thud_collocation *x, int row)
{
    return x->at[row] >= 0 && !thud_row_acts(state, row);
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

void thud_collocation_committed(const struct thud_state *state, struct thud_collocation *x, double moved_s,
                                bool switched, bool onset, bool quiet)
{
    x->step.done_s += moved_s;
    x->at_onset = onset;
    if (switched || quiet)
        forget_switched(state, x);
    if (!switched)
        return;
    x->contraction = slowest_contraction;
    x->at_h = 0;
}

/* Room for n active contacts, and for twice as many as before: what it replaces stays until the run is freed. */
static enum thud_status reserve(const struct thud_state *state, struct thud_collocation *x, int n,
                                struct thud_error *err)
{
    if (n <= x->capacity)
        return THUD_OK;
    x->capacity = n > 2 * x->capacity ? n : 2 * x->capacity;
    const size_t contacts = (size_t)x->capacity, unknowns = contacts * (NODES_MAX - 1), motions = contacts * POINTS_MAX;
    return THUD_LAY_IN(state->memory, err, THUD_PIECE(x->free, motions), THUD_PIECE(x->motion, motions),
                       THUD_PIECE(x->force, contacts * NODES_MAX + 1), THUD_PIECE(x->residual, unknowns),
                       THUD_PIECE(x->matrix, unknowns * unknowns), THUD_PIECE(x->response, contacts * contacts),
                       THUD_PIECE(x->pivot, unknowns), THUD_PIECE(x->begins, contacts));
}

/* The forces at the start: as they are, or where the polynomials through the other nodes come to. */
static void set_starts(struct thud_collocation *x)
{
    for (int a = 0; a < x->nactive; a++) {
        double *force = x->force + a * x->by->n, at_start = 0;
        for (int k = 1; k < x->by->n; k++)
            at_start += x->by->back[k] * force[k];
        force[0] = x->begins[a].rough ? at_start : x->begins[a].force;
    }
}

/* Residual of the force equations and their derivative by the forces (column-major). */
static void linearize(const struct thud_state *state, struct thud_collocation *x)
{
    const int n = x->by->n, each = n - 1, all = x->nactive * each;
    set_starts(x);
    for (int row = 0; row < all; row++) {
        const int a = row / each, i = row % each + 1;
        const bool sticks = x->begins[a].sticks;
        const thud_vec2 motion = x->motion[a * x->by->points + i] = motion_at(x, a, i, n);
        double by_d = 0, by_v = -1;
        x->residual[row] =
            sticks ? motion[1] : x->force[a * x->by->n + i] - law_at(x->begins[a].branch, motion, &by_d, &by_v);
        for (int column = 0; column < all; column++) {
            const int b = column / each, k = column % each + 1;
            const thud_vec2 *r = x->response[a * x->nactive + b] + i * n,
                            by = r[k] + (x->begins[b].rough ? x->by->back[k] : 0) * r[0];
            x->matrix[column * all + row] = -by_d * by[0] - by_v * by[1] + (column == row && !sticks);
        }
    }
    state->work->force_evaluations += all;
}

/* One sweep over the nodes of the step, earliest first: at each all forces take a step of Newton's method by themselves,
 * under the newest forces of the nodes before (nonlinear Gauss-Seidel by nodes). Those of one node do not wait for each
 * other: a law is a chain of products, and a processor works on several chains at once. Returns the largest change of a
 * force, over the force scale. */
static inline double sweep_nodes(const struct thud_state *state, struct thud_collocation *x, const int n)
{
    const int points = x->by->points;
    double most = 0;
    set_starts(x);
    for (int j = 1; j < n; j++) {
        for (int a = 0; a < x->nactive; a++)
            x->motion[a * points + j] = motion_at(x, a, j, n);
        for (int a = 0; a < x->nactive; a++) {
            double by_d, by_v, *force = &x->force[a * n + j];
            const thud_vec2 own = x->response[a * x->nactive + a][j * n + j], motion = x->motion[a * points + j];
            const double law = law_at(x->begins[a].branch, motion, &by_d, &by_v);
            const double change = (law - *force) / (1 - by_d * own[0] - by_v * own[1]);
            *force += change;
            x->motion[a * points + j] = motion + change * own;
            most = thud_larger(most, fabs(change) * x->begins[a].per_scale);
        }
    }
    state->work->force_evaluations += x->nactive * (n - 1);
    return most;
}

/* Iteration for the forces: cheap, and fast where contacts are soft on the scale of the step, as what acts later hardly
 * shows in what was before. What is left after an iteration is its change times the contraction, which is known from
 * the step before; should it be worse, the error of the step shows it. */
static bool iterate(const struct thud_state *state, struct thud_collocation *x, double h, double tolerance)
{
    const double longer = x->at_h > 0 ? h / x->at_h : 1; /* the displacement by a force goes with its square */
    double before = 0,
           contraction = thud_smaller(slowest_contraction, x->contraction * longer * thud_larger(longer, 1));
    for (int a = 0; a < x->nactive; a++)
        if (x->begins[a].sticks)
            return false;
    for (int iteration = 0; iteration < ITERATIONS_MAX; iteration++) {
        const double change = x->by->n == 3   ? sweep_nodes(state, x, 3)
                              : x->by->n == 4 ? sweep_nodes(state, x, 4)
                              : x->by->n == 5 ? sweep_nodes(state, x, 5)
                                              : sweep_nodes(state, x, NODES_MAX);
        if (iteration > 0) {
            x->contraction = contraction = fmin(slowest_contraction, 4 * change / before);
            x->at_h = h;
        }
        if (change * contraction <= tolerance) {
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
    const int each = x->by->n - 1, n = x->nactive * each;
    double before = INFINITY;
    for (int iteration = 0; iteration < NEWTON_MAX; iteration++) {
        linearize(state, x);
        if (LAPACKE_dgesv_work(LAPACK_COL_MAJOR, n, 1, x->matrix, n, x->pivot, x->residual, n) != 0)
            return false;
        double change = 0;
        for (int a = 0; a < x->nactive; a++) {
            double scale = force_scale(state, x, a, x->by->n);
            for (int i = 0; i < each; i++) {
                x->force[a * x->by->n + i + 1] -= x->residual[a * each + i];
                change = thud_larger(change, fabs(x->residual[a * each + i]) / scale);
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

/* What the forces of the last step come to if they go on over h. */
static void extrapolate(const struct thud_collocation *x, int c, double h, double *force)
{
    const struct step *last = &x->step;
    const double from = last->done_s / last->h, part = h / last->h;
    for (int i = 1; i < x->by->n; i++)
        force[i] = thud_poly_value(last->coefficient + c * ROW, last->n, from + part * x->by->point[i]);
}

/* Where the contact goes deeper, at least half of what the law makes of the indentation going on at half its rate; else
 * the force now, which stands at the start. */
static void begin_force(const struct thud_state *state, const struct thud_collocation *x, int a, double h)
{
    const int c = x->active[a];
    double *force = x->force + a * x->by->n;
    const double now = x->begins[a].force, place = x->motion[a * x->by->points][0],
                 rate = x->motion[a * x->by->points][1];
    const bool deeper = is_approach(thud_row_contact(state, c));
    for (int i = 1; i < x->by->n; i++) {
        const double d = place + 0.5 * rate * h * x->by->point[i];
        force[i] = deeper ? thud_larger(now, 0.5 * thud_branch_force(x->begins[a].branch, d, rate, NULL, NULL)) : now;
    }
}

/* Motions and forces at the start: by the laws, or the constraint of those that stick. At contact onset a contact has not
 * moved yet, whatever rounding says. */
static void start_forces(const struct thud_state *state, struct thud_collocation *x)
{
    bool sticking = false;
    for (int a = 0; a < x->nactive; a++)
        sticking |= thud_row_sticks(state, x->active[a]);
    if (sticking)
        thud_contact_forces(state, state->force_now);
    for (int a = 0; a < x->nactive; a++) {
        const int c = x->active[a];
        struct beginning *begins = &x->begins[a];
        thud_vec2 *motion = x->motion + a * x->by->points;
        thud_contact_motion(state, c, (double *)motion);
        if (thud_row_starts_at_zero(state, c))
            (*motion)[0] = 0;
        if (thud_row_sticks(state, c) && fabs((*motion)[1]) <= thud_rest_speed(state))
            (*motion)[1] = 0; /* in a short step a large force would be needed, and another one to end it */
        *begins = (struct beginning){.branch = thud_row_branch(state, c), .sticks = thud_row_sticks(state, c)};
        begins->force =
            begins->sticks ? state->force_now[c] : law_at(begins->branch, *motion, &begins->by_d, &begins->by_v);
        if (thud_row_contact(state, c)) /* of a storey, the yield force */
            x->largest_n[c] = thud_larger(x->largest_n[c], fabs(begins->force));
        begins->scale = scale_at_start(state, x, a);
        begins->per_scale = 1 / begins->scale;
    }
}

/* Whether the forces of a step of length h go on from those at its start: not where a contact is so stiff that what its
 * force was comes to rest in the step, nor from an onset with a power below 1 of the indentation, which is a jump. */
static void judge_starts(const struct thud_state *state, struct thud_collocation *x, double h)
{
    for (int a = 0; a < x->nactive; a++) {
        const int c = x->active[a];
        const struct thud_branch *b = x->begins[a].branch;
        const bool jumps = thud_row_starts_at_zero(state, c) && ((b->K != 0 && b->p < 1) || (b->D != 0 && b->r < 1));
        struct beginning *begins = &x->begins[a];
        const double stiffness =
            state->model->delassus[c * x->nc + c] * h * (0.5 * h * fabs(begins->by_d) + fabs(begins->by_v));
        begins->rough = jumps || stiffness > stiff;
    }
}

/* First guess: the forces of the last step go on where their contact has not switched; the others begin. */
static void guess(const struct thud_state *state, struct thud_collocation *x, double h)
{
    static const double farthest = 32; /* times the last step: its sixth power is 1e9 */
    const struct step *last = &x->step;
    for (int a = 0; a < x->nactive; a++) {
        const int c = x->active[a];
        if (last->of[c].known && last->done_s + h <= farthest * last->h)
            extrapolate(x, c, h, x->force + a * x->by->n);
        else
            begin_force(state, x, a, h);
        x->force[a * x->by->n] = x->begins[a].force;
    }
}

/* Keeps the forces at the nodes as polynomials of a step that begins at the state. */
static void keep_step(const struct thud_state *state, struct thud_collocation *x, double h)
{
    const int n = x->by->n;
    for (int c = 0; c < x->nc; c++)
        x->step.of[c] =
            is_awaited(state, x, c) ? (struct branch_name){true, THUD_CLOSED, THUD_APPROACH, false} : name_of(state, c);
    for (int a = 0; a < x->nactive; a++) {
        double *coefficient = x->step.coefficient + x->active[a] * ROW;
        for (int p = 0; p < n; p += 2) {
            thud_vec2 sum = {0, 0};
            for (int k = 0; k < n; k++)
                sum += x->force[a * n + k] * thud_vec2_at(x->by->lagrange[k] + p);
            thud_vec2_put(sum, coefficient + p);
        }
    }
    x->step.n = n;
    x->step.h = h;
    x->step.done_s = 0;
}

/* The motion under the forces of the step. */
static void write_segment(const struct thud_state *state, struct thud_segment *seg, struct thud_collocation *x)
{
    const double h = x->step.h, least = fmax(THUD_TOL_SERIES, series_part * state->tolerance);
    const int n = x->by->n;
    int *terms = &x->by->terms[x->made_level];
    if (*terms == 0)
        *terms = thud_segment_terms(state->fastest_radps * h, least, n + 3);
    thud_segment_begin(state, seg, h, *terms);
    seg->loaded = n;
    for (int a = 0; a < x->nactive; a++)
        if (is_awaited(state, x, x->active[a])) {
            seg->row[seg->rows++] = x->active[a];
            seg->notes->begun[x->active[a]] = INFINITY;
        }
    for (int a = 0; a < x->nactive; a++)
        for (int k = 0; k < n; k++)
            seg->force[k * x->nc + x->active[a]] = x->step.coefficient[x->active[a] * ROW + k];
    thud_taylor_given(state->model, seg, state->q, state->qd);
    if (state->model->couples)
        thud_segment_trim(seg, state->model, 0.1 * least);
    x->by->nodes.motion = x->motion;
    x->by->nodes.force = x->force;
    seg->nodes = &x->by->nodes;
}

/* Whether a row is an open contact that is expected to close in the step, as it goes now, and need not end it: its force
 * begins with no slope, whatever the speed, and stays so small that its polynomial may bend there. */
static bool may_begin(const struct thud_state *state, const struct thud_collocation *x, int row)
{
    const struct thud_contact_state *s = thud_row_contact(state, row);
    const struct thud_branch *b = s ? &s->branch : NULL;
    if (!s || s->mode != THUD_OPEN || s->suppressed.indentation > 0 || b->K == 0 || b->D != 0 ||
        !thud_branch_is_smooth(b))
        return false;
    double motion[2];
    thud_contact_motion(state, row, motion);
    const double d = motion[0] + motion[1] * thud_smaller(x->h, thud_state_remaining(state));
    return motion[0] < 0 && d > 0 &&
           thud_branch_force(b, d, 0, NULL, NULL) <= begins_below * state->tolerance * s->expected_force_n;
}

bool thud_collocation_awaits(const struct thud_state *state, const struct thud_collocation *x)
{
    bool awaits = false;
    for (int c = 0; c < state->model->ncontacts; c++)
        awaits = awaits || may_begin(state, x, c);
    return awaits;
}

static void find_active(const struct thud_state *state, struct thud_collocation *x)
{
    int n = 0;
    for (int c = 0; c < x->nc; c++) {
        const bool acts = thud_row_acts(state, c) || may_begin(state, x, c);
        if (acts != (x->at[c] >= 0))
            x->made_by = NULL;
        x->at[c] = acts ? n : -1;
        x->active[n] = c;
        n += acts;
    }
    x->nactive = n;
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
        sticking += x->begins[a].sticks;
    if (sticking > 1 && state->model->left_out > 0) /* all modes tell any floors apart */
        return thud_state_too_few_modes(state, err);
    return thud_error_set(err, THUD_DIVERGED, "no step is short enough for the contact forces at t = %.6g s",
                          thud_state_now(state));
}

/* Few nodes are cheap, of many the steps are long: few where those of the longest step are more than enough. */
static void choose_scheme(struct thud_collocation *x)
{
    if (x->h < 0.5 * x->h_top)
        x->by = &x->many;
    else if (x->h >= 3 * x->h_top)
        x->by = &x->few;
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
                                    double tolerance, double *error, struct thud_error *err)
{
    const double h = thud_level_step(x->h_top, level), least = solution_part * tolerance;
    *error = INFINITY;
    enum thud_status status = THUD_OK;
    if (x->made_by != x->by || x->made_level != level)
        status = thud_responses_make(x->by->responses, level, x->active, x->nactive, x->response, err);
    if (status != THUD_OK)
        return status;
    x->made_by = x->by;
    x->made_level = level;
    thud_responses_unforced(x->by->responses, state, level, x->active, x->nactive, x->motion, x->free);
    judge_starts(state, x, h);
    guess(state, x, h);
    if (iterate(state, x, h, least) || solve(state, x, least)) {
        keep_step(state, x, h); /* should it be too long, a shorter one begins with these forces */
        *error = error_of_step(state, x, h, tolerance);
    } else {
        memset(x->step.of, 0, (size_t)x->nc * sizeof *x->step.of);
    }
    return THUD_OK;
}

/* The size at which the error would be the tolerance: it falls with h^n. */
static double next_size(const struct thud_collocation *x, double h, double error, double tolerance)
{
    double grown = 1; /* of the error, where the step grows most */
    for (int i = 0; i < x->by->n; i++)
        grown *= most_growth / safety;
    if (!isfinite(error))
        return h * unsolved;
    return h * (error * grown <= tolerance ? most_growth
                                           : thud_larger(most_shrink, safety * pow(tolerance / error, 1.0 / x->by->n)));
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
    const double tolerance = step_tolerance(state), ahead = thud_state_remaining(state);
    double before = INFINITY, error;
    choose_size(x);
    choose_scheme(x);
    start_forces(state, x);
    for (int same = 0;;) {
        const int level = level_for(x, x->h, ahead);
        const double want = x->h, h = thud_level_step(x->h_top, level);
        const enum thud_status status = solve_level(state, x, level, tolerance, &error, err);
        if (status != THUD_OK)
            return status;
        same = error > same_error * before && error <= near_tolerance * tolerance ? same + 1 : 0;
        before = error;
        x->h = same >= REPEATS ? most_growth * h : next_size(x, h, error, tolerance);
        if (error <= tolerance || same >= REPEATS) {
            accept(x, level, h, want);
            return THUD_OK;
        }
        x->h = fmin(x->h, 0.5 * h);
        state->work->rejected++;
        if (level + 1 >= LEVELS)
            return too_short(state, x, err);
    }
}

enum thud_status thud_collocation_step(const struct thud_state *state, struct thud_segment *seg,
                                       struct thud_collocation *x, struct thud_error *err)
{
    find_active(state, x);
    enum thud_status status = reserve(state, x, x->nactive, err);
    if (status == THUD_OK)
        status = make_step(state, x, err);
    if (status == THUD_OK)
        write_segment(state, seg, x);
    return status;
}
