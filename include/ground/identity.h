/* Identity of a ground motion: its direction, and whether two motions are of one event or station. */
#pragma once

#include <stdbool.h>

#include "ground/record.h"

/* Writes the peak and how the samples relate to those of the file: "peak 0.821 g as recorded", "... scaled by 1.2",
 * "... reversed", "... scaled by 1.2, reversed"; a synthetic motion is "as synthesized". */
void thud_record_peak_text(const struct thud_record *record, char *text, size_t size);
/* Writes event, station and component as far as known: "Kaikoura, New Zealand, 2016-11-13, WTMC, N28W"; else the name
 * of the file. */
void thud_record_title(const struct thud_record *record, char *text, size_t size);
/* Returns " (synthetic)" or "". */
const char *thud_record_synthetic_mark(const struct thud_record *record);
/* Writes "synthetic motion" or "3 of 8 motions synthetic"; "" if none is. */
void thud_synthetic_text(int synthetic, int of, char *text, size_t size);
int thud_records_synthetic(const struct thud_record *const *record, int n);

/* Returns whether a component is vertical, by its description or the name of its file: UP, U-D, UD, VERT, a channel
 * code such as HNZ, and components 3 and 6 of KiK-net. */
bool thud_record_is_vertical(const struct thud_record *record);
/* Returns the azimuth in degrees from north towards east by a component's name: NS, E-W, HNE, N28W, 090, 90 DEG; NaN:
 * none. */
double thud_record_azimuth(const struct thud_record *record);
/* Returns whether a component has this name, or is on the same axis. */
bool thud_component_is(const char *name, const char *wanted);
bool thud_component_is_vertical(const char *name);
/* Return whether both are of one event, or of one station in it; false if either does not state it. */
bool thud_record_same_event(const struct thud_record *a, const struct thud_record *b);
bool thud_record_same_station(const struct thud_record *a, const struct thud_record *b);
/* Returns whether both may be of one event: not where the texts of their events state different years. */
bool thud_record_may_be_same_event(const struct thud_record *a, const struct thud_record *b);
/* Returns whether two motions are read from one file, whatever their factors, signs and windows; columns of a table and
 * channels may be of different recordings, and are files of their own. */
bool thud_record_same_file(const struct thud_record *a, const struct thud_record *b);
/* Returns whether two motions are the same except for factor, start and processing: their correlation coefficient
 * exceeds 0.9 at the best lag of up to 5 s. */
bool thud_record_same_motion(const struct thud_record *a, const struct thud_record *b);
/* Returns whether a ground motion is `other` reversed, by the names in a suite of both signs. */
bool thud_motion_is_turned(const char *own, const char *other);
/* Returns the number of recordings among n motions. One event at one station, or one file, is one recording, whatever
 * its components, factors, signs, windows and processings. Without a station a motion counts by itself unless it is the
 * same motion as another; NULL counts as none. `of` (n) or NULL: the recording of each, from 0 in the order of the
 * motions. */
int thud_motions_recordings(const struct thud_record *const *record, int n, int *of);
