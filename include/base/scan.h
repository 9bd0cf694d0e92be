/* Taking a text apart from left to right. Each moves `*text` past what it read, and leaves it where it was when what
 * was wanted is not there. */
#pragma once

#include <stdbool.h>

/* Exactly `word`. */
bool thud_scan_word(const char **text, const char *word);
/* A count: one to nine decimal digits, no sign, no blank. */
bool thud_scan_count(const char **text, int *out);
