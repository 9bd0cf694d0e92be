#include "io/record_unit.h"

#include <ctype.h>
#include <math.h>
#include <string.h>
#include <strings.h>

#include "base/quantity.h"

const char record_unit_allowed[] = "g, mg, %g, m/s2, cm/s2, gal, mm/s2, in/s2, ft/s2";

static const struct {
    const char *name;
    double factor;
} lengths[] = {{"cm", 0.01}, {"mm", 0.001}, {"m", 1}, {"in", 0.0254}, {"ft", 0.3048}};
static const struct {
    const char *name;
    double factor;
} words[] = {
    {"gals", 0.01}, {"gal", 0.01}, {"%g", THUD_GRAVITY / 100}, {"mg", THUD_GRAVITY / 1000}, {"g", THUD_GRAVITY}};
/* what follows a length to make it an acceleration, longest first */
static const char *const tails[] = {"/sec/sec", "/sec**2", "/sec^2",     "/sec2",  "/s/s",   "/s**2",
                                    "/s^2",     "/s2",     "/s\xc2\xb2", "/s\xb2", "/(s^2)", "ps2",
                                    " s^-2",    ".s^-2",   "*s^-2",      " s-2",   ".s-2",   "s-2"};

static bool starts(const char *s, const char *end, const char *word)
{
    size_t n = strlen(word);
    return (size_t)(end - s) >= n && strncasecmp(s, word, n) == 0;
}

static bool ends_word(const char *s, const char *end)
{
    return s >= end || !isalnum((unsigned char)*s);
}

double record_unit_at(const char *s, const char *end, size_t *length)
{
    for (size_t i = 0; i < sizeof lengths / sizeof *lengths; i++) {
        if (!starts(s, end, lengths[i].name))
            continue;
        size_t n = strlen(lengths[i].name);
        for (size_t k = 0; k < sizeof tails / sizeof *tails; k++) {
            const char *after = s + n + strlen(tails[k]);
            if (starts(s + n, end, tails[k]) && ends_word(after, end)) {
                *length = (size_t)(after - s);
                return lengths[i].factor;
            }
        }
    }
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (starts(s, end, words[i].name) && ends_word(s + strlen(words[i].name), end)) {
            *length = strlen(words[i].name);
            return words[i].factor;
        }
    return 0;
}

double record_unit(const char *text)
{
    size_t length, all = strlen(text);
    double factor = record_unit_at(text, text + all, &length);
    return factor != 0 && length == all ? factor : 0;
}

/* A lone `g` is a unit only where something says so. */
static bool unit_said(const char *line, const char *at, const char *end, size_t length)
{
    if (length > 2)
        return true;
    const char *after = at + length;
    if (at > line &&
        ((at[-1] == '(' && after < end && *after == ')') || (at[-1] == '[' && after < end && *after == ']')))
        return true;
    const char *before = at;
    while (before > line && strchr(" \t:=", before[-1]))
        before--;
    static const char *const leads[] = {"units of", "unit of", "units", "unit", "in"};
    for (size_t i = 0; i < sizeof leads / sizeof *leads; i++) {
        size_t n = strlen(leads[i]);
        if ((size_t)(before - line) >= n && strncasecmp(before - n, leads[i], n) == 0 && before < at &&
            ((size_t)(before - line) == n || !isalnum((unsigned char)before[-(ptrdiff_t)n - 1])))
            return true;
    }
    return false;
}

/* "Acc. in", "acceleration" before the unit: it is about what is wanted. */
static bool about_acceleration(const struct record_line *line, const char *at)
{
    struct record_line before = {.at = line->at, .length = (size_t)(at - line->at)};
    return record_find(&before, "acc") != NULL;
}

static void read_unit(struct record_prose *prose, const struct record_line *line)
{
    const char *end = line->at + line->length;
    for (const char *s = line->at; s < end; s++) {
        size_t length;
        if (s > line->at && isalnum((unsigned char)s[-1]))
            continue;
        double factor = record_unit_at(s, end, &length);
        if (factor == 0 || !unit_said(line->at, s, end, length))
            continue;
        int weight = about_acceleration(line, s) ? 2 : 1;
        if (weight > prose->weight) {
            prose->factor = factor;
            prose->weight = weight;
            prose->line = line->number;
            prose->contradicts = false;
        } else if (weight == prose->weight && factor != prose->factor)
            prose->contradicts = true;
        s += length - 1;
    }
}

/* The number behind `word` and an optional `=`, in seconds; NaN when there is none. */
static double seconds_after(const struct record_line *line, const char *word)
{
    const char *end = line->at + line->length;
    struct record_line rest = *line;
    const char *s;
    while ((s = record_find(&rest, word)) != NULL) {
        bool whole = s == line->at || !isalnum((unsigned char)s[-1]);
        s += strlen(word);
        rest.at = s;
        rest.length = (size_t)(end - s);
        double value = whole ? record_number_at(&s, end) : NAN;
        if (isnan(value))
            continue;
        while (s < end && *s == ' ')
            s++;
        return starts(s, end, "ms") ? value / 1000 : value;
    }
    return NAN;
}

void record_prose_read(struct record_prose *prose, const struct record_line *line)
{
    read_unit(prose, line);
    static const char *const names[] = {"dt",       "delta t",           "delta_t",      "time step",
                                        "timestep", "sampling interval", "time interval"};
    for (size_t i = 0; i < sizeof names / sizeof *names && !prose->dt_line; i++) {
        double dt = seconds_after(line, names[i]);
        if (dt > 0) {
            prose->dt_s = dt;
            prose->dt_line = line->number;
        }
    }
}

void record_prose_apply(const struct record_prose *prose, struct record_raw *raw)
{
    if (isnan(raw->factor) && prose->weight && !prose->contradicts) {
        raw->factor = prose->factor;
        raw->factor_line = prose->line;
        raw->factor_from_prose = true;
    }
    if (isnan(raw->dt_s) && prose->dt_line) {
        raw->dt_s = prose->dt_s;
        raw->dt_line = prose->dt_line;
        raw->dt_from_prose = true;
    }
}
