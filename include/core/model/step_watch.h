/* Observer of a run at its steps. */
#pragma once

#include "base/status.h" /* struct thud_moment is of thud.h */

/* Called at the end of every step; a result other than 0 ends the run (THUD_CANCELLED). */
struct thud_step_watch {
    int (*step)(void *context, const struct thud_moment *moment);
    void *context;
};
