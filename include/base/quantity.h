/* Parses and writes numbers with units, as people type them, to and from SI. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/status.h"

enum thud_dimension {
    THUD_NUMBER = 0, /* no unit; `5 %` is 0.05 */
    THUD_RATIO,      /* as THUD_NUMBER, shown in per cent where the parameter's unit is "%" */
    THUD_LENGTH,
    THUD_AREA,
    THUD_MASS,
    THUD_FORCE,
    THUD_STIFFNESS,       /* N/m */
    THUD_POWER_STIFFNESS, /* N/m^n: the exponent is part of the unit as typed, `0.36 kN/mm^2.65` */
    THUD_PRESSURE,
    THUD_TIME,
    THUD_VELOCITY,
    THUD_ACCELERATION,
    THUD_BENDING,         /* N m2 */
    THUD_DASHPOT,         /* N s/m */
    THUD_ROCKING,         /* N m/rad */
    THUD_ROCKING_DASHPOT, /* N m s/rad */
    THUD_INERTIA,         /* kg m2 */
    THUD_DENSITY,         /* kg/m3 */
    THUD_DIMENSIONS
};

/* Value in SI units and, for THUD_POWER_STIFFNESS, the exponent of the unit as typed (else 0). */
struct thud_quantity {
    double value;
    double exponent;
};

/* Reads `text` as a quantity of the dimension. A missing unit is an error, unless the dimension is THUD_NUMBER or
 * THUD_RATIO, or `bare_unit` gives the unit of bare numbers (NULL: none). A decimal comma, another dimension (named), a
 * word, infinities and NaN are refused with what is allowed. Errors: THUD_INPUT. */
enum thud_status thud_quantity_parse(const char *text, enum thud_dimension dimension, const char *bare_unit,
                                     struct thud_quantity *out, struct thud_error *err);

/* Writes the SI value in `unit` (which may carry an exponent) as the shortest text that reads back the same. */
void thud_quantity_format(double value_si, const char *unit, char *text, size_t size);
/* Whether the number that begins the text has more than nine digits, as a factor between units leaves them. */
bool thud_quantity_is_long(const char *text);
/* Returns the text of a value as sentences have it: a long number rounded to six digits in `said`; else `text`. */
const char *thud_quantity_said(const char *text, char said[96]);

/* Returns the factor from `unit` to SI; 0: unknown unit. `exponent` (may be NULL) gets the unit's exponent for N/m^n
 * units. */
double thud_unit_factor(const char *unit, enum thud_dimension *dimension, double *exponent);

/* Writes the units of a dimension for messages and help: "m, cm, mm, in, ft". */
const char *thud_dimension_units(enum thud_dimension dimension);
const char *thud_dimension_name(enum thud_dimension dimension); /* "a length" */

/* Reads a number independently of the locale (LC_NUMERIC stays "C"). `end` gets the first character not read; returns 0
 * on success, -1 for no number, -2 when out of range. Hexadecimal, `inf` and `nan` are refused. */
int thud_number_parse(const char *text, const char **end, double *out);
/* Writes the shortest decimal text that reads back as the same double; of -0 it is 0. */
void thud_number_format(double value, char *text, size_t size);
/* Writes a number rounded to twelve digits as printf's %.12g does, in a tenth of its time; returns the length. */
size_t thud_number_twelve(double value, char text[32]);
/* Writes `digits` significant digits without an exponent, and more for larger numbers. Returns `text`. */
const char *thud_digits(double value, int digits, char text[32]);
/* Writes the change of a ratio: "+12 %" of 1.12, "-0.2 %" of 0.998, "0 %" below the shown digits. Returns `text`. */
const char *thud_change_text(double ratio, char text[32]);
/* Returns the value, or 0 if it rounds to 0 at this number of decimals, where printf would write -0. */
double thud_shown(double value, int places);

#define THUD_GRAVITY 9.80665         /* m/s2, standard gravity */
#define THUD_KIP     4448.2216152605 /* N, 1000 lbf */
#define THUD_PI      3.14159265358979323846
