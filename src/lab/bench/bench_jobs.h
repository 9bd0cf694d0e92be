/* A bench run and timed, point by point. */
#pragma once

#include <stdatomic.h>

#include "base/text.h"
#include "plot/figure/figure.h"
#include "study/methods/bench.h"

struct thud_bench_jobs {
    int repeats;                    /* timings of each point after one to warm up; fewer where one takes long */
    double patience_s;              /* a point expected to take longer is skipped and says so; 0: none is */
    double budget_s;                /* no point is begun that would end later; 0: all are */
    const struct thud_scene *scene; /* its peaks under 0.1 % of input too (thud_bench_move); NULL: not */
    const atomic_int *cancel;       /* not NULL: stops when it becomes other than 0 */
    void *context;
    void (*progress)(void *context, const char *what, int done, int count); /* may be NULL */
    double (*now_s)(void *context); /* a clock, s from any start; NULL: the machine's own */
};
/* Both front ends measure with these. */
enum { THUD_BENCH_REPEATS = 7 };
#define THUD_BENCH_PATIENCE_S 12.0
#define THUD_BENCH_BUDGET_S   50.0
enum { THUD_TIMINGS_MAX = 32 };

/* The bench in slices. Reference first, then every point, the first ones of all curves before the second ones; filled by thud_bench_work_init, and what is done stays when
 * it is stopped. */
struct thud_bench_work {
    struct thud_bench *bench; /* the caller's */
    struct thud_bench_jobs jobs;
    int reference;                          /* the one in the making; 2: both are there; 3: inputs were changed, too */
    int at;                                 /* the point in the making; -1: none */
    struct thud_run *run;                   /* in hand; NULL: none */
    bool judged;                            /* the point has its verdict, the run in hand is for its time */
    double elapsed_s, processor_s;          /* of the run in hand */
    double warm_s, spent_s;                 /* of the first run of the point; of the timed ones, about */
    double all_s;                           /* of all runs */
    int timed;                              /* runs whose time is known */
    double seconds[THUD_TIMINGS_MAX + 1];   /* (timed) by the wall clock */
    double processor[THUD_TIMINGS_MAX + 1]; /* (timed) */
};
void thud_bench_work_init(struct thud_bench_work *work, struct thud_bench *bench, const struct thud_bench_jobs *jobs);
/* A piece of so many segments or steps. Errors: as thud_bench_jobs_run. */
enum thud_status thud_bench_work_advance(struct thud_bench_work *work, long budget, bool *done, struct thud_error *err);
void thud_bench_work_stop(struct thud_bench_work *work);

/* Reference first, then every point. Errors: THUD_CANCELLED (what is done stays), THUD_MEMORY, THUD_DIVERGED (of the
 * reference). */
enum thud_status thud_bench_jobs_run(struct thud_bench *bench, const struct thud_bench_jobs *jobs,
                                     struct thud_error *err);

/* What came of it, for people. */
void thud_bench_table(struct thud_bench *bench, struct thud_text *out);
/* Time against error, and force evaluations against error (which no noise touches), log-log, a curve per method. Ask
 * thud_figure_check. */
struct thud_figure *thud_bench_figure(struct thud_bench *bench, const char *title);
