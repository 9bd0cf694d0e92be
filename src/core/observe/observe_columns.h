/* Observer of a run: peaks of the shears and bending moments of columns that slabs strike, from the drift of their
 * storey and the forces on them at the same moment. */
#pragma once

#include "core/observe/observer.h"

extern const struct thud_observer thud_observe_columns; /* its own: the run's struct thud_result */
