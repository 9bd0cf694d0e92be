#include "app/run/summary_line.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/quantity.h"
#include "base/text.h"

double thud_summary_gap_cm(double gap_m)
{
    return 0.1 * thud_shown(ceil(1e3 * gap_m - 1e-6), 0);
}

double thud_table_gap_cm(double gap_m)
{
    return 0.01 * thud_shown(ceil(1e4 * gap_m - 1e-6), 0);
}

/* Adds a part where it fits. Everything here is ASCII. */
static void add(char *text, size_t size, int columns, const char *part)
{
    size_t n = strlen(text);
    if ((int)(n + (n ? 3 : 0) + strlen(part)) <= columns)
        thud_append(text, size, "%s%s", n ? "   " : "", part);
}

/* "16 impacts, 34.5 MN": three digits. */
static void pounding_words(int impacts, double force_n, char text[64])
{
    const double force = 1e-6 * force_n;
    if (force < 5e-4) {
        snprintf(text, 64, "%d impact%s, %.2g kN", impacts, impacts == 1 ? "" : "s", 1e-3 * force_n);
        return;
    }
    snprintf(text, 64, "%d impact%s, %.*f MN", impacts, impacts == 1 ? "" : "s",
             force >= 99.95     ? 0
             : force >= 9.995   ? 1
             : force >= 0.9995  ? 2
             : force >= 0.09995 ? 3
                                : 4,
             force);
}

static void bumper_words(const struct thud_summary_line *line, bool brief, char *part, size_t size)
{
    char words[64];
    *part = '\0';
    if (!line->with || (isnan(line->bumper_force_n) && line->bumper_impacts == 0))
        return;
    if (line->bumper_impacts == 0)
        snprintf(part, size, "%s: no contact", line->with);
    else if (isnan(line->bumper_force_n))
        snprintf(part, size, "%s: %d impact%s", line->with, line->bumper_impacts, line->bumper_impacts == 1 ? "" : "s");
    else {
        pounding_words(line->bumper_impacts, line->bumper_force_n, words);
        snprintf(part, size, "%s: %s", line->with, brief ? strchr(words, ',') + 2 : words);
        if (!brief && line->force_n > 0)
            thud_append(part, size, " (%s)", thud_change_text(line->bumper_force_n / line->force_n, words));
    }
}

#define ALONE " when nothing else touches"

/* "needs 19.8 cm" */
static int needs_words(const struct thud_summary_line *line, char *text, size_t size)
{
    return snprintf(text, size, "needs %s%.1f cm", line->by_level ? "up to " : "",
                    thud_summary_gap_cm(line->need_m + line->bumper_m));
}

const char *thud_summary_bare(double need_m, double bumper_m, char text[24])
{
    *text = '\0';
    if (bumper_m > 1e-9) /* a difference: rounding is no bumper */
        snprintf(text, 24, " (%.1f bare)", thud_summary_gap_cm(need_m));
    return text;
}

void thud_summary_needs(const struct thud_summary_line *line, char *text, size_t size)
{
    char bare[24];
    needs_words(line, text, size);
    if (*thud_summary_bare(line->need_m, line->bumper_m, bare))
        thud_append(text, size, "%s%s", bare, line->in_row ? ALONE : "");
    else if (line->in_row)
        thud_append(text, size, ALONE);
    else
        thud_append(text, size, " (ABS %.1f, SRSS %.1f)", thud_summary_gap_cm(line->abs_m),
                    thud_summary_gap_cm(line->srss_m));
}

/* The gap that is needed, with as much beside it as leaves `rest` columns. */
static void add_needs(const struct thud_summary_line *line, int columns, int rest, char *text, size_t size)
{
    char part[160];
    if (isnan(line->need_m))
        return;
    thud_summary_needs(line, part, sizeof part);
    if ((int)(strlen(text) + 3 + strlen(part)) + rest > columns) {
        needs_words(line, part, sizeof part);
        thud_append(part, sizeof part, "%s", line->in_row ? ALONE : "");
    }
    add(text, size, columns, part);
}

void thud_summary_line(const struct thud_summary_line *line, int columns, char *text, size_t size)
{
    char part[160], bumper[120], words[64];
    const char *gap = line->gap;
    *text = '\0';
    if (isnan(line->force_n) && line->impacts == 0)
        return;
    bumper_words(line, false, bumper, sizeof bumper);
    if (isnan(line->force_n))
        snprintf(part, sizeof part, "POUNDS at %s: %d impulse%s, %s kN s in all", gap, line->impacts,
                 line->impacts == 1 ? "" : "s", thud_digits(1e-3 * line->impulse_ns, 3, words));
    else if (line->impacts > 0) {
        pounding_words(line->impacts, line->force_n, words);
        snprintf(part, sizeof part, "POUNDS at %s: %s", gap, words);
    } else
        snprintf(part, sizeof part, "NO CONTACT at %s", gap);
    add(text, size, columns, part);
    const bool last = line->need_with && *bumper;
    const int rest = last && !isnan(line->need_m) ? 3 + needs_words(line, words, sizeof words) : 0;
    if (!last)
        add_needs(line, columns, *bumper ? (int)(3 + strlen(bumper) + strlen(line->without) + 2) : 0, text, size);
    if ((int)(strlen(text) + 3 + strlen(bumper)) + rest > columns)
        bumper_words(line, true, bumper, sizeof bumper);
    if (!*bumper)
        return;
    add(text, size, columns, bumper);
    snprintf(part, sizeof part, "%s: ", line->without);
    const size_t n = strlen(text), room = strlen(part);
    if ((int)(n + room) + rest <= columns && n + room < size) {
        memmove(text + room, text, n + 1);
        memcpy(text, part, room);
    }
    if (last)
        add_needs(line, columns, 0, text, size);
}
