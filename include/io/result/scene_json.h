/* A scene with all its parameters as JSON that is a preset, too: YAML reads it. */
#pragma once

#include "base/text.h"
#include "study/scene/scene.h"

/* Every key that has a value, also those that no preset need give, as texts with their units, in the order of presets;
 * the lines after the first are indented by `indent`. `file`: the ground motion as it was found; NULL: as the scene
 * names it. */
void thud_scene_json(const struct thud_scene *scene, const char *file, int indent, struct thud_text *out);
/* Two members: "scene_si", numbers in SI under keys that end with their unit, and "scene", as above. */
void thud_scene_members_json(const struct thud_scene *scene, const char *file, struct thud_text *out);
