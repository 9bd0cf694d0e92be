#include "base/utf8.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

static int continuations(const unsigned char *s)
{
    int n = 0;
    while (n < 3 && (s[1 + n] & 0xc0) == 0x80)
        n++;
    return n;
}

int thud_utf8_length(const char *text)
{
    const unsigned char *s = (const unsigned char *)text;
    int n = s[0] < 0x80                   ? 1
            : s[0] >= 0xc2 && s[0] < 0xe0 ? 2
            : s[0] >= 0xe0 && s[0] < 0xf0 ? 3
            : s[0] >= 0xf0 && s[0] < 0xf5 ? 4
                                          : 0;
    if (n < 2)
        return n;
    if (continuations(s) < n - 1)
        return 0;
    if ((s[0] == 0xe0 && s[1] < 0xa0) || (s[0] == 0xed && s[1] >= 0xa0) || (s[0] == 0xf0 && s[1] < 0x90) ||
        (s[0] == 0xf4 && s[1] >= 0x90))
        return 0;
    return n;
}

uint32_t thud_utf8_next(const char **text)
{
    static const unsigned char mask[] = {0, 0x7f, 0x1f, 0x0f, 0x07};
    const unsigned char *s = (const unsigned char *)*text;
    if (!*s)
        return 0;
    int length = thud_utf8_length(*text);
    if (length == 0) { /* one mark for a lead byte and what follows it */
        *text += 1 + (*s >= 0xc2 ? continuations(s) : 0);
        return '?';
    }
    uint32_t code = *s & mask[length];
    for (int i = 1; i < length; i++)
        code = code << 6 | (s[i] & 0x3fU);
    *text += length;
    return code;
}

int thud_utf8_put(uint32_t code, char out[5])
{
    int n = 0;
    if (code < 0x80) {
        out[n++] = (char)code;
    } else if (code < 0x800) {
        out[n++] = (char)(0xc0 | code >> 6);
    } else if (code < 0x10000) {
        out[n++] = (char)(0xe0 | code >> 12);
        out[n++] = (char)(0x80 | (code >> 6 & 0x3f));
    } else {
        out[n++] = (char)(0xf0 | (code >> 18 & 7));
        out[n++] = (char)(0x80 | (code >> 12 & 0x3f));
        out[n++] = (char)(0x80 | (code >> 6 & 0x3f));
    }
    if (code >= 0x80)
        out[n++] = (char)(0x80 | (code & 0x3f));
    out[n] = '\0';
    return n;
}

int thud_utf8_width(uint32_t c)
{
    if (c < 0x300)
        return 1;
    if ((c <= 0x36f) || (c >= 0x483 && c <= 0x489) || (c >= 0x591 && c <= 0x5bd) || (c >= 0x610 && c <= 0x61a) ||
        (c >= 0x64b && c <= 0x65f) || (c >= 0x1ab0 && c <= 0x1aff) || (c >= 0x1dc0 && c <= 0x1dff) ||
        (c >= 0x200b && c <= 0x200f) || (c >= 0x2028 && c <= 0x202e) || (c >= 0x2060 && c <= 0x206f) ||
        (c >= 0x20d0 && c <= 0x20ff) || (c >= 0xfe00 && c <= 0xfe0f) || (c >= 0xfe20 && c <= 0xfe2f) || c == 0xfeff)
        return 0;
    return (c >= 0x1100 && c <= 0x115f) || c == 0x231a || c == 0x231b || (c >= 0x2e80 && c <= 0x303e) ||
                   (c >= 0x3041 && c <= 0xa4cf) || (c >= 0xa960 && c <= 0xa97f) || (c >= 0xac00 && c <= 0xd7a3) ||
                   (c >= 0xf900 && c <= 0xfaff) || (c >= 0xfe30 && c <= 0xfe6f) || (c >= 0xff00 && c <= 0xff60) ||
                   (c >= 0xffe0 && c <= 0xffe6) || (c >= 0x1f300 && c <= 0x1faff) || (c >= 0x20000 && c <= 0x3fffd)
               ? 2
               : 1;
}

bool thud_utf8_is_control(uint32_t c)
{
    return c < 0x20 || (c >= 0x7f && c < 0xa0) || c == 0x61c || (c >= 0x200b && c <= 0x200f) ||
           (c >= 0x2028 && c <= 0x202e) || (c >= 0x2060 && c <= 0x206f) || c == 0xfeff ||
           (c >= 0xe0000 && c <= 0xe007f);
}

int thud_utf8_columns(const char *text)
{
    int n = 0;
    for (uint32_t c; (c = thud_utf8_next(&text)) != 0;)
        n += thud_utf8_width(c);
    return n;
}

char *thud_utf8_fit(const char *text, int columns, char *out, unsigned long size)
{
    bool whole = thud_utf8_columns(text) <= columns;
    size_t n = 0;
    int used = 0;
    for (const char *next = text; *text; text = next) {
        uint32_t c = thud_utf8_next(&next);
        size_t bytes = (size_t)(next - text);
        used += thud_utf8_width(c);
        if (used > columns - !whole || n + bytes + 4 > size)
            break;
        memcpy(out + n, text, bytes);
        n += bytes;
    }
    snprintf(out + n, size - n, "%s", whole || columns < 1 ? "" : "…");
    return out;
}
