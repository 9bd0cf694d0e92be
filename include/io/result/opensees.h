/* Writes a scene as a script for OpenSeesPy, if OpenSees has its laws. It has springs between floors, modal damping, a
 * zero-length element for each contact, and Newmark's average acceleration. The script is self-contained and compares
 * its peaks with those of the given run. */
#pragma once

#include "base/text.h"
#include "core/model/model.h"
#include "core/model/result.h"
#include "ground/record.h"
#include "study/scene/scene.h"

/* Checks that OpenSees has every part of the scene. Errors: THUD_INPUT with the key of an unsupported part, and why. */
enum thud_status thud_opensees_check(const struct thud_scene *scene, const struct thud_model *model,
                                     struct thud_error *err);

/* Returns whether OpenSees has a material of this law. */
bool thud_opensees_has_law(const struct thud_law *law);
/* Makes the nearest scene whose contacts OpenSees has, by a run of the full one; `what` gets a line for each that is
 * replaced. Soil and struck columns stay: the script has them in another form. Errors: those of thud_scene_set. */
enum thud_status thud_opensees_nearest(const struct thud_scene *scene, const struct thud_model *model,
                                       const struct thud_result *result, struct thud_scene *out, struct thud_text *what,
                                       struct thud_error *err);
/* Writes the largest force, impacts and each building's largest acceleration in both runs, line by line. */
void thud_opensees_compare(const struct thud_scene *scene, const struct thud_result *full,
                           const struct thud_result *replaced, struct thud_text *what);

/* Ways in which the script ends other than with 0. DIFFERS: by more than 1 % in an acceleration. */
enum { THUD_OPENSEES_DIFFERS = 3, THUD_OPENSEES_DIVERGED, THUD_OPENSEES_MISSING };
/* Writes the script of a scene that passed the check, or of the nearest one. `record` NULL: no ground motion; `result`:
 * of the exact method. */
void thud_opensees_script(const struct thud_scene *scene, const struct thud_model *model,
                          const struct thud_record *record, const struct thud_result *result, struct thud_text *out);
