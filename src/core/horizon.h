/* What still can come of a run once the strong part of the ground motion is over. Between contacts a run is the motion
 * without contact, which is known, plus a free vibration that only decays. Where bounds of both together show that no
 * contact closes and no peak rises any more, the run may go to its end in one stride. */
#ifndef THUD_CORE_HORIZON_H
#define THUD_CORE_HORIZON_H

#include "core/flight.h"

struct thud_horizon;

/* For a run without contact, which is going to fill it. NULL when out of memory. */
struct thud_horizon *thud_horizon_create(const struct thud_model *model);
void thud_horizon_free(struct thud_horizon *horizon);

/* Of the run without contact: keeps the block just marched and what its values cannot pass. A failed allocation ends
 * the keeping. */
void thud_horizon_record(struct thud_horizon *horizon, const struct thud_run *run, struct thud_flight *f,
                         int intervals);
/* After the last block: its end, and what comes after each block. */
void thud_horizon_close(struct thud_horizon *horizon);

/* Of a run with contacts, all open: puts it at the end of the last block where nothing can happen before it; returns
 * how many intervals that passes, 0 where it cannot. */
long thud_horizon_jump(const struct thud_horizon *horizon, struct thud_run *run);
/* Intervals from `grid` to the next moment at which it pays to ask. */
int thud_horizon_stride(long grid);

#endif
