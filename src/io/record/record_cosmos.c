/* COSMOS V2: text, an integer header, a real header, comments, then `42000 acceleration pts, approx 210 secs,
 * units=cm/sec2(04),Format=(1E15.6)`. Each header announces how many lines it has and in which Fortran format. Real 62
 * is the sampling interval in ms. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
#include "io/record/record_source.h"
#include "io/record/record_table.h"

enum { REAL_INTERVAL = 61 };

static bool recognize(const struct record_source *source)
{
    struct record_cursor cursor = record_start(source);
    struct record_line line;
    for (int i = 0; i < 40 && record_next(&cursor, &line); i++)
        if (record_find(&line, "Integer-header values follow"))
            return true;
    return false;
}

/* Field width of `Format=(5F15.6)`; 0 when it is not of that kind. */
static size_t format_width(const struct record_line *line)
{
    const char *s = record_find(line, "Format"), *end = line->at + line->length;
    while (s && s < end && *s != '(')
        s++;
    if (!s || s >= end)
        return 0;
    for (s++; s < end && thud_ascii_is_digit(*s);)
        s++;
    if (s >= end || !strchr("FEGIfegi", *s) || !*s)
        return 0;
    size_t width = 0;
    for (s++; s < end && thud_ascii_is_digit(*s) && width < 100; s++)
        width = 10 * width + (size_t)(*s - '0');
    return width;
}

/* The lines a header announces, `follow on  20 lines`; values only when `list` is given. */
static enum thud_status read_header(struct record_cursor *cursor, const struct record_line *head,
                                    struct record_raw *list, struct thud_error *err)
{
    double lines = record_number_after(head, "follow on");
    if (!(lines >= 1) || lines > 1000)
        return record_refuse(cursor->source, head->number, 0, err,
                             "the number of lines of this header is not specified");
    struct record_line line;
    enum thud_status status = THUD_OK;
    for (int i = 0; i < (int)lines && !status; i++) {
        if (!record_next(cursor, &line))
            return record_refuse(cursor->source, cursor->line, 0, err, "the file ends in a header (cut off?)");
        if (list)
            status = record_add_line(list, cursor->source, &line, format_width(head), 64, err);
    }
    return status;
}

static bool begins_block(const struct record_line *line)
{
    return record_find(line, "pts") && record_find(line, "units=") && record_find(line, "Format");
}

static enum thud_status add_channel(const struct record_cursor *cursor, const struct record_line *line,
                                    double interval_ms, const char *name, struct record_channels *channels,
                                    struct thud_error *err)
{
    struct record_channel *channel = record_channel_add(channels, cursor, line, err);
    if (!channel)
        return THUD_INPUT;
    channel->width = format_width(line);
    channel->dt_s = interval_ms > 0 ? interval_ms / 1000 : NAN;
    memcpy(channel->name, name, sizeof channel->name);
    channel->factor = record_factor_at(record_find(line, "units=") + 6, line->at + line->length);
    return record_count(cursor->source, line, record_number_first(line), &channel->count, err);
}

/* What the text lines and the comments state about the channel: `Sta Chan 1: 360 deg`, `<SCNL>BMR.BNZ.AK.--`. */
static void read_name(const struct record_line *line, char name[64])
{
    const char *end = line->at + line->length, *s;
    if (record_begins(line, "Sta Chan") && (s = memchr(line->at, ':', line->length)) != NULL) {
        const char *stop = s + 1;
        while (stop < end && !(stop[0] == ' ' && (stop + 1 == end || stop[1] == ' ' || stop[1] == '(')) && *stop != '(')
            stop++;
        record_copy(name, 64, s + 1, stop);
    }
    if ((s = record_find(line, "<SCNL>")) != NULL) {
        const char *stop = s + 6;
        while (stop < end && *stop != ' ')
            stop++;
        record_copy(name, 64, s + 6, stop);
    }
}

static void read_text(const struct record_line *line, struct record_raw *raw)
{
    const char *end = line->at + line->length;
    if (line->number == 2)
        record_copy(raw->event, sizeof raw->event, line->at + (record_begins(line, "Record of ") ? 10 : 0), end);
    if (record_begins(line, "Statn No:")) {
        const char *code = record_find(line, "Code:");
        record_copy(raw->station, sizeof raw->station, code ? code + 5 : line->at + 9, end);
    }
}

static enum thud_status read_cosmos(const struct record_source *source, const struct thud_record_choice *choice,
                                    struct record_raw *raw, struct thud_error *err)
{
    struct record_channels channels = {.count = 0};
    struct record_cursor cursor = record_start(source);
    struct record_line line;
    struct record_raw reals = {0};
    char name[64] = "";
    double interval = 0;
    enum thud_status status = THUD_OK;
    while (!status && record_next(&cursor, &line)) {
        read_text(&line, raw);
        read_name(&line, name);
        if (record_find(&line, "Integer-header values follow"))
            status = read_header(&cursor, &line, NULL, err);
        else if (record_find(&line, "Real-header values follow")) {
            reals.count = 0;
            status = read_header(&cursor, &line, &reals, err);
            interval = !status && reals.count > REAL_INTERVAL ? reals.value[REAL_INTERVAL] : 0;
        } else if (begins_block(&line) && record_find(&line, "accel"))
            status = add_channel(&cursor, &line, interval, name, &channels, err);
    }
    free(reals.value);
    return status ? status : record_channels_read(source, &channels, choice, raw, err);
}

const struct record_format record_format_cosmos = {"COSMOS V2", false, recognize, read_cosmos};
