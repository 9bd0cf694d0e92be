#pragma once

#include "app/sweep/sweep_study.h"

enum thud_status thud_sweep_outcome_init(const struct thud_sweep_plan *plan, struct thud_sweep_outcome *out,
                                         struct thud_error *err);
/* A point into totals, table and the study's own `emit`. */
enum thud_status thud_sweep_study_deliver(const struct thud_sweep_study *study, const struct thud_sweep_point *point,
                                          struct thud_sweep_outcome *out, struct thud_error *err);
/* Reads the points back from the journals (point i from journal i % n) and writes the study's files. */
enum thud_status thud_sweep_study_finish(const struct thud_sweep_study *study, struct thud_sweep_journal **journal,
                                         int n, struct thud_sweep_outcome *out, struct thud_error *err);
