/* Crossings and peaks of polynomials, where they are easy to miss. */
#include <check.h>
#include <math.h>

#include "base/quantity.h"
#include "core/numerics/poly.h"

/* Coefficients of lead (s - r0)(s - r1)..., out (n + 1). */
static void from_roots(double lead, const double *root, int n, double *out)
{
    out[0] = lead;
    for (int i = 0; i < n; i++) {
        out[i + 1] = 0;
        for (int k = i + 1; k >= 0; k--)
            out[k] = (k > 0 ? out[k - 1] : 0) - root[i] * out[k];
    }
}

START_TEST(first_of_several_roots)
{
    double c[6];
    from_roots(1, (double[]){0.2, 0.5, 0.9}, 3, c); /* negative, positive from 0.2 to 0.5, negative, positive */
    ck_assert_double_eq_tol(thud_poly_first_above(c, 4, 1, 1, 0, 0), 0.2, 1e-15);
    ck_assert_double_eq(thud_poly_first_above(c, 4, 1, -1, 0, 0), 0);
    ck_assert(isinf(thud_poly_first_above(c, 4, 0.1999999, 1, 0, 0)));
}
END_TEST

START_TEST(close_pair_inside_a_step)
{
    double c[4];
    for (double gap = 1e-2; gap > 1e-7; gap /= 10) { /* -(s - a)(s - b): above 0 between a and b only */
        from_roots(-1, (double[]){0.37, 0.37 + gap}, 2, c);
        double s = thud_poly_first_above(c, 3, 1, 1, 0, 0);
        ck_assert_double_eq_tol(s, 0.37, 1e-15 / gap);
    }
}
END_TEST

START_TEST(grazing_from_both_sides)
{
    for (double miss = 1e-4; miss > 1e-14; miss /= 10) { /* -(s - 0.61)^2 -+ miss */
        double over[] = {-0.61 * 0.61 + miss, 1.22, -1}, under[] = {-0.61 * 0.61 - miss, 1.22, -1};
        ck_assert_double_eq_tol(thud_poly_first_above(over, 3, 1, 1, 0, 0), 0.61 - sqrt(miss),
                                1e-16 / sqrt(miss) + 1e-14);
        ck_assert(isinf(thud_poly_first_above(under, 3, 1, 1, 0, 0)));
    }
}
END_TEST

START_TEST(zeros_at_the_start_are_not_found_again)
{
    double leaves[] = {3e-17, -1, 0.5}, comes_back[] = {-3e-17, -0.3, 1}, rises[] = {-3e-17, 0.3, 1};
    ck_assert(isinf(thud_poly_first_above(leaves, 3, 1, 1, 1, 0)));
    ck_assert_double_eq_tol(thud_poly_first_above(comes_back, 3, 1, 1, 1, 0), 0.3, 1e-15);
    ck_assert_double_eq(thud_poly_first_above(rises, 3, 1, 1, 1, 0), 0);
    double higher[] = {0, 0, 1e-30, -1}; /* exact zeros are taken off as they come */
    ck_assert_double_eq(thud_poly_first_above(higher, 4, 1, 1, 0, 0), 0);
    double nothing[] = {0, 0, 0};
    ck_assert(isinf(thud_poly_first_above(nothing, 3, 1, 1, 0, 0)));
}
END_TEST

START_TEST(rounding_is_no_crossing)
{
    double c[] = {-1e-17, 4e-17, -4e-17};
    ck_assert(isinf(thud_poly_first_above(c, 3, 1, 1, 0, 1e-15)));
}
END_TEST

START_TEST(peak_of_a_sine)
{
    double c[24] = {0}, w = 2.5, fact = 1, where = -1;
    for (int k = 1; k < 24; k++) {
        fact *= w / k;
        c[k] = k % 2 ? (k % 4 == 1 ? fact : -fact) : 0; /* sin(2.5 s) */
    }
    ck_assert_double_eq_tol(thud_poly_peak(c, 24, 1, 0, &where), 1, 1e-15);
    ck_assert_double_eq_tol(where, THUD_PI / 5, 1e-8);
    ck_assert_double_eq_tol(thud_poly_peak(c, 24, 0.3, 0, &where), sin(0.75), 1e-15);
    ck_assert_double_eq(where, 0.3);
}
END_TEST

START_TEST(peak_is_left_alone_below_the_least)
{
    double c[] = {0.5, -2, 1.9}, where = 7;
    ck_assert_double_eq(thud_poly_peak(c, 3, 1, 3, &where), 3);
    ck_assert_double_eq(where, 7);
    double value = thud_poly_peak(c, 3, 1, 0.45, &where); /* 0.5 at s = 0, and -0.026 inside */
    ck_assert_double_eq(value, 0.5);
    ck_assert_double_eq(where, 0);
}
END_TEST

/* Against a fine grid: the peak found is never below any sample and no more than the grid's own error above them. */
START_TEST(peaks_against_a_grid)
{
    unsigned seed = 1;
    for (int trial = 0; trial < 300; trial++) {
        double c[12], grid = 0, where;
        for (int k = 0; k < 12; k++) {
            seed = seed * 1664525u + 1013904223u;
            c[k] = ((double)(seed >> 8) / 8388608.0 - 1) * (k < 4 ? 1 : 5);
        }
        for (int i = 0; i <= 20000; i++)
            grid = fmax(grid, fabs(thud_poly_value(c, 12, i / 20000.0)));
        double peak = thud_poly_peak(c, 12, 1, 0, &where);
        ck_assert_double_ge(peak, grid);
        ck_assert_double_le(peak, grid + 5 * 12 * 12 * 12 * 12 / (8 * 4e8));
        ck_assert_double_eq_tol(fabs(thud_poly_value(c, 12, where)), peak, 1e-15 * peak);
    }
}
END_TEST

/* Coefficients that fall as a series' do: like those of a motion over one step. */
static void series(unsigned *seed, double start, int n, double *c)
{
    double size = 1;
    for (int k = 0; k < n; k++, size *= 0.9 / k) {
        *seed = *seed * 1664525u + 1013904223u;
        c[k] = ((double)(*seed >> 8) / 8388608.0 - 1) * (k == 0 ? start : size);
    }
}

/* p, p' and sum |c_k| s^k by Horner's scheme in extended precision. */
static void extended(const double *c, int n, double s, long double *p, long double *slope, long double *size)
{
    *p = *slope = *size = 0;
    for (int k = n - 1; k >= 0; k--) {
        *slope = *slope * s + *p;
        *p = *p * s + c[k];
        *size = *size * s + fabs(c[k]);
    }
}

/* A crossing is as near as the rounding of p lets it be, whatever way led to it. */
START_TEST(crossings_to_rounding)
{
    unsigned seed = 3;
    int found = 0;
    for (int trial = 0; trial < 20000; trial++) {
        double c[20];
        int n = 8 + trial % 13;
        long double p, slope, size;
        series(&seed, 0.3, n, c);
        double s = thud_poly_first_above(c, n, 1, 1, 0, 0);
        if (!(s > 0 && s < 1))
            continue;
        extended(c, n, s, &p, &slope, &size);
        ck_assert(fabsl(p) <= 1.2e-15L * size + 4e-16L * s * fabsl(slope));
        found++;
    }
    ck_assert_int_gt(found, 2000);
}
END_TEST

/* A peak inside lies where the slope is 0, to 1e-12 of the way. */
START_TEST(peaks_lie_where_the_slope_is_0)
{
    unsigned seed = 5;
    int found = 0;
    for (int trial = 0; trial < 20000; trial++) {
        double c[20], derivative[19], where = 0;
        int n = 8 + trial % 13;
        long double slope, bend, size;
        series(&seed, 0.3, n, c);
        thud_poly_peak(c, n, 1, 0, &where);
        if (!(where > 0 && where < 1))
            continue;
        for (int k = 1; k < n; k++)
            derivative[k - 1] = k * c[k];
        extended(derivative, n - 1, where, &slope, &bend, &size);
        ck_assert(fabsl(slope) <= 2e-12L * fabsl(bend) + 2e-15L * size);
        found++;
    }
    ck_assert_int_gt(found, 2000);
}
END_TEST

/* Series read up to an end of their own, above a least value that some of them pass: against a grid, and attained. */
START_TEST(peaks_of_series_against_a_grid)
{
    unsigned seed = 9;
    int kind[3] = {0}; /* at the start, inside, at the end */
    for (int trial = 0; trial < 4000; trial++) {
        double c[20], where = -1, grid = 0, least = trial % 3 ? 0.4 : 0, s_end = trial % 2 ? 1 : 0.4;
        int n = 1 + trial % 20;
        series(&seed, 1, n, c);
        for (int i = 0; i <= 500; i++)
            grid = fmax(grid, fabs(thud_poly_value(c, n, s_end * i / 500)));
        double peak = thud_poly_peak(c, n, s_end, least, &where);
        ck_assert_double_ge(peak, fmax(grid, least) - 1e-15);
        ck_assert_double_le(peak, fmax(grid, least) + 4 * s_end * s_end / (8 * 250000.0));
        ck_assert_int_eq(where >= 0, peak > least);
        if (peak > least) {
            ck_assert_double_eq_tol(fabs(thud_poly_value(c, n, where)), peak, 1e-15);
            kind[where == 0 ? 0 : where == s_end ? 2 : 1]++;
        }
    }
    ck_assert_int_gt(kind[0], 300);
    ck_assert_int_gt(kind[1], 200);
    ck_assert_int_gt(kind[2], 300);
}
END_TEST

/* Newton's step from the middle lands on the peak to the last bit, where it is an end of the bracket. */
START_TEST(peak_met_in_one_step)
{
    for (int i = 1; i < 10; i++) { /* 1 + r s - s^2/2, but for a term that is nothing there */
        double r = 0.03 * i, c[21] = {1, r, -0.5, [20] = 1e-13}, where = 0;
        ck_assert_double_eq_tol(thud_poly_peak(c, 21, 1, 0, &where), 1 + r * r / 2, 1e-15);
        ck_assert_double_eq_tol(where, r, 1e-12);
    }
}
END_TEST

/* Between its roots, and from a root at 0 on. */
START_TEST(part_above_zero)
{
    static const double root[] = {0.125, 0.25, 0.5, 0.625}, from_zero[] = {0, 0.75};
    double c[5];
    from_roots(1, root, 4, c);
    ck_assert_double_eq_tol(thud_poly_above(c, 5, 1), 0.125 + 0.25 + 0.375, 1e-12);
    ck_assert_double_eq_tol(thud_poly_above(c, 5, 0.3), 0.125 + 0.05, 1e-12);
    from_roots(-1, root, 4, c);
    ck_assert_double_eq_tol(thud_poly_above(c, 5, 1), 0.125 + 0.125, 1e-12);
    from_roots(-1, from_zero, 2, c);
    ck_assert_double_eq_tol(thud_poly_above(c, 3, 1), 0.75, 1e-12);
    from_roots(1, from_zero, 2, c);
    ck_assert_double_eq_tol(thud_poly_above(c, 3, 1), 0.25, 1e-12);
    ck_assert_double_eq(thud_poly_above((double[]){1, 0}, 2, 0.7), 0.7);
    ck_assert_double_eq(thud_poly_above((double[]){0, 0}, 2, 0.7), 0);
}
END_TEST

Suite *thud_suite(void)
{
    Suite *suite = suite_create("poly");
    TCase *tc = tcase_create("poly");
    tcase_add_test(tc, first_of_several_roots);
    tcase_add_test(tc, close_pair_inside_a_step);
    tcase_add_test(tc, grazing_from_both_sides);
    tcase_add_test(tc, zeros_at_the_start_are_not_found_again);
    tcase_add_test(tc, rounding_is_no_crossing);
    tcase_add_test(tc, peak_of_a_sine);
    tcase_add_test(tc, peak_is_left_alone_below_the_least);
    tcase_add_test(tc, peaks_against_a_grid);
    tcase_add_test(tc, crossings_to_rounding);
    tcase_add_test(tc, peaks_lie_where_the_slope_is_0);
    tcase_add_test(tc, peaks_of_series_against_a_grid);
    tcase_add_test(tc, peak_met_in_one_step);
    tcase_add_test(tc, part_above_zero);
    suite_add_tcase(suite, tc);
    return suite;
}
