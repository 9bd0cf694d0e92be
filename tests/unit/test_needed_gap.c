/* The gap that is enough: contact just below it and none just above, linear in the ground motion, and the codes' rules
 * in their limits. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "study/scene/first_contact.h"
#include "study/scene/solution.h"
#include "study/suite/gap_suite.h"
#include "study_setup.h"

static void set_up(void)
{
    study_set_up(1);
}

static struct thud_needed_gap *gap_of(const struct thud_record *record)
{
    struct thud_needed_gap *gap;
    ck_assert_msg(thud_needed_gap_run(scene, record, &gap, &error) == THUD_OK, "%s", error.what);
    return gap;
}

/* Impacts of the scene without bumper at a gap. */
static int impacts_at(double gap_m)
{
    struct thud_solution solution;
    int impacts = 0;
    scene->interface[0].gap_m = gap_m;
    ck_assert_int_eq(thud_scene_case(scene, THUD_CASE_NONE, scene + 1, &error), THUD_OK);
    ck_assert_int_eq(thud_scene_solve(scene + 1, motion, NULL, &solution, &error), THUD_OK);
    const struct thud_result *result = thud_run_result(solution.run);
    for (int c = 0; c < result->ncontacts; c++)
        impacts += result->contact[c].impacts;
    thud_solution_clear(&solution);
    return impacts;
}

/* Also where storeys yield, of whose motion no closed form tells the gap. */
START_TEST(just_enough_and_just_not)
{
    struct thud_needed_gap *gap = gap_of(motion);
    if (_i == 1) {
        double elastic = thud_needed_gap_widest(gap, 0, THUD_GAP_EXACT, &(int){0});
        free(gap);
        for (int s = 0; s < scene->nstructures; s++)
            for (int i = 0; i < scene->structure[s].storeys; i++) {
                scene->structure[s].yield_m[i] = 0.008;
                scene->structure[s].hardening[i] = 0.05;
            }
        gap = gap_of(motion);
        double yielding = thud_needed_gap_widest(gap, 0, THUD_GAP_EXACT, &(int){0});
        ck_assert_double_gt(fabs(yielding / elastic - 1), 0.05);
    }
    int level = -1;
    double needed = thud_needed_gap_widest(gap, 0, THUD_GAP_EXACT, &level);
    ck_assert_double_gt(needed, 0);
    ck_assert(gap->level[level].relative_displacement_m == needed);
    ck_assert_int_eq(impacts_at(needed * (1 + 1e-9)), 0);
    ck_assert_int_gt(impacts_at(needed * (1 - 1e-6)), 0);
    free(gap);
}
END_TEST

START_TEST(linear_in_the_ground_motion)
{
    struct thud_needed_gap *one = gap_of(motion);
    thud_record_scale(motion, 2.5);
    struct thud_needed_gap *more = gap_of(motion);
    for (int i = 0; i < one->nlevels; i++)
        for (int rule = THUD_GAP_EXACT; rule < THUD_GAP_TBDY; rule++) { /* those that follow have least widths */
            double x = thud_gap_value(&one->level[i], rule);
            ck_assert_double_eq_tol(thud_gap_value(&more->level[i], rule), 2.5 * x, 1e-12 * x);
        }
    free(one);
    free(more);
}
END_TEST

START_TEST(neither_gap_nor_bumper_matters)
{
    struct thud_needed_gap *one = gap_of(motion);
    scene->interface[0].gap_m = 0.2;
    thud_interface_add_bumper(&scene->interface[0]);
    struct thud_needed_gap *other = gap_of(motion);
    for (int i = 0; i < one->nlevels; i++)
        ck_assert(one->level[i].relative_displacement_m == other->level[i].relative_displacement_m);
    free(one);
    free(other);
}
END_TEST

/* Equal buildings move alike: nothing closes, and DDC (correlation 1) is the difference of the two peaks, 0. */
START_TEST(equal_buildings_need_none)
{
    scene->structure[1] = scene->structure[0];
    scene->structure[1].name[0] = 'Z';
    struct thud_needed_gap *gap = gap_of(motion);
    for (int i = 0; i < gap->nlevels; i++) {
        const struct thud_gap_level *l = &gap->level[i];
        ck_assert_double_le(l->relative_displacement_m, 1e-12);
        ck_assert_double_eq_tol(l->correlation, 1, 1e-12);
        ck_assert_double_le(thud_gap_value(l, THUD_GAP_DDC), 1e-6 * l->left_m);
        ck_assert_double_eq_tol(thud_gap_value(l, THUD_GAP_ABS), 2 * l->left_m, 1e-12 * l->left_m);
    }
    free(gap);
}
END_TEST

/* Bodies on no springs stay where they are, whatever their masses, while the ground moves: what rounding leaves between
 * them is no displacement, and no factor on the motion makes it one. One that drifts off at 1 nm/s does use up the gap. */
START_TEST(bodies_that_move_alike_need_none)
{
    struct thud_first_contact begins;
    for (int i = 0; i < 2; i++) {
        thud_structure_init(&scene->structure[i], THUD_RIGID);
        scene->structure[i].storeys = 1;
        scene->structure[i].mass_kg[0] = 2e4 + 1e4 * i;
        snprintf(scene->structure[i].name, sizeof scene->structure[i].name, "body %d", i + 1);
    }
    struct thud_needed_gap *gap = gap_of(motion);
    ck_assert_int_eq(gap->nlevels, 1);
    ck_assert_double_gt(gap->level[0].left_m, 0.01);
    ck_assert(gap->level[0].relative_displacement_m == 0);
    ck_assert(gap->level[0].correlation == 1 && thud_gap_value(&gap->level[0], THUD_GAP_DDC) < 1e-9);
    ck_assert_int_eq(thud_first_contact_find(scene, motion, gap, &begins, NULL), THUD_OK);
    ck_assert_double_infinite(begins.first);
    free(gap);
    scene->structure[0].velocity_mps = 1e-9;
    gap = gap_of(motion);
    const double s = (double)(motion->samples - 1) * motion->dt_s + scene->analysis.tail_s;
    ck_assert_double_eq_tol(gap->level[0].relative_displacement_m, 1e-9 * s, 1e-6 * 1e-9 * s);
    ck_assert(gap->level[0].correlation == 0);
    free(gap);
}
END_TEST

/* The sum of the peaks is a bound; the rules against each other. */
START_TEST(rules_in_their_order)
{
    struct thud_needed_gap *gap = gap_of(motion);
    ck_assert_int_eq(gap->nlevels, 4);
    for (int i = 0; i < gap->nlevels; i++) {
        const struct thud_gap_level *l = &gap->level[i];
        double srss = hypot(l->left_m, l->right_m);
        ck_assert_double_le(l->relative_displacement_m, thud_gap_value(l, THUD_GAP_ABS) * (1 + 1e-12));
        ck_assert_double_eq_tol(thud_gap_value(l, THUD_GAP_SRSS), srss, 1e-15);
        ck_assert_double_eq_tol(thud_gap_value(l, THUD_GAP_ASCE7), srss, 1e-15);
        ck_assert_double_eq_tol(thud_gap_value(l, THUD_GAP_EN1998), 0.7 * srss, 1e-15);
        ck_assert_double_lt(thud_gap_value(l, THUD_GAP_DDC), srss);
    }
    struct thud_gap_level wall = {.left_floor = 3, .left_m = 0.1, .code = {.q = 1}};
    ck_assert_double_eq_tol(thud_gap_value(&wall, THUD_GAP_EN1998), 0.1, 1e-15); /* no aligned floors before a wall */
    free(gap);
}
END_TEST

/* 3 storeys of 3 m beside 2 of 4.5 m: the tops meet, the floors below do not, so the reduction of EN 1998-1 4.4.2.7(3)
 * holds nowhere; nor is a sum that misses what is needed by rounding too little. */
START_TEST(the_reduction_is_for_equal_elevations)
{
    const double three[] = {3, 3, 3}, two[] = {4.5, 4.5};
    bool aligned[THUD_STRUCTURES_MAX];
    scene->structure[0].storeys = 3;
    scene->structure[1].storeys = 2;
    memcpy(scene->structure[0].height_m, three, sizeof three);
    memcpy(scene->structure[1].height_m, two, sizeof two);
    thud_gap_aligned(scene, aligned);
    ck_assert(!aligned[0]);
    struct thud_needed_gap *gap = gap_of(motion);
    ck_assert_int_gt(gap->nlevels, 0);
    for (int i = 0; i < gap->nlevels; i++)
        ck_assert_double_eq(thud_gap_value(&gap->level[i], THUD_GAP_EN1998),
                            thud_gap_value(&gap->level[i], THUD_GAP_SRSS));
    free(gap);
    scene->structure[1].storeys = 5;
    for (int f = 0; f < 5; f++)
        scene->structure[1].height_m[f] = 3;
    thud_gap_aligned(scene, aligned);
    ck_assert(aligned[0]);
    ck_assert(!thud_gap_falls_short(0.657 * (1 - 1e-13), 0.657) && thud_gap_falls_short(0.656, 0.657));
}
END_TEST

START_TEST(a_suite_of_one_motion_has_no_spread)
{
    struct thud_needed_gap *gap = gap_of(motion), *all[3] = {gap, gap, gap};
    const char *const names[3] = {"a", "b", "c"};
    struct thud_gap_suite suite = {3, names, all, 3};
    struct thud_fractiles f;
    for (int level = -1; level < gap->nlevels; level++)
        for (int rule = THUD_GAP_EXACT; rule < THUD_GAP_RULES; rule++) {
            ck_assert_int_eq(thud_gap_suite_fractiles(&suite, 0, level, rule, &f, &error), THUD_OK);
            double x =
                level < 0 ? thud_needed_gap_widest(gap, 0, rule, NULL) : thud_gap_value(&gap->level[level], rule);
            if (rule == THUD_GAP_GB50011) { /* no intensity */
                ck_assert(isnan(x) && f.n == 0 && isnan(f.median) && isnan(f.share));
                continue;
            }
            ck_assert(f.n == 3 && f.p16 == x && f.median == x && f.p84 == x && f.most == x);
            ck_assert(f.share == 0 || f.share == 1);
        }
    ck_assert_int_eq(thud_gap_suite_fractiles(&suite, 0, -1, THUD_GAP_ABS, &f, &error), THUD_OK);
    ck_assert(f.share == 0); /* the sum is never too little */
    suite.recordings = 2;    /* of which there are no fractiles */
    ck_assert_int_eq(thud_gap_suite_fractiles(&suite, 0, -1, THUD_GAP_ABS, &f, &error), THUD_OK);
    ck_assert(isnan(f.p16) && f.median > 0 && isnan(f.p84));
    free(gap);
}
END_TEST

/* The factor from which on a motion causes contact, by runs with contact at a bit more and a bit less; also where
 * storeys yield, of which no closed form tells it (_i > 1), from below and from above. */
START_TEST(factor_from_which_on_they_pound)
{
    for (int s = 0; s < scene->nstructures && _i > 1; s++)
        for (int i = 0; i < scene->structure[s].storeys; i++) {
            scene->structure[s].yield_m[i] = 0.008;
            scene->structure[s].hardening[i] = 0.05;
        }
    struct thud_needed_gap *gap = gap_of(motion);
    double needed = thud_needed_gap_widest(gap, 0, THUD_GAP_EXACT, NULL);
    struct thud_first_contact contact;
    ck_assert_int_eq(thud_scene_case(scene, THUD_CASE_NONE, scene, &error), THUD_OK);
    const int i = _i % 2;
    scene->interface[0].gap_m = needed * (i ? 1.3 : 0.6);
    ck_assert_int_eq(thud_first_contact_find(scene, motion, gap, &contact, &error), THUD_OK);
    ck_assert(_i > 1 || fabs(contact.first / (i ? 1.3 : 0.6) - 1) < 1e-9);
    ck_assert(i ? contact.first > 1 : contact.first < 1);
    for (int end = -1; end <= 1; end += 2) {
        struct thud_solution solution;
        struct thud_record *scaled;
        int impacts = 0;
        ck_assert_int_eq(thud_record_create(motion->a_mps2, motion->samples, motion->dt_s, &scaled, &error), THUD_OK);
        thud_record_scale(scaled, contact.first * (1 + 3e-6 * end));
        ck_assert_int_eq(thud_scene_solve(scene, scaled, NULL, &solution, &error), THUD_OK);
        const struct thud_result *result = thud_run_result(solution.run);
        for (int c = 0; c < result->ncontacts; c++)
            impacts += result->contact[c].impacts;
        ck_assert_int_eq(impacts > 0, end > 0);
        thud_solution_clear(&solution);
        thud_record_free(scaled);
    }
    free(gap);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("needed_gap");
    TCase *tcase = tcase_create("needed_gap");
    tcase_add_checked_fixture(tcase, set_up, study_tear_down);
    tcase_add_loop_test(tcase, just_enough_and_just_not, 0, 2);
    tcase_add_test(tcase, linear_in_the_ground_motion);
    tcase_add_test(tcase, neither_gap_nor_bumper_matters);
    tcase_add_test(tcase, equal_buildings_need_none);
    tcase_add_test(tcase, bodies_that_move_alike_need_none);
    tcase_add_test(tcase, rules_in_their_order);
    tcase_add_test(tcase, the_reduction_is_for_equal_elevations);
    tcase_add_test(tcase, a_suite_of_one_motion_has_no_spread);
    tcase_add_loop_test(tcase, factor_from_which_on_they_pound, 0, 4);
    suite_add_tcase(suite, tcase);
    return suite;
}
