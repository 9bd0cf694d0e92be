/* Compares characters and keywords as ASCII, whatever the locale: in a Turkish one the library's tolower('I') is not
 * `i`. A byte of 0x80 or above belongs to none of these classes. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

static inline bool thud_ascii_is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static inline bool thud_ascii_is_upper(char c)
{
    return c >= 'A' && c <= 'Z';
}

static inline bool thud_ascii_is_alpha(char c)
{
    return thud_ascii_is_upper(c) || (c >= 'a' && c <= 'z');
}

static inline bool thud_ascii_is_alnum(char c)
{
    return thud_ascii_is_alpha(c) || thud_ascii_is_digit(c);
}

static inline char thud_ascii_lower(char c)
{
    return thud_ascii_is_upper(c) ? (char)(c - 'A' + 'a') : c;
}

static inline char thud_ascii_upper(char c)
{
    return c >= 'a' && c <= 'z' ? (char)(c - 'a' + 'A') : c;
}

static inline bool thud_ascii_is_blank(char c)
{
    return c == ' ' || c == '\t';
}

/* Returns whether both are equal, ignoring case. */
bool thud_ascii_same(const char *a, const char *b);
/* Returns whether `text` (`size` bytes) begins with `word`, ignoring case. */
bool thud_ascii_begins(const char *text, size_t size, const char *word);
/* Finds the first `part` in `text`, ignoring case; NULL: none. */
const char *thud_ascii_find(const char *text, const char *part);
/* Returns whether `text` ends with these letters. */
bool thud_ascii_ends(const char *text, const char *end);
