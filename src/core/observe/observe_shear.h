/* Observer of a run: peaks of the storey shears of buildings by their matrix, V_i = sum_j s_ij q_j (core/model/model.h).
 * Those of other buildings follow from the peaks of their drifts. */
#pragma once

#include "core/observe/observer.h"

extern const struct thud_observer thud_observe_shear; /* its own: the run's struct thud_result */
