/* Edits of a ground motion, made only on request. */
#pragma once

#include "ground/record.h"

/* Keeps the samples from `from_s` to `to_s` (each NaN: from the beginning, to the end); time starts again at 0. Errors:
 * THUD_INPUT when fewer than two remain. */
enum thud_status thud_record_trim(struct thud_record *record, double from_s, double to_s, struct thud_error *err);

/* Removes the best-fit polynomial of this degree (least squares) from the accelerations: 0 the mean, 1 a linear trend;
 * THUD_BASELINE_NONE nothing. */
enum { THUD_BASELINE_NONE = -1, THUD_BASELINE_MEAN = 0, THUD_BASELINE_LINEAR = 1, THUD_BASELINE_MAX = 8 };
void thud_record_baseline(struct thud_record *record, int degree);

/* Applies a cosine taper over `taper_s` at both ends. Errors: THUD_INPUT (less than 0, or more than half of the
 * motion). */
enum thud_status thud_record_taper(struct thud_record *record, double taper_s, struct thud_error *err);

/* Creates a record with other samples and the same names. Errors: as thud_record_create. */
enum thud_status thud_record_like(const struct thud_record *record, const double *a_mps2, size_t samples, double dt_s,
                                  struct thud_record **out, struct thud_error *err);

/* Keeps one sample in `every` (1: all), starting with the first, after a low-pass filter at half the rate of samples
 * that are `spacing` (1 or more) steps apart. The filter is a sinc in a Blackman window, without phase shift, which
 * falls within a sixth of its corner frequency. The motion is 0 beyond its ends. Errors: THUD_INPUT (fewer than two
 * remain), THUD_MEMORY. */
enum thud_status thud_record_low_pass(struct thud_record *record, double spacing, int every, struct thud_error *err);

/* Creates a record with another step, by linear interpolation between the samples, as in every run. At an integer
 * fraction of the step the motion is the same; at any other step, peaks between the new samples are lost. Errors:
 * THUD_INPUT (a step that is not positive or beyond the duration, more than 1e8 samples), THUD_MEMORY. */
enum thud_status thud_record_resample(const struct thud_record *record, double dt_s, struct thud_record **out,
                                      struct thud_error *err);
