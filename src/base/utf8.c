#include "base/utf8.h"

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

bool thud_utf8_is_control(uint32_t c)
{
    return c < 0x20 || (c >= 0x7f && c < 0xa0) || c == 0x61c || (c >= 0x200b && c <= 0x200f) ||
           (c >= 0x2028 && c <= 0x202e) || (c >= 0x2060 && c <= 0x206f) || c == 0xfeff ||
           (c >= 0xe0000 && c <= 0xe007f);
}

int thud_utf8_columns(const char *text)
{
    int n = 0;
    while (thud_utf8_next(&text))
        n++;
    return n;
}
