#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
#include "base/quantity.h"

int thud_number_parse(const char *text, const char **end, double *out)
{
    const char *s = text;
    if (*s == '+' || *s == '-')
        s++;
    /* strtod also takes hexadecimal, inf and nan, which are no numbers in a preset or a record */
    if (!thud_ascii_is_digit(*s) && !(*s == '.' && thud_ascii_is_digit(s[1])))
        return -1;
    if (*s == '0' && (s[1] == 'x' || s[1] == 'X'))
        return -1;
    char *stop;
    double value = strtod(text, &stop);
    if (end)
        *end = stop;
    *out = value;
    return isfinite(value) ? 0 : -2;
}

/* Powers of ten that a double holds exactly. */
static const double power[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9, 1e10,
                               1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20};

/* x as a sum of two numbers of at most 27 digits (Veltkamp), whose products with others of the kind are exact. */
static void split(double x, double *high, double *low)
{
    double c = 134217729 * x; /* 2^27 + 1 */
    *high = c - (c - x);
    *low = x - *high;
}

/* The whole number nearest to value 10^k, halves to the even one, where it is below 2^63; *off: how far that product
 * lies above it. The product of two doubles is exactly a sum of two (Dekker 1971). */
static int64_t nearest_whole(double value, int k, double *off)
{
    double high = value * power[k], a[2], b[2];
    split(value, &a[0], &a[1]);
    split(power[k], &b[0], &b[1]);
    double low = ((a[0] * b[0] - high) + a[0] * b[1] + a[1] * b[0]) + a[1] * b[1];
    double whole = rint(high), rest = (high - whole) + low, more = rint(rest);
    int64_t n = (int64_t)whole + (int64_t)more;
    *off = rest - more;
    if (fabs(*off) == 0.5 && n % 2 != 0) {
        n += *off > 0 ? 1 : -1;
        *off = -*off;
    }
    return n;
}

/* `digits` decimal digits, of which the first stands for 10^exponent, -4 <= exponent < digits, as %g writes them. */
static void write_digits(bool negative, int64_t n, int digits, int exponent, char *text)
{
    char digit[20];
    int last = digits;
    for (int i = digits - 1; i >= 0; i--, n /= 10)
        digit[i] = (char)('0' + n % 10);
    while (last > 1 && digit[last - 1] == '0')
        last--;
    if (negative)
        *text++ = '-';
    if (exponent < 0) {
        *text++ = '0';
        *text++ = '.';
    }
    for (int i = exponent + 1; i < 0; i++)
        *text++ = '0';
    for (int i = 0; i < last || i <= exponent; i++) {
        if (i > 0 && i == exponent + 1)
            *text++ = '.';
        *text++ = i < last ? digit[i] : '0';
    }
    *text = '\0';
}

/* Whole numbers below 10^15: 40, not 4e+01; and no -0. */
static void write_whole(double value, char *text)
{
    const int64_t n = (int64_t)fabs(value);
    int digits = 1;
    while (digits < 15 && n >= (int64_t)power[digits])
        digits++;
    write_digits(value < 0, n, digits, digits - 1, text);
}

/* Of the first digit of a number from 1e-9 to 1e19; near a power of ten perhaps the one beside it. */
static int exponent_of(double size)
{
    int exponent = 0;
    while (size >= power[exponent + 1])
        exponent++;
    while (exponent <= 0 && exponent > -9 && size * power[-exponent] < 1)
        exponent--;
    return exponent;
}

/* The shortest of 15, 16 and 17 digits that is this number again, where exact arithmetic in doubles shows which one it
 * is; else false. Not where expressions are evaluated in more than double precision. */
static bool write_plain(double value, char *text)
{
    const double size = fabs(value), unit = nextafter(size, INFINITY) - size;
    if (FLT_EVAL_METHOD != 0 || !(size >= 1e-4 && size < 1e14))
        return false;
    if (size - nextafter(size, 0) != unit) /* a power of 2: the unit in the last place is half as large below it */
        return false;
    const int exponent = exponent_of(size);
    for (int digits = 15; digits <= 17; digits++) {
        const int k = digits - 1 - exponent;
        const double half = 0.5 * unit * power[k];
        double off;
        const int64_t n = nearest_whole(size, k, &off), least = (int64_t)power[digits - 1];
        if (n < least || n >= 10 * least)
            return false;
        if (digits < 17 && fabs(off) > 0.999999 * half &&
            fabs(off) < 1.000001 * half) /* reading may round either way */
            return false;
        if (digits == 17 || fabs(off) < half) {
            write_digits(value < 0, n, digits, exponent, text);
            return true;
        }
    }
    return false;
}

/* Without the conversions of the C library, which took a tenth of a study's time for its files. */
static bool write_fast(double value, char *text, size_t size)
{
    char number[32];
    if (value == rint(value) && fabs(value) < 1e15)
        write_whole(value, number);
    else if (!write_plain(value, number))
        return false;
    size_t length = strlen(number);
    if (length >= size)
        return false;
    memcpy(text, number, length + 1);
    return true;
}

void thud_number_format(double value, char *text, size_t size)
{
    if (write_fast(value, text, size))
        return;
    /* %g leaves trailing zeros out, so 15 digits, which any normal double has, also print the shorter ones */
    for (int digits = fabs(value) < DBL_MIN ? 1 : 15; digits <= 17; digits++) {
        snprintf(text, size, "%.*g", digits, value);
        if (strtod(text, NULL) == value)
            return;
    }
}

/* As printf's %.12g, of which a history has millions. */
size_t thud_number_twelve(double value, char text[32])
{
    enum { DIGITS = 12 };
    const double size = fabs(value);
    if (FLT_EVAL_METHOD == 0 && size >= 1e-9 && size < 1e11) {
        const int exponent = exponent_of(size);
        double off;
        const int64_t n = nearest_whole(size, DIGITS - 1 - exponent, &off), least = (int64_t)power[DIGITS - 1];
        if (n >= least && n < 10 * least) {
            write_digits(value < 0, n, DIGITS, exponent < -4 ? 0 : exponent, text);
            const size_t length = strlen(text);
            if (exponent >= -4)
                return length;
            memcpy(text + length, (char[]){'e', '-', '0', (char)('0' - exponent), '\0'}, 5);
            return length + 4;
        }
    }
    return (size_t)snprintf(text, 32, "%.12g", value + 0.0); /* no -0 */
}

double thud_shown(double value, int places)
{
    return fabs(value) * pow(10, places) <= 0.5 ? 0 : value;
}

const char *thud_digits(double value, int digits, char text[32])
{
    const bool whole = fabs(value) >= pow(10, digits) * (1 - 0.5 * pow(10, -digits)) && fabs(value) < 1e15;
    if (whole)
        snprintf(text, 32, "%.0f", value);
    else
        snprintf(text, 32, "%.*g", digits, value);
    return text;
}

const char *thud_change_text(double ratio, char text[32])
{
    const double change = 100 * (ratio - 1);
    const int places = fabs(change) >= 0.5 ? 0 : 1;
    if (thud_shown(change, places) == 0)
        snprintf(text, 32, "0 %%");
    else
        snprintf(text, 32, "%+.*f %%", places, change);
    return text;
}
