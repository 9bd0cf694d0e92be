/* K-NET and KiK-net ASCII: a header of fixed words, integer counts, `Scale Factor 3920(gal)/6182761`; the mean is the
 * sensor's offset. */
#include <math.h>
#include <string.h>

#include "io/record/record_source.h"

/* The value of `Dir.`: words at K-NET, a number of the sensor at KiK-net. */
static bool recognize_either(const struct record_source *source, bool *number)
{
    struct record_cursor cursor = record_start(source);
    struct record_line line;
    if (!record_next(&cursor, &line) || !record_begins(&line, "Origin Time"))
        return false;
    *number = false;
    for (int i = 0; i < 20 && record_next(&cursor, &line); i++) {
        if (record_begins(&line, "Dir."))
            *number = !isnan(record_number_after(&line, "Dir."));
        if (record_begins(&line, "Scale Factor"))
            return true;
    }
    return false;
}

static bool recognize_knet(const struct record_source *source)
{
    bool number;
    return recognize_either(source, &number) && !number;
}

static bool recognize_kiknet(const struct record_source *source)
{
    bool number;
    return recognize_either(source, &number) && number;
}

/* What stands behind the word, without its blanks. */
static void value_of(const struct record_line *line, const char *word, char *to, size_t size)
{
    if (!to[0] && record_begins(line, word))
        record_copy(to, size, line->at + strlen(word), line->at + line->length);
}

static enum thud_status read_scale(const struct record_source *source, const struct record_line *line,
                                   struct record_raw *raw, struct thud_error *err)
{
    double top = record_number_after(line, "Scale Factor"), bottom = record_number_after(line, "/");
    if (!record_find(line, "(gal)") || !(top > 0) || !(bottom > 0))
        return record_refuse(source, line->number, 0, err, "the scale factor is not of the form 3920(gal)/6182761");
    raw->factor = top / bottom * 0.01;
    raw->factor_line = line->number;
    return THUD_OK;
}

static enum thud_status read_header(const struct record_source *source, struct record_cursor *cursor,
                                    struct record_raw *raw, double *duration, struct thud_error *err)
{
    struct record_line line;
    while (record_next(cursor, &line)) {
        value_of(&line, "Origin Time", raw->event, sizeof raw->event);
        value_of(&line, "Station Code", raw->station, sizeof raw->station);
        value_of(&line, "Dir.", raw->component, sizeof raw->component);
        if (record_begins(&line, "Duration Time"))
            *duration = record_number_after(&line, "(s)");
        if (record_begins(&line, "Sampling Freq")) {
            double rate = record_number_after(&line, "(Hz)");
            if (!(rate > 0))
                return record_refuse(source, line.number, 0, err, "no sampling frequency");
            raw->dt_s = 1 / rate;
            raw->dt_line = line.number;
        }
        if (record_begins(&line, "Scale Factor")) {
            enum thud_status status = read_scale(source, &line, raw, err);
            if (status)
                return status;
        }
        if (record_begins(&line, "Memo"))
            return THUD_OK;
    }
    return record_refuse(source, cursor->line, 0, err, "the header does not end in a line \"Memo.\"");
}

static enum thud_status read_knet(const struct record_source *source, const struct thud_record_choice *choice,
                                  struct record_raw *raw, struct thud_error *err)
{
    (void)choice;
    struct record_cursor cursor = record_start(source);
    struct record_line line;
    double duration = NAN;
    enum thud_status status = read_header(source, &cursor, raw, &duration, err);
    while (!status && record_next(&cursor, &line))
        status = record_add_line(raw, source, &line, 0, (size_t)-1, err);
    if (status)
        return status;
    if (isfinite(duration) && !isnan(raw->dt_s) && fabs((double)raw->count * raw->dt_s - duration) > 1)
        return record_refuse(source, cursor.line, 0, err,
                             "the header states %g s, but the file contains %zu samples, %g s (cut off?)", duration,
                             raw->count, (double)raw->count * raw->dt_s);
    raw->remove_mean = true;
    strcpy(raw->note, "mean removed");
    return THUD_OK;
}

const struct record_format record_format_knet = {"K-NET", false, recognize_knet, read_knet};
const struct record_format record_format_kiknet = {"KiK-net", false, recognize_kiknet, read_knet};
