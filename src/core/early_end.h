/* Early termination: between contacts a run is the contact-free baseline, which is known, plus a free vibration,
 *
 *     q(t) = q_baseline(t) + dq(t),   |dq_j(t)| <= sqrt(dq_j^2 + ((dq_j' + zeta omega dq_j)/omega_d)^2) at its start
 *
 * Where the largest values of the baseline that are still to come, plus these amplitudes, show that no contact and no
 * new peak can follow, the run goes to its end in one step. Not for free bodies, whose difference does not decay. */
#ifndef THUD_CORE_EARLY_END_H
#define THUD_CORE_EARLY_END_H

#include "core/free_vibration.h"

struct thud_early_end;

/* For a run without contact, which is going to fill it. NULL when out of memory. */
struct thud_early_end *thud_early_end_create(const struct thud_model *model);
void thud_early_end_free(struct thud_early_end *early_end);

/* Of the run without contact: keeps the block just marched and what its values cannot pass. A failed allocation ends
 * the keeping. */
void thud_early_end_record(struct thud_early_end *early_end, const struct thud_run *run, struct thud_free_vibration *f,
                           int intervals);
/* After the last block: its end, and what comes after each block. */
void thud_early_end_close(struct thud_early_end *early_end);

/* Of a run with contacts, all open: puts it at the end of the last block where nothing can happen before it; returns
 * how many intervals that passes, 0 where it cannot. */
long thud_early_end_jump(const struct thud_early_end *early_end, struct thud_run *run);
/* Intervals from `grid` to the next moment at which it pays to ask. */
int thud_early_end_stride(long grid);

#endif
