#include "io/json.h"

#include <math.h>

#include "base/utf8.h"

void thud_json_string(struct thud_text *out, const char *text)
{
    thud_text_append(out, "\"");
    for (const char *s = text; *s;) {
        int n = thud_utf8_length(s);
        if (n == 0) {
            thud_text_append(out, "\xEF\xBF\xBD");
            n = 1;
        } else if (*s == '"' || *s == '\\') {
            thud_text_append(out, "\\%c", *s);
        } else if ((unsigned char)*s < 0x20 || *s == 0x7f) {
            thud_text_append(out, "\\u%04x", (unsigned)(unsigned char)*s);
        } else {
            thud_text_bytes(out, s, (size_t)n);
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
