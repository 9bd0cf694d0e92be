/* Contact forces at the end of an alpha step: as many unknowns as rows are active (glossary: alpha_private.h). */
#include <math.h>

#include "core/methods/alpha_private.h"
#include "core/numerics/tolerance.h"

enum { NEWTON_MAX = 40 };

/* d, d' and d'' of row a at the step's end under the forces now tried. */
static void row_end(const struct thud_model *m, const struct thud_alpha_work *x, int a, double h, double *d, double *v,
                    double *acc)
{
    double pull = 0;
    for (int c = 0; c < m->nrows; c++)
        pull += x->w[a * m->nrows + c] * x->end[1].force[c];
    *d = x->d[a] - x->p.beta * h * h * pull;
    *v = x->v[a] - x->p.gamma * h * pull;
    *acc = x->a[a] - pull;
}

/* Equation of active row i and its derivatives by all active forces: residual F - law(d, d') and row i of the matrix
 * I + (law_d beta h^2 + law_v gamma h) w; a contact that is held has d'' = 0 instead. */
static void linearize(const struct thud_state *state, struct thud_alpha_work *x, int i, double h)
{
    const int n = x->nactive, nc = state->model->nrows, a = x->active[i];
    const double by_d = x->p.beta * h * h, by_v = x->p.gamma * h;
    const bool held = state->locates && thud_row_sticks(state, a);
    double d, v, acc, fd = 0, fv = 0;
    row_end(state->model, x, a, h, &d, &v, &acc);
    x->change[i] = held ? acc : x->end[1].force[a] - thud_step_force(state, a, d, v, &fd, &fv);
    /* the slope of a law may be without bound at d = 0, and with beta = 0 it does not count */
    const double slope = held ? -1 : (by_d > 0 ? fd * by_d : 0) + fv * by_v;
    for (int k = 0; k < n; k++)
        x->matrix[k * n + i] = slope * x->w[a * nc + x->active[k]] + (k == i && !held ? 1 : 0);
}

/* Newton's method on the forces of the active rows. Stops
 *   1) solved: the largest change, as a part of its force, is rounding, or small and no longer falling;
 *   2) not solved: the system is singular, or NEWTON_MAX steps have been taken. */
static bool solve(const struct thud_state *state, struct thud_alpha_work *x, double h)
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
            const double least =
                THUD_TOL_LEAST_ACCELERATION_PS2 * state->length_m * state->model->contact[x->active[i]].setup.mass_kg;
            double *force = &x->end[1].force[x->active[i]], change = fabs(x->change[i]), was = fabs(*force);
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

static bool is_active(const struct thud_alpha_work *x, int nactive, int c)
{
    for (int i = 0; i < nactive; i++)
        if (x->active[i] == c)
            return true;
    return false;
}

/* Takes the forces of more rows as unknown, with those of the step's start as first guess: located, of all that act;
 * else of all that yield and of the contacts that are closed at t1 under the forces so far. Returns whether there were
 * any. Clears apart where a contact is closed. */
static bool activate(const struct thud_state *state, struct thud_alpha_work *x, double h)
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
            d = x->d[c] = thud_model_gap_sum(m, c, x->end[1].q) - thud_state_clearance(state, c);
        if (unlocated && d <= 0 && !(any_open && x->end[0].force[c] != 0))
            continue;
        x->end[1].apart = false;
        if (unlocated && m->contact[c].law->flags & (THUD_LAW_NO_FORCE | THUD_LAW_IMPULSIVE))
            continue;
        x->v[c] = thud_model_gap_sum(m, c, x->end[1].qd);
        x->a[c] = thud_model_gap_sum(m, c, x->a1);
        x->active[x->nactive++] = c;
    }
    for (int i = before; i < x->nactive; i++)
        x->end[1].force[x->active[i]] = x->end[0].force[x->active[i]];
    return x->nactive > before;
}

void thud_alpha_forces(const struct thud_state *state, struct thud_alpha_work *x, double h)
{
    const struct thud_model *m = state->model;
    for (int c = 0; c < m->nrows; c++)
        x->end[1].force[c] = state->locates && c >= m->ncontacts ? thud_row_branch(state, c)->f0_n : 0;
    x->nactive = 0;
    x->end[1].apart = !state->locates && m->nstoreys == 0;
    x->solved = true;
    while (x->solved && activate(state, x, h))
        x->solved = solve(state, x, h);
    state->work->rejected += !x->solved;
}
