#include "core/alpha_step.h"

#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/modal_operator.h"
#include "core/tolerance.h"

enum { NEWTON_MAX = 40 };

struct alpha {
    struct thud_alpha p;
    struct thud_modal_operator *op;
    double h_made;                       /* step that the operator and the responses belong to */
    struct thud_motion start, end, work; /* accelerations by the equations of motion, also where the scheme's differ */
    double *a0, *a1;                     /* (nmodes) the scheme's own accelerations */
    double *rhs;                         /* (nmodes) */
    double *response;                    /* (nrows x nmodes): -da1/dF */
    double *w;                           /* (nrows x nrows): of the indentations' second rates */
    double *d, *v, *a, *change, *matrix; /* Newton's system, by active contact */
    double *applied;                     /* (nrows) lagged: force at the end of the step before */
    int *active;
    lapack_int *pivot;
    bool goes_on;                    /* the start of the step is the end of the last, with no contact force there */
    bool fresh;                      /* a0 is to be made anew, by the equations of motion */
    double a0_step_s;                /* step that a0 comes from */
    double ground_mps2, before_mps2; /* ground acceleration at the end of the step, and of the one before */
    double *block;
};

enum thud_status thud_alpha_create(const struct thud_state *state, struct thud_alpha parameters, void **own,
                                   struct thud_error *err)
{
    const struct thud_model *m = state->model;
    size_t n = (size_t)m->nmodes, nc = (size_t)m->nrows;
    struct alpha *x = calloc(1, sizeof *x);
    *own = NULL;
    if (!x)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    enum thud_status status = thud_modal_operator_create(m, &x->op, err);
    x->block = calloc(3 * thud_motion_size(m) + 3 * n + nc * n + 2 * nc * nc + 5 * nc + 1, sizeof(double));
    x->active = calloc(nc + 1, sizeof *x->active);
    x->pivot = calloc(nc + 1, sizeof *x->pivot);
    if (status != THUD_OK || !x->block || !x->active || !x->pivot) {
        thud_alpha_free(x);
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    double *next = thud_motion_place(&x->start, m, x->block);
    next = thud_motion_place(&x->end, m, next);
    next = thud_motion_place(&x->work, m, next);
    double **vectors[] = {&x->a0, &x->a1, &x->rhs};
    for (int i = 0; i < 3; i++, next += n)
        *vectors[i] = next;
    double **contacts[] = {&x->d, &x->v, &x->a, &x->change, &x->applied};
    for (int i = 0; i < 5; i++, next += nc)
        *contacts[i] = next;
    x->w = next;
    x->matrix = x->w + nc * nc;
    x->response = x->matrix + nc * nc;
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
    free(x->pivot);
    free(x);
}

/* Operator and responses for steps of length h; kept while steps differ by rounding only. */
static void prepare(const struct thud_model *m, struct alpha *x, double h)
{
    if (fabs(h - x->h_made) <= THUD_TOL_STEP_CHANGE * h)
        return;
    const struct thud_alpha *p = &x->p;
    double share = 1 - p->af;
    x->h_made = h;
    thud_modal_operator_set(x->op, m, 1 - p->am, share * p->gamma * h, share * p->beta * h * h);
    for (int c = 0; c < m->nrows; c++) {
        double *r = x->response + c * m->nmodes;
        thud_modal_operator_apply(x->op, m, m->jacobian + c * m->nmodes, r);
        for (int j = 0; j < m->nmodes; j++)
            r[j] *= share;
        for (int a = 0; a < m->nrows; a++)
            x->w[a * m->nrows + c] = thud_model_gap_sum(m, a, r);
    }
}

/* The scheme's own acceleration belongs to a time this many steps behind the state's. It goes on from step to step, at
 * the same distance in each; but not over a jump of the forces (a contact switched, the record ended), which it would
 * smear. For Newmark it is that of the equations of motion. */
static double offset(const struct thud_alpha *p)
{
    return p->am - p->af;
}

static void start_step(const struct thud_state *state, struct alpha *x, double h)
{
    const struct thud_model *m = state->model;
    size_t bytes = (size_t)m->nmodes * sizeof(double);
    double ground = thud_step_ground(state, 0);
    if (x->goes_on && fabs(ground - x->before_mps2) <= THUD_TOL_GROUND * (fabs(ground) + fabs(x->before_mps2))) {
        struct thud_motion last = x->start; /* the end of the last step, with no contact force there */
        x->start = x->end;
        x->end = last;
    } else {
        memcpy(x->start.q, state->q, bytes);
        memcpy(x->start.qd, state->qd, bytes);
        thud_step_motion(state, &x->start, 0);
    }
    if (x->p.lagged) { /* what acts now is the force of the step before */
        for (int c = 0; c < m->nrows; c++) {
            x->end.force[c] = x->start.force[c];
            x->start.force[c] = x->applied[c];
        }
        thud_model_acceleration(m, state->q, state->qd, thud_step_ground(state, 0), x->start.qdd);
        thud_model_apply_contact_forces(m, x->start.force, x->start.qdd);
    }
    x->fresh = x->fresh || fabs(ground - x->before_mps2) > THUD_TOL_GROUND_JUMP * (fabs(ground) + fabs(x->before_mps2));
    if (x->fresh || offset(&x->p) == 0) {
        memcpy(x->a0, x->start.qdd, bytes);
    } else if (fabs(h - x->a0_step_s) > THUD_TOL_STEP_CHANGE * h) {
        for (int j = 0; j < m->nmodes; j++)
            x->a0[j] = x->start.qdd[j] + h / x->a0_step_s * (x->a0[j] - x->start.qdd[j]);
    }
}

/* The end of the step if no contact force acted there: q, qd, a1. */
static void predict(const struct thud_state *state, struct alpha *x, double h)
{
    const struct thud_model *m = state->model;
    const struct thud_alpha *p = &x->p;
    for (int j = 0; j < m->nmodes; j++) {
        x->end.q[j] = state->q[j] + h * state->qd[j] + h * h * (0.5 - p->beta) * x->a0[j];
        x->end.qd[j] = state->qd[j] + h * (1 - p->gamma) * x->a0[j];
    }
    x->ground_mps2 = thud_step_ground(state, h);
    thud_model_acceleration(m, x->end.q, x->end.qd, x->ground_mps2, x->rhs);
    for (int j = 0; j < m->nmodes; j++)
        x->rhs[j] = (1 - p->af) * x->rhs[j] + p->af * x->start.qdd[j] - p->am * x->a0[j];
    thud_modal_operator_apply(x->op, m, x->rhs, x->a1);
    for (int j = 0; j < m->nmodes; j++) {
        x->end.q[j] += p->beta * h * h * x->a1[j];
        x->end.qd[j] += p->gamma * h * x->a1[j];
    }
}

static bool counts(const struct thud_state *state, int c)
{
    if (state->locates && c >= state->model->ncontacts)
        return state->contact[c].mode == THUD_CLOSED;
    if (state->locates)
        return thud_contact_acts(&state->contact[c]);
    return !(state->model->contact[c].law->flags & (THUD_LAW_NO_FORCE | THUD_LAW_IMPULSIVE));
}

/* Indentation, its rate and second rate of contact a at the step's end under the forces now tried. */
static void contact_end(const struct thud_state *state, const struct alpha *x, int a, double h, double *d, double *v,
                        double *acc)
{
    const struct thud_model *m = state->model;
    double pull = 0;
    for (int c = 0; c < m->nrows; c++)
        pull += x->w[a * m->nrows + c] * x->end.force[c];
    *d = x->d[a] - x->p.beta * h * h * pull;
    *v = x->v[a] - x->p.gamma * h * pull;
    *acc = x->a[a] - pull;
}

/* One Newton step for n active contacts; returns the largest change relative to the forces. */
static double newton(const struct thud_state *state, struct alpha *x, int n, double h)
{
    int nc = state->model->nrows;
    double largest = 0;
    for (int i = 0; i < n; i++) {
        int a = x->active[i];
        double d, v, acc, fd = 0, fv = 0, own = 1;
        contact_end(state, x, a, h, &d, &v, &acc);
        double by_d = x->p.beta * h * h, by_v = x->p.gamma * h, by_a = 0;
        if (state->contact[a].mode == THUD_STICKING && state->locates) { /* held: no second rate */
            own = 0;
            by_a = -1;
            x->change[i] = acc;
        } else {
            x->change[i] = x->end.force[a] - thud_step_force(state, a, d, v, &fd, &fv);
        }
        double by_slope = by_d > 0 ? fd * by_d : 0; /* the slope may be without bound at d = 0 */
        for (int k = 0; k < n; k++)
            x->matrix[k * n + i] = (by_slope + fv * by_v + by_a) * x->w[a * nc + x->active[k]] + (k == i ? own : 0);
    }
    if (n == 1)
        x->change[0] /= x->matrix[0];
    else if (LAPACKE_dgesv_work(LAPACK_COL_MAJOR, n, 1, x->matrix, n, x->pivot, x->change, n) != 0)
        return NAN;
    for (int i = 0; i < n; i++)
        if (!isfinite(x->change[i]))
            return NAN;
    for (int i = 0; i < n; i++) {
        int a = x->active[i];
        double before = fabs(x->end.force[a]);
        x->end.force[a] -= x->change[i];
        double scale = fmax(fmax(before, fabs(x->end.force[a])),
                            THUD_TOL_LEAST_ACCELERATION_MPS2 * state->model->contact[a].setup.mass_kg);
        largest = fmax(largest, fabs(x->change[i]) / scale);
    }
    return largest;
}

/* Nothing located: whether no contact has a force at the start of the step, or without one at its end; then there is
 * none at its end. */
static bool stays_open(const struct thud_state *state, const struct alpha *x)
{
    const struct thud_model *m = state->model;
    for (int c = 0; c < m->ncontacts; c++)
        if (x->start.force[c] != 0 || thud_model_gap_sum(m, c, x->end.q) > thud_state_clearance(state, c))
            return false;
    return true;
}

/* Contact forces of the step's end. Where the law jumps (nothing located) there may be no solution: the last try is
 * taken, as a program does that only sees its iterations run out, and counted as rejected. */
static void solve_forces(const struct thud_state *state, struct alpha *x, double h)
{
    int n = 0;
    x->end.apart = !state->locates && state->model->nstoreys == 0 && stays_open(state, x);
    if (x->end.apart)
        return;
    for (int c = 0; c < state->model->nrows; c++) {
        if (!counts(state, c))
            continue;
        x->d[c] = thud_model_gap_sum(state->model, c, x->end.q) - thud_state_clearance(state, c);
        if (!state->locates && x->p.beta == 0 && c < state->model->ncontacts && x->d[c] <= 0)
            continue; /* explicit in the displacements: no force can indent it, and it has none */
        x->v[c] = thud_model_gap_sum(state->model, c, x->end.qd);
        x->a[c] = thud_model_gap_sum(state->model, c, x->a1);
        x->active[n++] = c;
        x->end.force[c] = x->start.force[c];
    }
    if (n == 0)
        return;
    double before = INFINITY;
    for (int i = 0; i < NEWTON_MAX; i++) {
        double change = newton(state, x, n, h);
        if (!isfinite(change))
            break;
        if (change <= THUD_TOL_NEWTON || (change < THUD_TOL_NEWTON_STALL && change >= 0.5 * before))
            return;
        before = change;
    }
    state->work->rejected++;
}

/* From the start to the end of the step with the scheme's a0 as it is. */
static void cross(const struct thud_state *state, struct alpha *x, double h)
{
    const struct thud_model *m = state->model;
    predict(state, x, h);
    x->end.apart = false;
    if (!x->p.lagged) {
        memset(x->end.force, 0, (size_t)m->nrows * sizeof *x->end.force);
        for (int c = m->ncontacts; c < m->nrows && state->locates; c++) /* constant forces of elastic storeys */
            x->end.force[c] = state->contact[c].mode == THUD_OPEN ? state->contact[c].branch.f0_n : 0;
        solve_forces(state, x, h);
    }
    for (int c = 0; c < m->nrows; c++) {
        if (x->end.force[c] == 0.0)
            continue;
        const double *r = x->response + c * m->nmodes;
        for (int j = 0; j < m->nmodes; j++) {
            double change = r[j] * x->end.force[c];
            x->a1[j] -= change;
            x->end.q[j] -= x->p.beta * h * h * change;
            x->end.qd[j] -= x->p.gamma * h * change;
        }
    }
    thud_model_acceleration(m, x->end.q, x->end.qd, x->ground_mps2, x->end.qdd);
    thud_model_apply_contact_forces(m, x->end.force, x->end.qdd);
}

enum thud_status thud_alpha_step(const struct thud_state *state, void *own, struct thud_segment *seg,
                                 struct thud_error *err)
{
    (void)err;
    struct alpha *x = own;
    double h = thud_step_length(state);
    prepare(state->model, x, h);
    start_step(state, x, h);
    cross(state, x, h);
    if (x->fresh && offset(&x->p) != 0) {
        /* how the acceleration changes is known now: once more with a0 in its place */
        for (int j = 0; j < state->model->nmodes; j++)
            x->a0[j] = x->start.qdd[j] + offset(&x->p) * (x->end.qdd[j] - x->start.qdd[j]);
        cross(state, x, h);
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
    x->goes_on = !state->locates && !switched && !x->p.lagged && state->model->nstoreys == 0;
    for (int c = 0; c < state->model->ncontacts; c++)
        x->goes_on = x->goes_on && x->end.force[c] == 0;
    x->a0 = x->a1;
    x->a1 = now;
    memcpy(x->applied, x->end.force, (size_t)state->model->nrows * sizeof *x->applied);
}
