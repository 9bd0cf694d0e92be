#ifndef THUD_STUDY_BENCH_PRIVATE_H
#define THUD_STUDY_BENCH_PRIVATE_H

#include "study/methods/bench.h"

/* What is compared: peaks and impacts of one run. */
struct thud_bench_answer {
    double *acceleration, *drift, *force; /* (floors), (floors), (contacts) */
    struct thud_impact *impact;           /* (nimpacts) those of some weight */
    int floors, contacts, nimpacts;
    bool there;
};

/* Errors: THUD_MEMORY. */
enum thud_status thud_bench_answer_take(const struct thud_run *run, struct thud_bench_answer *out,
                                        struct thud_error *err);
void thud_bench_answer_clear(struct thud_bench_answer *answer);
struct thud_bench_errors thud_bench_compare(const struct thud_bench_answer *answer,
                                            const struct thud_bench_answer *reference);

#endif
