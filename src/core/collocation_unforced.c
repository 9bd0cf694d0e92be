/* How contacts would move through a step if no contact force acted. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/collocation_private.h"
#include "core/tolerance.h"

void thud_collocation_begin(struct thud_run *run, struct thud_segment *seg, double h)
{
    thud_segment_begin(run, seg, h);
    double least = fmin(1e-15, fmax(THUD_TOL_SERIES, 1e-9 * run->options.tolerance));
    seg->terms = thud_segment_terms(run->fastest_radps * h, least);
}

/* The table of a step size, where modes are uncoupled. */
static bool fill_table(const struct thud_run *run, struct thud_collocation *x, int level, double h)
{
    const struct thud_model *m = run->model;
    size_t n = (size_t)x->nmodes;
    double *table = thud_collocation_allocate(n * THUD_UNITS * 2 * THUD_PLACES, sizeof *table),
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
            double *d = table + (j * THUD_UNITS + (size_t)u) * 2 * THUD_PLACES, *v = d + THUD_PLACES;
            thud_places_read(&x->nodes, seg->q + j, m->nmodes, seg->terms, d);
            thud_places_slope(&x->nodes, seg->q + j, m->nmodes, seg->terms, h, v);
        }
    }
    free(start);
    return true;
}

/* Every mode's way to the points and its rates there. */
static void move_modes(const struct thud_run *run, struct thud_collocation *x, int level, double h)
{
    double a0, a1;
    thud_run_ground(run, run->grid, &a0, &a1);
    double slope = (a1 - a0) / run->grid_dt_s;
    double part[THUD_UNITS] = {[THUD_UNIT_A0] = a0 + slope * run->offset_s, [THUD_UNIT_A1] = slope * h};
    for (int j = 0; j < x->nmodes; j++) {
        const double *unit = x->unforced[level] + j * THUD_UNITS * 2 * THUD_PLACES;
        struct thud_lanes d = {0}, v = {0};
        part[THUD_UNIT_Q] = run->q[j];
        part[THUD_UNIT_QD] = run->qd[j];
        for (int u = 0; u < THUD_UNITS; u++, unit += 2 * THUD_PLACES) {
            thud_lanes_add(&d, part[u], unit);
            thud_lanes_add(&v, part[u], unit + THUD_PLACES);
        }
        thud_lanes_put(&d, x->moved + j * 2 * THUD_PLACES);
        thud_lanes_put(&v, x->moved + (j * 2 + 1) * THUD_PLACES);
    }
}

/* Adds the modes of one side of contact c. */
static void add_side(const struct thud_run *run, const struct thud_collocation *x, int c, int dof, struct thud_lanes *d,
                     struct thud_lanes *v)
{
    const struct thud_model *m = run->model;
    if (dof < 0)
        return;
    const struct thud_model_structure *s = &m->structure[m->dof_structure[dof]];
    for (int j = s->first_mode; j < s->first_mode + s->modes; j++) {
        const double *from = x->moved + j * 2 * THUD_PLACES;
        double g = m->g[c * m->nmodes + j];
        thud_lanes_add(d, g, from);
        thud_lanes_add(v, g, from + THUD_PLACES);
    }
}

static void by_table(struct thud_run *run, struct thud_collocation *x, int level, double h)
{
    move_modes(run, x, level, h);
    for (int a = 0; a < x->nactive; a++) {
        int c = x->active[a];
        const struct thud_model_contact *p = &run->model->contact[c];
        double now = run->contact[c].zeros.indentation > 0 ? 0 : thud_contact_indentation(run, c);
        struct thud_lanes d = {0}, v = {0};
        add_side(run, x, c, p->left_dof, &d, &v);
        add_side(run, x, c, p->right_dof, &d, &v);
        thud_lanes_add(&d, now, x->nodes.power[0]);
        thud_lanes_put(&d, x->d0 + a * THUD_PLACES);
        thud_lanes_put(&v, x->v0 + a * THUD_PLACES);
    }
}

static void by_series(struct thud_run *run, struct thud_collocation *x, double h)
{
    double p[THUD_SEGMENT_TERMS];
    thud_collocation_begin(run, &x->seg, h);
    thud_taylor_given(run->model, &x->seg, run->q, run->qd);
    for (int a = 0; a < x->nactive; a++) {
        int c = x->active[a];
        thud_segment_indentation(run, &x->seg, c, p);
        if (run->contact[c].zeros.indentation > 0)
            p[0] = 0;
        thud_places_read(&x->nodes, p, 1, x->seg.terms, x->d0 + a * THUD_PLACES);
        thud_places_slope(&x->nodes, p, 1, x->seg.terms, h, x->v0 + a * THUD_PLACES);
    }
}

bool thud_collocation_unforced(struct thud_run *run, struct thud_collocation *x, int level, double h)
{
    if (run->model->couples) {
        by_series(run, x, h);
        return true;
    }
    if (!x->unforced[level] && !fill_table(run, x, level, h))
        return false;
    by_table(run, x, level, h);
    return true;
}
