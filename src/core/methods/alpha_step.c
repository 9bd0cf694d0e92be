#include "core/methods/alpha_step.h"

#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/model/modal_operator.h"
#include "core/numerics/double_pair.h"
#include "core/numerics/tolerance.h"

enum { NEWTON_MAX = 40, FEW = 8 }; /* contacts for which calling LAPACK costs more than solving */

struct alpha {
    struct thud_alpha p;
    struct thud_modal_operator *op;
    double h_made;                       /* step that the operator and the responses belong to */
    struct thud_motion start, end, work; /* accelerations by the equations of motion, also where the scheme's differ */
    bool differ;                         /* they do: am or af is not 0 */
    double *a0, *a1;                     /* (nmodes) the scheme's own accelerations, where they differ */
    double *rhs;                         /* (nmodes) */
    double *table;                       /* (4 x nmodes) inverse of the operator, omega^2, 2 zeta omega, gamma */
    double *by_mode;                     /* (nmodes x stride) the Jacobian of the contacts, mode after mode */
    int stride;                          /* their number, made a multiple of four */
    double energy;                       /* sum of omega^2 q^2 + q'^2 at the start; NaN: not known */
    double room;                         /* as far as the modal coordinates may move before anything can touch */
    double push;                         /* size of the ground motion's peak in modal coordinates */
    long left;                           /* steps of this length that are left of the interval */
    double *response;                    /* (nrows x nmodes): -da1/dF */
    double *w;                           /* (nrows x nrows): of the indentations' second rates */
    double *d, *v, *a, *change, *matrix; /* Newton's system, by active contact */
    double *applied;                     /* (nrows) lagged: force at the end of the step before */
    int *active;
    lapack_int *pivot;
    bool solved;                     /* the contact forces of the step's end are those of the laws */
    bool goes_on;                    /* the start of the step is the end of the last: no law has changed there */
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
    x->stride = 4 * ((m->ncontacts + 3) / 4);
    size_t stride = (size_t)x->stride, doubles = 7 * n + n * stride + nc * n + 2 * nc * nc + 5 * nc + 1;
    x->block = calloc(3 * thud_motion_size(m) + doubles, sizeof(double));
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
    x->table = x->response + nc * n;
    x->by_mode = x->table + 4 * n;
    memcpy(x->table + n, m->spring, n * sizeof *x->table);
    memcpy(x->table + 2 * n, m->dashpot, n * sizeof *x->table);
    memcpy(x->table + 3 * n, m->gamma, n * sizeof *x->table);
    for (int c = 0; c < m->ncontacts; c++)
        for (int j = 0; j < m->nmodes; j++)
            x->by_mode[j * x->stride + c] = m->jacobian[c * m->nmodes + j];
    for (int j = 0; j < m->nmodes; j++)
        x->push += m->gamma[j] * m->gamma[j];
    x->push = sqrt(x->push) * state->ground_mps2;
    x->energy = NAN;
    x->p = parameters;
    x->differ = parameters.am != 0 || parameters.af != 0;
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
    memcpy(x->table, thud_modal_operator_diagonal(x->op), (size_t)m->nmodes * sizeof *x->table);
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
    double ground = thud_step_ground(state, 0), jump = fabs(ground - x->before_mps2),
           size = fabs(ground) + fabs(x->before_mps2);
    if (x->goes_on && jump <= THUD_TOL_GROUND * size) {
        struct thud_motion last = x->start; /* the end of the last step */
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
        thud_model_acceleration(m, state->q, state->qd, ground, x->start.qdd);
        thud_model_apply_contact_forces(m, x->start.force, x->start.qdd);
    }
    if (!x->differ)
        return;
    x->fresh = x->fresh || jump > THUD_TOL_GROUND_JUMP * size;
    if (x->fresh || offset(&x->p) == 0) {
        memcpy(x->a0, x->start.qdd, bytes);
    } else if (fabs(h - x->a0_step_s) > THUD_TOL_STEP_CHANGE * h) {
        for (int j = 0; j < m->nmodes; j++)
            x->a0[j] = x->start.qdd[j] + h / x->a0_step_s * (x->a0[j] - x->start.qdd[j]);
    }
}

/* The scheme's own accelerations at the two ends of the step. */
static double *first(const struct alpha *x)
{
    return x->differ ? x->a0 : x->start.qdd;
}

static double *last(const struct alpha *x)
{
    return x->differ ? x->a1 : x->end.qdd;
}

/* What a step of length h multiplies by. */
struct factors {
    double h, q0, q1, v0, v1, share; /* of a0 and a1 in q and q'; 1 - af */
    const struct thud_alpha *p;
};

static struct factors factors_of(const struct thud_alpha *p, double h)
{
    return (struct factors){h, h * h * (0.5 - p->beta), h * h * p->beta, h * (1 - p->gamma), h * p->gamma, 1 - p->af,
                            p};
}

/* The end of the step of modes that nothing couples: q, q', a1. The motions are (3 x n): q, q', q''. */
static void predict_modes(int n, const struct factors *f, double ground, const double *restrict table,
                          const double *restrict start, const double *restrict a0, double *restrict end,
                          double *restrict a1)
{
    const double h = f->h, q0 = f->q0, q1 = f->q1, v0 = f->v0, v1 = f->v1, share = f->share, am = f->p->am,
                 af = f->p->af;
    for (int j = 0; j < n; j++) {
        double q = start[j] + h * start[n + j] + q0 * a0[j], v = start[n + j] + v0 * a0[j];
        double r = table[n + j] * q + table[2 * n + j] * v + table[3 * n + j] * ground;
        double a = table[j] * (af * start[2 * n + j] - am * a0[j] - share * r);
        a1[j] = a;
        end[j] = q + q1 * a;
        end[n + j] = v + v1 * a;
    }
}

/* The same where damping couples modes; and where events are located, whose order at one moment hangs on rounding. */
static void predict_coupled(const struct thud_model *m, struct alpha *x, const struct factors *f)
{
    const double *a0 = first(x);
    double *a1 = last(x);
    for (int j = 0; j < m->nmodes; j++) {
        x->end.q[j] = x->start.q[j] + f->h * x->start.qd[j] + f->q0 * a0[j];
        x->end.qd[j] = x->start.qd[j] + f->v0 * a0[j];
    }
    thud_model_acceleration(m, x->end.q, x->end.qd, x->ground_mps2, x->rhs);
    for (int j = 0; j < m->nmodes; j++)
        x->rhs[j] = f->share * x->rhs[j] + x->p.af * x->start.qdd[j] - x->p.am * a0[j];
    thud_modal_operator_apply(x->op, m, x->rhs, a1);
    for (int j = 0; j < m->nmodes; j++) {
        x->end.q[j] += f->q1 * a1[j];
        x->end.qd[j] += f->v1 * a1[j];
    }
}

/* The end of the step if no contact force acted there: q, q', a1. */
static void predict(const struct thud_state *state, struct alpha *x, double h)
{
    const struct thud_model *m = state->model;
    struct factors f = factors_of(&x->p, h);
    x->ground_mps2 = thud_step_ground(state, h);
    if (m->couples || state->locates)
        predict_coupled(m, x, &f);
    else
        predict_modes(m->nmodes, &f, x->ground_mps2, x->table, x->start.q, first(x), x->end.q, last(x));
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

static void swap(double *a, double *b)
{
    double t = *a;
    *a = *b;
    *b = t;
}

/* x of A x = b into b for a few unknowns, by Gauss with partial pivoting; A (n x n), column-major, is used up. What is
 * singular leaves what is not finite. */
static void solve_few(int n, double *a, double *b)
{
    for (int i = 0; i < n; i++) {
        int best = i;
        for (int k = i + 1; k < n; k++)
            best = fabs(a[i * n + k]) > fabs(a[i * n + best]) ? k : best;
        for (int j = i; j < n && best != i; j++)
            swap(&a[j * n + i], &a[j * n + best]);
        if (best != i)
            swap(&b[i], &b[best]);
        for (int k = i + 1; k < n; k++) {
            double factor = a[i * n + k] / a[i * n + i];
            for (int j = i + 1; j < n; j++)
                a[j * n + k] -= factor * a[j * n + i];
            b[k] -= factor * b[i];
        }
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int j = i + 1; j < n; j++)
            b[i] -= a[j * n + i] * b[j];
        b[i] /= a[i * n + i];
    }
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
    if (n > FEW && LAPACKE_dgesv_work(LAPACK_COL_MAJOR, n, 1, x->matrix, n, x->pivot, x->change, n) != 0)
        return NAN;
    if (n <= FEW)
        solve_few(n, x->matrix, x->change);
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

/* How far the modal coordinates (as a vector) may move from here before anything can touch; 0 or below where something is
 * near. */
static double room_before_contact(const struct thud_state *state, const struct alpha *x, const double *q)
{
    const struct thud_model *m = state->model;
    double least = INFINITY;
    for (int c = 0; c < m->ncontacts; c += 4) {
        const double *g = x->by_mode + c;
        thud_double_pair low = {0, 0}, high = {0, 0};
        for (int j = 0; j < m->nmodes; j++, g += x->stride) {
            low += thud_double_pair_at(g) * q[j];
            high += thud_double_pair_at(g + 2) * q[j];
        }
        for (int k = 0; k < 4 && c + k < m->ncontacts; k++) {
            double gap = thud_state_clearance(state, c + k) - THUD_TOL_PRESSED_M - (k < 2 ? low[k] : high[k - 2]);
            least = thud_smaller(least, gap / sqrt(m->delassus[(c + k) * (m->nrows + 1)]));
        }
    }
    return least;
}

/* Nothing located: whether no contact has a force at the start of the step, or without one at its end; then there is
 * none at its end. A step moves the modal coordinates by h times the largest rate in it, or twice that where it is
 * coarse: they are looked at again once they may have come near a contact. */
static bool stays_open(const struct thud_state *state, struct alpha *x, double h)
{
    const struct thud_model *m = state->model;
    for (int c = 0; c < m->ncontacts && !x->start.apart; c++)
        if (x->start.force[c] != 0)
            return false;
    x->room -= 2 * h * (sqrt(x->energy) + h * x->push);
    if (x->start.apart && x->room > 0)
        return true;
    x->room = room_before_contact(state, x, x->end.q);
    if (x->room > 0)
        return true;
    for (int c = 0; c < m->ncontacts; c++)
        if (thud_model_gap_sum(m, c, x->end.q) > thud_state_clearance(state, c))
            return false;
    return true;
}

/* Makes row c one of those whose forces are looked for. */
static void activate(const struct thud_state *state, struct alpha *x, int c, int *n)
{
    x->v[c] = thud_model_gap_sum(state->model, c, x->end.qd);
    x->a[c] = thud_model_gap_sum(state->model, c, last(x));
    x->active[(*n)++] = c;
    x->end.force[c] = x->start.force[c];
}

/* Nothing located: contacts that were left out, and that the forces on the others have closed. Returns their number. */
static int activate_closed(const struct thud_state *state, struct alpha *x, double h, int *n)
{
    const int before = *n;
    for (int c = 0; c < state->model->ncontacts && !state->locates; c++) {
        double d, v, acc;
        bool known = !counts(state, c) || x->d[c] > 0;
        for (int i = 0; i < before; i++)
            known = known || x->active[i] == c;
        if (known)
            continue;
        contact_end(state, x, c, h, &d, &v, &acc);
        if (d > 0)
            activate(state, x, c, n);
    }
    return *n - before;
}

/* Newton's method on the forces of n rows: whether it ends. */
static bool iterate(const struct thud_state *state, struct alpha *x, int n, double h)
{
    double before = INFINITY;
    for (int i = 0; i < NEWTON_MAX; i++) {
        double change = newton(state, x, n, h);
        if (!isfinite(change))
            return false;
        if (change <= THUD_TOL_NEWTON || (change < THUD_TOL_NEWTON_STALL && change >= 0.5 * before))
            return true;
        before = change;
    }
    return false;
}

/* Contact forces of the step's end. Where the law jumps (nothing located) there may be no solution: the last try is
 * taken, as a program does that only sees its iterations run out, and counted as rejected. */
static void solve_forces(const struct thud_state *state, struct alpha *x, double h)
{
    int n = 0;
    x->solved = true;
    x->end.apart = !state->locates && state->model->nstoreys == 0 && stays_open(state, x, h);
    if (x->end.apart)
        return;
    for (int c = 0; c < state->model->nrows; c++) {
        if (!counts(state, c))
            continue;
        x->d[c] = thud_model_gap_sum(state->model, c, x->end.q) - thud_state_clearance(state, c);
        if (state->locates || c >= state->model->ncontacts || x->d[c] > 0 ||
            (x->p.beta > 0 && x->start.force[c] != 0)) /* where nothing is located, an open one has no force */
            activate(state, x, c, &n);
    }
    do
        x->solved = n == 0 || iterate(state, x, n, h);
    while (x->solved && x->p.beta > 0 && activate_closed(state, x, h, &n) > 0);
    state->work->rejected += !x->solved;
}

/* What a force at the end of the step changes there: r (nmodes) is -da1/dF. */
static void push(int n, struct alpha *x, const double *r, double force, double h)
{
    double *a1 = last(x), by_q = x->p.beta * h * h, by_v = x->p.gamma * h;
    for (int j = 0; j < n; j++) {
        double change = r[j] * force;
        a1[j] -= change;
        x->end.q[j] -= by_q * change;
        x->end.qd[j] -= by_v * change;
    }
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
    for (int c = 0; c < m->nrows && !x->end.apart; c++)
        if (x->end.force[c] != 0.0)
            push(m->nmodes, x, x->response + c * m->nmodes, x->end.force[c], h);
    if (!x->differ && !state->locates) /* the scheme's own acceleration is theirs, but for rounding */
        return;
    thud_model_acceleration(m, x->end.q, x->end.qd, x->ground_mps2, x->end.qdd);
    thud_model_apply_contact_forces(m, x->end.force, x->end.qdd);
}

/* Where nothing is located, all steps of an interval of the ground motion are of one length. */
static double step_length(const struct thud_state *state, struct alpha *x)
{
    if (x->left > 1) {
        x->left--;
        return x->h_made;
    }
    double h = thud_step_length(state);
    x->left = state->locates ? 0 : lround(thud_step_room(state) / h);
    return h;
}

enum thud_status thud_alpha_step(const struct thud_state *state, void *own, struct thud_segment *seg,
                                 struct thud_error *err)
{
    (void)err;
    struct alpha *x = own;
    double h = step_length(state, x);
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
    x->energy = seg->end_energy;
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
    if (x->p.lagged)
        memcpy(x->applied, x->end.force, (size_t)state->model->nrows * sizeof *x->applied);
}
