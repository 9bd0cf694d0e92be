/* A growing text, for what is put together in memory and written in one go. */
#pragma once

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
void thud_text_base64(struct thud_text *text, const char *bytes, size_t n);
/* A name in a table: to the left of so many columns on the screen, never cut. A table's column is as wide as the widest
 * of its names (thud_text_wider from the least width on). */
void thud_text_padded(struct thud_text *text, const char *name, int columns);
int thud_text_wider(int columns, const char *name);
void thud_text_number(struct thud_text *text, double value); /* shortest text that reads back the same */
/* A text as a field of CSV, in quotation marks where it needs them, and where it has what a terminal would obey or
 * bytes that are not UTF-8: these are written as they are. A spreadsheet computes what begins with = + - @ and
 * is no number: an apostrophe stands before it. */
void thud_text_csv(struct thud_text *text, const char *field);
/* The text that was meant by a field. */
const char *thud_text_csv_plain(const char *field);
/* In place: a ? for every character that a terminal would obey, but for those of `kept` ("\n\t"), and for bytes that are
 * not UTF-8. Returns the length. */
size_t thud_text_shown(char *text, const char *kept);
/* A line of comment, `# NAME: VALUE`, as thud_text_shown has it: a value with a line end stays one line. */
void thud_text_comment(struct thud_text *text, const char *name, const char *value);
void thud_text_clear(struct thud_text *text);
/* FNV-1a, 64 bits, of `size` bytes after what `h` is of; of nothing it is THUD_HASH_START. */
#define THUD_HASH_START 0xcbf29ce484222325ULL
unsigned long long thud_hash(unsigned long long h, const void *bytes, size_t size);
unsigned long long thud_hash_text(unsigned long long h, const char *text); /* with its NUL */

/* The part of a path after its last slash; all of it where nothing follows one. Settings of a ground motion that stand
 * behind its path belong to the name: "b.csv:unit=cm/s2" of "a/b.csv:unit=cm/s2". */
const char *thud_path_name(const char *path);
