/* Reads and writes UTF-8 (RFC 3629: no overlong forms, no surrogates, nothing beyond U+10FFFF). */
#pragma once

#include <stdbool.h>
#include <stdint.h>

/* Returns the length in bytes of the character at `text`, 1 to 4; 0: not UTF-8. The final 0 of a text has length 1. */
int thud_utf8_length(const char *text);
/* Reads one character and steps over it; bytes that are not UTF-8 give '?'. 0 at the end. */
uint32_t thud_utf8_next(const char **text);
/* Writes a character and a terminating 0; returns its length. */
int thud_utf8_put(uint32_t code, char out[5]);
/* Returns the screen columns of a character: 2 for East Asian scripts and pictures, 0 for combining marks (Unicode
 * Standard Annex 11). */
int thud_utf8_width(uint32_t code);
/* Returns whether a character controls a terminal or a reader instead of being shown: C0 and C1 controls, direction
 * marks and embeddings, joiners and zero-width characters. */
bool thud_utf8_is_control(uint32_t code);
/* Returns the columns of a text on the screen. */
int thud_utf8_columns(const char *text);
/* Writes the text in at most `columns` columns, cut with a final `…` if longer. Returns `out`. */
char *thud_utf8_fit(const char *text, int columns, char *out, unsigned long size);
