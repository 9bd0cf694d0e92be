/* No contact closed: free vibration over whole intervals of the ground motion, which is linear in each, by the exact
 * 2 x 2 recurrence of every mode (Nigam and Jennings 1969), a block of intervals at a time.
 *
 *     q(t + dt)  = e0 q + e1 q' + p0 a(t) + p1 a(t + dt),   q'(t + dt) = e2 q + e3 q' + p2 a(t) + p3 a(t + dt)
 *
 * Storeys with a plastic drift have constant forces, which shift the place that the modes swing about by s: then
 * (1 - e0) s is added to q, and -e2 s to q'.
 *
 * Bounds show in which intervals no contact can close and no storey can yield; the others are looked at as power series. The motion is the
 * recurrence's in any case, so that gaps that do not close change nothing. Structures whose damping couples their modes
 * are moved by the propagator of coupled_motion in place of the recurrence. */
#pragma once

#include "core/motion/coupled_motion.h"

enum {
    THUD_FREE_VIBRATION_BATCH = 4, /* modes that advance together; rows beyond the last mode stay 0 */
    THUD_FREE_VIBRATION_PRODUCTS = 7
};

/* Of one interval of the ground motion, the same for all of them. */
struct thud_free_vibration_tables {
    double *e[4], *p[4]; /* (n) the recurrence */
    /* Damping loss over one interval, a quadratic form in (q, q', a0, a1): by mode, of q q, q q', q' q', q a0, q a1,
     * q' a0, q' a1 */
    double *viscous[THUD_FREE_VIBRATION_PRODUCTS];
    double *work[4];     /* work of the ground: a0 (r[0] q + r[1] q') + a1 (r[2] q + r[3] q') */
    double ground[2][3]; /* of both, what the ground alone adds, summed over the modes: a0 a0, a0 a1, a1 a1 */
};

/* The power series of one piece of one interval, and the systems whose it has. */
struct thud_free_vibration_series {
    struct thud_segment seg;
    double *now, *now_rate; /* (n) modal state at its start */
    int t, piece;           /* piece -1: none */
    bool *has;              /* (nsystems) */
};

struct thud_free_vibration {
    const struct thud_model *model;
    int n; /* modes */
    int nsystems;
    int pieces; /* series needed for one interval */
    double dt_s;
    struct thud_free_vibration_tables tables;
    struct thud_coupled_motion *coupled; /* (nsystems) of those whose damping couples modes; behind them (nstoreys) of
                                            the system of a storey while it yields; size 0: another */
    int yields;                          /* in the block, this storey; -1: none */
    double *bound; /* (nsystems x 7) of the derivatives of such a system in a block, by order; NaN: not yet made */

    struct thud_free_vibration_series series;

    /* A block of intervals, by row and then by end (so that loops over time vectorize) */
    double *shift;        /* (n) s */
    bool shifted;         /* it is not 0 */
    double *q, *qd;       /* (n x ENDS) modal state */
    double *acceleration; /* (n x ENDS) of the modes without the ground's, where values have it */
    double *work[3];      /* (n x ENDS) derivatives of the last orders that are bounded, where damping couples modes */
    double *moved;        /* (n x ENDS) q - s there */
    double *value[THUD_FLOOR_QUANTITIES]; /* (ndof x ENDS) by floor, of what has been asked for: */
    bool *valued;                         /* (QUANTITIES x nstructures) */
    double *gap;                          /* (ENDS) */
    double *ground, *after;               /* (ENDS) ground acceleration at the start and at the end of each interval */
    double ground_most, slope;            /* largest sizes in the block of it and of its rate */
    double *margin; /* (QUANTITIES x nstructures): thud_free_vibration_margin; NaN: not yet made */
    double *speed;  /* (n) largest sqrt(q'^2 + omega^2 (q - s)^2) of a mode in the block */
    double *limit;  /* (ncontacts) gap above which a contact may close in an interval of the block */
    bool *near;     /* (ncontacts) whether it may in the interval looked at */
    int ends;       /* in the block */
    int certain;    /* interval of the block in which an event lies, whatever block it is in: by its end; -1: none */
    int size;       /* intervals to try next; 0: in the next one an event is certain */
    long made;      /* series so far: what the work is measured by */
};

/* *out stays NULL for a model that it is not for. The tables are those of `like` (may be NULL), whose model must still
 * be there, where it has the same modes and intervals. Errors: THUD_MEMORY. */
enum thud_status thud_free_vibration_create(const struct thud_state *state, const struct thud_free_vibration *like,
                                            struct thud_free_vibration **out, struct thud_error *err);

/* Makes a block from the state on, and returns how many intervals pass before one in which a contact closes or a storey
 * yields, or unloads; 0 where the state is not at the start of an interval, a contact is not open, more than one storey
 * yields or one that has no tables for that, or nothing is left. */
int thud_free_vibration_advance(struct thud_free_vibration *f, const struct thud_state *state);
/* The block's modal state after so many intervals. */
void thud_free_vibration_end(const struct thud_free_vibration *f, int intervals, double *q, double *qd);

/* What observers read of the block just advanced from `state`. */

/* One quantity of a structure's floors into f->value, which is made only when asked for. */
void thud_free_vibration_values(struct thud_free_vibration *f, const struct thud_model *model, int structure,
                                int quantity);
/* Bound of the derivative of order 2 to 6 of a sum over a structure's modes (modes) in the block. */
double thud_free_vibration_bend(struct thud_free_vibration *f, const struct thud_model *model, int structure,
                                const double *row, int order);
/* The same of a quantity of any floor, `more` orders (2 or 4) above its own: an acceleration is omega^2 q + 2 zeta omega q'
 * (or + D q'), whose derivatives have the bounds of two orders more. */
double thud_free_vibration_floor_bend(struct thud_free_vibration *f, const struct thud_model *model, int structure,
                                      int quantity, int more);
/* How far a quantity of any floor may lie above its values at the ends inside an interval. */
double thud_free_vibration_margin(struct thud_free_vibration *f, const struct thud_model *model, int structure,
                                  int quantity);
/* Where damping couples modes, what the size of all modes' total accelerations, sqrt(sum (q'' + gamma a_g)^2), can come to
 * inside the intervals, or that of the change of their velocities from the nearest end. */
double thud_free_vibration_size(struct thud_free_vibration *f, const struct thud_model *model, int structure,
                                int quantity);
/* Left less right displacement of contact c at the ends into f->gap; returns the largest, *margin: how far one inside
 * an interval may lie above those at its ends. */
double thud_free_vibration_gap(struct thud_free_vibration *f, const struct thud_model *model, int c, int ends,
                               double *margin);
/* The same for the size of one side's displacement. */
double thud_free_vibration_side(struct thud_free_vibration *f, const struct thud_model *model,
                                const struct thud_model_side *side, int ends, double *margin);
/* Rate of a floor's value at end t of an interval whose ground acceleration there is `ground`. */
double thud_free_vibration_rate(struct thud_free_vibration *f, const struct thud_model *model, int structure, int floor,
                                int quantity, int t, double ground);
/* Motion of one structure in a piece (0 ... f->pieces - 1) of interval t, until the next call: of structures of other
 * systems it has the same piece, or no number. */
const struct thud_segment *thud_free_vibration_series(struct thud_free_vibration *f, const struct thud_state *state,
                                                      int structure, int t, int piece);
/* The same of the structures that row c touches (a contact, a storey), and of all. */
const struct thud_segment *thud_free_vibration_row_series(struct thud_free_vibration *f, const struct thud_state *state,
                                                          int c, int t, int piece);
const struct thud_segment *thud_free_vibration_all_series(struct thud_free_vibration *f, const struct thud_state *state,
                                                          int t, int piece);
/* Loss in the dashpot of a link over the block. */
double thud_free_vibration_link_loss(const struct thud_free_vibration *f, const struct thud_model *model, int link);
/* Work of the ground and loss in damping over the intervals of the block. */
void thud_free_vibration_work(const struct thud_free_vibration *f, int intervals, double *input_j, double *viscous_j);
