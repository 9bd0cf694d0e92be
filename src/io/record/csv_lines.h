/* libcsv, fed line by line: it counts no lines and knows no comments, and a stray quote would eat the rest of a file.
 */
#pragma once

#include <csv.h>
#include <stdbool.h>
#include <stddef.h>

#include "base/text.h"
#include "io/record/record_source.h"

enum { CSV_FIELDS_MAX = 256 };

struct csv_lines {
    struct csv_parser parser;
    struct record_cursor cursor;
    struct thud_text row;         /* each field with a NUL */
    size_t field[CSV_FIELDS_MAX]; /* where each begins */
    size_t fields;
    int line; /* where the row begins */
    bool done, many;
};

enum thud_status csv_lines_open(struct csv_lines *lines, struct record_cursor cursor, char separator,
                                struct thud_error *err);
void csv_lines_close(struct csv_lines *lines);

/* The next row or comment. `*what`: CSV_ROW, CSV_COMMENT (the line as it stands in *line) or CSV_END. Blank lines are
 * passed over. Errors: THUD_INPUT with the line, THUD_MEMORY. */
enum csv_what { CSV_ROW, CSV_COMMENT, CSV_END };
enum thud_status csv_lines_next(struct csv_lines *lines, enum csv_what *what, struct record_line *line,
                                struct thud_error *err);
const char *csv_lines_field(const struct csv_lines *lines, size_t i);
