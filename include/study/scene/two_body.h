/* Single collision of two free rigid bodies, or of a body and a wall: the test of every impact law, without a scene. */
#pragma once

#include "base/status.h"
#include "core/laws/law.h"
#include "study/scene/solution.h"

/* Setup: the left body approaches at `approach_mps` the right one, which is at rest; without a clearance contact begins
 * at t = 0. */
struct thud_two_body {
    double mass_kg[2];
    double approach_mps, clearance_m;
    bool wall;           /* in place of the right body; without a law there is none */
    double spring_radps; /* sqrt(k/m) of a spring that holds the left body to the ground; 0: it is free */
    double duration_s;
    bool until_parted; /* ends once they are far enough apart that nothing changes any more */
    const struct thud_law *law;
    struct thud_law_setup setup;      /* value[] and thickness_m */
    const struct thud_method *method; /* NULL: auto, to 1e-9 */
    double method_step_s;             /* of a fixed-step method */
    bool locate;
};

/* Sets Table 1 of Polycarpou and Komodromos (2011): two bodies of 320 t approaching at 0.5 m/s. Contact is concrete on
 * concrete (k 2500 kN/mm, restitution 0.6), or the 5 cm rubber bumper (k 0.36 kN/mm^2.65, exponent 2.65, restitution
 * 0.5, 2500 kN/mm beyond 0.8 of the thickness). All other parameters are the laws' defaults. */
void thud_two_body_concrete(struct thud_two_body *pair);
void thud_two_body_rubber(struct thud_two_body *pair);

/* Sets a law with its defaults, and a parameter of it by name, SI. */
void thud_two_body_law(struct thud_two_body *pair, const struct thud_law *law);
void thud_two_body_set(struct thud_two_body *pair, const char *param, double value);

/* Makes the model. Errors: those of thud_model_create. */
enum thud_status thud_two_body_assemble(const struct thud_two_body *pair, struct thud_model **model,
                                        struct thud_error *err);
/* Makes a finished run with impacts and histories every `step_s` outside the contact. thud_solution_clear frees it.
 * Errors: as thud_run_create and thud_run_advance. */
enum thud_status thud_two_body_run(const struct thud_two_body *pair, double step_s, struct thud_solution *out,
                                   struct thud_error *err);

/* Returns the separation velocity at the end of a pair's run. */
double thud_two_body_separation(const struct thud_solution *solution);
