#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
#include "base/quantity.h"
#include "base/text.h"
#include "base/utf8.h"

/* Room for `more` bytes and the NUL after them. */
static bool reserve(struct thud_text *text, size_t more)
{
    if (text->failed)
        return false;
    if (more < text->capacity - text->size)
        return true;
    size_t capacity = text->capacity ? text->capacity : 256;
    while (capacity - text->size <= more) {
        if (capacity > (size_t)-1 / 2) {
            text->failed = 1;
            return false;
        }
        capacity *= 2;
    }
    char *data = realloc(text->data, capacity);
    if (!data) {
        text->failed = 1;
        return false;
    }
    text->data = data;
    text->capacity = capacity;
    return true;
}

void thud_text_bytes(struct thud_text *text, const char *bytes, size_t size)
{
    if (!reserve(text, size))
        return;
    if (size)
        memcpy(text->data + text->size, bytes, size);
    text->size += size;
    text->data[text->size] = '\0';
}

void thud_text_base64(struct thud_text *out, const char *bytes, size_t n)
{
    static const char digit[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < n; i += 3) {
        unsigned long bits = (unsigned long)(unsigned char)bytes[i] << 16;
        bits |= i + 1 < n ? (unsigned long)(unsigned char)bytes[i + 1] << 8 : 0;
        bits |= i + 2 < n ? (unsigned long)(unsigned char)bytes[i + 2] : 0;
        const char four[4] = {digit[bits >> 18 & 63], digit[bits >> 12 & 63], i + 1 < n ? digit[bits >> 6 & 63] : '=',
                              i + 2 < n ? digit[bits & 63] : '='};
        thud_text_bytes(out, four, sizeof four);
    }
}

/* Columns on the screen of so many bytes. */
static size_t columns_of(const char *text, size_t bytes)
{
    int columns = 0;
    for (const char *end = text + bytes; text < end;)
        columns += thud_utf8_width(thud_utf8_next(&text));
    return (size_t)columns;
}

/* Columns of the last line, without an end. */
static size_t last_column(const struct thud_text *text)
{
    const char *last = text->size > 0 ? strrchr(text->data, '\n') : NULL, *line = last ? last + 1 : text->data;
    return text->size > 0 ? columns_of(line, strlen(line)) : 0;
}

void thud_text_wrap(struct thud_text *text, const char *words, size_t indent, size_t columns)
{
    size_t from = text->size, column = last_column(text);
    for (const char *word = words + strspn(words, " "); *word && !text->failed; word += strspn(word, " ")) {
        const size_t n = strcspn(word, " "), width = columns_of(word, n);
        const size_t blank = column > 0 && text->data[text->size - 1] != ' ';
        const bool fits = column <= indent || column + blank + width <= columns;
        thud_text_append(text, "%s%*s%.*s", fits ? "" : "\n", (int)(fits ? blank : indent), "", (int)n, word);
        column = (fits ? column + blank : indent) + width;
        word += n;
    }
    for (; from < text->size; from++)
        text->data[from] = text->data[from] == '\t' ? ' ' : text->data[from];
}

void thud_append(char *text, size_t size, const char *fmt, ...)
{
    const size_t n = strlen(text);
    va_list args;
    va_start(args, fmt);
    vsnprintf(text + n, size - n, fmt, args);
    va_end(args);
}

void thud_text_append(struct thud_text *text, const char *fmt, ...)
{
    va_list args;
    va_start(args, fmt);
    thud_text_append_list(text, fmt, args);
    va_end(args);
}

void thud_text_append_list(struct thud_text *text, const char *fmt, va_list args)
{
    va_list again;
    const size_t room = text->failed ? 0 : text->capacity - text->size;
    va_copy(again, args);
    int size = vsnprintf(room > 0 ? text->data + text->size : NULL, room, fmt, args);
    if (size < 0) {
        text->failed = 1;
    } else if ((size_t)size < room) {
        text->size += (size_t)size;
    } else if (reserve(text, (size_t)size)) {
        vsnprintf(text->data + text->size, (size_t)size + 1, fmt, again);
        text->size += (size_t)size;
    } else if (room > 0) {
        text->data[text->size] = '\0'; /* without the part that would have fitted */
    }
    va_end(again);
}

void thud_text_number(struct thud_text *text, double value)
{
    char number[32];
    thud_number_format(value, number, sizeof number);
    thud_text_bytes(text, number, strlen(number));
}

/* Behind apostrophes, if any, begins what a spreadsheet takes for a formula. */
static bool is_formula(const char *field)
{
    const char *at = field + strspn(field, "'"), *end;
    double value;
    if (!*at || !strchr("=+-@", *at) || !at[1])
        return false;
    return at > field || thud_number_parse(at, &end, &value) != 0 || *end;
}

const char *thud_text_csv_plain(const char *field)
{
    return *field == '\'' && is_formula(field) ? field + 1 : field;
}

/* A terminal would obey it, or it is not UTF-8. */
static bool has_unshown(const char *field)
{
    while (*field) {
        bool valid = thud_utf8_length(field) > 0;
        if (thud_utf8_is_control(thud_utf8_next(&field)) || !valid)
            return true;
    }
    return false;
}

void thud_text_csv(struct thud_text *text, const char *field)
{
    size_t n = strlen(field);
    bool edged = n > 0 && (thud_ascii_is_blank(field[0]) ||
                           thud_ascii_is_blank(field[n - 1])); /* a reader takes bare blanks off */
    bool quoted = edged || strpbrk(field, ",\"\r\n") || has_unshown(field);
    if (quoted)
        thud_text_bytes(text, "\"", 1);
    if (is_formula(field))
        thud_text_bytes(text, "'", 1);
    for (; *field; field++)
        thud_text_bytes(text, *field == '"' ? "\"\"" : field, *field == '"' ? 2 : 1);
    if (quoted)
        thud_text_bytes(text, "\"", 1);
}

size_t thud_text_shown(char *text, const char *kept)
{
    char *to = text;
    for (const char *from = text; *from;) {
        const char *at = from;
        uint32_t code = thud_utf8_next(&at);
        bool keep = code < 0x80 && strchr(kept, (int)code);
        if (thud_utf8_length(from) == 0 || (thud_utf8_is_control(code) && !keep)) {
            *to++ = '?';
        } else {
            memmove(to, from, (size_t)(at - from));
            to += at - from;
        }
        from = at;
    }
    *to = '\0';
    return (size_t)(to - text);
}

int thud_text_wider(int columns, const char *name)
{
    const int own = thud_utf8_columns(name);
    return own > columns ? own : columns;
}

void thud_text_padded(struct thud_text *text, const char *name, int columns)
{
    const int before = (int)last_column(text);
    const bool fits = thud_utf8_columns(name) <= columns;
    thud_text_append(text, "%s%s%*s", name, fits ? "" : "\n",
                     fits ? columns - thud_utf8_columns(name) : before + columns, "");
}

void thud_text_comment(struct thud_text *text, const char *name, const char *value)
{
    thud_text_append(text, "# %s: ", name);
    size_t from = text->size;
    thud_text_append(text, "%s", value);
    if (!text->failed)
        text->size = from + thud_text_shown(text->data + from, "\t");
    thud_text_append(text, "\n");
}

void thud_text_clear(struct thud_text *text)
{
    free(text->data);
    *text = (struct thud_text){0};
}

/* Whether the text begins with a setting of a ground motion, `:unit=`. */
static bool is_setting(const char *text)
{
    size_t n = 1;
    while (text[0] == ':' && text[n] >= 'a' && text[n] <= 'z')
        n++;
    return n > 1 && text[n] == '=';
}

const char *thud_path_name(const char *path)
{
    const char *name = path;
    for (const char *c = path; *c && !is_setting(c); c++)
        name = c[0] == '/' && c[1] ? c + 1 : name;
    return name;
}

unsigned long long thud_hash(unsigned long long h, const void *bytes, size_t size)
{
    const unsigned char *p = bytes;
    for (size_t i = 0; i < size; i++)
        h = (h ^ p[i]) * 0x100000001b3ULL;
    return h;
}

unsigned long long thud_hash_text(unsigned long long h, const char *text)
{
    return thud_hash(h, text, strlen(text) + 1);
}
