/* What the files of the collocation share. */
#ifndef THUD_CORE_COLLOCATION_PRIVATE_H
#define THUD_CORE_COLLOCATION_PRIVATE_H

#include <lapacke.h>

#include "core/collocation.h"
#include "core/run_private.h"

enum { THUD_NODES = 7, THUD_LEVELS = 48, THUD_BLOCK = THUD_NODES * THUD_NODES };

/* Indentation and rate at point i from the force at point j of another contact, per step size: blocks (THUD_NODES x
 * THUD_NODES), made when first needed. */
struct thud_response {
    double *indentation, *rate;
};

struct thud_collocation {
    double node[THUD_NODES], lagrange[THUD_BLOCK], check[THUD_NODES];
    double h_top; /* step of level 0 */
    double h, h_touch;
    bool just_touched;
    bool has_source; /* run->seg holds forces that go on into this step, from s = source on */
    double source;
    int nc, nmodes, loads;      /* loads: 1 where modes are uncoupled, else one per contact */
    double *modal[THUD_LEVELS]; /* (loads x THUD_NODES x THUD_NODES x 2 x nmodes): q and h q' of each mode by load,
                                   power and point */
    struct thud_response *pair[THUD_LEVELS]; /* (nc x nc) */
    struct thud_segment seg;                 /* of unit loads, and of the motion without contact forces */
    double *seg_block;
    /* The system: unknowns are the forces of the active contacts at the points */
    int *active; /* (nc) */
    int nactive, capacity;
    double *force, *d0, *v0, *d, *v, *residual, *matrix; /* (nactive x THUD_NODES); matrix square */
    lapack_int *pivot;
};

/* collocation_response.c: of contact a's points to the forces of contact b at one step size; made when first asked for.
 * NULL: out of memory. */
const struct thud_response *thud_collocation_response(const struct thud_run *run, struct thud_collocation *x, int level,
                                                      double h, int a, int b);
/* calloc of at least one element. */
void *thud_collocation_allocate(size_t count, size_t size);

/* collocation_error.c: scale on which an error of the a-th active contact's force counts, and the largest error of the
 * step in run->seg. */
double thud_collocation_scale(const struct thud_run *run, const struct thud_collocation *x, int a);
double thud_collocation_error(struct thud_run *run, const struct thud_collocation *x, double h);

#endif
