/* Two free rigid bodies that meet once: the test of every impact law, without a scene or a ground motion. */
#ifndef THUD_STUDY_PAIR_H
#define THUD_STUDY_PAIR_H

#include "base/status.h"
#include "core/laws/law.h"
#include "study/scene/answer.h"

/* The left body closes with `closing_mps` on the right one, which is at rest; they touch at t = 0. */
struct thud_pair {
    double mass_kg[2];
    double closing_mps;
    double duration_s;
    const struct thud_law *law;
    struct thud_law_setup setup;      /* value[] and thickness_m */
    const struct thud_method *method; /* NULL: auto, to 1e-9 */
    double method_step_s;             /* of a fixed-step method */
    bool locate;
};

/* Table 1 of Polycarpou and Komodromos (2011): two bodies of 320 t closing at 0.5 m/s, concrete on concrete (k 2500
 * kN/mm, restitution 0.6), or with the 5 cm rubber bumper (k 0.36 kN/mm^2.65, exponent 2.65, restitution 0.5, 2500
 * kN/mm past 0.8 of the thickness). All other parameters as the laws' own defaults. */
void thud_pair_concrete(struct thud_pair *pair);
void thud_pair_rubber(struct thud_pair *pair);

/* Sets a parameter of the law by name, SI. */
void thud_pair_set(struct thud_pair *pair, const char *param, double value);

/* A finished run with impacts and histories every `step_s` outside the contact. thud_answer_clear frees it. Errors as
 * thud_run_create and thud_run_advance. */
enum thud_status thud_pair_run(const struct thud_pair *pair, double step_s, struct thud_answer *out,
                               struct thud_error *err);

/* Speed at which the bodies part at the end of a pair's run. */
double thud_pair_separation(const struct thud_answer *answer);

#endif
