#include "base/status.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"

static void copy(char *to, size_t size, const char *from)
{
    snprintf(to, size, "%s", from ? from : "");
}

static int write_message(struct thud_error *err, enum thud_status status, const char *fmt, va_list args)
{
    if (err) {
        memset(err, 0, sizeof *err);
        err->status = status;
        vsnprintf(err->what, sizeof err->what, fmt, args);
    }
    return err != NULL;
}

int thud_error_write(struct thud_error *err, enum thud_status status, const char *fmt, ...)
{
    va_list args;
    va_start(args, fmt);
    int written = write_message(err, status, fmt, args);
    va_end(args);
    return written;
}

int thud_error_write_whole(struct thud_error *err, enum thud_status status, const char *key, const char *allowed,
                           const char *fmt, ...)
{
    va_list args;
    va_start(args, fmt);
    int written = write_message(err, status, fmt, args);
    va_end(args);
    if (err) {
        copy(err->key, sizeof err->key, key);
        copy(err->allowed, sizeof err->allowed, allowed);
    }
    return written;
}

int thud_error_write_in(struct thud_error *err, enum thud_status status, const char *file, int line, const char *fmt,
                        ...)
{
    va_list args;
    va_start(args, fmt);
    int written = write_message(err, status, fmt, args);
    va_end(args);
    thud_error_place(err, file, line, 0);
    return written;
}

void thud_error_place(struct thud_error *err, const char *file, int line, int column)
{
    if (!err)
        return;
    if (file)
        copy(err->file, sizeof err->file, file);
    err->line = line;
    err->column = column;
}

void thud_error_key(struct thud_error *err, const char *fmt, ...)
{
    if (!err)
        return;
    va_list args;
    va_start(args, fmt);
    vsnprintf(err->key, sizeof err->key, fmt, args);
    va_end(args);
}

void thud_error_allow(struct thud_error *err, const char *fmt, ...)
{
    if (!err)
        return;
    va_list args;
    va_start(args, fmt);
    vsnprintf(err->allowed, sizeof err->allowed, fmt, args);
    va_end(args);
}

char *thud_error_text(const struct thud_error *err, char *text, unsigned long size)
{
    if (!text || size == 0)
        return text;
    text[0] = '\0';
    if (!err)
        return text;
    char place[640] = "";
    if (err->file[0])
        snprintf(place, sizeof place, "%s:", err->file);
    if (err->line > 0)
        thud_append(place, sizeof place, "%d:", err->line);
    if (err->line > 0 && err->column > 0)
        thud_append(place, sizeof place, "%d:", err->column);
    snprintf(text, size, "%s%s%s%s%s%s%s%s", place, place[0] ? " " : "", err->key, err->key[0] ? ": " : "", err->what,
             err->allowed[0] ? " (" : "", err->allowed, err->allowed[0] ? ")" : "");
    thud_text_shown(text, "");
    return text;
}
