/* Horizontal components of a recording: which belong together, and one of another direction made of two. */
#pragma once

#include "io/record/record_file.h"

/* Decided by buildings, which files do not know: see thud_motion_read. */
#define THUD_COMPONENT_GOVERNS "governs"

/* Whether a name needs more than one component: rotd50, rotd100, rotN, governs. */
bool thud_component_is_rotated(const char *component);

/* The other horizontal component of the recording at `path`, in a file named like it in the same folder, read as
 * `choice` says, and its path; *out NULL with THUD_OK: there is none. Errors: THUD_INPUT, THUD_MEMORY. */
enum thud_status thud_record_companion(const char *path, const struct thud_record *record,
                                       const struct thud_record_choice *choice, char *other, size_t size,
                                       struct thud_record **out, struct thud_error *err);

/* As recorded, in the direction of choice->component. Errors: THUD_INPUT, THUD_MEMORY. */
enum thud_status thud_record_rotated_read(const char *path, const struct thud_record_choice *choice,
                                          struct thud_record **out, struct thud_error *err);
