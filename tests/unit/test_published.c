/* Published numbers that need no ground motion hold; and each number can fail. */
#include <check.h>
#include <math.h>
#include <stdlib.h>

#include "io/preset/preset.h"
#include "io/record/record_file.h"
#include "study/methods/published.h"

static struct thud_published_row row[THUD_PUBLISHED_ROWS_MAX];

static int compute(enum thud_published which, const struct thud_scene *scene, const struct thud_record *record)
{
    struct thud_error err;
    int n = 0;
    ck_assert_int_eq(thud_published_compute(which, scene, record, row, &n, &err), THUD_OK);
    return n;
}

START_TEST(two_oscillators_are_one_before_a_wall)
{
    ck_assert_int_eq(compute(THUD_PUBLISHED_TWO_OSCILLATORS, NULL, NULL), 2);
    for (int i = 0; i < 2; i++)
        ck_assert(row[i].holds && row[i].published == 0 && fabs(row[i].difference) < 1e-9);
}
END_TEST

START_TEST(laws_and_a_cart)
{
    ck_assert_int_eq(compute(THUD_PUBLISHED_LANKARANI, NULL, NULL), 1);
    ck_assert(row[0].holds);
    /* s = 3 (1 - 0.09)/4 = 0.6825, and e solves s (1 + e) = ln((1 + s)/(1 - s e)): by bisection elsewhere 0.684226 */
    ck_assert_double_eq_tol(row[0].computed, 0.684226, 2e-6);
    ck_assert_int_eq(compute(THUD_PUBLISHED_CART, NULL, NULL), 1);
    ck_assert(row[0].holds);
    /* F of the cut law: k = m omega^2, and the largest of k d + c v on the damped sine, as printed 5.41 at e 0.872 */
    ck_assert_double_eq_tol(row[0].computed, 5.41, 0.02);
}
END_TEST

START_TEST(a_falling_mass)
{
    struct thud_preset *preset;
    struct thud_record *record;
    struct thud_scene scene;
    struct thud_error err;
    int n;
    ck_assert_int_eq(thud_preset_read("presets/published/ansys-vm65.yaml", &preset, &err), THUD_OK);
    scene = *thud_preset_scene(preset);
    ck_assert_int_eq(thud_record_file_read("presets/published/constant-386.csv", &scene.record, &record, &err),
                     THUD_OK);
    ck_assert_int_eq(compute(THUD_PUBLISHED_VM65, &scene, record), 3);
    double g = 386 * 0.0254, w = sqrt(345686 / 87.5634), v = sqrt(2 * g * 0.0254);
    /* by hand: v = sqrt(2 g h), then m u'' + k u = m g from the touch on */
    double drop = 0.0254 + g / (w * w) + hypot(g / (w * w), v / w);
    ck_assert_double_eq_tol(row[0].computed, sqrt(2 * 0.0254 / g), 1e-5);
    ck_assert_double_eq_tol(row[1].computed, v / 0.0254, 1e-3);
    ck_assert_double_eq_tol(row[2].computed, drop / 0.0254, 1e-5);
    for (int i = 0; i < 3; i++)
        ck_assert(row[i].holds);
    scene.interface[0].gap_m *= 1.02;
    compute(THUD_PUBLISHED_VM65, &scene, record);
    for (int i = 0; i < 3; i++)
        ck_assert(!row[i].holds);
    scene.interface[0].gap_m = 1; /* never touches: no time of touch */
    compute(THUD_PUBLISHED_VM65, &scene, record);
    ck_assert(isnan(row[0].computed) && !row[0].holds);
    ck_assert_int_eq(thud_published_compute(THUD_PUBLISHED_CHOPRA, &scene, record, row, &n, &err), THUD_INPUT);
    ck_assert_int_eq(thud_published_compute(THUD_PUBLISHED_NPTEL, NULL, NULL, row, &n, &err), THUD_INPUT);
    ck_assert_int_eq(thud_published_compute(THUD_PUBLISHED_VM65, NULL, NULL, row, &n, &err), THUD_INPUT);
    thud_record_free(record);
    thud_preset_free(preset);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("published");
    TCase *tcase = tcase_create("published");
    tcase_add_test(tcase, two_oscillators_are_one_before_a_wall);
    tcase_add_test(tcase, laws_and_a_cart);
    tcase_add_test(tcase, a_falling_mass);
    suite_add_tcase(suite, tcase);
    return suite;
}
