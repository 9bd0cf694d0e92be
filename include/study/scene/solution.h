/* Runs a scene with a record. */
#pragma once

#include "base/status.h"
#include "core/run/run.h"
#include "study/scene/scene.h"

/* Assembles the model of a scene as written (apply thud_scene_case first). Errors: THUD_INPUT, THUD_MEMORY. */
enum thud_status thud_scene_assemble(const struct thud_scene *scene, struct thud_model **out, struct thud_error *err);
/* Gives law, values and clearance of every contact of an interface: a bumper covers all of its levels. */
/* level: as thud_interface_level. */
void thud_interface_contact(const struct thud_interface *interface, int level, struct thud_contact_input *to);

/* Makes run options from scene->analysis. Errors: THUD_INPUT (unknown method). */
enum thud_status thud_scene_options(const struct thud_scene *scene, struct thud_run_options *out,
                                    struct thud_error *err);

/* Fills in the period of a spectral acceleration that is given without one: the mean of the fundamental periods of the
 * scene's buildings. Errors: those of thud_scene_assemble; THUD_INPUT (no building has a period). */
enum thud_status thud_record_choice_resolve(const struct thud_scene *scene, struct thud_record_choice *choice,
                                            struct thud_error *err);

/* Finished run together with its model (the run keeps pointing to the model and to the caller's record). */
struct thud_solution {
    struct thud_model *model;
    struct thud_run *run;
};
/* Assembles and creates the run. `options` NULL: from the scene. */
enum thud_status thud_scene_start(const struct thud_scene *scene, const struct thud_record *record,
                                  const struct thud_run_options *options, struct thud_solution *out,
                                  struct thud_error *err);
/* Does the same, and advances to the end. `options` NULL: from the scene. On THUD_DIVERGED the result up to then is
 * kept. */
enum thud_status thud_scene_solve(const struct thud_scene *scene, const struct thud_record *record,
                                  const struct thud_run_options *options, struct thud_solution *out,
                                  struct thud_error *err);
/* Does the same for a model that is no scene's. */
enum thud_status thud_model_solve(const struct thud_model_input *input, const struct thud_record *record,
                                  const struct thud_run_options *options, struct thud_solution *out,
                                  struct thud_error *err);
void thud_solution_clear(struct thud_solution *solution);
/* Checks that the contacts of a finished run made no energy to speak of. Errors: THUD_DIVERGED. */
enum thud_status thud_result_check(const struct thud_result *result, struct thud_error *err);

/* Checks that a valid scene moves: it needs a ground motion (NULL: none) that is not 0 throughout, or a body with a
 * velocity. Errors: THUD_INPUT with key. */
enum thud_status thud_scene_check_motion(const struct thud_scene *scene, const struct thud_record *record,
                                         struct thud_error *err);

/* Returns the link of the scene that bore the largest force in its result; NULL: no links. The soil behind
 * walls, which a result lists behind them, is no link. */
const struct thud_link_result *thud_link_hardest(const struct thud_scene *scene, const struct thud_result *result);
/* Returns whether a floor (from 0) was struck by an impulse, which has no finite acceleration: the result holds the
 * peak between the impulses. */
bool thud_floor_struck(const struct thud_result *result, int structure, int floor);
/* Returns the peak acceleration of a floor, m/s2; NaN: struck by an impulse. */
double thud_floor_acceleration(const struct thud_result *result, int structure, int floor);
/* Returns the peaks of a contact; NaN: impulses of a law without force. */
double thud_peak_force(const struct thud_contact_result *contact);
double thud_peak_depth(const struct thud_contact_result *contact);

/* Contacts of an interface together. */
struct thud_contact_sum {
    int impacts;
    double force_n; /* the largest; NaN: some are impulses, which have none */
    double impulse_ns;
};
struct thud_contact_sum thud_contacts_sum(const struct thud_result *result, int interface); /* from 1; 0: all */
/* Returns the contact with the largest force, of those that were closed; NULL: none was. */
const struct thud_contact_result *thud_contact_hardest(const struct thud_result *result, int interface);
