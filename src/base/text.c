#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"
#include "base/text.h"

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

void thud_text_append(struct thud_text *text, const char *fmt, ...)
{
    va_list args, again;
    va_start(args, fmt);
    va_copy(again, args);
    int size = vsnprintf(NULL, 0, fmt, args);
    va_end(args);
    if (size < 0)
        text->failed = 1;
    else if (reserve(text, (size_t)size)) {
        vsnprintf(text->data + text->size, (size_t)size + 1, fmt, again);
        text->size += (size_t)size;
    }
    va_end(again);
}

void thud_text_number(struct thud_text *text, double value)
{
    char number[32];
    thud_number_format(value, number, sizeof number);
    thud_text_bytes(text, number, strlen(number));
}

static bool is_blank(char c)
{
    return c == ' ' || c == '\t';
}

void thud_text_csv(struct thud_text *text, const char *field)
{
    size_t n = strlen(field);
    bool edged = n > 0 && (is_blank(field[0]) || is_blank(field[n - 1])); /* a reader takes bare blanks off */
    if (!edged && !strpbrk(field, ",\"\r\n")) {
        thud_text_bytes(text, field, n);
        return;
    }
    thud_text_bytes(text, "\"", 1);
    for (; *field; field++)
        thud_text_bytes(text, *field == '"' ? "\"\"" : field, *field == '"' ? 2 : 1);
    thud_text_bytes(text, "\"", 1);
}

void thud_text_clear(struct thud_text *text)
{
    free(text->data);
    *text = (struct thud_text){0};
}
