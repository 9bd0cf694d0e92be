/* A growing text, for what is put together in memory and written in one go. */
#ifndef THUD_BASE_TEXT_H
#define THUD_BASE_TEXT_H

#include <stddef.h>

#include "base/status.h"

/* Starts as `{0}`. `data` is NUL-terminated once something was appended. After a failed allocation `failed` is set and
 * appends do nothing, so it is enough to look at the end. */
struct thud_text {
    char *data;
    size_t size, capacity;
    int failed;
};
void thud_text_append(struct thud_text *text, const char *fmt, ...) THUD_PRINTF(2, 3);
void thud_text_bytes(struct thud_text *text, const char *bytes, size_t size);
void thud_text_number(struct thud_text *text, double value);   /* shortest text that reads back the same */
void thud_text_csv(struct thud_text *text, const char *field); /* in quotation marks where CSV needs them */
void thud_text_clear(struct thud_text *text);

#endif
