/* Compares characters and keywords as ASCII, whatever the locale: in a Turkish one the library's tolower('I') is not
 * `i`. A byte of another character (0x80 and above) is none of these. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

bool thud_ascii_is_digit(char c);
bool thud_ascii_is_upper(char c);
bool thud_ascii_is_alpha(char c);
bool thud_ascii_is_alnum(char c);
char thud_ascii_lower(char c);
char thud_ascii_upper(char c);

/* Returns whether both are equal, ignoring case. */
bool thud_ascii_same(const char *a, const char *b);
/* Returns whether `text` (`size` bytes) begins with `word`, ignoring case. */
bool thud_ascii_begins(const char *text, size_t size, const char *word);
/* Finds the first `part` in `text`, ignoring case; NULL: none. */
const char *thud_ascii_find(const char *text, const char *part);
/* Returns whether `text` ends with these letters. */
bool thud_ascii_ends(const char *text, const char *end);
