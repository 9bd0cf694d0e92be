#include "core/methods/alpha_step.h"

#include <assert.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/model/modal_operator.h"
#include "core/numerics/tolerance.h"

/* Glossary, for one step of length h from t0 to t1; index j is a mode, a and c are rows (contacts, yielding storeys).
 *
 *     q0, q0', r0      x->start   modal displacement (m kg^1/2), velocity, and acceleration by the equations of motion,
 *     q1, v1, r1       x->end     r = -D q' - Omega^2 q - gamma a_g - sum_c g_c F_c, at both ends of the step
 *     a0, a1           x->a0, a1  the scheme's own accelerations, as in alpha_step.h
 *     A                x->op      ((1 - am) I + (1 - af)(gamma h D + beta h^2 Omega^2))^-1
 *     F_c              .force     force of row c, N; unknown at t1 where the row is active
 *     -da1/dF_c        x->response = (1 - af) A g_c, one row of nmodes for each c
 *     w_ac             x->w       -dd''_a/dF_c = g_a . (1 - af) A g_c, 1/kg
 *     d_a, d_a', d_a'' x->d, v, a indentation (drift) of row a at t1 and its rates if no active row had a force
 *
 * Without forces at t1, a1 follows from A at once (predict). With them, what is left is small: as many unknowns as rows
 * are active,
 *
 *     F_a = law_a(d_a - beta h^2 sum_c w_ac F_c,  d_a' - gamma h sum_c w_ac F_c)      (solve_forces, by Newton's method)
 *
 * and q1, v1, a1 are corrected by them (correct). */
enum { NEWTON_MAX = 40 };

struct alpha {
    struct thud_alpha p;
    struct thud_modal_operator *op;
    double h_made; /* step that the operator and the responses belong to */
    struct thud_motion start, end, work;
    double *a0, *a1;            /* (nmodes) */
    double *rhs;                /* (nmodes) workspace */
    double *response;           /* (nrows x nmodes) */
    double *w;                  /* (nrows x nrows) */
    double *d, *v, *a;          /* (nrows) */
    double *matrix, *change;    /* Newton's system for the active rows, column-major, and its solution */
    lapack_int *active, *pivot; /* (nrows) rows whose forces are unknown */
    int nactive;
    bool solved;                     /* the contact forces at t1 are those of the laws */
    bool goes_on;                    /* t0 is the end of the last step: no law has changed there */
    bool fresh;                      /* a0 is to be made anew, from r0 */
    double a0_step_s;                /* step that a0 comes from */
    double ground_mps2, before_mps2; /* ground acceleration at t1, and at the end of the step before */
    double *block;
};

/* The scheme's a0 is r at the time t0 + (am - af) h, to second order: 0 where a is r itself, as Newmark's and central
 * difference's is. It passes from step to step, but not over a jump of the forces (a contact switched, the record ended),
 * which it would smear. */
static double time_offset(const struct thud_alpha *p)
{
    return p->am - p->af;
}

enum thud_status thud_alpha_create(const struct thud_state *state, struct thud_alpha parameters, void **own,
                                   struct thud_error *err)
{
    const struct thud_model *m = state->model;
    const size_t n = (size_t)m->nmodes, nc = (size_t)m->nrows, size = thud_motion_size(m);
    struct alpha *x = calloc(1, sizeof *x);
    *own = NULL;
    assert(time_offset(&parameters) != 0 || parameters.am == 0);
    if (x) {
        x->block = calloc(3 * size + 3 * n + nc * n + 2 * nc * nc + 4 * nc + 1, sizeof *x->block);
        x->active = calloc(2 * nc + 1, sizeof *x->active);
    }
    if (!x || !x->block || !x->active || thud_modal_operator_create(m, &x->op, err) != THUD_OK) {
        thud_alpha_free(x);
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    x->a0 = thud_motion_place(&x->start, m, x->block);
    x->a0 = thud_motion_place(&x->end, m, x->a0);
    x->a0 = thud_motion_place(&x->work, m, x->a0);
    x->a1 = x->a0 + n;
    x->rhs = x->a1 + n;
    x->response = x->rhs + n;
    x->w = x->response + nc * n;
    x->matrix = x->w + nc * nc;
    x->change = x->matrix + nc * nc;
    x->d = x->change + nc;
    x->v = x->d + nc;
    x->a = x->v + nc;
    x->pivot = x->active + nc;
    x->p = parameters;
    x->fresh = true;
    *own = x;
    return THUD_OK;
}

void thud_alpha_free(void *own)
{
    struct alpha *x = own;
    if (!x)
        return;
    thud_modal_operator_free(x->op);
    free(x->block);
    free(x->active);
    free(x);
}

/* Operator and responses for steps of length h; kept while steps differ by rounding only. */
static void prepare(const struct thud_model *m, struct alpha *x, double h)
{
    if (fabs(h - x->h_made) <= THUD_TOL_STEP_CHANGE * h)
        return;
    const double part = 1 - x->p.af;
    x->h_made = h;
    thud_modal_operator_set(x->op, m, 1 - x->p.am, part * x->p.gamma * h, part * x->p.beta * h * h);
    for (int c = 0; c < m->nrows; c++) {
        double *r = x->response + c * m->nmodes;
        thud_modal_operator_apply(x->op, m, m->jacobian + c * m->nmodes, r);
        for (int j = 0; j < m->nmodes; j++)
            r[j] *= part;
        for (int a = 0; a < m->nrows; a++)
            x->w[a * m->nrows + c] = thud_model_gap_sum(m, a, r);
    }
}

/* Lagged: what acts in the step is the force found at the end of the step before, which still stands in end.force; the
 * law's now is for the next. */
static void lag_forces(const struct thud_state *state, struct alpha *x, double ground)
{
    double *law = x->start.force;
    x->start.force = x->end.force;
    x->end.force = law;
    thud_model_acceleration(state->model, state->q, state->qd, ground, x->start.qdd);
    thud_model_apply_contact_forces(state->model, x->start.force, x->start.qdd);
}

/* q0, q0', r0, a0 and the forces: those of the last step's end where it goes on, else from the state. Where the length of
 * the steps changes, a0 keeps its time offset in steps: it lies on the line through r0. */
static void start_step(const struct thud_state *state, struct alpha *x, double h)
{
    const size_t n = (size_t)state->model->nmodes;
    const double ground = thud_step_ground(state, 0), jump = fabs(ground - x->before_mps2),
                 size = fabs(ground) + fabs(x->before_mps2);
    if (x->goes_on && jump <= THUD_TOL_GROUND * size) {
        const struct thud_motion last = x->start;
        x->start = x->end;
        x->end = last;
    } else {
        memcpy(x->start.q, state->q, n * sizeof(double));
        memcpy(x->start.qd, state->qd, n * sizeof(double));
        thud_step_motion(state, &x->start, 0);
    }
    if (x->p.lagged)
        lag_forces(state, x, ground);
    x->fresh = x->fresh || jump > THUD_TOL_GROUND_JUMP * size;
    if (time_offset(&x->p) == 0)
        return;
    if (x->fresh)
        memcpy(x->a0, x->start.qdd, n * sizeof(double));
    else if (fabs(h - x->a0_step_s) > THUD_TOL_STEP_CHANGE * h)
        for (size_t j = 0; j < n; j++)
            x->a0[j] = x->start.qdd[j] + h / x->a0_step_s * (x->a0[j] - x->start.qdd[j]);
}

/* Newmark's update without the part of a1: by_q = h^2 (1/2 - beta), by_v = h (1 - gamma). */
static void update(int n, double h, double by_q, double by_v, const double *restrict q0, const double *restrict v0,
                   const double *restrict a0, double *restrict q, double *restrict v)
{
    for (int j = 0; j < n; j++) {
        q[j] = q0[j] + h * v0[j] + by_q * a0[j];
        v[j] = v0[j] + by_v * a0[j];
    }
}

/* The part of a1: by_q = h^2 beta, by_v = h gamma. */
static void add_end(int n, double by_q, double by_v, const double *restrict a1, double *restrict q, double *restrict v)
{
    for (int j = 0; j < n; j++) {
        q[j] += by_q * a1[j];
        v[j] += by_v * a1[j];
    }
}

/* q1, v1, a1 if no contact force acted at t1. With a1 = 0 in Newmark's update first, a1 = A ((1 - af) r(q1, v1) + af r0 -
 * am a0), and its part is added. */
static void predict(const struct thud_state *state, struct alpha *x, double h)
{
    const struct thud_model *m = state->model;
    const struct thud_alpha *p = &x->p;
    const bool own = time_offset(p) != 0;
    const int n = m->nmodes;
    update(n, h, h * h * (0.5 - p->beta), h * (1 - p->gamma), x->start.q, x->start.qd, own ? x->a0 : x->start.qdd,
           x->end.q, x->end.qd);
    x->ground_mps2 = thud_step_ground(state, h);
    thud_model_acceleration(m, x->end.q, x->end.qd, x->ground_mps2, x->rhs);
    for (int j = 0; j < n && own; j++)
        x->rhs[j] = (1 - p->af) * x->rhs[j] + p->af * x->start.qdd[j] - p->am * x->a0[j];
    thud_modal_operator_apply(x->op, m, x->rhs, x->a1);
    add_end(n, h * h * p->beta, h * p->gamma, x->a1, x->end.q, x->end.qd);
}

/* The part of the forces at t1 in a1, q1, v1. */
static void correct(const struct thud_model *m, struct alpha *x, double h)
{
    for (int c = 0; c < m->nrows; c++) {
        if (x->end.force[c] == 0)
            continue;
        for (int j = 0; j < m->nmodes; j++) {
            x->rhs[j] = -x->response[c * m->nmodes + j] * x->end.force[c];
            x->a1[j] += x->rhs[j];
        }
        add_end(m->nmodes, x->p.beta * h * h, x->p.gamma * h, x->rhs, x->end.q, x->end.qd);
    }
}

/* d, d' and d'' of row a at the step's end under the forces now tried. */
static void row_end(const struct thud_model *m, const struct alpha *x, int a, double h, double *d, double *v,
                    double *acc)
{
    double pull = 0;
    for (int c = 0; c < m->nrows; c++)
        pull += x->w[a * m->nrows + c] * x->end.force[c];
    *d = x->d[a] - x->p.beta * h * h * pull;
    *v = x->v[a] - x->p.gamma * h * pull;
    *acc = x->a[a] - pull;
}

/* Equation of active row i and its derivatives by all active forces: residual F - law(d, d') and row i of the matrix
 * I + (law_d beta h^2 + law_v gamma h) w; a contact that is held has d'' = 0 instead. */
static void linearize(const struct thud_state *state, struct alpha *x, int i, double h)
{
    const int n = x->nactive, nc = state->model->nrows, a = x->active[i];
    const double by_d = x->p.beta * h * h, by_v = x->p.gamma * h;
    const bool held = state->locates && thud_row_sticks(state, a);
    double d, v, acc, fd = 0, fv = 0;
    row_end(state->model, x, a, h, &d, &v, &acc);
    x->change[i] = held ? acc : x->end.force[a] - thud_step_force(state, a, d, v, &fd, &fv);
    /* the slope of a law may be without bound at d = 0, and with beta = 0 it does not count */
    const double slope = held ? -1 : (by_d > 0 ? fd * by_d : 0) + fv * by_v;
    for (int k = 0; k < n; k++)
        x->matrix[k * n + i] = slope * x->w[a * nc + x->active[k]] + (k == i && !held ? 1 : 0);
}

/* Newton's method on the forces of the active rows. Stops
 *   1) solved: the largest change, as a part of its force, is rounding, or small and no longer falling;
 *   2) not solved: the system is singular, or NEWTON_MAX steps have been taken. */
static bool solve(const struct thud_state *state, struct alpha *x, double h)
{
    const int n = x->nactive;
    double before = INFINITY;
    for (int steps = 0; steps < NEWTON_MAX; steps++) {
        double largest = 0;
        for (int i = 0; i < n; i++)
            linearize(state, x, i, h);
        if (LAPACKE_dgesv_work(LAPACK_COL_MAJOR, n, 1, x->matrix, n, x->pivot, x->change, n) != 0)
            return false;
        for (int i = 0; i < n; i++) {
            const double least = THUD_TOL_LEAST_ACCELERATION_MPS2 * state->model->contact[x->active[i]].setup.mass_kg;
            double *force = &x->end.force[x->active[i]], change = fabs(x->change[i]), was = fabs(*force);
            if (!isfinite(change))
                return false;
            *force -= x->change[i];
            largest = fmax(largest, change / fmax(fmax(was, fabs(*force)), least));
        }
        if (largest <= THUD_TOL_NEWTON || (largest < THUD_TOL_NEWTON_STALL && largest >= 0.5 * before))
            return true;
        before = largest;
    }
    return false;
}

static bool is_active(const struct alpha *x, int nactive, int c)
{
    for (int i = 0; i < nactive; i++)
        if (x->active[i] == c)
            return true;
    return false;
}

/* Takes the forces of more rows as unknown, with those of the step's start as first guess: located, of all that act;
 * else of all that yield and of the contacts that are closed at t1 under the forces so far. Returns whether there were
 * any. Clears end.apart where a contact is closed. */
static bool activate(const struct thud_state *state, struct alpha *x, double h)
{
    const struct thud_model *m = state->model;
    const int before = x->nactive;
    const bool locates = state->locates, any_open = x->p.beta > 0;
    for (int c = 0; c < m->nrows; c++) {
        const bool unlocated = !locates && c < m->ncontacts;
        double d, v, acc;
        if ((locates && !thud_row_acts(state, c)) || is_active(x, before, c))
            continue;
        if (before > 0)
            row_end(m, x, c, h, &d, &v, &acc);
        else
            d = x->d[c] = thud_model_gap_sum(m, c, x->end.q) - thud_state_clearance(state, c);
        if (unlocated && d <= 0 && !(any_open && x->start.force[c] != 0))
            continue;
        x->end.apart = false;
        if (unlocated && m->contact[c].law->flags & (THUD_LAW_NO_FORCE | THUD_LAW_IMPULSIVE))
            continue;
        x->v[c] = thud_model_gap_sum(m, c, x->end.qd);
        x->a[c] = thud_model_gap_sum(m, c, x->a1);
        x->active[x->nactive++] = c;
    }
    for (int i = before; i < x->nactive; i++)
        x->end.force[x->active[i]] = x->start.force[x->active[i]];
    return x->nactive > before;
}

/* Contact forces at t1. Where the law jumps (nothing located) there may be no solution: the last try is taken, as a
 * program does that only sees its iterations run out, and counted as rejected. Located, an elastic storey that has
 * yielded has a constant force. */
static void solve_forces(const struct thud_state *state, struct alpha *x, double h)
{
    const struct thud_model *m = state->model;
    for (int c = 0; c < m->nrows; c++)
        x->end.force[c] = state->locates && c >= m->ncontacts ? thud_row_branch(state, c)->f0_n : 0;
    x->nactive = 0;
    x->end.apart = !state->locates && m->nstoreys == 0;
    x->solved = true;
    while (x->solved && activate(state, x, h))
        x->solved = solve(state, x, h);
    state->work->rejected += !x->solved;
}

/* From t0 to t1 with given a0; r1 by the equations of motion, where a1 is not r1 itself. */
static void take_step(const struct thud_state *state, struct alpha *x, double h)
{
    predict(state, x, h);
    x->end.apart = false;
    if (!x->p.lagged)
        solve_forces(state, x, h);
    if (!x->end.apart)
        correct(state->model, x, h);
    if (!state->locates && time_offset(&x->p) == 0) {
        memcpy(x->end.qdd, x->a1, (size_t)state->model->nmodes * sizeof *x->a1);
        return;
    }
    thud_model_acceleration(state->model, x->end.q, x->end.qd, x->ground_mps2, x->end.qdd);
    thud_model_apply_contact_forces(state->model, x->end.force, x->end.qdd);
}

enum thud_status thud_alpha_step(const struct thud_state *state, void *own, struct thud_segment *seg,
                                 struct thud_error *err)
{
    struct alpha *x = own;
    const double h = thud_step_length(state);
    (void)err;
    prepare(state->model, x, h);
    start_step(state, x, h);
    take_step(state, x, h);
    if (x->fresh && time_offset(&x->p) != 0) {
        /* r0 and r1 tell how the acceleration changes: once more, with a0 at its time offset */
        for (int j = 0; j < state->model->nmodes; j++)
            x->a0[j] = x->start.qdd[j] + time_offset(&x->p) * (x->end.qdd[j] - x->start.qdd[j]);
        take_step(state, x, h);
    }
    x->a0_step_s = h;
    thud_step_write(state, seg, h, &x->start, &x->end, &x->work);
    return THUD_OK;
}

void thud_alpha_committed(const struct thud_state *state, void *own, const struct thud_segment *seg, double tau_s,
                          bool switched)
{
    struct alpha *x = own;
    double *now = x->a0;
    (void)seg, (void)tau_s;
    x->fresh = state->locates && switched; /* nothing located: the program does not know that anything happened */
    x->before_mps2 = x->ground_mps2;
    x->goes_on = !state->locates && !switched && !x->p.lagged && state->model->nstoreys == 0 && x->solved;
    x->a0 = x->a1;
    x->a1 = now;
}
