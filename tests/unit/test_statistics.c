/* Quantiles and fractiles by hand. */
#include <check.h>
#include <math.h>

#include "base/statistics.h"

START_TEST(quantiles_by_hand)
{
    double x[] = {1, 2, 4, 8, 16}, y[] = {3, NAN, -1, 2};
    ck_assert(thud_quantile(x, 5, 0.5, false) == 4);
    ck_assert_double_eq_tol(thud_quantile(x, 5, 0.16, false), 1 + 0.64, 1e-15); /* h = 4 x 0.16 */
    ck_assert_double_eq_tol(thud_quantile(x, 5, 0.16, true), pow(2, 0.64), 1e-15);
    ck_assert(thud_quantile(x, 5, 1, true) == 16);
    ck_assert(thud_quantile(x, 1, 0.3, false) == 1);
    ck_assert(isnan(thud_quantile(x, 0, 0.5, false)));
    struct thud_fractiles f = thud_fractiles_of(x, 5, 5, 3);
    ck_assert_double_eq_tol(f.p84 * f.p16, 16, 1e-14); /* symmetric about the median in logarithms */
    ck_assert_double_eq_tol(f.share, 0.6, 1e-15);
    f = thud_fractiles_of(y, 4, 4, 0); /* not all positive: of the values; what has no result is left out */
    ck_assert_uint_eq(f.n, 3);
    ck_assert(f.median == 2);
    ck_assert_double_eq_tol(f.p16, -1 + 0.32 * 3, 1e-15);
    ck_assert(f.least == -1);
    ck_assert(f.most == 3);
    double ratios[] = {0.5, 1 + 1e-12, NAN, 1, 1.5, 2};
    f = thud_fractiles_of(ratios, 6, 6, 1); /* what is equal but for rounding is neither */
    ck_assert(f.n == 5 && f.below == 1 && f.above == 2);
    double same[] = {7, 7, 7};
    f = thud_fractiles_of(same, 3, 3, 7);
    ck_assert(f.p16 == 7 && f.median == 7 && f.p84 == 7 && f.share == 0);
    f = thud_fractiles_of(same, 3, 2, 7); /* two of them are of one motion */
    ck_assert(isnan(f.p16) && f.median == 7 && isnan(f.p84));
}
END_TEST

/* The ends of Wilson's interval are the shares p whose own normal deviation is the quantile: (share - p)^2 = z^2 p (1 -
 * p) / n. */
START_TEST(share_band_solves_its_equation)
{
    static const double z = 1.6448536269514722;
    static const size_t n[] = {1, 3, 24, 1000};
    for (size_t i = 0; i < sizeof n / sizeof *n; i++)
        for (size_t count = 0; count <= n[i]; count += n[i] > 3 ? n[i] / 4 : 1) {
            double low, high, share = (double)count / (double)n[i];
            thud_share_band(count, n[i], 1, &low, &high);
            ck_assert(low >= 0 && low <= share + 1e-15 && share <= high + 1e-15 && high <= 1);
            ck_assert_double_eq_tol(pow(share - low, 2), z * z * low * (1 - low) / (double)n[i], 1e-14);
            ck_assert_double_eq_tol(pow(share - high, 2), z * z * high * (1 - high) / (double)n[i], 1e-14);
        }
    double low, high;
    thud_share_band(0, 0, 1, &low, &high);
    ck_assert(isnan(low) && isnan(high));
}
END_TEST

/* Enough for at least so many: of two motions 84 % is both, of seven six. Pairs count as one. */
START_TEST(order_statistics)
{
    double two[] = {1, 2}, x[] = {1, 2, 3, 4, 5, 6, 7}, same[] = {1, 3, 3, 3};
    size_t count;
    ck_assert(thud_enough(two, 2, 0.84, &count) == 2 && count == 2);
    ck_assert(thud_enough(two, 2, 0.5, &count) == 1 && count == 1);
    ck_assert(thud_enough(x, 7, 0.84, &count) == 6 && count == 6);
    ck_assert(thud_enough(x, 7, 0.5, &count) == 4 && count == 4);
    ck_assert(thud_enough(same, 4, 0.5, &count) == 3 && count == 4);
    double many[25];
    for (int i = 0; i < 25; i++)
        many[i] = i + 1;
    ck_assert(thud_enough(many, 25, 0.84, &count) == 21);
    ck_assert(isnan(thud_enough(x, 0, 0.5, &count)) && count == 0);
    double low, high, other_low, other_high;
    thud_share_band(6, 14, 0.5, &low, &high);
    thud_share_band(3, 7, 1, &other_low, &other_high);
    ck_assert_double_eq_tol(low, other_low, 1e-15);
    ck_assert_double_eq_tol(high, other_high, 1e-15);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("statistics");
    TCase *tcase = tcase_create("statistics");
    tcase_add_test(tcase, quantiles_by_hand);
    tcase_add_test(tcase, share_band_solves_its_equation);
    tcase_add_test(tcase, order_statistics);
    suite_add_tcase(suite, tcase);
    return suite;
}
