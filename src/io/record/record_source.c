#include "io/record/record_source.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
#include "base/grow.h"
#include "base/quantity.h"

struct record_cursor record_start(const struct record_source *source)
{
    return (struct record_cursor){.source = source};
}

struct record_cursor record_start_data(const struct record_source *source)
{
    struct record_cursor cursor = record_start(source);
    struct record_line line;
    while (cursor.line < source->skip && record_next(&cursor, &line))
        ;
    return cursor;
}

bool record_next(struct record_cursor *cursor, struct record_line *line)
{
    const struct record_source *source = cursor->source;
    if (cursor->offset >= source->size)
        return false;
    const char *at = source->text + cursor->offset;
    size_t left = source->size - cursor->offset, length = 0;
    while (length < left && at[length] != '\n' && at[length] != '\r')
        length++;
    cursor->offset += length;
    if (length < left && at[length] == '\r')
        cursor->offset++;
    if (cursor->offset < source->size && source->text[cursor->offset] == '\n' &&
        (at[length] == '\n' || at[length] == '\r'))
        cursor->offset++;
    while (length > 0 && thud_ascii_is_blank(at[length - 1]))
        length--;
    *line = (struct record_line){.at = at, .length = length, .number = ++cursor->line};
    return true;
}

const char *record_find(const struct record_line *line, const char *word)
{
    size_t n = strlen(word);
    for (size_t i = 0; i + n <= line->length; i++)
        if (thud_ascii_begins(line->at + i, n, word))
            return line->at + i;
    return NULL;
}

bool record_begins(const struct record_line *line, const char *word)
{
    return thud_ascii_begins(line->at, line->length, word);
}

void record_copy(char *to, size_t size, const char *from, const char *end)
{
    while (from < end && thud_ascii_is_blank(*from))
        from++;
    while (end > from && (thud_ascii_is_blank(end[-1]) || end[-1] == ','))
        end--;
    size_t n = 0;
    for (; from < end && n + 1 < size; from++) {
        if (thud_ascii_is_blank(*from) &&
            thud_ascii_is_blank(from[-1])) /* not the first: blanks at the ends are gone */
            continue;
        /* what cannot be shown would spoil a terminal */
        to[n++] = (unsigned char)*from < 0x20 || *from == 0x7f ? (*from == '\t' ? ' ' : '?') : *from;
    }
    to[n] = '\0';
}

enum thud_status record_add(struct record_raw *raw, double value, struct thud_error *err)
{
    double *more = thud_grow(raw->value, raw->count, sizeof *more);
    if (!more)
        return thud_error_set(err, THUD_MEMORY, "out of memory after %zu samples", raw->count);
    raw->value = more;
    more[raw->count++] = value;
    return THUD_OK;
}

enum thud_status record_refuse(const struct record_source *source, int line, int column, struct thud_error *err,
                               const char *fmt, ...)
{
    char what[512];
    va_list args;
    va_start(args, fmt);
    vsnprintf(what, sizeof what, fmt, args);
    va_end(args);
    thud_error_set(err, THUD_INPUT, "%s", what);
    thud_error_place(err, source->name, line, column);
    return THUD_INPUT;
}

static size_t digits(const char *s, const char *end)
{
    size_t n = 0;
    while (s + n < end && thud_ascii_is_digit(s[n]))
        n++;
    return n;
}

/* Length of an exponent at `s`, 0 for none; *letter tells whether it has its letter. Without one, only a sign and
 * exactly three digits after a decimal point are an exponent: anything else there is the next field. */
static size_t exponent(const char *s, const char *end, bool point, bool *letter)
{
    *letter = s < end && strchr("eEdD", *s) && *s;
    size_t n = *letter ? 1 : 0;
    bool sign = s + n < end && (s[n] == '+' || s[n] == '-');
    if (sign)
        n++;
    size_t count = digits(s + n, end);
    if (*letter)
        return count ? n + count : 0;
    const char *after = s + n + count;
    return point && sign && count == 3 && (after >= end || (*after != '.' && !thud_ascii_is_alpha(*after))) ? n + count
                                                                                                            : 0;
}

enum record_scan record_scan(const char **at, const char *end, double *value)
{
    const char *s = *at;
    while (s < end && thud_ascii_is_blank(*s))
        s++;
    *at = s;
    if (s >= end)
        return RECORD_NONE;
    size_t sign = *s == '+' || *s == '-';
    size_t n = sign + digits(s + sign, end);
    bool point = s + n < end && s[n] == '.';
    size_t fraction = point ? digits(s + n + 1, end) : 0;
    if (n - sign + fraction == 0)
        return RECORD_WORD;
    n += point ? 1 + fraction : 0;
    bool letter;
    size_t power = exponent(s + n, end, point, &letter);
    char text[64];
    if (n + power + 2 > sizeof text)
        return RECORD_WORD;
    memcpy(text, s, n);
    size_t length = n;
    if (power) {
        text[length++] = 'e';
        memcpy(text + length, s + n + letter, power - letter);
        length += power - letter;
    }
    text[length] = '\0';
    if (thud_number_parse(text, NULL, value) != 0)
        return RECORD_RANGE;
    s += n + power;
    if (s < end && (*s == '.' || thud_ascii_is_digit(*s)))
        return RECORD_TOUCHING;
    if (s < end && thud_ascii_is_alpha(*s))
        return RECORD_WORD;
    *at = s;
    return RECORD_NUMBER;
}

enum thud_status record_refuse_scan(const struct record_source *source, const struct record_line *line, const char *at,
                                    enum record_scan scan, struct thud_error *err)
{
    char word[32];
    const char *end = line->at + line->length, *stop = at;
    while (stop < end && !thud_ascii_is_blank(*stop) && *stop != ',' && *stop != ';' && stop - at < 24)
        stop++;
    if (stop == at && at < end)
        stop++;
    record_copy(word, sizeof word, at, stop);
    const char *what = scan == RECORD_RANGE      ? "is too large a number"
                       : scan == RECORD_TOUCHING ? "are numbers without a separator"
                                                 : "is not a number";
    return record_refuse(source, line->number, (int)(at - line->at) + 1, err, "\"%s\" %s", word, what);
}

double record_number_at(const char **at, const char *end)
{
    const char *s = *at;
    while (s < end && strchr(" \t=:", *s) && *s)
        s++;
    const char *stop = s;
    while (stop < end && *stop && strchr("+-.0123456789", *stop))
        stop++;
    if (stop + 1 < end && strchr("eEdD", *stop) && *stop && strchr("+-0123456789", stop[1]) && stop[1]) {
        for (stop++; stop < end && *stop && strchr("+-0123456789", *stop);)
            stop++;
    }
    double value;
    if (record_scan(&s, stop, &value) != RECORD_NUMBER)
        return NAN;
    *at = s;
    return value;
}

double record_number_after(const struct record_line *line, const char *word)
{
    const char *s = record_find(line, word);
    if (!s)
        return NAN;
    s += strlen(word);
    return record_number_at(&s, line->at + line->length);
}

double record_number_first(const struct record_line *line)
{
    const char *s = line->at;
    return record_number_at(&s, line->at + line->length);
}

/* The fields of `width` characters; false when one of them does not hold exactly one number. */
static bool by_width(const struct record_line *line, size_t width, size_t most, double *value, size_t *count)
{
    *count = 0;
    for (size_t from = 0; from < line->length && *count < most; from += width) {
        const char *at = line->at + from;
        const char *end = line->at + (line->length - from < width ? line->length : from + width);
        double extra;
        if (*count == 64 || record_scan(&at, end, &value[*count]) != RECORD_NUMBER ||
            record_scan(&at, end, &extra) != RECORD_NONE)
            return false;
        ++*count;
    }
    return true;
}

enum thud_status record_add_line(struct record_raw *raw, const struct record_source *source,
                                 const struct record_line *line, size_t width, size_t most, struct thud_error *err)
{
    double value[64];
    size_t count = 0;
    enum thud_status status = THUD_OK;
    if (width && by_width(line, width, most, value, &count)) {
        for (size_t i = 0; i < count && !status; i++)
            status = record_add(raw, value[i], err);
        return status;
    }
    const char *at = line->at, *end = line->at + line->length;
    for (count = 0; count < most && !status; count++) {
        enum record_scan scan = record_scan(&at, end, value);
        if (scan == RECORD_NONE)
            return THUD_OK;
        if (scan != RECORD_NUMBER)
            return record_refuse_scan(source, line, at, scan, err);
        status = record_add(raw, value[0], err);
    }
    return status;
}

enum thud_status record_add_block(struct record_raw *raw, struct record_cursor *cursor, size_t width, size_t count,
                                  struct thud_error *err)
{
    struct record_line line;
    size_t last = raw->count + count;
    while (raw->count < last) {
        if (!record_next(cursor, &line))
            return record_refuse(cursor->source, cursor->line, 0, err,
                                 "the header states %zu samples, but the file ends after %zu (cut off?)", count,
                                 raw->count + count - last);
        enum thud_status status = record_add_line(raw, cursor->source, &line, width, last - raw->count, err);
        if (status)
            return status;
    }
    return THUD_OK;
}

enum thud_status record_count(const struct record_source *source, const struct record_line *line, double value,
                              size_t *count, struct thud_error *err)
{
    if (!(value >= 1) || value != floor(value))
        return record_refuse(source, line->number, 0, err, "the header states %g samples", value);
    if (value > (double)source->size)
        return record_refuse(source, line->number, 0, err,
                             "the header states %.0f samples, but the file has only %zu bytes (cut off?)", value,
                             source->size);
    *count = (size_t)value;
    return THUD_OK;
}
