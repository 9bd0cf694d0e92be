/* Every stepping method has the order it claims, from both sides: in smooth motion, in contact that never opens, and
 * through impacts where they are located; and not where they are not. */
#include <check.h>
#include <math.h>
#include <string.h>

#include "march.h"

static const char *const fixed[] = {"central-difference", "newmark", "newmark-linear", "hht", "generalized-alpha",
                                    "kr-alpha",           "rk4"};
enum { FIXED = sizeof fixed / sizeof *fixed, LOCATING = 6 };
static const char *const locating[LOCATING] = {"central-difference", "newmark", "newmark-linear", "hht",
                                               "generalized-alpha",  "rk4"};

static struct march march(const struct thud_model *model, const struct thud_record *record, const char *method,
                          double step, bool locate, double tail)
{
    struct march m = march_run(model, record, method, step, 1e-11, locate, tail);
    ck_assert_msg(m.status == THUD_OK, "%s: %s", method, m.err.what);
    return m;
}

/* Order seen between steps h and h/2^halvings, against `exact`. */
static double order_seen(const struct thud_model *model, const struct thud_record *record, const char *method, double h,
                         int halvings, bool locate, double tail)
{
    struct march want = march(model, record, "exact", 0, true, tail);
    struct march coarse = march(model, record, method, h, locate, tail);
    struct march fine = march(model, record, method, h / (1 << halvings), locate, tail);
    double order = log2(march_distance(&coarse, &want) / march_distance(&fine, &want)) / halvings;
    march_free(&want);
    march_free(&coarse);
    march_free(&fine);
    return order;
}

static void check_order(const char *method, double order, double least, double most)
{
    ck_assert_msg(order >= least && order <= most, "%s: order %.3f, not in %.2f to %.2f", method, order, least, most);
}

static void smooth(bool isolated)
{
    const int storeys[] = {4};
    struct march_law none = march_law("none", NULL);
    struct thud_model *model = march_row(1, storeys, isolated, 0.1, &none);
    struct thud_record *record = march_motion(1);
    for (int i = 0; i < FIXED; i++) {
        double order = thud_method_find(fixed[i])->order;
        double h = order > 2 ? 0.02 / 4 : 0.02 / 16; /* the fourth order reaches rounding soon */
        check_order(fixed[i], order_seen(model, record, fixed[i], h, order > 2 ? 2 : 3, true, 1), order - 0.1,
                    order + 0.3);
    }
    thud_record_free(record);
    thud_model_free(model);
}

START_TEST(shaken_building)
{
    smooth(false);
}
END_TEST

START_TEST(shaken_isolated_building_whose_damping_couples_modes)
{
    smooth(true);
}
END_TEST

/* A mass pressed against a softer wall by 5 cm from the start: u = u0 (1 - cos omega t), never out of contact. */
START_TEST(contact_that_never_opens)
{
    struct march_law law = march_law("linear", "stiffness", 300.0, NULL);
    struct thud_model *model = march_mass_and_wall(1, 30, 0, 0, -0.05, &law);
    const double u0 = -0.05 * 300 / 1200, omega = sqrt(1200), end = 1.7;
    struct march want = march(model, NULL, "exact", 0, true, end);
    ck_assert_double_eq_tol(march_displacement(&want, 0), u0 * (1 - cos(omega * end)), 1e-13);
    march_free(&want);
    for (int i = 0; i < FIXED; i++) {
        double order = thud_method_find(fixed[i])->order;
        check_order(fixed[i], order_seen(model, NULL, fixed[i], end / 400, 2, true, end), order - 0.1, order + 0.1);
    }
    thud_model_free(model);
}
END_TEST

/* A mass on a spring between bounces at a stiffer wall, 20 impacts. */
static struct thud_model *bouncing(const char *name)
{
    struct march_law law =
        strcmp(name, "hertz") == 0 ? march_law(name, "stiffness", 2e5, NULL) : march_law(name, "stiffness", 1e4, NULL);
    return march_mass_and_wall(1, 10, 0.01, 1, 0.02, &law);
}

/* The fourth order is seen over larger steps: at 3e-5 s its error is rounding. There amplitudes, whose error is of the fifth
 * order, still count. */
START_TEST(through_impacts_at_a_linear_wall)
{
    struct thud_model *model = bouncing("linear");
    for (int i = 0; i < LOCATING; i++) {
        const double order = thud_method_find(locating[i])->order, h = order > 2 ? 2e-3 : 5e-4;
        check_order(locating[i], order_seen(model, NULL, locating[i], h, 4, true, 6.3), order - 0.15,
                    order > 2 ? 5 : order + 0.3);
    }
    thud_model_free(model);
}
END_TEST

/* Hertz's force begins as d^1.5, which costs the step that begins there an error of order 2.5 in the velocity: the
 * fourth order is lost, the second not. */
START_TEST(through_impacts_at_a_hertz_wall)
{
    struct thud_model *model = bouncing("hertz");
    for (int i = 0; i < LOCATING; i++) {
        double order = order_seen(model, NULL, locating[i], 5e-4, 4, true, 6.3);
        check_order(locating[i], order, thud_method_find(locating[i])->order > 2 ? 2.1 : 1.8, 3.0);
    }
    thud_model_free(model);
}
END_TEST

/* Over 2^8 in the step, so that the noise of where in a step the impacts happen to fall counts for little. Viscous
 * contact begins with a jump of the force. */
START_TEST(first_order_where_nothing_is_located)
{
    struct march_law law = march_law("kelvin-voigt-no-tension", "stiffness", 1e4, "restitution", 0.8, NULL);
    struct thud_model *model = march_mass_and_wall(1, 10, 0.0, 1, 0.02, &law);
    for (int i = 0; i < LOCATING; i++)
        check_order(locating[i], order_seen(model, NULL, locating[i], 1e-3, 8, false, 2.5), 0.6, 1.45);
    thud_model_free(model);
}
END_TEST

/* How much locating gains at the same step. */
START_TEST(locating_gains_decades_with_rk4)
{
    struct thud_model *model = bouncing("linear");
    struct march want = march(model, NULL, "exact", 0, true, 6.3);
    const double step[] = {2.5e-3, 6e-4, 1e-4}, least_gain[] = {10, 100, 1e4}, most_error[] = {1e-2, 5e-5, 5e-8};
    for (int i = 0; i < 3; i++) {
        struct march located = march(model, NULL, "rk4", step[i], true, 6.3);
        struct march naive = march(model, NULL, "rk4", step[i], false, 6.3);
        double a = march_distance(&located, &want), b = march_distance(&naive, &want);
        ck_assert_msg(a < most_error[i] && b > least_gain[i] * a, "step %g: located %.2e, not %.2e", step[i], a, b);
        march_free(&located);
        march_free(&naive);
    }
    march_free(&want);
    thud_model_free(model);
}
END_TEST

/* The adaptive method's error goes down with its tolerance and stays below a fixed multiple of it. */
START_TEST(dormand_prince_follows_its_tolerance)
{
    struct thud_model *model = bouncing("linear");
    struct march want = march_run(model, NULL, "exact", 0, 1e-12, true, 6.3);
    double before = INFINITY;
    for (double tolerance = 1e-4; tolerance > 0.5e-9; tolerance /= 10) {
        struct march m = march_run(model, NULL, "dormand-prince", 0, tolerance, true, 6.3);
        ck_assert_int_eq(m.status, THUD_OK);
        double error = march_distance(&m, &want);
        ck_assert_msg(error < 30 * tolerance && error < before, "tolerance %g: %.2e", tolerance, error);
        before = error;
        march_free(&m);
    }
    march_free(&want);
    thud_model_free(model);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("method orders");
    TCase *tcase = tcase_create("orders");
    tcase_set_timeout(tcase, 120);
    tcase_add_test(tcase, shaken_building);
    tcase_add_test(tcase, shaken_isolated_building_whose_damping_couples_modes);
    tcase_add_test(tcase, contact_that_never_opens);
    tcase_add_test(tcase, through_impacts_at_a_linear_wall);
    tcase_add_test(tcase, through_impacts_at_a_hertz_wall);
    tcase_add_test(tcase, first_order_where_nothing_is_located);
    tcase_add_test(tcase, locating_gains_decades_with_rk4);
    tcase_add_test(tcase, dormand_prince_follows_its_tolerance);
    suite_add_tcase(suite, tcase);
    return suite;
}
