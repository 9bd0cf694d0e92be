#include "io/building/building_cells.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
#include "base/quantity.h"
#include "io/file/file.h"

enum { BYTES_MAX = 1 << 22 };

double building_unit_stiffness(const char *unit, bool *inverse)
{
    enum thud_dimension dimension;
    char turned[40];
    const char *slash = strchr(unit, '/');
    double factor = thud_unit_factor(unit, &dimension, NULL);
    *inverse = false;
    if (factor > 0 && dimension == THUD_STIFFNESS)
        return factor;
    if (!slash || strlen(unit) >= sizeof turned)
        return 0;
    snprintf(turned, sizeof turned, "%s/%.*s", slash + 1, (int)(slash - unit), unit);
    factor = thud_unit_factor(turned, &dimension, NULL);
    *inverse = true;
    return factor > 0 && dimension == THUD_STIFFNESS ? 1 / factor : 0;
}

double building_unit_time(const char *unit)
{
    static const char *const seconds[] = {"s", "sec", "secs", "second", "seconds"};
    for (size_t i = 0; i < sizeof seconds / sizeof *seconds; i++)
        if (thud_ascii_same(unit, seconds[i]))
            return 1;
    return thud_ascii_same(unit, "ms") || thud_ascii_same(unit, "msec") ? 1e-3 : 0;
}

void building_cells_clear(struct building_cells *cells)
{
    for (int i = 0; i < cells->heads; i++)
        free(cells->head[i]);
    free(cells->value);
    free(cells->text);
    *cells = (struct building_cells){0};
}

/* The separator of the table: the first of these that stands in a line behind the comments; else a comma. */
static char separator_of(const struct record_source *source)
{
    struct record_cursor cursor = record_start(source);
    struct record_line line;
    char found = '\0';
    while (record_next(&cursor, &line))
        for (size_t i = 0; i < line.length && line.at[0] != '#'; i++)
            if (line.at[i] == ',')
                return ',';
            else if (!found && (line.at[i] == ';' || line.at[i] == '\t'))
                found = line.at[i];
    return found ? found : ',';
}

int building_cells_column(const struct building_cells *cells, int row, int column)
{
    struct record_cursor cursor = record_start(&cells->source);
    struct record_line line;
    const char separator = separator_of(&cells->source);
    while (record_next(&cursor, &line) && line.number < cells->line[row])
        ;
    bool quoted = false;
    for (size_t i = 0; i < line.length; i++) {
        if (column == 0)
            return (int)i + 1 + (int)strspn(line.at + i, " ");
        quoted = quoted != (line.at[i] == '"');
        column -= !quoted && line.at[i] == separator;
    }
    return (int)line.length + 1;
}

enum thud_status building_cells_refuse(const struct building_cells *cells, int row, int column, struct thud_error *err,
                                       const char *fmt, ...)
{
    char text[256];
    va_list list;
    va_start(list, fmt);
    vsnprintf(text, sizeof text, fmt, list);
    va_end(list);
    return record_refuse(&cells->source, row < 0 ? 0 : cells->line[row],
                         row < 0 || column < 0 ? 0 : building_cells_column(cells, row, column), err, "%s", text);
}

/* Keeps a unit that stands in a name: in brackets, behind the last underscore, or the whole of it. */
static enum thud_status keep_unit(struct building_cells *cells, const struct csv_lines *lines, const char *name,
                                  struct thud_error *err)
{
    char part[32];
    const char *open = strpbrk(name, "(["), *behind = strrchr(name, '_');
    const char *from = open ? open + 1 : behind ? behind + 1 : name;
    size_t length = open ? strcspn(from, ")]") : strlen(from);
    bool inverse;
    if (length == 0 || length >= sizeof part)
        return THUD_OK;
    snprintf(part, sizeof part, "%.*s", (int)length, from);
    bool stiffness = building_unit_stiffness(part, &inverse) > 0, time = building_unit_time(part) > 0;
    char *to = time ? cells->of_time : cells->unit;
    enum thud_dimension other;
    const bool some = (strchr(part, '/') || cells->heads > 0) && thud_unit_factor(part, &other, NULL) > 0;
    if (!stiffness && !time && !open && !some)
        return THUD_OK; /* a name without a unit */
    if (to[0] && strcmp(to, part) != 0 && !time) {
        record_refuse(&lines->cursor.source[0], lines->line, 1, err, "the header says the unit twice: %s and %s", to,
                      part);
        thud_error_allow(err, "one unit for all columns");
        return THUD_INPUT;
    }
    snprintf(to, sizeof cells->unit, "%s", part);
    cells->unit_line = lines->line;
    return THUD_OK;
}

/* A row of the header: names of the columns where it has as many as numbers will follow, and units. */
static enum thud_status read_head(struct building_cells *cells, const struct csv_lines *lines, struct thud_error *err)
{
    int filled = 0, units = 0;
    bool inverse;
    for (size_t i = 0; i < lines->fields; i++) {
        const char *name = csv_lines_field(lines, i);
        filled += *name != '\0';
        units += building_unit_stiffness(name, &inverse) > 0 || building_unit_time(name) > 0;
        enum thud_status status = keep_unit(cells, lines, name, err);
        if (status != THUD_OK)
            return status;
    }
    if (filled < 2 || (units > 0 && cells->heads > 0)) /* a title, or the row of units under the names */
        return THUD_OK;
    for (int i = 0; i < cells->heads; i++)
        free(cells->head[i]);
    cells->heads = 0;
    cells->head_line = lines->line;
    for (size_t i = 0; i < lines->fields; i++) {
        if (i + 1 == lines->fields && !*csv_lines_field(lines, i))
            break; /* a separator at the end of the line */
        char *name = strdup(csv_lines_field(lines, i));
        if (!name)
            return thud_error_set(err, THUD_MEMORY, "out of memory");
        cells->head[cells->heads++] = name;
    }
    return THUD_OK;
}

/* A cell: whether it is a number; a label is NaN. */
static bool read_cell(const char *text, double *out)
{
    const char *end;
    text += strspn(text, " ");
    *out = NAN;
    if (thud_number_parse(text, &end, out) != 0 || end[strspn(end, " ")]) {
        *out = NAN;
        return false;
    }
    return true;
}

/* A number with an imaginary part behind it. */
static bool is_complex(const char *text)
{
    size_t length = strlen(text);
    return length > 1 && strspn(text, "+-.0123456789eE iIjJ*") == length && strpbrk(text, "iIjJ") &&
           strpbrk(text, "0123456789");
}

/* What programs write where they have no number: no label of a row. */
static bool is_no_value(const char *text)
{
    static const char *const words[] = {"nan", "-nan", "inf", "-inf", "n/a", "#n/a"};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (thud_ascii_same(text + strspn(text, " "), words[i]))
            return true;
    return false;
}

static enum thud_status add_row(struct building_cells *cells, const struct csv_lines *lines, struct thud_error *err)
{
    int columns = (int)lines->fields;
    if (columns > 1 && !*csv_lines_field(lines, lines->fields - 1))
        columns--; /* a separator at the end of the line */
    if (cells->rows == CELLS_ROWS_MAX)
        return record_refuse(&cells->source, lines->line, 0, err, "more than %d rows", CELLS_ROWS_MAX);
    if (cells->rows == 0)
        cells->columns = columns;
    cells->line[cells->rows] = lines->line;
    if (cells->rows == 0 && columns < cells->heads) {
        record_refuse(&cells->source, lines->line, 0, err, "%d values in this row, %d names in the header", columns,
                      cells->heads);
        thud_error_allow(err, "a value under every name");
        return THUD_INPUT;
    }
    if (columns != cells->columns) {
        record_refuse(&cells->source, lines->line, 0, err, "%d values in this row, %d in the row before it", columns,
                      cells->columns);
        thud_error_allow(err, "the same number in every row");
        return THUD_INPUT;
    }
    double *more = realloc(cells->value, (size_t)(cells->rows + 1) * (size_t)columns * sizeof *cells->value);
    if (!more)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    cells->value = more;
    double *row = more + cells->rows++ * columns;
    bool numbers = false;
    for (int i = 0; i < columns; i++) {
        const char *text = csv_lines_field(lines, (size_t)i);
        bool number = read_cell(text, &row[i]);
        if (!number && is_complex(text)) {
            building_cells_refuse(cells, cells->rows - 1, i, err, "\"%.40s\" is complex", text);
            thud_error_allow(err, "the modes of the undamped building");
            return THUD_INPUT;
        }
        if (!number && (numbers || is_no_value(text))) {
            building_cells_refuse(cells, cells->rows - 1, i, err, "\"%.40s\" is not a number", text);
            thud_error_allow(err, "numbers behind the labels of a row");
            return THUD_INPUT;
        }
        numbers = numbers || number;
    }
    return THUD_OK;
}

/* Numbers that count by one behind a word: names of floors. */
static bool is_count(const struct csv_lines *lines)
{
    double value, before = NAN;
    bool counting = lines->fields > 2 && !read_cell(csv_lines_field(lines, 0), &value);
    for (size_t i = 1; i < lines->fields && counting; i++) {
        counting = read_cell(csv_lines_field(lines, i), &value) && (i == 1 || fabs(value - before) == 1);
        before = value;
    }
    return counting;
}

/* Whether the first row of numbers: behind a header any row with a number is one, else one without words behind its
 * first cell. */
static bool is_numbers(const struct building_cells *cells, const struct csv_lines *lines)
{
    double value;
    int numbers = 0, words = 0;
    for (size_t i = 0; i < lines->fields; i++) {
        const char *text = csv_lines_field(lines, i);
        bool number = read_cell(text, &value) || is_complex(text);
        numbers += number;
        words += !number && *text && i > 0;
    }
    return numbers > 0 && (cells->heads > 0 || (words == 0 && !is_count(lines)));
}

static enum thud_status read_rows(struct building_cells *cells, struct csv_lines *lines, struct thud_error *err)
{
    struct record_line line;
    enum csv_what what = CSV_COMMENT;
    enum thud_status status = THUD_OK;
    while (status == THUD_OK) {
        status = csv_lines_next(lines, &what, &line, err);
        if (status != THUD_OK || what == CSV_END)
            break;
        if (what == CSV_COMMENT)
            continue;
        if (cells->rows > 0 || is_numbers(cells, lines))
            status = add_row(cells, lines, err);
        else
            status = read_head(cells, lines, err);
    }
    return status;
}

enum thud_status building_cells_read(const char *path, struct building_cells *out, struct thud_error *err)
{
    struct csv_lines lines;
    *out = (struct building_cells){.source = {.name = path}};
    enum thud_status status = thud_text_read(path, BYTES_MAX, &out->text, err);
    if (status != THUD_OK)
        return status;
    out->source.text = out->text;
    out->source.size = strlen(out->text);
    status = csv_lines_open(&lines, record_start(&out->source), separator_of(&out->source), err);
    if (status == THUD_OK)
        status = read_rows(out, &lines, err);
    csv_lines_close(&lines);
    if (status == THUD_OK && out->rows == 0)
        status = record_refuse(&out->source, 0, 0, err, "there is no row of numbers");
    return status;
}
