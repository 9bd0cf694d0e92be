/* Speed against accuracy in slices: what the Bench screen shows while it fills. */
#ifndef THUD_TUI_BENCH_WORK_H
#define THUD_TUI_BENCH_WORK_H

#include "study/bench.h"
#include "tui/backend.h"

enum { THUD_BENCH_REPEATS = 3 };

struct thud_bench_work {
    bool running, complete;
    struct thud_scene scene;
    struct thud_record *record; /* its own copy */
    struct thud_bench *bench;
    int reference; /* the one in the making; 2: both are there */
    int at;        /* the point in the making */
    int done;      /* points that have an answer */
    struct thud_run *run;
    bool judged;               /* the point has its verdict, the run in hand is for its time */
    double elapsed_s, spent_s; /* of the run in hand; of all timed runs of the point */
    double seconds[THUD_BENCH_REPEATS];
    int timed;
};

/* Begins anew with a copy of the scene and of the record (NULL: none). Errors: as thud_bench_create. */
enum thud_status thud_bench_work_start(struct thud_bench_work *work, const struct thud_scene *scene,
                                       const struct thud_record *record, struct thud_error *err);
/* A short piece; only the time spent in runs is counted. Errors end it, what is done stays. */
enum thud_status thud_bench_work_advance(struct thud_bench_work *work, struct thud_backend *clock,
                                         struct thud_error *err);
void thud_bench_work_stop(struct thud_bench_work *work); /* keeps what is done */
void thud_bench_work_clear(struct thud_bench_work *work);

#endif
