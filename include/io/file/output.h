/* Writes a file in pieces, whole or not at all. */
#pragma once

#include "base/text.h"

struct thud_output {
    int fd;
    char path[4096], part[4200];
};

/* Opens a temporary beside `path`. Errors: THUD_OUTPUT. */
enum thud_status thud_output_open(const char *path, struct thud_output *out, struct thud_error *err);
/* Writes what `text` holds so far when it is at least `least` bytes, and empties it. Errors: THUD_OUTPUT, THUD_MEMORY.
 */
enum thud_status thud_output_drain(struct thud_output *out, struct thud_text *text, size_t least,
                                   struct thud_error *err);
/* Syncs and renames. On failure the temporary is gone. Errors: THUD_OUTPUT. */
enum thud_status thud_output_commit(struct thud_output *out, struct thud_error *err);
/* Removes the temporary; does nothing after a commit. */
void thud_output_abandon(struct thud_output *out);
