/* The spread of a study's points: against runs made apart, against what linearity says, through the journal's text. */
#include <check.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "study/scene/solution.h"
#include "study_setup.h"
#include "sweep_rows.h"

static const double change = 2e-3;

static void set_up(void)
{
    study_set_up(1);
    plan->sensitivity = change;
}

/* The only point of a study of one gap. */
static struct thud_sweep_point *one_point(const char *gap, const char *cases)
{
    struct thud_sweep_group *group;
    struct thud_sweep_task *task;
    thud_sweep_plan_clear(plan);
    ck_assert_int_eq(thud_sweep_vary(plan, gap, &error), THUD_OK);
    ck_assert_int_eq(thud_sweep_cases(plan, cases, &error), THUD_OK);
    ck_assert_msg(thud_sweep_group_create(plan, 0, &group, &error) == THUD_OK, "%s", error.what);
    for (bool done = false; !done;)
        ck_assert_int_eq(thud_sweep_group_advance(group, 50, &done, &error), THUD_OK);
    ck_assert_int_eq(thud_sweep_task_create(plan, group, 0, &task, &error), THUD_OK);
    for (bool done = false; !done;)
        ck_assert_int_eq(thud_sweep_task_advance(task, 70, &done, &error), THUD_OK);
    struct thud_sweep_point *point = thud_sweep_task_take(task);
    thud_sweep_task_free(task);
    thud_sweep_group_free(group);
    return point;
}

/* Largest relative distance of an end from the value. */
static double reach(double low, double value, double high)
{
    ck_assert(low <= value && value <= high);
    return value != 0 ? fmax(high / value - 1, 1 - low / value) : high > 0;
}

static struct thud_sensitivity *apart(struct thud_solution *solution)
{
    struct thud_sensitivity *s;
    ck_assert_int_eq(thud_scene_solve(scene + 1, motion, NULL, solution, &error), THUD_OK);
    ck_assert_int_eq(thud_sensitivity_run(scene + 1, motion, change, thud_run_result(solution->run), &s, &error),
                     THUD_OK);
    return s;
}

START_TEST(the_spread_is_that_of_runs_made_apart)
{
    struct thud_sweep_row row[24];
    struct thud_sweep_contact_row contact[8];
    struct thud_sweep_point *point = one_point("gap=7 cm", "bumper,none");
    ck_assert_int_eq(sweep_rows(point, row), 24);
    ck_assert_int_eq(sweep_contact_rows(point, contact), 8);
    ck_assert_int_eq(point->changed.made + point->changed.free, 16);
    scene->interface[0].gap_m = 0.07;
    for (int k = 0, i = 0; k < 2; k++) {
        struct thud_solution solution;
        enum thud_case which = k ? THUD_CASE_NONE : THUD_CASE_BUMPER;
        ck_assert_int_eq(thud_scene_case(scene, which, scene + 1, &error), THUD_OK);
        struct thud_sensitivity *s = apart(&solution);
        for (int floor = 0; floor < 10; i++) {
            if (row[i].floor == 0)
                continue;
            ck_assert_int_eq(row[i].which, which);
            ck_assert_double_eq_tol(reach(row[i].low[THUD_MEASURE_ACCELERATION], row[i].of[THUD_MEASURE_ACCELERATION],
                                          row[i].high[THUD_MEASURE_ACCELERATION]),
                                    thud_spread_most(&s->floor[floor][0]), 1e-12);
            ck_assert_double_eq_tol(
                reach(row[i].low[THUD_MEASURE_DRIFT], row[i].of[THUD_MEASURE_DRIFT], row[i].high[THUD_MEASURE_DRIFT]),
                thud_spread_most(&s->floor[floor][3]), 1e-12);
            floor++;
        }
        for (int c = 0; c < 4; c++) {
            const struct thud_sweep_contact_row *r = &contact[4 * k + c];
            ck_assert_double_eq_tol(reach(r->force_low_n, r->of.force_n, r->force_high_n),
                                    thud_spread_most(&s->contact[c][0]), 1e-12);
            ck_assert_double_eq_tol(reach(r->indentation_low_m, r->of.indentation_m, r->indentation_high_m),
                                    thud_spread_most(&s->contact[c][1]), 1e-12);
        }
        thud_sensitivity_free(s);
        thud_solution_clear(&solution);
    }
    free(point);
}
END_TEST

/* Both runs of a ratio are changed alike, so a ratio of a case to itself has no spread; and where there is no
 * contact, no ratio has any, while the peaks follow the motion. */
START_TEST(ratios_are_of_runs_changed_alike)
{
    struct thud_sweep_row row[24];
    struct thud_sweep_point *point = one_point("gap=7 cm", "none");
    int n = sweep_rows(point, row);
    ck_assert_int_eq(n, 12);
    for (int i = 0; i < n; i++) {
        ck_assert(row[i].low[THUD_MEASURE_ACCELERATION_RATIO] == 1 &&
                  row[i].high[THUD_MEASURE_ACCELERATION_RATIO] == 1);
        ck_assert(row[i].high[THUD_MEASURE_ACCELERATION] > row[i].low[THUD_MEASURE_ACCELERATION]);
    }
    free(point);
    point = one_point("gap=3 m", "none,bumper");
    n = sweep_rows(point, row);
    ck_assert_int_eq(point->changed.made, 0); /* there is no contact in any of them */
    for (int i = 0; i < n; i++) {
        ck_assert(row[i].low[THUD_MEASURE_ACCELERATION_RATIO] == 1 &&
                  row[i].high[THUD_MEASURE_ACCELERATION_RATIO] == 1);
        ck_assert(row[i].low[THUD_MEASURE_DRIFT_FREE_RATIO] == 1 && row[i].high[THUD_MEASURE_DRIFT_FREE_RATIO] == 1);
        ck_assert(row[i].low[THUD_MEASURE_DRIFT] <= row[i].of[THUD_MEASURE_DRIFT] * (1 - change) * (1 + 1e-9));
        ck_assert(row[i].high[THUD_MEASURE_DRIFT] >= row[i].of[THUD_MEASURE_DRIFT] * (1 + change) * (1 - 1e-9));
    }
    free(point);
}
END_TEST

START_TEST(shortcuts_change_no_spread)
{
    struct thud_sweep_row row[2][36];
    for (int i = 0; i < 2; i++) {
        plan->shortcuts = i ? THUD_SWEEP_ALL : 0;
        struct thud_sweep_point *point = one_point("gap=9 cm", "none,bumper,cavity");
        ck_assert_int_eq(sweep_rows(point, row[i]), 36);
        free(point);
    }
    for (int i = 0; i < 36; i++) {
        ck_assert(memcmp(row[0][i].low, row[1][i].low, sizeof row[0][i].low) == 0);
        ck_assert(memcmp(row[0][i].high, row[1][i].high, sizeof row[0][i].high) == 0);
    }
}
END_TEST

/* A gap just as wide as the bumper is not made narrower; a bumper wider than the gap has no result and no spread. */
START_TEST(a_bumper_keeps_its_room)
{
    struct thud_sweep_row row[24];
    struct thud_sweep_point *point = one_point("gap=5 cm", "none,bumper");
    ck_assert_int_eq(sweep_rows(point, row), 24);
    ck_assert_int_eq(point->changed.failed, 0);
    for (int i = 0; i < 24; i++)
        ck_assert(isfinite(row[i].low[THUD_MEASURE_ACCELERATION_RATIO]));
    free(point);
    point = one_point("gap=4 cm", "none,bumper");
    ck_assert_int_eq(sweep_rows(point, row), 12);
    ck_assert_int_eq(point->changed.failed, 0);
    for (int i = 0; i < 12; i++)
        ck_assert(isfinite(row[i].low[THUD_MEASURE_ACCELERATION]));
    free(point);
}
END_TEST

START_TEST(a_spread_as_text_and_back)
{
    static const char *const gaps[] = {"gap=4 cm", "gap=7 cm", "gap=3 m"};
    for (int i = 0; i < 6; i++) {
        plan->sensitivity = i < 3 ? change : 0;
        struct thud_sweep_point *point = one_point(gaps[i % 3], "none,bumper"), *back;
        struct thud_sweep_row row[2][24];
        struct thud_text text = {0}, again = {0};
        memset(row, 0, sizeof row);
        thud_sweep_point_write(point, &text);
        ck_assert(strchr("s0123456789", text.data[0]) && (text.data[0] == 's') == (i < 3));
        ck_assert_int_eq(thud_sweep_point_read(text.data, &back, &error), THUD_OK);
        thud_sweep_point_write(back, &again);
        ck_assert_str_eq(text.data, again.data);
        int n = sweep_rows(point, row[0]);
        ck_assert_int_eq(sweep_rows(back, row[1]), n);
        ck_assert_int_eq(memcmp(row[0], row[1], sizeof row[0]), 0);
        ck_assert(isnan(row[0][0].low[THUD_MEASURE_DRIFT]) == (i >= 3));
        free(back);
        for (size_t at = 0; at < text.size; at += 31) {
            char kept = text.data[at];
            text.data[at] = kept == '1' ? '2' : '1';
            ck_assert_int_eq(thud_sweep_point_read(text.data, &back, &error), THUD_INPUT);
            text.data[at] = kept;
        }
        thud_text_clear(&text);
        thud_text_clear(&again);
        free(point);
    }
}
END_TEST

START_TEST(a_spread_makes_another_study)
{
    ck_assert_int_eq(thud_sweep_vary(plan, "gap=7 cm", &error), THUD_OK);
    unsigned long long with = thud_sweep_fingerprint(plan);
    plan->sensitivity = 2 * change;
    ck_assert(thud_sweep_fingerprint(plan) != with);
    plan->sensitivity = 0;
    ck_assert(thud_sweep_fingerprint(plan) != with);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("sweep spread");
    TCase *tcase = tcase_create("spread");
    tcase_add_checked_fixture(tcase, set_up, study_tear_down);
    tcase_add_test(tcase, the_spread_is_that_of_runs_made_apart);
    tcase_add_test(tcase, ratios_are_of_runs_changed_alike);
    tcase_add_test(tcase, shortcuts_change_no_spread);
    tcase_add_test(tcase, a_bumper_keeps_its_room);
    tcase_add_test(tcase, a_spread_as_text_and_back);
    tcase_add_test(tcase, a_spread_makes_another_study);
    suite_add_tcase(suite, tcase);
    return suite;
}
