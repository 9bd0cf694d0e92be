/* CDMG and CSMIP volume 2: per channel a text header, numbers, `3251 POINTS OF ACCEL DATA EQUALLY SPACED AT .020 SEC.
 * (UNITS: CM/SEC/SEC)`, the accelerations in 8F10.3, then velocities and displacements in the same way. */
#include <math.h>
#include <string.h>

#include "io/record/record_source.h"
#include "io/record/record_table.h"

static bool begins_block(const struct record_line *line)
{
    return record_find(line, "POINTS OF ACCEL DATA") && record_find(line, "EQUALLY SPACED");
}

static bool recognize(const struct record_source *source)
{
    struct record_cursor cursor = record_start(source);
    struct record_line line;
    for (int i = 0; i < 100 && record_next(&cursor, &line); i++)
        if (begins_block(&line))
            return true;
    return false;
}

/* `CHAN  1:  90 DEG` anywhere in a line; the rest of the line is its name. */
static void read_name(const struct record_line *line, char *number, size_t size, char *name, size_t name_size)
{
    const char *s = record_find(line, "CHAN"), *end = line->at + line->length;
    const char *colon = s ? memchr(s, ':', (size_t)(end - s)) : NULL;
    if (!colon || colon - s > 12)
        return;
    const char *stop = record_find(line, "FROM");
    record_copy(number, size, s + 4, colon);
    record_copy(name, name_size, colon + 1, stop && stop > colon ? stop : end);
}

static enum thud_status add_channel(const struct record_cursor *cursor, const struct record_line *line,
                                    const char number[16], const char name[64], struct record_channels *channels,
                                    struct thud_error *err)
{
    struct record_channel *channel = record_channel_add(channels, cursor, line, err);
    if (!channel)
        return THUD_INPUT;
    channel->width = 10;
    channel->dt_s = record_number_after(line, "SPACED AT");
    const char *unit = record_find(line, "UNITS:");
    if (unit)
        channel->factor = record_factor_at(unit + 6, line->at + line->length);
    memcpy(channel->number, number, sizeof channel->number);
    memcpy(channel->name, name, sizeof channel->name);
    return record_count(cursor->source, line, record_number_first(line), &channel->count, err);
}

static enum thud_status read_csmip(const struct record_source *source, const struct thud_record_choice *choice,
                                   struct record_raw *raw, struct thud_error *err)
{
    struct record_channels channels = {.count = 0};
    struct record_cursor cursor = record_start(source);
    struct record_line line;
    char number[16] = "", name[64] = "";
    bool named = false; /* this line is the station's name: it follows `STATION NO.`, of any number in a cut header */
    enum thud_status status = THUD_OK;
    while (!status && record_next(&cursor, &line)) {
        if (line.number <= 3 && record_find(&line, "EARTHQUAKE"))
            record_copy(raw->event, sizeof raw->event, line.at, line.at + line.length);
        if (named && !begins_block(&line))
            record_copy(raw->station, sizeof raw->station, line.at, line.at + line.length);
        named = record_begins(&line, "STATION NO.") && !raw->station[0];
        read_name(&line, number, sizeof number, name, sizeof name);
        if (begins_block(&line))
            status = add_channel(&cursor, &line, number, name, &channels, err);
    }
    return status ? status : record_channels_read(source, &channels, choice, raw, err);
}

const struct record_format record_format_csmip = {"CSMIP V2", false, recognize, read_csmip};
