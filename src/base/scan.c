#include "base/scan.h"

#include <string.h>

bool thud_scan_word(const char **text, const char *word)
{
    size_t length = strlen(word);
    if (strncmp(*text, word, length) != 0)
        return false;
    *text += length;
    return true;
}

bool thud_scan_count(const char **text, int *out)
{
    enum { DIGITS_MOST = 9 };
    int digits = 0, value = 0;
    for (; digits <= DIGITS_MOST && (*text)[digits] >= '0' && (*text)[digits] <= '9'; digits++)
        value = digits < DIGITS_MOST ? 10 * value + ((*text)[digits] - '0') : value;
    if (digits == 0 || digits > DIGITS_MOST)
        return false;
    *out = value;
    *text += digits;
    return true;
}
