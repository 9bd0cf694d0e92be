#include "io/json.h"

#include <math.h>

/* Length of the UTF-8 sequence at s, 0 where there is none. */
static int utf8_length(const unsigned char *s)
{
    int n = s[0] < 0x80                   ? 1
            : s[0] >= 0xC2 && s[0] < 0xE0 ? 2
            : s[0] >= 0xE0 && s[0] < 0xF0 ? 3
            : s[0] >= 0xF0 && s[0] < 0xF5 ? 4
                                          : 0;
    for (int i = 1; i < n; i++)
        if ((s[i] & 0xC0) != 0x80)
            return 0;
    if ((n == 3 && s[0] == 0xE0 && s[1] < 0xA0) || (n == 3 && s[0] == 0xED && s[1] >= 0xA0) ||
        (n == 4 && s[0] == 0xF0 && s[1] < 0x90) || (n == 4 && s[0] == 0xF4 && s[1] >= 0x90))
        return 0;
    return n;
}

void thud_json_string(struct thud_text *out, const char *text)
{
    thud_text_append(out, "\"");
    for (const unsigned char *s = (const unsigned char *)text; *s;) {
        int n = utf8_length(s);
        if (n == 0) {
            thud_text_append(out, "\xEF\xBF\xBD");
            n = 1;
        } else if (*s == '"' || *s == '\\') {
            thud_text_append(out, "\\%c", *s);
        } else if (*s < 0x20 || *s == 0x7f) {
            thud_text_append(out, "\\u%04x", (unsigned)*s);
        } else {
            thud_text_bytes(out, (const char *)s, (size_t)n);
        }
        s += n;
    }
    thud_text_append(out, "\"");
}

void thud_json_number(struct thud_text *out, double value)
{
    if (isfinite(value))
        thud_text_number(out, value);
    else
        thud_text_append(out, "null");
}

void thud_json_field(struct thud_text *out, const char *key, double value)
{
    thud_text_append(out, "\"%s\": ", key);
    thud_json_number(out, value);
}
