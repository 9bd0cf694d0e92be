/* Response spectra against closed forms (a step, a sine, the limits of stiff and soft), against brute force with small
 * steps, and against a run of the core with one floor. */
#include <check.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <time.h>

#include "base/quantity.h"
#include "core/model/model.h"
#include "core/run/run.h"
#include "ground/intensity.h"
#include "ground/oscillator.h"
#include "ground/spectrum.h"

static struct thud_record *make(const double *a, size_t samples, double dt)
{
    struct thud_record *record;
    ck_assert_int_eq(thud_record_create(a, samples, dt, &record, NULL), THUD_OK);
    return record;
}

/* A ragged motion, the same every time. */
static struct thud_record *ragged(size_t samples, double dt)
{
    double *a = malloc(samples * sizeof *a);
    uint32_t state = 12345;
    for (size_t i = 0; i < samples; i++) {
        state = state * 1664525u + 1013904223u;
        a[i] = (double)(state >> 8) / 8388608.0 - 1;
    }
    struct thud_record *record = make(a, samples, dt);
    free(a);
    return record;
}

START_TEST(step_without_damping)
{
    double a[201];
    for (int i = 0; i <= 200; i++)
        a[i] = 3;
    struct thud_record *record = make(a, 201, 0.05);
    const double periods[] = {0.1, 0.37, 1.0, 10.0 / 7};
    for (int i = 0; i < 4; i++) {
        double w = 2 * THUD_PI / periods[i];
        struct thud_spectrum_point p = thud_spectrum_at(record, periods[i], 0);
        /* what follows the step's end is its mirror: at most twice as large, and nothing where it ends at rest */
        double left = 2 * fabs(sin(w * 10 / 2)), least = 2 * 3 / (w * w), after = left * 3 / (w * w);
        ck_assert_double_eq_tol(p.displacement_m, fmax(least, after), 1e-9 * least);
        ck_assert_double_eq_tol(p.acceleration_mps2, fmax(least, after) * w * w, 1e-8);
        ck_assert_double_eq_tol(p.velocity_mps, fmax(3 / w, after * w), 1e-8);
    }
    thud_record_free(record);
}
END_TEST

START_TEST(step_with_damping)
{
    double a[401];
    for (int i = 0; i <= 400; i++)
        a[i] = -2;
    struct thud_record *record = make(a, 401, 0.05);
    const double periods[] = {0.13, 0.5, 1.1}, dampings[] = {0.02, 0.05, 0.3};
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
            double w = 2 * THUD_PI / periods[i], z = dampings[k], root = sqrt(1 - z * z);
            struct thud_spectrum_point p = thud_spectrum_at(record, periods[i], z);
            ck_assert_double_eq_tol(p.displacement_m * w * w / 2, 1 + exp(-z * THUD_PI / root), 1e-8);
            ck_assert_double_eq_tol(p.velocity_mps * w / 2, exp(-z / root * atan2(root, z)), 1e-7);
        }
    thud_record_free(record);
}
END_TEST

START_TEST(sine_without_damping)
{
    enum { N = 4001 };
    static double a[N];
    const double big = 2 * THUD_PI, dt = 0.001; /* forcing of 1 s, four cycles */
    for (int i = 0; i < N; i++)
        a[i] = sin(big * i * dt);
    struct thud_record *record = make(a, N, dt);
    const double periods[] = {0.2, 0.45, 2.0 / 3, 1.7};
    for (int i = 0; i < 4; i++) {
        double w = 2 * THUD_PI / periods[i], peak = 0;
        for (int k = 0; k <= 400000; k++) {
            double t = k * 1e-5;
            peak = fmax(peak, fabs((sin(big * t) - big / w * sin(w * t)) / (w * w - big * big)));
        }
        /* free vibration from the state at the end */
        double x = -big / w * sin(w * 4) / (w * w - big * big), v = (big - big * cos(w * 4)) / (w * w - big * big);
        peak = fmax(peak, hypot(x, v / w));
        ck_assert_double_eq_tol(thud_spectrum_at(record, periods[i], 0).displacement_m, peak, 1e-5 * peak);
    }
    /* resonance: x = (sin wt - wt cos wt) / (2 w^2) */
    double w = big, end = 2 * THUD_PI * 4 / (2 * w * w);
    ck_assert_double_eq_tol(thud_spectrum_at(record, 1, 0).displacement_m, end, 1e-5 * end);
    thud_record_free(record);
}
END_TEST

START_TEST(limits_of_stiff_and_soft)
{
    struct thud_record *record = ragged(400, 0.02);
    record->a_mps2[0] = record->a_mps2[399] = 0; /* no jumps: the stiffest oscillator would overshoot */
    double peak = thud_record_peak(record);
    ck_assert_double_eq(thud_spectrum_at(record, 0, 0.05).acceleration_mps2, peak);
    ck_assert_double_eq(thud_spectrum_at(record, 0, 0.05).displacement_m, 0);
    ck_assert_double_eq_tol(thud_spectrum_at(record, 1e-4, 0.05).acceleration_mps2, peak, 0.01 * peak);
    struct thud_intensity intensity = thud_intensity_of(record); /* of the motion less its mean: take it off here too */
    double mean = 0;
    for (size_t i = 0; i < record->samples; i++)
        mean += record->a_mps2[i] / (double)record->samples;
    for (size_t i = 0; i < record->samples; i++)
        record->a_mps2[i] -= mean;
    struct thud_spectrum_point soft = thud_spectrum_at(record, 5000, 0);
    /* so soft that it stays where it was; after the record the ground coasts, so only what happened before counts */
    ck_assert_double_ge(soft.velocity_mps, intensity.pgv_mps * (1 - 1e-4));
    ck_assert_double_eq_tol(soft.velocity_mps, intensity.pgv_mps, 0.08 * intensity.pgv_mps);
    thud_record_free(record);
}
END_TEST

/* Classic fourth-order Runge-Kutta, two thousand small steps to each of the record's, watching every one. */
static struct thud_spectrum_point brute(const struct thud_record *record, double period, double z)
{
    enum { PARTS = 2000 };
    double w = 2 * THUD_PI / period, h = record->dt_s / PARTS, x = 0, v = 0;
    struct thud_spectrum_point p = {.period_s = period};
    for (size_t i = 0; i + 1 < record->samples; i++)
        for (int k = 0; k < PARTS; k++) {
            double a[3];
            for (int s = 0; s < 3; s++)
                a[s] = record->a_mps2[i] + (record->a_mps2[i + 1] - record->a_mps2[i]) * (k + 0.5 * s) / PARTS;
            double k1 = -a[0] - 2 * z * w * v - w * w * x, v2 = v + h / 2 * k1;
            double k2 = -a[1] - 2 * z * w * v2 - w * w * (x + h / 2 * v), v3 = v + h / 2 * k2;
            double k3 = -a[1] - 2 * z * w * v3 - w * w * (x + h / 2 * v2), v4 = v + h * k3;
            double k4 = -a[2] - 2 * z * w * v4 - w * w * (x + h * v3);
            x += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
            v += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
            p.displacement_m = fmax(p.displacement_m, fabs(x));
            p.velocity_mps = fmax(p.velocity_mps, fabs(v));
            p.acceleration_mps2 = fmax(p.acceleration_mps2, fabs(2 * z * w * v + w * w * x));
        }
    return p;
}

START_TEST(peaks_between_the_samples)
{
    struct thud_record *record = ragged(120, 0.05);
    for (size_t i = 100; i < 120; i++)
        record->a_mps2[i] = 0; /* the largest response shall not come after the end */
    const double periods[] = {0.004, 0.013, 0.024, 0.026, 0.03, 0.11, 0.2, 0.9, 3};
    for (int i = 0; i < 9; i++) {
        struct thud_spectrum_point p = thud_spectrum_at(record, periods[i], 0.05), q = brute(record, periods[i], 0.05);
        const double near = periods[i] < 0.03 ? 1e-4 : 1e-6; /* of few steps to a period, brute force sees less */
        ck_assert_double_eq_tol(p.displacement_m, q.displacement_m, near * q.displacement_m);
        ck_assert_double_eq_tol(p.velocity_mps, q.velocity_mps, near * q.velocity_mps);
        ck_assert_double_eq_tol(p.acceleration_mps2, q.acceleration_mps2, near * q.acceleration_mps2);
    }
    thud_record_free(record);
}
END_TEST

/* However short the period, it takes no more than two periods of each interval; and the stiffer, the nearer to the peak
 * of the ground. */
START_TEST(periods_far_below_the_interval)
{
    struct thud_record *record = ragged(4000, 0.02);
    record->a_mps2[0] = record->a_mps2[3999] = 0;
    const double peak = thud_record_peak(record), periods[] = {1e-4, 1e-6, 1e-9, 1e-12};
    const clock_t before = clock();
    for (int i = 0; i < 4; i++) {
        double a = thud_spectrum_at(record, periods[i], 0.05).acceleration_mps2;
        ck_assert_double_eq_tol(a, peak, fmax(100 * periods[i], 1e-9) * peak);
        ck_assert_double_eq_tol(thud_record_sa(record, periods[i]), peak, fmax(100 * periods[i], 1e-9) * peak);
    }
    ck_assert_double_lt((double)(clock() - before) / CLOCKS_PER_SEC, 20); /* it was hours */
    thud_record_free(record);
}
END_TEST

START_TEST(a_run_with_one_floor)
{
    struct thud_record *record = ragged(300, 0.02);
    const double mass = 1000, period = 0.31, w = 2 * THUD_PI / period, stiffness = mass * w * w;
    struct thud_structure_input structure = {.n = 1, .mass_kg = &mass, .stiffness_npm = &stiffness, .damping = 0.05};
    struct thud_model_input input = {.nstructures = 1, .structure = &structure};
    struct thud_model *model;
    struct thud_error err = {0};
    ck_assert_int_eq(thud_model_create(&input, &model, &err), THUD_OK);
    struct thud_run_options options;
    thud_run_options_init(&options);
    options.tail_s = period;
    struct thud_run *run;
    ck_assert_int_eq(thud_run_create(model, record, &options, &run, &err), THUD_OK);
    bool done = false;
    while (!done)
        ck_assert_int_eq(thud_run_advance(run, 1000, &done, &err), THUD_OK);
    const struct thud_floor_result *floor = &thud_run_result(run)->structure[0].floor[0];
    struct thud_spectrum_point p = thud_spectrum_at(record, period, 0.05);
    ck_assert_double_eq_tol(p.acceleration_mps2, floor->acceleration.value, 1e-6 * p.acceleration_mps2);
    ck_assert_double_eq_tol(p.displacement_m, floor->displacement.value, 1e-6 * p.displacement_m);
    ck_assert_double_eq_tol(p.velocity_mps, floor->velocity.value, 1e-6 * p.velocity_mps);
    thud_run_free(run);
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

START_TEST(series_and_closed_form_agree)
{
    /* omega dt just below and just above the change from one to the other: two halves make a whole */
    const double sizes[] = {0.02, 0.3, 0.499, 0.51, 0.98, 1.5, 6};
    for (int i = 0; i < 7; i++) {
        struct thud_oscillator whole, half;
        thud_oscillator_init(&whole, 10, 0.07, sizes[i] / 10);
        thud_oscillator_init(&half, 10, 0.07, sizes[i] / 20);
        double x = 0.3, v = -2, y = x, w = v;
        thud_oscillator_step(&whole, 1.5, -4, &x, &v);
        thud_oscillator_step(&half, 1.5, -1.25, &y, &w);
        thud_oscillator_step(&half, -1.25, -4, &y, &w);
        ck_assert_double_eq_tol(x, y, 1e-14);
        ck_assert_double_eq_tol(v, w, 1e-13);
    }
}
END_TEST

Suite *thud_suite(void)
{
    Suite *suite = suite_create("spectrum");
    TCase *all = tcase_create("all");
    tcase_add_test(all, step_without_damping);
    tcase_add_test(all, step_with_damping);
    tcase_add_test(all, sine_without_damping);
    tcase_add_test(all, limits_of_stiff_and_soft);
    tcase_add_test(all, peaks_between_the_samples);
    tcase_add_test(all, periods_far_below_the_interval);
    tcase_add_test(all, a_run_with_one_floor);
    tcase_add_test(all, series_and_closed_form_agree);
    suite_add_tcase(suite, all);
    return suite;
}
