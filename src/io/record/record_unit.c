#include "io/record/record_table.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/ascii.h"
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

static const struct {
    const char *name;
    double factor;
} times[] = {{"s", 1},           {"sec", 1},          {"secs", 1},           {"second", 1},
             {"seconds", 1},     {"ms", 1e-3},        {"msec", 1e-3},        {"msecs", 1e-3},
             {"millisec", 1e-3}, {"millisecs", 1e-3}, {"millisecond", 1e-3}, {"milliseconds", 1e-3},
             {"us", 1e-6},       {"\xc2\xb5s", 1e-6}, {"\xce\xbcs", 1e-6},   {"usec", 1e-6},
             {"usecs", 1e-6},    {"microsec", 1e-6},  {"microsecond", 1e-6}, {"microseconds", 1e-6},
             {"ns", 1e-9},       {"nsec", 1e-9},      {"nanoseconds", 1e-9}, {"min", 60},
             {"mins", 60},       {"minute", 60},      {"minutes", 60}};

static bool starts(const char *s, const char *end, const char *word)
{
    return thud_ascii_begins(s, (size_t)(end - s), word);
}

static bool in_word(char c)
{
    return thud_ascii_is_alnum(c) || (unsigned char)c >= 0x80;
}

static const char *past_blanks(const char *s, const char *end)
{
    while (s < end && (*s == ' ' || *s == '\t'))
        s++;
    return s;
}

/* Nothing is calculated with what stands before `at`: no number, operator or prefix (`10^-3 g`, `V/g`, `milli g`). */
static bool starts_unit(const char *line, const char *at)
{
    if (at > line && in_word(at[-1]))
        return false;
    const char *before = at;
    while (before > line && strchr(" \t", before[-1]))
        before--;
    if (before == line)
        return true;
    char last = before[-1];
    if (thud_ascii_is_digit(last) || strchr("/*^%.+-", last) || ((unsigned char)last >= 0x80 && before == at))
        return false;
    static const char *const prefixes[] = {"per", "micro", "milli", "centi", "deci", "kilo", "mega", "x"};
    for (size_t i = 0; i < sizeof prefixes / sizeof *prefixes; i++) {
        size_t n = strlen(prefixes[i]);
        if ((size_t)(before - line) >= n && starts(before - n, before, prefixes[i]) &&
            ((size_t)(before - line) == n || !in_word(before[-(ptrdiff_t)n - 1])))
            return false;
    }
    return true;
}

/* Nor with what stands behind it (`g*100`, `g/Hz`, `m/s2 * 9.8`). */
static bool ends_unit(const char *s, const char *end)
{
    if (s < end && in_word(*s))
        return false;
    s = past_blanks(s, end);
    return s >= end || !strchr("/*^", *s);
}

double record_unit_at(const char *s, const char *end, size_t *length)
{
    for (size_t i = 0; i < sizeof lengths / sizeof *lengths; i++) {
        if (!starts(s, end, lengths[i].name))
            continue;
        size_t n = strlen(lengths[i].name);
        for (size_t k = 0; k < sizeof tails / sizeof *tails; k++) {
            const char *after = s + n + strlen(tails[k]);
            if (starts(s + n, end, tails[k]) && ends_unit(after, end)) {
                *length = (size_t)(after - s);
                return lengths[i].factor;
            }
        }
    }
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (starts(s, end, words[i].name) && ends_unit(s + strlen(words[i].name), end)) {
            *length = strlen(words[i].name);
            return words[i].factor;
        }
    return 0;
}

double record_factor_at(const char *s, const char *end)
{
    size_t length;
    const double factor = record_unit_at(past_blanks(s, end), end, &length);
    return factor != 0 ? factor : NAN;
}

static double whole_unit(const char *s, const char *end)
{
    size_t length;
    double factor = record_unit_at(s, end, &length);
    return factor != 0 && length == (size_t)(end - s) ? factor : 0;
}

double record_unit(const char *text)
{
    return whole_unit(text, text + strlen(text));
}

/* ---- the name of a column ---- */

/* The next pair of outermost brackets: what is between them. Those of `m/(s^2)` belong to the unit. */
static bool next_brackets(const char **at, const char *end, const char **from, const char **to)
{
    int depth = 0;
    for (const char *s = *at; s < end; s++) {
        bool opens = strchr("([{", *s) && *s && (depth > 0 || s == *at || s[-1] != '/');
        if (opens && depth++ == 0)
            *from = s + 1;
        if (strchr(")]}", *s) && *s && depth > 0 && --depth == 0) {
            *to = s;
            *at = s + 1;
            return true;
        }
    }
    return false;
}

/* Blanks at both ends, and `in`, `unit:`, `units =` at the beginning. */
static void strip(const char **from, const char **to)
{
    static const char *const leads[] = {"units", "unit", "in"};
    *from = past_blanks(*from, *to);
    while (*to > *from && strchr(" \t.", (*to)[-1]))
        --*to;
    for (size_t i = 0; i < sizeof leads / sizeof *leads; i++) {
        const char *after = *from + strlen(leads[i]);
        if (!starts(*from, *to, leads[i]) || after >= *to || !strchr(" \t:=", *after))
            continue;
        while (after < *to && strchr(" \t:=", *after))
            after++;
        *from = after;
        return;
    }
}

/* Whether what stands in brackets can be meant for a unit (`V/g`, `10^-3 g`, `counts`), not for a direction. */
static bool claims_unit(const char *from, const char *to)
{
    if (from[-1] == '[' || from[-1] == '{')
        return true;
    for (const char *s = from; s < to; s++)
        if (strchr("/*^%", *s) || (unsigned char)*s >= 0x80)
            return true;
    return to > from && (thud_ascii_lower(to[-1]) == 'g' || starts(from, to, "count") || starts(from, to, "volt"));
}

static void note_unknown(char *unknown, size_t size, const char *from, const char *to)
{
    snprintf(unknown, size, "%.*s", (int)(to - from), from);
}

double record_name_unit(const char *name, char *unknown, size_t size)
{
    const char *end = name + strlen(name), *from, *to;
    double factor = 0;
    *unknown = '\0';
    for (const char *at = name; next_brackets(&at, end, &from, &to);) {
        bool claims = claims_unit(from, to);
        strip(&from, &to);
        double one = whole_unit(from, to);
        if (one == 0 && !claims)
            continue;
        if (one == 0 || (factor != 0 && one != factor)) {
            note_unknown(unknown, size, from, to);
            return 0;
        }
        factor = one;
    }
    for (const char *s = name; s < end && factor == 0; s++) {
        size_t length;
        if (starts_unit(name, s))
            factor = record_unit_at(s, end, &length);
    }
    return factor;
}

/* ---- times ---- */

static double time_unit(const char *from, const char *to)
{
    strip(&from, &to);
    for (size_t i = 0; i < sizeof times / sizeof *times; i++)
        if (strlen(times[i].name) == (size_t)(to - from) && starts(from, to, times[i].name))
            return times[i].factor;
    return 0;
}

/* Words of a time column's name that are no unit. */
static bool is_filler(const char *from, const char *to)
{
    static const char *const words_of_time[] = {"t",     "time",  "times",  "stamp",   "timestamp", "axis",  "vector",
                                                "since", "start", "series", "elapsed", "relative",  "after", "trigger",
                                                "from",  "of",    "the",    "record",  "in"};
    for (size_t i = 0; i < sizeof words_of_time / sizeof *words_of_time; i++)
        if (strlen(words_of_time[i]) == (size_t)(to - from) && starts(from, to, words_of_time[i]))
            return true;
    return from == to;
}

double record_name_seconds(const char *name, char *unknown, size_t size)
{
    const char *end = name + strlen(name), *from, *to;
    double factor = 0;
    *unknown = '\0';
    for (const char *at = name; next_brackets(&at, end, &from, &to);) {
        factor = time_unit(from, to);
        if (factor == 0)
            note_unknown(unknown, size, from, to);
        return factor;
    }
    for (const char *s = name; s < end; s = to + 1) {
        for (to = s; to < end && !strchr(" \t_,;:.=-", *to); to++)
            ;
        double one = time_unit(s, to);
        if (one != 0)
            factor = one;
        else if (!is_filler(s, to))
            note_unknown(unknown, size, s, to);
    }
    return *unknown ? 0 : factor != 0 ? factor : 1;
}

double record_seconds_after(const struct record_line *line, const char *word)
{
    const char *end = line->at + line->length;
    struct record_line rest = *line;
    const char *s;
    while ((s = record_find(&rest, word)) != NULL) {
        bool whole = s == line->at || !in_word(s[-1]);
        s += strlen(word);
        rest.at = s;
        rest.length = (size_t)(end - s);
        double value = whole ? record_number_at(&s, end) : NAN;
        if (isnan(value))
            continue;
        s = past_blanks(s, end);
        s += s < end && strchr("([", *s);
        const char *to = s;
        while (to < end && in_word(*to))
            to++;
        double factor = to == s ? 1 : time_unit(s, to);
        if (factor != 0)
            return value * factor;
    }
    return NAN;
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
        if ((size_t)(before - line) >= n && starts(before - n, before, leads[i]) && before < at &&
            ((size_t)(before - line) == n || !thud_ascii_is_alnum(before[-(ptrdiff_t)n - 1])))
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
        if (!starts_unit(line->at, s))
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

void record_prose_read(struct record_prose *prose, const struct record_line *line)
{
    read_unit(prose, line);
    static const char *const names[] = {"dt",       "delta t",           "delta_t",      "time step",
                                        "timestep", "sampling interval", "time interval"};
    for (size_t i = 0; i < sizeof names / sizeof *names && !prose->dt_line; i++) {
        double dt = record_seconds_after(line, names[i]);
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
