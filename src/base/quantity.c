#include "base/quantity.h"

#include <assert.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
#include "base/unit.h"

enum { TEXT_MAX = 160 };

/* Copies `text` without blanks around it; false when it is too long to be a quantity. */
static bool trim(const char *text, char *to)
{
    while (thud_ascii_is_blank(*text))
        text++;
    size_t length = strlen(text);
    while (length > 0 && thud_ascii_is_blank(text[length - 1]))
        length--;
    if (length >= TEXT_MAX)
        return false;
    memcpy(to, text, length);
    to[length] = '\0';
    return true;
}

/* Decimal digits of a number's mantissa; returns how many. *last: the power of ten of the last one. */
static size_t digits_of(const char *text, size_t length, char *digit, long *last)
{
    size_t n = 0;
    bool behind = false;
    *last = 0;
    for (size_t i = 0; i < length && text[i] != 'e' && text[i] != 'E'; i++) {
        behind |= text[i] == '.';
        if (thud_ascii_is_digit(text[i])) {
            digit[n++] = (char)(text[i] - '0');
            *last -= behind;
        }
    }
    return n;
}

/* number * factor * 10^shift, correctly rounded: the product of both as decimals, 0.3 * 0.3048, which no product of
 * doubles is. So a value is the same in every unit in which it is typed, and has the short text of each. */
static int scaled(const char *text, size_t length, double factor, int shift, double *out)
{
    enum { FACTOR = 32 };
    char by[FACTOR], a[TEXT_MAX], b[FACTOR], copy[TEXT_MAX + 2 * FACTOR], *to = copy;
    int digit[TEXT_MAX + FACTOR] = {0};
    long last[2], exponent = 0;
    const size_t mantissa = strcspn(text, "eE");
    if (mantissa < length)
        exponent = strtol(text + mantissa + 1, NULL, 10);
    if (exponent > 100000 || exponent < -100000)
        exponent = exponent < 0 ? -100000 : 100000;
    thud_number_format(factor, by, sizeof by);
    if (strchr(by, 'e'))
        exponent += strtol(strchr(by, 'e') + 1, NULL, 10);
    const size_t na = digits_of(text, length, a, &last[0]), nb = digits_of(by, strlen(by), b, &last[1]);
    for (size_t i = 0; i < na; i++)
        for (size_t k = 0; k < nb; k++)
            digit[i + k + 1] += a[i] * b[k];
    if (*text == '-')
        *to++ = '-';
    for (size_t i = na + nb - 1; i > 0; i--) {
        digit[i - 1] += digit[i] / 10;
        digit[i] %= 10;
    }
    for (size_t i = 0; i < na + nb; i++)
        *to++ = (char)('0' + digit[i]);
    snprintf(to, (size_t)(copy + sizeof copy - to), "e%ld", exponent + last[0] + last[1] + shift);
    return thud_number_parse(copy, NULL, out);
}

static enum thud_status allow(struct thud_error *err, enum thud_dimension dimension)
{
    if (*thud_dimension_units(dimension))
        thud_error_allow(err, "%s", thud_dimension_units(dimension));
    return THUD_INPUT;
}

static enum thud_status not_a_number(const char *text, enum thud_dimension dimension, struct thud_error *err)
{
    thud_error_set(err, THUD_INPUT, *text ? "\"%.80s\" is not a number; give %s" : "%snothing is given; give %s", text,
                   thud_dimension_name(dimension));
    return allow(err, dimension);
}

/* 0,5 m: the remedy is the same text with a point. */
static enum thud_status decimal_comma(const char *text, const char *comma, struct thud_error *err)
{
    thud_error_set(err, THUD_INPUT, "\"%.80s\" has a decimal comma", text);
    thud_error_allow(err, "write %.*s.%.80s", (int)(comma - text), text, comma + 1);
    return THUD_INPUT;
}

/* Whether a unit is allowed where `dimension` is wanted; N/mm^2 is a pressure too, and N/m is N/m^1. */
static bool fits(struct thud_unit *unit, enum thud_dimension dimension)
{
    if (unit->dimension == dimension)
        return true;
    if (unit->dimension == THUD_STIFFNESS && dimension == THUD_POWER_STIFFNESS) {
        unit->exponent = 1;
        return true;
    }
    if (unit->dimension == THUD_POWER_STIFFNESS)
        return (dimension == THUD_STIFFNESS && unit->exponent == 1) ||
               (dimension == THUD_PRESSURE && unit->exponent == 2);
    return (unit->dimension == THUD_NUMBER || unit->dimension == THUD_RATIO) &&
           (dimension == THUD_NUMBER || dimension == THUD_RATIO);
}

static enum thud_status find_unit(const char *text, const char *name, enum thud_dimension dimension,
                                  struct thud_unit *unit, struct thud_error *err)
{
    if (!thud_unit_find(name, unit))
        thud_error_set(err, THUD_INPUT, "\"%.80s\" has no known unit; give %s", text, thud_dimension_name(dimension));
    else if (fits(unit, dimension))
        return THUD_OK;
    else if (!*name)
        thud_error_set(err, THUD_INPUT, "\"%.80s\" has no unit; give %s", text, thud_dimension_name(dimension));
    else
        thud_error_set(err, THUD_INPUT, "\"%.80s\" is %s; give %s", text, thud_dimension_name(unit->dimension),
                       thud_dimension_name(dimension));
    return allow(err, dimension);
}

enum thud_status thud_quantity_parse(const char *text, enum thud_dimension dimension, const char *bare_unit,
                                     struct thud_quantity *out, struct thud_error *err)
{
    char clean[TEXT_MAX];
    const char *end;
    double number;
    if (!trim(text, clean))
        return not_a_number(text, dimension, err);
    int failed = thud_number_parse(clean, &end, &number);
    if (failed == -1)
        return not_a_number(clean, dimension, err);
    if (*end == ',' && thud_ascii_is_digit(end[1]))
        return decimal_comma(clean, end, err);
    const char *name = end;
    while (thud_ascii_is_blank(*name))
        name++;
    struct thud_unit unit;
    enum thud_status status = find_unit(clean, !*name && bare_unit ? bare_unit : name, dimension, &unit, err);
    if (status != THUD_OK)
        return status;
    if (!failed)
        failed = scaled(clean, (size_t)(end - clean), unit.factor, unit.shift, &number);
    if (failed || !isfinite(number)) {
        thud_error_set(err, THUD_INPUT, "\"%.80s\" is too large a number", clean);
        return THUD_INPUT;
    }
    *out = (struct thud_quantity){number == 0 ? 0 : number, unit.exponent}; /* "-0 cm" is 0, whose text has no sign */
    return THUD_OK;
}

/* Shortest digits, as "d.ddd" and its decimal exponent, that are a finite value once multiplied by the factor. */
static int shortest(double value, double factor, char *text, size_t size)
{
    char by[32];
    double back;
    thud_number_format(factor, by, sizeof by);
    const long double near = value / strtold(by, NULL); /* a double may be too coarse for its 17 digits */
    for (int digits = 0; digits < 17; digits++) {
        snprintf(text, size, "%.*Le", digits, near);
        if (scaled(text, strlen(text), factor, 0, &back) == 0 && back == value)
            break;
    }
    char *e = strchr(text, 'e');
    assert(e); /* "%Le" writes one for every finite number */
    *e = '\0';
    return (int)strtol(e + 1, NULL, 10);
}

/* Writes mantissa "d.ddd" times 10^exponent without a power of ten where that is short enough. */
static void place_point(const char *mantissa, int exponent, char *text, size_t size)
{
    char digits[32];
    const char *sign = *mantissa == '-' ? "-" : "";
    size_t n = 0;
    for (const char *c = mantissa; *c; c++)
        if (thud_ascii_is_digit(*c) && n + 1 < sizeof digits)
            digits[n++] = *c;
    while (n > 1 && digits[n - 1] == '0')
        n--;
    digits[n] = '\0';
    if (exponent < -5 || exponent > 15)
        snprintf(text, size, "%s%c%s%se%d", sign, digits[0], n > 1 ? "." : "", digits + 1, exponent);
    else if (exponent < 0)
        snprintf(text, size, "%s0.%.*s%s", sign, -exponent - 1, "00000", digits);
    else if ((int)n <= exponent + 1)
        snprintf(text, size, "%s%s%.*s", sign, digits, exponent + 1 - (int)n, "0000000000000000");
    else
        snprintf(text, size, "%s%.*s.%s", sign, exponent + 1, digits, digits + exponent + 1);
}

void thud_quantity_format(double value_si, const char *unit, char *text, size_t size)
{
    struct thud_unit found = {THUD_NUMBER, 0, 1, 0};
    char number[64], mantissa[64];
    if (!isfinite(value_si)) {
        snprintf(text, size, "%s", isnan(value_si) ? "" : value_si > 0 ? "infinity" : "-infinity");
        return;
    }
    thud_unit_find(unit ? unit : "", &found);
    const int exponent = shortest(value_si, found.factor, mantissa, sizeof mantissa);
    place_point(mantissa, exponent - found.shift, number, sizeof number);
    snprintf(text, size, "%s%s%s", value_si == 0 ? "0" : number, unit && *unit ? " " : "", unit ? unit : "");
}

bool thud_quantity_is_long(const char *text)
{
    enum { TYPED = 9 };
    char digits[TEXT_MAX];
    long last;
    const size_t length = strspn(text, "+-.0123456789");
    return length < TEXT_MAX && digits_of(text, length, digits, &last) > TYPED;
}

const char *thud_quantity_said(const char *text, char said[96])
{
    enum { SAID = 6 };
    const char *end;
    char number[32];
    double value;
    if (thud_number_parse(text, &end, &value) != 0 || !thud_quantity_is_long(text))
        return text;
    snprintf(said, 96, "%s%.60s", thud_digits(value, SAID, number), end);
    return said;
}
