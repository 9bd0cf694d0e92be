/* Writes ground motions as CSV that reads back the same bits without an option. */
#pragma once

#include "base/text.h"
#include "ground/record.h"
#include "ground/synthesize.h"

/* Writes comment lines (`# ` before each line of `comment`, which may be NULL), the record's metadata, then
 * `time_s,acceleration_mps2` and a line per sample. */
void thud_record_csv(const struct thud_record *record, const char *comment, struct thud_text *text);

/* Writes a surrogate with every parameter in its comment lines. `title` (may be empty) names what it stands for.
 * Errors: those of thud_synthesis_run. */
enum thud_status thud_surrogate_csv(const struct thud_synthesis *synthesis, const char *title, struct thud_text *text,
                                    struct thud_error *err);
