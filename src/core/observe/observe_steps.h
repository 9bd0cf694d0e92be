/* Observer that shows the end of every step to a function of the caller's, which may end the run. */
#pragma once

#include "core/observe/observer.h"

struct thud_steps {
    const struct thud_step_watch *watch;
    struct thud_moment moment; /* its arrays lie in `room` */
    double *room;
};

extern const struct thud_observer thud_observe_steps; /* its own: a struct thud_steps */

/* Errors: THUD_MEMORY. */
enum thud_status thud_steps_init(struct thud_steps *steps, const struct thud_state *state,
                                 const struct thud_step_watch *watch, struct thud_error *err);
