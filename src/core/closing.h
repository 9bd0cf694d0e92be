/* Largest closings of a run without contact, for the trunk: watched where peaks are read. */
#ifndef THUD_CORE_CLOSING_H
#define THUD_CORE_CLOSING_H

#include "core/flight.h"

/* Raises run->closing (ncontacts) by the intervals of a block just marched, the state still being that at its start. */
void thud_closing_flight(struct thud_run *run, struct thud_flight *f, int intervals);
/* The same by the run's segment up to s. */
void thud_closing_segment(struct thud_run *run, double s);

#endif
