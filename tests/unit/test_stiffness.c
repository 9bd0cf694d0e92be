/* Estimates of a contact's stiffness by hand, and what the results do with it where that is known: two free bodies. */
#include <check.h>
#include <math.h>

#include "study/scene/stiffness.h"

static struct thud_scene scene, changed;

START_TEST(estimates_by_hand)
{
    /* 12 m x 0.25 m of concrete, 30 GPa, 15 m long: 6 GN/m; against half of it 2 GN/m */
    ck_assert_double_eq_tol(thud_stiffness_slab(3, 15, 30e9), 6e9, 1);
    ck_assert_double_eq_tol(thud_stiffness_series(6e9, 3e9), 2e9, 1);
    ck_assert_double_eq_tol(thud_stiffness_series(6e9, 6e9), 3e9, 1);
    /* force of a bumper at a strain of 1 is alpha A K_r */
    double k = thud_stiffness_rubber(2.5, 0.5, 5e6, 0.05, 2.65);
    ck_assert_double_eq_tol(k * pow(0.05, 2.65), 6.25e6, 1);
}
END_TEST

static void two_bodies(const char *law)
{
    struct thud_error err;
    thud_scene_init(&scene);
    scene.nstructures = 2;
    for (int s = 0; s < 2; s++) {
        thud_structure_init(&scene.structure[s], THUD_RIGID);
        scene.structure[s].mass_kg[0] = 320e3;
    }
    scene.structure[0].velocity_mps = 0.5;
    thud_interface_init(&scene.interface[0]);
    scene.interface[0].gap_m = 0;
    ck_assert_int_eq(thud_scene_set(&scene, "contact.law", law, &err), THUD_OK);
    scene.analysis.tail_s = 0.2;
}

START_TEST(force_goes_with_the_root_of_a_linear_stiffness)
{
    struct thud_stiffness_row row[THUD_STIFFNESS_ROWS];
    struct thud_error err;
    int n;
    two_bodies("linear");
    ck_assert_int_eq(thud_stiffness_rows(&scene, NULL, THUD_STIFFNESS_CONTACT, row, &n, &err), THUD_OK);
    ck_assert_int_eq(n, 3);
    for (int i = 0; i < 3; i++) { /* F = v sqrt(k m) */
        double k = row[i].factor * 2500e6;
        ck_assert_double_eq_tol(row[i].force_n, 0.5 * sqrt(k * 160e3), 1e-6 * row[i].force_n);
        ck_assert_double_eq_tol(row[i].acceleration_mps2[1], row[i].force_n / 320e3, 1e-6 * row[i].force_n);
        ck_assert_int_eq(row[i].impacts, 1);
    }
    ck_assert(row[0].factor == 0.5 && row[1].factor == 1 && row[2].factor == 2);
    ck_assert_int_eq(thud_stiffness_rows(&scene, NULL, THUD_STIFFNESS_BUMPER, row, &n, &err), THUD_OK);
    ck_assert_int_eq(n, 0);
}
END_TEST

START_TEST(what_stands_for_the_stiffness_is_varied)
{
    struct thud_error err;
    two_bodies("none");
    ck_assert(!thud_stiffness_scale(&scene, THUD_STIFFNESS_CONTACT, 2));
    two_bodies("hertz");
    changed = scene;
    ck_assert(thud_stiffness_scale(&changed, THUD_STIFFNESS_CONTACT, 2));
    ck_assert(changed.interface[0].contact.value[0] == 2 * scene.interface[0].contact.value[0]);
    scene.interface[0].gap_m = 0.1;
    thud_interface_add_bumper(&scene.interface[0]);
    ck_assert_int_eq(thud_scene_set(&scene, "bumper.stiffness", "", &err), THUD_OK);
    ck_assert_int_eq(thud_scene_set(&scene, "bumper.alpha", "2", &err), THUD_OK);
    ck_assert_int_eq(thud_scene_set(&scene, "bumper.area", "0.5 m2", &err), THUD_OK);
    ck_assert_int_eq(thud_scene_set(&scene, "bumper.material-stiffness", "5 MPa", &err), THUD_OK);
    changed = scene;
    ck_assert(thud_stiffness_scale(&changed, THUD_STIFFNESS_BUMPER, 0.5));
    int modulus = thud_law_param(scene.interface[0].bumper.law, "material-stiffness");
    ck_assert(changed.interface[0].bumper.value[modulus] == 2.5e6);
    ck_assert(isnan(changed.interface[0].bumper.value[0]));
    ck_assert(!thud_stiffness_scale(&changed, THUD_STIFFNESS_LINK, 2));
    changed.nlinks = 1;
    changed.link[0] = (struct thud_link){.stiffness_npm = 3, .damping_nspm = 5, .slip_n = 7};
    ck_assert(thud_stiffness_scale(&changed, THUD_STIFFNESS_LINK, 2));
    ck_assert(changed.link[0].stiffness_npm == 6 && changed.link[0].damping_nspm == 10 && changed.link[0].slip_n == 14);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("stiffness");
    TCase *tcase = tcase_create("stiffness");
    tcase_add_test(tcase, estimates_by_hand);
    tcase_add_test(tcase, force_goes_with_the_root_of_a_linear_stiffness);
    tcase_add_test(tcase, what_stands_for_the_stiffness_is_varied);
    suite_add_tcase(suite, tcase);
    return suite;
}
