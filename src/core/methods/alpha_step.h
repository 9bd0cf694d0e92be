/* One-step schemes with Newmark's update, of which generalized-alpha is the widest (Chung and Hulbert 1993). With r the
 * second rate q'' by the equations of motion, a step of length h is
 *
 *     q1 = q0 + h q0' + h^2 ((1/2 - beta) a0 + beta a1)
 *     v1 = q0' + h ((1 - gamma) a0 + gamma a1)
 *     (1 - am) a1 + am a0 = (1 - af) r(q1, v1) + af r(q0, v0)
 *
 *     am = af = 0                     Newmark: a is r itself
 *     am = af = 0, beta = 0           central difference (velocity Verlet)
 *     am = 0, af > 0                  Hilber, Hughes and Taylor
 *
 * r is linear but for the contact forces: its linear part is solved in modal coordinates, by (1 - am + (1 - af)(gamma h D
 * + beta h^2 Omega^2))^-1, and the contact forces of the step's end by Newton's method on those that act. Not for laws
 * of impulse without location. */
#pragma once

#include "core/methods/method.h"
#include "core/methods/stepping.h"

struct thud_alpha {
    double am, af, beta, gamma;
    bool lagged; /* the contact force of the step's end is taken from its start: eq. (1) read as an update rule */
};

extern const struct thud_stepper thud_alpha_stepper; /* of methods whose scheme is a struct thud_alpha */
