#pragma once

#include "study/methods/bench.h"

/* Errors: THUD_MEMORY. */
enum thud_status thud_bench_solution_take(const struct thud_run *run, struct thud_bench_solution *out,
                                          struct thud_error *err);
void thud_bench_solution_clear(struct thud_bench_solution *solution);
struct thud_bench_errors thud_bench_compare(const struct thud_bench_solution *solution,
                                            const struct thud_bench_solution *reference);
