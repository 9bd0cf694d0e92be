/* The verbs that the command line and the terminal interface share: open a preset, change values, read its ground
 * motion, run a case. */
#pragma once

#include "ground/record.h"
#include "io/file/paths.h"
#include "io/preset/preset.h"
#include "io/result/result_file.h"
#include "study/scene/solution.h"

struct thud_session {
    struct thud_paths paths;
    char preset_path[512];
    struct thud_preset *preset;            /* as read */
    struct thud_scene scene;               /* with the changes made since */
    struct thud_record *record;            /* of scene.record; NULL: none, or not read yet */
    struct thud_record_choice record_read; /* what `record` was read with, the periods filled in */
    struct thud_record *given;             /* stands for the file of its name, which is not looked for; NULL: none */
};

/* Opens a preset by name or path. Errors: THUD_INPUT with place, THUD_MEMORY. */
enum thud_status thud_session_open(struct thud_session *session, const char *preset, struct thud_error *err);
/* The same for who asks for no bumper: see thud_preset_read_unfinished. */
enum thud_status thud_session_open_unfinished(struct thud_session *session, const char *preset, struct thud_error *err);
/* The text of a preset; `name` stands for its path. Errors: as thud_session_open. */
enum thud_status thud_session_parse(struct thud_session *session, const char *text, size_t size, const char *name,
                                    struct thud_error *err);
void thud_session_close(struct thud_session *session);

/* Errors: THUD_INPUT with key and what is allowed. */
enum thud_status thud_session_set(struct thud_session *session, const char *key, const char *text,
                                  struct thud_error *err);
/* KEY=VALUE. Errors: THUD_USAGE without a `=`, THUD_INPUT with key and what is allowed. */
enum thud_status thud_session_assign(struct thud_session *session, const char *assignment, struct thud_error *err);
/* The same for several that are taken together: in whatever order they stand, but for one key given twice, they mean
 * the same. */
enum thud_status thud_session_assign_all(struct thud_session *session, const char *const *assignment, int n,
                                         struct thud_error *err);

/* Another ground motion: what the preset says of its own (peak, factor, step, unit, ...) does not hold for it. */
void thud_session_choose_record(struct thud_session *session, const char *file);

/* The motion of a choice from the file at `path`. What the choice leaves to the scene is filled in: the period of sa,
 * rotd50 and rotd100, the periods of a target, the governing direction. Errors: THUD_INPUT, THUD_MEMORY. */
enum thud_status thud_motion_read(const struct thud_scene *scene, const char *path, struct thud_record_choice *choice,
                                  struct thud_record **out, struct thud_error *err);
/* Gives the error of a motion that has not this direction the key record.component and, if the preset has that value,
 * its place there. */
void thud_session_place_component(const struct thud_session *session, const char *component, enum thud_status status,
                                  struct thud_error *err);
/* Looks whether the recording at `path` has the direction that is chosen, where one is. Errors: THUD_INPUT with the key
 * record.component; another reason for which it cannot be read is none. */
enum thud_status thud_motion_look(const struct thud_scene *scene, const char *path,
                                  const struct thud_record_choice *choice, struct thud_error *err);

/* Reads the scene's ground motion where it is not the one in hand. Errors: THUD_INPUT, THUD_MEMORY. */
enum thud_status thud_session_read_record(struct thud_session *session, struct thud_error *err);

/* A case of the session's scene, ready to run: *scene gets it, and the session reads its ground motion. Errors: as
 * thud_scene_case, thud_scene_check and thud_session_read_record. */
enum thud_status thud_session_case(struct thud_session *session, enum thud_case which, struct thud_scene *scene,
                                   struct thud_error *err);
/* Runs a case of the session's scene. `options` NULL: from the scene. *scene gets the case's scene. On
 * THUD_DIVERGED the result is kept for what came before. Errors: as thud_scene_case and thud_scene_solve. */
enum thud_status thud_session_run(struct thud_session *session, enum thud_case which,
                                  const struct thud_run_options *options, struct thud_scene *scene,
                                  struct thud_solution *solution, struct thud_error *err);

/* What the result is shown with; `scene` must stay. */
struct thud_report thud_session_report(const struct thud_session *session, const struct thud_scene *scene,
                                       enum thud_case which, const struct thud_solution *solution);
