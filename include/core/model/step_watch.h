/* Who looks at a run step by step. */
#pragma once

#include "base/status.h" /* struct thud_moment is of thud.h */

/* At the end of every step; other than 0 ends the run (THUD_CANCELLED). */
struct thud_step_watch {
    int (*step)(void *context, const struct thud_moment *moment);
    void *context;
};
