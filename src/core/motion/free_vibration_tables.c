/* The tables of one interval of the ground motion: the recurrence of every mode, and the energies of an interval as
 * quadratic forms. Both are what coupled_motion makes of one mode alone, by the ground's two values. */
#include "core/motion/free_vibration_parts.h"

#include <string.h>

/* Of the elastic compliance of a row over that while it yields. */
static const double least_left = 1e-6;

/* Of mode j; the forms are upper parts (4 x 4) by q, q', a0 and a1. */
static void read_mode(struct thud_free_vibration_tables *to, const struct thud_coupled_motion *c, int j)
{
    static const int own[THUD_FREE_VIBRATION_PRODUCTS] = {0, 1, 5, 2, 3, 6, 7}, ground[] = {10, 11, 15};
    const double *q = c->step, *qd = q + 2, *start = qd + 2, *change = start + 2;
    for (int i = 0; i < 2; i++) {
        to->e[2 * i][j] = q[i];
        to->e[2 * i + 1][j] = qd[i];
        to->p[2 * i][j] = start[i] - change[i];
        to->p[2 * i + 1][j] = change[i];
        to->work[i][j] = c->input[4 * i + 2];
        to->work[2 + i][j] = c->input[4 * i + 3];
    }
    if (q[0] ==
        0) /* a motion that dies out in one interval: 0 is of modes that damping couples, which have no tables */
        to->e[0][j] = 1e-300;
    for (int i = 0; i < THUD_FREE_VIBRATION_PRODUCTS; i++)
        to->viscous[i][j] = c->loss[own[i]];
    for (int i = 0; i < 3; i++) {
        to->ground[0][i] += c->loss[ground[i]];
        to->ground[1][i] += c->input[ground[i]];
    }
}

/* Whether blocks are made while storey k yields: an isolator, under a building whose damping couples its modes, whose
 * force no sum over modes needs; and the building still swings about a place, as its stiffness
 * Omega^2 + kappa g g^T stays positive definite. */
static bool slides(const struct thud_model *m, int k)
{
    const struct thud_model_storey *storey = &m->storey[k];
    const struct thud_model_structure *p = &m->structure[storey->structure];
    const double *g = m->jacobian + (m->ncontacts + k) * m->nmodes;
    double left = 1;
    for (int j = p->first_mode; j < p->first_mode + p->modes; j++)
        left -= (1 - storey->hardening) * storey->stiffness_npm * g[j] * g[j] / m->spring[j];
    return p->damping && storey->link < 0 && storey->floor == 0 && m->ncolumns == 0 && left > least_left;
}

enum thud_status thud_free_vibration_make_tables(const struct thud_state *state, struct thud_free_vibration *f,
                                                 struct thud_error *err)
{
    const struct thud_model *m = state->model;
    enum thud_status status = THUD_OK;
    for (int s = 0; s < m->nsystems && status == THUD_OK; s++) {
        const struct thud_model_structure *p = &m->structure[m->system[s]];
        struct thud_coupled_motion alone;
        struct thud_blocks memory = {NULL};
        if (p->damping)
            status = thud_coupled_motion_init(&f->coupled[s], state, s, -1, -1, state->memory, err);
        for (int j = p->first_mode; !p->damping && j < p->first_mode + p->modes && status == THUD_OK; j++) {
            status = thud_coupled_motion_init(&alone, state, s, j, -1, &memory, err);
            if (status == THUD_OK)
                read_mode(&f->tables, &alone, j);
            thud_blocks_free(&memory);
        }
    }
    for (int k = 0; k < m->nstoreys && status == THUD_OK; k++)
        if (slides(m, k))
            status = thud_coupled_motion_init(&f->coupled[m->nsystems + k], state,
                                              m->structure[m->storey[k].structure].system, -1, k, state->memory, err);
    return status;
}

static bool same(const double *a, const double *b, int n)
{
    return memcmp(a, b, (size_t)n * sizeof *a) == 0;
}

bool thud_free_vibration_copy_tables(struct thud_free_vibration *f, const struct thud_free_vibration *like)
{
    const struct thud_model *m = f->model, *l = like->model;
    if (m->couples || l->couples || like->n != f->n || like->dt_s != f->dt_s || !same(l->omega, m->omega, f->n) ||
        !same(l->zeta, m->zeta, f->n) || !same(l->gamma, m->gamma, f->n))
        return false;
    const double *end = f->tables.viscous[THUD_FREE_VIBRATION_PRODUCTS - 1] + f->n;
    memcpy(f->tables.e[0], like->tables.e[0], (size_t)(end - f->tables.e[0]) * sizeof *end);
    memcpy(f->tables.ground, like->tables.ground, sizeof f->tables.ground);
    return true;
}
