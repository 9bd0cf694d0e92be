/* Filters, polynomials, tapers and resampling of ground motions against closed forms. */
#include <check.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "ground/record_edit.h"
#include "ground/record_filter.h"

#define PI 3.14159265358979323846

static struct thud_record *make(size_t n, double dt)
{
    struct thud_record *record;
    double *a = calloc(n, sizeof *a);
    ck_assert_int_eq(thud_record_create(a, n, dt, &record, NULL), THUD_OK);
    free(a);
    return record;
}

/* 1 / (1 + W^(2n)): |H|^2 of one pass, the gain of two. */
static double gain(double low, double high, int order, double dt, double hz)
{
    double w = tan(PI * hz * dt), w1 = tan(PI * low * dt), ratio = w1 / w;
    if (!isnan(high)) {
        double w2 = tan(PI * high * dt);
        ratio = (w * w - w1 * w2) / ((w2 - w1) * w);
    }
    return 1 / (1 + pow(ratio * ratio, order));
}

/* The result to one sample of 1 in the middle has the closed form as its Fourier transform: real (no phase is shifted),
 * at every frequency. */
START_TEST(gain_is_butterworths_squared)
{
    static const struct {
        double low_hz, high_hz;
        int order;
    } filters[] = {{0.5, NAN, 1}, {0.5, NAN, 2}, {1, NAN, 3},  {0.5, NAN, 4}, {2, NAN, 5}, {0.3, NAN, 8}, {1, 10, 1},
                   {1, 10, 2},    {0.5, 20, 3},  {0.5, 25, 4}, {2, 8, 4},     {2, 3, 2},   {1, 45, 5},    {5, 40, 1}};
    const double dt = 0.01;
    struct thud_record_filter filter = {filters[_i].low_hz, filters[_i].high_hz, filters[_i].order};
    struct thud_record *impulse = make(12001, dt), *record;
    impulse->a_mps2[6000] = 1;
    ck_assert_int_eq(thud_record_filter_apply(impulse, &filter, &record, NULL), THUD_OK);
    size_t n = record->samples, middle = n / 2;
    ck_assert_double_eq_tol(
        (double)(n - 12001) * dt,
        3 * filter.order / fmin(filter.low_hz, isnan(filter.high_hz) ? 1e9 : filter.high_hz - filter.low_hz), 2.1 * dt);
    for (double hz = 0.05; hz < 50; hz *= 1.3) {
        double re = 0, im = 0;
        for (size_t i = 0; i < n; i++) {
            double angle = 2 * PI * hz * dt * ((double)i - (double)middle);
            re += record->a_mps2[i] * cos(angle);
            im -= record->a_mps2[i] * sin(angle);
        }
        ck_assert_double_eq_tol(re, gain(filter.low_hz, filter.high_hz, filter.order, dt, hz), 1e-8);
        ck_assert_double_eq_tol(im, 0, 1e-8);
    }
    for (size_t i = 1; i <= middle; i++) /* the same to the left and to the right */
        ck_assert_double_eq_tol(record->a_mps2[middle - i], record->a_mps2[middle + i], 1e-10);
    thud_record_free(impulse);
    thud_record_free(record);
}
END_TEST

START_TEST(corners_that_cannot_be)
{
    struct thud_record *record = make(100, 0.01), *none;
    const struct thud_record_filter wrong[] = {
        {0, NAN, 4},   {-1, NAN, 4}, {50, NAN, 4}, {2, 1, 4},
        {1, 50, 4},    {1, 1, 4},    {1, NAN, 0},  {1, NAN, THUD_FILTER_ORDER_MAX + 1},
        {1e-9, NAN, 4}};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        struct thud_error err = {0};
        ck_assert_int_eq(thud_record_filter_apply(record, &wrong[i], &none, &err), THUD_INPUT);
        ck_assert_ptr_null(none);
        ck_assert_str_ne(err.allowed, "");
    }
    thud_record_free(record);
}
END_TEST

/* A polynomial is taken off to nothing by its own degree and by every higher one, and what has no part of it stays. */
START_TEST(polynomials_are_found)
{
    const size_t n = 4001;
    for (int degree = 0; degree <= THUD_BASELINE_MAX; degree++)
        for (int by = degree; by <= THUD_BASELINE_MAX; by++) {
            struct thud_record *record = make(n, 0.01);
            for (size_t i = 0; i < n; i++)
                for (int k = 0; k <= degree; k++)
                    record->a_mps2[i] += pow(-1, k) * (k + 1) * pow((double)i / (double)(n - 1), k);
            thud_record_baseline(record, by);
            for (size_t i = 0; i < n; i++)
                ck_assert_double_eq_tol(record->a_mps2[i], 0, 1e-11);
            thud_record_free(record);
        }
    struct thud_record *record = make(n, 0.01); /* odd about the middle: even degrees find nothing new */
    for (size_t i = 0; i < n; i++)
        record->a_mps2[i] = pow((double)i - 2000, 3) / 8e9;
    thud_record_baseline(record, 2); /* x^3 - 3/5 x, but for the samples' own sums */
    for (size_t i = 0; i < n; i++) {
        double x = ((double)i - 2000) / 2000;
        ck_assert_double_eq_tol(record->a_mps2[i], x * x * x - 0.6 * x, 1e-3);
        ck_assert_double_eq_tol(record->a_mps2[i], -record->a_mps2[n - 1 - i], 1e-12);
    }
    thud_record_free(record);
    record = make(3, 0.01); /* no more than the samples determine */
    record->a_mps2[1] = 1;
    thud_record_baseline(record, THUD_BASELINE_MAX);
    for (size_t i = 0; i < 3; i++)
        ck_assert_double_eq_tol(record->a_mps2[i], 0, 1e-14);
    thud_record_free(record);
}
END_TEST

START_TEST(tapers_are_cosines)
{
    struct thud_record *record = make(101, 0.1);
    struct thud_error err = {0};
    for (size_t i = 0; i < 101; i++)
        record->a_mps2[i] = 2;
    ck_assert_int_eq(thud_record_taper(record, 2, &err), THUD_OK); /* 20 steps */
    for (size_t i = 0; i < 101; i++) {
        double from_end = fmin((double)i, 100 - (double)i) * 0.1;
        double wanted = from_end >= 2 ? 2 : 2 * pow(sin(0.25 * PI * from_end), 2);
        ck_assert_double_eq_tol(record->a_mps2[i], wanted, 1e-14);
    }
    ck_assert_int_eq(thud_record_taper(record, 5.01, &err), THUD_INPUT);
    ck_assert_int_eq(thud_record_taper(record, -1, &err), THUD_INPUT);
    ck_assert_int_eq(thud_record_taper(record, 0, &err), THUD_OK);
    ck_assert_double_eq(record->a_mps2[50], 2);
    thud_record_free(record);
}
END_TEST

/* Straight lines between samples are off a sine by at most (omega dt)^2 / 8, and that in the middle of a step. */
START_TEST(a_sine_is_resampled)
{
    const double omega = 2 * PI * 1.5, dt = 0.02;
    struct thud_record *record = make(501, dt), *fine, *third;
    for (size_t i = 0; i < 501; i++)
        record->a_mps2[i] = sin(omega * dt * (double)i);
    ck_assert_int_eq(thud_record_resample(record, dt / 4, &fine, NULL), THUD_OK);
    ck_assert_uint_eq(fine->samples, 2001);
    double worst = 0, bound = omega * dt * omega * dt / 8;
    for (size_t i = 0; i < fine->samples; i++)
        worst = fmax(worst, fabs(fine->a_mps2[i] - sin(omega * dt / 4 * (double)i)));
    ck_assert_double_le(worst, bound);
    ck_assert_double_ge(worst, 0.95 * bound);
    ck_assert_int_eq(thud_record_resample(record, 0.03, &third, NULL), THUD_OK);
    for (size_t i = 0; i < third->samples; i += 2) /* every other one is a sample of the record */
        ck_assert_double_eq(third->a_mps2[i], record->a_mps2[3 * i / 2]);
    thud_record_free(record);
    thud_record_free(fine);
    thud_record_free(third);
}
END_TEST

/* Thinned, what is slow is the resampled motion, and what is faster than half the new rate is gone. */
START_TEST(thinning_keeps_what_is_slow)
{
    const double dt = 0.01;
    const int every = _i;
    struct thud_record *record = make(2001, dt), *plain;
    struct thud_error err = {0};
    for (size_t i = 0; i < record->samples; i++) {
        const double t = dt * (double)i, away = (t - 10) / 3;
        record->a_mps2[i] = exp(-away * away) * sin(2 * PI * 2 * t);
    }
    ck_assert_int_eq(thud_record_resample(record, every * dt, &plain, NULL), THUD_OK);
    for (size_t i = 0; i < record->samples; i++) { /* 45 Hz, beside 25 Hz and less */
        const double away = (dt * (double)i - 10) / 3;
        record->a_mps2[i] += exp(-away * away) * sin(2 * PI * 45 * dt * (double)i);
    }
    ck_assert_int_eq(thud_record_low_pass(record, every, every, &err), THUD_OK);
    ck_assert_uint_eq(record->samples, 2000 / (size_t)every + 1);
    ck_assert_double_eq_tol(record->dt_s, every * dt, 1e-15);
    for (size_t i = 0; i < record->samples && i < plain->samples; i++)
        ck_assert_double_eq_tol(record->a_mps2[i], plain->a_mps2[i], 2e-3);
    ck_assert_int_eq(thud_record_low_pass(record, 5000, 5000, &err), THUD_INPUT);
    thud_record_free(record);
    thud_record_free(plain);
}
END_TEST

/* A low pass at a corner that is no whole fraction of the rate: what is slower by a sixth stays, what is faster is
 * gone. */
START_TEST(a_low_pass_keeps_what_is_slow)
{
    const double dt = 0.01, corner_hz = 7.3, slow_hz = corner_hz / 1.25, fast_hz = corner_hz * 1.25;
    struct thud_record *record = make(2001, dt);
    for (size_t i = 0; i < record->samples; i++) {
        const double t = dt * (double)i, away = (t - 10) / 3;
        record->a_mps2[i] = exp(-away * away) * (sin(2 * PI * slow_hz * t) + sin(2 * PI * fast_hz * t));
    }
    ck_assert_int_eq(thud_record_low_pass(record, 1 / (2 * corner_hz * dt), 1, NULL), THUD_OK);
    ck_assert_uint_eq(record->samples, 2001);
    for (size_t i = 0; i < record->samples; i++) {
        const double t = dt * (double)i, away = (t - 10) / 3;
        ck_assert_double_eq_tol(record->a_mps2[i], exp(-away * away) * sin(2 * PI * slow_hz * t), 2e-3);
    }
    thud_record_free(record);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("record filter");
    TCase *all = tcase_create("all");
    tcase_set_timeout(all, 30);
    tcase_add_loop_test(all, gain_is_butterworths_squared, 0, 14);
    tcase_add_test(all, corners_that_cannot_be);
    tcase_add_test(all, polynomials_are_found);
    tcase_add_test(all, tapers_are_cosines);
    tcase_add_test(all, a_sine_is_resampled);
    tcase_add_loop_test(all, thinning_keeps_what_is_slow, 2, 6);
    tcase_add_test(all, a_low_pass_keeps_what_is_slow);
    suite_add_tcase(suite, all);
    return suite;
}
