/* Measures of a ground motion against signals whose measures are worked out by hand. */
#include <check.h>
#include <math.h>
#include <stdlib.h>

#include "base/quantity.h"
#include "ground/intensity.h"
#include "ground/record_edit.h"
#include "ground/spectrum.h"

static struct thud_record *make(const double *a, size_t samples, double dt)
{
    struct thud_record *record;
    ck_assert_int_eq(thud_record_create(a, samples, dt, &record, NULL), THUD_OK);
    return record;
}

static struct thud_intensity of(const double *a, size_t samples, double dt)
{
    struct thud_record *record = make(a, samples, dt);
    struct thud_intensity out = thud_intensity_of(record);
    thud_record_free(record);
    return out;
}

START_TEST(triangle)
{
    const double a[] = {0, 1, 0}; /* less its mean: -1/3, 2/3, -1/3 */
    struct thud_intensity m = of(a, 3, 1);
    ck_assert_double_eq(m.pga_mps2, 1);
    ck_assert_double_eq(m.pga_time_s, 1);
    ck_assert_double_eq_tol(m.arias_mps, THUD_PI / (2 * THUD_GRAVITY) * 2 / 3, 1e-15); /* integral of a^2: 2/3 */
    ck_assert_double_eq_tol(m.cav_mps, 1, 1e-15);
    /* between the samples: 1/6 at 1 s, and the triangle down to zero at 5/3 s */
    ck_assert_double_eq_tol(m.pgv_mps, 1.0 / 6 + 0.5 * (2.0 / 3) * (2.0 / 3), 1e-15);
    ck_assert_double_eq_tol(m.pgv_time_s, 5.0 / 3, 1e-15);
    ck_assert_double_eq_tol(m.mean_mps2, 1.0 / 3, 1e-15);
    ck_assert_double_eq_tol(m.pgd_m, 1.0 / 3, 1e-15);
    ck_assert_double_eq_tol(m.pgd_time_s, 2, 1e-15);
    ck_assert_double_eq_tol(m.duration_s, 2, 1e-15);
    /* t^3/3 = 5 % of 2/3, its mirror image for 95 %; 75 %: (2 - t)^3/3 = 1/6 */
    ck_assert_double_eq_tol(m.t5_s, cbrt(0.1), 1e-12);
    ck_assert_double_eq_tol(m.t95_s, 2 - cbrt(0.1), 1e-12);
    ck_assert_double_eq_tol(m.d5_95_s, 2 - 2 * cbrt(0.1), 1e-12);
    ck_assert_double_eq_tol(m.d5_75_s, 2 - cbrt(0.5) - cbrt(0.1), 1e-12);
    /* above 0.05 g = 0.4903325 for as long as the triangle is */
    ck_assert_double_eq_tol(m.bracketed_s, 2 * (1 - 0.05 * THUD_GRAVITY), 1e-12);
}
END_TEST

START_TEST(through_zero_within_a_step)
{
    const double a[] = {3, -1};
    struct thud_intensity m = of(a, 2, 1);
    ck_assert_double_eq_tol(m.cav_mps, 0.5 * 0.75 * 3 + 0.5 * 0.25 * 1, 1e-15);
    ck_assert_double_eq_tol(m.arias_mps, THUD_PI / (2 * THUD_GRAVITY) * (27 + 1) / 12, 1e-15);
    ck_assert_double_eq_tol(m.arias_trapezoid_mps, THUD_PI / (2 * THUD_GRAVITY) * (9 + 1) / 2, 1e-15);
}
END_TEST

START_TEST(constant)
{
    double a[101];
    for (int i = 0; i <= 100; i++)
        a[i] = -2;
    struct thud_intensity m = of(a, 101, 0.1);
    ck_assert_double_eq_tol(m.arias_mps, THUD_PI / (2 * THUD_GRAVITY) * 40, 1e-12);
    ck_assert_double_eq_tol(m.d5_95_s, 9, 1e-9);
    ck_assert_double_eq_tol(m.d5_75_s, 7, 1e-9);
    ck_assert_double_eq_tol(m.t5_s, 0.5, 1e-9);
    ck_assert_double_eq_tol(m.cav_mps, 20, 1e-12);
    ck_assert_double_eq_tol(m.bracketed_s, 10, 1e-12);
    ck_assert_double_eq_tol(m.pgv_mps, 0, 1e-12); /* all of it is mean */
}
END_TEST

START_TEST(quiet_and_silent)
{
    const double quiet[] = {0, 0.3, -0.2, 0.1}, silent[] = {0, 0, 0};
    ck_assert_double_eq(of(quiet, 4, 0.1).bracketed_s, 0);
    struct thud_intensity m = of(silent, 3, 0.1);
    ck_assert_double_eq(m.pga_mps2, 0);
    ck_assert_double_eq(m.arias_mps, 0);
    ck_assert(isnan(m.d5_95_s) && isnan(m.d5_75_s));
}
END_TEST

START_TEST(bracket_takes_first_and_last)
{
    /* 0.1 g up and down at both ends, quiet in between */
    const double g = 0.1 * THUD_GRAVITY, a[] = {0, g, 0, 0, 0, -g, 0, 0};
    ck_assert_double_eq_tol(of(a, 8, 1).bracketed_s, 5.5 - 0.5, 1e-12);
}
END_TEST

START_TEST(sine)
{
    enum { N = 10001 };
    static double a[N];
    const double dt = 0.001, period = 0.5, w = 2 * THUD_PI / period, big = 1.7; /* twenty cycles */
    for (int i = 0; i < N; i++)
        a[i] = big * sin(w * i * dt);
    struct thud_intensity m = of(a, N, dt);
    ck_assert_double_eq_tol(m.arias_mps, THUD_PI / (2 * THUD_GRAVITY) * big * big * 5, 1e-4);
    ck_assert_double_eq_tol(m.cav_mps, big * 20 / THUD_PI, 1e-3);
    ck_assert_double_eq_tol(m.pgv_mps, 2 * big / w, 1e-5); /* from rest: (1 - cos) */
    ck_assert_double_eq_tol(m.pgd_m, big / w * 10, 1e-4);
    ck_assert_double_eq_tol(m.d5_95_s, 9, 0.02);
    struct thud_record *record = make(a, N, dt);
    ck_assert_double_eq_tol(thud_record_predominant_period(record), period, 0.01);
    thud_record_free(record);
}
END_TEST

/* The maximum of the exact spectrum over a dense grid is found to 1 % of the period, however close a second one
 * comes. */
START_TEST(predominant_is_the_largest)
{
    double a[600];
    for (unsigned seed = 1; seed <= 12; seed++) {
        unsigned state = seed;
        for (int i = 0; i < 600; i++) {
            state = state * 1664525u + 1013904223u;
            a[i] = 0.2 * (sin(0.3 * i) + sin(1.1 * i)) + (double)(state >> 8) / 8388608.0 - 1;
        }
        struct thud_record *record = make(a, 600, 0.01);
        double found = thud_record_predominant_period(record), best = 0, largest = 0;
        for (int i = 0; i < 2040; i++) { /* 0.02 s to 9.5 s */
            double period = 0.02 * pow(1.003, i), sa = thud_spectrum_at(record, period, 0.05).acceleration_mps2;
            if (sa > largest) {
                largest = sa;
                best = period;
            }
        }
        ck_assert_double_eq_tol(found, best, 0.01 * best);
        ck_assert_double_ge(thud_spectrum_at(record, found, 0.05).acceleration_mps2, 0.999 * largest);
        thud_record_free(record);
    }
}
END_TEST

START_TEST(peaks_between_samples)
{
    /* the velocity turns in the middle of the third step: -1 - 1/4 */
    const double turns[] = {1, -1, -1, 1};
    struct thud_intensity m = of(turns, 4, 1);
    ck_assert_double_eq_tol(m.pgv_mps, 1.25, 1e-15);
    ck_assert_double_eq_tol(m.pgv_time_s, 2.5, 1e-15);
    /* the second step begins with v = 1/2, u = 5/12: v = 1/2 - t/2 - t^2/4 is 0 at sqrt(3) - 1 */
    const double returns[] = {1.5, -0.5, -1, 0}, t = sqrt(3) - 1;
    m = of(returns, 4, 1);
    ck_assert_double_eq_tol(m.pgd_m, 5.0 / 12 + t / 2 - t * t / 4 - t * t * t / 12, 1e-15);
    ck_assert_double_eq_tol(m.pgd_time_s, sqrt(3), 1e-14);
}
END_TEST

START_TEST(motion_of_a_parabola)
{
    /* a = 6 t - 3 over one second: v = 3 t^2 - 3 t, u = t^3 - 1.5 t^2, exactly */
    const double a[] = {-3, -1.5, 0, 1.5, 3};
    double v[5], u[5];
    struct thud_record *record = make(a, 5, 0.25);
    thud_record_integrate(record, v, u);
    for (int i = 0; i < 5; i++) {
        double t = 0.25 * i;
        ck_assert_double_eq_tol(v[i], 3 * t * t - 3 * t, 1e-15);
        ck_assert_double_eq_tol(u[i], t * t * t - 1.5 * t * t, 1e-15);
    }
    thud_record_free(record);
}
END_TEST

/* A sine of whole periods ends where it began; with a ramp of the acceleration its displacement ends at its largest. */
START_TEST(drift_is_told)
{
    double a[1001];
    for (int ramp = 0; ramp < 2; ramp++) {
        for (int i = 0; i < 1001; i++) /* cos: velocity sin, displacement 1 - cos */
            a[i] = cos(2 * acos(-1.0) * 5 * i / 1000) + ramp * 0.02 * (i - 500) / 500.0;
        struct thud_record *record = make(a, 1001, 0.01);
        struct thud_intensity m = thud_intensity_of(record);
        ck_assert_int_eq(m.drifts, ramp);
        if (ramp)
            ck_assert_double_eq_tol(fabs(m.end_m), m.pgd_m, 0.05 * m.pgd_m);
        thud_record_free(record);
    }
}
END_TEST

START_TEST(trimmed)
{
    const double a[] = {0, 1, 2, 3, 4, 5};
    struct thud_error err = {0};
    struct thud_record *record = make(a, 6, 0.1);
    ck_assert_int_eq(thud_record_trim(record, 0.1, 0.3, &err), THUD_OK); /* 0.3/0.1 is not quite 3 */
    ck_assert_uint_eq(record->samples, 3);
    ck_assert_double_eq(record->a_mps2[0], 1);
    ck_assert_double_eq(record->a_mps2[2], 3);
    ck_assert_int_eq(thud_record_trim(record, 5, NAN, &err), THUD_INPUT);
    ck_assert_int_eq(thud_record_trim(record, 0.15, 0.1, &err), THUD_INPUT);
    ck_assert_uint_eq(record->samples, 3);
    ck_assert_int_eq(thud_record_trim(record, NAN, NAN, &err), THUD_OK);
    ck_assert_uint_eq(record->samples, 3);
    thud_record_free(record);
}
END_TEST

START_TEST(baseline_taken_off)
{
    double line[7]; /* what stays has no mean and no slope */
    const double still[] = {1, -1, 0, 0, 0, -1, 1};
    for (int i = 0; i < 7; i++)
        line[i] = still[i] + 4 + 0.5 * i;
    struct thud_record *record = make(line, 7, 1);
    thud_record_baseline(record, THUD_BASELINE_LINEAR);
    for (int i = 0; i < 7; i++)
        ck_assert_double_eq_tol(record->a_mps2[i], still[i], 1e-14);
    thud_record_free(record);
    record = make(line, 7, 1);
    thud_record_baseline(record, THUD_BASELINE_MEAN);
    for (int i = 0; i < 7; i++)
        ck_assert_double_eq_tol(record->a_mps2[i], still[i] + 0.5 * (i - 3), 1e-14);
    thud_record_free(record);
}
END_TEST

START_TEST(resampled)
{
    const double a[] = {0, 1, -1, 4};
    struct thud_error err = {0};
    struct thud_record *record = make(a, 4, 0.03), *fine, *back, *none;
    ck_assert_int_eq(thud_record_resample(record, 0.01, &fine, &err), THUD_OK);
    ck_assert_uint_eq(fine->samples, 10);
    ck_assert_double_eq_tol(fine->a_mps2[4], 1.0 / 3, 1e-14);
    ck_assert_int_eq(thud_record_resample(fine, 0.03, &back, &err), THUD_OK);
    ck_assert_uint_eq(back->samples, 4);
    for (int i = 0; i < 4; i++)
        ck_assert_double_eq(back->a_mps2[i], a[i]);
    ck_assert_int_eq(thud_record_resample(record, 0, &none, &err), THUD_INPUT);
    ck_assert_int_eq(thud_record_resample(record, 1, &none, &err), THUD_INPUT);
    ck_assert_int_eq(thud_record_resample(record, 1e-12, &none, &err), THUD_INPUT);
    ck_assert_ptr_null(none);
    thud_record_free(record);
    thud_record_free(fine);
    thud_record_free(back);
}
END_TEST

Suite *thud_suite(void)
{
    Suite *suite = suite_create("intensity");
    TCase *all = tcase_create("all");
    tcase_add_test(all, triangle);
    tcase_add_test(all, through_zero_within_a_step);
    tcase_add_test(all, constant);
    tcase_add_test(all, quiet_and_silent);
    tcase_add_test(all, bracket_takes_first_and_last);
    tcase_add_test(all, sine);
    tcase_add_test(all, predominant_is_the_largest);
    tcase_add_test(all, peaks_between_samples);
    tcase_add_test(all, motion_of_a_parabola);
    tcase_add_test(all, drift_is_told);
    tcase_add_test(all, trimmed);
    tcase_add_test(all, baseline_taken_off);
    tcase_add_test(all, resampled);
    suite_add_tcase(suite, all);
    return suite;
}
