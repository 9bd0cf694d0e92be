/* How contacts answer to each other's forces at the points of a step. */
#include <stdlib.h>

#include "core/collocation_private.h"

void *thud_collocation_allocate(size_t count, size_t size)
{
    return calloc(count ? count : 1, size);
}

/* Motion of every mode at the points under unit loads s^power. */
static bool fill_modal(const struct thud_state *state, struct thud_collocation *x, int level, double h)
{
    size_t n = (size_t)x->nmodes;
    double *table = thud_collocation_allocate((size_t)x->loads * THUD_POINTS * n * 2 * THUD_BATCH, sizeof *table),
           *ones = thud_collocation_allocate(n, sizeof *ones);
    x->modal[level] = table;
    if (!table || !ones) {
        free(ones);
        return false;
    }
    for (size_t j = 0; j < n; j++)
        ones[j] = 1;
    struct thud_segment *seg = &x->seg;
    seg->terms = THUD_SEGMENT_TERMS;
    seg->h_s = h;
    seg->a0 = seg->a1 = 0;
    seg->loaded = 0;
    for (int load = 0; load < x->loads; load++)
        for (int power = 0; power < THUD_POINTS; power++) {
            thud_taylor_load(state->model, seg,
                             !state->model->couples ? ones : state->model->jacobian + (size_t)load * n, power);
            for (int j = 0; j < x->nmodes; j++, table += 2 * THUD_BATCH) {
                thud_nodes_values(&x->nodes, seg->q + j, x->nmodes, seg->terms, table);
                thud_nodes_rates(&x->nodes, seg->q + j, x->nmodes, seg->terms, h, table + THUD_BATCH);
            }
        }
    free(ones);
    return true;
}

/* Response of contact a to forces of contact b. A force pushes the two apart: indentation falls. */
static bool fill_pair(const struct thud_state *state, struct thud_collocation *x, int level, double h, int a, int b)
{
    size_t n = (size_t)x->nmodes;
    if (!x->modal[level] && !fill_modal(state, x, level, h))
        return false;
    struct thud_response *r = &x->pair[level][a * x->nc + b];
    double *block = thud_collocation_allocate(2 * THUD_BLOCK, sizeof *block);
    if (!block)
        return false;
    r->indentation = block;
    r->rate = block + THUD_BLOCK;
    const bool couples = state->model->couples;
    const double *ga = state->model->jacobian + (size_t)a * n, *gb = state->model->jacobian + (size_t)b * n;
    const double *table = x->modal[level] + (couples ? (size_t)b * THUD_POINTS * n * 2 * THUD_BATCH : 0);
    for (int power = 0; power < THUD_POINTS; power++) {
        struct thud_batch d = {0}, v = {0};
        double moved[2 * THUD_BATCH];
        for (size_t j = 0; j < n; j++, table += 2 * THUD_BATCH) {
            double w = couples ? -ga[j] : -ga[j] * gb[j];
            thud_batch_add(&d, w, table);
            thud_batch_add(&v, w, table + THUD_BATCH);
        }
        thud_batch_put(&d, moved);
        thud_batch_put(&v, moved + THUD_BATCH);
        for (int k = 0; k < THUD_POINTS; k++)
            for (int i = 0; i < THUD_POINTS; i++) {
                r->indentation[k * THUD_BATCH + i] += moved[i] * x->lagrange[power * THUD_POINTS + k];
                r->rate[k * THUD_BATCH + i] += moved[THUD_BATCH + i] * x->lagrange[power * THUD_POINTS + k];
            }
    }
    return true;
}

/* Where modes do not couple, each of two contacts answers to the other in the same way. */
static bool mirror_pair(const struct thud_state *state, struct thud_collocation *x, int level, int a, int b)
{
    const struct thud_response *other = &x->pair[level][b * x->nc + a];
    if (state->model->couples || !other->indentation)
        return false;
    x->pair[level][a * x->nc + b] = *other;
    x->pair[level][a * x->nc + b].shared = true;
    return true;
}

const struct thud_response *thud_collocation_response(const struct thud_state *state, struct thud_collocation *x,
                                                      int level, double h, int a, int b)
{
    if (!x->pair[level])
        x->pair[level] = thud_collocation_allocate((size_t)x->nc * (size_t)x->nc, sizeof(struct thud_response));
    if (!x->pair[level])
        return NULL;
    struct thud_response *r = &x->pair[level][a * x->nc + b];
    return r->indentation || mirror_pair(state, x, level, a, b) || fill_pair(state, x, level, h, a, b) ? r : NULL;
}
