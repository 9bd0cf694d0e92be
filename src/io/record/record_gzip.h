#ifndef THUD_IO_RECORD_GZIP_H
#define THUD_IO_RECORD_GZIP_H

#include <stddef.h>

#include "base/status.h"

/* Unpacks what gzip(1) made, all its members, into *out with a NUL after it (free with free()). Errors: THUD_INPUT (cut
 * off, damaged, more than `most` bytes), THUD_MEMORY. */
enum thud_status record_gunzip(const char *packed, size_t size, size_t most, char **out, size_t *length,
                               struct thud_error *err);

#endif
