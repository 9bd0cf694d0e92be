/* The peaks from inside: what their bounds, their segments and their blocks give each other. */
#pragma once

#include "core/observe/observe_peaks.h"

/* response_bound.c. Fills peaks->per_speed, per_force and as_speed. */
void thud_response_bound_fill(struct thud_peaks *peaks, const struct thud_state *state);
/* Fills peaks->push. */
void thud_peaks_row_forces(struct thud_peaks *peaks, const struct thud_model *m, const struct thud_segment *seg);
/* S of a structure in the segment up to s, with what its forces do at once. */
double thud_response_bound_segment(const struct thud_peaks *peaks, const struct thud_state *state,
                                   const struct thud_segment *seg, int structure, double s);

/* observe_peaks_series.c. Reads the peak of a floor's quantity from the polynomials of a segment; those of a structure are made
 * once, until they are forgotten. */
void thud_peaks_read_floor(struct thud_peaks *peaks, const struct thud_model *m, const struct thud_segment *seg,
                           int structure, int floor, int quantity, double s_end);
void thud_peaks_forget_series(struct thud_peaks *peaks, const struct thud_model_structure *p);

/* observe_peaks_block.c: the observer's function for blocks. */
enum thud_status thud_peaks_block(void *own, const struct thud_state *state, struct thud_free_vibration *f,
                                  int intervals, struct thud_error *err);
