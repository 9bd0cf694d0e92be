/* Sum of a scene's elements without its floor contacts: the response without pounding. */
#pragma once

#include "core/model/element.h"
#include "study/scene/scene.h"

struct thud_element_sum thud_structure_elements(const struct thud_structure *structure);
struct thud_element_sum thud_scene_elements(const struct thud_scene *scene);
/* Returns whether the response without pounding scales with the ground motion: factors of first contact follow from one
 * run. */
bool thud_scene_scales(const struct thud_scene *scene);
