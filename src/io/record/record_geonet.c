/* GeoNet V2A: per component 16 lines of text, ten of numbers, then accelerations in mm/s2 as 10F8.1, velocities and
 * displacements. */
#include <math.h>
#include <string.h>

#include "io/record/record_source.h"
#include "io/record/record_table.h"

enum { TEXT_LINES = 16, NUMBER_LINES = 10 };

static bool recognize(const struct record_source *source)
{
    struct record_cursor cursor = record_start(source);
    struct record_line line;
    bool interval = false, component = false;
    for (int i = 0; i < TEXT_LINES && record_next(&cursor, &line); i++) {
        if (i == 0 && !record_begins(&line, "Corrected accelerogram"))
            return false;
        interval = interval || record_begins(&line, "Instrument corrected data at");
        component = component || record_begins(&line, "Component ");
    }
    return interval && component;
}

static void read_text(const struct record_line *line, int k, struct record_channel *channel, double *count,
                      struct record_raw *raw)
{
    const char *end = line->at + line->length;
    if (k == 1 && record_begins(line, "Site "))
        record_copy(raw->station, sizeof raw->station, line->at + 5, line->length > 15 ? line->at + 15 : end);
    if (k == 7)
        record_copy(raw->event, sizeof raw->event, line->at, end);
    if (record_begins(line, "Number of points"))
        *count = record_number_after(line, "points");
    if (record_begins(line, "Instrument corrected data at"))
        channel->dt_s = record_number_after(line, "data at");
    if (record_begins(line, "Component ")) {
        const char *s = line->at + 10, *stop = s;
        while (stop < end && *stop != ' ')
            stop++;
        record_copy(channel->name, sizeof channel->name, s, stop);
    }
    if (record_begins(line, "Acceleration:")) {
        const char *peak = record_find(line, "peak"); /* its unit is that of the samples */
        if (peak && (peak += strlen("peak")) && !isnan(record_number_at(&peak, end)))
            channel->factor = record_factor_at(peak, end);
    }
}

static enum thud_status add_channel(struct record_cursor *cursor, const struct record_line *first,
                                    struct record_channels *channels, struct record_raw *raw, struct thud_error *err)
{
    struct record_channel *channel = record_channel_add(channels, cursor, first, err);
    if (!channel)
        return THUD_INPUT;
    struct record_line line = *first;
    double count = NAN;
    channel->width = 8;
    for (int k = 1; k < TEXT_LINES + NUMBER_LINES; k++) {
        if (!record_next(cursor, &line))
            return record_refuse(cursor->source, cursor->line, 0, err, "the file ends in a header (cut off?)");
        if (k < TEXT_LINES)
            read_text(&line, k, channel, &count, raw);
    }
    channel->cursor = *cursor;
    return record_count(cursor->source, first, count, &channel->count, err);
}

static enum thud_status read_geonet(const struct record_source *source, const struct thud_record_choice *choice,
                                    struct record_raw *raw, struct thud_error *err)
{
    struct record_channels channels = {.count = 0};
    struct record_cursor cursor = record_start(source);
    struct record_line line;
    enum thud_status status = THUD_OK;
    while (!status && record_next(&cursor, &line))
        if (record_begins(&line, "Corrected accelerogram"))
            status = add_channel(&cursor, &line, &channels, raw, err);
    return status ? status : record_channels_read(source, &channels, choice, raw, err);
}

const struct record_format record_format_geonet = {"GeoNet V2A", false, recognize, read_geonet};
