/* Scans a text from left to right. Each function moves `*text` past what it read, and leaves it in place if the wanted
 * item is absent. */
#pragma once

#include <stdbool.h>

/* Reads exactly `word`. */
bool thud_scan_word(const char **text, const char *word);
/* Reads a count: one to nine decimal digits, no sign, no blank. */
bool thud_scan_count(const char **text, int *out);
