#include "io/record/record_source.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/ascii.h"
#include "ground/identity.h"

struct record_channel *record_channel_add(struct record_channels *channels, const struct record_cursor *cursor,
                                          const struct record_line *line, struct thud_error *err)
{
    if (channels->count == RECORD_CHANNELS_MAX) {
        record_refuse(cursor->source, line->number, 0, err, "more than %d channels", RECORD_CHANNELS_MAX);
        return NULL;
    }
    struct record_channel *channel = &channels->of[channels->count++];
    *channel = (struct record_channel){.cursor = *cursor, .line = line->number, .dt_s = NAN, .factor = NAN};
    return channel;
}

/* By what the file calls it (`N28W`, `90 DEG`, or its first word `90`), then by its number. */
static int find(const struct record_channels *channels, const char *wanted)
{
    char place[16];
    for (int pass = 0; pass < 5; pass++)
        for (int i = 0; i < channels->count; i++) {
            const struct record_channel *channel = &channels->of[i];
            snprintf(place, sizeof place, "%d", i + 1);
            size_t word = strcspn(channel->name, " ");
            bool hit = pass == 0   ? thud_ascii_same(channel->name, wanted)
                       : pass == 1 ? strlen(wanted) == word && thud_ascii_begins(channel->name, word, wanted)
                       : pass == 2 ? thud_ascii_same(channel->number, wanted)
                       : pass == 3 ? strcmp(place, wanted) == 0
                                   : thud_component_is(channel->name, wanted);
            if (hit && wanted[0])
                return i;
        }
    return -1;
}

static enum thud_status ask(const struct record_source *source, const struct record_channels *channels,
                            const char *wanted, struct thud_error *err)
{
    char list[240] = "";
    size_t n = 0;
    for (int i = 0; i < channels->count && n < sizeof list - 70; i++)
        n += (size_t)snprintf(list + n, sizeof list - n, "%s%d %s", i ? ", " : "", i + 1, channels->of[i].name);
    if (wanted[0])
        record_refuse(source, 0, 0, err, "there is no channel \"%s\"", wanted);
    else
        record_refuse(source, 0, 0, err, "%d channels, and `record.channel` does not say which", channels->count);
    thud_error_key(err, "channel");
    thud_error_allow(err, "%s", list);
    return THUD_INPUT;
}

enum thud_status record_channels_read(const struct record_source *source, const struct record_channels *channels,
                                      const struct thud_record_choice *choice, struct record_raw *raw,
                                      struct thud_error *err)
{
    if (channels->count == 0)
        return record_refuse(source, 0, 0, err, "there are no accelerations in it");
    const char *wanted = choice->part ? "" : choice->channel[0] ? choice->channel : choice->component;
    int which = wanted[0] && (choice->channel[0] || channels->count > 1) ? find(channels, wanted)
                : channels->count == 1                                   ? 0
                                                                         : -1;
    for (int i = 0, horizontal = 0; channels->count > 1 && choice->part && i < channels->count; i++)
        if (!thud_component_is_vertical(channels->of[i].name) && ++horizontal == choice->part)
            which = i;
    raw->parts = channels->count;
    if (which < 0)
        return ask(source, channels, wanted, err);
    const struct record_channel *channel = &channels->of[which];
    struct record_cursor cursor = channel->cursor;
    raw->dt_s = channel->dt_s;
    raw->factor = channel->factor;
    raw->dt_line = raw->factor_line = channel->line;
    snprintf(raw->component, sizeof raw->component, "%s", channel->name);
    if (channels->count > 1)
        snprintf(raw->note, sizeof raw->note, "channel %d of %d", which + 1, channels->count);
    return record_add_block(raw, &cursor, channel->width, channel->count, err);
}
