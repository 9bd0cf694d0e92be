/* Roots in a bracket: known roots, ends, functions that mislead a secant. */
#include <check.h>
#include <float.h>
#include <math.h>

#include "core/numerics/root.h"

static int calls;

static double cosine(double x, const void *context)
{
    (void)context;
    calls++;
    return cos(x);
}

static double power(double x, const void *context)
{
    calls++;
    return pow(x, *(const double *)context) - 2;
}

static double line(double x, const void *context)
{
    calls++;
    return x - *(const double *)context;
}

/* Flat, then steep: a secant alone crawls. */
static double wall(double x, const void *context)
{
    calls++;
    return expm1(40 * (x - *(const double *)context));
}

START_TEST(known_roots)
{
    ck_assert_double_eq_tol(thud_root(cosine, NULL, 0, 3), acos(0), 4e-16);
    for (double p = 0.5; p < 60; p *= 2)
        ck_assert_double_eq_tol(thud_root(power, &p, 0, 8) / pow(2, 1 / p), 1, 1e-15);
    for (double at = 1e-300; at < 1; at *= 1e30)
        ck_assert_double_eq_tol(thud_root(line, &at, -1, 1) / at, 1, 1e-15);
}
END_TEST

START_TEST(ends)
{
    double at = 3;
    ck_assert_double_eq(thud_root(line, &at, 3, 4), 3);
    ck_assert_double_eq(thud_root(line, &at, 2, 3), 3);
    at = 0;
    ck_assert_double_eq_tol(thud_root(line, &at, -1, 3), 0, DBL_MIN);
}
END_TEST

START_TEST(number_of_calls)
{
    for (double at = 0.01; at < 1; at += 0.07) {
        calls = 0;
        ck_assert_double_eq_tol(thud_root(wall, &at, 0, 1) / at, 1, 1e-14);
        ck_assert_int_lt(calls, 60); /* bisection alone takes 54 */
    }
    double p = 3;
    calls = 0;
    thud_root(power, &p, 1, 2);
    ck_assert_int_lt(calls, 16);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("root");
    TCase *tests = tcase_create("root");
    tcase_add_test(tests, known_roots);
    tcase_add_test(tests, ends);
    tcase_add_test(tests, number_of_calls);
    suite_add_tcase(suite, tests);
    return suite;
}
