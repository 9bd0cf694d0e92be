/* Fragility curves: known samples, steps, directions; hazard sums by hand; counts over a made-up suite. */
#include <check.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "study/suite/fragility.h"
#include "base/random.h"
#include "study_setup.h"

/* Two stripes and two parameters: the curve goes through both shares, in closed form. */
START_TEST(two_stripes_in_closed_form)
{
    struct thud_stripe s[] = {{1, 10, 2}, {4, 20, 15}};
    struct thud_lognormal c = thud_lognormal_fit(s, 2);
    double a = thud_normal_quantile(0.2), b = thud_normal_quantile(0.75), beta = log(4) / (b - a);
    ck_assert(c.fitted && !c.falling);
    ck_assert_double_eq_tol(c.beta, beta, 1e-9);
    ck_assert_double_eq_tol(c.theta, exp(-a * beta), 1e-9);
    ck_assert_double_eq_tol(thud_lognormal_at(&c, 4), 0.75, 1e-10);
    s[0].count = 8;
    s[1].count = 5;
    c = thud_lognormal_fit(s, 2);
    ck_assert(c.fitted && c.falling);
    ck_assert_double_eq_tol(thud_lognormal_at(&c, 1), 0.8, 1e-10);
    ck_assert_double_eq_tol(thud_lognormal_at(&c, 4), 0.25, 1e-10);
}
END_TEST

/* Of the counts, by its definition. */
static double likelihood(const struct thud_lognormal *curve, const struct thud_stripe *stripe, size_t n)
{
    double sum = 0;
    for (size_t i = 0; i < n; i++) {
        double p = thud_lognormal_at(curve, stripe[i].x);
        sum += stripe[i].count * log(p) + (stripe[i].n - stripe[i].count) * log1p(-p);
    }
    return sum;
}

/* A sample drawn from a known curve: the parameters come back within their standard error, and no neighbour has a
 * larger likelihood. */
START_TEST(a_known_sample)
{
    enum { STRIPES = 15, MOTIONS = 4000 };
    struct thud_stripe s[STRIPES];
    struct thud_random random = {20260101};
    for (int i = 0; i < STRIPES; i++) {
        s[i] = (struct thud_stripe){0.1 * (i + 1), MOTIONS, 0};
        for (int r = 0; r < MOTIONS; r++)
            s[i].count += thud_random_unit(&random) < thud_normal_cdf(log(s[i].x / 0.7) / 0.4);
    }
    struct thud_lognormal c = thud_lognormal_fit(s, STRIPES);
    ck_assert_double_eq_tol(c.theta, 0.7, 0.7 * 0.02);
    ck_assert_double_eq_tol(c.beta, 0.4, 0.4 * 0.04);
    double best = likelihood(&c, s, STRIPES);
    for (int i = 0; i < 8; i++) {
        struct thud_lognormal other = c;
        other.theta *= 1 + 1e-3 * cos(i * 0.785398);
        other.beta *= 1 + 1e-3 * sin(i * 0.785398);
        ck_assert_double_lt(likelihood(&other, s, STRIPES), best);
    }
}
END_TEST

/* Expected counts of a curve (not whole ones, scaled up) give that curve back: no bias of the method. */
START_TEST(exact_shares_give_the_curve_back)
{
    struct thud_stripe s[9];
    for (int i = 0; i < 9; i++) {
        s[i] = (struct thud_stripe){pow(1.3, i), 1000000000, 0};
        s[i].count = (int)lround(1e9 * thud_normal_cdf(-log(s[i].x / 3) / 0.55));
    }
    struct thud_lognormal c = thud_lognormal_fit(s, 9);
    ck_assert(c.falling);
    ck_assert_double_eq_tol(c.theta, 3, 1e-7);
    ck_assert_double_eq_tol(c.beta, 0.55, 1e-7);
}
END_TEST

START_TEST(steps_and_nothing)
{
    struct thud_stripe up[] = {{1, 5, 0}, {2, 5, 0}, {3, 5, 5}, {4, 5, 5}}, part[] = {{1, 5, 5}, {2, 5, 3}, {4, 5, 0}};
    struct thud_lognormal c = thud_lognormal_fit(up, 4);
    ck_assert(c.fitted && !c.falling && c.beta == 0);
    ck_assert_double_eq_tol(c.theta, sqrt(6), 1e-14);
    ck_assert(thud_lognormal_at(&c, 2) == 0 && thud_lognormal_at(&c, 3) == 1);
    c = thud_lognormal_fit(part, 3);
    ck_assert(c.fitted && c.falling && c.beta == 0 && c.theta == 2);
    for (int i = 0; i < 4; i++)
        up[i].count = 0;
    ck_assert(!thud_lognormal_fit(up, 4).fitted);
    for (int i = 0; i < 4; i++)
        up[i].count = 5;
    c = thud_lognormal_fit(up, 4);
    ck_assert(!c.fitted && isnan(thud_lognormal_at(&c, 1)));
    ck_assert(!thud_lognormal_fit(part, 1).fitted);
    /* counts that overlap at one stripe in one motion only: a curve again, and the far tails do not overflow */
    struct thud_stripe far[] = {{1e-6, 40, 0}, {1, 40, 1}, {1.1, 40, 39}, {1e6, 40, 40}};
    c = thud_lognormal_fit(far, 4);
    ck_assert(c.fitted && c.beta > 0 && c.beta < 0.1);
    ck_assert_double_eq_tol(c.theta, sqrt(1.1), 1e-6);
}
END_TEST

/* P is a step at 0.5: everything above counts. By hand 0.02 of the intervals above, and the tail. */
START_TEST(hazard_by_hand)
{
    double x[] = {0.1, 0.4, 0.9, 1.6}, rate[] = {0.1, 0.02, 0.005, 0.001};
    struct thud_hazard hazard = {4, x, rate};
    struct thud_lognormal step = {true, false, 0.5, 0}, smooth = {true, false, 0.6, 0.4};
    ck_assert_double_eq_tol(thud_hazard_rate(&hazard, &step), (0.02 - 0.005) + (0.005 - 0.001) + 0.001, 1e-16);
    double by_hand = thud_normal_cdf(log(0.2 / 0.6) / 0.4) * 0.08 + thud_normal_cdf(log(0.6 / 0.6) / 0.4) * 0.015 +
                     thud_normal_cdf(log(1.2 / 0.6) / 0.4) * 0.004 + thud_normal_cdf(log(1.6 / 0.6) / 0.4) * 0.001;
    ck_assert_double_eq_tol(thud_hazard_rate(&hazard, &smooth), by_hand, 1e-16);
    ck_assert_double_eq_tol(thud_hazard_probability(1 / 475.0, 50), 0.1, 1e-4);
    ck_assert_double_eq_tol(thud_hazard_probability(1e-12, 50), 5e-11, 1e-20);
    step.falling = true;
    ck_assert(isnan(thud_hazard_rate(&hazard, &step)));
}
END_TEST

/* A hazard that falls as a power and a lognormal curve have a rate in closed form (Cornell 1996): k0 theta^-k
 * exp(k^2 beta^2 / 2). */
START_TEST(hazard_in_closed_form)
{
    enum { N = 20000 };
    double *x = malloc(2 * N * sizeof *x), *rate = x + N;
    for (int i = 0; i < N; i++) {
        x[i] = 1e-3 * pow(1e6, i / (N - 1.0));
        rate[i] = 2e-3 * pow(x[i], -2.5);
    }
    struct thud_hazard hazard = {N, x, rate};
    struct thud_lognormal c = {true, false, 0.8, 0.35};
    double exact = 2e-3 * pow(0.8, -2.5) * exp(0.5 * 2.5 * 2.5 * 0.35 * 0.35);
    ck_assert_double_eq_tol(thud_hazard_rate(&hazard, &c) / exact, 1, 1e-6);
    free(x);
}
END_TEST

static void set_up(void)
{
    study_set_up(1);
}

/* A suite whose motion r pounds where gap < needed[r]. */
static struct thud_suite *made_up(const double *needed, int n)
{
    static const struct thud_record *many[8];
    struct thud_suite *suite;
    for (int r = 0; r < n; r++)
        many[r] = motion;
    vary("gap=5 cm:20 cm:1 cm");
    plan->record = many;
    plan->nrecords = n;
    ck_assert_int_eq(thud_suite_create(plan, &suite, &error), THUD_OK);
    for (int r = 0; r < n; r++)
        for (long i = 0; i < suite->settings; i++)
            for (int v = 0; v < suite->nvalues; v++)
                suite->value[((size_t)r * (size_t)suite->settings + (size_t)i) * (size_t)suite->nvalues + (size_t)v] =
                    v == THUD_SUITE_IMPACTS ? plan->axis[0].value[i] < needed[r] : 1;
    return suite;
}

START_TEST(counts_and_band_of_a_suite)
{
    const double needed[] = {0.075, 0.085, 0.105, 0.125, 0.145, 0.165};
    struct thud_suite *suite = made_up(needed, 6);
    struct thud_event event;
    struct thud_fragility f, again;
    ck_assert_int_eq(thud_event_parse("pounding", &event, &error), THUD_OK);
    struct thud_fragility_ask ask = {.event = &event, .samples = 300, .seed = 1};
    ck_assert_int_eq(thud_fragility_make(suite, &ask, &f, &error), THUD_OK);
    ck_assert_int_eq(thud_fragility_make(suite, &ask, &again, &error), THUD_OK);
    ck_assert_uint_eq(f.n, 16);
    for (size_t i = 0; i < f.n; i++) {
        int count = 0;
        for (int r = 0; r < 6; r++)
            count += f.stripe[i].x < needed[r];
        ck_assert_int_eq(f.stripe[i].count, count);
        double p = thud_lognormal_at(&f.curve, f.stripe[i].x);
        ck_assert(f.low[i] <= p + 1e-9 && p <= f.high[i] + 1e-9);
        ck_assert(f.low[i] == again.low[i] && f.high[i] == again.high[i]); /* seeded */
    }
    ck_assert(f.curve.falling && f.curve.theta > 0.085 && f.curve.theta < 0.145);
    ck_assert(f.theta_low < f.curve.theta && f.curve.theta < f.theta_high && f.theta_low > 0.07);
    thud_fragility_clear(&f);
    thud_fragility_clear(&again);
    thud_suite_free(suite);
}
END_TEST

START_TEST(equal_motions_have_no_band)
{
    const double needed[] = {0.1, 0.1, 0.1, 0.1};
    struct thud_suite *suite = made_up(needed, 4);
    struct thud_event event;
    struct thud_fragility f;
    ck_assert_int_eq(thud_event_parse("pounding", &event, &error), THUD_OK);
    struct thud_fragility_ask ask = {.event = &event, .samples = 50, .seed = 1};
    ck_assert_int_eq(thud_fragility_make(suite, &ask, &f, &error), THUD_OK);
    ck_assert(f.curve.fitted && f.curve.beta == 0 && f.theta_low == f.theta_high && f.theta_low == f.curve.theta);
    for (size_t i = 0; i < f.n; i++)
        ck_assert(f.low[i] == f.high[i] && f.low[i] == thud_lognormal_at(&f.curve, f.stripe[i].x));
    thud_fragility_clear(&f);
    thud_suite_free(suite);
}
END_TEST

START_TEST(events_by_name)
{
    struct thud_event e;
    ck_assert(thud_event_parse("force:5 MN", &e, &error) == THUD_OK && e.kind == THUD_EVENT_FORCE && e.limit == 5e6);
    ck_assert(thud_event_parse("drift:3 cm", &e, &error) == THUD_OK && e.kind == THUD_EVENT_DRIFT);
    ck_assert(thud_event_parse("drift:1 %", &e, &error) == THUD_OK && e.kind == THUD_EVENT_DRIFT_ANGLE);
    ck_assert_double_eq_tol(e.limit, 0.01, 1e-15);
    const char *const wrong[] = {"",           "poundings",   "pounding:1", "force",
                                 "force:5 kg", "force:-5 MN", "drift:",     "worse:2"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        ck_assert_msg(thud_event_parse(wrong[i], &e, &error) == THUD_USAGE, "%s", wrong[i]);
}
END_TEST

/* The suite's numbers of a real point against its rows. */
START_TEST(a_suite_holds_what_the_rows_say)
{
    struct thud_suite *suite;
    struct thud_sweep_group *group;
    struct thud_sweep_task *task;
    bool done = false;
    plan->scene.interface[0].gap_m = 0.06;
    ck_assert_int_eq(thud_sweep_cases(plan, "none,bumper", &error), THUD_OK);
    ck_assert_int_eq(thud_suite_create(plan, &suite, &error), THUD_OK);
    ck_assert(isnan(thud_suite_value(suite, 0, 0, 1, THUD_SUITE_FORCE, -1)));
    ck_assert_int_eq(thud_sweep_group_create(plan, 0, &group, &error), THUD_OK);
    while (!done)
        ck_assert_int_eq(thud_sweep_group_advance(group, 1 << 20, &done, &error), THUD_OK);
    ck_assert_int_eq(thud_sweep_task_create(plan, group, 0, &task, &error), THUD_OK);
    for (done = false; !done;)
        ck_assert_int_eq(thud_sweep_task_advance(task, 1 << 20, &done, &error), THUD_OK);
    struct thud_sweep_point *point = thud_sweep_task_take(task);
    ck_assert_int_eq(thud_suite_add(suite, point, &error), THUD_OK);
    struct thud_sweep_row row[64];
    int n = thud_sweep_rows(plan, point, row);
    double most = 0, drift = 0, ratio = NAN;
    for (int i = 0; i < n; i++)
        if (row[i].which == THUD_CASE_BUMPER && row[i].structure == 1) {
            most = row[i].floor > 0 ? fmax(most, row[i].acceleration_mps2) : most;
            drift = row[i].floor > 0 ? fmax(drift, row[i].drift_m) : drift;
            ratio = row[i].floor == 0 ? row[i].acceleration_ratio : ratio;
        }
    ck_assert(thud_suite_value(suite, 0, 0, 1, THUD_SUITE_ACCELERATION, 1) == most);
    ck_assert(thud_suite_value(suite, 0, 0, 1, THUD_SUITE_DRIFT, 1) == drift);
    ck_assert_double_eq_tol(thud_suite_value(suite, 0, 0, 1, THUD_SUITE_DRIFT_ANGLE, 1), drift / 3, 1e-15);
    ck_assert(thud_suite_value(suite, 0, 0, 1, THUD_SUITE_ACCELERATION_RATIO, 1) == ratio);
    ck_assert_double_gt(thud_suite_value(suite, 0, 0, 0, THUD_SUITE_FORCE, -1), 0);
    free(point);
    thud_sweep_task_free(task);
    thud_sweep_group_free(group);
    thud_suite_free(suite);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("fragility");
    TCase *tcase = tcase_create("fragility");
    tcase_add_checked_fixture(tcase, set_up, study_tear_down);
    tcase_add_test(tcase, two_stripes_in_closed_form);
    tcase_add_test(tcase, a_known_sample);
    tcase_add_test(tcase, exact_shares_give_the_curve_back);
    tcase_add_test(tcase, steps_and_nothing);
    tcase_add_test(tcase, hazard_by_hand);
    tcase_add_test(tcase, hazard_in_closed_form);
    tcase_add_test(tcase, counts_and_band_of_a_suite);
    tcase_add_test(tcase, equal_motions_have_no_band);
    tcase_add_test(tcase, events_by_name);
    tcase_add_test(tcase, a_suite_holds_what_the_rows_say);
    suite_add_tcase(suite, tcase);
    return suite;
}
