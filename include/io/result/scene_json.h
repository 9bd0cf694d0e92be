/* Writes a scene with all its parameters as JSON that is also a preset: YAML reads it. */
#pragma once

#include "base/text.h"
#include "study/scene/scene.h"

/* Writes every key that has a value, including optional keys, as texts with their units in the order of presets. Lines
 * after the first are indented by `indent`. `file`: the ground motion as found; NULL: as the scene names it. */
void thud_scene_json(const struct thud_scene *scene, const char *file, int indent, struct thud_text *out);
/* Writes two members: "scene_si", numbers in SI under keys that end with their unit, and "scene", as above. */
void thud_scene_members_json(const struct thud_scene *scene, const char *file, struct thud_text *out);
