/* A study in words and small tables, 80 columns wide. */
#pragma once

#include "app/sweep/sweep_study.h"

/* How far the mean and the worst floor's ratios go, per record, case and structure; needed gaps beside the codes'
 * rules. */
void thud_sweep_report(const struct thud_sweep_plan *plan, const struct thud_sweep_outcome *outcome,
                       struct thud_text *out);
/* How many runs were asked for, made and saved, and what has no result. */
void thud_sweep_report_work(const struct thud_sweep_plan *plan, const struct thud_sweep_total *total,
                            struct thud_text *out);
/* The best value of an axis. Errors: THUD_MEMORY. */
enum thud_status thud_sweep_report_best(const struct thud_sweep_plan *plan, const struct thud_sweep_table *table,
                                        int axis, bool csv, struct thud_text *out, struct thud_error *err);
