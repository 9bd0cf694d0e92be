/* ESM and ITACA ASCII: `KEY: value` lines, then a value per line. */
#include <math.h>
#include <string.h>

#include "base/ascii.h"
#include "io/record/record_source.h"
#include "io/record/record_table.h"

/* A key is capitals, digits, `_`, `/` and `^` up to a colon. */
static const char *colon(const struct record_line *line)
{
    for (size_t i = 0; i < line->length; i++) {
        char c = line->at[i];
        if (c == ':')
            return i ? line->at + i : NULL;
        if (!thud_ascii_is_upper(c) && !thud_ascii_is_digit(c) && !strchr("_/^", c))
            return NULL;
    }
    return NULL;
}

static bool recognize(const struct record_source *source)
{
    struct record_cursor cursor = record_start(source);
    struct record_line line;
    bool interval = false, count = false;
    for (int i = 0; i < 80 && record_next(&cursor, &line) && colon(&line); i++) {
        interval = interval || record_begins(&line, "SAMPLING_INTERVAL_S:");
        count = count || record_begins(&line, "NDATA:");
    }
    return interval && count;
}

static bool value_of(const struct record_line *line, const char *word, char *to, size_t size)
{
    if (!record_begins(line, word))
        return false;
    record_copy(to, size, line->at + strlen(word), line->at + line->length);
    return true;
}

static enum thud_status read_key(const struct record_source *source, const struct record_line *line,
                                 struct record_raw *raw, double *count, struct thud_error *err)
{
    char text[64];
    value_of(line, "EVENT_NAME:", raw->event, sizeof raw->event);
    value_of(line, "STREAM:", raw->component, sizeof raw->component);
    value_of(line, "STATION_CODE:", raw->station, sizeof raw->station);
    if (record_begins(line, "SAMPLING_INTERVAL_S:")) {
        raw->dt_s = record_number_after(line, ":");
        raw->dt_line = line->number;
    }
    if (record_begins(line, "NDATA:"))
        *count = record_number_after(line, ":");
    if (value_of(line, "UNITS:", text, sizeof text) && text[0]) {
        raw->factor = record_unit(text);
        raw->factor_line = line->number;
        if (raw->factor == 0)
            return record_refuse(source, line->number, 0, err, "\"%s\" is not a unit of acceleration", text);
    }
    if (value_of(line, "DATA_TYPE:", text, sizeof text) && text[0] && strcmp(text, "ACCELERATION") != 0)
        return record_refuse(source, line->number, 0, err, "this file holds \"%s\", not accelerations", text);
    return THUD_OK;
}

static enum thud_status read_esm(const struct record_source *source, const struct thud_record_choice *choice,
                                 struct record_raw *raw, struct thud_error *err)
{
    (void)choice;
    struct record_cursor cursor = record_start(source), before = cursor;
    struct record_line line;
    double stated = NAN;
    enum thud_status status = THUD_OK;
    while (!status && record_next(&cursor, &line) && (colon(&line) || line.length == 0)) {
        status = read_key(source, &line, raw, &stated, err);
        before = cursor;
    }
    size_t count = 0;
    if (!status)
        status = record_count(source, &line, stated, &count, err);
    while (!status && record_next(&before, &line))
        status = record_add_line(raw, source, &line, 0, (size_t)-1, err);
    if (!status && raw->count != count)
        return record_refuse(source, before.line, 0, err, "the header states %zu samples, but the file contains %zu%s",
                             count, raw->count, raw->count < count ? " (cut off?)" : "");
    return status;
}

const struct record_format record_format_esm = {"ESM", false, recognize, read_esm};
