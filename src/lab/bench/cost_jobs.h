/* The cost of growing scenes, run and timed size by size. */
#pragma once

#include "lab/bench/bench_jobs.h"
#include "study/methods/cost.h"

/* Every size in turn; a run that diverges is marked and passed over. Errors: THUD_CANCELLED (what is done stays),
 * THUD_INPUT, THUD_MEMORY. */
enum thud_status thud_cost_jobs_run(struct thud_cost *cost, const struct thud_bench_jobs *jobs, struct thud_error *err);

/* What came of it, with the fitted slopes: for people, and as a figure (ask thud_figure_check). */
void thud_cost_table(struct thud_cost *cost, struct thud_text *out);
struct thud_figure *thud_cost_figure(struct thud_cost *cost, const char *title);
