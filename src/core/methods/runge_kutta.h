/* Explicit Runge-Kutta steps for the equations of motion, whose last stage is the end of the step (first same as last):
 * what it finds there is the start of the next step. */
#pragma once

#include "core/methods/method.h"
#include "core/methods/stepping.h"

enum { THUD_RK_STAGES_MAX = 7 };

struct thud_tableau {
    int stages;
    double c[THUD_RK_STAGES_MAX];
    double a[THUD_RK_STAGES_MAX][THUD_RK_STAGES_MAX]; /* row i: weights of the stages before stage i */
};

struct thud_rk {
    const struct thud_tableau *tableau;
    struct thud_motion stage[THUD_RK_STAGES_MAX], work; /* stage[0]: start, the last one: end */
    bool first_known;                                   /* stage[0] holds the right-hand side at the run's state */
    double end_mps2;                                    /* ground acceleration at the end of the step before */
};

/* Of a method whose scheme is a struct thud_tableau; *own is a struct thud_rk. */
enum thud_status thud_rk_create(const struct thud_method *method, const struct thud_state *state, void **own,
                                struct thud_error *err);

/* The right-hand side at the run's state into stage[0]. */
void thud_rk_start(const struct thud_state *state, struct thud_rk *rk);
/* All other stages of a step of length h. */
void thud_rk_stages(const struct thud_state *state, struct thud_rk *rk, double h);
/* Keeps the end as the next start where the whole step was taken and nothing changed at its end. */
void thud_rk_committed(const struct thud_state *state, void *own, const struct thud_segment *seg, double tau_s,
                       bool switched);
