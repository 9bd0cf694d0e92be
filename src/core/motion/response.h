/* How contacts move at the points of a step: without contact forces, and under each other's. Both are sums over modes with
 * factors that depend on the step size alone: tables, made when first needed. A motion is an indentation and its rate. */
#pragma once

#include <stdint.h>

#include "core/contact/contact_state.h"
#include "core/numerics/vec.h"

struct thud_responses;

/* Points of a step: n nodes, at which its forces are given, the first at its start, and others behind them. */
enum { THUD_NODES_MAX = 7, THUD_POINTS_MAX = THUD_NODES_MAX + 2 };

/* Length of the steps of a level below 64. */
static inline double thud_level_step(double h_top, int level)
{
    return h_top / (double)(UINT64_C(1) << level);
}

/* point (points); lagrange (n x n): coefficients of the polynomials through the nodes. Errors: THUD_MEMORY. */
enum thud_status thud_responses_create(const struct thud_state *state, int n, int points, const double *point,
                                       const double *lagrange, double h_top, struct thud_responses **out,
                                       struct thud_error *err);

/* Makes the responses of these contacts, in order, to each other at this step size: out (n x n), of one to the force of the other at
 * each node (points x nodes). Errors: THUD_MEMORY. */
enum thud_status thud_responses_make(struct thud_responses *responses, int level, const int *contact, int n,
                                     const thud_vec2 **out, struct thud_error *err);

/* Motions of these contacts at the points of a step from the state on, if no contact force acted and the ground went on as
 * it does now: out (n x points), of which start has those at its start. Only once responses of the level are made. */
void thud_responses_unforced(struct thud_responses *responses, const struct thud_state *state, int level,
                             const int *contact, int n, const thud_vec2 *start, thud_vec2 *out);
