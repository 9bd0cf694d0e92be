/* A run of two rigid bodies that meet parts them with the restitution the law says two free bodies part with: run and
 * law know nothing of each other's way there. */
#include <check.h>
#include <math.h>

#include "core/run/run.h"
#include "law_examples.h"

static const double speeds[] = {0.002, 0.3, 1.3}; /* about the floor, usual, past the bumper's knee */

/* `choice` may be NULL. */
static void check(const char *name, const char *choice, int index, double e, double v)
{
    const struct thud_law *law = thud_law_find(name);
    double left = 320e3, right = 250e3;
    struct thud_structure_input bodies[2] = {{.n = 1, .mass_kg = &left, .velocity_mps = v},
                                             {.n = 1, .mass_kg = &right}};
    struct thud_contact_input contact = {.interface = 1,
                                         .left_floor = 1,
                                         .right_floor = 1,
                                         .right_structure = 1,
                                         .clearance_m = 0.01,
                                         .law = law,
                                         .setup = {.thickness_m = 0.05}};
    thud_law_defaults(law, &contact.setup);
    if (law == thud_law_find("rubber"))
        contact.setup.value[thud_law_param(law, "stiffness")] = 0.36e3 * pow(1000, 2.65);
    if (choice)
        contact.setup.value[thud_law_param(law, choice)] = index;
    if (thud_law_param(law, "restitution") >= 0)
        contact.setup.value[thud_law_param(law, "restitution")] = e;
    struct thud_model_input input = {.nstructures = 2, .structure = bodies, .ncontacts = 1, .contact = &contact};
    struct thud_model *model;
    struct thud_run *run;
    struct thud_run_options options;
    ck_assert_int_eq(thud_model_create(&input, &model, NULL), THUD_OK);
    thud_run_options_init(&options);
    options.tail_s = fmax(2, 0.1 / v);
    ck_assert_int_eq(thud_run_create(model, NULL, &options, &run, NULL), THUD_OK);
    for (bool done = false; !done;)
        ck_assert_int_eq(thud_run_advance(run, 1000, &done, NULL), THUD_OK);
    const struct thud_contact_result *result = &thud_run_result(run)->contact[0];
    double parted = result->separation_mps / result->approach_mps;
    double expected = thud_law_restitution(law, &model->contact[0].setup, result->approach_mps);
    ck_assert_int_eq(result->impacts, 1);
    ck_assert_double_eq_tol(result->approach_mps / v, 1, 1e-12);
    ck_assert_double_eq_tol(parted, expected, 1e-7);
    double mass = left * right / (left + right), energy = 0.5 * mass * v * v;
    ck_assert_double_eq_tol(result->dissipated_j / energy, 1 - expected * expected, 1e-6);
    ck_assert_double_eq_tol(result->impulse_ns / (mass * v * (1 + expected)), 1, 1e-6);
    thud_run_free(run);
    thud_model_free(model);
}

START_TEST(as_the_law_says)
{
    static const double es[] = {0.05, 0.3, 0.6, 0.95, 1};
    for (int i = 0; i < 3 * 5; i++)
        for (int j = 0; j < thud_law_count(); j++)
            if (!(thud_law_at(j)->flags & THUD_LAW_NO_FORCE))
                check(thud_law_at(j)->name, NULL, 0, es[i / 3], speeds[i % 3]);
}
END_TEST

START_TEST(with_other_choices)
{
    static const double es[] = {0.05, 0.5, 0.95};
    for (int i = 0; i < 9; i++) {
        double e = es[i / 3], v = speeds[i % 3];
        check("kelvin-voigt-no-tension", "damping", 1, e, v);
        check("jankowski", "damping", 1, e, v);
        for (int formula = 1; formula < 4; formula++)
            check("hertz-damp", "formula", formula, e, v);
        check("rubber", "damping", 1, e, v);
        check("rubber", "unloading", 1, e, v);
        check("rubber", "impact-speed", 1, e, v);
    }
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("law runs");
    TCase *tests = tcase_create("runs");
    tcase_set_timeout(tests, 0);
    tcase_add_test(tests, as_the_law_says);
    tcase_add_test(tests, with_other_choices);
    suite_add_tcase(suite, tests);
    return suite;
}
