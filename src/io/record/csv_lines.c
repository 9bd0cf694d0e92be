#include "io/record/csv_lines.h"

#include <string.h>

static void end_field(void *text, size_t size, void *data)
{
    struct csv_lines *lines = data;
    if (lines->fields == CSV_FIELDS_MAX) {
        lines->many = true;
        return;
    }
    lines->field[lines->fields++] = lines->row.size;
    thud_text_bytes(&lines->row, text, size);
    thud_text_bytes(&lines->row, "", 1);
}

static void end_row(int end, void *data)
{
    (void)end;
    ((struct csv_lines *)data)->done = true;
}

enum thud_status csv_lines_open(struct csv_lines *lines, struct record_cursor cursor, char separator,
                                struct thud_error *err)
{
    memset(lines, 0, sizeof *lines);
    lines->cursor = cursor;
    if (csv_init(&lines->parser, CSV_STRICT | CSV_STRICT_FINI) != 0)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    csv_set_delim(&lines->parser, (unsigned char)separator);
    return THUD_OK;
}

void csv_lines_close(struct csv_lines *lines)
{
    csv_free(&lines->parser);
    thud_text_clear(&lines->row);
}

const char *csv_lines_field(const struct csv_lines *lines, size_t i)
{
    return lines->row.data + lines->field[i];
}

static enum thud_status refuse(const struct csv_lines *lines, struct thud_error *err)
{
    if (lines->row.failed || csv_error((struct csv_parser *)&lines->parser) == CSV_ENOMEM)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    record_refuse(lines->cursor.source, lines->line, 0, err,
                  lines->many ? "more than %d columns" : "a quotation mark is inside a field or is unmatched",
                  CSV_FIELDS_MAX);
    return THUD_INPUT;
}

static bool feed(struct csv_lines *lines, const char *text, size_t size)
{
    return csv_parse(&lines->parser, text, size, end_field, end_row, lines) == size && !lines->row.failed &&
           !lines->many;
}

enum thud_status csv_lines_next(struct csv_lines *lines, enum csv_what *what, struct record_line *line,
                                struct thud_error *err)
{
    lines->fields = 0;
    lines->row.size = 0;
    lines->done = false;
    lines->line = 0;
    while (!lines->done) {
        if (!record_next(&lines->cursor, line)) {
            *what = CSV_END;
            int open = lines->line && csv_fini(&lines->parser, end_field, end_row, lines) != 0;
            return open ? refuse(lines, err) : THUD_OK;
        }
        if (!lines->line && line->length == 0)
            continue;
        const char *comments = csv_get_delim(&lines->parser) == ';' ? "#%" : "#%;"; /* ";;x" has empty cells */
        if (!lines->line && strchr(comments, line->at[0])) {
            *what = CSV_COMMENT;
            return THUD_OK;
        }
        if (!lines->line)
            lines->line = line->number;
        if (!feed(lines, line->at, line->length) || !feed(lines, "\n", 1))
            return refuse(lines, err);
    }
    *what = CSV_ROW;
    return THUD_OK;
}
