/* A bench run and timed, point by point. */
#ifndef THUD_APP_BENCH_JOBS_H
#define THUD_APP_BENCH_JOBS_H

#include <signal.h>

#include "base/text.h"
#include "plot/figure.h"
#include "study/bench.h"

struct thud_bench_jobs {
    int repeats;                         /* timings of each point after one to warm up; fewer where one takes long */
    double patience_s;                   /* a point expected to take longer is skipped and says so; 0: none is */
    const volatile sig_atomic_t *cancel; /* not NULL: stops when it becomes other than 0 */
    void *context;
    void (*progress)(void *context, const char *what, int done, int count); /* may be NULL */
};

/* Reference first, then every point. Errors: THUD_CANCELLED (what is done stays), THUD_MEMORY, THUD_DIVERGED (of the
 * reference). */
enum thud_status thud_bench_jobs_run(struct thud_bench *bench, const struct thud_bench_jobs *jobs,
                                     struct thud_error *err);

/* What came of it: for people, and as CSV. */
void thud_bench_table(struct thud_bench *bench, struct thud_text *out);
void thud_bench_csv(struct thud_bench *bench, struct thud_text *out);
/* Time against error, and force evaluations against error (which no noise touches), log-log, a curve per method. Ask
 * thud_figure_check. */
struct thud_figure *thud_bench_figure(struct thud_bench *bench, const char *title);

#endif
