/* A whole study in memory, for figures: points are taken one by one as they are done. */
#ifndef THUD_APP_SWEEP_TABLE_H
#define THUD_APP_SWEEP_TABLE_H

#include "study/sweep.h"

struct thud_sweep_collector {
    struct thud_sweep_table table; /* points into the plan, the names and the rows below */
    struct thud_sweep_row *row;
    struct thud_sweep_contact_row *contact;
    struct thud_sweep_need_row *need;
    size_t rows_room, contacts_room, needs_room;
    const char *structure[THUD_STRUCTURES_MAX];
};

/* `record` (plan->nrecords, at least 1) are names as shown; they and the plan must outlive the table. */
void thud_sweep_collector_init(struct thud_sweep_collector *collector, const struct thud_sweep_plan *plan,
                               const char *const *record);
/* Adds a point's rows. Errors: THUD_MEMORY. */
enum thud_status thud_sweep_collector_add(struct thud_sweep_collector *collector, const struct thud_sweep_plan *plan,
                                          const struct thud_sweep_point *point, struct thud_error *err);
void thud_sweep_collector_clear(struct thud_sweep_collector *collector);

#endif
