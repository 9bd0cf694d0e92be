/* Growing text, assembled in memory and written in one call. */
#pragma once

#include <stdarg.h>
#include <stddef.h>

#include "base/status.h"

/* Text, initialized as `{0}`. `data` is NUL-terminated after the first append. A failed allocation sets `failed`, and
 * later appends do nothing, so one check at the end is enough. */
struct thud_text {
    char *data;
    size_t size, capacity;
    int failed;
};
void thud_text_append(struct thud_text *text, const char *fmt, ...) THUD_PRINTF(2, 3);
void thud_text_append_list(struct thud_text *text, const char *fmt, va_list args) THUD_PRINTF(2, 0);
enum { THUD_LINE_WIDTH = 80 }; /* columns of a line of a terminal */
/* Appends words from where the last line ends, in lines of so many columns, the further ones behind `indent` blanks. A
 * tab is a blank at which no line ends. */
void thud_text_wrap(struct thud_text *text, const char *words, size_t indent, size_t columns);
/* Appends to a text in `size` bytes, and cuts what has no room. */
void thud_append(char *text, size_t size, const char *fmt, ...) THUD_PRINTF(3, 4);
void thud_text_bytes(struct thud_text *text, const char *bytes, size_t size);
void thud_text_base64(struct thud_text *text, const char *bytes, size_t n);
/* Writes a name in a table, left-aligned in this many screen columns and never cut: what follows a longer one stands on
 * the next line. A table's column is as wide as its widest name (thud_text_wider, starting from the least width). */
void thud_text_padded(struct thud_text *text, const char *name, int columns);
int thud_text_wider(int columns, const char *name);
void thud_text_number(struct thud_text *text, double value); /* shortest text that reads back the same */
/* Writes a text as a field of CSV, quoted where necessary, also for terminal control characters and bytes that are not
 * UTF-8, which are kept. An apostrophe precedes a non-number that begins with = + - @, which a spreadsheet would
 * compute. */
void thud_text_csv(struct thud_text *text, const char *field);
/* Restores the text of a field. */
const char *thud_text_csv_plain(const char *field);
/* Replaces in place by ? every terminal control character except those of `kept` ("\n\t"), and bytes that are not
 * UTF-8. Returns the length. */
size_t thud_text_shown(char *text, const char *kept);
/* Writes a comment line, `# NAME: VALUE`, as thud_text_shown does: a value with a line end stays one line. */
void thud_text_comment(struct thud_text *text, const char *name, const char *value);
void thud_text_clear(struct thud_text *text);
/* Returns the 64-bit FNV-1a hash of `size` bytes, continued from `h`; THUD_HASH_START is that of nothing. */
#define THUD_HASH_START 0xcbf29ce484222325ULL
unsigned long long thud_hash(unsigned long long h, const void *bytes, size_t size);
unsigned long long thud_hash_text(unsigned long long h, const char *text); /* with its NUL */

/* Returns the part of a path after its last slash; all of it if nothing follows one. Settings behind a ground motion's
 * path belong to the name: "b.csv:unit=cm/s2" of "a/b.csv:unit=cm/s2". */
const char *thud_path_name(const char *path);
