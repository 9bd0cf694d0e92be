/* What every reader of record files stands on: lines with their numbers, numbers as instruments print them, a growing
 * list of samples. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/text.h"
#include "study/scene/scene.h"

/* A file in memory. Lines end with LF, CRLF or CR. The first `skip` lines are the user's --skip. */
struct record_source {
    const char *name;
    const char *text;
    size_t size;
    int skip;
};

/* One line without its end and without trailing blanks. */
struct record_line {
    const char *at;
    size_t length;
    int number; /* from 1 */
};

struct record_cursor {
    const struct record_source *source;
    size_t offset;
    int line; /* of the last line given */
};

/* Starts at the first line (also among the skipped ones). */
struct record_cursor record_start(const struct record_source *source);
/* Starts behind the skipped lines. */
struct record_cursor record_start_data(const struct record_source *source);
bool record_next(struct record_cursor *cursor, struct record_line *line);

/* Finds `word` in a line, any case; NULL when it is not there. */
const char *record_find(const struct record_line *line, const char *word);
bool record_begins(const struct record_line *line, const char *word);
/* Copies a part of a line, blanks at both ends dropped, several in a row made one, what cannot be shown made `?`. */
void record_copy(char *to, size_t size, const char *from, const char *end);

/* What a file holds, before it becomes a record. Texts may be empty. */
struct record_raw {
    double *value;
    size_t count;
    double dt_s;        /* NaN: the file does not say */
    double factor;      /* to m/s2; NaN: the file does not say */
    bool dt_from_prose; /* found in free text: an option may say otherwise */
    bool factor_from_prose;
    bool remove_mean;
    int parts;             /* motions that the file holds; 0: one */
    char unknown_unit[48]; /* of the accelerations, as the file has it; empty: it says nothing or what is known */
    int dt_line;           /* where dt stands */
    int factor_line;
    char station[96];
    char component[64];
    char event[96], licence[96];
    char note[160]; /* how the samples were found, for a person to see */
    bool synthetic;
};

enum thud_status record_add(struct record_raw *raw, double value, struct thud_error *err);

/* Sets an input error at a place of the file. */
enum thud_status record_refuse(const struct record_source *source, int line, int column, struct thud_error *err,
                               const char *fmt, ...) THUD_PRINTF(5, 6);

/* One number at `*at`, which moves behind it. Takes what Fortran prints: no leading zero, D exponents, an exponent
 * without a letter
 * (`1.234-100`), a sign that touches the number before it. */
enum record_scan { RECORD_NUMBER, RECORD_NONE, RECORD_WORD, RECORD_RANGE, RECORD_TOUCHING };
enum record_scan record_scan(const char **at, const char *end, double *value);
/* The message that goes with what record_scan gave for a line. */
enum thud_status record_refuse_scan(const struct record_source *source, const struct record_line *line, const char *at,
                                    enum record_scan scan, struct thud_error *err);

/* The number at `*at`, which moves behind it, over blanks, `=` and `:`; a word may touch its end (`100Hz`, `.01SEC`).
 * NaN: none. */
double record_number_at(const char **at, const char *end);
/* The number behind `word` in a line (over blanks, `=` and `:`), NaN when there is none. */
double record_number_after(const struct record_line *line, const char *word);
/* The first number of a line, NaN when it does not begin with one. */
double record_number_first(const struct record_line *line);

/* All numbers of a line, in fields of `width` characters (0: apart by blanks or signs). Lines an editor has changed are
 * read by blanks. At most `most` numbers are added. */
enum thud_status record_add_line(struct record_raw *raw, const struct record_source *source,
                                 const struct record_line *line, size_t width, size_t most, struct thud_error *err);
/* Lines until `count` samples are there; a file that ends early is refused with both counts. */
enum thud_status record_add_block(struct record_raw *raw, struct record_cursor *cursor, size_t width, size_t count,
                                  struct thud_error *err);
/* A count from a header, with the bound the file's size sets (a sample takes at least one character and one between).
 */
enum thud_status record_count(const struct record_source *source, const struct record_line *line, double value,
                              size_t *count, struct thud_error *err);

/* ---- The formats of record files: one table each, in its own file ---- */

/* `recognize` looks at content only. `read` fills `raw` (empty, with dt and factor NaN); it may leave dt and factor for
 * the user to give. */
struct record_format {
    const char *name;
    bool plain; /* says nothing of itself: also what is left after --skip is read so */
    bool (*recognize)(const struct record_source *source);
    enum thud_status (*read)(const struct record_source *source, const struct thud_record_choice *choice,
                             struct record_raw *raw, struct thud_error *err);
};

/* The first that recognizes a file reads it. */
/* clang-format off */
#define RECORD_FORMATS(X) \
    X(at2) X(knet) X(kiknet) X(esm) X(cosmos) X(smc) X(csmip) X(geonet) X(at2_bare) X(csv) X(columns)
/* clang-format on */
#define RECORD_DECLARE(name) extern const struct record_format record_format_##name;
RECORD_FORMATS(RECORD_DECLARE)
#undef RECORD_DECLARE

/* ---- Files with several channels: each by its number in the file and by what the file calls it ---- */

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

/* A new channel that `line` begins and whose samples stand behind `cursor`; NULL when there are too many. */
struct record_channel *record_channel_add(struct record_channels *channels, const struct record_cursor *cursor,
                                          const struct record_line *line, struct thud_error *err);

/* Reads the chosen channel, or the only one, into `raw`. Errors: THUD_INPUT asking for --channel with the names. */
enum thud_status record_channels_read(const struct record_source *source, const struct record_channels *channels,
                                      const struct thud_record_choice *choice, struct record_raw *raw,
                                      struct thud_error *err);

/* Unpacks what gzip(1) made, all its members, into *out. Errors: THUD_INPUT (cut off, damaged, more than `most` bytes),
 * THUD_MEMORY. */
enum thud_status record_gunzip(const char *packed, size_t size, size_t most, struct thud_text *out,
                               struct thud_error *err);
