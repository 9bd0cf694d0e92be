#include "cli/rows.h"

#include <string.h>

#include "base/quantity.h"
#include "base/version.h"
#include "io/file/csv_field.h"
#include "io/file/json.h"
#include "io/file/schema.h"

void thud_rows_begin(const char *preset, struct thud_text *out)
{
    thud_text_append(out, "{");
    if (preset)
        thud_json_head(out, preset);
    else
        thud_text_append(out, "\"format\": 1, \"version\": \"%s\"", THUD_VERSION);
}

void thud_rows_end(struct thud_text *out)
{
    thud_text_append(out, "}\n");
}

static void put_value(const char *field, struct thud_text *out)
{
    const char *end;
    double value;
    if (!*field || strcmp(field, "inf") == 0)
        thud_text_append(out, "null");
    else if (thud_number_parse(field, &end, &value) == 0 && !*end)
        thud_text_append(out, "%s", field);
    else
        thud_json_string(out, field);
}

void thud_rows_add(const char *name, struct thud_text *csv, struct thud_text *out)
{
    enum { COLUMNS_MAX = 64 };
    const char *head[COLUMNS_MAX], *field;
    int n = 0;
    char *at = csv->data, end = at ? ',' : '\0';
    thud_text_append(out, ",\n \"%s\": [", name);
    while (end == ',' && n < COLUMNS_MAX)
        end = thud_csv_field(&at, &head[n++]);
    for (bool first = true; at && *at; first = false) {
        thud_text_append(out, "%s\n  {", first ? "" : ",");
        end = ',';
        for (int k = 0; end == ',' && k < n; k++) {
            end = thud_csv_field(&at, &field);
            thud_text_append(out, k ? ", " : "");
            thud_json_string(out, head[k]);
            thud_text_append(out, ": ");
            put_value(field, out);
        }
        thud_text_append(out, "}");
    }
    thud_text_append(out, "]");
    out->failed |= csv->failed;
    thud_text_clear(csv);
}

void thud_rows_under(const char *name, const char *value, bool header, struct thud_text *csv, struct thud_text *out)
{
    const char *line = csv->data;
    for (bool first = true; line && *line; first = false) {
        bool quoted = false; /* a quoted field may go over several lines */
        size_t length = 0;
        for (; line[length] && (quoted || line[length] != '\n'); length++)
            quoted ^= line[length] == '"';
        if (!first || header) {
            thud_text_append(out, "%s,", first ? name : value);
            thud_text_bytes(out, line, length);
            thud_text_append(out, "\n");
        }
        line += length + (line[length] == '\n');
    }
    out->failed |= csv->failed;
    thud_text_clear(csv);
}

void thud_rows_files(const char *lines, struct thud_text *out)
{
    thud_text_append(out, ",\n \"files\": [");
    for (bool first = true; lines && *lines; first = false) {
        size_t length = strcspn(lines, "\n");
        char name[4200];
        size_t kept = length < sizeof name ? length : sizeof name - 1;
        memcpy(name, lines, kept);
        name[kept] = '\0';
        thud_text_append(out, first ? "" : ", ");
        thud_json_string(out, name);
        lines += length + (lines[length] == '\n');
    }
    thud_text_append(out, "]");
}
