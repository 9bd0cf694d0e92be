/* Restitutions and other closed forms of the laws against the relations they solve, published figures, limits and
 * order. */
#include <check.h>
#include <math.h>

#include "base/quantity.h"
#include "closed_form.h"
#include "core/laws/law.h"
#include "core/laws/law_closed_form.h"

/* Restitution that two free bodies with m = 160 t part with, a choice (may be NULL) and e given. */
static double part(const char *name, const char *choice, int index, double e, double v)
{
    const struct thud_law *law = thud_law_find(name);
    struct thud_law_setup setup = {.mass_kg = 160e3, .thickness_m = 0.05};
    thud_law_defaults(law, &setup);
    if (law == thud_law_find("rubber"))
        setup.value[thud_law_param(law, "stiffness")] = 0.36e3 * pow(1000, 2.65);
    if (choice)
        setup.value[thud_law_param(law, choice)] = index;
    setup.value[thud_law_param(law, "restitution")] = e;
    ck_assert_int_eq(thud_law_prepare(law, &setup, NULL), THUD_OK);
    ck_assert_double_eq(thud_law_nominal(law, &setup), e);
    return thud_law_restitution(law, &setup, v);
}

/* What bodies part with when e is asked for. */
START_TEST(what_each_named_e_gives)
{
    static const double table[][6] = {{0.3, 0.3971, 0.5813, 0.6842, 0.2562, 0.2917},
                                      {0.5, 0.5503, 0.6630, 0.7252, 0.4704, 0.4946},
                                      {0.6, 0.6323, 0.7120, 0.7561, 0.5773, 0.5962},
                                      {0.8, 0.8081, 0.8329, 0.8471, 0.7885, 0.7989}};
    for (int i = 0; i < 4; i++) {
        double e = table[i][0];
        ck_assert_double_eq_tol(part("kelvin-voigt-no-tension", NULL, 0, e, 1), table[i][1], 5.1e-5);
        ck_assert_double_eq_tol(part("hertz-damp", "formula", 1, e, 1), table[i][2], 5.1e-5);
        ck_assert_double_eq_tol(part("hertz-damp", "formula", 0, e, 1), table[i][3], 5.1e-5);
        ck_assert_double_eq_tol(part("hertz-damp", "formula", 2, e, 1), table[i][4], 5.1e-5);
        ck_assert_double_eq_tol(part("jankowski", NULL, 0, e, 1), table[i][5], 5.1e-5);
    }
    ck_assert_double_eq_tol(part("kelvin-voigt-no-tension", NULL, 0, 0.5, 1), 0.55028, 5.1e-6);
    ck_assert_double_eq_tol(part("kelvin-voigt-no-tension", NULL, 0, 0.6, 1), 0.63229, 5.1e-6);
    ck_assert_double_eq_tol(part("kelvin-voigt-no-tension", NULL, 0, 0.8, 1), 0.80810, 5.1e-6);
}
END_TEST

/* Eq. (7) drifts at low speed. */
START_TEST(rubber_drift)
{
    ck_assert_double_eq_tol(part("rubber", "unloading", 1, 0.5, 1), 0.5034, 5.1e-5);
    ck_assert_double_eq_tol(part("rubber", NULL, 0, 0.5, 0.5), 0.5095, 5.1e-5);
    ck_assert_double_eq_tol(part("rubber", NULL, 0, 0.5, 0.05), 0.530, 5.1e-4);
    ck_assert_double_eq_tol(part("rubber", NULL, 0, 0.5, 0.001), 0.563, 5.1e-4);
}
END_TEST

START_TEST(exact_values)
{
    ck_assert_double_eq_tol(thud_kelvin_voigt_cut_xi(0.5), 0.25528, 5.1e-6);
    ck_assert_double_eq_tol(thud_kelvin_voigt_cut_xi(0.6), 0.18086, 5.1e-6);
    ck_assert_double_eq_tol(thud_kelvin_voigt_cut_xi(0.8), 0.07436, 5.1e-6);
    ck_assert_double_eq_tol(thud_hertz_damp_s(0.5), 1.43275, 5.1e-6);
    ck_assert_double_eq_tol(thud_hertz_damp_s(0.6), 0.97487, 5.1e-6);
    ck_assert_double_eq_tol(thud_rubber_cv(0.5), 1.86011, 5.1e-6);
    ck_assert_double_eq_tol(thud_rubber_cv(0.6), 1.39261, 5.1e-6);
    ck_assert_double_eq_tol(thud_rubber_cv(0.8), 0.63675, 5.1e-6);
    ck_assert_double_eq_tol(2 * thud_kelvin_voigt_xi(0.6) * sqrt(2.5e9 * 160e3), 6.42e6, 5e3);
}
END_TEST

/* The relations themselves, written with long doubles. Where 1 - s e is small its logarithm feels the last bit of s. */
START_TEST(relations)
{
    for (int i = 4; i < 20; i++) {
        double e = 0.05 * i;
        long double s = thud_hertz_damp_s(e), x = thud_rubber_cv(e) * (long double)e, xi = thud_kelvin_voigt_cut_xi(e);
        ck_assert_ldouble_eq_tol(s * (1 + e), logl((1 + s) / (1 - s * e)), 1e-13L + 1e-15L / (1 - s * e));
        ck_assert_ldouble_eq_tol(-x - logl(1 - x), x * x / (2.0L * e * e), 1e-13L + 1e-15L / (1 - x));
        long double angle = xi < 1 ? acosl(xi) / sqrtl(1 - xi * xi) : acoshl(xi) / sqrtl(xi * xi - 1);
        ck_assert_ldouble_eq_tol(expl(-2 * xi * angle), e, 1e-13L);
        ck_assert_double_eq_tol(kelvin_voigt_restitution(thud_kelvin_voigt_xi(e)), e, 1e-14);
    }
}
END_TEST

static void check_round_trip(double e)
{
    ck_assert_double_eq_tol(thud_kelvin_voigt_cut_restitution(thud_kelvin_voigt_cut_xi(e)) / e, 1, 1e-13);
    ck_assert_double_eq_tol(thud_hertz_damp_restitution(thud_hertz_damp_s(e)) / e, 1, 1e-13);
    ck_assert_double_eq_tol(thud_rubber_restitution(thud_rubber_cv(e), 1) / e, 1, 1e-13);
    for (double n = 1; n < 6.1; n += 0.5)
        ck_assert_double_eq_tol(thud_jankowski_restitution(thud_jankowski_xi(e, n), n) / e, 1, 1e-13);
}

START_TEST(round_trips)
{
    for (double e = 1e-6; e < 1; e *= 1.3)
        check_round_trip(e);
    for (double less = 1e-16; less < 1; less *= 7)
        check_round_trip(1 - less);
    check_round_trip(1);
}
END_TEST

/* Nothing is lost at e = 1; near it s = (1 - e) 3/2 and C v = (1 - e) 3 to first order, xi = (1 - e)/pi. */
START_TEST(limits)
{
    double less = 1e-7, e = 1 - less;
    ck_assert_double_eq(thud_kelvin_voigt_cut_xi(1), 0);
    ck_assert_double_eq(thud_hertz_damp_s(1), 0);
    ck_assert_double_eq(thud_rubber_cv(1), 0);
    ck_assert_double_eq(thud_jankowski_xi(1, 1.5), 0);
    ck_assert_double_eq_tol(thud_kelvin_voigt_cut_xi(e) / less, 1 / THUD_PI, 1e-6);
    ck_assert_double_eq_tol(thud_hertz_damp_s(e) / less, 1.5, 1e-6);
    ck_assert_double_eq_tol(thud_rubber_cv(e) / less, 3, 1e-6);
    ck_assert_double_eq_tol(thud_jankowski_xi(e, 1) / less, 2 / THUD_PI, 1e-6);
    /* restitution is so slow in the limit of strong damping that the speed is the damping's own: e = 1/s */
    ck_assert_double_eq_tol(thud_hertz_damp_restitution(1e9) * 1e9, 1, 1e-12);
    ck_assert_double_eq_tol(thud_rubber_restitution(1e9, 1) * 1e9, 1, 1e-12);
    ck_assert_double_eq(thud_hertz_damp_restitution(0), 1);
    ck_assert_double_eq(thud_rubber_restitution(0, 0.25), 0.5);
    ck_assert_double_eq_tol(thud_rubber_restitution(1e-90, 0.25), 0.5, 1e-15);
}
END_TEST

START_TEST(critical_damping)
{
    ck_assert_double_eq_tol(thud_kelvin_voigt_cut_restitution(1), exp(-2), 1e-16);
    for (int sign = -1; sign <= 1; sign += 2) {
        double xi = 1 + sign * 1e-9;
        ck_assert_double_eq_tol(thud_kelvin_voigt_cut_restitution(xi), exp(-2), 1e-9);
        struct two_body_collision at = kelvin_voigt_cut_collision(2.5e9, 1, 160e3, 0.5),
                                  beside = kelvin_voigt_cut_collision(2.5e9, xi, 160e3, 0.5);
        ck_assert_double_eq_tol(beside.duration_s / at.duration_s, 1, 1e-8);
        ck_assert_double_eq_tol(beside.indentation_m / at.indentation_m, 1, 1e-8);
    }
    /* contact time */
    double xi = 0.25528, omega = 125;
    ck_assert_double_eq_tol(kelvin_voigt_cut_collision(2.5e9, xi, 160e3, 0.5).duration_s,
                            2 * acos(xi) / (omega * sqrt(1 - xi * xi)), 1e-15);
}
END_TEST

/* More damping, less restitution; a higher e asked for, a higher e obtained, at every speed. */
START_TEST(order)
{
    double last[4] = {2, 2, 2, 2};
    for (double a = 0; a < 50; a = a * 1.1 + 0.01) {
        double now[4] = {thud_kelvin_voigt_cut_restitution(a), thud_hertz_damp_restitution(a),
                         thud_rubber_restitution(a, 1), thud_jankowski_restitution(a, 1.5)};
        for (int i = 0; i < 4; i++) {
            ck_assert_double_gt(now[i], 0);
            ck_assert_double_lt(now[i], last[i]);
            last[i] = now[i];
        }
    }
    static const char *const names[] = {"kelvin-voigt", "kelvin-voigt-no-tension", "hertz-damp", "jankowski", "rubber"};
    for (int i = 0; i < 5; i++)
        for (double v = 1e-3; v < 3; v *= 4)
            for (double e = 0.02; e < 0.99; e += 0.02)
                ck_assert_double_lt(part(names[i], NULL, 0, e, v), part(names[i], NULL, 0, e + 0.01, v));
}
END_TEST

/* The bumper's curve: the figures of the paper's Table 1, energy by Simpson's rule, and back. */
START_TEST(rubber_curve)
{
    struct thud_rubber_curve curve = thud_rubber_curve(0.36e3 * pow(1000, 2.65), 2.65, 0.04, 2.5e9);
    ck_assert_double_eq_tol(curve.ultimate_force_n / 1e3, 6335, 0.5);
    ck_assert_double_eq_tol(curve.ultimate_energy_j / 1e3, 69.43, 0.005);
    ck_assert_double_eq_tol(sqrt(2 * curve.ultimate_energy_j / 160e3), 0.9316, 5e-5);
    double h = 1e-9, below = thud_rubber_curve_force(&curve, 0.04 - h),
           above = thud_rubber_curve_force(&curve, 0.04 + h);
    ck_assert_double_eq_tol((curve.ultimate_force_n - below) / h / 1e6, 419.7, 0.06);
    ck_assert_double_eq_tol((above - curve.ultimate_force_n) / h / 1e6, 2500, 0.01);
    enum { N = 3000 };
    double d = 0, step = 0.06 / N, energy = 0; /* the ultimate compression is at a whole step */
    for (int i = 0; i < N; i++, d += step) {
        energy += step / 6 *
                  (thud_rubber_curve_force(&curve, d) + 4 * thud_rubber_curve_force(&curve, d + step / 2) +
                   thud_rubber_curve_force(&curve, d + step));
        ck_assert_double_eq_tol(thud_rubber_curve_energy(&curve, d + step) / energy, 1, 1e-2 * pow(i + 1, -3) + 1e-9);
        ck_assert_double_eq_tol(thud_rubber_curve_indentation(&curve, energy) / (d + step), 1,
                                1e-2 * pow(i + 1, -3) + 1e-9);
    }
    ck_assert_double_eq(thud_rubber_curve_force(&curve, 0), 0);
    ck_assert_double_eq(thud_rubber_curve_energy(&curve, -1), 0);
    ck_assert_double_eq(thud_rubber_curve_indentation(&curve, 0), 0);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("law closed forms");
    TCase *tests = tcase_create("closed forms");
    tcase_set_timeout(tests, 0);
    tcase_add_test(tests, what_each_named_e_gives);
    tcase_add_test(tests, rubber_drift);
    tcase_add_test(tests, exact_values);
    tcase_add_test(tests, relations);
    tcase_add_test(tests, round_trips);
    tcase_add_test(tests, limits);
    tcase_add_test(tests, critical_damping);
    tcase_add_test(tests, order);
    tcase_add_test(tests, rubber_curve);
    suite_add_tcase(suite, tests);
    return suite;
}
