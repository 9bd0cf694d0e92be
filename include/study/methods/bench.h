/* Compares speed and accuracy: every method over its steps or tolerances on one scene, against an independent
 * reference. The study plans and judges the runs; the owner of a clock runs and times them. */
#pragma once

#include "study/methods/time_stepping.h"
#include "study/scene/solution.h"

enum thud_bench_state { THUD_BENCH_WAITING, THUD_BENCH_DONE, THUD_BENCH_FAILED, THUD_BENCH_SKIPPED };

/* Largest relative error over floors and contacts, by kind of peak; of impact times in seconds. */
struct thud_bench_errors {
    double all; /* of acceleration, drift and force */
    double acceleration, drift, force;
    double impact_time_s;
    int missed, extra; /* significant impacts that the run misses, and additional ones */
};

struct thud_bench_point {
    struct thud_stepping how;
    int curve; /* points of one curve have the same number and are contiguous */
    enum thud_bench_state state;
    struct thud_bench_errors error;
    struct thud_work work;
    double seconds, spread; /* median and half the interquartile range of the timings; filled by the caller */
    double processor_s;     /* median of processor time, unaffected by other programs; 0: not measured */
    int repeats;
    char message[192]; /* why it failed or was skipped */
};

/* What is compared: peaks and impacts of one run. */
struct thud_bench_solution {
    double *acceleration, *drift, *force; /* (floors), (floors), (contacts) */
    struct thud_impact *impact;           /* (nimpacts) those of some weight */
    int floors, contacts, nimpacts;
    bool there;
};

/* References: the program's own tightest, and an independent one. */
enum { THUD_BENCH_REFERENCES = 2 };
extern const char *const thud_bench_reference_name[THUD_BENCH_REFERENCES];

struct thud_bench {
    const struct thud_record *record;
    struct thud_model *model;
    struct thud_run_options options; /* common to all */
    struct thud_bench_point *point;  /* (npoints) */
    int npoints;
    struct thud_bench_solution reference[THUD_BENCH_REFERENCES];
    double reference_error; /* relative difference of the two, which bounds the trust in them; NaN: one has no result */
    double moved;           /* thud_bench_move; NaN before */
};

/* Creates a bench. `scene` (of a case), record and the bench's points stay the caller's. Errors: THUD_MEMORY, those of
 * thud_scene_assemble. */
enum thud_status thud_bench_create(const struct thud_scene *scene, const struct thud_record *record,
                                   struct thud_bench **out, struct thud_error *err);
void thud_bench_free(struct thud_bench *bench);

/* Keeps only the curves of these methods. */
void thud_bench_only(struct thud_bench *bench, const struct thud_method *const *method, int methods);

/* Returns the next point to run, the first pending one of its curve; -1: none. */
int thud_bench_next(const struct thud_bench *bench);
/* Returns the number of points that are done. */
int thud_bench_ended(const struct thud_bench *bench);

/* Cost of an accuracy by a curve: its fastest run within that error of the peaks that has every impact. `ratio`: its
 * time over that of the fastest curve. */
struct thud_bench_cost {
    double level;
    int point;
    double ratio;
};
enum { THUD_BENCH_LEVELS = 2, THUD_BENCH_CURVES_MAX = 64 };
extern const double thud_bench_level[THUD_BENCH_LEVELS]; /* 1 % and 0.1 % */
/* Lists by rising time a row for each curve that keeps the level; returns their number. */
int thud_bench_costs(const struct thud_bench *bench, double level, struct thud_bench_cost cost[THUD_BENCH_CURVES_MAX]);

/* Runs the scene with each of a few inputs 0.1 % less and more (thud_change_solve). The largest change of the peaks is
 * the smallest meaningful error of the scene. Errors: those of thud_scene_solve. */
enum thud_status thud_bench_move(struct thud_bench *bench, const struct thud_scene *scene, struct thud_error *err);

/* Creates runs of the references. The caller advances each and hands it back (freed in any case). Errors: those of
 * thud_run_create; THUD_MEMORY. */
enum thud_status thud_bench_reference_start(struct thud_bench *bench, int which, struct thud_run **out,
                                            struct thud_error *err);
enum thud_status thud_bench_reference_finish(struct thud_bench *bench, int which, struct thud_run *run,
                                             struct thud_error *err);

/* Create the run of a point, and compare it with the reference after its end (status THUD_OK) or failure. A run by the
 * method of the reference is compared with the independent reference. The run stays the caller's. Errors: those of
 * thud_run_create; THUD_MEMORY. */
enum thud_status thud_bench_start(struct thud_bench *bench, int i, struct thud_run **out, struct thud_error *err);
enum thud_status thud_bench_judge(struct thud_bench *bench, int i, const struct thud_run *run, enum thud_status status,
                                  const struct thud_error *failure, struct thud_error *err);
