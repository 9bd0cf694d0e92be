/* Fragility curves: known samples, steps, directions; hazard sums by hand; counts over a made-up suite. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/sweep/fragility_report.h"
#include "base/random.h"
#include "io/result/sweep_csv.h"
#include "plot/figures/figures_case.h"
#include "plot/figures/figures_fragility.h"
#include "plot/figures/figures_sweep.h"
#include "study/suite/fragility.h"
#include "study_setup.h"
#include "sweep_rows.h"

/* Two stripes and two parameters: the curve goes through both shares, in closed form. */
START_TEST(two_stripes_in_closed_form)
{
    struct thud_stripe s[] = {{1, 10, 2}, {4, 20, 15}};
    struct thud_lognormal c = thud_lognormal_fit(s, 2);
    double a = thud_normal_quantile(0.2), b = thud_normal_quantile(0.75), beta = log(4) / (b - a);
    ck_assert(thud_is_fitted(&c) && !c.falling);
    ck_assert_double_eq_tol(c.beta, beta, 1e-9);
    ck_assert_double_eq_tol(c.theta, exp(-a * beta), 1e-9);
    ck_assert_double_eq_tol(thud_lognormal_at(&c, 4), 0.75, 1e-10);
    s[0].count = 8;
    s[1].count = 5;
    c = thud_lognormal_fit(s, 2);
    ck_assert(thud_is_fitted(&c) && c.falling);
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

/* Where the likelihood grows without end there is no curve, and no band of width 0. */
START_TEST(steps_and_nothing)
{
    struct thud_stripe up[] = {{1, 5, 0}, {2, 5, 0}, {3, 5, 5}, {4, 5, 5}}, part[] = {{1, 5, 5}, {2, 5, 3}, {4, 5, 0}};
    struct thud_stripe edge[] = {{1, 6, 0}, {2, 6, 0}, {4, 6, 4}};
    struct thud_lognormal c = thud_lognormal_fit(up, 4);
    ck_assert(c.fit == THUD_FIT_SEPARATED && !c.falling && c.beta == 0);
    ck_assert(isnan(thud_lognormal_at(&c, 2)));
    c = thud_lognormal_fit(part, 3);
    ck_assert(c.fit == THUD_FIT_SEPARATED && c.falling && c.beta == 0);
    c = thud_lognormal_fit(edge, 3);
    ck_assert(c.fit == THUD_FIT_SEPARATED && !c.falling);
    for (int i = 0; i < 4; i++)
        up[i].count = 0;
    ck_assert(thud_lognormal_fit(up, 4).fit == THUD_FIT_NEVER);
    for (int i = 0; i < 4; i++)
        up[i].count = 5;
    c = thud_lognormal_fit(up, 4);
    ck_assert(c.fit == THUD_FIT_ALWAYS && isnan(thud_lognormal_at(&c, 1)));
    ck_assert(thud_lognormal_fit(part, 1).fit == THUD_FIT_ALWAYS);
    ck_assert(thud_lognormal_fit(part + 1, 1).fit == THUD_FIT_NONE);
    /* counts that overlap at one stripe in one motion only: a curve again, and the far tails do not overflow */
    struct thud_stripe far[] = {{1e-6, 40, 0}, {1, 40, 1}, {1.1, 40, 39}, {1e6, 40, 40}};
    c = thud_lognormal_fit(far, 4);
    ck_assert(thud_is_fitted(&c) && c.beta > 0 && c.beta < 0.1);
    ck_assert_double_eq_tol(c.theta, sqrt(1.1), 1e-6);
}
END_TEST

/* Chi-square: two degrees of freedom in closed form; 5 % points of the tables. */
START_TEST(chi_square)
{
    static const double five[] = {3.841458820694124, 5.991464547107979, 7.814727903251179, 9.487729036781154,
                                  11.070497693516351};
    ck_assert_double_eq_tol(thud_chi_square_tail(3, 2), exp(-1.5), 1e-15);
    for (int n = 1; n <= 5; n++)
        ck_assert_double_eq_tol(thud_chi_square_tail(five[n - 1], n), 0.05, 1e-13);
    ck_assert(thud_chi_square_tail(0, 3) == 1);
}
END_TEST

/* Counts up and down again: the deviance, by its definition, rejects what is fitted; those of the curve itself pass. */
START_TEST(a_curve_that_denies_its_points)
{
    struct thud_stripe s[] = {{1, 40, 0}, {2, 40, 28}, {3, 40, 17}, {4, 40, 2}, {5, 40, 3}};
    struct thud_lognormal c = thud_lognormal_fit(s, 5);
    ck_assert(c.fit == THUD_FIT_REJECTED && c.p < 1e-6 && isnan(thud_lognormal_at(&c, 2)));
    struct thud_stripe two[] = {{1, 10, 3}, {2, 10, 4}, {4, 10, 9}};
    c = thud_lognormal_fit(two, 3);
    double deviance = 0;
    for (int i = 0; i < 3; i++) {
        double p = thud_lognormal_at(&c, two[i].x), k = two[i].count;
        deviance += 2 * (k * log(k / (10 * p)) + (10 - k) * log((10 - k) / (10 * (1 - p))));
    }
    ck_assert(thud_is_fitted(&c) && deviance > 0.1);
    ck_assert_double_eq_tol(c.p, erfc(sqrt(deviance / 2)), 1e-9); /* one degree of freedom */
}
END_TEST

static struct thud_fragility rising(double theta, double beta)
{
    return (struct thud_fragility){
        .curve = {THUD_FIT_CURVE, false, theta, beta, NAN}, .least = 0.1, .most = 10, .theta = theta};
}

/* A hazard that falls as a power and a lognormal curve have a rate in closed form (Cornell 1996): k0 theta^-k
 * exp(k^2 beta^2 / 2). It holds with points a factor of 10 apart as well as with many. */
START_TEST(hazard_in_closed_form)
{
    double exact = 2e-3 * pow(0.8, -2.5) * exp(0.5 * 2.5 * 2.5 * 0.35 * 0.35);
    for (int n = 7; n < 1000; n *= 10) {
        double x[1000], rate[1000];
        for (int i = 0; i < n; i++) {
            x[i] = 1e-3 * pow(1e6, i / (n - 1.0));
            rate[i] = 2e-3 * pow(x[i], -2.5);
        }
        struct thud_hazard hazard = {.n = (size_t)n, .x = x, .rate = rate};
        struct thud_fragility f = rising(0.8, 0.35);
        struct thud_rate r = thud_hazard_rate(&hazard, &f);
        ck_assert_double_eq_tol(r.value / exact, 1, 1e-6);
    }
    ck_assert_double_eq_tol(thud_hazard_probability(1 / 475.0, 50), 0.1, 1e-4);
    ck_assert_double_eq_tol(thud_hazard_probability(1e-12, 50), 5e-11, 1e-20);
}
END_TEST

/* A curve with its weight beyond the hazard curve's end, or before its beginning, is known between bounds only; both
 * hold the rate of the whole hazard curve. */
START_TEST(hazard_that_ends_too_soon)
{
    double x[61], rate[61];
    for (int i = 0; i < 61; i++) {
        x[i] = 0.05 * pow(1.1, i);
        rate[i] = 1e-3 * pow(x[i], -2);
    }
    struct thud_hazard whole = {.n = 61, .x = x, .rate = rate}, low = {.n = 25, .x = x, .rate = rate},
                       high = {.n = 21, .x = x + 40, .rate = rate + 40};
    struct thud_fragility f = rising(0.8, 0.3), falling = f, unknown = f;
    double exact = 1e-3 * pow(0.8, -2) * exp(0.5 * 4 * 0.09);
    struct thud_rate r = thud_hazard_rate(&whole, &f);
    ck_assert_double_eq_tol(r.value / exact, 1, 0.01);
    r = thud_hazard_rate(&low, &f); /* ends at 0.5 */
    ck_assert(isnan(r.value) && r.least < 0.5 * exact && r.most > exact && isfinite(r.most));
    r = thud_hazard_rate(&high, &f); /* begins at 2.3 */
    ck_assert(isnan(r.value) && r.least > 0 && r.least < exact && isinf(r.most));
    falling.curve.falling = true;
    ck_assert(isnan(thud_hazard_rate(&whole, &falling).least));
    unknown.theta = NAN; /* outside the values that were tried */
    ck_assert(isnan(thud_hazard_rate(&whole, &unknown).least));
}
END_TEST

/* Each motion's own value: the mean of the rates at which they are exceeded. */
START_TEST(hazard_of_exact_values)
{
    double x[] = {0.1, 0.4, 0.9, 1.6}, rate[] = {0.1, 0.02, 0.005, 0.001}, own[] = {0.4, 0.6, 0.9}, beyond[] = {0.4, 2};
    struct thud_hazard hazard = {.n = 4, .x = x, .rate = rate};
    struct thud_fragility f = {.exact = own, .nexact = 3};
    struct thud_rate r = thud_hazard_rate(&hazard, &f);
    ck_assert_double_eq_tol(r.value, (0.02 + 0.01 + 0.005) / 3, 1e-15);
    f.exact = beyond;
    f.nexact = 2;
    r = thud_hazard_rate(&hazard, &f);
    ck_assert(isnan(r.value));
    ck_assert_double_eq_tol(r.least, 0.01, 1e-15);
    ck_assert_double_eq_tol(r.most, 0.0105, 1e-15);
}
END_TEST

/* Counts that separate begin between two values: the rate is that of one of them, on logarithmic axes. */
START_TEST(hazard_of_a_step)
{
    double x[] = {0.1, 0.4, 0.9, 1.6}, rate[] = {0.1, 0.02, 0.005, 0.001};
    struct thud_stripe s[] = {{0.2, 5, 0}, {0.6, 5, 0}, {0.9, 5, 5}};
    struct thud_hazard hazard = {.n = 4, .x = x, .rate = rate};
    struct thud_fragility f = {.n = 3,
                               .stripe = s,
                               .curve = {THUD_FIT_SEPARATED, false, 0.7, 0, NAN},
                               .least = 0.2,
                               .most = 0.9,
                               .theta = NAN,
                               .above = 0.6,
                               .below = 0.9};
    struct thud_rate r = thud_hazard_rate(&hazard, &f);
    ck_assert_double_eq_tol(r.least, 0.005, 1e-16);
    ck_assert_double_eq_tol(r.most, 0.01, 1e-15); /* 0.6 is the geometric mean of 0.4 and 0.9 */
    f.curve.fit = THUD_FIT_NEVER;
    f.above = 0.9;
    r = thud_hazard_rate(&hazard, &f);
    ck_assert(r.least == 0);
    ck_assert_double_eq_tol(r.most, 0.005, 1e-16);
}
END_TEST

static void set_up(void)
{
    study_set_up(1);
}

/* A suite whose motion r pounds where gap < needed[r]; `turned`: every second one is the one before it reversed. */
static struct thud_suite *made_up(const double *needed, int n, bool turned)
{
    static struct thud_record own[16];
    static const struct thud_record *many[16];
    struct thud_suite *suite;
    for (int r = 0; r < n; r++) {
        many[r] = &own[r];
        snprintf(own[r].file, sizeof own[r].file, "motion %d%s", turned ? r / 2 : r, turned && r % 2 ? ":sign=-" : "");
    }
    vary("gap=5 cm:20 cm:1 cm");
    plan->record = many;
    plan->nrecords = n;
    ck_assert_int_eq(thud_suite_create(plan, &suite, &error), THUD_OK);
    double *value = suite->value;
    for (int r = 0; r < n; r++)
        for (long i = 0; i < suite->settings; i++)
            for (int v = 0; v < plan->ncases * suite->nvalues; v++)
                *value++ = v % suite->nvalues == suite->at[THUD_MEASURE_IMPACTS] ? plan->axis[0].value[i] < needed[r]
                           : v % suite->nvalues == suite->at[THUD_MEASURE_SHORT] ? needed[r] - plan->axis[0].value[i]
                                                                                 : 1;
    return suite;
}

/* Motion r uses the clearance up at the intensity from[r]; of[r]: its recording, NULL: each is one. */
static struct thud_suite *made_up_of(const char *varied, const double *from, const int *of, int n)
{
    static struct thud_record own[16];
    static const struct thud_record *many[16];
    struct thud_suite *suite;
    for (int r = 0; r < n; r++) {
        many[r] = &own[r];
        snprintf(own[r].file, sizeof own[r].file, "motion %d%s", of ? of[r] : r,
                 of && r > 0 && of[r] == of[r - 1] ? ":sign=-" : "");
    }
    vary(varied);
    plan->record = many;
    plan->nrecords = n;
    ck_assert_int_eq(thud_suite_create(plan, &suite, &error), THUD_OK);
    double *value = suite->value;
    for (int r = 0; r < n; r++)
        for (long i = 0; i < suite->settings; i++)
            for (int v = 0; v < plan->ncases * suite->nvalues; v++) {
                const double used = plan->axis[0].value[i] / from[r];
                *value++ = v % suite->nvalues == suite->at[THUD_MEASURE_USED] ? used : used > 1;
            }
    return suite;
}

static struct thud_fragility of(const struct thud_suite *suite, const char *name, int samples)
{
    static struct thud_event event;
    struct thud_fragility f;
    ck_assert_int_eq(thud_event_parse(name, &event, &error), THUD_OK);
    struct thud_fragility_ask ask = {.event = &event, .samples = samples, .seed = 1, .first_contact = true};
    ck_assert_int_eq(thud_fragility_make(suite, &ask, &f, &error), THUD_OK);
    return f;
}

/* What draws of recordings with replacement, all motions of one together, give for the mean of own[r]: 16 and 84 %. */
static void drawn_band(const double *own, const int *of, int n, double *low, double *high)
{
    enum { DRAWS = 20000 };
    static double mean[DRAWS];
    unsigned state = 12345;
    for (int b = 0; b < DRAWS; b++) {
        double sum = 0;
        int count = 0;
        for (int d = 0; d <= of[n - 1]; d++) {
            state = state * 1664525u + 1013904223u;
            const int drawn = (int)((state >> 8) % (unsigned)(of[n - 1] + 1));
            for (int r = 0; r < n; r++) {
                sum += of[r] == drawn ? own[r] : 0;
                count += of[r] == drawn;
            }
        }
        mean[b] = sum / count;
    }
    thud_sort_numbers(mean, DRAWS);
    *low = thud_quantile(mean, DRAWS, 0.16, false);
    *high = thud_quantile(mean, DRAWS, 0.84, false);
}

/* Both signs of seven recordings, and one recording with eight components: drawn together, and none left out. */
START_TEST(band_of_unequal_recordings)
{
    static const int of[2][14] = {{0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6},
                                  {0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 3, 4, 5, 6}};
    double x[2] = {1e-3, 1e3}, rate[2] = {10, 1e-11}, from[14], own[14], low, high;
    struct thud_hazard hazard = {.n = 2, .x = x, .rate = rate};
    static struct thud_event event;
    ck_assert_int_eq(thud_event_parse("pounding", &event, &error), THUD_OK);
    for (int r = 0; r < 14; r++) {
        from[r] = 0.3 + 0.08 * of[_i][r] + 0.01 * (r % 2);
        own[r] = 1e-5 * pow(from[r], -2);
    }
    struct thud_suite *suite = made_up_of("record.factor=0.2:2:0.2", from, of[_i], 14);
    struct thud_fragility_ask ask = {
        .event = &event, .samples = 20000, .seed = 1, .hazard = &hazard, .first_contact = true};
    struct thud_fragility f;
    ck_assert_int_eq(suite->ndraws, 7);
    ck_assert_int_eq(thud_fragility_make(suite, &ask, &f, &error), THUD_OK);
    const struct thud_rate r = thud_hazard_rate(&hazard, &f);
    drawn_band(own, of[_i], 14, &low, &high);
    ck_assert_double_eq_tol(r.low, low, 0.02 * (high - low));
    ck_assert_double_eq_tol(r.high, high, 0.02 * (high - low));
    ck_assert(r.low < r.value && r.value < r.high); /* not at the estimate */
    thud_fragility_clear(&f);
    thud_suite_free(suite);
}
END_TEST

/* Of exact values the annual rate is a mean over the motions: its bootstrap is nearly normal with the standard error of
 * that mean. Fewer than seven motions have no band. */
START_TEST(band_of_an_annual_rate)
{
    static const double from[10] = {0.31, 0.36, 0.42, 0.5, 0.57, 0.61, 0.7, 0.83, 0.9, 1.1};
    double x[2] = {1e-3, 1e3}, rate[2] = {10, 1e-11}, mean = 0, square = 0;
    struct thud_hazard hazard = {.n = 2, .x = x, .rate = rate};
    static struct thud_event event;
    ck_assert_int_eq(thud_event_parse("pounding", &event, &error), THUD_OK);
    const int n = _i ? 6 : 10;
    struct thud_suite *suite = made_up_of("record.factor=0.2:2:0.2", from, NULL, n);
    struct thud_fragility_ask ask = {
        .event = &event, .samples = 20000, .seed = 1, .hazard = &hazard, .first_contact = true};
    struct thud_fragility f;
    ck_assert_int_eq(thud_fragility_make(suite, &ask, &f, &error), THUD_OK);
    const struct thud_rate r = thud_hazard_rate(&hazard, &f);
    if (n < 10) {
        ck_assert(isnan(r.low) && isnan(r.high));
    } else {
        for (int i = 0; i < n; i++) {
            const double own = 1e-5 * pow(from[i], -2);
            mean += own / n;
            square += own * own / n;
        }
        const double deviation = sqrt((square - mean * mean) / n);
        ck_assert_double_eq_tol(r.value, mean, 1e-9 * mean);
        ck_assert_double_eq_tol(r.low, mean - 0.9945 * deviation, 0.1 * deviation);
        ck_assert_double_eq_tol(r.high, mean + 0.9945 * deviation, 0.1 * deviation);
    }
    thud_fragility_clear(&f);
    thud_suite_free(suite);
}
END_TEST

START_TEST(counts_and_band_of_a_suite)
{
    const double needed[] = {0.075, 0.085, 0.105, 0.125, 0.145, 0.165, 0.115};
    struct thud_suite *suite = made_up(needed, 7, false);
    struct thud_fragility f = of(suite, "pounding", 300), again = of(suite, "pounding", 300);
    ck_assert_uint_eq(f.n, 16);
    for (size_t i = 0; i < f.n; i++) {
        int count = 0;
        double low, high;
        for (int r = 0; r < 7; r++)
            count += f.stripe[i].x < needed[r];
        ck_assert_int_eq(f.stripe[i].count, count);
        double p = thud_lognormal_at(&f.curve, f.stripe[i].x);
        ck_assert(f.low[i] <= p + 1e-9 && p <= f.high[i] + 1e-9);
        ck_assert(f.low[i] == again.low[i] && f.high[i] == again.high[i]); /* seeded */
        thud_share_band((size_t)count, 7, 1, &low, &high);
        ck_assert(f.share_low[i] == low && f.share_high[i] == high);
    }
    ck_assert(isnan(f.free_gap)); /* the scene as written has bumpers */
    /* of pounding each motion's own gap is known: no fit */
    ck_assert_int_eq(f.nexact, 7);
    ck_assert_double_eq_tol(f.exact50, 0.115, 1e-12);
    ck_assert_double_eq_tol(f.exact16, 0.085, 1e-12);
    ck_assert_double_eq_tol(f.exact84, 0.145, 1e-12);
    ck_assert(f.exact_low >= 0.075 && f.exact_low < f.exact50 && f.exact50 < f.exact_high && f.exact_high <= 0.165);
    ck_assert(f.curve.falling && f.theta == f.curve.theta && f.theta > 0.085 && f.theta < 0.145);
    ck_assert(f.theta_low < f.theta && f.theta < f.theta_high && f.theta_low > 0.07);
    thud_fragility_clear(&f);
    thud_fragility_clear(&again);
    thud_suite_free(suite);
}
END_TEST

/* Seven motions and the same reversed are seven draws: the band is theirs, not the narrower one of fourteen. */
START_TEST(both_signs_are_one_draw)
{
    double needed[14];
    for (int r = 0; r < 14; r++)
        needed[r] = 0.07 + 0.015 * (r / 2) + 0.001;
    struct thud_suite *pairs = made_up(needed, 14, true);
    struct thud_fragility f = of(pairs, "pounding", 400);
    ck_assert_int_eq(pairs->ndraws, 7);
    double width = f.theta_high - f.theta_low, share = f.share_high[6] - f.share_low[6];
    thud_fragility_clear(&f);
    thud_suite_free(pairs);
    for (int r = 0; r < 7; r++)
        needed[r] = needed[2 * r];
    thud_sweep_plan_clear(plan);
    thud_sweep_plan_init(plan, scene);
    struct thud_suite *seven = made_up(needed, 7, false);
    f = of(seven, "pounding", 400);
    ck_assert_double_eq_tol(width, f.theta_high - f.theta_low, 1e-9); /* the same draws */
    ck_assert_double_eq_tol(share, f.share_high[6] - f.share_low[6], 1e-12);
    thud_fragility_clear(&f);
    thud_suite_free(seven);
}
END_TEST

/* All motions the same: none and then all, so an interval; fewer than seven have no band, fewer than three none at
 * all. */
START_TEST(equal_motions_and_few)
{
    const double needed[] = {0.1005, 0.1005, 0.1005, 0.1005, 0.1005, 0.1005, 0.1005, 0.1005},
                 few[] = {0.075, 0.095, 0.125, 0.085};
    struct thud_suite *suite = made_up(needed, 8, false);
    struct thud_fragility f = of(suite, "pounding", 50);
    ck_assert(f.curve.fit == THUD_FIT_SEPARATED && isnan(f.theta) && isnan(f.theta_low) && isnan(f.low[3]));
    ck_assert_double_eq_tol(f.above, 0.10, 1e-12);
    ck_assert_double_eq_tol(f.below, 0.11, 1e-12);
    thud_fragility_clear(&f);
    thud_suite_free(suite);
    for (int n = 4; n > 0; n -= 2) {
        thud_sweep_plan_clear(plan);
        thud_sweep_plan_init(plan, scene);
        suite = made_up(few, n, false);
        f = of(suite, "pounding", 50);
        ck_assert(isnan(f.theta_low) && isnan(f.low[3]));
        ck_assert(isnan(f.share_low[3]) == (n < 3));
        thud_fragility_clear(&f);
        thud_suite_free(suite);
    }
}
END_TEST

/* A median beyond the values that were tried is told as a bound, and what need not be monotone is counted. */
START_TEST(medians_beyond_and_counts)
{
    const double needed[] = {0.105, 0.165, 0.25, 0.3, 0.31, 0.27, 0.28, 0.29};
    struct thud_suite *suite = made_up(needed, 8, false);
    struct thud_fragility f = of(suite, "pounding", 50);
    ck_assert(thud_is_fitted(&f.curve) && isnan(f.theta) && f.above == f.most && isinf(f.below));
    thud_fragility_clear(&f);
    static const char *const counted[] = {"acceleration:1 g", "permanent:1 cm"};
    for (int e = 0; e < 2; e++) {
        for (long i = 0; i < suite->settings; i++) /* half of the motions at some gaps */
            for (int r = 0; r < 8; r++) {
                double *v = suite->value + ((long)r * suite->settings + i) * suite->nvalues;
                for (int m = 0; m < suite->nvalues; m++)
                    v[m] = i % 5 == 2 && r % 2 ? 20 : 0;
            }
        f = of(suite, counted[e], 50);
        ck_assert(f.curve.fit == THUD_FIT_COUNTED && isnan(f.theta) && isnan(f.above) && isnan(f.low[2]));
        ck_assert(f.share_low[2] > 0 && f.share_high[2] < 1);
        thud_fragility_clear(&f);
    }
    thud_suite_free(suite);
}
END_TEST

START_TEST(events_by_name)
{
    struct thud_event e;
    ck_assert(thud_event_parse("force:5 MN", &e, &error) == THUD_OK && e.measure == THUD_MEASURE_FORCE &&
              e.limit == 5e6);
    ck_assert(thud_event_parse("drift:3 cm", &e, &error) == THUD_OK && e.measure == THUD_MEASURE_DRIFT);
    ck_assert(thud_event_parse("drift:1 %", &e, &error) == THUD_OK && e.measure == THUD_MEASURE_DRIFT_ANGLE);
    ck_assert_double_eq_tol(e.limit, 0.01, 1e-15);
    const char *const wrong[] = {"",           "poundings",   "pounding:1", "force",
                                 "force:5 kg", "force:-5 MN", "drift:",     "worse:2"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        ck_assert_msg(thud_event_parse(wrong[i], &e, &error) == THUD_USAGE, "%s", wrong[i]);
}
END_TEST

/* Of accelerations the largest is not known where one structure's is not; a structure without ductility has none. */
START_TEST(largest_where_one_is_unknown)
{
    const double needed[] = {0.1};
    struct thud_suite *suite = made_up(needed, 1, false);
    const enum thud_measure m[] = {THUD_MEASURE_ACCELERATION, THUD_MEASURE_DUCTILITY};
    for (int i = 0; i < 2; i++) {
        suite->value[suite->at[m[i]]] = NAN;
        suite->value[suite->at[m[i]] + 1] = 7;
    }
    ck_assert(isnan(thud_suite_value(suite, 0, 0, 0, m[0], -1)) && isnan(thud_suite_value(suite, 0, 0, 0, m[0], 0)));
    ck_assert(thud_suite_value(suite, 0, 0, 0, m[1], -1) == 7 && thud_suite_value(suite, 0, 0, 0, m[0], 1) == 7);
    struct thud_fragility f = of(suite, "acceleration:1 g", 0);
    ck_assert_int_eq(f.stripe[0].n, 0); /* the other settings have one */
    ck_assert_int_eq(f.stripe[1].n, 1);
    thud_fragility_clear(&f);
    thud_suite_free(suite);
}
END_TEST

/* Each has a name and words of its own, and a place of its own in every document that tells it. */
START_TEST(measures_are_told_apart)
{
    for (enum thud_measure a = 0; a < THUD_MEASURES; a++) {
        const struct thud_measure_info *x = thud_measure_info(a);
        const int floors = x->place[THUD_TOLD_BY_FLOORS],
                  ahead = 5; /* columns before theirs, and nine before storeys */
        if (floors > 0)
            ck_assert_str_eq(x->column, floors <= 9 ? thud_sweep_floor_schema.column[ahead + floors - 1].name
                                                    : thud_sweep_storey_schema.column[floors - 10].name);
        ck_assert(x->column && x->words && (x->read || a == THUD_MEASURE_GAP || x->place[THUD_TOLD_BY_FLOORS] > 0));
        for (enum thud_measure b = 0; b < a; b++) {
            const struct thud_measure_info *y = thud_measure_info(b);
            ck_assert_str_ne(x->column, y->column);
            ck_assert_str_ne(x->words, y->words);
            for (int d = 0; d < THUD_MEASURE_DOCUMENTS; d++)
                ck_assert_msg(x->place[d] == 0 || x->place[d] != y->place[d], "%s, %s", x->column, y->column);
            if (x->event.word && y->event.word && strcmp(x->event.word, y->event.word) == 0)
                ck_assert(x->kind != y->kind); /* the unit of the limit tells them apart */
        }
    }
    for (int d = 0; d < THUD_MEASURE_DOCUMENTS; d++) {
        enum thud_measure told[THUD_MEASURES];
        int n = thud_measures_told((enum thud_measure_document)d, ~0u, told);
        ck_assert(n > 0 && thud_measure_info(told[n - 1])->place[d] == n);
    }
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
    ck_assert(isnan(thud_suite_value(suite, 0, 0, 1, THUD_MEASURE_FORCE, -1)));
    ck_assert_int_eq(thud_sweep_group_create(plan, 0, &group, &error), THUD_OK);
    while (!done)
        ck_assert_int_eq(thud_sweep_group_advance(group, 1 << 20, &done, &error), THUD_OK);
    ck_assert_int_eq(thud_sweep_task_create(plan, group, 0, &task, &error), THUD_OK);
    for (done = false; !done;)
        ck_assert_int_eq(thud_sweep_task_advance(task, 1 << 20, &done, &error), THUD_OK);
    struct thud_sweep_point *point = thud_sweep_task_take(task);
    ck_assert_int_eq(thud_suite_add(suite, point, &error), THUD_OK);
    struct thud_sweep_row row[64];
    int n = sweep_rows(point, row);
    double most = 0, drift = 0, ratio = NAN;
    for (int i = 0; i < n; i++)
        if (row[i].which == THUD_CASE_BUMPER && row[i].structure == 1) {
            most = row[i].floor > 0 ? fmax(most, row[i].of[THUD_MEASURE_ACCELERATION]) : most;
            drift = row[i].floor > 0 ? fmax(drift, row[i].of[THUD_MEASURE_DRIFT]) : drift;
            ratio = row[i].floor == 0 ? row[i].of[THUD_MEASURE_ACCELERATION_RATIO] : ratio;
        }
    ck_assert(thud_suite_value(suite, 0, 0, 1, THUD_MEASURE_ACCELERATION, 1) == most);
    ck_assert(thud_suite_value(suite, 0, 0, 1, THUD_MEASURE_DRIFT, 1) == drift);
    ck_assert_double_eq_tol(thud_suite_value(suite, 0, 0, 1, THUD_MEASURE_DRIFT_ANGLE, 1), drift / 3, 1e-15);
    ck_assert(thud_suite_value(suite, 0, 0, 1, THUD_MEASURE_ACCELERATION_RATIO, 1) == ratio);
    ck_assert_double_gt(thud_suite_value(suite, 0, 0, 0, THUD_MEASURE_FORCE, -1), 0);
    free(point);
    thud_sweep_task_free(task);
    thud_sweep_group_free(group);
    thud_suite_free(suite);
}
END_TEST

/* Against the gap the line stands where the last of the motions no longer causes contact, whatever is asked; none and
 * all of the motions stand off the frame, and counts of cases beside each other. */
START_TEST(a_figure_against_the_gap_has_its_line)
{
    const double needed[] = {0.075, 0.085, 0.105, 0.125, 0.145, 0.165, 0.115};
    ck_assert_int_eq(thud_sweep_cases(plan, "none,bumper", &error), THUD_OK);
    struct thud_suite *suite = made_up(needed, 7, false);
    struct thud_fragility f = of(suite, "drift:1 %", 0);
    struct thud_fragility_curve curve[2] = {{0, 0, &f}, {0, 1, &f}};
    struct thud_figure *figure = thud_figure_of_fragility(plan, "drift:1 %", curve, 2, "A note.");
    ck_assert_int_eq(thud_figure_check(figure, NULL), THUD_OK);
    const struct thud_panel *panel = &figure->panel[0];
    ck_assert_int_eq(panel->nmarks, 1);
    ck_assert_double_eq_tol(panel->mark[0].from, 16.5, 1e-9);
    ck_assert_ptr_nonnull(
        strstr(figure->note, "A note. Vertical line: no contact without the bumper at this gap or wider"));
    ck_assert_ptr_nonnull(strstr(figure->title, "probability of drift above 1 %"));
    ck_assert(panel->axis[THUD_Y].least < 0 && panel->axis[THUD_Y].most > 100);
    const struct thud_series *points[2] = {NULL, NULL};
    for (int i = 0, n = 0; i < panel->nseries; i++)
        if (panel->series[i]->style.kind == THUD_POINTS && n < 2)
            points[n++] = panel->series[i];
    ck_assert(points[1] && points[0]->x[0] < points[1]->x[0]);
    thud_figure_free(figure);
    thud_fragility_clear(&f);
    thud_suite_free(suite);
}
END_TEST

/* A spectral acceleration is told with its damping and its period: that which is asked for, the mean of the first ones,
 * or in words where it is not the same at every point. */
START_TEST(a_spectral_acceleration_has_its_period)
{
    static const struct {
        double asked_s;
        const char *also, *want;
    } cases[] = {{0.7, NULL, "Sa at 0.7 s, 5 % damped"},
                 {0.7, "structures.1.mass=300 t,400 t", "Sa at 0.7 s, 5 % damped"},
                 {NAN, "gap=5 cm,10 cm", NULL},
                 {NAN, "structures.1.mass=300 t,400 t", "Sa at the mean first period, 5 % damped"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char mean[64];
        struct thud_record_choice choice = scene->record;
        choice.sa_mps2 = 1;
        choice.period_s = NAN;
        ck_assert_int_eq(thud_record_choice_resolve(scene, &choice, &error), THUD_OK);
        snprintf(mean, sizeof mean, "Sa at %.3g s, 5 %% damped", choice.period_s);
        thud_sweep_plan_clear(plan);
        scene->record.period_s = cases[i].asked_s;
        thud_sweep_plan_init(plan, scene);
        vary("record.sa=0.5 g,1 g");
        if (cases[i].also)
            vary(cases[i].also);
        struct thud_figure *figure = thud_figure_create("x", "", 1, 1);
        struct thud_panel *panel = thud_figure_panel(figure, 0, 0, "");
        for (int a = 0; a < plan->naxes; a++)
            if (strcmp(plan->axis[a].key, "record.sa") == 0)
                thud_panel_varied(panel, THUD_X, &plan->axis[a]);
        ck_assert_str_eq(panel->axis[THUD_X].label, cases[i].want ? cases[i].want : mean);
        thud_figure_free(figure);
    }
}
END_TEST

/* Measures have the colour of their case, and a size of marks for each setting; of shares there is Wilson's band. */
START_TEST(what_lowers_is_drawn_by_case)
{
    const double needed[] = {0.075, 0.085, 0.105, 0.125, 0.145, 0.165, 0.115};
    ck_assert_int_eq(thud_sweep_cases(plan, "none,bumper,cavity", &error), THUD_OK);
    struct thud_suite *suite = made_up(needed, 7, false);
    struct thud_figure *figure = thud_suite_lowered_figure(suite);
    ck_assert_int_eq(thud_figure_check(figure, NULL), THUD_OK);
    const struct thud_panel *shares = &figure->panel[1];
    int points = 0, rank = 0;
    for (int i = 0; i < shares->nseries; i++) {
        const struct thud_series *s = shares->series[i];
        if (s->style.kind != THUD_POINTS)
            continue;
        const struct thud_series *band = shares->series[i - 1];
        double low, high;
        thud_share_band((size_t)lround(s->x[0] * 7 / 100), 7, 1, &low, &high);
        ck_assert_double_eq_tol(band->x[0], 100 * low, 1e-9);
        ck_assert_double_eq_tol(band->x[1], 100 * high, 1e-9);
        ck_assert(band->y[0] == s->y[0] && isnan(band->y[2]));
        ck_assert_int_eq(s->style.color,
                         thud_case_color(strncmp(s->name, "cavity", 6) == 0 ? THUD_CASE_CAVITY : THUD_CASE_BUMPER));
        rank = points % 3 == 0 ? 1 : rank + 1;
        ck_assert_int_eq(s->style.rank, rank);
        points++;
    }
    ck_assert_int_eq(points, 6);
    thud_figure_free(figure);
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
    tcase_add_test(tcase, chi_square);
    tcase_add_test(tcase, a_curve_that_denies_its_points);
    tcase_add_test(tcase, hazard_in_closed_form);
    tcase_add_test(tcase, hazard_that_ends_too_soon);
    tcase_add_test(tcase, hazard_of_a_step);
    tcase_add_test(tcase, hazard_of_exact_values);
    tcase_add_loop_test(tcase, band_of_unequal_recordings, 0, 2);
    tcase_add_loop_test(tcase, band_of_an_annual_rate, 0, 2);
    tcase_add_test(tcase, counts_and_band_of_a_suite);
    tcase_add_test(tcase, a_figure_against_the_gap_has_its_line);
    tcase_add_test(tcase, a_spectral_acceleration_has_its_period);
    tcase_add_test(tcase, what_lowers_is_drawn_by_case);
    tcase_add_test(tcase, both_signs_are_one_draw);
    tcase_add_test(tcase, equal_motions_and_few);
    tcase_add_test(tcase, medians_beyond_and_counts);
    tcase_add_test(tcase, events_by_name);
    tcase_add_test(tcase, largest_where_one_is_unknown);
    tcase_add_test(tcase, measures_are_told_apart);
    tcase_add_test(tcase, a_suite_holds_what_the_rows_say);
    suite_add_tcase(suite, tcase);
    return suite;
}
