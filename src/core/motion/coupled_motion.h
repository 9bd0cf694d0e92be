/* Free vibration of a system whose damping couples its modes (an isolated building, linked neighbours), or of one mode
 * alone, over whole intervals of the ground motion, by the exact propagator of one interval. With x = (q, q', a, b) and
 * the ground acceleration a + b t/dt in it,
 *
 *     x' = A x,   x(t + dt) = exp(A dt) x(t),
 *
 * and what damping and the ground do in the interval are quadratic forms in x:
 *
 *     loss = int q'^T D q' dt = x^T L x,   input = -int (gamma . q') a_g dt = a (W_a . x) + b (W_b . x).
 *
 * While a storey yields, A has Omega^2 + kappa g g^T in place of Omega^2, kappa = -(1 - r) k, and x is about the rest.
 * Propagator and forms are made over a part of the interval short enough for power series and one quadrature, and
 * doubled: E(2h) = E E, L(2h) = L + E^T L E, and W likewise (scaling and squaring: Moler and Van Loan, SIAM Review 45
 * (2003) 3-49). Not for dashpots whose own rates are far above 1/dt: the squares would do, but the bounds of
 * free_vibration would not. */
#pragma once

#include "core/contact/segment.h"

enum {
    THUD_FREE_VIBRATION_BLOCK = 128,                         /* intervals in a block; blocks begin at its multiples */
    THUD_FREE_VIBRATION_ENDS = THUD_FREE_VIBRATION_BLOCK + 4 /* their ends, by fours; a row holds as many */
};

struct thud_coupled_motion {
    int n, size; /* modes, and of x: 2 n + 2 */
    int first_mode;
    const double *soft; /* (n) g of a row that yields, NULL: none; its force is soft_npm g . (q - s) about the rest s */
    double soft_npm;    /* below 0 */
    double *step;       /* (size x 2 n) to q and q' an interval later, by each entry of x */
    double *loss;       /* ((1 + links) x size x size) upper part of L, and of x^T L_l x of links with a dashpot, by the
                         accelerations at both ends */
    double *input;      /* (size x size) upper part of W, as a form by the accelerations at both ends */
    int links, *link;   /* (links) these links in the model */
    double *work[2];    /* (size) W_a, W_b: the last rows of input */
    double *now;        /* (2 x size) */
    double *product;    /* (size x size) upper part of the sums of x x^T over the intervals of a block */
};

/* Of the structures of one system; mode: -1, or this one of its modes alone; storey: -1, or one that yields. Errors:
 * THUD_MEMORY. */
enum thud_status thud_coupled_motion_init(struct thud_coupled_motion *motion, const struct thud_state *state,
                                          int system, int mode, int storey, struct thud_blocks *memory,
                                          struct thud_error *err);

/* What ends a block early: row . (q - s), or row . q' where it is of rates, outside of these bounds at an end. */
struct thud_coupled_stop {
    const double *row; /* (n) NULL: nothing */
    bool rates;
    double low, high;
};

/* Rows of q, qd and of x = q - s of all modes, from the first value of q and qd on, under the ground accelerations at
 * the start and at the end of each interval, and constant forces under which the modes rest at s. Returns how many
 * intervals. */
int thud_coupled_motion_advance(struct thud_coupled_motion *motion, double *q, double *qd, const double *s, double *x,
                                const double *ground, const double *after, int intervals,
                                struct thud_coupled_stop stop);
/* Sums over the first intervals of the same rows, of which the following are made. */
void thud_coupled_motion_sum(struct thud_coupled_motion *motion, const double *x, const double *qd,
                             const double *ground, const double *after, int intervals);
/* Loss in the dashpot of the link whose index in the model is this; 0 where it has none. */
double thud_coupled_motion_link_loss(const struct thud_coupled_motion *motion, int link);
/* Adds work of the ground and loss in damping. */
void thud_coupled_motion_work(const struct thud_coupled_motion *motion, double *input_j, double *viscous_j);
