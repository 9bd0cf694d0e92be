/* Texts in UTF-8 (RFC 3629: no longer form than needed, no surrogates, nothing beyond U+10FFFF). */
#pragma once

#include <stdbool.h>
#include <stdint.h>

/* Length in bytes of the character at `text`, 1 to 4; 0 where the bytes are not UTF-8. The 0 at the end of a text has
 * length 1. */
int thud_utf8_length(const char *text);
/* Reads one character and steps over it; bytes that are not UTF-8 give '?'. 0 at the end. */
uint32_t thud_utf8_next(const char **text);
/* Writes a character and a terminating 0; returns its length. */
int thud_utf8_put(uint32_t code, char out[5]);
/* Columns that a character takes on the screen: 2 for those of East Asian scripts and pictures, 0 for marks that
 * combine (Unicode Standard Annex 11). */
int thud_utf8_width(uint32_t code);
/* A character that a terminal or a reader obeys in place of showing it: C0 and C1 controls, marks and embeddings of
 * direction, what joins or has no width. */
bool thud_utf8_is_control(uint32_t code);
/* Returns the columns of a text on the screen. */
int thud_utf8_columns(const char *text);
/* The text in at most `columns` columns, cut where it is longer, with `…` at the end. Returns `out`. */
char *thud_utf8_fit(const char *text, int columns, char *out, unsigned long size);
