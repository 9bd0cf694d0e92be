/* Factor on a ground motion at which contact begins, by the response without pounding. */
#pragma once

#include "study/scene/needed_gap.h"

struct thud_first_contact {
    double first;       /* the smallest factor at which there is contact; INFINITY: none is found up to 1000 */
    double clear_again; /* a larger one at which there is none again; NaN: none is found up to twice the first, or 1 */
};
/* Finds it at the clearances of `scene` (of a case). `gap`: of the given motion, with the scene's links. If the
 * response without pounding scales (thud_scene_scales), the factor is the smallest clearance over relative
 * displacement. Otherwise both are found by runs without contact at increasing factors, to 1e-6. Contact need not be
 * monotonic in the factor; a window narrower than 3 % without a larger displacement before it may be missed. Errors:
 * those of thud_needed_gap_run. */
enum thud_status thud_first_contact_find(const struct thud_scene *scene, const struct thud_record *record,
                                         const struct thud_needed_gap *gap, struct thud_first_contact *out,
                                         struct thud_error *err);
