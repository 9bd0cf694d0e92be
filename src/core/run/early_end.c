/* The rest of a run without contact, left out where it can be foretold. After the last contact the motion differs from
 * the baseline's by a free vibration, which decays in every mode alone:
 *     |difference of q_j|(t) <= sqrt(x^2 + ((x' + zeta omega x)/omega_d)^2)        x: the difference now
 * So from some block on no gap closes and no peak is passed, by the largest values of the baseline in all that follows,
 * kept block by block (thud_early_end_close), plus the modes' amplitudes. Then the state at the end is the baseline's plus
 * the difference in closed form (thud_early_end_jump). Not for coupled damping, free bodies and storeys that yield. */
#include "core/run/early_end.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "base/grow.h"
#include "base/largest.h"
#include "core/model/element.h"
#include "core/motion/free_vibration.h"

enum { STRIDE = THUD_FREE_VIBRATION_BLOCK, ENDS = THUD_FREE_VIBRATION_ENDS };

struct thud_early_end {
    int n, floors, nc, row; /* modes, floors, contacts, doubles of one block: 2 n + 4 floors + nc */
    double *block; /* (count x row): q, q' at its start; bounds of its floors' values; largest relative displacements */
    long count;
    double *end;         /* (2 n) q, q' at the end of the last block */
    bool closed, failed; /* blocks are STRIDE intervals each, but for the last */
    long end_grid;
};

struct thud_early_end *thud_early_end_create(const struct thud_model *model)
{
    if (model->traits & (THUD_SLIPS | THUD_UNKEPT))
        return NULL;
    struct thud_early_end *h, to = {.n = model->nmodes, .floors = model->ndof, .nc = model->ncontacts};
    if (THUD_LAY(NULL, THUD_PIECE(h, 1), THUD_PIECE(to.end, 2 * to.n)) != THUD_OK)
        return NULL;
    to.row = 2 * to.n + THUD_FLOOR_QUANTITIES * to.floors + to.nc;
    to.failed = model->couples; /* a mode's difference does not decay alone */
    for (int j = 0; j < to.n; j++)
        to.failed = to.failed || !(model->omega[j] > 0); /* a free body's difference does not decay */
    *h = to;
    return h;
}

void thud_early_end_free(struct thud_early_end *early_end)
{
    if (!early_end)
        return;
    free(early_end->block);
    free(early_end);
}

/* Room for one more block; NULL: there is no memory. */
static double *new_block(struct thud_early_end *h)
{
    double *larger = thud_grow(h->block, (size_t)h->count, (size_t)h->row * sizeof *larger);
    if (!larger)
        return NULL;
    h->block = larger;
    return h->block + h->count++ * h->row;
}

/* Keeps the block just advanced and what its values cannot pass. A failed allocation ends the keeping. */
static enum thud_status block(void *own, const struct thud_state *state, struct thud_free_vibration *f, int intervals,
                              struct thud_error *err)
{
    struct thud_early_end *h = own;
    const struct thud_model *m = state->model;
    (void)err;
    h->failed = h->failed || state->grid != h->count * STRIDE;
    double *row = h->failed ? NULL : new_block(h);
    if (!row) {
        h->failed = true;
        return THUD_OK;
    }
    thud_free_vibration_end(f, 0, row, row + h->n);
    thud_free_vibration_end(f, intervals, h->end, h->end + h->n);
    double *value = row + 2 * h->n, *relative = value + THUD_FLOOR_QUANTITIES * h->floors;
    for (int x = 0; x < THUD_FLOOR_QUANTITIES; x++)
        for (int s = 0; s < m->nstructures; s++)
            thud_free_vibration_values(f, m, s, x);
    for (int x = 0; x < THUD_FLOOR_QUANTITIES; x++)
        for (int i = 0; i < h->floors; i++)
            value[x * h->floors + i] = thud_largest_size(f->value[x] + i * ENDS, intervals + 1) +
                                       thud_free_vibration_margin(f, m, m->dof_structure[i], x);
    for (int c = 0; c < h->nc; c++) {
        double margin, most = thud_free_vibration_gap(f, m, c, intervals + 1, &margin);
        relative[c] = most + margin;
    }
    h->end_grid = state->grid + intervals;
    return THUD_OK;
}

const struct thud_observer thud_observe_early_end = {.block = block};

/* From each block on: the largest of it and all that follow. */
void thud_early_end_close(struct thud_early_end *h)
{
    for (long b = h->count - 2; b >= 0; b--) {
        double *block = h->block + b * h->row + 2 * h->n, *next = block + h->row;
        for (int i = 0; i < THUD_FLOOR_QUANTITIES * h->floors + h->nc; i++)
            block[i] = fmax(block[i], next[i]);
    }
    h->closed = !h->failed && h->count > 0;
}

/* Largest |x| that a mode's free vibration from (q, q') comes to: its envelope at the start. */
static double amplitude(const struct thud_model *m, int j, double q, double qd)
{
    double damped = m->omega[j] * sqrt(1 - m->zeta[j] * m->zeta[j]);
    double v = (qd + m->zeta[j] * m->omega[j] * q) / damped;
    return sqrt(q * q + v * v);
}

/* Whether no contact closes in the rest, `relative` being the largest relative displacements to come in the baseline. */
static bool stays_apart(const struct thud_state *state, const double *relative, const double *amplitudes)
{
    const struct thud_model *m = state->model;
    for (int c = 0; c < m->ncontacts; c++) {
        const double *g = m->jacobian + c * m->nmodes;
        double add = 0;
        if (m->contact[c].law->flags & THUD_LAW_NO_FORCE)
            continue;
        for (int j = 0; j < m->nmodes; j++)
            add += fabs(g[j]) * amplitudes[j];
        if (relative[c] + add >= thud_state_clearance(state, c))
            return false;
    }
    return true;
}

bool thud_early_end_holds(const struct thud_early_end *h, const struct thud_state *state, double *amplitudes,
                          struct thud_rest *rest)
{
    long grid = state->grid, b = grid / STRIDE;
    if (!h->closed || state->offset_s != 0 || grid % STRIDE != 0 || b >= h->count || grid >= h->end_grid)
        return false;
    for (int c = 0; c < state->model->ncontacts; c++)
        if (state->contact[c].mode != THUD_OPEN)
            return false;
    const double *start = h->block + b * h->row, *later = start + 2 * h->n;
    for (int j = 0; j < h->n; j++)
        amplitudes[j] = amplitude(state->model, j, state->q[j] - start[j], state->qd[j] - start[h->n + j]);
    *rest = (struct thud_rest){state->model, later, amplitudes};
    return stays_apart(state, later + THUD_FLOOR_QUANTITIES * h->floors, amplitudes);
}

/* Free vibration of the difference, added to the motion without contact. */
long thud_early_end_jump(const struct thud_early_end *h, struct thud_state *state)
{
    const struct thud_model *m = state->model;
    assert(h->closed && state->offset_s == 0 && state->grid % STRIDE == 0 && state->grid < h->end_grid);
    const double *start = h->block + state->grid / STRIDE * h->row;
    long intervals = h->end_grid - state->grid;
    double time = (double)intervals * state->grid_dt_s;
    for (int j = 0; j < h->n; j++) {
        double dq = state->q[j] - start[j], dv = state->qd[j] - start[h->n + j];
        double zw = m->zeta[j] * m->omega[j], w = m->omega[j] * sqrt(1 - m->zeta[j] * m->zeta[j]);
        double fade = exp(-zw * time), c = cos(w * time), s = sin(w * time);
        state->q[j] = h->end[j] + fade * (dq * c + (dv + zw * dq) / w * s);
        state->qd[j] = h->end[h->n + j] + fade * (dv * c - (zw * dv + m->spring[j] * dq) / w * s);
    }
    state->grid = h->end_grid;
    return intervals;
}
