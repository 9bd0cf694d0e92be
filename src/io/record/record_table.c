#include "io/record/record_table.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
#include "ground/identity.h"
#include "ground/record.h"

void record_table_clear(struct record_table *table)
{
    free(table->cells.value);
    free(table->lines.value);
    table->cells.value = table->lines.value = NULL;
}

bool record_is_comment(const struct record_line *line)
{
    return line->length > 0 && strchr("#%;", line->at[0]) != NULL;
}

bool record_table_first(const struct record_source *source, struct record_line *line)
{
    struct record_cursor cursor = record_start_data(source);
    for (int i = 0; i < 1000 && record_next(&cursor, line); i++) {
        bool digit = false, other = false;
        for (size_t k = 0; k < line->length && !other; k++) {
            digit = digit || thud_ascii_is_digit(line->at[k]);
            other = !line->at[k] || !strchr("0123456789+-.eEdD,; \t\"", line->at[k]);
        }
        if (digit && !other && !record_is_comment(line))
            return true;
    }
    return false;
}

enum thud_status record_table_row(struct record_table *table, const double *value, size_t count, int line,
                                  struct thud_error *err)
{
    if (count == 0)
        return THUD_OK;
    if (table->columns == 0)
        table->columns = table->in_last = count;
    if (table->in_last != table->columns || count > table->columns) {
        int odd = table->in_last != table->columns ? (int)table->lines.value[table->rows - 1] : line;
        size_t has = table->in_last != table->columns ? table->in_last : count;
        record_refuse(table->source, odd, 0, err, "%zu value%s in this line, %zu in the lines before it", has,
                      has == 1 ? "" : "s", table->columns);
        double samples = table->cells.value[0], dt = table->columns == 2 ? table->cells.value[1] : 0;
        if (samples > 0 && samples < 1 && dt >= 2) { /* the other way round */
            samples = dt;
            dt = table->cells.value[0];
        }
        if (table->columns == 2 && samples >= 2 && samples == floor(samples) && dt > 0 && dt < 1) {
            int first = (int)table->lines.value[0];
            thud_error_key(err, "skip");
            thud_error_allow(err,
                             "`record.skip: %d` and `record.dt: %g s` if line %d states %.0f samples, one every %g s",
                             first, dt, first, samples, dt);
        } else if (table->rows < 10 && count > table->columns) { /* a line of another kind before the samples */
            thud_error_key(err, "skip");
            thud_error_allow(err, "`record.skip: %d` when the samples begin here", odd - 1);
        }
        return THUD_INPUT;
    }
    enum thud_status status = record_add(&table->lines, line, err);
    for (size_t i = 0; i < count && !status; i++)
        status = record_add(&table->cells, value[i], err);
    table->in_last = count;
    table->rows++;
    return status;
}

static void keep(const struct record_line *line, const char *word, char *to, size_t size)
{
    const char *at = line->at, *end = line->at + line->length;
    while (at < end && strchr("#%; \t", *at))
        at++;
    struct record_line rest = {.at = at, .length = (size_t)(end - at)};
    size_t n = strlen(word);
    if (!to[0] && record_begins(&rest, word) && rest.length > n && (at[n] == ':' || at[n] == '='))
        record_copy(to, size, at + n + 1, end);
}

void record_table_prose(struct record_table *table, const struct record_line *line, struct record_raw *raw)
{
    record_prose_read(&table->prose, line);
    raw->synthetic = raw->synthetic || record_find(line, THUD_RECORD_COMPUTED);
    keep(line, "station", raw->station, sizeof raw->station);
    keep(line, "component", raw->component, sizeof raw->component);
    keep(line, "event", raw->event, sizeof raw->event);
    keep(line, "licence", raw->licence, sizeof raw->licence);
}

enum thud_status record_table_name(struct record_table *table, size_t i, const char *name, int line,
                                   struct thud_error *err)
{
    const char *word = name + (*name == '-' || *name == '+');
    if (thud_ascii_same(word, "nan") || thud_ascii_same(word, "inf") || thud_ascii_same(word, "infinity") ||
        (*word == '*' && strspn(word, "*") == strlen(word) && word[1]))
        return record_refuse(table->source, line, 0, err, "\"%.40s\" is not a number", name);
    if (i < TABLE_COLUMNS_MAX) {
        record_copy(table->name[i], sizeof table->name[i], name, name + strlen(name));
        table->names = i + 1;
        table->names_line = line;
    }
    return THUD_OK;
}

/* ---- names ---- */

static bool has_name(const struct record_table *table, size_t i)
{
    return table->names == table->columns && table->name[i][0];
}

static bool name_begins(const struct record_table *table, size_t i, const char *word, bool whole)
{
    size_t n = strlen(word);
    return has_name(table, i) && thud_ascii_begins(table->name[i], strlen(table->name[i]), word) &&
           (!whole || !thud_ascii_is_alnum(table->name[i][n]));
}

static bool name_is_time(const struct record_table *table, size_t i)
{
    return name_begins(table, i, "time", false) || name_begins(table, i, "t", true) ||
           name_begins(table, i, "sec", true) || name_begins(table, i, "seconds", true) ||
           (has_name(table, i) && strpbrk(table->name[i], "([") &&
            record_name_seconds(table->name[i], (char[TABLE_NAME_MAX]){0}, TABLE_NAME_MAX) > 0); /* Zeit (s) */
}

static bool name_is_other(const struct record_table *table, size_t i)
{
    return name_begins(table, i, "vel", false) || name_begins(table, i, "dis", false) ||
           name_begins(table, i, "v", true) || name_begins(table, i, "d", true) || name_begins(table, i, "u", true);
}

/* ---- time ---- */

static double cell(const struct record_table *table, size_t row, size_t column)
{
    return table->cells.value[row * table->columns + column];
}

/* The step of a column that climbs in equal steps, 0 when it does not; *odd is the first row that breaks it. Printing
 * rounds, so a fiftieth of a step is let pass. */
static double equal_step(const struct record_table *table, size_t column, size_t *odd)
{
    size_t rows = table->rows;
    *odd = 1;
    if (rows < 3)
        return 0;
    double first = cell(table, 0, column), step = (cell(table, rows - 1, column) - first) / (double)(rows - 1);
    double early = cell(table, 1, column) - first; /* tells where the steps change, not only that they do */
    for (size_t i = 1; i < rows; i++)
        if (!(fabs(cell(table, i, column) - (first + (double)i * step)) <= 0.02 * fabs(step))) {
            for (*odd = 1; *odd + 1 < rows; ++*odd)
                if (fabs(cell(table, *odd, column) - cell(table, *odd - 1, column) - early) > 0.02 * fabs(early))
                    break;
            return 0;
        }
    return step > 0 ? step : 0;
}

/* The number that was meant by one that was rounded. */
static double meant_by(double step)
{
    for (int digits = 1; digits < 16; digits++) {
        char text[40];
        snprintf(text, sizeof text, "%.*g", digits, step);
        double meant = strtod(text, NULL);
        if (fabs(meant - step) <= 1e-11 * step)
            return meant;
    }
    return step;
}

/* The time column from 0, or -1. */
static int time_column(const struct record_table *table, bool *by_name)
{
    *by_name = true;
    for (size_t i = 0; i < table->columns; i++)
        if (name_is_time(table, i))
            return (int)i;
    *by_name = false;
    size_t odd;
    return table->columns > 1 && !has_name(table, 0) && table->in_last == table->columns &&
                   equal_step(table, 0, &odd) > 0
               ? 0
               : -1;
}

static enum thud_status take_step(struct record_table *table, int column, bool by_name,
                                  const struct thud_record_choice *choice, struct record_raw *raw,
                                  struct thud_error *err)
{
    if (column < 0 || table->rows < 2)
        return THUD_OK;
    size_t odd;
    double step = equal_step(table, (size_t)column, &odd);
    if (step == 0 && table->rows == 2)
        step = cell(table, 1, (size_t)column) - cell(table, 0, (size_t)column);
    if (!(step > 0)) {
        if (!isnan(choice->dt_s) || !by_name)
            return THUD_OK;
        for (size_t i = 1; i < table->rows; i++)
            if (!(cell(table, i, (size_t)column) > cell(table, i - 1, (size_t)column)))
                return record_refuse(table->source, (int)table->lines.value[i], 0, err, "the times are not increasing");
        table->unequal = !isnan(choice->resample_s);
        if (!table->unequal) {
            record_refuse(table->source, (int)table->lines.value[odd], 0, err,
                          "the times do not increase in equal steps");
            thud_error_key(err, "resample");
            thud_error_allow(
                err, "`record.resample: 0.01 s` interpolates linearly; `record.dt` if the samples are equally spaced");
            return THUD_INPUT;
        }
    }
    char unknown[TABLE_NAME_MAX] = "";
    double factor =
        has_name(table, (size_t)column) ? record_name_seconds(table->name[column], unknown, sizeof unknown) : 1;
    if (factor == 0 && isnan(choice->dt_s) && !table->prose.dt_line) {
        record_refuse(table->source, table->names_line, 0, err,
                      "the unit of the times in the column \"%s\" is not known: give the time step with `record.dt`",
                      table->name[column]);
        thud_error_key(err, "dt");
        thud_error_allow(err, "s, ms, us, min in the name of the column, or `record.dt: 0.01 s`");
        return THUD_INPUT;
    }
    if (factor == 0)
        return THUD_OK;
    table->time_s = factor;
    if (table->unequal)
        return THUD_OK;
    step = meant_by(step * factor);
    double told =
        table->prose.dt_line ? table->prose.dt_s : step; /* a time column is rounded, a comment may have all digits */
    if (fabs(told - step) <= 1e-6 * step) {
        raw->dt_s = told;
        raw->dt_line = table->prose.dt_line ? table->prose.dt_line : (int)table->lines.value[0];
    } else if (isnan(choice->dt_s)) {
        record_refuse(table->source, table->prose.dt_line, 0, err,
                      "this line states a time step of %.6g s, the time column %.6g s", told, step);
        thud_error_key(err, "dt");
        thud_error_allow(err, "`record.dt` says which");
        return THUD_INPUT;
    }
    return THUD_OK;
}

/* ---- which column ---- */

static enum thud_status ask_column(const struct record_table *table, int time, struct thud_error *err)
{
    char list[360] = "";
    size_t n = 0;
    for (size_t i = 0; i < table->columns && n < sizeof list - 60; i++)
        n += (size_t)snprintf(list + n, sizeof list - n, "%s%zu%s%.40s", i ? ", " : ": ", i + 1,
                              has_name(table, i) ? " " : "",
                              (int)i == time && !has_name(table, i) ? " time"
                              : has_name(table, i)                  ? table->name[i]
                                                                    : "");
    record_refuse(table->source, (int)table->lines.value[0], 0, err,
                  "it is not specified which of the %zu columns is the acceleration%s", table->columns, list);
    thud_error_key(err, "column");
    if (time < 0)
        thud_error_allow(
            err, "`record.column: N`, or `record.column: all` when each line goes on where the one before ended");
    else
        thud_error_allow(err, "`record.column: N`, or `record.component: NS`");
    return THUD_INPUT;
}

static int only_candidate(const struct record_table *table, int time)
{
    int found = -1;
    for (size_t i = 0; i < table->columns; i++) {
        if ((int)i == time || name_is_other(table, i))
            continue;
        if (found >= 0)
            return -1;
        found = (int)i;
    }
    return found;
}

/* Whether a column is called so, with or without the unit that stands behind its name in brackets. */
static bool is_called(const char *name, const char *wanted)
{
    const size_t n = strlen(wanted);
    if (!thud_ascii_begins(name, strlen(name), wanted))
        return false;
    name += n + strspn(name + n, " ");
    return !*name || strchr("([", *name);
}

/* By the name that is wanted, or as the n-th of two horizontal components; -1: there is none. */
static int find_column(const struct record_table *table, const struct thud_record_choice *choice, int time)
{
    const char *wanted = choice->channel[0] ? choice->channel : choice->component;
    int horizontal = 0, at[2] = {-1, -1};
    for (int pass = 0; pass < 2; pass++)
        for (int i = 0; i < (int)table->columns && *wanted && !choice->part; i++)
            if (i != time && has_name(table, (size_t)i) &&
                (pass == 0             ? is_called(table->name[i], wanted)
                 : !choice->channel[0] ? thud_component_is(table->name[i], wanted)
                                       : false))
                return i;
    for (int i = 0; i < (int)table->columns; i++)
        if (i != time && !name_is_other(table, (size_t)i) &&
            !(has_name(table, (size_t)i) && thud_component_is_vertical(table->name[i])) && horizontal++ < 2)
            at[horizontal - 1] = i;
    return choice->part && horizontal == 2 ? at[choice->part - 1] : -1;
}

/* Several values to a line and a short line at the very end: no table ends so, a list does. A file that was cut off
 * lacks its last line end. */
static bool is_list(const struct record_table *table, int time)
{
    const struct record_source *source = table->source;
    char last = source->size ? source->text[source->size - 1] : 0;
    return table->columns > 2 && table->in_last < table->columns && table->rows > 2 && time < 0 &&
           !has_name(table, 0) && (last == '\n' || last == '\r');
}

/* *column from 0; -1: all of them, row by row. */
static enum thud_status choose(const struct record_table *table, const struct thud_record_choice *choice, int time,
                               int *column, struct thud_error *err)
{
    int line = (int)table->lines.value[0];
    if (choice->column > 0) {
        *column = choice->column - 1;
        if ((size_t)choice->column <= table->columns && *column != time)
            return THUD_OK;
        record_refuse(table->source, line, 0, err, *column == time ? "column %d is the time" : "there is no column %d",
                      choice->column);
        thud_error_key(err, "column");
        thud_error_allow(err, "1 to %zu", table->columns);
        return THUD_INPUT;
    }
    *column = find_column(table, choice, time);
    if (*column >= 0)
        return THUD_OK;
    if (choice->channel[0] || ((choice->component[0] || choice->part) && only_candidate(table, time) < 0)) {
        ask_column(table, time, err);
        thud_error_key(err, choice->channel[0] ? "channel" : "component");
        return THUD_INPUT;
    }
    *column = -1;
    if (choice->column < 0 || is_list(table, time))
        return THUD_OK;
    *column = only_candidate(table, time);
    return *column >= 0 ? THUD_OK : ask_column(table, time, err);
}

static enum thud_status take_column(struct record_table *table, int column, struct record_raw *raw,
                                    struct thud_error *err)
{
    if (column < 0) {
        free(raw->value);
        raw->value = table->cells.value;
        raw->count = table->cells.count;
        table->cells.value = NULL;
        return THUD_OK;
    }
    if (table->in_last != table->columns)
        return record_refuse(table->source, (int)table->lines.value[table->rows - 1], 0, err,
                             "%zu value%s in the last line, %zu in the lines before it (cut off?)", table->in_last,
                             table->in_last == 1 ? "" : "s", table->columns);
    enum thud_status status = THUD_OK;
    for (size_t i = 0; i < table->rows && !status; i++)
        status = record_add(raw, cell(table, i, (size_t)column), err);
    return status;
}

/* Straight between the samples, from the first time on. */
static enum thud_status resample(const struct record_table *table, int time, double dt, struct record_raw *raw,
                                 struct thud_error *err)
{
    struct record_raw even = {0};
    double first = cell(table, 0, (size_t)time),
           duration = (cell(table, table->rows - 1, (size_t)time) - first) * table->time_s;
    if (!(dt > 0) || dt > duration || duration / dt > 1e8) {
        record_refuse(table->source, 0, 0, err, "cannot be resampled at %g s", dt);
        thud_error_key(err, "resample");
        thud_error_allow(err, "above 0, at most %g s, and at most 1e8 samples", duration);
        return THUD_INPUT;
    }
    size_t samples = (size_t)floor(duration / dt + 1e-6) + 1, at = 0;
    enum thud_status status = THUD_OK;
    for (size_t i = 0; i < samples && !status; i++) {
        double t = fmin((double)i * dt, duration) / table->time_s + first;
        while (at + 2 < table->rows && cell(table, at + 1, (size_t)time) < t)
            at++;
        double t0 = cell(table, at, (size_t)time), t1 = cell(table, at + 1, (size_t)time);
        double part = fmin(1, (t - t0) / (t1 - t0));
        status = record_add(
            &even, part == 1 ? raw->value[at + 1] : (1 - part) * raw->value[at] + part * raw->value[at + 1], err);
    }
    if (status) {
        free(even.value);
        return status;
    }
    free(raw->value);
    raw->value = even.value;
    raw->count = even.count;
    raw->dt_s = dt;
    thud_append(raw->note, sizeof raw->note, "%s%zu samples in unequal steps", *raw->note ? ", " : "", table->rows);
    return THUD_OK;
}

enum thud_status record_table_finish(struct record_table *table, const struct thud_record_choice *choice,
                                     struct record_raw *raw, struct thud_error *err)
{
    if (table->rows == 0)
        return record_refuse(table->source, 0, 0, err, "there are no numbers in it");
    bool by_name = false;
    int column = -1, time = choice->column < 0 ? -1 : time_column(table, &by_name);
    enum thud_status status = choose(table, choice, time, &column, err);
    if (!status)
        status = take_step(table, time, by_name, choice, raw, err);
    if (status)
        return status;
    if (column >= 0 && only_candidate(table, time) < 0)
        raw->parts = (int)table->columns - (time >= 0);
    if (raw->parts > 1 && has_name(table, (size_t)column) && !raw->component[0])
        record_copy(raw->component, sizeof raw->component, table->name[column],
                    table->name[column] + strlen(table->name[column]));
    if (!isnan(choice->dt_s) && isnan(raw->dt_s))
        table->prose.dt_line = 0; /* the user has decided */
    if (column >= 0 && has_name(table, (size_t)column)) {
        double factor = record_name_unit(table->name[column], raw->unknown_unit, sizeof raw->unknown_unit);
        raw->factor_line = table->names_line;
        if (factor != 0)
            raw->factor = factor;
        if (raw->unknown_unit[0])
            table->prose.weight = 0; /* a comment is not to guess for it */
    }
    if (table->unequal)
        table->prose.dt_line = 0;
    record_prose_apply(&table->prose, raw);
    if (column < 0)
        snprintf(raw->note, sizeof raw->note, "%zu values to a line, row by row", table->columns);
    else if (time >= 0)
        snprintf(raw->note, sizeof raw->note, "column %d of %zu, times in column %d", column + 1, table->columns,
                 time + 1);
    else if (table->columns > 1)
        snprintf(raw->note, sizeof raw->note, "column %d of %zu", column + 1, table->columns);
    status = take_column(table, column, raw, err);
    return !status && table->unequal ? resample(table, time, choice->resample_s, raw, err) : status;
}
