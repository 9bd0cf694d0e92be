/* Free flight: the tables of one interval of the ground motion. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/free_vibration.h"
#include "core/quadrature.h"

/* Unit motions over one interval: initial q, initial q', ground acceleration falling from 1 to 0, and rising from 0
 * to 1. */
enum { UNIT_Q, UNIT_QD, UNIT_A0, UNIT_A1, UNITS };

static bool allocate(struct thud_free_vibration *f, const struct thud_model *m)
{
    size_t n = (size_t)m->nmodes, floors = (size_t)m->ndof,
           rows = (n + THUD_FREE_VIBRATION_BATCH - 1) / THUD_FREE_VIBRATION_BATCH * THUD_FREE_VIBRATION_BATCH,
           many = rows * THUD_FREE_VIBRATION_ENDS, high = floors * THUD_FREE_VIBRATION_ENDS;
    double **by_mode[32], **by_end[] = {&f->q, &f->qd, &f->spring, &f->bound[0], &f->bound[1], &f->bound[2]};
    double **single[] = {&f->gap, &f->energy, &f->ground, &f->after, &f->lower, &f->upper};
    size_t count = 0, ends = sizeof by_end / sizeof *by_end, singles = sizeof single / sizeof *single;
    for (int i = 0; i < 4; i++) {
        by_mode[count++] = &f->e[i];
        by_mode[count++] = &f->p[i];
        by_mode[count++] = &f->work[i];
    }
    for (int i = 0; i < 7; i++)
        by_mode[count++] = &f->viscous[i];
    double **rest[] = {&f->now, &f->now_rate, &f->speed};
    for (size_t i = 0; i < sizeof rest / sizeof *rest; i++)
        by_mode[count++] = rest[i];
    size_t total = count * rows + ends * many + THUD_FLOOR_QUANTITIES * high + singles * THUD_FREE_VIBRATION_ENDS +
                   THUD_FLOOR_QUANTITIES * (size_t)m->nstructures + 2 * THUD_FLOOR_QUANTITIES * floors * n +
                   (size_t)m->ncontacts;
    double *next = f->block = calloc(total, sizeof *next);
    if (!next)
        return false;
    for (size_t i = 0; i < count; i++, next += rows)
        *by_mode[i] = next;
    for (size_t i = 0; i < ends; i++, next += many)
        *by_end[i] = next;
    for (int x = 0; x < THUD_FLOOR_QUANTITIES; x++, next += high)
        f->value[x] = next;
    for (size_t i = 0; i < singles; i++, next += THUD_FREE_VIBRATION_ENDS)
        *single[i] = next;
    f->margin = next;
    f->kept = f->margin + THUD_FLOOR_QUANTITIES * m->nstructures;
    f->limit = f->kept + 2 * THUD_FLOOR_QUANTITIES * floors * n;
    f->deferred = calloc(THUD_FLOOR_QUANTITIES * floors, sizeof *f->deferred);
    f->looked = calloc(2 * (size_t)m->nstructures + (size_t)m->ncontacts + 1, sizeof *f->looked);
    f->bounded = f->looked + m->nstructures;
    f->near = f->bounded + m->nstructures;
    return f->deferred != NULL && f->looked != NULL;
}

/* Rates of the four unit motions at one quadrature point enter the integrals of their products. */
static void add_point(struct thud_free_vibration *f, const struct thud_model *m, double weight, double s,
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

enum { POINTS = THUD_QUADRATURE_POINTS };

/* Moves unit motion u over one piece; its rates at the quadrature points into rate (POINTS x n). */
static void move_unit(struct thud_run *run, const struct thud_free_vibration *f, int u, int piece, double *q,
                      double *qd, double *rate)
{
    struct thud_segment *seg = &run->seg;
    double s0 = (double)piece / f->pieces, ds = 1.0 / f->pieces;
    thud_segment_begin(&run->state, seg, run->state.grid_dt_s * ds);
    seg->a0 = u == UNIT_A0 ? 1 - s0 : u == UNIT_A1 ? s0 : 0;
    seg->a1 = u == UNIT_A0 ? -ds : u == UNIT_A1 ? ds : 0;
    thud_taylor_given(run->state.model, seg, q, qd);
    for (int i = 0; i < POINTS; i++)
        thud_segment_state(seg, f->n, thud_quadrature_node[i], f->now, rate + i * f->n);
    thud_segment_state(seg, f->n, 1, q, qd);
}

/* Marches the four unit motions through one interval in pieces short enough for the series. */
static enum thud_status unit_motions(struct thud_run *run, struct thud_free_vibration *f, struct thud_error *err)
{
    size_t n = (size_t)run->state.model->nmodes, size = (2 + POINTS) * n;
    double *state = calloc(UNITS * size + 1, sizeof *state), *q[UNITS], *qd[UNITS], *rate[UNITS];
    if (!state)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    for (size_t u = 0; u < UNITS; u++) {
        q[u] = state + u * size;
        qd[u] = q[u] + n;
    }
    for (size_t j = 0; j < n; j++)
        q[UNIT_Q][j] = qd[UNIT_QD][j] = 1;
    f->pieces = 1 + (int)(run->state.fastest_radps * run->state.grid_dt_s / 1.8);
    for (int piece = 0; piece < f->pieces; piece++) {
        for (int u = 0; u < UNITS; u++)
            move_unit(run, f, u, piece, q[u], qd[u], qd[u] + n);
        for (int i = 0; i < POINTS; i++) {
            for (int u = 0; u < UNITS; u++)
                rate[u] = qd[u] + n + (size_t)i * n;
            double ds = 1.0 / f->pieces, s = (piece + thud_quadrature_node[i]) * ds;
            add_point(f, run->state.model, thud_quadrature_weight[i] * ds * run->state.grid_dt_s, s, rate);
        }
    }
    for (int u = 0; u < UNITS; u++) {
        memcpy(u < 2 ? f->e[u] : f->p[u - 2], q[u], n * sizeof(double));
        memcpy(u < 2 ? f->e[u + 2] : f->p[u], qd[u], n * sizeof(double));
    }
    free(state);
    return THUD_OK;
}

enum thud_status thud_free_vibration_create(struct thud_run *run, struct thud_error *err)
{
    run->free_vibration = NULL;
    if (run->state.model->couples || run->state.model->nmodes == 0)
        return THUD_OK;
    struct thud_free_vibration *f = calloc(1, sizeof *f);
    if (!f || !allocate(f, run->state.model)) {
        thud_free_vibration_free(f);
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    f->n = run->state.model->nmodes;
    f->size = THUD_FREE_VIBRATION_BLOCK;
    enum thud_status status = unit_motions(run, f, err);
    if (status != THUD_OK) {
        thud_free_vibration_free(f);
        return status;
    }
    run->free_vibration = f;
    return THUD_OK;
}

void thud_free_vibration_free(struct thud_free_vibration *flight)
{
    if (!flight)
        return;
    free(flight->deferred);
    free(flight->looked);
    free(flight->block);
    free(flight);
}
