/* Observer of a run: peaks of the shears and bending moments of columns that slabs strike, from the drift of their
 * storey and the forces on them at the same moment. */
#ifndef THUD_CORE_OBSERVE_COLUMNS_H
#define THUD_CORE_OBSERVE_COLUMNS_H

#include "core/observe/observer.h"

extern const struct thud_observer thud_observe_columns; /* its own: the run's struct thud_result */

/* Whether the storey can drift by so much without raising a peak of untouched columns. */
bool thud_columns_below(const struct thud_model *model, const struct thud_result *result, int column, double drift_m);

#endif
