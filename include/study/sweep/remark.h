/* Remarks on combinations of values: one list, each a row of remark_list.c with its place, condition, sentence and
 * weight. Command line, reports and terminal find the remarks on what they have. */
#pragma once

#include "core/model/result.h"
#include "ground/record.h"
#include "ground/target.h"
#include "study/scene/scene.h"
#include "study/sweep/sensitivity.h"
#include "study/sweep/sweep.h"

/* Returns theta = W d/(V h) of a storey (from 0) by a run's own peaks: weight of all above it, peak drift, peak shear,
 * height. EN 1998-1 4.4.2.2(2): second-order effects may be neglected up to 0.1, and 0.3 must not be exceeded. NaN: it
 * did not drift, or there is no such storey. */
double thud_stability_coefficient(const struct thud_structure *structure, const struct thud_structure_result *result,
                                  int storey);
/* Returns the peak drift ratio of a building's storeys (`elastic`: of those that do not yield), and that storey, from
 * 1; 0: none. */
double thud_drift_ratio(const struct thud_structure *structure, const struct thud_structure_result *result,
                        bool elastic, int *storey);
/* Writes which storey collapsed under P-Delta, when and at which drift; false: none. */
bool thud_collapse_remark(const struct thud_scene *scene, const struct thud_collapse *fall, struct thud_error *out);
/* Returns THUD_COLLAPSED with that message, else THUD_OK. */
enum thud_status thud_collapse_status(const struct thud_scene *scene, const struct thud_collapse *fall,
                                      struct thud_error *err);

/* Counts over the runs of a study, with the worst place of each: collapses, drifts beyond the elastic range of
 * buildings, and bumpers compressed beyond their ultimate strain or their thickness. Zeros at first. */
struct thud_sweep_worst {
    double value; /* drift over height; stability coefficient; compression over thickness */
    long point;
    enum thud_case which;
    int structure, storey; /* from 0, from 1; `structure` the interface of a bumper */
};
struct thud_sweep_watch {
    long runs, drifting, unstable, with_bumper, pressed, beyond, collapsed;
    long fall_point; /* the first that collapsed, and its case */
    enum thud_case fall_which;
    struct thud_sweep_worst drift, theta, press;
    double press_m, thickness_m; /* of the worst press */
};
/* Adds a point. Errors: THUD_MEMORY, THUD_INPUT. */
enum thud_status thud_sweep_watch_add(struct thud_sweep_watch *watch, const struct thud_sweep_plan *plan,
                                      const struct thud_sweep_point *point, struct thud_error *err);

/* ---- the list ---- */

/* Subject of a remark; a set of them selects the rows. */
enum thud_remark_about {
    THUD_REMARK_SCENE = 1,     /* values that are allowed but unusual */
    THUD_REMARK_EFFORT = 2,    /* a run that takes long */
    THUD_REMARK_MOTIONS = 4,   /* the ground motions, each and together */
    THUD_REMARK_CHANGE = 8,    /* changes of the scene, or varied keys, that have no effect */
    THUD_REMARK_RESULT = 16,   /* what the peaks of a run show */
    THUD_REMARK_STUDY = 32,    /* what the runs of a study show */
    THUD_REMARK_COMPUTED = 64, /* synthetic motions */
    THUD_REMARK_LEDGER = 128,  /* energy error of a run */
    THUD_REMARK_SIMPLER = 256  /* the command that finds what a scene can omit */
};
/* Remarks on the input of a study, and with its results: those at the end of its JSON. */
enum {
    THUD_REMARKS_OF_INPUT = THUD_REMARK_SCENE | THUD_REMARK_MOTIONS | THUD_REMARK_COMPUTED,
    THUD_REMARKS_OF_STUDY = THUD_REMARKS_OF_INPUT | THUD_REMARK_CHANGE | THUD_REMARK_STUDY
};
/* Weight of a remark; the heaviest come first where few are shown. */
enum thud_remark_weight {
    THUD_WEIGHT_FAILURE, /* later numbers are meaningless */
    THUD_WEIGHT_MOTION,  /* the ground motion is not suitable for design */
    THUD_WEIGHT_MODEL,   /* outside the range of the model */
    THUD_WEIGHT_DIGITS,  /* fewer digits are significant than are shown */
    THUD_WEIGHT_UNUSUAL, /* an unusual value */
    THUD_WEIGHTS
};
struct thud_remark {
    int row; /* of the list: of two cases the same remark has the same row and key */
    enum thud_remark_weight weight;
    /* Keys of the JSON beside it whose values the numbers of the sentence are, also a/b, a*b and a||b = ab/(a + b) of
     * two; values by level are those of their key. Empty: it has none, or the value at its place, or numbers without a
     * key (counts, estimates of the effort). */
    const char *keys;
    struct thud_error said; /* place (its key), sentence (what) and condition (what is allowed) */
};
struct thud_remarks {
    int n;
    struct thud_remark *item; /* (n) in the order of the rows */
    bool is_short;            /* there was no memory for one more */
};

/* Subjects of the search; NULL or 0: none, and its rows give no remarks. */
struct thud_remark_scope {
    const struct thud_scene *scene, *before; /* before: as it was written, ahead of its changes */
    const struct thud_result *result;
    const struct thud_impact *impact; /* (nimpacts) */
    int nimpacts, nrecords;
    const struct thud_record *const *record; /* (nrecords) */
    const double *factor;                    /* (nrecords) NULL: those that the records were read with */
    const struct thud_target *target;        /* design spectrum that the motions are scaled to; NULL: none */
    const struct thud_sensitivity *sensitivity;
    const struct thud_sweep_plan *plan;
    const struct thud_sweep_watch *watch;
};
/* Finds the remarks of a set of enum thud_remark_about, to be cleared; without memory for one, it is omitted. */
struct thud_remarks thud_remarks_find(const struct thud_remark_scope *scope, unsigned about);
void thud_remarks_clear(struct thud_remarks *remarks);
/* Returns the remark of the same row and key; NULL: none. */
const struct thud_remark *thud_remarks_like(const struct thud_remarks *remarks, const struct thud_remark *as);
