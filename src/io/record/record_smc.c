/* USGS SMC: 11 lines of text, 48 integers in 10 columns, 50 reals in 15, comments with `|`, samples in fields of 10,
 * cm/s2. */
#include <math.h>
#include <stdlib.h>

#include "io/record/record_source.h"

enum { TEXT_LINES = 11, INTEGERS = 48, REALS = 50, INTEGER_LINES = 6, REAL_LINES = 10 };
static const double unknown_integer = -32768, unknown_real = 1.7e38;

static bool recognize(const struct record_source *source)
{
    struct record_cursor cursor = record_start(source);
    struct record_line line;
    if (!record_next(&cursor, &line) || line.length < 3 || line.at[0] < '0' || line.at[0] > '9' || line.at[1] != ' ')
        return false;
    if (!record_find(&line, "CORRECTED") && !record_find(&line, "VELOCITY") && !record_find(&line, "DISPLACEMENT") &&
        !record_find(&line, "RESPONSE"))
        return false;
    for (int i = 1; i <= TEXT_LINES; i++)
        if (!record_next(&cursor, &line))
            return false;
    double value; /* the twelfth line is integers already */
    const char *at = line.at;
    return record_scan(&at, line.at + line.length, &value) == RECORD_NUMBER;
}

static enum thud_status read_text(const struct record_source *source, struct record_cursor *cursor,
                                  struct record_raw *raw, struct thud_error *err)
{
    struct record_line line;
    for (int i = 0; i < TEXT_LINES && record_next(cursor, &line); i++) {
        const char *end = line.at + line.length;
        if (i == 0 && !record_find(&line, "ACCELEROGRAM"))
            return record_refuse(source, 1, 0, err, "this SMC file holds no accelerations");
        if (i == 3)
            record_copy(raw->event, sizeof raw->event, line.at, end);
        const char *station = record_find(&line, "station ="), *component = record_find(&line, "component=");
        if (station)
            record_copy(raw->station, sizeof raw->station, station + 9, component ? component : end);
        if (component)
            record_copy(raw->component, sizeof raw->component, component + 10, end);
    }
    return THUD_OK;
}

static enum thud_status read_numbers(struct record_cursor *cursor, size_t width, int lines, size_t expected,
                                     double *value, struct thud_error *err)
{
    struct record_raw list = {0};
    struct record_line line;
    enum thud_status status = THUD_OK;
    for (int i = 0; i < lines && !status && record_next(cursor, &line); i++)
        status = record_add_line(&list, cursor->source, &line, width, 64, err);
    if (!status && list.count != expected)
        status = record_refuse(cursor->source, cursor->line, 0, err,
                               "%zu numbers in the header that ends here, not %zu", list.count, expected);
    for (size_t i = 0; !status && list.value && i < expected; i++)
        value[i] = list.value[i];
    free(list.value);
    return status;
}

static enum thud_status read_smc(const struct record_source *source, const struct thud_record_choice *choice,
                                 struct record_raw *raw, struct thud_error *err)
{
    (void)choice;
    struct record_cursor cursor = record_start(source);
    struct record_line line = {.number = TEXT_LINES + 3};
    double integer[INTEGERS] = {0}, real[REALS] = {0};
    enum thud_status status = read_text(source, &cursor, raw, err);
    if (!status)
        status = read_numbers(&cursor, 10, INTEGER_LINES, INTEGERS, integer, err);
    if (!status)
        status = read_numbers(&cursor, 15, REAL_LINES, REALS, real, err);
    size_t count = 0;
    if (!status)
        status = record_count(source, &line, integer[16], &count, err);
    if (status)
        return status;
    if (real[1] > 0 && real[1] < unknown_real / 2) {
        raw->dt_s = 1 / real[1];
        raw->dt_line = TEXT_LINES + INTEGER_LINES + 1;
    }
    raw->factor = 0.01;
    raw->factor_line = 1;
    double stated = integer[15] == unknown_integer ? 0 : integer[15];
    int comments = (int)fmin(fmax(stated, 0), 1e6);
    for (int i = 0; i < comments; i++)
        if (!record_next(&cursor, &line) || line.length == 0 || line.at[0] != '|')
            return record_refuse(source, cursor.line, 0, err,
                                 "the header states %d comment lines with `|`, but this is not one", comments);
    return record_add_block(raw, &cursor, 10, count, err);
}

const struct record_format record_format_smc = {"USGS SMC", false, recognize, read_smc};
