/* What may be done to a ground motion on request; nothing of it ever happens by itself. */
#ifndef THUD_CORE_RECORD_EDIT_H
#define THUD_CORE_RECORD_EDIT_H

#include "core/record.h"

/* Keeps the samples from `from_s` to `to_s` (each NaN: from the beginning, to the end); time starts anew. Errors:
 * THUD_INPUT when fewer than two remain. */
enum thud_status thud_record_trim(struct thud_record *record, double from_s, double to_s, struct thud_error *err);

enum thud_baseline { THUD_BASELINE_NONE, THUD_BASELINE_MEAN, THUD_BASELINE_LINEAR };
/* Takes off the mean or the least-squares straight line of the accelerations. */
void thud_record_baseline(struct thud_record *record, enum thud_baseline baseline);

/* A new record at another step. It goes straight between the samples, as every run takes the record: at a whole
 * fraction of the step the motion is the same, at any other it loses what lies between. Errors: THUD_INPUT (a step that
 * is not positive or beyond the duration, more than 1e8 samples), THUD_MEMORY. */
enum thud_status thud_record_resample(const struct thud_record *record, double dt_s, struct thud_record **out,
                                      struct thud_error *err);

#endif
