/* The plan of a parametric study: keys over ranges and lists, cases, the numbering of its points. */
#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "study_setup.h"

static void set_up(void)
{
    study_set_up(1);
}

static void refused(const char *text, enum thud_status status, const char *key)
{
    ck_assert_msg(thud_sweep_vary(plan, text, &error) == status, "%s", text);
    ck_assert_str_eq(error.key, key);
    ck_assert_int_gt((int)strlen(error.what), 0);
}

START_TEST(ranges_and_lists)
{
    vary("gap=5 cm:25 cm:0.5 cm");
    vary("bumper.thickness=2, 3.5,5 cm");
    ck_assert_int_eq(plan->axis[0].n, 41);
    ck_assert_str_eq(plan->axis[0].text[9], "9.5 cm");
    ck_assert(plan->axis[0].value[9] == 0.095);
    ck_assert(plan->axis[0].value[40] == 0.25);
    ck_assert_int_eq(plan->axis[1].n, 3);
    ck_assert(plan->axis[1].value[0] == 0.02 && plan->axis[1].value[1] == 0.035 && plan->axis[1].value[2] == 0.05);
    ck_assert_int_eq(thud_sweep_points(plan), 123);
    ck_assert_int_eq(thud_sweep_points_per_group(plan), 123);
}
END_TEST

START_TEST(a_ratio_and_per_cent_are_of_one_kind)
{
    vary("structures.1.damping=0.05:7%:0.01");
    ck_assert_int_eq(plan->axis[0].n, 3);
    ck_assert_double_eq_tol(plan->axis[0].value[1], 0.06, 1e-12);
}
END_TEST

START_TEST(units_of_ranges)
{
    vary("gap=5:25:5 cm");
    ck_assert_int_eq(plan->axis[0].n, 5);
    ck_assert(plan->axis[0].value[4] == 0.25);
    thud_sweep_plan_clear(plan);
    vary("gap=50 mm:0.1 m:1 cm");
    ck_assert_int_eq(plan->axis[0].n, 6);
    ck_assert_double_eq_tol(plan->axis[0].value[3], 0.08, 1e-15);
    thud_sweep_plan_clear(plan);
    vary("gap=10 cm:5 cm:-1 cm");
    ck_assert_int_eq(plan->axis[0].n, 6);
    ck_assert(plan->axis[0].value[5] == 0.05);
    thud_sweep_plan_clear(plan);
    vary("gap=10 cm:10.9 cm:0.5 cm");
    ck_assert_int_eq(plan->axis[0].n, 2);
}
END_TEST

START_TEST(what_cannot_be_varied)
{
    refused("gap", THUD_USAGE, "vary");
    refused("=3 cm", THUD_USAGE, "vary");
    refused("gap=", THUD_USAGE, "vary");
    refused("gap=5 cm:25 cm", THUD_USAGE, "gap");
    refused("gap=5 cm:25 cm:0 cm", THUD_USAGE, "gap");
    refused("gap=5 cm:25 cm:-1 cm", THUD_USAGE, "gap");
    refused("gap=5 cm:25 cm:1 furlong", THUD_USAGE, "gap");
    refused("gap=5 cm:25 cm:1 cm:2 cm", THUD_USAGE, "gap");
    refused("gap=5 cm:6 t:1 cm", THUD_INPUT, "gap"); /* and not for the number of values that it would make */
    ck_assert_ptr_nonnull(strstr(error.what, "\"6 t\" is a mass"));
    refused("gap=5:6 cm:1", THUD_INPUT, "gap");
    refused("gap=5 cm,,6 cm", THUD_USAGE, "gap");
    refused("gap=1 cm:1 km:1 nm", THUD_USAGE, "gap");
    ck_assert_int_eq(thud_sweep_vary(plan, "gap=5,6", &error), THUD_INPUT);
    ck_assert_int_eq(thud_sweep_vary(plan, "gap=5 kg", &error), THUD_INPUT);
    ck_assert_int_eq(thud_sweep_vary(plan, "nonsense=5 cm", &error), THUD_INPUT);
    refused("record.file=a.csv", THUD_USAGE, "record.file");
    refused("analysis.tolerance=1e-6", THUD_USAGE, "analysis.tolerance");
    ck_assert_int_eq(plan->naxes, 0);
    vary("gap=5 cm");
    refused("gap=6 cm", THUD_USAGE, "gap");
    ck_assert_int_eq(plan->naxes, 1);
}
END_TEST

/* A period gives the stiffness of the storeys: both cannot be varied, whichever is named first. */
START_TEST(what_a_period_determines_is_not_varied)
{
    static const char *const keys[] = {"structures.1.stiffness=500 MN/m,700 MN/m", "structures.1.period=0.5 s,0.8 s"};
    struct thud_scene *at = malloc(sizeof *at);
    for (int first = 0; first < 2; first++) {
        vary(keys[first]);
        vary(keys[!first]);
        ck_assert_int_eq(thud_sweep_scene(plan, 0, at, &error), THUD_INPUT);
        ck_assert_str_eq(error.key, "structures.1.stiffness");
        thud_sweep_plan_clear(plan);
    }
    free(at);
}
END_TEST

START_TEST(cases_by_name)
{
    ck_assert_int_eq(thud_sweep_cases(plan, "none, cavity", &error), THUD_OK);
    ck_assert_int_eq(plan->ncases, 2);
    ck_assert_int_eq(plan->cases[1], THUD_CASE_CAVITY);
    ck_assert_int_eq(thud_sweep_cases(plan, "none,nothing", &error), THUD_USAGE);
    ck_assert_int_eq(thud_sweep_cases(plan, "none,none", &error), THUD_USAGE);
    ck_assert_int_eq(thud_sweep_cases(plan, "", &error), THUD_USAGE);
}
END_TEST

START_TEST(points_are_numbered_with_structures_outside)
{
    records[1] = motion;
    plan->nrecords = 2;
    vary("gap=5 cm,10 cm,15 cm");
    vary("structures.1.stiffness=500 MN/m,600 MN/m");
    ck_assert_int_eq(thud_sweep_points(plan), 12);
    ck_assert_int_eq(thud_sweep_points_per_group(plan), 3);
    ck_assert_str_eq(plan->axis[0].key, "structures.1.stiffness");
    int at[THUD_VARY_MAX];
    ck_assert_int_eq(thud_sweep_place(plan, 6 + 3 + 2, at), 1);
    ck_assert_int_eq(at[0], 1);
    ck_assert_int_eq(at[1], 2);
    struct thud_scene *out = malloc(sizeof *out);
    ck_assert_int_eq(thud_sweep_scene(plan, 6 + 2, out, &error), THUD_OK);
    ck_assert(out->structure[0].stiffness_npm[3] == 500e6);
    ck_assert(out->structure[1].stiffness_npm[3] == 600e6);
    ck_assert(out->interface[0].gap_m == 0.15);
    free(out);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("sweep plan");
    TCase *tcase = tcase_create("plan");
    tcase_add_checked_fixture(tcase, set_up, study_tear_down);
    tcase_add_test(tcase, ranges_and_lists);
    tcase_add_test(tcase, units_of_ranges);
    tcase_add_test(tcase, a_ratio_and_per_cent_are_of_one_kind);
    tcase_add_test(tcase, what_cannot_be_varied);
    tcase_add_test(tcase, what_a_period_determines_is_not_varied);
    tcase_add_test(tcase, cases_by_name);
    tcase_add_test(tcase, points_are_numbered_with_structures_outside);
    suite_add_tcase(suite, tcase);
    return suite;
}
