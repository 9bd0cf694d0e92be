/* A scene as a script for OpenSeesPy, where its laws exist there: springs between floors, modal damping, a zero-length
 * element for each contact, Newmark's average acceleration. The script holds everything it needs, runs on its own and
 * compares its peaks with those of the run given. */
#pragma once

#include "base/text.h"
#include "core/model/model.h"
#include "core/model/result.h"
#include "ground/record.h"
#include "study/scene/scene.h"

/* Whether OpenSees has what the scene is made of. Errors: THUD_INPUT with the key of what it has not, and why. */
enum thud_status thud_opensees_check(const struct thud_scene *scene, const struct thud_model *model,
                                     struct thud_error *err);

/* The script of a scene that passed the check. `record` NULL: no ground motion; `result`: of the exact method. */
void thud_opensees_script(const struct thud_scene *scene, const struct thud_model *model,
                          const struct thud_record *record, const struct thud_result *result, struct thud_text *out);
