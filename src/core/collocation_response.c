/* How contacts answer to each other's forces at the points of a step. */
#include <stdlib.h>
#include <string.h>

#include "core/collocation_private.h"

void *thud_collocation_allocate(size_t count, size_t size)
{
    return calloc(count ? count : 1, size);
}

/* Motion of every mode at the points under unit loads s^power. */
static bool fill_modal(const struct thud_run *run, struct thud_collocation *x, int level, double h)
{
    size_t n = (size_t)x->nmodes;
    double *table = thud_collocation_allocate((size_t)x->loads * THUD_POINTS * THUD_POINTS * 2 * n, sizeof *table),
           *ones = thud_collocation_allocate(n, sizeof *ones);
    x->modal[level] = table;
    if (!table || !ones) {
        free(ones);
        return false;
    }
    for (size_t j = 0; j < n; j++)
        ones[j] = 1;
    x->seg.terms = THUD_SEGMENT_TERMS;
    x->seg.h_s = h;
    x->seg.a0 = x->seg.a1 = 0;
    memset(x->seg.force, 0, THUD_SEGMENT_TERMS * (size_t)x->nc * sizeof(double));
    for (int load = 0; load < x->loads; load++)
        for (int power = 0; power < THUD_POINTS; power++) {
            thud_taylor_load(run->model, &x->seg, !run->model->couples ? ones : run->model->g + (size_t)load * n,
                             power);
            for (int i = 0; i < THUD_POINTS; i++, table += 2 * n)
                thud_segment_state(&x->seg, x->nmodes, x->node[i], table, table + n);
        }
    free(ones);
    return true;
}

/* Response of contact a to forces of contact b. A force pushes the two apart: indentation falls. */
static bool fill_pair(const struct thud_run *run, struct thud_collocation *x, int level, double h, int a, int b)
{
    size_t n = (size_t)x->nmodes;
    if (!x->modal[level] && !fill_modal(run, x, level, h))
        return false;
    struct thud_response *r = &x->pair[level][a * x->nc + b];
    double *block = thud_collocation_allocate(2 * THUD_BLOCK, sizeof *block);
    if (!block)
        return false;
    r->indentation = block;
    r->rate = block + THUD_BLOCK;
    const double *ga = run->model->g + (size_t)a * n, *gb = run->model->g + (size_t)b * n;
    const double *table = x->modal[level] + (!run->model->couples ? 0 : (size_t)b * THUD_POINTS * THUD_POINTS * 2 * n);
    for (int power = 0; power < THUD_POINTS; power++)
        for (int i = 0; i < THUD_POINTS; i++, table += 2 * n) {
            double d = 0, v = 0;
            for (size_t j = 0; j < n; j++) {
                double w = !run->model->couples ? ga[j] * gb[j] : ga[j];
                d -= w * table[j];
                v -= w * table[n + j];
            }
            for (int k = 0; k < THUD_POINTS; k++) {
                r->indentation[k * THUD_PLACES + i] += d * x->lagrange[power * THUD_POINTS + k];
                r->rate[k * THUD_PLACES + i] += v * x->lagrange[power * THUD_POINTS + k];
            }
        }
    return true;
}

const struct thud_response *thud_collocation_response(const struct thud_run *run, struct thud_collocation *x, int level,
                                                      double h, int a, int b)
{
    if (!x->pair[level])
        x->pair[level] = thud_collocation_allocate((size_t)x->nc * (size_t)x->nc, sizeof(struct thud_response));
    if (!x->pair[level])
        return NULL;
    struct thud_response *r = &x->pair[level][a * x->nc + b];
    return r->indentation || fill_pair(run, x, level, h, a, b) ? r : NULL;
}
