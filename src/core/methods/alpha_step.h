/* One-step schemes with Newmark's update, of which generalized-alpha is the widest (Chung and Hulbert 1993):
 *
 *     (1 - am) a1 + am a0 = (1 - af) r(q1, v1) + af r(q0, v0)
 *     q1 = q0 + h v0 + h^2 ((1/2 - beta) a0 + beta a1)
 *     v1 = v0 + h ((1 - gamma) a0 + gamma a1)
 *
 * where r is the acceleration by the equations of motion. am = af = 0 is Newmark; with beta = 0 as well it is the
 * central difference. Linear parts are solved in modal coordinates, the contact forces of the step's end by Newton's
 * method on the contacts that act. */
#ifndef THUD_CORE_ALPHA_STEP_H
#define THUD_CORE_ALPHA_STEP_H

#include "core/methods/stepping.h"

struct thud_alpha {
    double am, af, beta, gamma;
    bool lagged; /* the contact force of the step's end is taken from its start: eq. (1) read as an update rule */
};

/* For a method's own create; its step, committed and free are those below. Errors: as thud_method's. */
enum thud_status thud_alpha_create(const struct thud_state *state, struct thud_alpha parameters, void **own,
                                   struct thud_error *err);
enum thud_status thud_alpha_step(const struct thud_state *state, void *own, struct thud_segment *seg,
                                 struct thud_error *err);
void thud_alpha_committed(const struct thud_state *state, void *own, const struct thud_segment *seg, double tau_s,
                          bool switched);
void thud_alpha_free(void *own);

#endif
