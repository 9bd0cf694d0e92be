/* Changes of a scene that are more than one value. Structures, floors and interfaces from 0 unless said. */
#pragma once

#include "tui/document/state.h"

/* Force at the bumper's delta_u, N; NaN where there is no such thing. */
double thud_scene_force_at_knee(const struct thud_scene *scene, int interface);
/* The value under the cursor, for every floor of its structure. */
void thud_tui_all_floors(struct thud_tui *tui);
void thud_tui_add_storey(struct thud_tui *tui, int s, int floor);    /* above `floor` (from 1; 0: on top) */
void thud_tui_delete_storey(struct thud_tui *tui, int s, int floor); /* from 1 */
void thud_tui_add_structure(struct thud_tui *tui, int s);            /* a copy of s, to its right */
void thud_tui_remove_structure(struct thud_tui *tui, int s);
void thud_tui_swap(struct thud_tui *tui, int s); /* s and its right neighbour */
void thud_tui_toggle_bumper(struct thud_tui *tui, int interface);
void thud_tui_add_link(struct thud_tui *tui, int interface);
void thud_tui_delete_link(struct thud_tui *tui, int link);
/* The stiffness with which F(delta_u) is what it was before the exponent changed. */
void thud_tui_keep_force(struct thud_tui *tui);
/* The keys that go from one pair of neighbours to the next; false where `action` is another. */
bool thud_tui_change_interface(struct thud_tui *tui, enum thud_action action);
const char *thud_tui_cannot_change_interface(struct thud_tui *tui, enum thud_action action);
