/* How contacts would move through a step if no contact force acted. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/collocation_private.h"
#include "core/tolerance.h"

void thud_collocation_begin(const struct thud_state *state, struct thud_segment *seg, double h)
{
    thud_segment_begin(state, seg, h);
    double least = fmin(1e-15, fmax(THUD_TOL_SERIES, 1e-9 * state->tolerance));
    seg->terms = thud_segment_terms(state->fastest_radps * h, least);
}

/* The table of a step size, where modes are uncoupled. */
static bool fill_table(const struct thud_state *state, struct thud_collocation *x, int level, double h)
{
    const struct thud_model *m = state->model;
    size_t n = (size_t)x->nmodes;
    double *table = thud_collocation_allocate(n * THUD_UNITS * 2 * THUD_BATCH, sizeof *table),
           *start = thud_collocation_allocate(2 * n, sizeof *start);
    x->unforced[level] = table;
    if (!table || !start) {
        free(start);
        return false;
    }
    struct thud_segment *seg = &x->seg;
    seg->terms = THUD_SEGMENT_TERMS;
    seg->h_s = h;
    memset(seg->force, 0, THUD_SEGMENT_TERMS * (size_t)x->nc * sizeof *seg->force);
    for (int u = 0; u < THUD_UNITS; u++) {
        for (size_t j = 0; j < n; j++) {
            start[j] = u == THUD_UNIT_Q;
            start[n + j] = u == THUD_UNIT_QD;
        }
        seg->a0 = u == THUD_UNIT_A0;
        seg->a1 = u == THUD_UNIT_A1;
        thud_taylor_given(m, seg, start, start + n);
        memset(seg->q, 0, n * sizeof *seg->q); /* how far it moves */
        for (size_t j = 0; j < n; j++) {
            double *d = table + (j * THUD_UNITS + (size_t)u) * 2 * THUD_BATCH, *v = d + THUD_BATCH;
            thud_nodes_values(&x->nodes, seg->q + j, m->nmodes, seg->terms, d);
            thud_nodes_rates(&x->nodes, seg->q + j, m->nmodes, seg->terms, h, v);
        }
    }
    free(start);
    return true;
}

/* Every mode's way to the points and its rates there. */
static void move_modes(const struct thud_state *state, struct thud_collocation *x, int level, double h)
{
    double a0, a1;
    thud_state_ground(state, state->grid, &a0, &a1);
    double slope = (a1 - a0) / state->grid_dt_s;
    double part[THUD_UNITS] = {[THUD_UNIT_A0] = a0 + slope * state->offset_s, [THUD_UNIT_A1] = slope * h};
    for (int j = 0; j < x->nmodes; j++) {
        const double *unit = x->unforced[level] + j * THUD_UNITS * 2 * THUD_BATCH;
        struct thud_batch d = {0}, v = {0};
        part[THUD_UNIT_Q] = state->q[j];
        part[THUD_UNIT_QD] = state->qd[j];
        for (int u = 0; u < THUD_UNITS; u++, unit += 2 * THUD_BATCH) {
            thud_batch_add(&d, part[u], unit);
            thud_batch_add(&v, part[u], unit + THUD_BATCH);
        }
        thud_batch_put(&d, x->moved + j * 2 * THUD_BATCH);
        thud_batch_put(&v, x->moved + (j * 2 + 1) * THUD_BATCH);
    }
}

/* Adds the modes of one side of contact c. */
static void add_side(const struct thud_state *state, const struct thud_collocation *x, int c, int dof,
                     struct thud_batch *d, struct thud_batch *v)
{
    const struct thud_model *m = state->model;
    if (dof < 0)
        return;
    const struct thud_model_structure *s = &m->structure[m->dof_structure[dof]];
    for (int j = s->first_mode; j < s->first_mode + s->modes; j++) {
        const double *from = x->moved + j * 2 * THUD_BATCH;
        double g = m->jacobian[c * m->nmodes + j];
        thud_batch_add(d, g, from);
        thud_batch_add(v, g, from + THUD_BATCH);
    }
}

static void by_table(const struct thud_state *state, struct thud_collocation *x, int level, double h)
{
    move_modes(state, x, level, h);
    for (int a = 0; a < x->nactive; a++) {
        int c = x->active[a];
        const struct thud_model_contact *p = &state->model->contact[c];
        double now = state->contact[c].suppressed.indentation > 0 ? 0 : thud_contact_indentation(state, c);
        struct thud_batch d = {0}, v = {0};
        add_side(state, x, c, p->left_dof, &d, &v);
        add_side(state, x, c, p->right_dof, &d, &v);
        thud_batch_add(&d, now, x->nodes.power[0]);
        thud_batch_put(&d, x->d0 + a * THUD_BATCH);
        thud_batch_put(&v, x->v0 + a * THUD_BATCH);
    }
}

static void by_series(const struct thud_state *state, struct thud_collocation *x, double h)
{
    double p[THUD_SEGMENT_TERMS];
    thud_collocation_begin(state, &x->seg, h);
    thud_taylor_given(state->model, &x->seg, state->q, state->qd);
    for (int a = 0; a < x->nactive; a++) {
        int c = x->active[a];
        thud_segment_indentation(state, &x->seg, c, p);
        if (state->contact[c].suppressed.indentation > 0)
            p[0] = 0;
        thud_nodes_values(&x->nodes, p, 1, x->seg.terms, x->d0 + a * THUD_BATCH);
        thud_nodes_rates(&x->nodes, p, 1, x->seg.terms, h, x->v0 + a * THUD_BATCH);
    }
}

bool thud_collocation_unforced(const struct thud_state *state, struct thud_collocation *x, int level, double h)
{
    if (state->model->couples) {
        by_series(state, x, h);
        return true;
    }
    if (!x->unforced[level] && !fill_table(state, x, level, h))
        return false;
    by_table(state, x, level, h);
    return true;
}
