/* Evaluates the rules for the gap over a suite of ground motions, and the response of the buildings at the resulting
 * gaps. */
#pragma once

#include "base/statistics.h"
#include "study/scene/needed_gap.h"

/* Several ground motions on one scene. */
struct thud_gap_suite {
    int nrecords;
    const char *const *record;          /* (nrecords) names */
    struct thud_needed_gap *const *gap; /* (nrecords) with the same levels */
    int recordings;                     /* that these motions are of (thud_motions_recordings) */
};
/* Computes fractiles over the ground motions at a level (from 0; -1: the widest over the levels of `interface`, from 1;
 * 0: of all). 16, 50 and 84 % are order statistics: the smallest gaps sufficient for this fraction of the motions.
 * `share`: of the motions with a value of the rule, those for which it requires too little. Errors: THUD_MEMORY. */
enum thud_status thud_gap_suite_fractiles(const struct thud_gap_suite *suite, int interface, int level, int rule,
                                          struct thud_fractiles *out, struct thud_error *err);

/* Result of a rule over a suite at an interface, and the response of the buildings at that gap. */
struct thud_gap_ruled {
    struct thud_gap_level level; /* that asks for most, with the design displacements */
    double gap_m;                /* NaN: the rule has no value; -1: nothing could touch there */
    int pounding;                /* ground motions in which there is contact at that gap, without the bumper */
    double force_n;              /* the largest of any of them */
    int worst;                   /* the ground motion of it; -1 */
};
/* Evaluates a rule at every interface (from 0, nstructures - 1 of them). It uses the means of the displacements over
 * the ground motions, or the largest ones if fewer motions are independent than its code requires. The required gap is
 * the largest of all. Nothing pounds yet. */
bool thud_gap_suite_means(const struct thud_gap_suite *suite, int rule); /* else the largest */
void thud_gap_suite_rule(const struct thud_gap_suite *suite, int rule, int interfaces, struct thud_gap_ruled *out);
/* Adds a ground motion to the response at the gaps of a rule, set at all interfaces together; an interface without a
 * value keeps its own gap. This takes a run without bumpers, or none if there is no contact. Errors: those of
 * thud_scene_solve. */
enum thud_status thud_gap_pound(const struct thud_scene *scene, const struct thud_record *record,
                                const struct thud_gap_suite *suite, int motion, struct thud_gap_ruled *ruled,
                                struct thud_error *err);

/* ---- over the periods of estimated buildings ---- */

/* Range of the required gap of an interface (from 1) for periods of its estimated buildings from THUD_ESTIMATE_LEAST to
 * THUD_ESTIMATE_MOST times, in equal logarithmic steps. The periods of two neighbours vary independently. */
struct thud_gap_range {
    int interface;
    double least_m, most_m;
    double left_factor, right_factor; /* of the periods where it is most_m; NaN: not estimated */
};
/* Returns the number of such periods; 0: no building is estimated. */
int thud_gap_periods(const struct thud_scene *scene);
/* Computes the gap sufficient at one of them (from 0) for a ground motion, if more than need_m (nstructures - 1), which
 * is -1 at first and where nothing could touch. Errors: those of thud_needed_gap_run. */
enum thud_status thud_gap_at_periods(const struct thud_scene *scene, const struct thud_record *record, int period,
                                     double *need_m, struct thud_error *err);
/* Makes the ranges of the interfaces beside an estimated building that can touch from need_m (periods x interfaces);
 * returns their number. */
int thud_gap_period_range(const struct thud_scene *scene, const double *need_m, struct thud_gap_range *out);
