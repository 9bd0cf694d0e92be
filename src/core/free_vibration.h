/* Tables and working space of free flight: see free_vibration.c. */
#ifndef THUD_CORE_FREE_VIBRATION_H
#define THUD_CORE_FREE_VIBRATION_H

#include "core/run_private.h"

enum {
    THUD_FREE_VIBRATION_BLOCK = 256,
    THUD_FREE_VIBRATION_ENDS = THUD_FREE_VIBRATION_BLOCK + 4
};                                      /* intervals in a block; their ends, by fours */
enum { THUD_FREE_VIBRATION_BATCH = 4 }; /* modes that march together; rows beyond the last mode stay 0 */
/* The interval in which one floor's value peaks, its series not yet made. */
struct thud_deferred_peak {
    bool waits;
    long grid;
    double most; /* what the peak is at most */
};

struct thud_free_vibration {
    int n;      /* modes */
    int pieces; /* series needed for one interval */
    /* One interval, by mode: q = e[0] q + e[1] q' + p[0] a0 + p[1] a1, q' = e[2] q + e[3] q' + p[2] a0 + p[3] a1 */
    double *e[4], *p[4];
    /* Damping loss over one interval, a quadratic form in (q, q', a0, a1), by mode; the ground's own terms summed over
     * the modes */
    double *viscous[7], viscous_ground[3];
    /* Work of the ground: a0 (r[0] q + r[1] q') + a1 (r[2] q + r[3] q') and the ground's own terms */
    double *work[4], work_ground[3];
    double *now, *now_rate; /* (n) modal state while one interval is looked at */

    /* A block of intervals, by row and then by end (so that loops over time vectorize) */
    double *q, *qd, *spring;              /* (n x ENDS) modal state, and omega^2 q + 2 zeta omega q' */
    double *value[THUD_FLOOR_QUANTITIES]; /* (ndof x ENDS) by floor */
    double *bound[3];                     /* (n x ENDS) of a mode's fourth, fifth and sixth derivative */
    double *gap, *energy;                 /* (ENDS) */
    double *ground, *after;               /* (ENDS) ground acceleration at the start and at the end of each interval */
    double *margin; /* (QUANTITIES x nstructures): how far a value inside an interval may lie above those at its ends */
    double *speed;  /* (n) largest sqrt(q'^2 + omega^2 q^2) of a mode in the block */
    bool *looked;   /* (nstructures) whether its floors may have new peaks: all their values are there */
    double *limit;  /* (ncontacts) gap above which a contact may close in an interval of the block */
    bool *near;     /* (ncontacts) whether it may in the interval looked at */
    bool *bounded;  /* (nstructures) whether `bound` holds for the block */
    double *lower, *upper; /* (ENDS) what the largest value of one row in each interval is at least and at most */
    struct thud_deferred_peak *deferred; /* (QUANTITIES x ndof) */
    int stride;                          /* modes of the structure that has most */
    double *kept; /* (QUANTITIES x ndof x 2 x stride) q, q' of its structure at the interval's start */
    int size;     /* intervals to try next */
    double *block;
};

/* Left less right displacement of contact c at the ends of a marched block into f->gap; returns the largest, *margin:
 * how far one inside an interval may lie above those at its ends. */
double thud_free_vibration_gap(struct thud_free_vibration *f, const struct thud_model *model, int c, int ends,
                               double *margin);

#endif
