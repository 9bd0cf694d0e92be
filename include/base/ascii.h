/* Characters and keywords by ASCII alone, whatever the locale: in a Turkish one the library's tolower('I') is no `i`.
 * A byte of another character (0x80 and above) is none of these. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

bool thud_ascii_is_digit(char c);
bool thud_ascii_is_upper(char c);
bool thud_ascii_is_alpha(char c);
bool thud_ascii_is_alnum(char c);
char thud_ascii_lower(char c);
char thud_ascii_upper(char c);

/* The same letters, large or small. */
bool thud_ascii_same(const char *a, const char *b);
/* `text`, of which `size` bytes may be read, begins with `word`, large or small. */
bool thud_ascii_begins(const char *text, size_t size, const char *word);
/* Where `part` stands in `text`, large or small, the first time; NULL: nowhere. */
const char *thud_ascii_find(const char *text, const char *part);
/* `text` ends with these very letters. */
bool thud_ascii_ends(const char *text, const char *end);
