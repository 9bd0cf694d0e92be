/* The inside of an alpha step: what the scheme (alpha_step.c) and the contact forces at its end (alpha_forces.c) share. */
#pragma once

#include "core/methods/alpha_step.h"
#include "core/model/modal_operator.h"

/* Glossary, for one step of length h from t0 to t1; index j is a mode, a and c are rows (contacts, yielding storeys).
 *
 *     q0, q0', r0      x->end[0]  modal displacement (m kg^1/2), velocity, and acceleration by the equations of motion,
 *     q1, v1, r1       x->end[1]  r = -D q' - Omega^2 q - gamma a_g - sum_c g_c F_c, at both ends of the step
 *     a0, a1           x->a0, a1  the scheme's own accelerations, as in alpha_step.h
 *     A                x->op      ((1 - am) I + (1 - af)(gamma h D + beta h^2 Omega^2))^-1
 *     F_c              .force     force of row c, N; unknown at t1 where the row is active
 *     -da1/dF_c        x->response = (1 - af) A g_c, one row of nmodes for each c
 *     w_ac             x->w       -dd''_a/dF_c = g_a . (1 - af) A g_c, 1/kg
 *     d_a, d_a', d_a'' x->d, v, a indentation (drift) of row a at t1 and its rates if no active row had a force
 *
 * Without forces at t1, a1 follows from A at once (predict). With them, what is left is small: as many unknowns as rows
 * are active,
 *
 *     F_a = law_a(d_a - beta h^2 sum_c w_ac F_c,  d_a' - gamma h sum_c w_ac F_c)      (thud_alpha_forces, Newton)
 *
 * and q1, v1, a1 are corrected by them (correct). */
struct thud_alpha_work {
    struct thud_alpha p;
    struct thud_modal_operator op;
    double h_made; /* step that the operator and the responses belong to */
    struct thud_motion end[THUD_STEPS_AT_ONCE + 1], work;
    double *a0, *a1;            /* (nmodes); r itself where the scheme has no other */
    double *rhs;                /* (nmodes) workspace */
    double *response;           /* (nrows x nmodes) */
    double *reach;              /* (nrows) d_a^2 at most, by the sum of omega^2 q^2 */
    double *w;                  /* (nrows x nrows) */
    double *d, *v, *a;          /* (nrows) */
    double *matrix, *change;    /* Newton's system for the active rows, column-major, and its solution */
    lapack_int *active, *pivot; /* (nrows) rows whose forces are unknown */
    int nactive;
    bool solved;                     /* the contact forces at t1 are those of the laws */
    bool goes_on;                    /* t0 is the end of the last step: no law has changed there */
    bool fresh;                      /* a0 is to be recomputed from r0 */
    double a0_step_s;                /* step that a0 comes from */
    double ground_mps2, before_mps2; /* ground acceleration at t1, and at the end of the step before */
};

/* Contact forces at t1 by the laws, into x->end[1].force, and whether no contact is closed there into its apart. Where a
 * law jumps (nothing located) there may be no solution: the last try is taken, as a program does that only sees its
 * iterations run out, and counted as rejected. Located, an elastic storey that has yielded has a constant force. */
void thud_alpha_forces(const struct thud_state *state, struct thud_alpha_work *x, double h);
