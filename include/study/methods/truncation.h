/* Effect of omitted higher modes: runs the scene again with all of them. */
#pragma once

#include "study/scene/solution.h"

/* Largest relative difference from the run with all modes over floors and contacts, by kind of peak. A peak below
 * 1/1000 of the largest of its kind is relative to that value. INFINITY: a peak that does not exist with all modes. */
struct thud_truncation {
    int modes, left_out; /* kept of each building; left out in all */
    double acceleration, drift, force;
};

/* Computes it. `solution`: of the scene (of a case), whose model omits modes; at its end. Errors: those of
 * thud_scene_solve. */
enum thud_status thud_truncation_measure(const struct thud_scene *scene, const struct thud_record *record,
                                         const struct thud_solution *solution, struct thud_truncation *out,
                                         struct thud_error *err);
