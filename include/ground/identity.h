/* What a ground motion's own words say of it: its direction, and whether two motions are of one event or station. */
#pragma once

#include <stdbool.h>

#include "ground/record.h"

/* Its peak and how its samples stand to those of its file: "peak 0.821 g as recorded", "... scaled by 1.2", "... reversed",
 * "... scaled by 1.2, reversed"; of a synthetic one "as synthesized" for the first. */
void thud_record_peak_text(const struct thud_record *record, char *text, size_t size);
/* "Kaikoura, New Zealand, 2016-11-13, WTMC, N28W": event, station and component as far as they are said; without any the
 * name of its file. */
void thud_record_title(const struct thud_record *record, char *text, size_t size);
/* " (synthetic)", or "". */
const char *thud_record_synthetic_mark(const struct thud_record *record);
/* "synthetic motion" or "3 of 8 motions synthetic"; "" where none is. */
void thud_synthetic_text(int synthetic, int of, char *text, size_t size);
int thud_records_synthetic(const struct thud_record *const *record, int n);

/* A vertical component, by its own words or those of its file's name: UP, U-D, UD, VERT, a channel code such as HNZ, and
 * components 3 and 6 of KiK-net. */
bool thud_record_is_vertical(const struct thud_record *record);
/* Degrees from north towards east by what a component is called: NS, E-W, HNE, N28W, 090, 90 DEG; NaN: it does not say. */
double thud_record_azimuth(const struct thud_record *record);
/* Whether a component has this name, or is on the same axis. */
bool thud_component_is(const char *name, const char *wanted);
bool thud_component_is_vertical(const char *name);
/* Whether both are of one event, or of one station in it; false where one does not state it. */
bool thud_record_same_event(const struct thud_record *a, const struct thud_record *b);
bool thud_record_same_station(const struct thud_record *a, const struct thud_record *b);
/* The same motion but for a factor, where it begins, and how it was processed: at the best lag of up to 5 s the
 * correlation coefficient of the two is above 0.9. */
bool thud_record_same_motion(const struct thud_record *a, const struct thud_record *b);
/* Whether a ground motion is `other` reversed, by their names as a suite of both signs has them. */
bool thud_motion_is_turned(const char *own, const char *other);
/* How many recordings n motions are of: one event at one station is one, and so is one file, whatever the components,
 * factors, signs, windows and processings of it; without a station a motion is one of its own unless it is the same
 * motion as another, or none at all (NULL). `of` (n): whose, from 0 in the order of the motions; or NULL. */
int thud_motions_recordings(const struct thud_record *const *record, int n, int *of);
