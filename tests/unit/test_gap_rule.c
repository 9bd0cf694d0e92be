/* The codes' rules by hand, the displacements of a suite that they are asked of, and what happens at their gaps. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ground/identity.h"
#include "study/scene/solution.h"
#include "study/suite/gap_suite.h"
#include "study/sweep/sweep_table.h"
#include "study_setup.h"

static void set_up(void)
{
    study_set_up(1);
}

static struct thud_gap_level level_of(double left_m, double right_m, double height_m, bool aligned)
{
    struct thud_gap_level level = {.interface = 1,
                                   .left_floor = 4,
                                   .right_floor = 4,
                                   .aligned = aligned,
                                   .left_m = left_m,
                                   .right_m = right_m,
                                   .relative_displacement_m = left_m,
                                   .height_m = height_m,
                                   .lower_m = height_m};
    thud_gap_code_init(&level.code);
    return level;
}

static void is_mm(const struct thud_gap_level *level, int rule, double mm)
{
    ck_assert_double_eq_tol(1e3 * thud_gap_value(level, rule), mm, 1e-9);
}

/* TBDY 2018, 4.9.3: displacements of 18 and 24 mm, R/I = 8: 0.25 x 8 x 30 = 60 mm where all floors are at the same
 * elevations, 0.5 x 8 x 30 = 120 mm where not; at least 30 mm, 10 mm more per 3 m above 6 m: 50 mm at 12 m. */
START_TEST(turkey_by_hand)
{
    struct thud_gap_level level = level_of(0.018, 0.024, 12, true);
    is_mm(&level, THUD_GAP_TBDY, 50);
    level.code.r = 8;
    is_mm(&level, THUD_GAP_TBDY, 60);
    level.aligned = false;
    is_mm(&level, THUD_GAP_TBDY, 120);
    level = level_of(0.001, 0.001, 4, false);
    is_mm(&level, THUD_GAP_TBDY, 30);
    level.height_m = NAN;
    ck_assert(isnan(thud_gap_value(&level, THUD_GAP_TBDY)));
}
END_TEST

/* GB 50011, 6.1.4: 100 mm up to 15 m; 20 mm more per 5, 4, 3 and 2 m at 6 to 9 degrees: 27 m at 8: 180 mm. */
START_TEST(china_by_hand)
{
    struct thud_gap_level level = level_of(0.3, 0.3, 27, true);
    ck_assert(isnan(thud_gap_value(&level, THUD_GAP_GB50011))); /* intensity not given */
    const double more[] = {20.0 * 12 / 5, 20.0 * 12 / 4, 20.0 * 12 / 3, 20.0 * 12 / 2};
    for (int degrees = 6; degrees <= 9; degrees++) {
        level.code.intensity = degrees;
        is_mm(&level, THUD_GAP_GB50011, 100 + more[degrees - 6]);
    }
    level.code.intensity = 8;
    is_mm(&level, THUD_GAP_GB50011, 180);
    level.lower_m = 15;
    is_mm(&level, THUD_GAP_GB50011, 100);
    level.lower_m = 3;
    is_mm(&level, THUD_GAP_GB50011, 100);
}
END_TEST

/* E.030: 0.006 x 12 m = 72 mm; 30 mm at least; two thirds of the sum where that is more. */
START_TEST(peru_by_hand)
{
    struct thud_gap_level level = level_of(0.05, 0.05, 12, true);
    is_mm(&level, THUD_GAP_E030, 72);
    level.right_m = 0.1;
    is_mm(&level, THUD_GAP_E030, 100);
    level = level_of(0.001, 0.001, 4, true);
    is_mm(&level, THUD_GAP_E030, 30);
}
END_TEST

/* 30 and 40 mm, q = 2, Cd/Ie = 5. */
START_TEST(europe_and_america_by_hand)
{
    struct thud_gap_level level = level_of(0.03, 0.04, 12, true);
    is_mm(&level, THUD_GAP_EN1998, 35);
    level.code.q = 2;
    level.code.cd = 5;
    is_mm(&level, THUD_GAP_EN1998_OWNERS, 140);
    is_mm(&level, THUD_GAP_EN1998_UNITS, 100);
    is_mm(&level, THUD_GAP_EN1998, 70);
    is_mm(&level, THUD_GAP_ASCE7, 250);
    is_mm(&level, THUD_GAP_ASCE7_LINE, 350);
    is_mm(&level, THUD_GAP_ABS, 70);
    is_mm(&level, THUD_GAP_SRSS, 50);
    level.aligned = false;
    is_mm(&level, THUD_GAP_EN1998, 100);
    level.correlation = NAN;
    ck_assert(isnan(thud_gap_value(&level, THUD_GAP_DDC)));
}
END_TEST

START_TEST(numbers_stand_in_the_formula)
{
    struct thud_gap_level level = level_of(0.018, 0.024, 12, true);
    struct thud_text text = {0};
    level.code.r = 8;
    thud_gap_numbers(&level, THUD_GAP_TBDY, &text);
    ck_assert_str_eq(text.data, "max(0.25 x 8 x sqrt(1.800^2 + 2.400^2), 3, 3 + (12 - 6)/3) cm");
    thud_text_clear(&text);
    for (int rule = 0; rule < THUD_GAP_RULES; rule++) {
        thud_gap_numbers(&level, rule, &text);
        ck_assert_ptr_null(strchr(text.data, '$'));
        thud_text_clear(&text);
        for (int other = THUD_GAP_EXACT; other < rule; other++) {
            ck_assert_str_ne(thud_gap_rule_at(rule)->name, thud_gap_rule_at(other)->name);
            ck_assert_str_ne(thud_gap_rule_at(rule)->column, thud_gap_rule_at(other)->column);
        }
    }
}
END_TEST

START_TEST(factors_of_codes)
{
    static const char *const wrong[] = {"",    "q",    "q=",          "q=0",           "q=-1",     "q=101",
                                        "z=2", "q=2,", "intensity=5", "intensity=9.5", "q=1.5 cm", "q=nan,cd=2"};
    struct thud_gap_code code;
    thud_gap_code_init(&code);
    ck_assert(code.q == 1 && code.cd == 1 && code.r == 1 && isnan(code.intensity));
    ck_assert_int_eq(thud_gap_code_set(&code, "q=1.5,intensity=8", &error), THUD_OK);
    ck_assert_int_eq(thud_gap_code_set(&code, "cd=4", &error), THUD_OK);
    ck_assert(code.q == 1.5 && code.cd == 4 && code.r == 1 && code.intensity == 8);
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        ck_assert_int_eq(thud_gap_code_set(&code, wrong[i], &error), THUD_USAGE);
}
END_TEST

/* EN 1998-1, 4.3.3.4.3(3): the mean of seven or more, the largest of fewer; a motion and the same reversed are one. */
START_TEST(means_of_seven_and_largest_of_fewer)
{
    enum { MOST = 8 };
    struct thud_needed_gap *gap[MOST];
    static const char *const apart[MOST] = {"a", "b", "c", "d", "e", "f", "g", "h"}, *const pairs[MOST] = {
                                                                                         "a", "a:sign=-",
                                                                                         "b", "b:sign=-",
                                                                                         "c", "c:sign=-",
                                                                                         "d", "d:sign=-"};
    struct thud_gap_ruled ruled;
    for (int r = 0; r < MOST; r++) {
        gap[r] = malloc(sizeof *gap[r] + sizeof *gap[r]->level);
        ck_assert_ptr_nonnull(gap[r]);
        gap[r]->nlevels = 1;
        gap[r]->level[0] = level_of(0.01 * (r + 1), 0.02 * (r + 1), 12, true);
    }
    struct thud_gap_suite suite = {6, apart, gap, 6};
    thud_gap_suite_rule(&suite, THUD_GAP_ABS, 1, &ruled);
    ck_assert_double_eq_tol(ruled.gap_m, 0.18, 1e-15); /* 0.06 + 0.12 */
    suite.nrecords = suite.recordings = 7;
    thud_gap_suite_rule(&suite, THUD_GAP_ABS, 1, &ruled);
    ck_assert_double_eq_tol(ruled.gap_m, 0.12, 1e-15);           /* 0.04 + 0.08 */
    thud_gap_suite_rule(&suite, THUD_GAP_ASCE7_LINE, 1, &ruled); /* ASCE 7-16, 16.2.2: the mean of eleven or more */
    ck_assert_double_eq_tol(ruled.gap_m, 0.21, 1e-15);
    suite.recordings = 11;
    thud_gap_suite_rule(&suite, THUD_GAP_ASCE7_LINE, 1, &ruled);
    ck_assert_double_eq_tol(ruled.gap_m, 0.12, 1e-15);
    thud_gap_suite_rule(&suite, THUD_GAP_EXACT, 1, &ruled);
    ck_assert_double_eq_tol(ruled.gap_m, 0.07, 1e-15);
    struct thud_record drawn[MOST] = {{.samples = 0}};
    const struct thud_record *motions[MOST];
    for (int r = 0; r < MOST; r++) {
        snprintf(drawn[r].file, sizeof drawn[r].file, "%s", pairs[r]);
        motions[r] = &drawn[r];
    }
    suite = (struct thud_gap_suite){MOST, pairs, gap, thud_motions_recordings(motions, MOST, NULL)};
    ck_assert_int_eq(suite.recordings, 4);
    static const char *const thrice[MOST] = {"a", "a:factor=2", "b", "c", "a:from=1 s:sign=-", "d", "e", "f"};
    int of[MOST]; /* six recordings, one of them three times, are six */
    for (int r = 0; r < MOST; r++)
        snprintf(drawn[r].file, sizeof drawn[r].file, "%s", thrice[r]);
    ck_assert_int_eq(thud_motions_recordings(motions, MOST, of), 6);
    ck_assert(of[1] == 0 && of[4] == 0 && of[2] == 1 && of[7] == 5);
    snprintf(drawn[1].file, sizeof drawn[1].file, "a:column=3"); /* another of the same table */
    ck_assert_int_eq(thud_motions_recordings(motions, MOST, NULL), 7);
    thud_gap_suite_rule(&suite, THUD_GAP_ABS, 1, &ruled);
    ck_assert_double_eq_tol(ruled.gap_m, 0.24, 1e-15);
    gap[2]->level[0].correlation = NAN; /* a storey yielded in one motion */
    thud_gap_suite_rule(&suite, THUD_GAP_DDC, 1, &ruled);
    ck_assert(isnan(ruled.gap_m));
    for (int r = 0; r < MOST; r++)
        free(gap[r]);
}
END_TEST

/* A run of its own at the gap of every rule; at the needed gap there is no contact. */
START_TEST(what_happens_at_the_gap)
{
    struct thud_needed_gap *gap;
    static const char *const names[] = {"a"};
    int pounds = 0;
    scene->interface[0].gap_m = 0.5;
    thud_interface_add_bumper(&scene->interface[0]); /* which is left out */
    ck_assert_int_eq(thud_needed_gap_run(scene, motion, &gap, &error), THUD_OK);
    struct thud_gap_suite suite = {1, names, &gap, 1};
    for (int rule = THUD_GAP_EXACT; rule < THUD_GAP_RULES; rule++) {
        struct thud_gap_ruled ruled;
        struct thud_solution solution;
        double force = 0;
        thud_gap_suite_rule(&suite, rule, 1, &ruled);
        if (isnan(ruled.gap_m))
            continue;
        ck_assert_double_eq(ruled.gap_m, thud_needed_gap_widest(gap, 0, rule, NULL));
        ck_assert_int_eq(thud_gap_pound(scene, motion, &suite, 0, &ruled, &error), THUD_OK);
        ck_assert_int_eq(thud_scene_case(scene, THUD_CASE_NONE, scene + 1, &error), THUD_OK);
        scene[1].interface[0].gap_m = ruled.gap_m;
        ck_assert_int_eq(thud_scene_solve(scene + 1, motion, NULL, &solution, &error), THUD_OK);
        for (int c = 0; c < solution.model->ncontacts; c++)
            force = fmax(force, thud_run_result(solution.run)->contact[c].force.value);
        thud_solution_clear(&solution);
        ck_assert_double_eq(ruled.force_n, force);
        ck_assert_int_eq(ruled.pounding, force > 0);
        ck_assert_int_eq(ruled.worst, force > 0 ? 0 : -1);
        ck_assert(rule != THUD_GAP_EXACT || force == 0);
        pounds += force > 0;
    }
    ck_assert_int_gt(pounds, 0);
    for (int i = 0; i < 2; i++) { /* without a value: the scene's own gap */
        struct thud_gap_ruled none = {.gap_m = NAN, .worst = -1};
        scene->interface[0].gap_m = i == 0 ? 0.5 : 0.01;
        scene->interface[0].has_bumper = false;
        ck_assert_int_eq(thud_gap_pound(scene, motion, &suite, 0, &none, &error), THUD_OK);
        ck_assert_int_eq(none.pounding, i);
    }
    free(gap);
}
END_TEST

/* DDC's periods are elastic ones: where a storey yields it has no value, and where none does, however little is
 * missing, it has. */
START_TEST(no_ddc_where_storeys_yield)
{
    for (int i = 0; i < 2; i++) {
        struct thud_needed_gap *gap;
        for (int f = 0; f < scene->structure[1].storeys; f++) {
            scene->structure[1].yield_m[f] = i == 0 ? 10 : 0.008;
            scene->structure[1].hardening[f] = 0.05;
        }
        ck_assert_int_eq(thud_needed_gap_run(scene, motion, &gap, &error), THUD_OK);
        for (int rule = THUD_GAP_EXACT; rule < THUD_GAP_GB50011; rule++) {
            bool none = i == 1 && rule == THUD_GAP_DDC;
            ck_assert_int_eq(isnan(thud_gap_value(&gap->level[0], rule)) != 0, none);
            ck_assert_int_eq(isnan(thud_needed_gap_widest(gap, 0, rule, NULL)) != 0, none);
        }
        free(gap);
    }
}
END_TEST

/* Heights are above the ground that a building stands on; of the two buildings the lower one counts. */
START_TEST(heights_of_levels)
{
    struct thud_needed_gap *gap;
    double top = 0, other = 0;
    for (int s = 0; s < 2; s++)
        scene->structure[s].base_m = 5;
    scene->structure[0].storeys = 3;
    for (int f = 0; f < 3; f++)
        top += scene->structure[0].height_m[f];
    for (int f = 0; f < scene->structure[1].storeys; f++)
        other += scene->structure[1].height_m[f];
    ck_assert_int_eq(thud_needed_gap_run(scene, motion, &gap, &error), THUD_OK);
    ck_assert_double_lt(top, other);
    ck_assert_double_eq_tol(gap->level[gap->nlevels - 1].height_m, top, 1e-12);
    ck_assert_double_eq_tol(gap->level[0].height_m, scene->structure[0].height_m[0], 1e-12);
    ck_assert_double_eq_tol(gap->level[0].lower_m, top, 1e-12);
    free(gap);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("gap_rule");
    TCase *tcase = tcase_create("gap_rule");
    tcase_add_checked_fixture(tcase, set_up, study_tear_down);
    tcase_add_test(tcase, turkey_by_hand);
    tcase_add_test(tcase, china_by_hand);
    tcase_add_test(tcase, peru_by_hand);
    tcase_add_test(tcase, europe_and_america_by_hand);
    tcase_add_test(tcase, numbers_stand_in_the_formula);
    tcase_add_test(tcase, factors_of_codes);
    tcase_add_test(tcase, means_of_seven_and_largest_of_fewer);
    tcase_add_test(tcase, what_happens_at_the_gap);
    tcase_add_test(tcase, no_ddc_where_storeys_yield);
    tcase_add_test(tcase, heights_of_levels);
    suite_add_tcase(suite, tcase);
    return suite;
}
