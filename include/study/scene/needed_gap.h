/* Required gap: the largest relative displacement of neighbouring floors without pounding, which is exact for a ground
 * motion. The rules of codes estimate it from the two peak displacements only. */
#pragma once

#include <math.h>

#include "core/run/baseline.h"
#include "ground/record.h"
#include "study/scene/gap_rule.h"
#include "study/scene/solution.h"

/* Computes the levels of a finished run without contact, (model->npairs); their heights are not known. */
double thud_gap_side(const struct thud_model *model, const struct thud_baseline_motion *baseline, int contact,
                     bool right); /* left_m, right_m */
/* `alone`: the same structures without links, whose damping ratios are their own; may be `model`. */
void thud_gap_levels(const bool *aligned, const struct thud_model *alone, const struct thud_model *model,
                     const struct thud_baseline_motion *baseline, struct thud_gap_level *level);

/* Required gap under one ground motion. */
struct thud_needed_gap {
    struct thud_collapse collapse; /* without contact: the required gap is that until then */
    int nlevels, ncolumns;
    double ductility; /* the largest of the storeys that can yield; 0: there is none */
    double *shear_n;  /* (ncolumns) the larger shear of each storey whose columns are struck, by drift alone */
    struct thud_gap_level level[]; /* (nlevels) */
};
/* Computes it for `scene` as written; bumpers and gaps have no effect. For a bumper, add its thickness minus its
 * cavity. Free with free(). Errors: those of thud_scene_assemble; THUD_DIVERGED. */
enum thud_status thud_needed_gap_run(const struct thud_scene *scene, const struct thud_record *record,
                                     struct thud_needed_gap **out, struct thud_error *err);
/* Computes the required gap of an interface (from 1) of a row while the others keep their gaps and bumpers. It is the
 * largest relative displacement in a run with this interface open, which no wider gap changes. NaN: a storey collapses
 * there; -1: nothing could touch. */
enum thud_status thud_needed_gap_in_row(const struct thud_scene *scene, int interface, const struct thud_record *record,
                                        double *need_m, struct thud_error *err);
/* Returns the index of a level (from 0) among those of its interface. */
int thud_needed_gap_level(const struct thud_gap_level *level, int i);
/* Returns whether a gap is wider than the widest so far; an unknown one (NaN) is kept. */
static inline bool thud_gap_is_wider(double gap_m, double widest_m)
{
    return !isnan(widest_m) && !(gap_m <= widest_m);
}
/* Returns the widest gap over the levels of an interface (0: of all); -1: no levels, NaN: the rule has no value at one.
 * *level gets it if not NULL. */
double thud_needed_gap_widest(const struct thud_needed_gap *gap, int interface, int rule, int *level);
/* Does the same over n levels. */
double thud_gap_widest(const struct thud_gap_level *of, int n, int interface, int rule, int *level);
/* Returns the gap that this interface (from 1) needs with its bumpers, whose projections may differ by level; -1: no
 * levels. */
double thud_needed_gap_with_bumpers(const struct thud_needed_gap *gap, const struct thud_scene *scene, int interface);

/* Returns the damping ratio of the first mode of a structure, of a model without links; 0: it has no modes. */
double thud_gap_damping(const struct thud_model *model, int structure);
/* Returns whether a rule requires too little, by more than rounding. */
bool thud_gap_falls_short(double asked_m, double needed_m);

/* Finds for each interface (from 0) whether all floor elevations of its two buildings are the same. */
void thud_gap_aligned(const struct thud_scene *scene, bool aligned[THUD_STRUCTURES_MAX]);
