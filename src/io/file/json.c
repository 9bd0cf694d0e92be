#include "io/file/json.h"

#include <math.h>

#include "base/utf8.h"

static bool is_escaped(const char *s)
{
    return thud_utf8_is_control(thud_utf8_next(&s));
}

/* Beyond U+FFFF as a pair of surrogates (RFC 8259). */
static void put_escaped(struct thud_text *out, const char *s)
{
    uint32_t code = thud_utf8_next(&s);
    if (code < 0x10000)
        thud_text_append(out, "\\u%04x", (unsigned)code);
    else
        thud_text_append(out, "\\u%04x\\u%04x", (unsigned)(0xd800 + ((code - 0x10000) >> 10)),
                         (unsigned)(0xdc00 + ((code - 0x10000) & 0x3ff)));
}

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
        } else if (is_escaped(s)) {
            put_escaped(out, s);
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

void thud_json_fields(struct thud_text *out, const struct thud_json_pair *pair, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        thud_text_append(out, i > 0 ? ", " : "");
        thud_json_field(out, pair[i].key, pair[i].value);
    }
}
