/* Quantities: every unit against its definition, every refusal with its remedy, and no digit lost. */
#include <check.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "base/quantity.h"

static double si(const char *text, enum thud_dimension dimension)
{
    struct thud_quantity q = {NAN, NAN};
    struct thud_error err = {0};
    enum thud_status status = thud_quantity_parse(text, dimension, NULL, &q, &err);
    ck_assert_msg(status == THUD_OK, "%s: %s", text, err.what);
    return q.value;
}

START_TEST(units_are_what_they_are_defined_to_be)
{
    static const struct {
        const char *text;
        enum thud_dimension dimension;
        double value;
    } rows[] = {
        {"0.07 m", THUD_LENGTH, 0.07},
        {"7 cm", THUD_LENGTH, 0.07},
        {"70mm", THUD_LENGTH, 0.07},
        {" 1 in ", THUD_LENGTH, 0.0254},
        {"1 ft", THUD_LENGTH, 0.3048},
        {"3 m2", THUD_AREA, 3},
        {"3 cm2", THUD_AREA, 0.0003},
        {"3 mm^2", THUD_AREA, 0.000003},
        {"320 t", THUD_MASS, 320000},
        {"320 Mg", THUD_MASS, 320000},
        {"5 kg", THUD_MASS, 5},
        {"320 kN", THUD_FORCE, 320000},
        {"1 MN", THUD_FORCE, 1e6},
        {"7 N", THUD_FORCE, 7},
        {"600 MN/m", THUD_STIFFNESS, 6e8},
        {"600 kN/mm", THUD_STIFFNESS, 6e8},
        {"1 kip/in", THUD_STIFFNESS, 4448.2216152605 / 0.0254},
        {"1 kip/ft", THUD_STIFFNESS, 4448.2216152605 / 0.3048},
        {"1000 lbf", THUD_FORCE, 4448.2216152605},
        {"2 kip s2/in", THUD_MASS, 2 * (4448.2216152605 / 0.0254)},
        {"2 kN-s\xc2\xb2/m", THUD_MASS, 2000},
        {"2 kN*s^2/m", THUD_MASS, 2000},
        {"1 tonf s2/m", THUD_MASS, 9806.65},
        {"3 tonf/m", THUD_STIFFNESS, 29419.95},
        {"1 kips/in", THUD_STIFFNESS, 4448.2216152605 / 0.0254},
        {"1 ft2", THUD_AREA, 0.3048 * 0.3048},
        {"1 kip ft/rad", THUD_ROCKING, 4448.2216152605 * 0.3048},
        {"1 kip-in/rad", THUD_ROCKING, 4448.2216152605 * 0.0254},
        {"1 kip ft s/rad", THUD_ROCKING_DASHPOT, 4448.2216152605 * 0.3048},
        {"1 kip in s2", THUD_INERTIA, 4448.2216152605 * 0.0254},
        {"1 lb ft2", THUD_INERTIA, 0.45359237 * 0.3048 * 0.3048},
        {"1 pcf", THUD_DENSITY, 0.45359237 / 0.3048 / 0.3048 / 0.3048},
        {"7 MNm^2", THUD_BENDING, 7e6},
        {"7 MN m2", THUD_BENDING, 7e6},
        {"4 kN s/m", THUD_DASHPOT, 4000},
        {"1 ksi", THUD_PRESSURE, 4448.2216152605 / 0.0254 / 0.0254},
        {"1 ft/s2", THUD_ACCELERATION, 0.3048},
        {"600 N/mm", THUD_STIFFNESS, 6e5},
        {"6 MN/mm", THUD_STIFFNESS, 6e9},
        {"6 kN/m", THUD_STIFFNESS, 6000},
        {"6 N/m", THUD_STIFFNESS, 6},
        {"1 GPa", THUD_PRESSURE, 1e9},
        {"1 kN/mm2", THUD_PRESSURE, 1e9},
        {"1 N/mm^2", THUD_PRESSURE, 1e6},
        {"1 MPa", THUD_PRESSURE, 1e6},
        {"1 kPa", THUD_PRESSURE, 1e3},
        {"1 Pa", THUD_PRESSURE, 1},
        {"20 ms", THUD_TIME, 0.02},
        {"1e3 s", THUD_TIME, 1000},
        {"0.5 m/s", THUD_VELOCITY, 0.5},
        {"50 cm/s", THUD_VELOCITY, 0.5},
        {"-500 mm/s", THUD_VELOCITY, -0.5},
        {"1 g", THUD_ACCELERATION, 9.80665},
        {"981 gal", THUD_ACCELERATION, 9.81},
        {"981 cm/s2", THUD_ACCELERATION, 9.81},
        {"9.81 m/s^2", THUD_ACCELERATION, 9.81},
        {"5 %", THUD_RATIO, 0.05},
        {"0.05", THUD_RATIO, 0.05},
        {"80 %", THUD_NUMBER, 0.8},
        {"+.5", THUD_NUMBER, 0.5},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        ck_assert_msg(si(rows[i].text, rows[i].dimension) == rows[i].value, "%s", rows[i].text);
}
END_TEST

START_TEST(power_stiffness_carries_its_exponent)
{
    struct thud_quantity q;
    ck_assert_int_eq(thud_quantity_parse("0.36 kN/mm^2.65", THUD_POWER_STIFFNESS, NULL, &q, NULL), THUD_OK);
    ck_assert_double_eq(q.exponent, 2.65);
    /* F = k d^n is the same force in both units */
    ck_assert_double_eq_tol(q.value * pow(0.04, 2.65), 0.36e3 * pow(40, 2.65), 1e-6);
    ck_assert_int_eq(thud_quantity_parse("80 kN/mm^2", THUD_POWER_STIFFNESS, NULL, &q, NULL), THUD_OK);
    ck_assert_double_eq(q.value, 80e9);
    ck_assert_int_eq(thud_quantity_parse("2 kN/mm", THUD_POWER_STIFFNESS, NULL, &q, NULL), THUD_OK);
    ck_assert_double_eq(q.exponent, 1);
    ck_assert_double_eq(q.value, 2e6);
    ck_assert_int_eq(thud_quantity_parse("2 kN/mm^n", THUD_POWER_STIFFNESS, NULL, &q, NULL), THUD_INPUT);
    ck_assert_int_eq(thud_quantity_parse("2 kN/mm^-1", THUD_POWER_STIFFNESS, NULL, &q, NULL), THUD_INPUT);
    ck_assert_int_eq(thud_quantity_parse("2 kN/mm^2.65", THUD_STIFFNESS, NULL, &q, NULL), THUD_INPUT);
}
END_TEST

static void refused(const char *text, enum thud_dimension dimension, const char *what, const char *allowed)
{
    struct thud_quantity q = {1234, 0};
    struct thud_error err = {0};
    ck_assert_msg(thud_quantity_parse(text, dimension, NULL, &q, &err) == THUD_INPUT, "%s is taken", text);
    ck_assert_msg(strstr(err.what, what), "%s: \"%s\" lacks \"%s\"", text, err.what, what);
    ck_assert_msg(strstr(err.allowed, allowed), "%s: \"%s\" lacks \"%s\"", text, err.allowed, allowed);
    ck_assert_double_eq(q.value, 1234);
}

START_TEST(refusals_name_the_remedy)
{
    refused("320 kN", THUD_MASS, "is a force; give a mass", "t, kg");
    refused("5 m m", THUD_LENGTH, "has no known unit", "mm");
    refused("5 kN  s2/m", THUD_MASS, "has no known unit", "t, kg");
    refused("320", THUD_MASS, "has no unit; give a mass", "t, kg");
    refused("0", THUD_LENGTH, "has no unit; give a length", "cm");
    refused("0,5 m", THUD_LENGTH, "decimal comma", "write 0.5 m");
    refused("1,234.5 m", THUD_LENGTH, "decimal comma", "");
    refused("5 parsec", THUD_LENGTH, "no known unit", "ft");
    refused("5 KG", THUD_MASS, "no known unit", "kg");
    refused("5 cm", THUD_NUMBER, "is a length; give a number", "");
    refused("wide", THUD_LENGTH, "is not a number", "m, cm");
    refused("", THUD_LENGTH, "nothing is given", "m, cm");
    refused("nan m", THUD_LENGTH, "is not a number", "");
    refused("inf", THUD_NUMBER, "is not a number", "");
    refused("-infinity m", THUD_LENGTH, "is not a number", "");
    refused("0x10 m", THUD_LENGTH, "is not a number", "");
    refused("1e999 m", THUD_LENGTH, "too large", "");
    refused("1e308 MN", THUD_FORCE, "too large", "");
    refused("5 cm cm", THUD_LENGTH, "no known unit", "");
    refused("5 cm; 3", THUD_LENGTH, "no known unit", "");
    char text[400];
    memset(text, '1', sizeof text);
    text[sizeof text - 1] = '\0';
    refused(text, THUD_NUMBER, "is not a number", "");
}
END_TEST

START_TEST(bare_numbers_take_the_unit_given_for_them)
{
    struct thud_quantity q;
    ck_assert_int_eq(thud_quantity_parse("5", THUD_LENGTH, "cm", &q, NULL), THUD_OK);
    ck_assert_double_eq(q.value, 0.05);
    ck_assert_int_eq(thud_quantity_parse("5 mm", THUD_LENGTH, "cm", &q, NULL), THUD_OK);
    ck_assert_double_eq(q.value, 0.005);
}
END_TEST

START_TEST(nothing_has_no_sign)
{
    ck_assert(!signbit(si("-0 cm", THUD_LENGTH)) && !signbit(si("-0.00e5", THUD_NUMBER)));
    ck_assert(si("-1e-300 cm", THUD_LENGTH) < 0);
    char text[32];
    thud_number_format(-0.0, text, sizeof text);
    ck_assert_str_eq(text, "0");
    const double value[] = {-0.0, -0.4, -0.5, -0.51, 0.4, -3};
    const char *const shown[] = {"+0", "+0", "+0", "-1", "+0", "-3"};
    for (size_t i = 0; i < sizeof value / sizeof *value; i++) {
        snprintf(text, sizeof text, "%+.0f", thud_shown(value[i], 0));
        ck_assert_str_eq(text, shown[i]);
    }
    snprintf(text, sizeof text, "%.2f", thud_shown(-0.005001, 2));
    ck_assert_str_eq(text, "-0.01");
}
END_TEST

START_TEST(digits_are_never_lost)
{
    static const struct {
        const char *text;
        enum thud_dimension dimension;
        const char *unit;
    } rows[] = {
        {"1.23456789 cm", THUD_LENGTH, "cm"},
        {"7 cm", THUD_LENGTH, "cm"},
        {"320 t", THUD_MASS, "t"},
        {"0.36 kN/mm^2.65", THUD_POWER_STIFFNESS, "kN/mm^2.65"},
        {"5 %", THUD_RATIO, "%"},
        {"0.821 g", THUD_ACCELERATION, "g"},
        {"12 in", THUD_LENGTH, "in"},
        {"0.001 mm", THUD_LENGTH, "mm"},
        {"-0.5 m/s", THUD_VELOCITY, "m/s"},
        {"1e-13", THUD_NUMBER, ""},
        {"1e20 kN/mm", THUD_STIFFNESS, "kN/mm"},
        {"0 cm", THUD_LENGTH, "cm"},
        {"2500 kN/mm", THUD_STIFFNESS, "kN/mm"},
        {"0.01", THUD_NUMBER, ""},
        {"1.7 kip/in", THUD_STIFFNESS, "kip/in"},
        {"3.1 psi", THUD_PRESSURE, "psi"},
        {"0.7 tonf s2/m", THUD_MASS, "tonf s2/m"},
    };
    char text[64];
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        thud_quantity_format(si(rows[i].text, rows[i].dimension), rows[i].unit, text, sizeof text);
        ck_assert_str_eq(text, rows[i].text);
    }
}
END_TEST

/* What is typed in feet, inches, pounds or g is shown in metric units as the decimal that it is, by whole numbers. */
START_TEST(values_of_other_units_are_short)
{
    static const struct {
        const char *from, *to;
        enum thud_dimension dimension;
        long long whole; /* one tenth of `from`, in units of 10^-places of `to` */
        int places;
    } rows[] = {{"ft", "cm", THUD_LENGTH, 3048, 3},
                {"in", "cm", THUD_LENGTH, 254, 3},
                {"lb", "kg", THUD_MASS, 45359237, 9},
                {"g", "m/s2", THUD_ACCELERATION, 980665, 6}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        for (int n = 1; n < 2000; n++) {
            char typed[32], shown[64], expected[300];
            long long size = 1, whole = n * rows[i].whole;
            unsigned char places = (unsigned char)rows[i].places;
            for (; places > 0 && whole % 10 == 0; places--)
                whole /= 10;
            for (int k = 0; k < places; k++)
                size *= 10;
            snprintf(typed, sizeof typed, "%d.%d %s", n / 10, n % 10, rows[i].from);
            if (places > 0)
                snprintf(expected, sizeof expected, "%lld.%0*lld %s", whole / size, places, whole % size, rows[i].to);
            else
                snprintf(expected, sizeof expected, "%lld %s", whole, rows[i].to);
            thud_quantity_format(si(typed, rows[i].dimension), rows[i].to, shown, sizeof shown);
            ck_assert_str_eq(shown, expected);
        }
}
END_TEST

static double random_double(uint64_t *state)
{
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    double unit = (double)(*state >> 11) / 9007199254740992.0;
    return (unit + 1e-3) * pow(10, (double)(int)(*state % 24) - 12);
}

START_TEST(any_value_reads_back_the_same_in_any_unit)
{
    static const char *const units[] = {"cm",         "mm",       "in",   "ft",  "m",  "t",   "kN/mm",
                                        "kN/mm^2.65", "N/mm^1.5", "g",    "gal", "ms", "%",   "",
                                        "cm2",        "GPa",      "cm/s", "psi", "lb", "tonf"};
    uint64_t state = 88172645463325252u;
    for (int i = 0; i < 20000; i++) {
        const char *unit = units[(size_t)i % (sizeof units / sizeof *units)];
        enum thud_dimension dimension = THUD_NUMBER;
        char text[64];
        ck_assert(thud_unit_factor(unit, &dimension, NULL) > 0);
        double value = random_double(&state);
        thud_quantity_format(value, unit, text, sizeof text);
        ck_assert_msg(si(text, dimension) == value, "%s is not %.17g", text, value);
    }
}
END_TEST

/* The lists shown in messages name units that exist, of that dimension. */
START_TEST(named_units_exist)
{
    for (int d = 0; d < THUD_DIMENSIONS; d++) {
        ck_assert_int_gt((int)strlen(thud_dimension_name((enum thud_dimension)d)), 0);
        char list[200], *next = list;
        snprintf(list, sizeof list, "%s", thud_dimension_units((enum thud_dimension)d));
        if (d == THUD_POWER_STIFFNESS)
            continue;
        for (char *unit = list; unit && *unit; unit = next) {
            next = strstr(unit, ", ");
            if (next) {
                *next = '\0';
                next += 2;
            }
            enum thud_dimension found = THUD_DIMENSIONS;
            ck_assert_msg(thud_unit_factor(unit, &found, NULL) > 0, "%s", unit);
            ck_assert_int_eq((int)found, d);
        }
    }
    ck_assert_double_eq(thud_unit_factor("furlong", NULL, NULL), 0);
    ck_assert_double_eq(thud_unit_factor("cm", NULL, NULL), 0.01);
}
END_TEST

/* Numbers of tables and sentences: no exponents, no change that is written as none. */
START_TEST(numbers_without_exponents)
{
    static const struct {
        double value;
        int digits;
        const char *text;
    } shown[] = {{11930, 4, "11930"}, {40580.4, 4, "40580"}, {9999.6, 4, "10000"}, {1552.84, 4, "1553"},
                 {6.26, 4, "6.26"},   {0.0123, 2, "0.012"},  {-20000, 4, "-20000"}};
    static const struct {
        double ratio;
        const char *text;
    } change[] = {{1.12, "+12 %"}, {0.998, "-0.2 %"}, {1.0004, "0 %"}, {1, "0 %"}, {0.9945, "-1 %"}, {1.0051, "+1 %"}};
    char text[32];
    for (size_t i = 0; i < sizeof shown / sizeof *shown; i++)
        ck_assert_str_eq(thud_digits(shown[i].value, shown[i].digits, text), shown[i].text);
    for (size_t i = 0; i < sizeof change / sizeof *change; i++)
        ck_assert_str_eq(thud_change_text(change[i].ratio, text), change[i].text);
}
END_TEST

/* Values in sentences: as they were typed, unless a factor between units has made more digits of them. */
START_TEST(long_numbers_are_said_short)
{
    static const char *const said[][2] = {{"0.29771561991900986 MN/m", "0.297716 MN/m"},
                                          {"595.4312398380196 MN/m", "595.431 MN/m"},
                                          {"-1234567.125000000001 N", "-1234567 N"},
                                          {"1.23456789 cm", "1.23456789 cm"},
                                          {"9.144 cm", "9.144 cm"},
                                          {"[0.29771561991900986 m]", "[0.29771561991900986 m]"},
                                          {"rubber", "rubber"},
                                          {"", ""}};
    char text[96];
    for (size_t i = 0; i < sizeof said / sizeof *said; i++)
        ck_assert_str_eq(thud_quantity_said(said[i][0], text), said[i][1]);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("quantity");
    TCase *tests = tcase_create("quantity");
    tcase_add_test(tests, units_are_what_they_are_defined_to_be);
    tcase_add_test(tests, power_stiffness_carries_its_exponent);
    tcase_add_test(tests, refusals_name_the_remedy);
    tcase_add_test(tests, bare_numbers_take_the_unit_given_for_them);
    tcase_add_test(tests, nothing_has_no_sign);
    tcase_add_test(tests, numbers_without_exponents);
    tcase_add_test(tests, long_numbers_are_said_short);
    tcase_add_test(tests, digits_are_never_lost);
    tcase_add_test(tests, values_of_other_units_are_short);
    tcase_add_test(tests, any_value_reads_back_the_same_in_any_unit);
    tcase_add_test(tests, named_units_exist);
    suite_add_tcase(suite, tests);
    return suite;
}
