#include "base/ascii.h"

#include <string.h>

bool thud_ascii_begins(const char *text, size_t size, const char *word)
{
    size_t i = 0;
    while (word[i] && i < size && thud_ascii_lower(text[i]) == thud_ascii_lower(word[i]))
        i++;
    return !word[i];
}

bool thud_ascii_same(const char *a, const char *b)
{
    return strlen(a) == strlen(b) && thud_ascii_begins(a, strlen(a), b);
}

const char *thud_ascii_find(const char *text, const char *part)
{
    for (size_t size = strlen(text); !thud_ascii_begins(text, size, part); text++, size--)
        if (size == 0)
            return NULL;
    return text;
}

bool thud_ascii_ends(const char *text, const char *end)
{
    const size_t n = strlen(text), m = strlen(end);
    return n >= m && strcmp(text + n - m, end) == 0;
}
