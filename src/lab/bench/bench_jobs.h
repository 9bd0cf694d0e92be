/* A bench run and timed, point by point. */
#pragma once

#include <stdatomic.h>

#include "base/text.h"
#include "plot/figure/figure.h"
#include "study/methods/bench.h"

struct thud_bench_jobs {
    double patience_s;              /* a point expected to take longer is skipped and says so; 0: none is */
    double budget_s;                /* no point is begun that would end later; 0: all are */
    const struct thud_scene *scene; /* of the bench: its peaks under 0.1 % of input too (thud_bench_move) */
    const atomic_int *cancel;       /* not NULL: stops when it becomes other than 0 */
    void *context;
    void (*progress)(void *context, const char *what, int done, int count); /* may be NULL */
};
enum { THUD_BENCH_REPEATS = 7 }; /* timings of each point after one to warm up; fewer where one takes long */
#define THUD_BENCH_PATIENCE_S 12.0
#define THUD_BENCH_BUDGET_S   50.0
/* Reference first, then every point. Errors: THUD_CANCELLED (what is done stays), THUD_MEMORY, THUD_DIVERGED (of the
 * reference). */
enum thud_status thud_bench_jobs_run(struct thud_bench *bench, const struct thud_bench_jobs *jobs,
                                     struct thud_error *err);

/* What came of it, for people. */
void thud_bench_table(struct thud_bench *bench, struct thud_text *out);
/* Time against error, and force evaluations against error (which no noise touches), log-log, a curve per method. Ask
 * thud_figure_check. */
struct thud_figure *thud_bench_figure(struct thud_bench *bench, const char *title);
