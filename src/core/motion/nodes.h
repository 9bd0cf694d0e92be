/* A polynomial evaluated at several fixed nodes of [0, 1] in one pass, as a batch: the powers of all nodes are
 * tabulated, so that the processor works on two nodes at a time and there is no chain of Horner's scheme. */
#pragma once

#include "core/contact/segment.h"
#include "core/numerics/vec.h"

struct thud_nodes {
    double power[THUD_SEGMENT_TERMS][THUD_BATCH]; /* [k][i]: s_i^k */
};

/* Nodes scale s[i]; count <= THUD_BATCH, the others are put at 0. For polynomials of up to `terms` coefficients, at
 * least 2. */
void thud_nodes_set(struct thud_nodes *nodes, int count, const double *s, double scale, int terms);

/* Values at all nodes (THUD_BATCH) of c[0] + c[stride] s + ..., n coefficients. */
void thud_nodes_values(const struct thud_nodes *nodes, const double *c, int stride, int n, double *value);
