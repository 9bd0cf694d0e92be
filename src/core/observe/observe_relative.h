/* Observer of a run without contact: largest relative displacement (left less right, m, at least 0) of the two sides of
 * each contact, and largest displacement of the struck place where it is no floor's. */
#pragma once

#include "core/observe/observer.h"

struct thud_relative {
    double *largest_m;  /* (2 x ncontacts) the values */
    unsigned char *due; /* (2 x ncontacts x intervals of a block) workspace */
};

extern const struct thud_observer thud_observe_relative; /* its own: a struct thud_relative */

/* All 0. Errors: THUD_MEMORY. */
enum thud_status thud_relative_init(struct thud_relative *relative, const struct thud_state *state,
                                    struct thud_error *err);
