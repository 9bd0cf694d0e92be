/* The options that change the scene, for every command that has them. */
#ifndef THUD_CLI_SCENE_OPTIONS_H
#define THUD_CLI_SCENE_OPTIONS_H

#include "app/run/session.h"
#include "cli/args.h"

/* Opens the preset that is the command's only operand (where it may be left out: towers) and applies --record, --peak,
 * --dt, ..., --tolerance and then every --set. The session is closed on failure. Errors: THUD_USAGE, THUD_INPUT,
 * THUD_MEMORY. */
enum thud_status thud_scene_options_open(const struct thud_args *args, struct thud_session *session,
                                         struct thud_error *err);

/* Opens the preset as above, does the work and closes it again; `scene` is room for the scene that is worked on.
 * Errors: THUD_MEMORY, and those of both. */
typedef enum thud_status thud_scene_work(const struct thud_args *args, struct thud_session *session,
                                         struct thud_scene *scene, struct thud_error *err);
enum thud_status thud_scene_options_with(const struct thud_args *args, thud_scene_work *work, struct thud_error *err);

/* A message about a key of the scene whose value came from an option is about the option, by the name that was typed.
 * Gives `status`, or THUD_USAGE where the option's value is what is wrong. */
enum thud_status thud_scene_options_name(const struct thud_args *args, enum thud_status status, struct thud_error *err);

/* --sensitivity with its value, else with that of the scene's study or 0.1 %; 0: not asked for. */
double thud_scene_options_change(const struct thud_args *args, const struct thud_scene *scene);

/* The scene of --case, its name in the title; as written without it. Errors: THUD_USAGE, THUD_INPUT. */
enum thud_status thud_scene_options_of_case(const struct thud_args *args, const struct thud_session *session,
                                            struct thud_scene *scene, struct thud_error *err);

/* --case; THUD_CASE_AS_WRITTEN without it. Errors: THUD_USAGE. */
enum thud_status thud_scene_options_case(const struct thud_args *args, enum thud_case *out, struct thud_error *err);

#endif
