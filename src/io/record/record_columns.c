/* Plain columns: numbers apart by blanks, tabs or signs; header and comment lines. */
#include <string.h>

#include "io/record/record_source.h"
#include "io/record/record_table.h"

static bool recognize(const struct record_source *source)
{
    struct record_line line;
    return record_table_first(source, &line) && !memchr(line.at, ',', line.length) &&
           !memchr(line.at, ';', line.length);
}

/* The numbers of a line; false with where and why when it holds something else. */
static bool numbers(const struct record_line *line, double *value, size_t *count, const char **at,
                    enum record_scan *scan)
{
    const char *end = line->at + line->length;
    *at = line->at;
    for (*count = 0; *count < TABLE_COLUMNS_MAX; ++*count) {
        *scan = record_scan(at, end, &value[*count]);
        if (*scan == RECORD_NONE)
            return true;
        if (*scan != RECORD_NUMBER)
            return false;
    }
    *scan = record_scan(at, end, &(double){0});
    return *scan == RECORD_NONE;
}

/* Names apart by tabs, else by blanks; what stands in brackets belongs to the name before it. */
static enum thud_status read_names(struct record_table *table, const struct record_line *line, struct thud_error *err)
{
    const char *end = line->at + line->length, *s = line->at;
    bool tabs = memchr(line->at, '\t', line->length) != NULL;
    enum thud_status status = THUD_OK;
    table->names = 0;
    for (size_t i = 0; s < end && i < TABLE_COLUMNS_MAX && !status; i++) {
        while (s < end && (*s == ' ' || *s == '\t'))
            s++;
        const char *stop = s;
        for (; stop < end && *stop != '\t' && (tabs || *stop != ' '); stop++)
            if (stop + 2 < end && stop[1] == ' ' && (stop[2] == '(' || stop[2] == '['))
                stop += 2;
        char name[TABLE_NAME_MAX];
        record_copy(name, sizeof name, s, stop);
        if (s < end)
            status = record_table_name(table, i, name, line->number, err);
        s = stop;
    }
    return status;
}

static enum thud_status read_line(struct record_table *table, const struct record_line *line, struct record_raw *raw,
                                  struct thud_error *err)
{
    if (line->length == 0)
        return THUD_OK;
    if (record_is_comment(line)) {
        record_table_prose(table, line, raw);
        return THUD_OK;
    }
    double value[TABLE_COLUMNS_MAX];
    size_t count;
    const char *at;
    enum record_scan scan;
    if (numbers(line, value, &count, &at, &scan))
        return record_table_row(table, value, count, line->number, err);
    if (scan == RECORD_NUMBER)
        return record_refuse(table->source, line->number, 0, err, "more than %d columns", TABLE_COLUMNS_MAX);
    if (table->rows > 0 || scan == RECORD_RANGE || scan == RECORD_TOUCHING)
        return record_refuse_scan(table->source, line, at, scan, err);
    record_table_prose(table, line, raw);
    return read_names(table, line, err);
}

static enum thud_status read_columns(const struct record_source *source, const struct thud_record_choice *choice,
                                     struct record_raw *raw, struct thud_error *err)
{
    struct record_table table = {.source = source};
    struct record_cursor cursor = record_start(source);
    struct record_line line;
    enum thud_status status = THUD_OK;
    while (!status && record_next(&cursor, &line)) {
        if (line.number <= source->skip)
            record_table_prose(&table, &line, raw);
        else
            status = read_line(&table, &line, raw, err);
    }
    if (!status)
        status = record_table_finish(&table, choice, raw, err);
    record_table_clear(&table);
    return status;
}

const struct record_format record_format_columns = {"plain columns", true, recognize, read_columns};
