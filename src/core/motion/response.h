/* How contacts move at the points of a step: without contact forces, and under each other's. Both are sums over modes with
 * factors that depend on the step size alone: tables, made when first needed. */
#pragma once

#include "core/contact/state.h"
#include "core/motion/nodes.h"

struct thud_responses;

/* Points of a step: the nodes, at which forces are unknown, and others behind them; the first of those is in one batch
 * with the nodes, as far as an iteration for the forces goes. */
enum { THUD_NODES = THUD_BATCH - 1, THUD_POINTS = THUD_BATCH + 2 };

/* To the force at a node of another contact, or of the contact itself: (THUD_NODES x THUD_POINTS). */
struct thud_response {
    double *indentation, *rate;
    double *own_indentation, *own_rate; /* (THUD_BATCH) at each node to the force there; 0 behind them */
    bool shared;                        /* the memory is another's */
};

/* point (THUD_POINTS); lagrange (THUD_NODES x THUD_NODES): coefficients of the polynomials through the nodes. Steps:
 * h_top / 2^level. tolerance: of the forces, relative. Errors: THUD_MEMORY. */
enum thud_status thud_responses_create(const struct thud_model *model, const double *point, const double *lagrange,
                                       double h_top, double tolerance, struct thud_responses **out,
                                       struct thud_error *err);
void thud_responses_free(struct thud_responses *responses);

/* Makes the responses of these contacts to each other at this step size: out (n x n), of one to the force of the other.
 * Errors: THUD_MEMORY. */
enum thud_status thud_responses_make(struct thud_responses *responses, int level, const int *contact, int n,
                                     const struct thud_response **out, struct thud_error *err);

/* Indentations and rates of these contacts at the points of a step from the state on, if no contact force acted: d, v
 * (n x THUD_POINTS). Kinks of the ground motion before end_s lie inside the step. Only once responses of the level are
 * made. */
void thud_responses_unforced(struct thud_responses *responses, const struct thud_state *state, int level, double end_s,
                             const int *contact, int n, double *d, double *v);
