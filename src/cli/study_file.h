/* study.json and scene.json: what the files beside them were made of. */
#ifndef THUD_CLI_STUDY_FILE_H
#define THUD_CLI_STUDY_FILE_H

#include "app/run/session.h"
#include "base/text.h"
#include "cli/args.h"
#include "study/sweep/sweep.h"

/* Version, scene, options and ground motions: the scene as a preset and the options with it give the study again. */
void thud_study_file_json(const struct thud_args *args, const struct thud_session *session,
                          const struct thud_sweep_plan *plan, struct thud_text *out);

/* Makes the folder of -o before the work begins, and writes the scene into it as scene.json, for commands whose answers
 * are not one run's. Nothing without -o. Errors: THUD_OUTPUT, THUD_MEMORY. */
enum thud_status thud_scene_file_write(const struct thud_args *args, const struct thud_scene *scene,
                                       const struct thud_record *record, struct thud_error *err);

#endif
