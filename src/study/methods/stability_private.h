/* The small models that stability is judged on. */
#pragma once

#include "study/methods/stability.h"
#include "study/scene/two_body.h"

/* One floor on a spring of 1 Hz, thrown towards a wall on its right, which is not there without a law. */
extern const double thud_bouncer_omega_radps;
struct thud_two_body thud_bouncer(void);
/* A wall spring with sqrt(k/m) = omega. */
void thud_bouncer_spring(struct thud_two_body *bouncer, double omega_radps);

/* Kinetic, strain and contact energy over that at the start: the largest of the first and of the second half of the
 * time, looked at where each step ends, and at the end. */
struct thud_bouncer_energy {
    double half[2], end;
};

/* As thud_scene_solve. `energy` may be NULL; INFINITY where the run diverged. */
enum thud_status thud_bouncer_run(const struct thud_two_body *bouncer, const struct thud_record *record,
                                  struct thud_stepping how, double duration_s, struct thud_solution *out,
                                  struct thud_bouncer_energy *energy, struct thud_error *err);

/* THUD_DIVERGED is a finding, not a failure. */
bool thud_trial_failed(enum thud_status status);
struct thud_stepping thud_stepping_of(const char *method, double setting, bool locate);
/* Kinetic, strain and contact energy now over the kinetic one at the start. */
double thud_energy_ratio(const struct thud_solution *solution);
/* Restitution of a pair by a method; INFINITY where it blew up. Errors: THUD_MEMORY. */
enum thud_status thud_two_body_restitution(const struct thud_two_body *pair, struct thud_stepping how, double *out,
                                           struct thud_error *err);

/* The wall spring, the distances from it, and the approach velocity at which laws that know none are tried. */
extern const double thud_stability_wall_radps, thud_stability_start_m[THUD_STABILITY_STARTS], thud_stability_usual_mps;

/* The scene by a method, also where it diverges. `coarse`: the motion that the run holds on to, to be freed behind it.
 * Errors: THUD_MEMORY, those of thud_run_create. */
enum thud_status thud_stability_scene(const struct thud_stability *s, struct thud_stepping how, struct thud_run **out,
                                      struct thud_record **coarse, struct thud_error *err);
/* Runs what a summary needs of its own. Errors: THUD_MEMORY. */
enum thud_status thud_stability_summarise(const struct thud_stability *s, struct thud_stability_summary *summary,
                                          struct thud_error *err);
