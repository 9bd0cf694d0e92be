/* Largest relative displacement (left less right, m) of the two floors of each contact in a run without contact, for
 * the baseline: an observer beside that of the peaks. */
#ifndef THUD_CORE_RELATIVE_DISPLACEMENT_H
#define THUD_CORE_RELATIVE_DISPLACEMENT_H

#include "core/free_vibration.h"

/* Raises run->relative_m (ncontacts) by the intervals of a block just marched, the state still being that at its start. */
void thud_relative_displacement_block(struct thud_run *run, struct thud_free_vibration *f, int intervals);
/* The same by the run's segment up to s. */
void thud_relative_displacement_segment(struct thud_run *run, double s);

#endif
