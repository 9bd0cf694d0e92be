/* Texts on a picture: their width, lines and quoting. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/utf8.h"
#include "plot/gnuplot/gnuplot_internal.h"

/* Width of a character of DejaVu Sans, ems. */
static double advance(unsigned char c)
{
    if (strchr("ijl'|", c))
        return 0.3;
    if (strchr(".,:;fIJrt()[]-/! ", c))
        return 0.39;
    if (strchr("mMwW%@", c))
        return 0.93;
    return c >= 'A' && c <= 'Z' ? 0.7 : c >= '0' && c <= '9' ? 0.64 : 0.62;
}

double thud_gnuplot_width(const char *text, double em)
{
    double sum = 0;
    for (size_t step; *text; text += step ? step : 1) {
        step = (size_t)thud_utf8_length(text);
        sum += step == 1 ? advance((unsigned char)*text) : 0.65;
    }
    return em * sum;
}

double thud_gnuplot_fit(const char *text, double widest, double em)
{
    double width = thud_gnuplot_width(text, em);
    return width > widest ? em * fmax(0.75, widest / width) : em;
}

/* A byte that means something within double quotes: as an octal escape. */
static void escaped(struct thud_text *out, char byte)
{
    thud_text_append(out, "\\%03o", (unsigned)(unsigned char)byte);
}

/* gnuplot 5.4 does not read an apostrophe doubled at the beginning of a single-quoted text, nor two in a row: a text
 * with an apostrophe stands in double quotes. */
void thud_gnuplot_quote(struct thud_text *out, const char *text, double widest, double em)
{
    bool cut = widest > 0.0 && thud_gnuplot_width(text, em) > widest, twice = strchr(text, '\'') != NULL;
    double used = em; /* with the sign that it goes on */
    const char *quote = twice ? "\"" : "'";
    thud_text_bytes(out, quote, 1);
    while (*text) {
        size_t size = (size_t)thud_utf8_length(text);
        used += size == 1 ? em * advance((unsigned char)*text) : 0.65 * em;
        if (cut && used > widest) {
            thud_text_append(out, "…");
            break;
        }
        if (size == 0)
            thud_text_bytes(out, "?", 1);
        else if (size == 1 && ((unsigned char)*text < 0x20 || *text == 0x7f))
            thud_text_bytes(out, " ", 1);
        else if (twice && strchr("\"\\`@$", *text))
            escaped(out, *text);
        else
            thud_text_bytes(out, text, size);
        text += size ? size : 1;
    }
    thud_text_bytes(out, quote, 1);
}

/* Whether a number stands before a blank and a unit, or another short word, behind it. */
static bool before_unit(const char *begin, const char *blank)
{
    return blank > begin && blank[-1] >= '0' && blank[-1] <= '9' && strcspn(blank + 1, " ,.;:)") <= 2;
}

/* Lines that a text takes, at most THUD_LINES_MAX; where each begins (the last one's end comes after it) in *at. */
static int wrapped_at(const char *text, double widest, double em, size_t at[THUD_LINES_MAX + 1])
{
    int n = 0;
    size_t begin = 0, length = strlen(text);
    while (begin < length && n < THUD_LINES_MAX) {
        double used = 0.0;
        size_t end = begin, blank = 0;
        while (end < length && used <= widest) {
            size_t step = (size_t)thud_utf8_length(text + end);
            used += em * (step == 1 ? advance((unsigned char)text[end]) : 0.65);
            if (text[end] == ' ' && !before_unit(text + begin, text + end))
                blank = end;
            end += step ? step : 1;
        }
        if (used > widest && blank > begin && n + 1 < THUD_LINES_MAX)
            end = blank + 1;
        else if (used > widest && n + 1 == THUD_LINES_MAX)
            end = length;
        if (at) {
            at[n] = begin;
            at[n + 1] = end;
        }
        begin = end;
        n++;
    }
    return n;
}

int thud_gnuplot_wrap(const char *text, double widest, double em, size_t at[THUD_LINES_MAX + 1])
{
    static const double shorter = 0.95;
    int n = wrapped_at(text, widest, em, NULL);
    while (n > 1 && n < THUD_LINES_MAX && wrapped_at(text, shorter * widest, em, NULL) == n)
        widest *= shorter;
    return wrapped_at(text, widest, em, at);
}
