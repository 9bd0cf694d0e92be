/* The required gap: the largest relative displacement of neighbouring floors without pounding, which is exact for
 * a ground motion, beside what the rules of the codes estimate from the two largest displacements alone. */
#pragma once

#include "base/statistics.h"
#include "core/run/baseline.h"
#include "ground/record.h"
#include "study/scene/gap_rule.h"
#include "study/scene/scene.h"

/* Levels of a finished run without contact, (model->npairs); their heights are not known. */
double thud_gap_side(const struct thud_model *model, const struct thud_baseline_motion *baseline, int contact,
                     bool right); /* left_m, right_m */
void thud_gap_levels(const bool *aligned, const struct thud_model *model, const struct thud_baseline_motion *baseline,
                     struct thud_gap_level *level);

/* One ground motion. */
struct thud_needed_gap {
    struct thud_collapse collapse; /* without contact: what is needed is that until then */
    int nlevels;
    struct thud_gap_level level[]; /* (nlevels) */
};
/* `scene` as written; its bumpers and gaps do not matter. A bumper needs its thickness less its cavity besides. Free
 * with free(). Errors: those of thud_scene_assemble; THUD_DIVERGED. */
enum thud_status thud_needed_gap_run(const struct thud_scene *scene, const struct thud_record *record,
                                     struct thud_needed_gap **out, struct thud_error *err);
/* The index of a level (from 0) among those of its interface. */
int thud_needed_gap_level(const struct thud_gap_level *level, int i);
/* The widest over the levels of an interface (0: of all); -1 where there are none, NaN where the rule has no value at
 * one. *level where not NULL. */
double thud_needed_gap_widest(const struct thud_needed_gap *gap, int interface, int rule, int *level);

/* Several ground motions on one scene. */
struct thud_gap_suite {
    int nrecords;
    const char *const *record;          /* (nrecords) names */
    struct thud_needed_gap *const *gap; /* (nrecords) with the same levels */
    int recordings;                     /* that these motions are of (thud_motions_recordings) */
};
/* Over the ground motions at a level (from 0; -1: the widest over all levels): 16, 50 and 84 % are the narrowest gaps
 * that are enough for at least so many of them, order statistics. `share`: of the ground motions for which
 * the rule asks for less than is needed there, of those for which it has a value. Errors: THUD_MEMORY. */
enum thud_status thud_gap_suite_fractiles(const struct thud_gap_suite *suite, int level, int rule,
                                          struct thud_fractiles *out, struct thud_error *err);

/* Damping ratio of a structure's first mode; 0: it has none. */
double thud_gap_damping(const struct thud_model *model, int structure);
/* Whether a rule asks for less than is needed, by more than rounding. */
bool thud_gap_falls_short(double asked_m, double needed_m);

/* Of each interface (from 0): whether the floor elevations of its two buildings are the same, all of them. */
void thud_gap_aligned(const struct thud_scene *scene, bool aligned[THUD_STRUCTURES_MAX]);
