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

/* number * 10^shift, correctly rounded: the decimal exponent of the text is moved, not the number multiplied. */
static int shifted(const char *text, size_t length, int shift, double *out)
{
    char copy[TEXT_MAX + 32];
    size_t mantissa = strcspn(text, "eE");
    long exponent = 0;
    if (mantissa < length)
        exponent = strtol(text + mantissa + 1, NULL, 10);
    else
        mantissa = length;
    if (exponent > 100000 || exponent < -100000)
        exponent = exponent < 0 ? -100000 : 100000;
    snprintf(copy, sizeof copy, "%.*se%ld", (int)mantissa, text, exponent + shift);
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
        failed = shifted(clean, (size_t)(end - clean), unit.shift, &number);
    number *= unit.factor;
    if (failed || !isfinite(number)) {
        thud_error_set(err, THUD_INPUT, "\"%.80s\" is too large a number", clean);
        return THUD_INPUT;
    }
    *out = (struct thud_quantity){number == 0 ? 0 : number, unit.exponent}; /* "-0 cm" is 0, whose text has no sign */
    return THUD_OK;
}

/* Shortest digits of a finite value as "d.ddd" and its decimal exponent. */
static int shortest(double value, char *text, size_t size)
{
    for (int digits = 0; digits < 17; digits++) {
        snprintf(text, size, "%.*e", digits, value);
        if (strtod(text, NULL) == value)
            break;
    }
    char *e = strchr(text, 'e');
    assert(e); /* "%e" writes one for every finite number */
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

/* Number of the unit with a factor that reads back as `value`; false when no double does. */
static bool by_factor(double value, const struct thud_unit *unit, char *text, size_t size)
{
    double near = value / unit->factor;
    double tries[] = {near, nextafter(near, INFINITY), nextafter(near, -INFINITY)};
    for (size_t i = 0; i < sizeof tries / sizeof *tries; i++)
        for (int digits = 1; digits <= 17; digits++) {
            char number[64];
            double back;
            snprintf(number, sizeof number, "%.*g", digits, tries[i]);
            if (shifted(number, strlen(number), unit->shift, &back) == 0 && back * unit->factor == value) {
                char mantissa[40];
                int exponent = shortest(strtod(number, NULL), mantissa, sizeof mantissa);
                place_point(mantissa, exponent, text, size);
                return true;
            }
        }
    return false;
}

/* The unit in which every value can be written: shift 0, factor 1. */
static void plain_unit(const struct thud_unit *unit, char *name, size_t size)
{
    char n[32];
    thud_number_format(unit->exponent, n, sizeof n);
    if (unit->dimension == THUD_POWER_STIFFNESS)
        snprintf(name, size, "N/m^%s", n);
    else
        snprintf(name, size, "%s", unit->dimension == THUD_ACCELERATION ? "m/s2" : "m");
}

void thud_quantity_format(double value_si, const char *unit, char *text, size_t size)
{
    struct thud_unit found = {THUD_NUMBER, 0, 1, 0};
    char number[64] = "", name[64], mantissa[40];
    if (!isfinite(value_si)) {
        snprintf(text, size, "%s", isnan(value_si) ? "" : value_si > 0 ? "infinity" : "-infinity");
        return;
    }
    thud_unit_find(unit ? unit : "", &found);
    snprintf(name, sizeof name, "%s", unit ? unit : "");
    int exponent = shortest(value_si, mantissa, sizeof mantissa);
    if (value_si == 0)
        snprintf(number, sizeof number, "0");
    else if (found.factor == 1)
        place_point(mantissa, exponent - found.shift, number, sizeof number);
    else if (!by_factor(value_si, &found, number, sizeof number)) {
        place_point(mantissa, exponent, number, sizeof number);
        plain_unit(&found, name, sizeof name);
    }
    snprintf(text, size, "%s%s%s", number, *name ? " " : "", name);
}
