/* Significant digits of a peak: pounding can amplify a small change, so the scene is run again with each of a few
 * inputs a little smaller and a little larger. */
#pragma once

#include "study/scene/solution.h"

/* Changes of stiffness are of every second structure at a time: a common change moves no building relative to its
 * neighbour, which is what makes them pound. */
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
/* Returns the number of significant leading digits under this relative change: the change is below one of the last of
 * them, whatever the number; at most 15. */
int thud_spread_digits(double spread);

/* Changes gaps or stiffnesses of a case's scene: every interface's gap, but never less than a bumper takes; the
 * stiffness of every storey and isolator of every second structure. The scale is the ground motion's, which no scene holds. */
void thud_change_scene(struct thud_scene *scene, enum thud_change change, double factor);

/* Runs a case's scene with one input times a factor, by its own method. The result needs neither the changed scene nor
 * the changed motion any more, but its history must not be asked for. Errors: THUD_MEMORY, those of thud_scene_solve. */
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
    int runs;      /* made for it, the given one included */
    int nfloors, ncontacts;
    struct thud_spread (*floor)[THUD_FLOOR_SPREADS];     /* (nfloors): structures one after the other */
    struct thud_spread (*contact)[THUD_CONTACT_SPREADS]; /* (ncontacts) */
};

/* Computes it. `result`: of `scene` (of a case), nominal. Errors: THUD_MEMORY, those of thud_scene_solve. */
enum thud_status thud_sensitivity_run(const struct thud_scene *scene, const struct thud_record *record, double change,
                                      const struct thud_result *result, struct thud_sensitivity **out,
                                      struct thud_error *err);
void thud_sensitivity_free(struct thud_sensitivity *sensitivity);
