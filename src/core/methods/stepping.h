/* What the stepping methods share: the length of a step, the right-hand side of the equations of motion, and the
 * segment through both ends of a step. */
#pragma once

#include "core/contact/segment.h"

/* Doubles that a motion of segment.h needs, and their distribution; returns what comes after. */
size_t thud_motion_size(const struct thud_model *model);
double *thud_motion_place(struct thud_motion *motion, const struct thud_model *model, double *block);
/* The same as pieces of a block (base/arena.h) that begins with its q. */
#define THUD_MOTION_PIECES(motion, model)                                                                              \
    THUD_PIECE((motion).q, (model)->nmodes), THUD_PIECE((motion).qd, (model)->nmodes),                                 \
        THUD_PIECE((motion).qdd, (model)->nmodes), THUD_PIECE((motion).force, (model)->nrows)

/* The longest step now: to the next kink of the ground motion or the end, or what the run asks for. */
double thud_step_room(const struct thud_state *state);
/* Fixed-step methods: equal steps over that room, none longer than the option. */
double thud_step_length(const struct thud_state *state);

/* Ground acceleration `after` seconds from now, in the present interval of the ground motion. */
static inline double thud_step_ground(const struct thud_state *state, double after)
{
    double a0, a1;
    thud_state_ground(state, state->grid, &a0, &a1);
    return a0 + (a1 - a0) * ((state->offset_s + after) / state->grid_dt_s);
}

/* Force of row c at indentation (or drift) d and rate v inside a step; derivatives by d and v. Located: the branch that holds,
 * also a little beyond its end, which the run cuts off. Not located: the law as a function of the state alone, 0 where
 * d <= 0 and cut at 0, with the phase by the sign of the rate. */
double thud_step_force(const struct thud_state *state, int c, double d, double v, double *df_dd, double *df_dv);

/* Forces of all contacts and the acceleration, from motion->q, qd, `after` seconds from now. */
void thud_step_motion(const struct thud_state *state, struct thud_motion *motion, double after);

/* What small changes of q and q' in change->q, qd make of the forces and accelerations at x, into change->force, qdd.
 * Changes of an indentation and its rate that rounding may have left make no force. */
void thud_step_motion_change(const struct thud_state *state, const struct thud_motion *x, struct thud_motion *change);

/* The segment of length h with the quintic of every mode through q, q', q'' of both ends (so that at s = 1 the state is
 * the method's own), and the contact forces: located, the law's along that motion; else straight from end to end, which
 * is all that such a step knows. Not located, observers read the two ends alone (seg->start, seg->end), and the
 * polynomials are left out where no history asks for them. */
void thud_step_write(const struct thud_state *state, struct thud_segment *seg, double h,
                     const struct thud_motion *start, const struct thud_motion *end, struct thud_motion *work);
