/* Power series of linear motion over a whole interval of the ground motion, where contacts push by linear branches or
 * storeys yield and damping couples the modes: by superposition of unit motions, tables made once for each set of branches
 * that comes often. An isolator that slides has one set in both directions. */
#pragma once

#include "core/contact/segment.h"

struct thud_interval_series;

/* *out stays NULL for a model that it is not for. Errors: THUD_MEMORY. */
enum thud_status thud_interval_series_create(const struct thud_model *model, struct thud_interval_series **out,
                                             struct thud_error *err);
void thud_interval_series_free(struct thud_interval_series *series);

/* What thud_taylor_linear gives for the segment, which has been begun; false where it is for that function to make. */
bool thud_interval_series_make(struct thud_interval_series *series, const struct thud_state *state,
                               struct thud_segment *seg);
