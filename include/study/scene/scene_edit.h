/* Edits of a scene that change more than one value, each by its words. */
#pragma once

#include "study/scene/scene.h"

/* Edits the scene: "storey add S FLOOR" (above that floor, like it; 0: on top), "storey delete S FLOOR", "structure add
 * S" (a copy to its right), "structure remove S", "swap S" (with its right neighbour), "bumper I" (in or out; alone:
 * 1), "link add I" (a dashpot between the topmost common floors), "link remove L", counted from 1. Links that tie
 * neighbours no more go with them. Writes what was done. Errors: THUD_USAGE; the scene is then as it was. */
enum thud_status thud_scene_edit(struct thud_scene *scene, const char *words, char *what, size_t size,
                                 struct thud_error *err);
