/* Writes pieces of JSON text. */
#pragma once

#include "base/text.h"

/* Appends a quoted string; control characters are escaped, bytes that are not UTF-8 replaced. */
void thud_json_string(struct thud_text *out, const char *text);
/* Appends a number that reads back the same; null if not finite. */
void thud_json_number(struct thud_text *out, double value);
/* Appends "key": value. */
void thud_json_field(struct thud_text *out, const char *key, double value);
/* Appends several, separated by commas: THUD_JSON_FIELDS(out, {"key", value}, {"key", value}). */
struct thud_json_pair {
    const char *key;
    double value;
};
void thud_json_fields(struct thud_text *out, const struct thud_json_pair *pair, size_t n);
#define THUD_JSON_FIELDS(out, ...)                                                                                     \
    thud_json_fields(out, (const struct thud_json_pair[]){__VA_ARGS__},                                                \
                     sizeof((const struct thud_json_pair[]){__VA_ARGS__}) / sizeof(struct thud_json_pair))
