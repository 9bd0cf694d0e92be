/* Significant digits of a peak. Pounding can amplify a small change, so the scene is run again with each of a few
 * inputs slightly decreased and increased. */
#pragma once

#include "study/scene/solution.h"

/* Stiffness changes apply to every second structure at a time: a common change would not alter one building relative to
 * its neighbour, and so would hardly affect pounding. */
enum thud_change {
    THUD_CHANGE_GAP,
    THUD_CHANGE_SCALE,
    THUD_CHANGE_STIFFNESS_ODD, /* of the first, third, ... structure from the left */
    THUD_CHANGE_STIFFNESS_EVEN,
    THUD_CHANGES
};
const char *thud_change_name(enum thud_change change); /* "gap", "scale", "stiffness_odd", "stiffness_even" */

/* Largest relative change of a peak, by what was changed; 0 where the peak is 0 in all runs. */
struct thud_spread {
    double by[THUD_CHANGES];
};
double thud_spread_most(const struct thud_spread *spread);
/* Returns the number of significant leading digits under this relative change, at most 15: the change is below one unit
 * of the last of them, for any number. */
int thud_spread_digits(double spread);

/* Changes the scene of a case: the gap of every interface, but not below the projection of a bumper, or the stiffness
 * of every storey and isolator of every second structure. The scale is that of the ground motion, which is not part of
 * a scene. */
void thud_change_scene(struct thud_scene *scene, enum thud_change change, double factor);

/* Runs a case's scene with one input times a factor, by its own method. The result is independent of the changed scene
 * and motion, except that its history must not be read. Errors: THUD_MEMORY, those of thud_scene_solve. */
enum thud_status thud_change_solve(const struct thud_scene *scene, const struct thud_record *record,
                                   enum thud_change change, double factor, struct thud_solution *solution,
                                   struct thud_error *err);

/* Returns the relative change of the scene's study, by default 0.1 %. */
double thud_scene_change(const struct thud_scene *scene);

/* Peaks of a floor and of a contact, in this order. */
enum { THUD_FLOOR_SPREADS = 4 };   /* acceleration, displacement, velocity, drift */
enum { THUD_CONTACT_SPREADS = 2 }; /* force, indentation */

struct thud_sensitivity {
    double change; /* the relative change of the inputs */
    int runs;      /* including the given run */
    int nfloors, ncontacts;
    struct thud_spread (*floor)[THUD_FLOOR_SPREADS];     /* (nfloors): structures one after the other */
    struct thud_spread (*contact)[THUD_CONTACT_SPREADS]; /* (ncontacts) */
};

/* Computes it. `result`: of `scene` (of a case), nominal. Errors: THUD_MEMORY, those of thud_scene_solve. */
enum thud_status thud_sensitivity_run(const struct thud_scene *scene, const struct thud_record *record, double change,
                                      const struct thud_result *result, struct thud_sensitivity **out,
                                      struct thud_error *err);
void thud_sensitivity_free(struct thud_sensitivity *sensitivity);
