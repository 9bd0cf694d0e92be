/* Files with several channels: each by its number in the file and by what the file calls it. */
#ifndef THUD_IO_RECORD_CHANNELS_H
#define THUD_IO_RECORD_CHANNELS_H

#include "io/record/record_source.h"

enum { RECORD_CHANNELS_MAX = 64 };

struct record_channel {
    char name[64];
    char number[16];             /* the file's own number; may be empty */
    struct record_cursor cursor; /* at its first line of samples */
    size_t count, width;
    double dt_s;   /* NaN: not said */
    double factor; /* to m/s2; NaN: not said */
    int line;
};

struct record_channels {
    struct record_channel of[RECORD_CHANNELS_MAX];
    int count;
};

/* A new channel, or NULL when there are too many. */
struct record_channel *record_channel_add(struct record_channels *channels);

/* Reads the chosen channel, or the only one, into `raw`. Errors: THUD_INPUT asking for --channel with the names. */
enum thud_status record_channels_read(const struct record_source *source, const struct record_channels *channels,
                                      const struct thud_record_choice *choice, struct record_raw *raw,
                                      struct thud_error *err);

#endif
