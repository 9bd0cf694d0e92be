/* Design spectra by hand at five periods each, and motions selected and scaled by hand. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"
#include "ground/identity.h"
#include "ground/spectrum.h"
#include "ground/target.h"
#include "remarks.h"
#include "study/suite/scaling.h"
#include "suite.h"

static const double g = 9.80665;
static struct thud_target target;
static struct thud_error error;

static void by_hand(const char *text, int n, const double (*expected)[2])
{
    ck_assert_msg(thud_target_parse(text, &target, &error) == THUD_OK, "%s: %s", text, error.what);
    for (int i = 0; i < n; i++)
        ck_assert_double_eq_tol(thud_target_sa(&target, expected[i][0]) / g, expected[i][1], 1e-12);
}

START_TEST(spectra_by_hand)
{
    /* type 1, ground B: S 1.2, TB 0.15, TC 0.5, TD 2; a_g S = 0.36 g */
    by_hand("en1998:0.3g,B", 5, (const double[][2]){{0, 0.36}, {0.075, 0.63}, {0.3, 0.9}, {1, 0.45}, {4, 0.05625}});
    /* type 2, ground D: S 1.8, TB 0.1, TC 0.3, TD 1.2, 8 %: eta = sqrt(10/13) */
    double eta = sqrt(10.0 / 13);
    by_hand("en1998:0.1g, D, type2, 8%", 5,
            (const double[][2]){{0, 0.18},
                                {0.05, 0.18 * (1 + 0.5 * (2.5 * eta - 1))},
                                {0.2, 0.45 * eta},
                                {0.6, 0.225 * eta},
                                {2.4, 0.45 * eta * 0.3 * 1.2 / 5.76}});
    ck_assert(target.damping == 0.08);
    /* eta is no less than 0.55 */
    by_hand("en1998:1g,A,40%", 1, (const double[][2]){{0.2, 2.5 * 0.55}});
    /* TS 0.6, T0 0.12, TL 8 */
    by_hand("asce7:SDS=1.0g,SD1=0.6g,TL=8s", 5,
            (const double[][2]){{0, 0.4}, {0.06, 0.7}, {0.6, 1}, {1.2, 0.5}, {10, 0.6 * 8 / 100}});
    by_hand("asce7:TL=4s,SD1=1.96133m/s2,SDS=4.903325 m/s2", 2, (const double[][2]){{0.3, 0.5}, {1, 0.2}});
    /* alpha_max 0.9, Tg 0.45 s; 5 %: gamma 0.9, eta1 0.02, eta2 1 */
    by_hand("gb50011:AMAX=0.9,TG=0.45s", 5,
            (const double[][2]){{0, 0.405},
                                {0.05, 0.9 * 0.725},
                                {0.3, 0.9},
                                {0.9, 0.9 * pow(0.5, 0.9)},
                                {3.25, 0.9 * (pow(0.2, 0.9) - 0.02)}});
    /* 10 %: gamma 0.9 - 0.05/0.9, eta1 0.02 - 0.05/7.2, eta2 1 - 0.05/0.24 */
    by_hand("gb50011:AMAX=0.16,TG=0.35s,10%", 2,
            (const double[][2]){{0.7, 0.16 * (1 - 0.05 / 0.24) * pow(0.5, 0.9 - 0.05 / 0.9)},
                                {2.75, 0.16 * ((1 - 0.05 / 0.24) * pow(0.2, 0.9 - 0.05 / 0.9) - (0.02 - 0.05 / 7.2))}});
    ck_assert(isnan(thud_target_sa(&target, 6.5)));
    /* the rounded values of table 3.1 of NZS 1170.5, classes B, C, D and E */
    static const double period[4] = {0.5, 1, 2, 4}, at_zero[4] = {1, 1.33, 1.12, 1.12};
    static const double table[4][4] = {
        {1.60, 0.95, 0.53, 0.20}, {2.00, 1.19, 0.66, 0.25}, {3.00, 1.93, 1.07, 0.40}, {3.00, 3.00, 1.66, 0.62}};
    for (int c = 0; c < 4; c++) {
        char text[40];
        snprintf(text, sizeof text, "nzs1170:Z=0.4,%c,R=1.3", 'B' + c);
        ck_assert_int_eq(thud_target_parse(text, &target, &error), THUD_OK);
        for (int i = 0; i < 4; i++)
            ck_assert_double_eq_tol(thud_target_sa(&target, period[i]) / (0.52 * g), table[c][i], 0.006);
        ck_assert_double_eq_tol(thud_target_sa(&target, 0) / (0.52 * g), at_zero[c], 1e-12);
    }
}
END_TEST

/* Straight lines between the points, then Sa_n T_n/T up to TL and TL/T of that. */
START_TEST(multi_period_spectrum)
{
    ck_assert_int_eq(thud_target_parse("asce7-22:mine.csv, TL=12s", &target, &error), THUD_OK);
    ck_assert_str_eq(target.file, "mine.csv");
    target.n = 3;
    for (int i = 0; i < 3; i++) {
        target.period_s[i] = (const double[]){0, 0.2, 10}[i];
        target.sa_mps2[i] = (const double[]){4, 10, 0.5}[i];
    }
    ck_assert_double_eq_tol(thud_target_sa(&target, 0.05), 5.5, 1e-12);
    ck_assert_double_eq_tol(thud_target_sa(&target, 5.1), 5.25, 1e-12);
    ck_assert_double_eq_tol(thud_target_sa(&target, 11), 5 / 11.0, 1e-12);
    ck_assert_double_eq_tol(thud_target_sa(&target, 24), 5 / 24.0 * 0.5, 1e-12);
    target.tl_s = 0;
    ck_assert(isnan(thud_target_sa(&target, 11)));
}
END_TEST

/* The numbers of motions are those of the target's own code. */
START_TEST(numbers_of_the_code)
{
    ck_assert_int_eq(thud_target_code(NULL)->mean, 7);
    ck_assert_int_eq(thud_target_parse("asce7:SDS=1g,SD1=0.6g,TL=8s", &target, &error), THUD_OK);
    ck_assert(thud_target_code(&target)->least == 11 && strstr(thud_target_code(&target)->remark, "MCE_R"));
}
END_TEST

START_TEST(no_spectra)
{
    static const char *const text[] = {"en1998:0.3,B",
                                       "en1998:0.3g",
                                       "en1998:0.3g,F",
                                       "en1998:-0.3g,B",
                                       "en1998:0.3g,B,x",
                                       "en1998:",
                                       "asce7:SDS=1g",
                                       "asce7:SDS=1,SD1=1,TL=8s",
                                       "asce7:SDS=1g,SD1=0.6g,TL=8",
                                       "asce7:SDS=1g,SD1=0.6g,TX=8s",
                                       "asce7:SDS=1g,SD1=0.6g,TL=0.5s",
                                       "asce7-22:TL=8s",
                                       "gb50011:AMAX=0.9",
                                       "gb50011:AMAX=0.9,TG=0.4",
                                       "nzs1170:C",
                                       "nzs1170:Z=0.4",
                                       "nzs1170:Z=0.4,G",
                                       "",
                                       "eurocode"};
    for (size_t i = 0; i < sizeof text / sizeof *text; i++) {
        memset(&error, 0, sizeof error);
        ck_assert_msg(thud_target_parse(text[i], &target, &error) == THUD_INPUT, "%s", text[i]);
        ck_assert_msg(error.what[0] && error.allowed[0] && error.status == THUD_INPUT, "%s", text[i]);
    }
}
END_TEST

/* Noise of a seed, `event` and `station` as said. */
static struct thud_record *motion(unsigned seed, double scale, const char *event, const char *station)
{
    double a[800];
    struct thud_record *record;
    unsigned long long x = seed * 2654435761ULL + 1;
    for (int i = 0; i < 800; i++) {
        x = x * 6364136223846793005ULL + 1442695040888963407ULL;
        a[i] = scale * ((double)(x >> 11) / 9007199254740992.0 - 0.5) * exp(-0.005 * i);
    }
    ck_assert_int_eq(thud_record_create(a, 800, 0.01, &record, NULL), THUD_OK);
    snprintf(record->event, sizeof record->event, "%s", event);
    snprintf(record->station, sizeof record->station, "%s", station);
    snprintf(record->file, sizeof record->file, "m%u", seed);
    record->scale = 1;
    return record;
}

enum { MOTIONS = 3, DENSE = 12 * (THUD_TARGET_PERIODS - 1) + 1 };

/* Factors and means computed here from thud_spectrum_at, without the functions under test. */
START_TEST(three_motions_by_hand)
{
    struct thud_record *record[MOTIONS];
    struct thud_scaling scaling;
    struct thud_scaled_suite suite;
    double factor[MOTIONS], mean[DENSE] = {0}, peak = 0, need = 0;
    bool common = _i == 1;
    for (int i = 0; i < MOTIONS; i++)
        record[i] = motion((unsigned)i + 1, 4.0 + 2 * i, "", "");
    ck_assert_int_eq(thud_target_parse("en1998:0.2g,C", &target, NULL), THUD_OK);
    thud_scaling_init(&scaling);
    scaling.common = common;
    scaling.factor_most = 100;
    scaling.to_s = 1;
    ck_assert_int_eq(
        thud_suite_scale((const struct thud_record *const *)record, MOTIONS, &target, &scaling, &suite, &error),
        THUD_OK);
    for (int i = 0; i < MOTIONS; i++) {
        double sum = 0;
        for (int p = 0; p < THUD_TARGET_PERIODS; p++) {
            double period = 0.1 * pow(10, p / (THUD_TARGET_PERIODS - 1.0)), w = 2 * acos(-1) / period;
            sum += log(thud_target_sa(&target, period) /
                       (w * w * thud_spectrum_at(record[i], period, 0.05).displacement_m));
        }
        factor[i] = common ? 1 : exp(sum / THUD_TARGET_PERIODS);
        peak += factor[i] * thud_record_peak(record[i]) / MOTIONS;
    }
    for (int p = 0; p < DENSE; p++) {
        double period = 0.1 * pow(10, p / (DENSE - 1.0)), w = 2 * acos(-1) / period;
        for (int i = 0; i < MOTIONS; i++)
            mean[p] += factor[i] * w * w * thud_spectrum_at(record[i], period, 0.05).displacement_m / MOTIONS;
        need = fmax(need, 0.9 * thud_target_sa(&target, period) / mean[p]);
    }
    need = fmax(need, 0.2 * g * 1.15 / peak);
    need = common ? need : fmax(1, need);
    ck_assert_double_eq_tol(suite.common, need, 1e-9 * need);
    ck_assert_int_eq(suite.chosen, MOTIONS);
    for (int i = 0; i < MOTIONS; i++)
        ck_assert_double_eq_tol(suite.motion[i].factor, factor[i] * need, 1e-9 * factor[i] * need);
    /* the rule: nowhere below 90 %, between the periods of the factors either, and the peak not below a_g S */
    ck_assert(suite.ratio >= 0.9 - 1e-9 && suite.mean_peak_mps2 >= 0.2 * g * 1.15 * (1 - 1e-9));
    thud_scaled_suite_clear(&suite);
    for (int i = 0; i < MOTIONS; i++)
        thud_record_free(record[i]);
}
END_TEST

START_TEST(what_may_be_chosen)
{
    struct thud_record *record[7] = {motion(1, 5, "E1", "S1"), motion(2, 5, "E1", "S2"), motion(3, 5, "E1", "S3"),
                                     motion(4, 5, "E2", "S1"), motion(5, 5, "E2", "S1"), motion(6, 0.05, "E3", "S1"),
                                     motion(7, 5, "E4", "S1")};
    const struct thud_record *const *all = (const struct thud_record *const *)record;
    struct thud_scaling scaling;
    struct thud_scaled_suite suite;
    int events[5] = {0};
    snprintf(record[6]->component, sizeof record[6]->component, "HNZ");
    ck_assert_int_eq(thud_target_parse("en1998:0.1g,B", &target, NULL), THUD_OK);
    thud_scaling_init(&scaling);
    scaling.to_s = 1;
    ck_assert_int_eq(thud_suite_scale(all, 7, &target, &scaling, &suite, &error), THUD_OK);
    for (int i = 0; i < 7; i++)
        events[record[i]->event[1] - '0'] += suite.motion[i].chosen;
    ck_assert(events[1] == 2 && events[2] == 1 && events[3] == 0 && events[4] == 0);
    ck_assert(strstr(suite.motion[5].why, "factor would be") && strstr(suite.motion[6].why, "vertical"));
    thud_scaled_suite_clear(&suite);
    /* of fewer the best: no motion that is left out and might be taken fits better than one that is taken */
    scaling.count = 2;
    ck_assert_int_eq(thud_suite_scale(all, 7, &target, &scaling, &suite, &error), THUD_OK);
    double worst = 0, best = INFINITY;
    for (int i = 0; i < 7; i++) {
        if (suite.motion[i].chosen)
            worst = fmax(worst, suite.motion[i].misfit);
        else if (strcmp(suite.motion[i].why, "fits less well") == 0)
            best = fmin(best, suite.motion[i].misfit);
    }
    ck_assert(suite.chosen == 2 && worst <= best);
    /* what could not be taken says so, whether or not there was room */
    thud_scaled_suite_clear(&suite);
    for (int turn = 0; turn < 7;
         turn++) { /* each but the first comes after the one that is taken, in one order or other */
        const struct thud_record *two[] = {record[5], record[turn == 5 ? 0 : turn]};
        scaling.count = 1;
        ck_assert_int_eq(thud_suite_scale(two, 2, &target, &scaling, &suite, &error), turn == 6 ? THUD_INPUT : THUD_OK);
        if (turn < 6)
            ck_assert_msg(strstr(suite.motion[0].why, "factor would be"), "beside %d: %s", turn, suite.motion[0].why);
        thud_scaled_suite_clear(&suite);
    }
    for (int i = 0; i < 7; i++)
        thud_record_free(record[i]);
}
END_TEST

/* The n-th remark on two motions. */
static bool remark(const struct thud_record *const *record, int n)
{
    return nth_remark(&(struct thud_remark_scope){.record = record, .nrecords = 2}, THUD_REMARK_MOTIONS, n, &error);
}

START_TEST(remarks)
{
    struct thud_record *a = motion(1, 5, "E1", "S1"), *b = motion(2, 5, "E1", "S1"), *same = motion(1, 2, "", ""),
                       *turned;
    const struct thud_record *one[] = {a, b};
    ck_assert(thud_record_same_motion(a, same) && !thud_record_same_motion(a, b));
    ck_assert(remark(one, 0) && strstr(error.what, "one event"));
    ck_assert(remark(one, 1) && strstr(error.what, "2 files, 1 recording: fewer"));
    ck_assert(remark(one, 2) && strstr(error.what, "two components of one station"));
    ck_assert(!remark(one, 3));
    /* each code's own numbers: of 8 recordings EN 1998-1 takes the mean, ASCE 7 asks for 11, NZS 1170.5 for the largest */
    struct thud_record *many[8];
    for (int i = 0; i < 8; i++) {
        char name[2][16];
        snprintf(name[0], sizeof name[0], "E%d", i);
        snprintf(name[1], sizeof name[1], "S%d", i);
        many[i] = motion(3 + (unsigned)i, 5, name[0], name[1]);
    }
    static const struct {
        const char *target, *what, *allowed;
    } code[] = {{"", NULL, NULL},
                {"en1998:0.3g,B", NULL, NULL},
                {"gb50011:AMAX=0.9,TG=0.45s", NULL, NULL},
                {"asce7:SDS=1.0g,SD1=0.6g,TL=8s", "8 recordings: fewer than", "11 or more (ASCE 7-16 16.2.2)"},
                {"nzs1170:Z=0.4,C", "the code requires the largest", "3 or more (NZS 1170.5 5.5.1)"}};
    for (size_t c = 0; c < sizeof code / sizeof *code; c++) {
        const struct thud_remark_scope scope = {.record = (const struct thud_record *const *)many,
                                                .target = *code[c].target ? &target : NULL,
                                                .nrecords = 8};
        ck_assert(!*code[c].target || thud_target_parse(code[c].target, &target, &error) == THUD_OK);
        ck_assert(nth_remark(&scope, THUD_REMARK_MOTIONS, 0, &error) == (code[c].what != NULL));
        ck_assert(!code[c].what || (strstr(error.what, code[c].what) && strcmp(error.allowed, code[c].allowed) == 0));
        ck_assert(nth_remark(&scope, THUD_REMARK_MOTIONS, 1, &error) ==
                  (scope.target && strstr(code[c].target, "asce")));
        ck_assert(c != 3 || strstr(error.what, "MCE_R"));
    }
    for (int i = 0; i < 8; i++)
        thud_record_free(many[i]);
    b->scale = 2700;
    ck_assert(remark(one, 2) && strstr(error.what, "scaled by 2.7e+03"));
    b->scale = 1;
    snprintf(b->file, sizeof b->file, "kobe-up.AT2");
    ck_assert(remark(one, 2) && strstr(error.what, "vertical component"));
    /* a motion and its reverse are one, of which nothing is said */
    ck_assert_int_eq(thud_record_create(a->a_mps2, a->samples, a->dt_s, &turned, NULL), THUD_OK);
    thud_record_scale(turned, -1);
    snprintf(turned->file, sizeof turned->file, "%.400s:sign=-", a->file);
    const struct thud_record *both[] = {a, turned};
    ck_assert(!remark(both, 0));
    thud_record_free(a);
    thud_record_free(b);
    thud_record_free(same);
    thud_record_free(turned);
}
END_TEST

/* One motion is found again delayed by 3 s, reversed, of another step and with another correction (a slow wave on it);
 * another motion is not, nor one of as much energy and peak. */
START_TEST(one_motion_processed_twice)
{
    struct thud_record *a = motion(1, 5, "", ""), *b = motion(2, 5, "", ""), *later;
    const size_t behind = (size_t)(3 / a->dt_s), n = a->samples + behind;
    double *x = calloc(2 * n, sizeof *x);
    for (size_t i = 0; i < 2 * a->samples - 1; i++) /* every half step */
        x[2 * behind + i] = -0.5 * (a->a_mps2[i / 2] + a->a_mps2[(i + 1) / 2]) +
                            0.1 * thud_record_peak(a) * sin(0.3 * (double)i * a->dt_s);
    ck_assert_int_eq(thud_record_create(x, 2 * n - 1, 0.5 * a->dt_s, &later, &error), THUD_OK);
    ck_assert(thud_record_same_motion(a, later) && thud_record_same_motion(later, a));
    ck_assert(thud_record_same_motion(a, a) && !thud_record_same_motion(a, b) && !thud_record_same_motion(later, b));
    thud_record_scale(a, -3);
    ck_assert(thud_record_same_motion(a, later));
    thud_record_free(later);
    for (size_t i = 0; i < a->samples; i++) /* backwards: the same energy and peak */
        x[i] = a->a_mps2[a->samples - 1 - i];
    ck_assert_int_eq(thud_record_create(x, a->samples, a->dt_s, &later, &error), THUD_OK);
    ck_assert(!thud_record_same_motion(a, later));
    thud_record_free(a);
    thud_record_free(b);
    thud_record_free(later);
    free(x);
}
END_TEST

START_TEST(vertical_words)
{
    static const char *const up[][2] = {{"UP", "a"},  {"U-D", "a"}, {"BMR.BNZ.AK.--", "a"}, {"", "rsn6-elc-up.at2"},
                                        {"", "x.UD"}, {"", "x.UD2"}},
                             *const level[][2] = {{"E-W", "a"},           {"180", "a"},     {"HNE", "a"},
                                                  {"", "tcu052-v7.at2x"}, {"", "jump.AT2"}, {"90 DEG", "csmip.V2"}};
    struct thud_record *r = motion(1, 1, "", "");
    for (int i = 0; i < 6; i++) {
        snprintf(r->component, sizeof r->component, "%s", up[i][0]);
        snprintf(r->file, sizeof r->file, "%s", up[i][1]);
        ck_assert_msg(thud_record_is_vertical(r), "%s %s", up[i][0], up[i][1]);
        snprintf(r->component, sizeof r->component, "%s", level[i][0]);
        snprintf(r->file, sizeof r->file, "%s", level[i][1]);
        ck_assert_msg(!thud_record_is_vertical(r), "%s %s", level[i][0], level[i][1]);
    }
    thud_record_free(r);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("target");
    TCase *tcase = tcase_create("target");
    tcase_add_test(tcase, spectra_by_hand);
    tcase_add_test(tcase, multi_period_spectrum);
    tcase_add_test(tcase, numbers_of_the_code);
    tcase_add_test(tcase, no_spectra);
    tcase_add_loop_test(tcase, three_motions_by_hand, 0, 2);
    tcase_add_test(tcase, what_may_be_chosen);
    tcase_add_test(tcase, remarks);
    tcase_add_test(tcase, one_motion_processed_twice);
    tcase_add_test(tcase, vertical_words);
    suite_add_tcase(suite, tcase);
    return suite;
}
