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

double building_unit(const char *unit, enum thud_dimension dimension)
{
    static const char *const words[][2] = {{"kn", "kN"},  {"kip", "kip"},  {"kips", "kip"},  {"tonf", "tonf"},
                                           {"lb", "lbf"}, {"lbf", "lbf"},  {"kgf", "kgf"},   {"sec", "s"},
                                           {"secs", "s"}, {"second", "s"}, {"seconds", "s"}, {"msec", "ms"}};
    enum thud_dimension is = THUD_NUMBER;
    double factor = thud_unit_factor(unit, &is, NULL);
    for (size_t i = 0; i < sizeof words / sizeof *words && !(factor > 0 && is == dimension); i++) {
        char text[48];
        const size_t length = strlen(words[i][0]);
        if (!thud_ascii_begins(unit, strlen(unit), words[i][0]) || thud_ascii_is_alpha(unit[length]))
            continue;
        snprintf(text, sizeof text, "%s%.30s", words[i][1], unit + length);
        factor = thud_unit_factor(text, &is, NULL);
    }
    return factor > 0 && is == dimension ? factor : 0;
}

double building_unit_stiffness(const char *unit, bool *inverse)
{
    char turned[40];
    const char *slash = strchr(unit, '/');
    double factor = building_unit(unit, THUD_STIFFNESS);
    *inverse = !(factor > 0) && slash && strlen(unit) < sizeof turned;
    if (!*inverse)
        return factor;
    snprintf(turned, sizeof turned, "%s/%.*s", slash + 1, (int)(slash - unit), unit);
    factor = building_unit(turned, THUD_STIFFNESS);
    return factor > 0 ? 1 / factor : 0;
}

void building_cells_clear(struct building_cells *cells)
{
    for (int i = 0; i < cells->heads; i++)
        free(cells->head[i]);
    free(cells->value);
    free(cells->text);
    *cells = (struct building_cells){0};
}

/* How a line is parted, outside quotes. */
static int count_in(const struct record_line *line, char separator)
{
    int n = 0;
    bool quoted = false;
    for (size_t i = 0; i < line->length; i++) {
        quoted = quoted != (line->at[i] == '"');
        n += !quoted && line->at[i] == separator;
    }
    return n;
}

/* The separator of the table: what stands in most of its lines; a comma among semicolons is a decimal one. */
static char separator_of(const struct record_source *source)
{
    static const char candidates[] = {';', '\t', ','};
    int lines[3] = {0}, most = 0;
    struct record_cursor cursor = record_start(source);
    struct record_line line;
    while (record_next(&cursor, &line))
        for (int i = 0; i < 3 && line.length > 0 && line.at[0] != '#'; i++)
            lines[i] += count_in(&line, candidates[i]) > 0;
    for (int i = 1; i < 3; i++)
        most = lines[i] > lines[most] ? i : most;
    return lines[most] > 0 ? candidates[most] : ',';
}

/* Whether numbers have a decimal comma: a comma between digits, and no point behind one, where none parts the cells. */
static bool has_decimal_commas(const struct building_cells *cells)
{
    bool found = false;
    const char *at = cells->separator == ',' ? NULL : strchr(cells->text, ',');
    for (; at; at = strchr(at + 1, ',')) {
        if (at == cells->text || !thud_ascii_is_digit(at[-1]) || !thud_ascii_is_digit(at[1]))
            continue;
        if (at[1 + strspn(at + 1, "0123456789")] == '.')
            return false;
        found = true;
    }
    return found;
}

int building_cells_place(const struct building_cells *cells, int number, int column)
{
    struct record_cursor cursor = record_start(&cells->source);
    struct record_line line;
    while (record_next(&cursor, &line) && line.number < number)
        ;
    bool quoted = false;
    for (size_t i = 0; i < line.length; i++) {
        if (column == 0)
            return (int)i + 1 + (int)strspn(line.at + i, " ");
        quoted = quoted != (line.at[i] == '"');
        column -= !quoted && line.at[i] == cells->separator;
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
                         row < 0 || column < 0 ? 0 : building_cells_place(cells, cells->line[row], column), err, "%s",
                         text);
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
    bool stiffness = building_unit_stiffness(part, &inverse) > 0, time = building_unit(part, THUD_TIME) > 0;
    char *to = time ? cells->of_time : cells->unit;
    enum thud_dimension other;
    const bool some = (strchr(part, '/') || cells->heads > 0) && thud_unit_factor(part, &other, NULL) > 0;
    if (!stiffness && !time && !open && !some)
        return THUD_OK; /* a name without a unit */
    if (to[0] && strcmp(to, part) != 0 && !time) {
        record_refuse(&lines->cursor.source[0], lines->line, 1, err, "the header states the unit twice: %s and %s", to,
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
        units += building_unit_stiffness(name, &inverse) > 0 || building_unit(name, THUD_TIME) > 0;
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

/* Marks of thousands go, if three digits stand behind each; a decimal comma becomes a point. */
bool building_cells_number(const struct building_cells *cells, const char *text, double *out)
{
    const char thousands = cells->decimal_comma ? '.' : ',', *end;
    char plain[64];
    size_t n = 0;
    text += strspn(text, " ");
    *out = NAN;
    for (; *text && n + 1 < sizeof plain; text++) {
        plain[n] = '\0'; /* of 0.001 the point is none */
        const bool mark = *text == thousands && strspn(plain, "+-0") < n && strspn(text + 1, "0123456789") == 3;
        if (!mark)
            plain[n++] = *text == ',' && cells->decimal_comma ? '.' : *text;
    }
    plain[n] = '\0';
    if (!*text && thud_number_parse(plain, &end, out) == 0 && !end[strspn(end, " ")])
        return true;
    *out = NAN;
    return false;
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
        bool number = building_cells_number(cells, text, &row[i]);
        if (!number && is_complex(text)) {
            building_cells_refuse(cells, cells->rows - 1, i, err, "\"%.40s\" is complex", text);
            thud_error_allow(err, "the modes of the undamped building");
            return THUD_INPUT;
        }
        if (!number && (numbers || is_no_value(text))) {
            building_cells_refuse(cells, cells->rows - 1, i, err, "\"%.40s\" is not a number", text);
            thud_error_allow(err, "numbers after the labels of a row");
            return THUD_INPUT;
        }
        numbers = numbers || number;
    }
    return THUD_OK;
}

/* Numbers that count by one behind a word: names of floors. */
static bool is_count(const struct building_cells *cells, const struct csv_lines *lines)
{
    double value, before = NAN;
    bool counting = lines->fields > 2 && !building_cells_number(cells, csv_lines_field(lines, 0), &value);
    for (size_t i = 1; i < lines->fields && counting; i++) {
        counting =
            building_cells_number(cells, csv_lines_field(lines, i), &value) && (i == 1 || fabs(value - before) == 1);
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
        bool number = building_cells_number(cells, text, &value) || is_complex(text);
        numbers += number;
        words += !number && *text && i > 0;
    }
    return numbers > 0 && (cells->heads > 0 || (words == 0 && !is_count(cells, lines)));
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

enum thud_status building_cells_open(const char *path, struct building_cells *out, struct thud_error *err)
{
    *out = (struct building_cells){.source = {.name = path}};
    enum thud_status status = thud_text_read(path, BYTES_MAX, &out->text, err);
    if (status != THUD_OK)
        return status;
    /* lb-s2/ft, raised, of a sheet that is no UTF-8, in which no such byte follows ASCII */
    for (char *c = out->text; (c = strchr(c, '\xb2')) != NULL; c++)
        if (c == out->text || (c[-1] & 0x80) == 0)
            *c = '2';
    if (thud_ascii_begins(out->text, strlen(out->text), "TABLE:")) /* a title, whose quotes are no CSV */
        out->text[0] = '#';
    out->source.text = out->text;
    out->source.size = strlen(out->text);
    out->separator = separator_of(&out->source);
    out->decimal_comma = has_decimal_commas(out);
    return THUD_OK;
}

enum thud_status building_cells_read(const char *path, struct building_cells *out, struct thud_error *err)
{
    struct csv_lines lines;
    enum thud_status status = building_cells_open(path, out, err);
    if (status != THUD_OK)
        return status;
    status = csv_lines_open(&lines, record_start(&out->source), out->separator, err);
    if (status == THUD_OK)
        status = read_rows(out, &lines, err);
    csv_lines_close(&lines);
    if (status == THUD_OK && out->rows == 0)
        status = record_refuse(&out->source, 0, 0, err, "there is no row of numbers");
    return status;
}
