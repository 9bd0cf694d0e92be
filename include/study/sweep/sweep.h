/* Parametric studies: a scene, its records, a grid of varied keys and the cases. A study consists of points (one
 * record, one set of parameters), numbered from 0 in a fixed order. A point has a run for each case. Points are
 * independent, but points with the same structures and record form a group with one response without pounding, which
 * saves most of the work (see enum thud_sweep_shortcut). Work advances in slices, so a study can be cancelled, shown
 * and distributed to threads. Several threads may call these functions at the same time, if each task belongs to one
 * thread. */
#pragma once

#include <stdbool.h>

#include "base/text.h"
#include "ground/record.h"
#include "study/scene/needed_gap.h"
#include "study/sweep/sensitivity.h"
#include "study/sweep/sweep_row.h"

/* Shortcuts, none of which changes a result (model.md, section 7). They hold for the exact method; other methods make
 * every run. */
enum thud_sweep_shortcut {
    THUD_SWEEP_FREE =
        1, /* clearances at least as wide as the largest relative displacements take the contact-free result */
    THUD_SWEEP_START = 2,  /* a run begins at the earliest possible contact */
    THUD_SWEEP_LEVELS = 4, /* contacts that cannot close (between walls, of laws without force) are omitted */
    THUD_SWEEP_SAME = 8,   /* runs with equal contacts are made once */
    THUD_SWEEP_ALL = 15
};

enum { THUD_SWEEP_CASES_MAX = THUD_CASES_MAX };

/* Runs of a case at a point with a spread: nominal (variant 0), then each change less and more. */
enum { THUD_SWEEP_VARIANTS = 1 + 2 * THUD_CHANGES };

struct thud_sweep_plan {
    struct thud_scene scene;
    int nrecords;
    const struct thud_record *const
        *record; /* (nrecords) scaled according to the scene's record choice; NULL: no ground motion */
    int naxes;
    struct thud_sweep_axis
        axis[THUD_VARY_MAX]; /* keys that change the response without pounding come first; the last varies fastest */
    int nouter;              /* how many do */
    unsigned has;            /* THUD_HAS_... of the structures of some point: the scene's, or by a varied key */
    int ncases;
    enum thud_case cases[THUD_SWEEP_CASES_MAX];
    unsigned shortcuts;
    double sensitivity; /* relative change of gaps, motion and stiffnesses for the repeated runs; 0: none */
};

/* Makes a plan of the scene only: no axes, no records, case as written. */
void thud_sweep_plan_init(struct thud_sweep_plan *plan, const struct thud_scene *scene);
void thud_sweep_plan_clear(struct thud_sweep_plan *plan);
/* Adds an axis: `KEY=FROM:TO:STEP` or `KEY=V1,V2,...`; a unit at the end stands for all. Errors: THUD_USAGE, THUD_INPUT
 * with key, THUD_MEMORY. */
enum thud_status thud_sweep_vary(struct thud_sweep_plan *plan, const char *text, struct thud_error *err);
/* Sets the cases by name, `none,bumper`. Errors: THUD_USAGE. */
enum thud_status thud_sweep_cases(struct thud_sweep_plan *plan, const char *text, struct thud_error *err);
/* Sets axes and cases of the scene's own study; its sensitivity in any case. Errors: as thud_sweep_vary. */
enum thud_status thud_sweep_study(struct thud_sweep_plan *plan, bool axes, bool cases, struct thud_error *err);

long thud_sweep_points(const struct thud_sweep_plan *plan);
/* Return the number of points or groups; point p is in group p / thud_sweep_points_per_group. */
long thud_sweep_points_per_group(const struct thud_sweep_plan *plan);
/* Finds the index on each axis (naxes) of a point; returns its record. */
int thud_sweep_place(const struct thud_sweep_plan *plan, long point, int *at);
/* Writes "14 cm, 0.3 g", with `keys` "gap 14 cm, record.peak 0.3 g": indices on the first n axes, -1 for none ("-"),
 * except on axis `but` (-1: on all). Returns the text; "nominal" without axes. */
const char *thud_sweep_setting(const struct thud_sweep_plan *plan, int n, const int *at, int but, bool keys, char *text,
                               size_t size);
/* Returns whether a table shows at[]: on every axis except `but` one of at most five evenly spread values or the
 * preset's own. */
bool thud_sweep_is_spread(const struct thud_sweep_plan *plan, const int *at, int but);
/* Does the same for the i-th of n. */
bool thud_is_spread(int n, int i);
/* Makes the scene of a point, before its case. Errors: THUD_INPUT. */
enum thud_status thud_sweep_scene(const struct thud_sweep_plan *plan, long point, struct thud_scene *out,
                                  struct thud_error *err);

/* Computes the factor on a record of the plan that varied keys require at a point of this scene. Errors: THUD_INPUT. */
enum thud_status thud_sweep_motion_factor(const struct thud_sweep_plan *plan, const struct thud_scene *scene,
                                          const struct thud_record *record, double *out, struct thud_error *err);

/* Creates a group: the response without pounding of a set of points, and the required gap of each level. Plan and
 * records must outlive it. Errors: THUD_INPUT (a scene of its points is not possible), THUD_MEMORY. */
struct thud_sweep_group;
enum thud_status thud_sweep_group_create(const struct thud_sweep_plan *plan, long index, struct thud_sweep_group **out,
                                         struct thud_error *err);
/* Advances a group, which may be shared once done. Errors: THUD_DIVERGED, THUD_MEMORY. */
enum thud_status thud_sweep_group_advance(struct thud_sweep_group *group, long budget, bool *done,
                                          struct thud_error *err);
void thud_sweep_group_free(struct thud_sweep_group *group);
/* Returns the point that runs case k (k = ncases: `none` for the ratios) of a point; the point itself if no other run
 * is the same. The group is done. */
long thud_sweep_maker(const struct thud_sweep_group *group, long point, int k);
enum { THUD_SWEEP_SAME_BYTES = 8 << 20 }; /* memory limit of a group for this */

/* Outcome of a run. */
struct thud_sweep_effort {
    enum thud_status status;   /* THUD_OK; THUD_INPUT: not possible (a bumper wider than the gap); THUD_DIVERGED */
    bool made;                 /* false: result without a run */
    bool reused;               /* result of another run with the same contacts */
    bool reference;            /* not requested: case `none`, run for the ratios */
    double shared_s, end_s;    /* motion taken from the baseline, and the whole */
    struct thud_collapse fall; /* the peaks are those until then; of a point that was read, only `happened` */
    double link_n;             /* largest force of all links; NaN: none */
    int left_out;              /* omitted contacts */
    long steps, events;
};

struct thud_sweep_floor {
    double acceleration_mps2, drift_m, displacement_m;
    double ductility, permanent_m, excursions, hysteretic_j; /* NaN: the storey below is elastic */
    double stability; /* coefficient W d/(V h) of that storey; NaN: there is none, or it does not drift */
};

/* Cost of the changed runs of a point. */
struct thud_sweep_changed {
    int made, free, failed; /* runs; results without a run; no result */
    long steps, events;
};

/* Finished point: plain numbers, one allocation (free with free()). */
struct thud_sweep_point {
    long index;
    double gap_m;
    int nstructures, nfloors, ncontacts;
    int ncases;                                     /* those of the plan, then `none` if it was added */
    enum thud_case which[THUD_SWEEP_CASES_MAX + 1]; /* (ncases) */
    struct thud_sweep_effort effort[THUD_SWEEP_CASES_MAX + 1];
    bool awaited[THUD_SWEEP_CASES_MAX + 1]; /* result of another point, filled in before anything is read */
    int nvariants;                          /* 1, or THUD_SWEEP_VARIANTS */
    struct thud_sweep_changed changed;
    int floors[THUD_STRUCTURES_MAX], first_storey[THUD_STRUCTURES_MAX]; /* (nstructures) */
    struct thud_sweep_floor
        *floor; /* (nvariants x (ncases + 1) x nfloors): NaN where a case has no result; the last is no pounding */
    struct thud_sweep_contact *contact; /* (nvariants x ncases x ncontacts): force NaN where a case has no result */
    /* (nlinkages x ncontacts) with the scene's links, then without them if the scene has links */
    int nlinkages;
    struct thud_gap_level *level;
    struct thud_collapse fall[2]; /* (nlinkages) without pounding */
};
/* (ncontacts) those of a case, and the collapse without pounding. */
const struct thud_gap_level *thud_sweep_levels(const struct thud_sweep_point *point, enum thud_case which);
const struct thud_collapse *thud_sweep_fall(const struct thud_sweep_point *point, enum thud_case which);
/* Return the cases whose motion without pounding ratios of a plan are to, and required gaps of cases: as written where
 * every case has the links, or any; else `none`. */
enum thud_case thud_sweep_free_case(const struct thud_sweep_plan *plan);
enum thud_case thud_sweep_need_case(const enum thud_case *cases, int ncases);

/* Creates the task of a point. The group (done) and the plan must outlive it. Errors: THUD_INPUT (scene or case is not
 * possible), THUD_MEMORY. */
struct thud_sweep_task;
enum thud_status thud_sweep_task_create(const struct thud_sweep_plan *plan, const struct thud_sweep_group *group,
                                        long point, struct thud_sweep_task **out, struct thud_error *err);
/* Advances a task. A failed run has no result: `err` gives the reason, but THUD_OK is returned. Errors: THUD_MEMORY. */
enum thud_status thud_sweep_task_advance(struct thud_sweep_task *task, long budget, bool *done, struct thud_error *err);
/* Omits from a task not yet advanced the runs whose result is that of another run, which a point of `first`, `first +
 * step`, ... makes, for thud_sweep_group_settle. */
void thud_sweep_task_leave(struct thud_sweep_task *task, long first, long step);
/* Hands over the point of a task that is done. */
struct thud_sweep_point *thud_sweep_task_take(struct thud_sweep_task *task);
void thud_sweep_task_free(struct thud_sweep_task *task);
/* Runs a point with a group of its own. Errors: those of thud_sweep_group_advance and of the task. */
enum thud_status thud_sweep_point_make(const struct thud_sweep_plan *plan, long index, struct thud_sweep_point **out,
                                       struct thud_error *err);
/* Exchanges the shared results of a finished point: stores those that other points need, and fills in those that it
 * omitted. To be called for all points of the group in order, one at a time. Errors: THUD_MEMORY. */
enum thud_status thud_sweep_group_settle(struct thud_sweep_group *group, struct thud_sweep_point *point,
                                         struct thud_error *err);

/* Returns whether a point is the first of its group, whose required gaps hold for all of them. */
static inline bool thud_sweep_is_first(const struct thud_sweep_plan *plan, const struct thud_sweep_point *point)
{
    return point->index % thud_sweep_points_per_group(plan) == 0;
}
/* Returns the case of the i-th run of a point that was requested and has a result; ncases: there are no more. */
int thud_sweep_answered(const struct thud_sweep_point *point, int i);
int thud_sweep_contact_row_count(const struct thud_sweep_point *point);
void thud_sweep_contact_row_at(const struct thud_sweep_point *point, int i, struct thud_sweep_contact_row *row);

/* Write a point as one line of text without a newline, and read it; one with a spread is marked at its start. Reading
 * errors: THUD_INPUT, THUD_MEMORY. */
void thud_sweep_point_write(const struct thud_sweep_point *point, struct thud_text *out);
enum thud_status thud_sweep_point_read(const char *line, struct thud_sweep_point **out, struct thud_error *err);
/* Do the same for a line of n numbers with its place in a study; false: damaged. */
void thud_sweep_numbers_write(long index, const double *x, size_t n, struct thud_text *out);
bool thud_sweep_numbers_read(const char *line, long *index, double *x, size_t n);
/* Identifies a plan: equal for equal scenes, records, axes, cases and sensitivity. */
unsigned long long thud_sweep_fingerprint(const struct thud_sweep_plan *plan);

/* Sums over points: cost of a study, and savings. */
struct thud_sweep_total {
    long points, asked, made, reused, references, free, impossible, diverged, shared_runs, left_out, steps, events;
    double shared_s, end_s; /* of the runs made */
    struct {
        long made, free, failed;
    } changed; /* runs for the spread */
    /* The first run that is not possible, and the first that diverged: point and index of its case; -1: none */
    long impossible_point, diverged_point;
    int impossible_case, diverged_case;
};
void thud_sweep_total_init(struct thud_sweep_total *total);
void thud_sweep_total_add(struct thud_sweep_total *total, const struct thud_sweep_point *point);
