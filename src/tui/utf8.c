#include "tui/canvas.h"

/* Length of the sequence that starts with `lead`; 0 when none does. */
static int sequence_length(unsigned char lead)
{
    if (lead < 0x80)
        return 1;
    if (lead >= 0xc2 && lead < 0xe0)
        return 2;
    if (lead >= 0xe0 && lead < 0xf0)
        return 3;
    if (lead >= 0xf0 && lead < 0xf5)
        return 4;
    return 0;
}

uint32_t thud_utf8_next(const char **text)
{
    const unsigned char *s = (const unsigned char *)*text;
    if (!*s)
        return 0;
    int length = sequence_length(*s);
    if (length <= 1) {
        (*text)++;
        return length ? *s : '?';
    }
    static const unsigned char mask[] = {0, 0, 0x1f, 0x0f, 0x07};
    uint32_t code = *s & mask[length];
    for (int i = 1; i < length; i++) {
        if ((s[i] & 0xc0) != 0x80) {
            *text += i;
            return '?';
        }
        code = code << 6 | (s[i] & 0x3fU);
    }
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

int thud_utf8_columns(const char *text)
{
    int n = 0;
    while (thud_utf8_next(&text))
        n++;
    return n;
}
