#include "base/unit.h"

#include <math.h>
#include <string.h>

static const struct {
    const char *text;
    struct thud_unit unit;
} units[] = {
#define UNIT(text, dimension, shift, factor) {text, {dimension, shift, factor, 0}},
#include "base/unit_table.h"
#undef UNIT
};

static const struct {
    const char *name, *units;
} dimensions[THUD_DIMENSIONS] = {
    [THUD_NUMBER] = {"a number", ""},
    [THUD_RATIO] = {"a ratio", "%"},
    [THUD_LENGTH] = {"a length", "m, cm, mm, in, ft"},
    [THUD_AREA] = {"an area", "m2, cm2, mm2, ft2"},
    [THUD_MASS] = {"a mass", "t, kg, Mg, lb, kip s2/in, tonf s2/m"},
    [THUD_FORCE] = {"a force", "N, kN, MN, lbf, kip, tonf"},
    [THUD_STIFFNESS] = {"a stiffness", "N/m, kN/m, MN/m, N/mm, kN/mm, MN/mm, kip/in, kip/ft, tonf/m"},
    [THUD_POWER_STIFFNESS] = {"a stiffness of a power law",
                              "N/m^n, kN/m^n, MN/m^n, N/mm^n, kN/mm^n, MN/mm^n with the number for n"},
    [THUD_PRESSURE] = {"a pressure", "Pa, kPa, MPa, GPa, N/mm2, kN/mm2, N/m2, kN/m2, MN/m2, psi, ksi, psf"},
    [THUD_TIME] = {"a time", "s, ms"},
    [THUD_VELOCITY] = {"a velocity", "m/s, cm/s, mm/s, in/s, ft/s"},
    [THUD_ACCELERATION] = {"an acceleration", "m/s2, cm/s2, mm/s2, in/s2, ft/s2, g, gal"},
    [THUD_BENDING] = {"a bending stiffness", "N m2, kN m2, MN m2, GN m2, kip in2, kip ft2"},
    [THUD_DASHPOT] = {"a dashpot", "N s/m, kN s/m, MN s/m, kip s/in, kip s/ft"},
    [THUD_ROCKING] = {"a rotational stiffness", "N m/rad, kN m/rad, MN m/rad, GN m/rad, kip in/rad, kip ft/rad"},
    [THUD_ROCKING_DASHPOT] = {"a rotational dashpot",
                              "N m s/rad, kN m s/rad, MN m s/rad, GN m s/rad, kip in s/rad, kip ft s/rad"},
    [THUD_INERTIA] = {"a moment of inertia", "kg m2, t m2, kip in s2, kip ft s2, lb ft2"},
    [THUD_DENSITY] = {"a density", "kg/m3, t/m3, lb/ft3, pcf"},
};

const char *thud_dimension_units(enum thud_dimension dimension)
{
    return dimensions[dimension].units;
}

const char *thud_dimension_name(enum thud_dimension dimension)
{
    return dimensions[dimension].name;
}

/* The factors of a product may be joined by *, a blank, a hyphen or nothing, and a power may have its caret or be
 * raised: kN s2/m, kN-s²/m, kN*s^2/m. */
static bool is_unit(const char *text, size_t length, const char *listed)
{
    const char *end = text + length;
    for (; *listed; listed++) {
        if (*listed == '*') {
            text += text < end && strchr("* -", *text);
            continue;
        }
        const bool digit = *listed == '2' || *listed == '3';
        text += end - text > 1 && digit && *text == '^';
        if (end - text > 1 && *listed == '2' && memcmp(text, "\xc2\xb2", 2) == 0) {
            text += 2;
            continue;
        }
        if (text == end || *text++ != *listed)
            return false;
    }
    return text == end;
}

static bool find_listed(const char *text, size_t length, struct thud_unit *unit)
{
    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        if (is_unit(text, length, units[i].text)) {
            *unit = units[i].unit;
            return true;
        }
    return false;
}

/* FORCE/LENGTH^n, n between 0 and 10. */
static bool find_power(const char *text, struct thud_unit *unit)
{
    const char *slash = strchr(text, '/'), *caret = strchr(text, '^'), *end;
    struct thud_unit force, length;
    double n;
    if (!slash || !caret || caret < slash || !find_listed(text, (size_t)(slash - text), &force) ||
        force.dimension != THUD_FORCE || !find_listed(slash + 1, (size_t)(caret - slash - 1), &length) ||
        length.dimension != THUD_LENGTH)
        return false;
    if (caret[1] == '+' || thud_number_parse(caret + 1, &end, &n) != 0 || *end || !(n > 0) || n > 10)
        return false;
    *unit = (struct thud_unit){THUD_POWER_STIFFNESS, 0, 1, n};
    double shift = force.shift - n * length.shift;
    if (shift == rint(shift))
        unit->shift = (int)shift;
    else
        unit->factor = pow(10, force.shift) * pow(pow(10, -length.shift), n);
    unit->factor *= pow(length.factor, -n);
    return true;
}

bool thud_unit_find(const char *text, struct thud_unit *unit)
{
    if (!*text) {
        *unit = (struct thud_unit){THUD_NUMBER, 0, 1, 0};
        return true;
    }
    return find_power(text, unit) || find_listed(text, strlen(text), unit);
}

double thud_unit_factor(const char *unit, enum thud_dimension *dimension, double *exponent)
{
    struct thud_unit found;
    if (!thud_unit_find(unit, &found))
        return 0;
    if (dimension)
        *dimension = found.dimension;
    if (exponent)
        *exponent = found.exponent;
    /* 1/100 and not 0.01 * 1: correctly rounded */
    return found.shift < 0 ? found.factor / pow(10, -found.shift) : found.factor * pow(10, found.shift);
}
