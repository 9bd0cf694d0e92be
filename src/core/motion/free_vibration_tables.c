/* The tables of one interval of the ground motion: the recurrence of every mode, and the energies of an interval as
 * quadratic forms, both from the four unit motions by power series and quadrature.
 *
 * The motion of a mode in an interval is linear in its state and the ground's two values: with the unit motions w_u(t),
 *
 *     q'(t) = q w_Q + q' w_QD + a0 w_A0 + a1 w_A1
 *
 * so that its end gives the recurrence, and the integrals over the interval of
 *
 *     loss in damping   2 zeta omega q'^2           work of the ground   -gamma a_g q',  a_g = a0 (1 - s) + a1 s
 *
 * are quadratic forms whose coefficients are integrals of products of two w_u, made once by Gauss's rule (exact for the
 * series' polynomials to rounding). */
#include "core/motion/free_vibration_parts.h"

#include <stdlib.h>
#include <string.h>

#include "core/numerics/quadrature.h"

enum { POINTS = THUD_QUADRATURE_POINTS };

/* Unit motions over one interval: initial q, initial q', ground acceleration falling from 1 to 0, and rising from 0
 * to 1. */
enum { UNIT_Q, UNIT_QD, UNIT_A0, UNIT_A1, UNITS };

/* Rates of the four unit motions at one quadrature point enter the integrals of their products; of a structure whose
 * modes are not coupled. */
static void add_point(struct thud_free_vibration *f, const struct thud_model *m, const struct thud_model_structure *p,
                      double weight, double s, double *const rate[UNITS])
{
    double a[2] = {1 - s, s};
    for (int j = p->first_mode; j < p->first_mode + p->modes; j++) {
        double w[UNITS], loss = 2 * m->zeta[j] * m->omega[j] * weight, drive = -m->gamma[j] * weight;
        for (int u = 0; u < UNITS; u++)
            w[u] = rate[u][j];
        f->tables.viscous[0][j] += loss * w[0] * w[0];
        f->tables.viscous[1][j] += loss * 2 * w[0] * w[1];
        f->tables.viscous[2][j] += loss * w[1] * w[1];
        f->tables.viscous[3][j] += loss * 2 * w[0] * w[2];
        f->tables.viscous[4][j] += loss * 2 * w[0] * w[3];
        f->tables.viscous[5][j] += loss * 2 * w[1] * w[2];
        f->tables.viscous[6][j] += loss * 2 * w[1] * w[3];
        f->tables.viscous_ground[0] += loss * w[2] * w[2];
        f->tables.viscous_ground[1] += loss * 2 * w[2] * w[3];
        f->tables.viscous_ground[2] += loss * w[3] * w[3];
        f->tables.work[0][j] += drive * a[0] * w[0];
        f->tables.work[1][j] += drive * a[0] * w[1];
        f->tables.work[2][j] += drive * a[1] * w[0];
        f->tables.work[3][j] += drive * a[1] * w[1];
        f->tables.work_ground[0] += drive * a[0] * w[2];
        f->tables.work_ground[1] += drive * (a[0] * w[3] + a[1] * w[2]);
        f->tables.work_ground[2] += drive * a[1] * w[3];
    }
}

/* Moves unit motion u over one piece; its rates at the quadrature points into rate (POINTS x n). */
static void move_unit(const struct thud_state *state, struct thud_free_vibration *f, int u, int piece, double *q,
                      double *qd, double *rate)
{
    struct thud_segment *seg = &f->series.seg;
    double s0 = (double)piece / f->pieces, ds = 1.0 / f->pieces;
    thud_segment_begin(state, seg, f->dt_s * ds, thud_segment_all_terms(state, f->dt_s * ds));
    seg->a0 = u == UNIT_A0 ? 1 - s0 : u == UNIT_A1 ? s0 : 0;
    seg->a1 = u == UNIT_A0 ? -ds : u == UNIT_A1 ? ds : 0;
    thud_taylor_given(state->model, seg, q, qd);
    for (int i = 0; i < POINTS; i++)
        thud_segment_state(seg, f->n, thud_quadrature_node[i], f->series.now, rate + i * f->n);
    thud_segment_state(seg, f->n, 1, q, qd);
}

/* Advances the four unit motions through one interval in pieces short enough for the series. */
enum thud_status thud_free_vibration_make_tables(const struct thud_state *state, struct thud_free_vibration *f,
                                                 struct thud_error *err)
{
    const struct thud_model *m = state->model;
    size_t n = (size_t)m->nmodes, size = (2 + POINTS) * n;
    double *block = calloc(UNITS * size + 1, sizeof *block), *q[UNITS], *qd[UNITS], *rate[UNITS];
    if (!block)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    for (size_t u = 0; u < UNITS; u++) {
        q[u] = block + u * size;
        qd[u] = q[u] + n;
    }
    for (size_t j = 0; j < n; j++)
        q[UNIT_Q][j] = qd[UNIT_QD][j] = 1;
    for (int piece = 0; piece < f->pieces; piece++) {
        for (int u = 0; u < UNITS; u++)
            move_unit(state, f, u, piece, q[u], qd[u], qd[u] + n);
        for (int i = 0; i < POINTS; i++) {
            for (int u = 0; u < UNITS; u++)
                rate[u] = qd[u] + n + (size_t)i * n;
            double ds = 1.0 / f->pieces, s = (piece + thud_quadrature_node[i]) * ds;
            for (int k = 0; k < m->nsystems; k++)
                if (!m->structure[m->system[k]].damping)
                    add_point(f, m, &m->structure[m->system[k]], thud_quadrature_weight[i] * ds * f->dt_s, s, rate);
        }
    }
    for (int u = 0; u < UNITS; u++) {
        memcpy(u < 2 ? f->tables.e[u] : f->tables.p[u - 2], q[u], n * sizeof(double));
        memcpy(u < 2 ? f->tables.e[u + 2] : f->tables.p[u], qd[u], n * sizeof(double));
    }
    free(block);
    return THUD_OK;
}

static bool same(const double *a, const double *b, int n)
{
    return memcmp(a, b, (size_t)n * sizeof *a) == 0;
}

/* Whether the tables of `like` are those of f, to the last bit: no modes are coupled, and no contact is closed, whose
 * rate would give the series more terms. */
bool thud_free_vibration_has_tables(const struct thud_free_vibration *like, const struct thud_free_vibration *f,
                                    const struct thud_state *state)
{
    const struct thud_model *m = f->model, *l = like->model;
    return !m->couples && !l->couples && state->nactive == 0 && like->n == f->n && like->dt_s == f->dt_s &&
           like->pieces == f->pieces && l->nstructures == m->nstructures && same(l->omega, m->omega, f->n) &&
           same(l->zeta, m->zeta, f->n) && same(l->gamma, m->gamma, f->n);
}

void thud_free_vibration_copy_tables(struct thud_free_vibration *f, const struct thud_free_vibration *like)
{
    const size_t bytes = (size_t)f->n * sizeof(double);
    for (int i = 0; i < 4; i++) {
        memcpy(f->tables.e[i], like->tables.e[i], bytes);
        memcpy(f->tables.p[i], like->tables.p[i], bytes);
        memcpy(f->tables.work[i], like->tables.work[i], bytes);
    }
    for (int i = 0; i < THUD_FREE_VIBRATION_PRODUCTS; i++)
        memcpy(f->tables.viscous[i], like->tables.viscous[i], bytes);
    memcpy(f->tables.viscous_ground, like->tables.viscous_ground, sizeof f->tables.viscous_ground);
    memcpy(f->tables.work_ground, like->tables.work_ground, sizeof f->tables.work_ground);
}
