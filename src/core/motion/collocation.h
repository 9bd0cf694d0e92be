/* Nonlinear and sticking contacts. The structures' motion under any force polynomial is known exactly, so only the contact
 * forces are unknown: each is a polynomial in time that satisfies its law at the Lobatto points of the step (or d' = 0
 * where the contact sticks), the first of which is the state itself. The force equation's own residual between the points
 * is the error measure. A step goes on to the next kink of the ground motion at most. */
#pragma once

#include <stdbool.h>

#include "base/status.h"

#include "core/contact/segment.h"

struct thud_collocation;

/* Errors: THUD_MEMORY. */
enum thud_status thud_collocation_create(const struct thud_state *state, struct thud_collocation **out,
                                         struct thud_error *err);

/* A step that is accurate to the run's tolerance; it may be longer than what is left of the interval of the ground motion,
 * whose line it then follows. Errors: THUD_DIVERGED (no step is small enough), THUD_MEMORY. */
enum thud_status thud_collocation_step(const struct thud_state *state, struct thud_segment *seg,
                                       struct thud_collocation *collocation, struct thud_error *err);
/* Whether nothing acts, and a contact is expected to begin in the next step, which need not end there. */
bool thud_collocation_awaits(const struct thud_state *state, const struct thud_collocation *collocation);
/* Told after the run committed so much of this segment, at whose end or quietly inside a contact has switched; `onset`: a
 * contact has just closed, so that the next step has to be short. */
void thud_collocation_committed(const struct thud_state *state, struct thud_collocation *collocation, double moved_s,
                                bool switched, bool onset, bool quiet);
