/* Surrogates: the pulse is the one of the formula, the noise has the spectrum of its two filters, the peak is met, the
 * same seed gives the same motion. */
#include <check.h>
#include <math.h>
#include <string.h>

#include "base/quantity.h"
#include "ground/intensity.h"
#include "ground/synthesize.h"

static struct thud_record *make(const struct thud_synthesis *synthesis)
{
    struct thud_record *record;
    struct thud_error err = {0};
    enum thud_status status = thud_synthesis_run(synthesis, &record, &err);
    ck_assert_msg(status == THUD_OK, "%s: %s", err.key, err.what);
    return record;
}

static void refuses(const struct thud_synthesis *synthesis, const char *key)
{
    struct thud_record *record;
    struct thud_error err = {0};
    ck_assert_int_eq(thud_synthesis_run(synthesis, &record, &err), THUD_INPUT);
    ck_assert_ptr_null(record);
    ck_assert_str_eq(err.key, key);
}

/* The noise is a burst at the very beginning, long gone when the pulse comes: the velocity from then on must be the
 * formula's. */
START_TEST(pulse_of_the_formula)
{
    const double phases[] = {0, 90, 180, 37};
    for (int k = 0; k < 4; k++) {
        struct thud_synthesis s;
        thud_synthesis_init(&s);
        s.pulse_amplitude_mps = 0.8;
        s.pulse_period_s = 1.3;
        s.pulse_cycles = 1.7;
        s.pulse_phase_deg = phases[k];
        s.pulse_time_s = 23;
        s.rise_s = s.hold_s = 0.01;
        s.decay_ps = 100;
        s.dt_s = 0.002;
        struct thud_record *record = make(&s);
        static double v[20001];
        ck_assert_uint_eq(record->samples, 20001);
        thud_record_integrate(record, v, NULL);
        size_t quiet = 10000;
        for (size_t i = quiet; i < record->samples; i += 7) {
            double theta = 2 * THUD_PI / 1.3 * ((double)i * 0.002 - s.pulse_time_s), expected = 0;
            if (fabs(theta) <= 1.7 * THUD_PI)
                expected = 0.4 * (1 + cos(theta / 1.7)) * cos(theta + phases[k] * THUD_PI / 180);
            ck_assert_double_eq_tol(v[i] - v[quiet], expected, 2e-5 * 0.8);
        }
        thud_record_free(record);
    }
}
END_TEST

/* Power at a frequency, in unscaled units. */
static double power(const struct thud_record *record, double f)
{
    double re = 0, im = 0;
    for (size_t i = 0; i < record->samples; i++) {
        re += record->a_mps2[i] * cos(2 * THUD_PI * f * (double)i * record->dt_s);
        im += record->a_mps2[i] * sin(2 * THUD_PI * f * (double)i * record->dt_s);
    }
    return re * re + im * im;
}

static double kanai_tajimi_clough_penzien(double f, const struct thud_synthesis *s)
{
    double r = f / s->ground_frequency_hz, q = f / s->cut_frequency_hz, z = 2 * s->ground_damping * r,
           y = 2 * s->cut_damping * q;
    double ground = (1 + z * z) / ((1 - r * r) * (1 - r * r) + z * z);
    return ground * q * q * q * q / ((1 - q * q) * (1 - q * q) + y * y);
}

START_TEST(noise_of_the_filters)
{
    enum {
        SEEDS = 150,
        LINES = 9
    }; /* neighbouring lines are averaged: their scatter falls with the root of their number */
    struct thud_synthesis s;
    thud_synthesis_init(&s);
    const double at[] = {0.15, 0.5, 2, 6, 15};
    double sum[5] = {0}, expected[5] = {0};
    for (int seed = 0; seed < SEEDS; seed++) {
        s.seed = seed;
        struct thud_record *record = make(&s);
        double energy = 0; /* undo the scaling to the peak */
        for (size_t i = 0; i < record->samples; i++)
            energy += record->a_mps2[i] * record->a_mps2[i];
        for (int k = 0; k < 5; k++)
            for (int line = 0; line < LINES; line++)
                sum[k] += power(record, at[k] * (0.8 + 0.05 * line)) / energy;
        thud_record_free(record);
    }
    for (int k = 0; k < 5; k++)
        for (int line = 0; line < LINES; line++)
            expected[k] += kanai_tajimi_clough_penzien(at[k] * (0.8 + 0.05 * line), &s);
    for (int k = 0; k < 5; k++)
        ck_assert_double_eq_tol(sum[k] / sum[2] / (expected[k] / expected[2]), 1, 0.2);
}
END_TEST

START_TEST(peak_is_met_and_nothing_is_left)
{
    struct thud_synthesis s;
    thud_synthesis_init(&s);
    s.pulse_amplitude_mps = 0.5;
    for (int seed = 0; seed < 20; seed++) {
        s.seed = seed;
        struct thud_record *record = make(&s);
        ck_assert_double_eq_tol(thud_record_peak(record), 0.5 * THUD_GRAVITY, 1e-8);
        double sum = 0;
        for (size_t i = 0; i < record->samples; i++)
            sum += record->a_mps2[i] * record->dt_s;
        ck_assert_double_eq_tol(sum, 0, 2e-3); /* hardly any velocity */
        thud_record_free(record);
    }
}
END_TEST

START_TEST(seeds)
{
    struct thud_synthesis s;
    thud_synthesis_init(&s);
    struct thud_record *a = make(&s), *b = make(&s);
    ck_assert_int_eq(memcmp(a->a_mps2, b->a_mps2, a->samples * sizeof(double)), 0);
    s.seed = 2;
    struct thud_record *c = make(&s);
    ck_assert_int_ne(memcmp(a->a_mps2, c->a_mps2, a->samples * sizeof(double)), 0);
    thud_record_free(a);
    thud_record_free(b);
    thud_record_free(c);
}
END_TEST

START_TEST(refusals_name_the_parameter)
{
    for (size_t i = 0; i < thud_synthesis_param_count; i++) {
        struct thud_synthesis s;
        thud_synthesis_init(&s);
        *thud_synthesis_field(&s, &thud_synthesis_params[i]) = -1e6;
        refuses(&s, thud_synthesis_params[i].name);
        *thud_synthesis_field(&s, &thud_synthesis_params[i]) = NAN;
        refuses(&s, thud_synthesis_params[i].name);
    }
    struct thud_synthesis s;
    thud_synthesis_init(&s);
    s.pulse_amplitude_mps = 5;
    refuses(&s, "peak");
    s.pulse_amplitude_mps = 0.1;
    s.pulse_time_s = 0.5;
    refuses(&s, "pulse-time");
    thud_synthesis_init(&s);
    s.seed = 1.5;
    refuses(&s, "seed");
    thud_synthesis_init(&s);
    s.hold_s = 1;
    refuses(&s, "hold");
}
END_TEST

Suite *thud_suite(void)
{
    Suite *suite = suite_create("synthesize");
    TCase *all = tcase_create("all");
    tcase_add_test(all, pulse_of_the_formula);
    tcase_add_test(all, noise_of_the_filters);
    tcase_add_test(all, peak_is_met_and_nothing_is_left);
    tcase_add_test(all, seeds);
    tcase_add_test(all, refusals_name_the_parameter);
    suite_add_tcase(suite, all);
    return suite;
}
