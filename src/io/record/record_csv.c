/* CSV: comma or semicolon, header and comment lines. */
#include <string.h>

#include "base/ascii.h"
#include "io/record/csv_lines.h"
#include "io/record/record_source.h"
#include "io/record/record_table.h"

static char separator(const struct record_source *source)
{
    struct record_line line;
    if (!record_table_first(source, &line))
        return 0;
    return memchr(line.at, ';', line.length) ? ';' : memchr(line.at, ',', line.length) ? ',' : 0;
}

static bool recognize(const struct record_source *source)
{
    return separator(source) != 0;
}

/* Where a comma stands between two digits, or NULL. */
static const char *comma_in_number(const char *s, const char *end)
{
    for (const char *c = s + 1; c + 1 < end; c++)
        if (*c == ',' && thud_ascii_is_digit(c[-1]) && thud_ascii_is_digit(c[1]))
            return c;
    return NULL;
}

static size_t commas(const struct record_line *line)
{
    size_t n = 0;
    for (size_t i = 0; i < line->length; i++)
        n += line->at[i] == ',';
    return n;
}

/* The line of names before the numbers has as many commas: they separate. */
static bool header_agrees(const struct record_source *source, const struct record_line *first)
{
    struct record_cursor cursor = record_start(source);
    struct record_line line;
    bool agrees = false;
    while (record_next(&cursor, &line) && line.number < first->number)
        if (line.length && !record_is_comment(&line))
            agrees = commas(&line) == commas(first);
    return agrees;
}

/* Between semicolons, numbers with a comma beside numbers with a point: 1,234 may be 1.234 or 1234. */
static bool mixes_signs(const struct record_source *source, int *where)
{
    struct record_line line;
    bool point = false;
    if (!record_table_first(source, &line))
        return false;
    struct record_cursor cursor = record_start(source);
    for (const int first = line.number; record_next(&cursor, &line);) {
        if (line.number < first || record_is_comment(&line) || line.length == 0)
            continue;
        point = point || memchr(line.at, '.', line.length);
        *where = *where == 0 && comma_in_number(line.at, line.at + line.length) ? line.number : *where;
        if (point && *where)
            return true;
    }
    return false;
}

/* The numbers' decimal sign is a comma where no semicolon parts them: `0,02 0,5`, or `0,5` alone with never a point in
 * sight. */
static bool decimal_comma(const struct record_source *source, char sep, const struct thud_record_choice *choice,
                          int *where)
{
    struct record_line line, first;
    if (sep == ';')
        return mixes_signs(source, where);
    if (!record_table_first(source, &first))
        return false;
    struct record_cursor cursor = record_start(source);
    bool whole = choice->column == 0 && !header_agrees(source, &first);
    for (int i = 0; i < first.number + 60 && record_next(&cursor, &line); i++) {
        if (line.number < first.number || record_is_comment(&line) || line.length == 0)
            continue;
        const char *end = line.at + line.length, *comma = comma_in_number(line.at, end);
        *where = comma && *where == 0 ? line.number : *where;
        const char *blank = comma ? memchr(comma, ' ', (size_t)(end - comma)) : NULL;
        if (!blank && comma)
            blank = memchr(comma, '\t', (size_t)(end - comma));
        if (blank && blank[-1] != ',' && comma_in_number(blank, end) && !memchr(line.at, '.', line.length))
            return true;
        whole = whole && commas(&line) % 2 == 1 && comma && !memchr(line.at, '.', line.length);
    }
    return whole && *where > 0;
}

static enum thud_status refuse_comma(const struct record_source *source, int line, struct thud_error *err)
{
    record_refuse(source, line, 0, err, "a comma for the decimal point");
    thud_error_allow(
        err,
        "write 0.5, not 0,5: `sed 's/,/./g'` where the comma is not the separator; `record.column: N` where it is");
    return THUD_INPUT;
}

/* The numbers of a row; false when one of its fields is no number (*bad). An empty field at the end is a separator too
 * many, and a comma between semicolons a decimal one. */
static bool numbers(const struct csv_lines *lines, double *value, size_t *count, size_t *bad, enum record_scan *scan)
{
    *count = lines->fields;
    while (*count > 0 && csv_lines_field(lines, *count - 1)[0] == '\0')
        --*count;
    for (*bad = 0; *bad < *count; ++*bad) {
        char plain[64];
        const char *at = csv_lines_field(lines, *bad);
        if (csv_get_delim((struct csv_parser *)&lines->parser) == ';' && strchr(at, ',') && strlen(at) < sizeof plain) {
            strcpy(plain, at);
            *strchr(plain, ',') = '.'; /* only one: 1,234,5 is no number */
            at = plain;
        }
        const char *end = at + strlen(at);
        *scan = record_scan(&at, end, &value[*bad]);
        double extra;
        if (*scan == RECORD_NUMBER && record_scan(&at, end, &extra) != RECORD_NONE)
            *scan = RECORD_WORD;
        if (*scan != RECORD_NUMBER)
            return false;
    }
    return true;
}

static enum thud_status read_row(struct record_table *table, const struct csv_lines *lines,
                                 const struct record_line *line, struct record_raw *raw, struct thud_error *err)
{
    double value[CSV_FIELDS_MAX];
    size_t count, bad;
    enum record_scan scan = RECORD_NONE;
    if (numbers(lines, value, &count, &bad, &scan))
        return record_table_row(table, value, count, lines->line, err);
    const char *word = csv_lines_field(lines, bad);
    if (table->rows > 0 || scan == RECORD_RANGE)
        return record_refuse(table->source, lines->line, 0, err,
                             scan == RECORD_RANGE ? "\"%.40s\" is too large a number"
                             : *word              ? "\"%.40s\" is not a number"
                                                  : "an empty field%s",
                             word);
    enum thud_status status = THUD_OK;
    table->names = 0;
    for (size_t i = 0; i < lines->fields && !status; i++)
        status = record_table_name(table, i, csv_lines_field(lines, i), lines->line, err);
    record_table_prose(table, line, raw);
    return status;
}

static enum thud_status read_rows(struct record_table *table, struct csv_lines *lines, struct record_raw *raw,
                                  struct thud_error *err)
{
    enum csv_what what = CSV_ROW;
    struct record_line line;
    enum thud_status status = THUD_OK;
    while (!status) {
        status = csv_lines_next(lines, &what, &line, err);
        if (status || what == CSV_END)
            break;
        if (what == CSV_COMMENT)
            record_table_prose(table, &line, raw);
        else
            status = read_row(table, lines, &line, raw, err);
    }
    return status;
}

static enum thud_status read_csv(const struct record_source *source, const struct thud_record_choice *choice,
                                 struct record_raw *raw, struct thud_error *err)
{
    char sep = separator(source);
    int where = 0;
    if (decimal_comma(source, sep, choice, &where))
        return refuse_comma(source, where, err);
    struct record_table table = {.source = source};
    struct record_cursor cursor = record_start(source);
    struct record_line line;
    while (cursor.line < source->skip && record_next(&cursor, &line))
        record_table_prose(&table, &line, raw);
    struct csv_lines lines;
    enum thud_status status = csv_lines_open(&lines, cursor, sep, err);
    if (status)
        return status;
    status = read_rows(&table, &lines, raw, err);
    csv_lines_close(&lines);
    if (!status)
        status = record_table_finish(&table, choice, raw, err);
    record_table_clear(&table);
    return status;
}

const struct record_format record_format_csv = {"CSV", true, recognize, read_csv};
