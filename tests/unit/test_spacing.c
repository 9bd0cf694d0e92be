/* The codes' rules against hand-computed figures and their limits. */
#include <check.h>
#include <math.h>

#include "study/scene/spacing.h"

START_TEST(rules_in_closed_form)
{
    ck_assert_double_eq_tol(thud_spacing_abs(0.3, 0.4), 0.7, 1e-15);
    ck_assert_double_eq_tol(thud_spacing_srss(0.3, 0.4), 0.5, 1e-15);
    /* rho 0.5: sqrt(0.09 + 0.16 - 0.12) */
    ck_assert_double_eq_tol(thud_spacing_ddc(0.3, 0.4, 0.5), 0.36055512754639892, 1e-15);
    ck_assert_double_eq_tol(thud_spacing_ddc(0.3, 0.4, 0), thud_spacing_srss(0.3, 0.4), 1e-15);
    ck_assert_double_eq_tol(thud_spacing_ddc(0.3, 0.3, 1), 0, 1e-15);
    ck_assert_double_eq_tol(thud_spacing_ddc(0.3, 0.4, -1), 0.7, 1e-15);
}
END_TEST

START_TEST(correlation_of_the_double_difference)
{
    /* r = 2, both 5 %: 8 * 0.05 * (0.05 * 3) * 2^1.5 / (9 + 4 * 0.0025 * 5 * 2 + 4 * 0.005 * 4) = 0.16970562748 / 9.18
     */
    ck_assert_double_eq_tol(thud_spacing_correlation(0.5, 0.05, 1, 0.05), 0.018486451795, 1e-11);
    /* r = 0.5, 2 % and 10 %: 8 sqrt(0.002) (0.1 + 0.01) 0.5^1.5 / (0.5625 + 4 * 0.002 * 1.25 * 0.5 + 4 * 0.0104 * 0.25)
     */
    double by_hand = 8 * sqrt(0.002) * 0.11 * pow(0.5, 1.5) / (0.5625 + 0.005 + 0.0104);
    ck_assert_double_eq_tol(thud_spacing_correlation(1, 0.02, 0.5, 0.1), by_hand, 1e-14);
    ck_assert_double_eq_tol(thud_spacing_correlation(0.7, 0.05, 0.7, 0.05), 1, 1e-14);
    /* the two buildings may change places */
    ck_assert_double_eq_tol(thud_spacing_correlation(0.4, 0.03, 0.6, 0.08),
                            thud_spacing_correlation(0.6, 0.08, 0.4, 0.03), 1e-14);
    ck_assert(thud_spacing_correlation(INFINITY, 0, 0.5, 0.05) == 0);
    ck_assert(thud_spacing_correlation(0.5, 0.05, INFINITY, 0) == 0);
    ck_assert(thud_spacing_correlation(0.5, 0, 0.6, 0) == 0);
    ck_assert(thud_spacing_correlation(0.5, 0, 0.5, 0) == 1);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("spacing");
    TCase *tcase = tcase_create("spacing");
    tcase_add_test(tcase, rules_in_closed_form);
    tcase_add_test(tcase, correlation_of_the_double_difference);
    suite_add_tcase(suite, tcase);
    return suite;
}
