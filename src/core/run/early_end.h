/* Early termination: between contacts a run is the contact-free baseline, which is known, plus a free vibration,
 *
 *     q(t) = q_baseline(t) + dq(t),   |dq_j(t)| <= sqrt(dq_j^2 + ((dq_j' + zeta omega dq_j)/omega_d)^2) at its start
 *
 * Where the largest values of the baseline that are still to come, plus these amplitudes, show that no contact and no
 * new peak can follow, the run goes to its end in one step. Not for free bodies, whose difference does not decay. */
#pragma once

#include "core/observe/observer.h"
#include "core/observe/rest.h"

struct thud_early_end;

/* For a run without contact, whose observer it is. NULL where the traits of its elements forbid it, and when out of memory. */
struct thud_early_end *thud_early_end_create(const struct thud_model *model);
void thud_early_end_free(struct thud_early_end *early_end);
extern const struct thud_observer thud_observe_early_end;
/* After the last block: what comes after each block. */
void thud_early_end_close(struct thud_early_end *early_end);

/* Whether no contact can close before the end of the record in a run that is at this state; then what comes, which
 * reads amplitudes (nmodes), workspace. */
bool thud_early_end_holds(const struct thud_early_end *early_end, const struct thud_state *state, double *amplitudes,
                          struct thud_rest *rest);
/* Puts the state there; returns how many intervals that passes. Only where thud_early_end_holds. */
long thud_early_end_jump(const struct thud_early_end *early_end, struct thud_state *state);
