/* Changes of a scene that are more than one value. */
#pragma once

#include "tui/document/state.h"

/* Force at the bumper's delta_u, N; NaN where there is no such thing. */
double thud_scene_force_at_knee(const struct thud_scene *scene, int interface);
/* The value under the cursor, for every floor of its structure. */
void thud_tui_all_floors(struct thud_tui *tui);
void thud_tui_edit_scene(struct thud_tui *tui, const char *fmt, ...) THUD_PRINTF(2, 3); /* study/scene/scene_edit.h */
/* The stiffness with which F(delta_u) is what it was before the exponent changed. */
void thud_tui_keep_force(struct thud_tui *tui);
/* The keys that go from one pair of neighbours to the next; false where `action` is another. */
bool thud_tui_change_interface(struct thud_tui *tui, enum thud_action action);
const char *thud_tui_cannot_change_interface(struct thud_tui *tui, enum thud_action action);
