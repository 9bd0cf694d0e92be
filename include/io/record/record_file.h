/* Reads ground motions from files, whose format is found by content. */
#pragma once

#include <stddef.h>

#include "base/status.h"
#include "base/text.h"
#include "ground/record.h"
#include "study/scene/scene.h"

enum { THUD_RECORD_BYTES_MAX = 256 << 20 };

/* Reads `path` with the dt, unit, channel, column and skip of `choice`. Keeps the requested part and applies factor,
 * peak or spectral acceleration, and sign. `sa` needs record.period (see thud_record_choice_resolve). What the file
 * does not state is asked for by its option's name. Errors: THUD_INPUT with file and line, THUD_MEMORY. */
enum thud_status thud_record_file_read(const char *path, const struct thud_record_choice *choice,
                                       struct thud_record **out, struct thud_error *err);

/* Lists the formats, as "PEER AT2, K-NET, ...". */
void thud_record_formats(struct thud_text *out);

/* Returns the text of a record file (free with free()), unpacked if gzipped. Errors: THUD_INPUT (also a pipe, whose end
 * may never come, and more than THUD_RECORD_BYTES_MAX of text), THUD_MEMORY. */
enum thud_status thud_record_text_read(const char *path, char **text, size_t *size, struct thud_error *err);

/* Reads a record from memory, with `name` as its path. Errors: those of thud_record_file_read. */
enum thud_status thud_record_parse(const char *text, size_t size, const char *name,
                                   const struct thud_record_choice *choice, struct thud_record **out,
                                   struct thud_error *err);

/* Applies a choice: the part from `from` to `to`, then factor, peak and sign, then decimation. Errors: THUD_INPUT (too
 * short a part, zeros cannot be scaled to a peak, or the result is not finite), THUD_MEMORY. */
enum thud_status thud_record_choice_apply(struct thud_record *record, const struct thud_record_choice *choice,
                                          struct thud_error *err);
