/* Free flight over whole intervals of the ground motion by the exact 2x2 recurrence of every mode (Nigam and Jennings
 * 1969), as long as bounds show that neither a contact nor a new peak is possible inside the interval. What may hold
 * one goes the long way, through a segment: the answer is the same, only the work differs. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/quadrature.h"
#include "core/run_private.h"

/* Unit motions over one interval: initial q, initial q', ground acceleration falling from 1 to 0, and rising from 0
 * to 1. */
enum { UNIT_Q, UNIT_QD, UNIT_A0, UNIT_A1, UNITS };

struct thud_flight {
    int n; /* modes */
    /* One interval, by mode: q = e[0] q + e[1] q' + p[0] a0 + p[1] a1, q' = e[2] q + e[3] q' + p[2] a0 + p[3] a1 */
    double *e[4], *p[4];
    /* Damping loss over one interval: 0.5 x^T V x with x = (q, q', a0, a1), by mode; the ground's own terms summed over
     * the modes */
    double *viscous[7], viscous_ground[3];
    /* Work of the ground: a0 (r[0] q + r[1] q') + a1 (r[2] q + r[3] q') and the ground's own terms */
    double *work[4], work_ground[3];
    /* Bounds of second derivatives: largest participation of each mode in displacement or drift, by mode */
    double *shape, *drift_shape, *reach; /* reach: |gamma| */
    double *q, *qd;                      /* the interval's end */
    double *floor[2];                    /* (4 n): values at its two ends */
    double *gap[2];                      /* (ncontacts) */
    double *bound;                       /* (4 x nstructures): of displacement, velocity, acceleration, drift */
    double *block;
};

static bool modes_couple(const struct thud_model *m)
{
    for (int s = 0; s < m->nstructures; s++)
        if (m->structure[s].damping)
            return true;
    return false;
}

static bool allocate(struct thud_flight *f, const struct thud_model *m)
{
    size_t n = (size_t)m->ndof, nc = (size_t)m->ncontacts;
    double **vectors[32];
    int count = 0;
    for (int i = 0; i < 4; i++) {
        vectors[count++] = &f->e[i];
        vectors[count++] = &f->p[i];
        vectors[count++] = &f->work[i];
    }
    for (int i = 0; i < 7; i++)
        vectors[count++] = &f->viscous[i];
    double **rest[] = {&f->shape, &f->drift_shape, &f->reach, &f->q, &f->qd};
    for (size_t i = 0; i < sizeof rest / sizeof *rest; i++)
        vectors[count++] = rest[i];
    double *next = f->block = calloc((size_t)count * n + 8 * n + 2 * nc + 4 * (size_t)m->nstructures + 1, sizeof *next);
    if (!next)
        return false;
    for (int i = 0; i < count; i++, next += n)
        *vectors[i] = next;
    for (int i = 0; i < 2; i++) {
        f->floor[i] = next;
        f->gap[i] = next + 4 * n;
        next += 4 * n + nc;
    }
    f->bound = next;
    return true;
}

/* Rates of the four unit motions at one quadrature point enter the integrals of their products. */
static void add_point(struct thud_flight *f, const struct thud_model *m, double weight, double s,
                      double *const rate[UNITS])
{
    double a[2] = {1 - s, s};
    for (int j = 0; j < f->n; j++) {
        double w[UNITS], loss = 2 * m->zeta[j] * m->omega[j] * weight, drive = -m->gamma[j] * weight;
        for (int u = 0; u < UNITS; u++)
            w[u] = rate[u][j];
        f->viscous[0][j] += loss * w[0] * w[0];
        f->viscous[1][j] += loss * 2 * w[0] * w[1];
        f->viscous[2][j] += loss * w[1] * w[1];
        f->viscous[3][j] += loss * 2 * w[0] * w[2];
        f->viscous[4][j] += loss * 2 * w[0] * w[3];
        f->viscous[5][j] += loss * 2 * w[1] * w[2];
        f->viscous[6][j] += loss * 2 * w[1] * w[3];
        f->viscous_ground[0] += loss * w[2] * w[2];
        f->viscous_ground[1] += loss * 2 * w[2] * w[3];
        f->viscous_ground[2] += loss * w[3] * w[3];
        f->work[0][j] += drive * a[0] * w[0];
        f->work[1][j] += drive * a[0] * w[1];
        f->work[2][j] += drive * a[1] * w[0];
        f->work[3][j] += drive * a[1] * w[1];
        f->work_ground[0] += drive * a[0] * w[2];
        f->work_ground[1] += drive * (a[0] * w[3] + a[1] * w[2]);
        f->work_ground[2] += drive * a[1] * w[3];
    }
}

/* Marches the four unit motions through one interval in pieces short enough for the series. */
static enum thud_status unit_motions(struct thud_run *run, struct thud_flight *f, struct thud_error *err)
{
    const struct thud_model *m = run->model;
    size_t n = (size_t)m->ndof;
    double fastest = 0, *state = calloc(3 * UNITS * n + n + 1, sizeof *state);
    if (!state)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    double *q[UNITS], *qd[UNITS], *rate[UNITS], *spare = state + 3 * UNITS * n;
    for (int u = 0; u < UNITS; u++) {
        q[u] = state + (size_t)(3 * u) * n;
        qd[u] = q[u] + n;
        rate[u] = qd[u] + n;
    }
    for (int j = 0; j < m->ndof; j++) {
        q[UNIT_Q][j] = qd[UNIT_QD][j] = 1;
        fastest = fmax(fastest, m->omega[j]);
    }
    double dt = run->grid_dt_s;
    int pieces = 1 + (int)(fastest * dt / 1.2);
    struct thud_segment *seg = &run->seg;
    for (int i = 0; i < pieces; i++) {
        double s0 = (double)i / pieces, ds = 1.0 / pieces;
        for (int point = 0; point < THUD_QUADRATURE_POINTS + 1; point++) {
            bool last = point == THUD_QUADRATURE_POINTS;
            double s = last ? 1 : thud_quadrature_node[point];
            for (int u = 0; u < UNITS; u++) {
                thud_segment_begin(run, seg, dt * ds);
                seg->a0 = u == UNIT_A0 ? 1 - s0 : u == UNIT_A1 ? s0 : 0;
                seg->a1 = u == UNIT_A0 ? -ds : u == UNIT_A1 ? ds : 0;
                thud_taylor_given(m, seg, q[u], qd[u]);
                thud_segment_state(seg, m->ndof, s, last ? q[u] : spare, last ? qd[u] : rate[u]);
            }
            if (!last)
                add_point(f, m, thud_quadrature_weight[point] * ds * dt, s0 + s * ds, rate);
        }
    }
    for (int u = 0; u < UNITS; u++) {
        memcpy(u < 2 ? f->e[u] : f->p[u - 2], q[u], n * sizeof(double));
        memcpy(u < 2 ? f->e[u + 2] : f->p[u], qd[u], n * sizeof(double));
    }
    free(state);
    return THUD_OK;
}

static void shapes(struct thud_flight *f, const struct thud_model *m)
{
    for (int s = 0; s < m->nstructures; s++) {
        const struct thud_model_structure *p = &m->structure[s];
        for (int j = 0; j < p->n; j++) {
            double most = 0, drift = 0;
            for (int i = 0; i < p->n; i++) {
                double below = i > 0 ? p->phi[(i - 1) * p->n + j] : 0;
                most = fmax(most, fabs(p->phi[i * p->n + j]));
                drift = fmax(drift, fabs(p->phi[i * p->n + j] - below));
            }
            f->shape[p->first + j] = most;
            f->drift_shape[p->first + j] = drift;
            f->reach[p->first + j] = fabs(m->gamma[p->first + j]);
        }
    }
}

enum thud_status thud_flight_create(struct thud_run *run, struct thud_error *err)
{
    run->flight = NULL;
    if (modes_couple(run->model) || run->model->ndof == 0)
        return THUD_OK;
    struct thud_flight *f = calloc(1, sizeof *f);
    if (!f || !allocate(f, run->model)) {
        free(f);
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    f->n = run->model->ndof;
    shapes(f, run->model);
    enum thud_status status = unit_motions(run, f, err);
    if (status != THUD_OK) {
        thud_flight_free(f);
        return status;
    }
    run->flight = f;
    return THUD_OK;
}

void thud_flight_free(struct thud_flight *flight)
{
    if (!flight)
        return;
    free(flight->block);
    free(flight);
}

/* Displacement, velocity, total acceleration and drift of every floor, out (4 x n). */
static void floor_values(const struct thud_model *m, const double *q, const double *qd, double *out)
{
    int n = m->ndof;
    for (int s = 0; s < m->nstructures; s++) {
        const struct thud_model_structure *p = &m->structure[s];
        for (int i = 0; i < p->n; i++) {
            const double *row = p->phi + i * p->n;
            double u = 0, v = 0, a = 0;
            for (int j = 0; j < p->n; j++) {
                int k = p->first + j;
                u += row[j] * q[k];
                v += row[j] * qd[k];
                a += row[j] * m->omega[k] * (m->omega[k] * q[k] + 2 * m->zeta[k] * qd[k]);
            }
            int dof = p->first + i;
            out[dof] = u;
            out[n + dof] = v;
            out[2 * n + dof] = a;
            out[3 * n + dof] = !p->stiffness_npm ? 0 : i > 0 ? u - out[dof - 1] : u;
        }
    }
}

/* Bounds of the second derivatives over an interval from the state at its start, times dt^2/8: how far a value inside
 * may lie above those at the ends. */
static void bounds(struct thud_flight *f, const struct thud_run *run, double a0, double a1)
{
    const struct thud_model *m = run->model;
    double dt = run->grid_dt_s, ground = fmax(fabs(a0), fabs(a1)), slope = fabs(a1 - a0) / dt, eighth = dt * dt / 8;
    for (int s = 0; s < m->nstructures; s++) {
        const struct thud_model_structure *p = &m->structure[s];
        double sum[4] = {0};
        for (int j = p->first; j < p->first + p->n; j++) {
            double w = m->omega[j], z = 2 * m->zeta[j] * w;
            double push = f->reach[j] * ground;
            double speed = sqrt(run->qd[j] * run->qd[j] + w * w * run->q[j] * run->q[j]) + dt * push;
            double second = (w + z) * speed + push;
            double third = w * w * speed + z * second + f->reach[j] * slope;
            sum[0] += f->shape[j] * second;
            sum[1] += f->shape[j] * third;
            sum[2] += f->shape[j] * (w * w * second + z * third);
            sum[3] += f->drift_shape[j] * second;
        }
        for (int i = 0; i < 4; i++)
            f->bound[4 * s + i] = sum[i] * eighth;
    }
}

static bool below(double a, double b, double margin, double peak)
{
    return fmax(fabs(a), fabs(b)) + margin <= peak;
}

static bool no_new_peak(const struct thud_flight *f, const struct thud_run *run)
{
    const struct thud_model *m = run->model;
    int n = f->n;
    const double *x = f->floor[0], *y = f->floor[1];
    for (int s = 0; s < m->nstructures; s++) {
        const struct thud_model_structure *p = &m->structure[s];
        const double *margin = f->bound + 4 * s;
        for (int i = 0; i < p->n; i++) {
            const struct thud_floor_result *peak = &run->result.structure[s].floor[i];
            int d = p->first + i;
            if (!below(x[2 * n + d], y[2 * n + d], margin[2], peak->acceleration.value) ||
                !below(x[d], y[d], margin[0], peak->displacement.value) ||
                !below(x[n + d], y[n + d], margin[1], peak->velocity.value))
                return false;
            if (p->stiffness_npm && !below(x[3 * n + d], y[3 * n + d], margin[3], peak->drift.value))
                return false;
        }
    }
    return true;
}

static void gaps(const struct thud_run *run, const double *floor, double *out)
{
    const struct thud_model *m = run->model;
    for (int c = 0; c < m->ncontacts; c++) {
        const struct thud_model_contact *p = &m->contact[c];
        double left = p->left_dof < 0 ? 0 : floor[p->left_dof], right = p->right_dof < 0 ? 0 : floor[p->right_dof];
        out[c] = p->law->flags & THUD_LAW_SILENT ? -INFINITY : left - right - thud_run_shift(run, c);
    }
}

static bool no_contact(const struct thud_flight *f, const struct thud_model *m)
{
    for (int c = 0; c < m->ncontacts; c++) {
        const struct thud_model_contact *p = &m->contact[c];
        double margin = 0;
        if (p->left_dof >= 0)
            margin += f->bound[4 * m->dof_structure[p->left_dof]];
        if (p->right_dof >= 0)
            margin += f->bound[4 * m->dof_structure[p->right_dof]];
        if (fmax(f->gap[0][c], f->gap[1][c]) + margin > 0)
            return false;
    }
    return true;
}

static void advance(struct thud_flight *f, const struct thud_run *run, double a0, double a1)
{
    const double *q = run->q, *qd = run->qd;
    for (int j = 0; j < f->n; j++) {
        f->q[j] = f->e[0][j] * q[j] + f->e[1][j] * qd[j] + f->p[0][j] * a0 + f->p[1][j] * a1;
        f->qd[j] = f->e[2][j] * q[j] + f->e[3][j] * qd[j] + f->p[2][j] * a0 + f->p[3][j] * a1;
    }
}

static void add_energies(const struct thud_flight *f, struct thud_run *run, double a0, double a1)
{
    double loss = 0, work = 0;
    for (int j = 0; j < f->n; j++) {
        double q = run->q[j], v = run->qd[j];
        loss += q * (f->viscous[0][j] * q + f->viscous[1][j] * v + f->viscous[3][j] * a0 + f->viscous[4][j] * a1) +
                v * (f->viscous[2][j] * v + f->viscous[5][j] * a0 + f->viscous[6][j] * a1);
        work += a0 * (f->work[0][j] * q + f->work[1][j] * v) + a1 * (f->work[2][j] * q + f->work[3][j] * v);
    }
    const double *g = f->viscous_ground, *w = f->work_ground;
    run->ledger.viscous_j += loss + g[0] * a0 * a0 + g[1] * a0 * a1 + g[2] * a1 * a1;
    run->ledger.input_j += work + w[0] * a0 * a0 + w[1] * a0 * a1 + w[2] * a1 * a1;
}

static bool may_fly(const struct thud_run *run)
{
    if (run->offset_s != 0)
        return false;
    for (int c = 0; c < run->model->ncontacts; c++)
        if (run->contact[c].mode != THUD_OPEN || run->contact[c].zeros.indentation > 0)
            return false;
    return true;
}

static void swap(double **a, double **b)
{
    double *t = *a;
    *a = *b;
    *b = t;
}

/* Rows of the interval that is about to be committed. */
static enum thud_status rows(struct thud_run *run, struct thud_error *err)
{
    struct thud_segment *seg = &run->seg;
    thud_segment_begin(run, seg, run->grid_dt_s);
    if (thud_taylor_given(run->model, seg, run->q, run->qd) > 1e-12)
        return THUD_OK; /* too coarse a grid for one series: its rows come from where segments are made */
    return thud_history_segment(run, 1, err);
}

enum thud_status thud_flight_go(struct thud_run *run, long most, long *passed, struct thud_error *err)
{
    struct thud_flight *f = run->flight;
    enum thud_status status = THUD_OK;
    *passed = 0;
    if (!may_fly(run))
        return THUD_OK;
    long done = 0;
    floor_values(run->model, run->q, run->qd, f->floor[0]);
    gaps(run, f->floor[0], f->gap[0]);
    for (; done < most && (double)(run->grid + 1) * run->grid_dt_s <= run->end_s * (1 + 1e-12); done++) {
        double a0, a1;
        thud_run_ground(run, run->grid, &a0, &a1);
        advance(f, run, a0, a1);
        floor_values(run->model, f->q, f->qd, f->floor[1]);
        gaps(run, f->floor[1], f->gap[1]);
        bounds(f, run, a0, a1);
        if (!no_contact(f, run->model) || !no_new_peak(f, run))
            break;
        if (run->options.keep_history && (status = rows(run, err)) != THUD_OK)
            break;
        if (!run->options.no_ledger)
            add_energies(f, run, a0, a1);
        memcpy(run->q, f->q, (size_t)f->n * sizeof *run->q);
        memcpy(run->qd, f->qd, (size_t)f->n * sizeof *run->qd);
        swap(&f->floor[0], &f->floor[1]);
        swap(&f->gap[0], &f->gap[1]);
        run->grid++;
    }
    run->result.work.samples_fast += done;
    *passed = done;
    return status;
}
