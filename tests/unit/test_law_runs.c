/* A run of two rigid bodies that meet parts them with the restitution the law says two free bodies part with: run and
 * law know nothing of each other's way there. */
#include <check.h>
#include <math.h>

#include "base/quantity.h"
#include "core/run/run.h"
#include "law_examples.h"
#include "march.h"

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

/* A contact lasts while it pushes. Two free bodies by F = k d + c v, cut at 0 or not: until
 * t = 2 acos(xi)/(omega sqrt(1 - xi^2)), where F is 0; the classical law pulls on until pi/(omega sqrt(1 - xi^2)). */
START_TEST(time_in_contact)
{
    static const struct {
        const char *name, *method;
        double step_s, tolerance, within;
    } all[] = {{"kelvin-voigt", "exact", 0, 0, 1e-9},
               {"kelvin-voigt-no-tension", "exact", 0, 0, 1e-9},
               {"kelvin-voigt", "dormand-prince", 0, 1e-9, 1e-6},
               {"kelvin-voigt-no-tension", "dormand-prince", 0, 1e-9, 1e-6},
               {"kelvin-voigt", "rk4", 1e-4, 0, 1e-4},
               {"kelvin-voigt", "lagged", 1e-5, 0, 2e-3}};
    struct march_law law = march_law(all[_i].name, "stiffness", 2.5e9, "restitution", 0.3, NULL);
    struct thud_model *model = march_two_bodies(320e3, 250e3, 0.5, 0.001, &law);
    double mass = 320e3 * 250e3 / 570e3, xi = -log(0.3) / sqrt(THUD_PI * THUD_PI + log(0.3) * log(0.3));
    struct march m = march_run(model, NULL, all[_i].method, all[_i].step_s, all[_i].tolerance, true, 0.5);
    ck_assert_int_eq(m.status, THUD_OK);
    ck_assert_int_eq(m.result->contact[0].impacts, 1);
    ck_assert_double_eq_tol(m.result->contact[0].contact_time_s * sqrt(2.5e9 / mass) * sqrt(1 - xi * xi) /
                                (2 * acos(xi)),
                            1, all[_i].within);
    march_free(&m);
    thud_model_free(model);
}
END_TEST

/* Two bodies that touch and go on together but for rounding, which each method has another share of: what their
 * contact passes on counts neither as an impact nor as time in contact. A thousand times faster it does. */
START_TEST(touches_without_force_take_no_time)
{
    const bool counts = _i >= 2;
    double mass = 320e3;
    struct march_law law = march_law("linear", "stiffness", 2.5e9, NULL);
    struct thud_structure_input bodies[2] = {
        {.n = 1, .mass_kg = &mass, .velocity_mps = 0.5 * (1 + (counts ? 2e-9 : 2e-12))},
        {.n = 1, .mass_kg = &mass, .velocity_mps = 0.5}};
    struct thud_contact_input contact = {
        .interface = 1, .left_floor = 1, .right_floor = 1, .right_structure = 1, .law = law.law, .setup = law.setup};
    struct thud_model_input input = {.nstructures = 2, .structure = bodies, .ncontacts = 1, .contact = &contact};
    struct thud_model *model;
    ck_assert_int_eq(thud_model_create(&input, &model, NULL), THUD_OK);
    struct march m = march_run(model, NULL, _i % 2 ? "dormand-prince" : "exact", 0, 1e-9, true, 0.5);
    ck_assert_int_eq(m.status, THUD_OK);
    const struct thud_contact_result *p = &m.result->contact[0];
    ck_assert_double_gt(p->impulse_ns, 0);
    ck_assert_int_eq(p->impacts, counts);
    ck_assert_double_eq_tol(p->contact_time_s, counts ? THUD_PI / sqrt(2.5e9 / (mass / 2)) : 0, 1e-5);
    march_free(&m);
    thud_model_free(model);
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
    tcase_add_loop_test(tests, time_in_contact, 0, 6);
    tcase_add_loop_test(tests, touches_without_force_take_no_time, 0, 4);
    suite_add_tcase(suite, tests);
    return suite;
}
