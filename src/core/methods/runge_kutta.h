/* Explicit Runge-Kutta steps for the equations of motion, whose last stage is the end of the step (first same as last):
 * what it finds there is the start of the next step. */
#pragma once

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
    double *block;
};

/* Errors: THUD_MEMORY; nothing stays allocated then. */
enum thud_status thud_rk_init(struct thud_rk *rk, const struct thud_state *state, const struct thud_tableau *tableau,
                              struct thud_error *err);
void thud_rk_clear(struct thud_rk *rk);

/* The right-hand side at the run's state into stage[0]. */
void thud_rk_start(const struct thud_state *state, struct thud_rk *rk);
/* All other stages of a step of length h. */
void thud_rk_stages(const struct thud_state *state, struct thud_rk *rk, double h);
/* Writes state->seg from them. */
void thud_rk_write(const struct thud_state *state, struct thud_segment *seg, struct thud_rk *rk, double h);
/* Keeps the end as the next start where the whole step was taken and nothing changed at its end. */
void thud_rk_committed(const struct thud_state *state, const struct thud_segment *seg, struct thud_rk *rk,
                       bool switched);
