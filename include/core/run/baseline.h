/* Contact-free response of a model, computed once and cached. It is the result for every sufficiently wide clearance,
 * and the start of every run whose first contact comes later. It is read-only afterwards, so several runs may start
 * from it at the same time. */
#pragma once

#include <stdbool.h>

#include "core/run/run.h"

struct thud_baseline_motion;

/* Creates the baseline of `model` without its contacts, so laws and clearances have no effect. `open` above 0 omits
 * only the contacts of that interface, for its relative displacements, not for runs. Model and record must outlive it.
 * Errors: as thud_run_create. */
enum thud_status thud_baseline_create(const struct thud_model *model, int open, const struct thud_record *record,
                                      const struct thud_run_options *options, struct thud_baseline_motion **out,
                                      struct thud_error *err);
/* Advances as thud_run_advance; the functions below are valid once it is done. */
enum thud_status thud_baseline_advance(struct thud_baseline_motion *baseline, long budget, bool *done,
                                       struct thud_error *err);
void thud_baseline_free(struct thud_baseline_motion *baseline);

/* Returns the contact-free result. */
const struct thud_result *thud_baseline_result(const struct thud_baseline_motion *baseline);
/* Returns the largest u_left - u_right (m) of contact c (from 0) over the whole motion, at least 0: the clearance that
 * prevents this contact. */
double thud_baseline_relative_displacement(const struct thud_baseline_motion *baseline, int c);
/* Returns the largest |displacement| (m) of the struck point of contact c between two floors; 0 for floor to floor. */
double thud_baseline_struck_displacement(const struct thud_baseline_motion *baseline, int c);

/* Returns whether runs can share its beginning. This needs the exact method, whose contact-free response does not
 * depend on the clearances. */
bool thud_baseline_shares(const struct thud_baseline_motion *baseline);

/* Creates a run of `model` (same structures and floor pairs as the baseline's) from the last checkpoint before which no
 * contact can close; it ends when no contact or new peak can follow. Its motion and peaks equal those of a run from t =
 * 0, bit for bit; energies and counts of work are those from its start to its end. *shared_s is the time of its start,
 * 0 if nothing is shared (histories are stored, or the method uses steps without contact). Errors: as thud_run_create.
 */
enum thud_status thud_baseline_run(const struct thud_baseline_motion *baseline, const struct thud_model *model,
                                   const struct thud_record *record, const struct thud_run_options *options,
                                   struct thud_run **out, double *shared_s, struct thud_error *err);
