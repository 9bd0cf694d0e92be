/* The generator against its published sequence, the normal distribution against tables. */
#include <check.h>
#include <math.h>
#include <stdlib.h>

#include "base/random.h"

/* The first numbers from the seed 1234567, as in the reference implementation's tests. */
START_TEST(the_generator_gives_its_published_sequence)
{
    struct thud_random random = {1234567};
    const uint64_t first[] = {6457827717110365317ULL, 3203168211198807973ULL, 9817491932198370423ULL,
                              4593380528125082431ULL, 16408922859458223821ULL};
    for (int i = 0; i < 5; i++)
        ck_assert_uint_eq(thud_random_next(&random), first[i]);
    double sum = 0, square = 0;
    long hit[7] = {0};
    for (int i = 0; i < 70000; i++) {
        double u = thud_random_unit(&random);
        ck_assert(u >= 0 && u < 1);
        sum += u;
        square += u * u;
        hit[thud_random_below(&random, 7)]++;
    }
    ck_assert_double_eq_tol(sum / 70000, 0.5, 5 * sqrt(1 / 12.0 / 70000));
    ck_assert_double_eq_tol(square / 70000, 1 / 3.0, 5 * sqrt(4 / 45.0 / 70000));
    for (int i = 0; i < 7; i++)
        ck_assert_int_lt(labs(hit[i] - 10000), 500);
}
END_TEST

START_TEST(the_normal_distribution)
{
    ck_assert_double_eq_tol(thud_normal_cdf(0), 0.5, 1e-16);
    ck_assert_double_eq_tol(thud_normal_cdf(-1), 0.15865525393145705, 1e-15);
    ck_assert_double_eq_tol(thud_normal_quantile(0.975), 1.959963984540054, 1e-13);
    ck_assert_double_eq_tol(thud_normal_quantile(0.05), -1.6448536269514722, 1e-13);
    ck_assert_double_eq_tol(thud_normal_quantile(1e-12), -7.034483825301131, 1e-9);
    ck_assert_double_eq_tol(thud_normal_quantile(0.5), 0, 1e-12);
    for (double p = 0.001; p < 1; p += 0.0173)
        ck_assert_double_eq_tol(thud_normal_cdf(thud_normal_quantile(p)), p, 1e-14);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("random");
    TCase *tcase = tcase_create("random");
    tcase_add_test(tcase, the_generator_gives_its_published_sequence);
    tcase_add_test(tcase, the_normal_distribution);
    suite_add_tcase(suite, tcase);
    return suite;
}
