/* Small changes of the inputs: exact ratios where there is no contact, and the scaling symmetry where there is. */
#include <check.h>
#include <math.h>

#include "study/sweep/sensitivity.h"
#include "towers.h"

static const double change = 1e-3;

static struct thud_sensitivity *measured(double gap_m, struct thud_solution *solution, struct thud_record *record)
{
    static struct thud_scene scene;
    struct thud_sensitivity *s = NULL;
    struct thud_error err = {0};
    thud_test_towers(&scene);
    scene.interface[0].has_bumper = false;
    scene.interface[0].gap_m = gap_m;
    scene.analysis.tolerance = 1e-9;
    ck_assert_int_eq(thud_scene_solve(&scene, record, NULL, solution, &err), THUD_OK);
    ck_assert_msg(thud_sensitivity_run(&scene, record, change, thud_run_result(solution->run), &s, &err) == THUD_OK,
                  "%s", err.what);
    return s;
}

START_TEST(without_contact_only_the_motion_counts)
{
    struct thud_record *record = thud_test_motion(1);
    struct thud_solution solution;
    struct thud_sensitivity *s = measured(5, &solution, record);
    ck_assert_int_eq(s->nfloors, 10);
    ck_assert_int_eq(s->runs, 9);
    for (int i = 0; i < s->nfloors; i++)
        for (int q = 0; q < THUD_FLOOR_SPREADS; q++) {
            ck_assert(s->floor[i][q].by[THUD_CHANGE_GAP] == 0);
            ck_assert_double_eq_tol(s->floor[i][q].by[THUD_CHANGE_SCALE], change, 1e-9);
            ck_assert((s->floor[i][q].by[THUD_CHANGE_STIFFNESS_ODD] > 0) == (i < 4)); /* of the own building */
            ck_assert((s->floor[i][q].by[THUD_CHANGE_STIFFNESS_EVEN] > 0) == (i >= 4));
        }
    for (int c = 0; c < s->ncontacts; c++)
        ck_assert(thud_spread_most(&s->contact[c][0]) == 0);
    thud_sensitivity_free(s);
    thud_solution_clear(&solution);
    thud_record_free(record);
}
END_TEST

/* The response to lambda a at gap g is lambda times that to a at gap g/lambda. */
START_TEST(gap_and_motion_trade_against_each_other)
{
    static struct thud_scene scene;
    struct thud_record *record = thud_test_motion(1);
    struct thud_solution solution, traded[2];
    struct thud_sensitivity *s = measured(0.1, &solution, record);
    double lambda[2] = {1 - change, 1 + change};
    int moved = 0, row = 0;
    for (int k = 0; k < 2; k++) {
        thud_test_towers(&scene);
        scene.interface[0].has_bumper = false;
        scene.interface[0].gap_m = 0.1 / lambda[k];
        scene.analysis.tolerance = 1e-9;
        ck_assert_int_eq(thud_scene_solve(&scene, record, NULL, &traded[k], NULL), THUD_OK);
    }
    const struct thud_result *r = thud_run_result(solution.run);
    for (int b = 0; b < r->nstructures; b++)
        for (int i = 0; i < r->structure[b].floors; i++, row++) {
            double before = r->structure[b].floor[i].acceleration.value, most = 0;
            for (int k = 0; k < 2; k++) {
                double after = thud_run_result(traded[k].run)->structure[b].floor[i].acceleration.value;
                most = fmax(most, fabs(lambda[k] * after / before - 1));
            }
            ck_assert_double_eq_tol(s->floor[row][0].by[THUD_CHANGE_SCALE], most, 1e-7);
            moved += fabs(most - change) > 1e-5;
        }
    ck_assert_int_gt(moved, 3); /* there are contacts that matter */
    for (int k = 0; k < 2; k++)
        thud_solution_clear(&traded[k]);
    thud_sensitivity_free(s);
    thud_solution_clear(&solution);
    thud_record_free(record);
}
END_TEST

/* Equal buildings do not touch, however stiff both are; they do when one is a little stiffer than the other. */
START_TEST(one_building_against_its_neighbour)
{
    static struct thud_scene scene;
    struct thud_record *record = thud_test_motion(1);
    struct thud_solution solution;
    struct thud_sensitivity *s = NULL;
    thud_test_towers(&scene);
    scene.structure[1] = scene.structure[0];
    scene.interface[0].has_bumper = false;
    scene.interface[0].gap_m = 1e-4;
    ck_assert_int_eq(thud_scene_solve(&scene, record, NULL, &solution, NULL), THUD_OK);
    ck_assert_int_eq(thud_sensitivity_run(&scene, record, change, thud_run_result(solution.run), &s, NULL), THUD_OK);
    const struct thud_spread *top = &s->contact[s->ncontacts - 1][0];
    ck_assert(top->by[THUD_CHANGE_STIFFNESS_ODD] == 1 && top->by[THUD_CHANGE_STIFFNESS_EVEN] == 1);
    ck_assert(top->by[THUD_CHANGE_GAP] == 0 && top->by[THUD_CHANGE_SCALE] == 0);
    thud_sensitivity_free(s);
    thud_solution_clear(&solution);
    thud_record_free(record);
}
END_TEST

/* The change stays below one unit of the last digit that means anything, whatever the number, and no digit more could
 * be promised. */
START_TEST(digits_outlast_the_change)
{
    static const double spread[] = {1e-9, 2e-5, 9e-4, 1e-3, 5e-3, 0.08, 0.1, 0.3, 1, 7};
    for (size_t i = 0; i < sizeof spread / sizeof *spread; i++) {
        int digits = thud_spread_digits(spread[i]);
        double largest = 10, unit = pow(10, 1 - digits); /* of numbers from 1 to 10 */
        ck_assert(digits == 0 || spread[i] * largest <= 1.05 * unit);
        ck_assert(spread[i] * largest > 0.1 * unit);
    }
    ck_assert_int_eq(thud_spread_digits(0.3), 0);
    ck_assert_int_eq(thud_spread_digits(1.0000001e-3), 3);
    ck_assert_int_ge(thud_spread_digits(0), 15);
}
END_TEST

Suite *thud_suite(void)
{
    Suite *suite = suite_create("sensitivity");
    TCase *tcase = tcase_create("sensitivity");
    tcase_add_test(tcase, without_contact_only_the_motion_counts);
    tcase_add_test(tcase, gap_and_motion_trade_against_each_other);
    tcase_add_test(tcase, one_building_against_its_neighbour);
    tcase_add_test(tcase, digits_outlast_the_change);
    suite_add_tcase(suite, tcase);
    return suite;
}
