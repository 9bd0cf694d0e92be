/* When an impact counts: by its impulse, by one rule for every method. */
#include <check.h>
#include <math.h>

#include "march.h"

/* Four storeys beside a wall, clearance 0, at rest: touches of rounding when the ground begins to move. `mirrored`: the
 * wall to the right, and the motion reversed. */
static struct march beside_a_wall(const char *law_name, const char *method, double tolerance, bool mirrored,
                                  struct thud_model **model)
{
    static const double mass[] = {320e3, 320e3, 320e3, 250e3}, stiffness[] = {6e8, 6e8, 6e8, 6e8};
    struct march_law law = march_law(law_name, "stiffness", 2.5e9, "restitution", 0.6, NULL);
    struct thud_structure_input building = {.n = 4, .mass_kg = mass, .stiffness_npm = stiffness, .damping = 0.05};
    struct thud_structure_input s[2] = {0};
    struct thud_contact_input c[4];
    s[mirrored ? 0 : 1] = building;
    for (int i = 0; i < 4; i++)
        c[i] = (struct thud_contact_input){.interface = 1,
                                           .left_floor = mirrored ? i + 1 : 0,
                                           .right_floor = mirrored ? 0 : i + 1,
                                           .left_structure = 0,
                                           .right_structure = 1,
                                           .law = law.law,
                                           .setup = law.setup};
    ck_assert_int_eq(
        thud_model_create(&(struct thud_model_input){.nstructures = 2, .structure = s, .ncontacts = 4, .contact = c},
                          model, NULL),
        THUD_OK);
    struct thud_record *record = march_motion(mirrored ? -1 : 1);
    struct march run = march_run(*model, record, method, 0, tolerance, true, 1);
    thud_record_free(record);
    return run;
}

START_TEST(the_same_by_every_method_and_in_the_mirror)
{
    static const char *const laws[] = {"jankowski", "hertz-damp", "kelvin-voigt-no-tension"};
    struct thud_model *model[3];
    struct march a = beside_a_wall(laws[_i], "exact", 1e-9, false, &model[0]),
                 b = beside_a_wall(laws[_i], "exact", 1e-9, true, &model[1]),
                 c = beside_a_wall(laws[_i], "dormand-prince", 1e-9, false, &model[2]);
    ck_assert_int_eq(a.status, THUD_OK);
    ck_assert_int_eq(b.status, THUD_OK);
    ck_assert_int_eq(c.status, THUD_OK);
    for (int i = 0; i < 4; i++) {
        ck_assert_int_gt(a.result->contact[i].impacts, 5);
        ck_assert_int_eq(a.result->contact[i].impacts, b.result->contact[i].impacts);
        ck_assert_int_eq(a.result->contact[i].impacts, c.result->contact[i].impacts);
    }
    march_free(&a);
    march_free(&b);
    march_free(&c);
    for (int i = 0; i < 3; i++)
        thud_model_free(model[i]);
}
END_TEST

/* Five equal bodies in a row that touch, struck by the first: the inner ones begin without an approach velocity of
 * their own, so that the ratio of speeds is none. */
static void row_of_five(const char *law_name, double restitution, struct thud_contact_result out[4])
{
    static const double mass = 1e5;
    struct march_law law =
        restitution >= 0 ? march_law(law_name, "restitution", restitution, NULL) : march_law(law_name, NULL);
    struct thud_structure_input s[5];
    struct thud_contact_input c[4];
    struct thud_model *model;
    for (int i = 0; i < 5; i++)
        s[i] = (struct thud_structure_input){.n = 1, .mass_kg = &mass, .velocity_mps = i == 0};
    for (int i = 0; i < 4; i++)
        c[i] = (struct thud_contact_input){.interface = i + 1,
                                           .left_floor = 1,
                                           .right_floor = 1,
                                           .left_structure = i,
                                           .right_structure = i + 1,
                                           .law = law.law,
                                           .setup = law.setup};
    ck_assert_int_eq(
        thud_model_create(&(struct thud_model_input){.nstructures = 5, .structure = s, .ncontacts = 4, .contact = c},
                          &model, NULL),
        THUD_OK);
    struct march m = march_run(model, NULL, "exact", 0, 0, true, 1);
    ck_assert_int_eq(m.status, THUD_OK);
    for (int i = 0; i < 4; i++)
        out[i] = m.result->contact[i];
    march_free(&m);
    thud_model_free(model);
}

START_TEST(no_restitution_without_a_closing_speed)
{
    struct thud_contact_result c[4];
    row_of_five("hertz", -1, c);
    for (int i = 0; i < 4; i++) {
        ck_assert_int_gt(c[i].impacts, 0);
        ck_assert_double_gt(c[i].impulse_ns, 0.9e5);
        ck_assert(isnan(c[i].restitution) || (c[i].restitution >= 0 && c[i].restitution < 10));
    }
    ck_assert(isnan(c[2].restitution));
}
END_TEST

/* A plastic blow: the restitution is there, and 0. What passes the blow on has its impulse. */
START_TEST(plastic_blow)
{
    struct thud_contact_result c[4];
    row_of_five("stereomechanical", 0, c);
    ck_assert_int_eq(c[0].impacts, 1);
    ck_assert_double_eq_tol(c[0].restitution, 0, 1e-12);
    for (int i = 0; i < 4; i++)
        ck_assert_double_eq_tol(c[i].impulse_ns, 1e5 * (1 - (i + 1) / 5.0), 1e-6);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("impact count");
    TCase *tcase = tcase_create("impact count");
    tcase_set_timeout(tcase, 60);
    tcase_add_loop_test(tcase, the_same_by_every_method_and_in_the_mirror, 0, 3);
    tcase_add_test(tcase, no_restitution_without_a_closing_speed);
    tcase_add_test(tcase, plastic_blow);
    suite_add_tcase(suite, tcase);
    return suite;
}
