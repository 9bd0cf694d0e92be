/* A polynomial evaluated at several fixed nodes of [0, 1] in one pass, as a batch: the powers of all nodes are
 * tabulated, so that the processor works on two nodes at a time and there is no chain of Horner's scheme. */
#ifndef THUD_CORE_NODES_H
#define THUD_CORE_NODES_H

#include "core/contact/segment.h"
#include "core/numerics/double_pair.h"

enum { THUD_BATCH = 8 };

/* Values at all nodes. */
struct thud_batch {
    thud_double_pair pair[THUD_BATCH / 2];
};

static inline struct thud_batch thud_batch_at(const double *x)
{
    struct thud_batch batch;
    for (int i = 0; i < THUD_BATCH / 2; i++)
        batch.pair[i] = thud_double_pair_at(x + 2 * i);
    return batch;
}

static inline void thud_batch_put(const struct thud_batch *batch, double *x)
{
    for (int i = 0; i < THUD_BATCH / 2; i++)
        *(thud_double_pair *)(x + 2 * i) = batch->pair[i];
}

/* sum += factor x */
static inline void thud_batch_add(struct thud_batch *sum, double factor, const double *x)
{
    for (int i = 0; i < THUD_BATCH / 2; i++)
        sum->pair[i] += factor * thud_double_pair_at(x + 2 * i);
}

struct thud_nodes {
    double power[THUD_SEGMENT_TERMS][THUD_BATCH]; /* [k][i]: s_i^k */
};

/* Nodes scale s[i]; count <= THUD_BATCH, the others are put at 0. For polynomials of up to `terms` coefficients, at
 * least 2. */
void thud_nodes_set(struct thud_nodes *nodes, int count, const double *s, double scale, int terms);

/* Values at all nodes (THUD_BATCH) of c[0] + c[stride] s + ..., n coefficients. */
void thud_nodes_values(const struct thud_nodes *nodes, const double *c, int stride, int n, double *value);

#endif
