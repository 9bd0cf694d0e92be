/* Observer of a run: peaks of sums over the floors (core/model/model.h). Storey shears of buildings by their matrix,
 * V_i = sum_j s_ij q_j; those of other buildings follow from the peaks of their drifts. Overturning moments of buildings
 * whose width is given. */
#pragma once

#include "core/observe/observer.h"

extern const struct thud_observer thud_observe_shear; /* its own: the run's struct thud_result */
