/* A polynomial read at several fixed places of [0, 1] in one pass: the places stand side by side, so that a processor
 * works on several at a time, and no place waits for another's Horner scheme. */
#ifndef THUD_CORE_PLACES_H
#define THUD_CORE_PLACES_H

#include "core/double_pair.h"
#include "core/segment.h"

enum { THUD_PLACES = 8 };

/* Values at all places. */
struct thud_lanes {
    thud_pair pair[THUD_PLACES / 2];
};

static inline struct thud_lanes thud_lanes_at(const double *x)
{
    struct thud_lanes lanes;
    for (int i = 0; i < THUD_PLACES / 2; i++)
        lanes.pair[i] = thud_pair_at(x + 2 * i);
    return lanes;
}

static inline void thud_lanes_put(const struct thud_lanes *lanes, double *x)
{
    for (int i = 0; i < THUD_PLACES / 2; i++)
        *(thud_pair *)(x + 2 * i) = lanes->pair[i];
}

/* sum += factor x */
static inline void thud_lanes_add(struct thud_lanes *sum, double factor, const double *x)
{
    for (int i = 0; i < THUD_PLACES / 2; i++)
        sum->pair[i] += factor * thud_pair_at(x + 2 * i);
}

struct thud_places {
    double power[THUD_SEGMENT_TERMS][THUD_PLACES]; /* [k][i]: s_i^k */
};

/* Places scale s[i]; count <= THUD_PLACES, the others are put at 0. For polynomials of up to `terms` coefficients, at
 * least 2. */
void thud_places_set(struct thud_places *places, int count, const double *s, double scale, int terms);

/* Values at all places (THUD_PLACES) of c[0] + c[stride] s + ..., n coefficients. */
void thud_places_read(const struct thud_places *places, const double *c, int stride, int n, double *value);
/* Its rates, where s runs from 0 to 1 in the time h. */
void thud_places_slope(const struct thud_places *places, const double *c, int stride, int n, double h, double *slope);

#endif
