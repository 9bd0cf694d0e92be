/* What the files of the collocation share. */
#ifndef THUD_CORE_COLLOCATION_PRIVATE_H
#define THUD_CORE_COLLOCATION_PRIVATE_H

#include <lapacke.h>

#include "core/collocation.h"
#include "core/nodes.h"

/* Values at the points of a contact stand THUD_BATCH apart; those past the last point are padding. */
enum { THUD_POINTS = 7, THUD_LEVELS = 48, THUD_BLOCK = THUD_POINTS * THUD_BATCH };

/* Indentation and rate at point i from the force at point j of another contact, per step size: blocks (THUD_POINTS x
 * THUD_BATCH) by [j][i], made when first needed. */
struct thud_response {
    double *indentation, *rate;
    bool shared; /* the memory is another's */
};

/* Unit motions of the modes: initial displacement, initial rate, constant ground acceleration, one rising from 0. */
enum { THUD_UNIT_Q, THUD_UNIT_QD, THUD_UNIT_A0, THUD_UNIT_A1, THUD_UNITS };

struct thud_collocation {
    double node[THUD_POINTS], lagrange[THUD_POINTS * THUD_POINTS];
    struct thud_nodes nodes, checks; /* the points, and those between them where the error is measured */
    double h_top;                    /* step of level 0 */
    double h, h_touch;
    int steady;         /* steps since one that let the next be longer */
    double contraction; /* of the fixed-point iteration, as last measured and with a margin */
    bool just_touched;
    bool has_source; /* the forces of the last segment go on into this step */
    double *last;    /* (THUD_POINTS x nc): their coefficients, in a segment of last_h, from s = source on */
    double last_h, source;
    int nc, nmodes, loads;      /* loads: 1 where modes are uncoupled, else one per contact */
    double *modal[THUD_LEVELS]; /* (loads x THUD_POINTS x nmodes x 2 x THUD_BATCH): q and q' of each mode at the
                                   points, by load and power */
    struct thud_response *pair[THUD_LEVELS]; /* (nc x nc) */
    double *unforced[THUD_LEVELS]; /* (nmodes x THUD_UNITS x 2 x THUD_BATCH): how far each mode moves to the points,
                                      and its rate there, in each unit motion without contact; not where modes couple */
    double *moved;                 /* (nmodes x 2 x THUD_BATCH) the same in the step at hand */
    struct thud_segment seg;       /* of unit loads, and of the motion without contact forces */
    double *seg_block;
    /* The system: unknowns are the forces of the active contacts at the points */
    int *active; /* (nc) */
    int nactive, capacity;
    double *force, *d0, *v0, *d, *v; /* (nactive x THUD_BATCH) */
    double *residual, *matrix;       /* (nactive x THUD_POINTS); square */
    double *scale, *change;          /* (nactive) on which a change of the force counts, and the last one */
    lapack_int *pivot;
};

/* A segment whose contact forces are given: its series has to follow the modes alone. */
void thud_collocation_begin(const struct thud_state *state, struct thud_segment *seg, double h);

/* collocation_response.c: of contact a's points to the forces of contact b at one step size; made when first asked for.
 * NULL: out of memory. */
const struct thud_response *thud_collocation_response(const struct thud_state *state, struct thud_collocation *x,
                                                      int level, double h, int a, int b);
/* Indentations and rates of the active contacts at the points if no contact force acted, into d0 and v0. false: out of
 * memory. */
bool thud_collocation_unforced(const struct thud_state *state, struct thud_collocation *x, int level, double h);
/* calloc of at least one element. */
void *thud_collocation_allocate(size_t count, size_t size);

/* collocation_error.c: scale on which an error of the a-th active contact's force counts, and the largest error of the
 * step in seg-> */
double thud_collocation_scale(const struct thud_state *state, const struct thud_collocation *x, int a);
double thud_collocation_error(const struct thud_state *state, struct thud_segment *seg,
                              const struct thud_collocation *x, double h);

#endif
