/* Horizontal components of a recording: finds pairs, and makes another direction of two. */
#pragma once

#include "io/record/record_file.h"

/* Component decided by the buildings, which files do not know: see thud_motion_read. */
#define THUD_COMPONENT_GOVERNS "governs"

/* Returns whether a name needs more than one component: rotd50, rotd100, rotN, governs. */
bool thud_component_is_rotated(const char *component);

/* Reads the other horizontal component of the recording at `path`, with the settings of `choice`, from a file with a
 * similar name in the same folder. Gives its path; *out NULL with THUD_OK: none. Errors: THUD_INPUT, THUD_MEMORY. */
enum thud_status thud_record_companion(const char *path, const struct thud_record *record,
                                       const struct thud_record_choice *choice, char *other, size_t size,
                                       struct thud_record **out, struct thud_error *err);

/* Reads a motion as recorded, in the direction of choice->component. Errors: THUD_INPUT, THUD_MEMORY. */
enum thud_status thud_record_rotated_read(const char *path, const struct thud_record_choice *choice,
                                          struct thud_record **out, struct thud_error *err);
