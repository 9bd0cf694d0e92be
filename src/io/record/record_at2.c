/* PEER AT2: a few lines of text, among them `NPTS= 4000, DT= .01000 SEC` (or the numbers before the words), then g,
 * five to a line. */
#include <math.h>
#include <string.h>

#include "io/record/record_source.h"
#include "io/record/record_table.h"

enum { HEADER_MAX = 12 };

static bool is_count_line(const struct record_line *line)
{
    return record_find(line, "NPTS") && record_find(line, "DT");
}

static bool find_count_line(const struct record_source *source, struct record_cursor *cursor, struct record_line *line)
{
    *cursor = record_start(source);
    for (int i = 0; i < HEADER_MAX && record_next(cursor, line); i++) {
        const char *at = line->at;
        double value;
        /* a comment of a table may speak of npts and dt as well */
        if (line->length && strchr("#%;", line->at[0]))
            return false;
        if (is_count_line(line))
            return true;
        if (record_scan(&at, line->at + line->length, &value) == RECORD_NUMBER && i > 4)
            return false;
    }
    return false;
}

static bool recognize(const struct record_source *source)
{
    struct record_cursor cursor;
    struct record_line line;
    return source->skip <= 0 && find_count_line(source, &cursor, &line);
}

/* Both numbers before the words: `4000 0.0100 NPTS, DT`. */
static bool numbers_first(const struct record_line *line, double *count, double *dt)
{
    const char *s = line->at, *end = line->at + line->length;
    if (record_scan(&s, end, count) != RECORD_NUMBER)
        return false;
    while (s < end && *s == ',')
        s++;
    return record_scan(&s, end, dt) == RECORD_NUMBER;
}

/* "Event, date, station, component": the last part is the component, the one before it the station. */
static void read_title(struct record_raw *raw, const struct record_line *line)
{
    const char *end = line->at + line->length, *comma[2] = {NULL, NULL};
    for (const char *s = end; s > line->at && !comma[1]; s--)
        if (s[-1] == ',') {
            if (!comma[0])
                comma[0] = s;
            else
                comma[1] = s;
        }
    if (!comma[1]) {
        record_copy(raw->event, sizeof raw->event, line->at, end);
        return;
    }
    record_copy(raw->component, sizeof raw->component, comma[0], end);
    record_copy(raw->station, sizeof raw->station, comma[1], comma[0]);
    record_copy(raw->event, sizeof raw->event, line->at, comma[1]);
}

static enum thud_status read_header(const struct record_source *source, struct record_cursor *cursor,
                                    struct record_line *count_line, struct record_raw *raw, struct thud_error *err)
{
    struct record_line line;
    struct record_cursor at = record_start(source);
    struct record_prose prose = {0};
    if (!find_count_line(source, cursor, count_line))
        return record_refuse(source, 0, 0, err, "no line with NPTS and DT");
    for (int first = 1; record_next(&at, &line) && line.number < count_line->number; first = 0) {
        if ((record_find(&line, "VELOCITY") || record_find(&line, "DISPLACEMENT")) && !record_find(&line, "ACC") &&
            record_find(&line, "UNITS"))
            return record_refuse(source, line.number, 0, err,
                                 "this file holds velocities or displacements, not accelerations");
        if (first && !record_find(&line, "PEER"))
            record_copy(raw->event, sizeof raw->event, line.at, line.at + line.length);
        else if (line.number == 2 && !raw->event[0])
            read_title(raw, &line);
        record_prose_read(&prose, &line);
    }
    prose.dt_line = 0; /* the count line alone says it */
    record_prose_apply(&prose, raw);
    raw->factor_from_prose = false;
    return THUD_OK;
}

static enum thud_status read_at2(const struct record_source *source, const struct thud_record_choice *choice,
                                 struct record_raw *raw, struct thud_error *err)
{
    (void)choice;
    struct record_cursor cursor;
    struct record_line header, line;
    enum thud_status status = read_header(source, &cursor, &header, raw, err);
    if (status)
        return status;
    double stated, dt;
    if (!numbers_first(&header, &stated, &dt)) {
        stated = record_number_after(&header, "NPTS");
        dt = record_seconds_after(&header, "DT");
    }
    if (isnan(stated) || isnan(dt))
        return record_refuse(source, header.number, 0, err,
                             "no numbers with NPTS and DT, or DT in another unit than s, ms, us, min");
    size_t count;
    status = record_count(source, &header, stated, &count, err);
    raw->dt_s = dt;
    raw->dt_line = header.number;
    while (!status && record_next(&cursor, &line))
        status = record_add_line(raw, source, &line, 0, (size_t)-1, err);
    if (!status && raw->count != count) {
        record_refuse(source, header.number, 0, err, "the header states %zu samples, but the file contains %zu%s",
                      count, raw->count, raw->count < count ? " (cut off?)" : "");
        thud_error_allow(err, "`record.skip: %d` with `record.dt` and `record.unit` reads what is there",
                         header.number);
        return THUD_INPUT;
    }
    return status;
}

const struct record_format record_format_at2 = {"PEER AT2", false, recognize, read_at2};

/* ---- AT2 whose header was removed: known by its fields, 5E15.7 without a digit before the point or with one ---- */

static bool is_field(const char *at)
{
    const char *end = at + 15, *s = at;
    double value;
    if (record_scan(&s, end, &value) != RECORD_NUMBER || s != end)
        return false;
    return end[-4] == 'E' && end[-12] == '.';
}

static bool recognize_bare(const struct record_source *source)
{
    struct record_cursor cursor = record_start_data(source);
    struct record_line line;
    size_t lines = 0, last = 0;
    while (lines < 200 && record_next(&cursor, &line)) {
        if (line.length == 0)
            continue;
        if (line.length % 15 != 0 || line.length > 75 || (lines > 0 && last != 75))
            return false;
        for (size_t i = 0; i < line.length; i += 15)
            if (!is_field(line.at + i))
                return false;
        last = line.length;
        lines++;
    }
    return lines > 1;
}

static enum thud_status read_bare(const struct record_source *source, const struct thud_record_choice *choice,
                                  struct record_raw *raw, struct thud_error *err)
{
    (void)choice;
    struct record_cursor cursor = record_start(source);
    struct record_line line;
    struct record_prose prose = {0};
    enum thud_status status = THUD_OK;
    while (cursor.line < source->skip && record_next(&cursor, &line))
        record_prose_read(&prose, &line);
    record_prose_apply(&prose, raw);
    while (!status && record_next(&cursor, &line))
        status = record_add_line(raw, source, &line, 0, (size_t)-1, err);
    return status;
}

const struct record_format record_format_at2_bare = {"PEER AT2 without header", true, recognize_bare, read_bare};
