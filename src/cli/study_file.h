/* study.json, scene.json and made-by.txt: what the files beside them were made of. */
#ifndef THUD_CLI_STUDY_FILE_H
#define THUD_CLI_STUDY_FILE_H

#include "app/run/session.h"
#include "base/text.h"
#include "cli/args.h"
#include "io/file/made_by.h"
#include "study/sweep/sweep.h"

/* Version, scene, options and ground motions: the scene as a preset and the options with it give the study again. */
void thud_study_file_json(const struct thud_args *args, const struct thud_session *session,
                          const struct thud_sweep_plan *plan, struct thud_text *out);

/* What a command makes of a scene, for made-by.txt: of one group are commands whose files have the same names; what is
 * asked for beside the scene are the values of the options `asked` (ends with NULL) and the ground motions. */
enum thud_status thud_made_by_scene(const struct thud_args *args, const char *group, const struct thud_scene *scene,
                                    const struct thud_record *const *records, int nrecords, const char *const *asked,
                                    struct thud_made_by *out, struct thud_error *err);
/* Likewise a study. */
enum thud_status thud_made_by_study(const struct thud_args *args, const struct thud_sweep_plan *plan,
                                    struct thud_made_by *out, struct thud_error *err);

/* Makes the folder of -o before the work begins, and writes the scene into it as scene.json, for commands whose results
 * are not one run's. Nothing without -o. Errors: THUD_OUTPUT, THUD_MEMORY. */
enum thud_status thud_scene_file_write(const struct thud_args *args, const struct thud_scene *scene,
                                       const struct thud_record *record, struct thud_error *err);

#endif
