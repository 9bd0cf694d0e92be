#include "io/result/expectation_file.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"
#include "base/version.h"
#include "io/file/file.h"
#include "io/record/csv_lines.h"

enum { CASE, QUANTITY, VALUE, TOLERANCE, FIELDS };
enum { FILE_BYTES_MAX = 16 << 20 };
static const char header[] = "case,quantity,value,tolerance";

enum thud_status thud_expectation_path(const char *preset_path, char *path, size_t size, struct thud_error *err)
{
    static const char *const endings[] = {".yaml", ".yml"};
    size_t length = strlen(preset_path);
    for (size_t i = 0; i < sizeof endings / sizeof *endings; i++) {
        size_t tail = strlen(endings[i]);
        if (length > tail && strcmp(preset_path + length - tail, endings[i]) == 0) {
            length -= tail;
            break;
        }
    }
    int n = snprintf(path, size, "%.*s.expected.csv", (int)length, preset_path);
    return n >= 0 && (size_t)n < size ? THUD_OK : thud_error_set(err, THUD_INPUT, "the file's name is too long");
}

/* Where the i-th field of a line begins, from 1. */
static int column(const struct record_line *line, int i)
{
    bool quoted = false;
    size_t at = 0;
    for (; at < line->length && i > 0; at++) {
        if (line->at[at] == '"')
            quoted = !quoted;
        else if (line->at[at] == ',' && !quoted)
            i--;
    }
    return (int)at + 1;
}

static enum thud_status refuse(const struct csv_lines *lines, const struct record_line *line, int field,
                               const char *what, const char *allowed, struct thud_error *err)
{
    record_refuse(lines->cursor.source, lines->line, column(line, field), err, "\"%.60s\" %s",
                  csv_lines_field(lines, (size_t)field), what);
    thud_error_allow(err, "%s", allowed);
    return THUD_INPUT;
}

static enum thud_status number(const struct csv_lines *lines, const struct record_line *line, int field, double *out,
                               struct thud_error *err)
{
    const char *text = csv_lines_field(lines, (size_t)field), *end;
    text += strspn(text, " \t");
    int failed = thud_number_parse(text, &end, out);
    if (!*text)
        return refuse(lines, line, field, "is empty", "a number with a decimal point, in SI units", err);
    if (failed || end[strspn(end, " \t")] || !isfinite(*out))
        return refuse(lines, line, field, failed == -2 ? "is too large a number" : "is not a number",
                      "a number with a decimal point, in SI units", err);
    if (field == TOLERANCE && !(*out >= 0))
        return refuse(lines, line, field, "is below 0", "the largest relative change, 0 or more", err);
    return THUD_OK;
}

static bool has_control(const char *text)
{
    for (; *text; text++)
        if ((unsigned char)*text < ' ' || *text == 0x7f)
            return true;
    return false;
}

static enum thud_status add_expectation(const struct csv_lines *lines, const struct record_line *line,
                                        struct thud_expectations *out, struct thud_error *err)
{
    struct thud_expectation one = {.other = NAN};
    if (lines->fields != FIELDS) {
        record_refuse(lines->cursor.source, lines->line, 1, err, "%zu column%s, not %d", lines->fields,
                      lines->fields == 1 ? "" : "s", FIELDS);
        thud_error_allow(err, "%s, with commas between them and decimal points", header);
        return THUD_INPUT;
    }
    const char *name = thud_text_csv_plain(csv_lines_field(lines, QUANTITY));
    if (thud_case_find(csv_lines_field(lines, 0), &one.which, NULL) != THUD_OK)
        return refuse(lines, line, CASE, "is no case", "as-written, none, bumper, cavity", err);
    if (!*name || strlen(name) >= sizeof one.name || has_control(name))
        return refuse(lines, line, QUANTITY, "is not a quantity", "a name such as A.4.acceleration_mps2", err);
    snprintf(one.name, sizeof one.name, "%s", name);
    enum thud_status status = number(lines, line, VALUE, &one.value, err);
    if (status == THUD_OK)
        status = number(lines, line, TOLERANCE, &one.tolerance, err);
    return status == THUD_OK ? thud_expectations_add(out, &one, err) : status;
}

static enum thud_status read_rows(struct csv_lines *lines, struct thud_expectations *out, struct thud_error *err)
{
    struct record_line line;
    enum csv_what what = CSV_COMMENT;
    enum thud_status status = THUD_OK;
    for (bool first = true; status == THUD_OK && what != CSV_END;) {
        status = csv_lines_next(lines, &what, &line, err);
        if (status != THUD_OK || what != CSV_ROW)
            continue;
        bool is_header = first && lines->fields == FIELDS && strcmp(csv_lines_field(lines, 0), "case") == 0;
        first = false;
        if (!is_header)
            status = add_expectation(lines, &line, out, err);
    }
    if (status == THUD_OK && out->n == 0) {
        record_refuse(lines->cursor.source, 0, 0, err, "there is no expectation in it");
        thud_error_allow(err, "rows of %s", header);
        status = THUD_INPUT;
    }
    return status;
}

enum thud_status thud_expectation_parse(const char *text, size_t size, const char *name, struct thud_expectations *out,
                                        struct thud_error *err)
{
    struct record_source source = {.name = name, .text = text, .size = size};
    struct csv_lines lines;
    *out = (struct thud_expectations){0};
    if (size >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0) { /* the mark some editors put first */
        source.text += 3;
        source.size -= 3;
    }
    enum thud_status status = thud_text_check(source.text, source.size, name, err);
    if (status == THUD_OK)
        status = csv_lines_open(&lines, record_start(&source), ',', err);
    if (status != THUD_OK)
        return status;
    status = read_rows(&lines, out, err);
    csv_lines_close(&lines);
    if (status != THUD_OK)
        thud_expectations_clear(out);
    return status;
}

enum thud_status thud_expectation_read(const char *path, struct thud_expectations *out, struct thud_error *err)
{
    char *text;
    size_t size;
    *out = (struct thud_expectations){0};
    enum thud_status status = thud_file_read(path, FILE_BYTES_MAX, &text, &size, err);
    if (status != THUD_OK)
        return status;
    status = thud_expectation_parse(text, size, path, out, err);
    free(text);
    return status;
}

void thud_expectation_text(const struct thud_expectation_origin *origin, const struct thud_expectations *agreed,
                           const struct thud_expectations *disputed, struct thud_text *out)
{
    thud_text_append(out,
                     "# What `thud verify %s` expects, in SI units. Made by thud %s with --update.\n"
                     "# Values of %s (events located, tolerance %g), confirmed by %s (%s).\n"
                     "# tolerance: the largest relative change (absolute where 0 is expected), ten times the two\n"
                     "# methods' difference and at least 1e-6; 0: exactly.\n%s\n",
                     origin->preset, THUD_VERSION, origin->independent, origin->independent_tolerance, origin->own,
                     origin->own_setting, header);
    for (size_t i = 0; i < agreed->n; i++) {
        const struct thud_expectation *e = &agreed->item[i];
        thud_text_append(out, "%s,", thud_case_name(e->which));
        thud_text_csv(out, e->name);
        thud_text_append(out, ",%.10g,%.1g\n", e->value, e->tolerance);
    }
    if (disputed->n > 0)
        thud_text_append(out, "# Left out, because the two methods do not agree:\n");
    for (size_t i = 0; i < disputed->n; i++) {
        const struct thud_expectation *e = &disputed->item[i];
        thud_text_append(out, "# %s %s: %s %.10g, %s %.10g\n", thud_case_name(e->which), e->name, origin->own, e->value,
                         origin->independent, e->other);
    }
}
