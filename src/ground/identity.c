#include "ground/identity.h"

#include "base/ascii.h"
#include "base/text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"

void thud_record_peak_text(const struct thud_record *record, char *text, size_t size)
{
    static const double rounding = 5e-4; /* of a peak that is given by three or four digits */
    double factor = fabs(record->scale), peak_g = thud_record_peak(record) / THUD_GRAVITY;
    const char *reversed = record->scale < 0 ? "reversed" : "";
    if (fabs(factor - 1) > rounding)
        snprintf(text, size, "peak %.4g g scaled by %.4g%s%s", peak_g, factor, *reversed ? ", " : "", reversed);
    else
        snprintf(text, size, "peak %.4g g %s", peak_g,
                 *reversed           ? reversed
                 : record->synthetic ? "as synthesized"
                                     : "as recorded");
}

void thud_record_title(const struct thud_record *record, char *text, size_t size)
{
    const char *part[] = {record->event, record->station, record->component};
    text[0] = '\0';
    for (int i = 0; i < 3; i++)
        if (*part[i])
            thud_append(text, size, "%s%s", *text ? ", " : "", part[i]);
    if (!*text)
        snprintf(text, size, "%s", thud_path_name(record->file));
}

const char *thud_record_synthetic_mark(const struct thud_record *record)
{
    return record->synthetic ? " (synthetic)" : "";
}

void thud_synthetic_text(int synthetic, int of, char *text, size_t size)
{
    if (synthetic == 0)
        snprintf(text, size, "%s", "");
    else if (of == 1)
        snprintf(text, size, "synthetic motion");
    else
        snprintf(text, size, "%d of %d motions synthetic", synthetic, of);
}

int thud_records_synthetic(const struct thud_record *const *record, int n)
{
    int synthetic = 0;
    for (int i = 0; i < n; i++)
        synthetic += record[i] && record[i]->synthetic;
    return synthetic;
}

/* Whether one of the words of letters in a text (U-D is one) stands for a vertical direction. */
bool thud_component_is_vertical(const char *text)
{
    static const char *const word[] = {"UP", "UD", "U-D", "VER", "VERT", "VERTICAL", "DWN", "DOWN", "V", "Z"};
    while (*text) {
        char found[12] = "";
        size_t n = 0, length = 0;
        while (thud_ascii_is_alpha(text[n]) ||
               (text[n] == '-' && n == 1 && thud_ascii_is_alpha(text[n + 1]) && !thud_ascii_is_alpha(text[n + 2])))
            n++;
        for (; length < n && length + 1 < sizeof found; length++)
            found[length] = thud_ascii_upper(text[length]);
        for (size_t i = 0; n == length && i < sizeof word / sizeof *word; i++)
            if (strcmp(found, word[i]) == 0)
                return true;
        if (n == 3 && found[2] == 'Z' && strchr("HBEFS", found[0]) && strchr("NLGH", found[1])) /* SEED channel codes */
            return true;
        text += n > 0 ? n : 1;
    }
    return false;
}

/* Degrees from north of one word: NS, E-W, HNE, N28W, 090, 90 DEG. NaN: none. */
static double azimuth_of_word(const char *w, size_t n, const char *behind)
{
    char word[12] = "", *end;
    size_t length = 0, digits = strspn(w, "0123456789");
    for (size_t i = 0; i < n && length + 1 < sizeof word; i++)
        if (w[i] != '-')
            word[length++] = thud_ascii_upper(w[i]);
    const char last = n > 0 ? word[length - 1] : '\0';
    if (digits == n && n > 0)
        return (n == 3 || strncmp(behind, " DEG", 4) == 0 || strncmp(behind, " deg", 4) == 0) && atof(word) <= 360
                   ? atof(word)
                   : NAN;
    if (strcmp(word, "NS") == 0 || strcmp(word, "NORTH") == 0 || strcmp(word, "EW") == 0 || strcmp(word, "EAST") == 0)
        return *word == 'N' ? 0 : 90;
    if (length == 3 && strchr("HBEFS", word[0]) && strchr("NLGH", word[1]) &&
        strchr("NE", last)) /* SEED channel codes */
        return last == 'N' ? 0 : 90;
    if (length < 3 || !strchr("NS", word[0]) || !strchr("EW", last))
        return NAN;
    const double off = strtod(word + 1, &end);
    const double from_north = *word == 'N' ? off : 180 - off;
    return end == word + length - 1 && off <= 90 ? (last == 'E' ? from_north : 360 - from_north) : NAN;
}

static double component_azimuth(const char *name)
{
    static const char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-";
    double found = NAN;
    char *end;
    if ((*name == 'N' || *name == 'E') && !name[1])
        return *name == 'N' ? 0 : 90;
    const double whole = strtod(name, &end);
    if (end > name && !*end && whole >= 0 && whole <= 360)
        return whole;
    for (size_t n; *name && isnan(found); name += n > 0 ? n : 1) {
        n = strspn(name, letters);
        found = azimuth_of_word(name, n, name + n);
    }
    return found;
}

double thud_record_azimuth(const struct thud_record *record)
{
    const int place = strstr(record->format, "KiK") ? atoi(record->component) : 0; /* 1, 4: N-S; 2, 5: E-W; 3, 6: up */
    return place > 0 ? (place % 3 == 0 ? (double)NAN : 90.0 * (place % 3 - 1)) : component_azimuth(record->component);
}

bool thud_component_is(const char *name, const char *wanted)
{
    const double turn = fabs(component_azimuth(name) - component_azimuth(wanted));
    return thud_ascii_same(name, wanted) || fmod(turn, 180) < 0.5;
}

bool thud_record_is_vertical(const struct thud_record *record)
{
    const char *name = thud_path_name(record->file), *dot = strrchr(name, '.');
    const char *dash = strrchr(name, '-'), *line = strrchr(name, '_');
    const char *last = dash > line ? dash : line; /* "rsn6-elc-up.at2" */
    if (thud_component_is_vertical(record->component))
        return true;
    if (strstr(record->format, "K-NET") || strstr(record->format, "KiK"))
        return strcmp(record->component, "3") == 0 || strcmp(record->component, "6") == 0;
    char tail[8] = "";
    if (last && dot && dot > last && (size_t)(dot - last) < sizeof tail)
        memcpy(tail, last + 1, (size_t)(dot - last - 1));
    bool letters = strlen(tail) > 1;
    for (const char *c = tail; *c; c++)
        letters = letters && thud_ascii_is_alpha(*c);
    /* .UD and .UD2 are a direction, .V2 and .V2A a volume of processed data */
    return (letters && thud_component_is_vertical(tail)) ||
           (dot && thud_ascii_is_alpha(dot[1]) && thud_ascii_is_alpha(dot[2]) && thud_component_is_vertical(dot + 1));
}

bool thud_record_same_event(const struct thud_record *a, const struct thud_record *b)
{
    return a->event[0] && strcmp(a->event, b->event) == 0;
}

/* The first year from 1900 on in a text, as four digits; 0: none. */
static int year_of(const char *text)
{
    for (size_t n = 0; *text; text += n > 0 ? n : 1) {
        n = strspn(text, "0123456789");
        const int year = n == 4 || n == 8 ? atoi(text) / (n == 8 ? 10000 : 1) : 0; /* 1940, 19400519 */
        if (year >= 1900 && year < 2100)
            return year;
    }
    return 0;
}

bool thud_record_may_be_same_event(const struct thud_record *a, const struct thud_record *b)
{
    const int of_a = year_of(a->event), of_b = year_of(b->event);
    return !(of_a > 0 && of_b > 0 && of_a != of_b);
}

bool thud_record_same_station(const struct thud_record *a, const struct thud_record *b)
{
    return thud_record_same_event(a, b) && a->station[0] && strcmp(a->station, b->station) == 0;
}

/* The record every dt_s, (n), from its own beginning; returns the sum of squares. */
static double sample(const struct thud_record *record, double dt_s, long n, double *out)
{
    double squares = 0;
    for (long i = 0; i < n; i++) {
        const double x = (double)i * dt_s / record->dt_s;
        const size_t k = (size_t)x < record->samples - 1 ? (size_t)x : record->samples - 2;
        out[i] = record->a_mps2[k] + (x - (double)k) * (record->a_mps2[k + 1] - record->a_mps2[k]);
        squares += out[i] * out[i];
    }
    return squares;
}

/* Largest |sum of a_i b_i+lag| over lags of 0 to `most` samples, or few more, four at a time; a (n), b long enough. */
static double correlate(const double *a, long n, const double *b, long most)
{
    double largest = 0;
    for (long lag = 0; lag <= most; lag += 4) {
        double sum[4] = {0};
        for (long i = 0; i < n; i++)
            for (int k = 0; k < 4; k++)
                sum[k] += a[i] * b[i + lag + k];
        for (int k = 0; k < 4; k++)
            largest = fmax(largest, fabs(sum[k]));
    }
    return largest;
}

/* By the correlation coefficient at the best lag: it is 0.95 for two ways of processing El Centro 1940, and 0.5 for
 * different motions. The energies over the squared peaks are compared first: that is quick, and most motions differ in
 * it. */
bool thud_record_same_motion(const struct thud_record *a, const struct thud_record *b)
{
    static const double same = 0.9, alike = 1.6, finest_s = 0.02, longest_lag_s = 5;
    const double dt = fmax(finest_s, fmax(a->dt_s, b->dt_s)), of_a = thud_record_peak(a), of_b = thud_record_peak(b);
    if (!(of_a > 0 && of_b > 0) || a->samples < 2 || b->samples < 2)
        return false;
    const long n = (long)((double)(a->samples - 1) * a->dt_s / dt) + 1,
               m = (long)((double)(b->samples - 1) * b->dt_s / dt) + 1;
    const long lags = (long)(longest_lag_s / dt), room = (n > m ? n : m) + 2 * lags + 4;
    double *x = calloc((size_t)(n + room), sizeof *x); /* b between zeros */
    if (!x)
        return false;
    const double ea = sample(a, dt, n, x), eb = sample(b, dt, m, x + n + lags),
                 ratio = ea / (of_a * of_a) / (eb / (of_b * of_b));
    const bool found = ratio < alike && ratio > 1 / alike && correlate(x, n, x + n, 2 * lags) > same * sqrt(ea * eb);
    free(x);
    return found;
}

bool thud_motion_is_turned(const char *own, const char *other)
{
    static const char turned[] = ":sign=-";
    size_t n = strlen(own), cut = sizeof turned - 1;
    return n > cut && strcmp(own + n - cut, turned) == 0 && strncmp(own, other, n - cut) == 0;
}

/* The length of a file's name without its settings (FILE:KEY=VALUE...). */
static size_t name_length(const char *file)
{
    for (const char *colon = strchr(file, ':'); colon; colon = strchr(colon + 1, ':'))
        if (colon[1 + strspn(colon + 1, "abcdefghijklmnopqrstuvwxyz-")] == '=')
            return (size_t)(colon - file);
    return strlen(file);
}

/* Whether a setting, ":KEY=", has the same value in both names, or stands in neither. */
static bool same_setting(const char *a, const char *b, const char *key)
{
    const char *of_a = strstr(a, key), *of_b = strstr(b, key);
    if (!of_a || !of_b)
        return !of_a && !of_b;
    const size_t n = strlen(key), length = strcspn(of_a + n, ":");
    return length == strcspn(of_b + n, ":") && strncmp(of_a + n, of_b + n, length) == 0;
}

bool thud_record_same_file(const struct thud_record *a, const struct thud_record *b)
{
    const size_t n = name_length(a->file);
    return n == name_length(b->file) && strncmp(a->file, b->file, n) == 0 &&
           same_setting(a->file, b->file, ":column=") && same_setting(a->file, b->file, ":channel=");
}

static bool same_recording(const struct thud_record *a, const struct thud_record *b)
{
    return thud_record_same_file(a, b) || thud_record_same_station(a, b) || thud_record_same_motion(a, b);
}

int thud_motions_recordings(const struct thud_record *const *record, int n, int *of)
{
    int recordings = 0;
    for (int i = 0; i < n; i++) {
        int k = 0;
        while (k < i && !(record && record[i] && record[k] && same_recording(record[i], record[k])))
            k++;
        if (of)
            of[i] = k < i ? of[k] : recordings;
        recordings += k == i;
    }
    return recordings;
}
