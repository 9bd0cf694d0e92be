/* Storeys that yield: bilinear with kinematic hardening, each storey on its own. With the drift d = u_i - u_(i-1),
 *
 *     V = r k d + (1 - r) k (d - d_p),   |d - d_p| <= d_y
 *
 * where d_p moves while the bound holds with equality and d' goes outward (an elastic spring r k beside an elastoplastic
 * one (1 - r) k). The elastic stiffness k is part of the modes; what is left is a force of the storey's row,
 *
 *     F = -(1 - r) k d_p:  elastic   constant
 *                          yielding  f0 + kappa d,  kappa = -(1 - r) k,  f0 = +-(1 - r) k d_y
 *
 * so that the storey is propagated as a linear contact is. It is elastic (direction 0: the row's force is constant) or
 * yields one way (by its branch); the guards are in core/contact/event.c. A method that does not
 * locate events reads F from the drift alone, by the return to the bound, and d_p follows at the ends of its steps. */
#pragma once

#include "core/contact/contact_state.h"
#include "core/contact/event.h"

/* All storeys elastic. */
void thud_storeys_start(struct thud_state *state);
/* As at an earlier moment (nstoreys), when none of them yielded. */
void thud_storeys_resume(struct thud_state *state, const struct thud_storey_state *storey);
/* The state has gone on: plastic drift, energy, excursions and largest shear of the storeys that yield. Not located: of
 * all storeys, from their drift. */
void thud_storeys_moved(struct thud_state *state);
/* Acts on an event of a storey's row. */
void thud_storey_switch(struct thud_state *state, int row, enum thud_event event);

/* d_p that belongs to drift d, from the one at the state. */
double thud_storey_plastic(const struct thud_state *state, int k, double drift_m);
/* Force F of storey k at drift d (by the return to the bound), and its derivative. */
double thud_storey_force(const struct thud_state *state, int k, double drift_m, double *df_dd);
/* Shear V of storey k at drift d. */
double thud_storey_shear(const struct thud_state *state, int k, double drift_m);
/* What the storeys' energy has beyond that of their elastic stiffness at modal coordinates q: the sum of
 * (1 - r) k d_p (d_p/2 - d). */
double thud_storeys_strain(const struct thud_state *state, const double *q);
/* Energy lost in all storeys up to the state, and up to modal coordinates q behind it. */
double thud_storeys_hysteretic(const struct thud_state *state, const double *q);
