/* Gathers what a study's figures and tables show: points are taken one by one as they are done. */
#pragma once

#include "study/sweep/sweep_table.h"

struct thud_sweep_collector {
    struct thud_sweep_table table; /* points into the plan, the names and what is below */
    struct thud_sweep_summary **point;
    struct thud_sweep_need_row *need; /* (2 x table.nrecords) */
    const char *structure[THUD_STRUCTURES_MAX];
    enum thud_structure_kind kind[THUD_STRUCTURES_MAX];
};

/* `record` (plan->nrecords, at least 1) are names as shown; they and the plan must outlive the table. */
void thud_sweep_collector_init(struct thud_sweep_collector *collector, const struct thud_sweep_plan *plan,
                               const char *const *record);
/* Adds a point. Errors: THUD_MEMORY. */
enum thud_status thud_sweep_collector_add(struct thud_sweep_collector *collector, const struct thud_sweep_plan *plan,
                                          const struct thud_sweep_point *point, struct thud_error *err);
void thud_sweep_collector_clear(struct thud_sweep_collector *collector);
