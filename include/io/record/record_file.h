/* Ground motions from files, format found by content. */
#pragma once

#include <stddef.h>

#include "base/status.h"
#include "ground/record.h"
#include "study/scene/scene.h"

enum { THUD_RECORD_BYTES_MAX = 256 << 20 };

/* Reads `path` with what `choice` says of it (dt, unit, channel, column, skip), then keeps the part it asks for and
 * applies factor, peak or spectral acceleration, and sign (record.period must be given for
 * `sa`: see thud_record_choice_resolve).
 * What a file does not say is asked for by its option's name. Errors: THUD_INPUT with file and line, THUD_MEMORY. */
enum thud_status thud_record_file_read(const char *path, const struct thud_record_choice *choice,
                                       struct thud_record **out, struct thud_error *err);

/* Name of the i-th format that is recognized, in the order in which they are tried; NULL behind the last. */
const char *thud_record_format_name(int i);

/* The text of a record file (free with free()), unpacked where gzip has compressed it. Errors: THUD_INPUT (also a pipe,
 * whose end may never come, and more than THUD_RECORD_BYTES_MAX of text), THUD_MEMORY. */
enum thud_status thud_record_text_read(const char *path, char **text, size_t *size, struct thud_error *err);

/* Reads a record from memory, with `name` as its path. Errors: those of thud_record_file_read. */
enum thud_status thud_record_parse(const char *text, size_t size, const char *name,
                                   const struct thud_record_choice *choice, struct thud_record **out,
                                   struct thud_error *err);

/* The part from `from` to `to`, then factor, peak and sign of the choice, and of the scaled samples every so many. Errors:
 * THUD_INPUT (too short a part, zeros cannot be scaled to a peak, or the result is not finite), THUD_MEMORY. */
enum thud_status thud_record_choice_apply(struct thud_record *record, const struct thud_record_choice *choice,
                                          struct thud_error *err);
