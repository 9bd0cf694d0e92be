/* Floor spectra: oscillators on floors against the ground's own spectrum, closed forms, and an integration of
 * histories. */
#include <check.h>
#include <complex.h>
#include <math.h>
#include <string.h>

#include "base/quantity.h"
#include "core/run/run_private.h"
#include "ground/oscillator.h"
#include "ground/spectrum.h"
#include "march.h"

enum { PERIODS = 11 };
static const double damping = 0.05;
static const double period[PERIODS] = {0.013, 0.031, 0.05, 0.08, 0.13, 0.2, 0.33, 0.5, 0.9, 1.7, 3.1};

static struct thud_run *create_for(const struct thud_model *model, const struct thud_record *record,
                                   const struct thud_floor_spectra_choice *choice, bool history)
{
    struct thud_run_options options;
    struct thud_error err = {0};
    struct thud_run *run;
    thud_run_options_init(&options);
    options.keep_history = history;
    options.history_step_s = 5e-4;
    options.floor_spectra = choice;
    ck_assert_msg(thud_run_create(model, record, &options, &run, &err) == THUD_OK, "%s", err.what);
    return run;
}

static struct thud_run *create(const struct thud_model *model, const struct thud_record *record, const int *dof, int n,
                               bool history)
{
    struct thud_floor_spectra_choice choice = {n, PERIODS, dof, period, damping};
    return create_for(model, record, n > 0 ? &choice : NULL, history);
}

static void finish(struct thud_run *run)
{
    struct thud_error err = {0};
    for (bool done = false; !done;)
        ck_assert_msg(thud_run_advance(run, 1000, &done, &err) == THUD_OK, "%s", err.what);
}

static struct thud_run *run_with(const struct thud_model *model, const struct thud_record *record, const int *dof,
                                 int n, bool history)
{
    struct thud_run *run = create(model, record, dof, n, history);
    finish(run);
    return run;
}

/* Largest difference from the spectrum of the ground, over its own largest value. */
static double from_ground(double omega, const struct thud_record *record)
{
    struct march_law law = march_law("kelvin-voigt-no-tension", NULL);
    struct thud_model *model = march_mass_and_wall(1e5, omega, 0.05, 0, 10, &law);
    struct thud_run *run = run_with(model, record, (const int[]){0}, 1, false);
    double worst = 0, largest = 0;
    for (int k = 0; k < PERIODS; k++) {
        double w = 2 * THUD_PI / period[k], sa = w * w * thud_spectrum_at(record, period[k], damping).displacement_m;
        worst = fmax(worst, fabs(thud_run_floor_spectrum(run, 0, k) - sa));
        largest = fmax(largest, sa);
    }
    thud_run_free(run);
    thud_model_free(model);
    return worst / largest;
}

START_TEST(a_stiff_building_gives_the_spectrum_of_the_ground)
{
    struct thud_record *record = march_motion(1);
    double stiff = from_ground(1e3, record), stiffer = from_ground(8e3, record);
    ck_assert_double_lt(stiff, 1e-3);
    ck_assert_double_lt(stiffer, 1e-5);
    ck_assert_double_lt(stiffer, stiff / 30);
    thud_record_free(record);
}
END_TEST

/* A body that an impulse turns round: oscillators on it move freely from the change of its velocity, and one without
 * damping would reach it. */
START_TEST(an_impulse_moves_oscillators_in_closed_form)
{
    const double v = 0.7, e = 0.6, change = (1 + e) * v;
    struct march_law law = march_law("stereomechanical", "restitution", e, NULL);
    struct thud_model *model = march_mass_and_wall(1e5, 0, 0, v, 0.1, &law);
    struct thud_run *run = run_with(model, NULL, (const int[]){0}, 1, false);
    for (int k = 0; k < PERIODS; k++) {
        double root = sqrt(1 - damping * damping);
        double y = change * 2 * THUD_PI / period[k] * exp(-damping / root * atan(root / damping));
        ck_assert_double_eq_tol(thud_run_floor_spectrum(run, 0, k) / y, 1, 1e-10);
    }
    thud_run_free(run);
    thud_model_free(model);
}
END_TEST

/* Largest omega^2 |y| until `end` of an oscillator at rest whose floor moves as u = v/rate sin(rate t): sampled, with a
 * parabola at each extremum. */
static double on_a_sine(double omega, double zeta, double rate, double v, double end)
{
    const double complex lambda = omega * (-zeta + I * sqrt(1 - zeta * zeta)),
                         forced = rate * v / (omega * omega - rate * rate + 2 * I * zeta * omega * rate);
    /* y = Im(forced e^(i rate t)) + Re(free e^(lambda t)), with y = y' = 0 at the start */
    const double re = -cimag(forced), slope = -rate * creal(forced);
    const double complex free = re - I * (slope - creal(lambda) * re) / cimag(lambda);
    const int samples = (int)(end * fmax(omega, rate) * 200 / THUD_PI) + 1;
    double y[3] = {0}, peak = 0;
    for (int i = 0; i <= samples; i++) {
        const double t = end * i / samples;
        y[0] = y[1];
        y[1] = y[2];
        y[2] = cimag(forced * cexp(I * rate * t)) + creal(free * cexp(lambda * t));
        double bend = y[0] - 2 * y[1] + y[2], rise = 0.5 * (y[2] - y[0]);
        if (fabs(rise) <= fabs(bend) && i > 2)
            peak = fmax(peak, fabs(y[1] - 0.5 * rise * rise / bend));
        peak = fmax(peak, fabs(y[2]));
    }
    return omega * omega * peak;
}

static const double ratio[] = {1e-5, 0.003, 0.05, 0.4, 0.99};

/* From stiff ones, in many pieces or at the longest ones, to such as hardly move; one at resonance; of any damping. */
START_TEST(oscillators_on_a_free_floor_move_in_closed_form)
{
    enum { N = 40 };
    const double rate = 2 * THUD_PI / 0.33, v = 0.7;
    double at[N];
    for (int k = 0; k < N; k++)
        at[k] = 0.33 * pow(1.25, k - 18);
    struct thud_floor_spectra_choice choice = {1, N, (const int[]){0}, at, ratio[_i]};
    struct march_law law = march_law("kelvin-voigt", NULL);
    struct thud_model *model = march_mass_and_wall(1e5, rate, 0, v, 10, &law);
    struct thud_run *run = create_for(model, NULL, &choice, false);
    finish(run);
    for (int k = 0; k < N; k++) {
        double sa = on_a_sine(2 * THUD_PI / at[k], ratio[_i], rate, v, thud_run_result(run)->end_s);
        ck_assert_double_eq_tol(thud_run_floor_spectrum(run, 0, k) / sa, 1, 2e-7);
    }
    thud_run_free(run);
    thud_model_free(model);
}
END_TEST

/* Of a floor's history, straight between its rows. */
static double integrated(const struct thud_history *h, int dof, double period_s)
{
    const int column = thud_history_acceleration(h, dof);
    double y = 0, v = 0, peak = 0, made = 0;
    struct thud_oscillator o = {0};
    for (size_t i = 1; i < h->rows; i++) {
        double dt = h->time_s[i] - h->time_s[i - 1];
        if (dt <= 0)
            continue;
        if (fabs(dt - made) > 1e-9 * dt)
            thud_oscillator_init(&o, 2 * THUD_PI / period_s, damping, made = dt);
        thud_oscillator_step(&o, h->value[(i - 1) * (size_t)h->columns + (size_t)column],
                             h->value[i * (size_t)h->columns + (size_t)column], &y, &v);
        peak = fmax(peak, fabs(y));
    }
    return pow(2 * THUD_PI / period_s, 2) * peak;
}

static const char *const laws[] = {"none", "kelvin-voigt-no-tension", "hertz-damp", "jankowski"};
static const int towers[] = {2, 3}, floors[] = {0, 1, 2, 3, 4};

static struct thud_model *pounding(const char *name, double gap)
{
    struct march_law law = march_law(strcmp(name, "none") ? name : "kelvin-voigt", NULL);
    return march_row(2, towers, false, strcmp(name, "none") ? gap : 10, &law);
}

static void compare_with_history(const struct thud_model *model, const struct thud_record *record, bool pounds)
{
    struct thud_run *run = run_with(model, record, floors, 5, true);
    ck_assert(!pounds || thud_run_result(run)->contact[1].impacts > 0);
    for (int f = 1; f < 5; f += 3)
        for (int k = 0; k < PERIODS; k++)
            ck_assert_double_eq_tol(integrated(thud_run_history(run), floors[f], period[k]) /
                                        thud_run_floor_spectrum(run, f, k),
                                    1, k < 2 ? 5e-3 : 1e-3);
    thud_run_free(run);
}

START_TEST(a_history_integrated_in_small_steps_gives_the_same)
{
    struct thud_record *record = march_motion(1);
    struct thud_model *model = pounding(laws[_i], 0.02);
    compare_with_history(model, record, _i > 0);
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

/* Whose straight lines last longer than oscillators may go at once; and one that does not move. */
START_TEST(records_of_few_samples_do)
{
    struct thud_record *coarse, *single;
    ck_assert_int_eq(thud_record_create((const double[]){0, 4, -3, 2, 0}, 5, 0.9, &coarse, NULL), THUD_OK);
    ck_assert_int_eq(thud_record_create((const double[]){0}, 1, 0.9, &single, NULL), THUD_OK);
    struct thud_model *model = pounding("hertz-damp", 0.02);
    compare_with_history(model, coarse, false);
    struct thud_run *run = run_with(model, single, floors, 5, false);
    for (int k = 0; k < PERIODS; k++)
        ck_assert_double_eq(thud_run_floor_spectrum(run, 4, k), 0);
    thud_run_free(run);
    thud_model_free(model);
    thud_record_free(coarse);
    thud_record_free(single);
}
END_TEST

/* What is left out of a floor's acceleration changes nothing by more than 2e-7 of it. */
START_TEST(shortened_polynomials_keep_their_bound)
{
    struct thud_record *record = march_motion(1);
    struct thud_model *model = pounding("hertz-damp", 0.02);
    struct thud_run *run = run_with(model, record, floors, 5, false), *whole = create(model, record, floors, 5, false);
    double worst = 0;
    ck_assert_double_gt(run->floors.left_out, 0);
    whole->floors.left_out = 0;
    finish(whole);
    for (int f = 0; f < 5; f++)
        for (int k = 0; k < PERIODS; k++)
            worst = fmax(worst, fabs(thud_run_floor_spectrum(run, f, k) - thud_run_floor_spectrum(whole, f, k)) /
                                    run->floors.largest[f]);
    ck_assert_double_gt(worst, 0);
    ck_assert_double_lt(worst, 2e-7);
    thud_run_free(run);
    thud_run_free(whole);
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

/* Of linear buildings that do not touch; and a floor's spectrum does not depend on which others are asked for. */
START_TEST(it_grows_with_the_motion)
{
    struct thud_record *record = march_motion(1), *twice = march_motion(-2);
    struct thud_model *model = pounding("none", 0);
    struct thud_run *a = run_with(model, record, floors, 5, false), *b = run_with(model, twice, &floors[3], 1, false);
    for (int k = 0; k < PERIODS; k++)
        ck_assert_double_eq_tol(thud_run_floor_spectrum(b, 0, k) / thud_run_floor_spectrum(a, 3, k), 2, 1e-11);
    thud_run_free(a);
    thud_run_free(b);
    thud_model_free(model);
    thud_record_free(record);
    thud_record_free(twice);
}
END_TEST

START_TEST(the_motion_is_the_same_with_and_without)
{
    struct thud_record *record = march_motion(1);
    struct thud_model *model = pounding("hertz-damp", 0.02);
    struct thud_run *with = run_with(model, record, floors, 5, false),
                    *without = run_with(model, record, NULL, 0, false);
    const size_t bytes = (size_t)model->nmodes * sizeof(double);
    ck_assert(memcmp(with->state.q, without->state.q, bytes) == 0);
    ck_assert(memcmp(with->state.qd, without->state.qd, bytes) == 0);
    ck_assert_int_eq(with->work.events, without->work.events);
    thud_run_free(with);
    thud_run_free(without);
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

/* Whose segments say nothing, or less, of the acceleration between their ends. */
START_TEST(stepping_methods_are_refused)
{
    static const char *const method[] = {"newmark", "dormand-prince", "rk4"};
    struct thud_floor_spectra_choice choice = {1, PERIODS, floors, period, damping};
    struct thud_record *record = march_motion(1);
    struct thud_model *model = pounding("hertz-damp", 0.02);
    struct thud_run_options options;
    struct thud_error err = {0};
    struct thud_run *run;
    thud_run_options_init(&options);
    options.method = thud_method_find(method[_i]);
    options.floor_spectra = &choice;
    ck_assert_int_eq(thud_run_create(model, record, &options, &run, &err), THUD_INPUT);
    ck_assert_str_eq(err.key, "method");
    ck_assert_ptr_nonnull(strstr(err.what, method[_i]));
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

Suite *thud_suite(void)
{
    Suite *s = suite_create("floor spectra");
    TCase *t = tcase_create("floor spectra");
    tcase_add_test(t, a_stiff_building_gives_the_spectrum_of_the_ground);
    tcase_add_test(t, an_impulse_moves_oscillators_in_closed_form);
    tcase_add_loop_test(t, oscillators_on_a_free_floor_move_in_closed_form, 0, sizeof ratio / sizeof *ratio);
    tcase_add_loop_test(t, a_history_integrated_in_small_steps_gives_the_same, 0, sizeof laws / sizeof *laws);
    tcase_add_test(t, records_of_few_samples_do);
    tcase_add_test(t, shortened_polynomials_keep_their_bound);
    tcase_add_test(t, it_grows_with_the_motion);
    tcase_add_test(t, the_motion_is_the_same_with_and_without);
    tcase_add_loop_test(t, stepping_methods_are_refused, 0, 3);
    suite_add_tcase(s, t);
    return s;
}
