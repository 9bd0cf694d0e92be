/* Writes a scene as a script for OpenSeesPy, if OpenSees has its laws: springs between floors, modal damping, a
 * zero-length element for each contact, Newmark's average acceleration. The script is self-contained and compares its
 * peaks with those of the given run. */
#pragma once

#include "base/text.h"
#include "core/model/model.h"
#include "core/model/result.h"
#include "ground/record.h"
#include "study/scene/scene.h"

/* Checks that OpenSees has every part of the scene. Errors: THUD_INPUT with the key of an unsupported part, and why. */
enum thud_status thud_opensees_check(const struct thud_scene *scene, const struct thud_model *model,
                                     struct thud_error *err);

/* Makes the nearest scene whose contacts OpenSees has, by a run of the full one; `what` lists each replacement.
 * Contacts of other laws, soil and struck columns stay, and thud_opensees_check refuses them. Errors: those of
 * thud_scene_set. */
enum thud_status thud_opensees_nearest(const struct thud_scene *scene, const struct thud_model *model,
                                       const struct thud_result *result, struct thud_scene *out, struct thud_text *what,
                                       struct thud_error *err);
/* Writes the largest force, impacts and each building's largest acceleration in both runs, line by line. */
void thud_opensees_compare(const struct thud_scene *scene, const struct thud_result *full,
                           const struct thud_result *replaced, struct thud_text *what);

/* Writes the script of a checked scene. `record` NULL: no ground motion; `result`: of the exact method. */
void thud_opensees_script(const struct thud_scene *scene, const struct thud_model *model,
                          const struct thud_record *record, const struct thud_result *result, struct thud_text *out);
