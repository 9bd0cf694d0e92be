/* Collisions under the laws of springs and dashpots, integrated from the printed equations, against the laws and their
 * closed forms. */
#include "base/quantity.h"
#include "closed_form.h"
#include "collision.h"
#include "core/laws/law_closed_form.h"

START_TEST(concrete_figures)
{
    static const struct figure figures[] = {{0.5, 8379.6, 3.1807, 22.850, 0.63229, 0.8118},
                                            {1.0, 16759.2, 6.3613, 22.850, 0.63229, 1.6237}};
    double xi = -log(0.6) / sqrt(THUD_PI * THUD_PI + log(0.6) * log(0.6));
    struct equation q = {DASHPOT, 2.5e9, 1, 2 * xi * sqrt(2.5e9 * 160e3), false, INFINITY, 0, false};
    for (int i = 0; i < 2; i++) {
        struct outcome out = collide(&q, mass, mass, figures[i].v, 2e-6);
        check_figure(&out, &figures[i]);
        check_balance(&out, mass, mass, figures[i].v);
        struct two_body_collision closed = kelvin_voigt_cut_collision(2.5e9, xi, 160e3, figures[i].v);
        CLOSE(closed.force_n, out.force, 1e-7);
        CLOSE(closed.indentation_m, out.indentation, 1e-9);
        CLOSE(closed.duration_s, out.duration, 1e-9);
        CLOSE(closed.residual_m, out.residual, 1e-9);
        CLOSE(closed.restitution, out.e, 1e-9);
        struct thud_law_setup setup = setup_of("kelvin-voigt-no-tension", 160e3);
        CLOSE(restitution("kelvin-voigt-no-tension", &setup, figures[i].v), out.e, 1e-9);
    }
    ck_assert_double_eq_tol(force(&q, 0, 0.5, true, false) / 1e3, 3210, 1); /* at contact onset */
}
END_TEST

START_TEST(concrete_exact)
{
    struct thud_law_setup setup = setup_of("kelvin-voigt-no-tension", 160e3);
    set("kelvin-voigt-no-tension", &setup, "damping", 1);
    CLOSE(restitution("kelvin-voigt-no-tension", &setup, 0.5), 0.6, 1e-12);
    struct equation q = {DASHPOT, 2.5e9, 1, 2 * 0.18086 * sqrt(2.5e9 * 160e3), false, INFINITY, 0, false};
    struct outcome out = collide(&q, mass, mass, 0.5, 2e-6);
    ck_assert_double_eq_tol(out.force / 1e3, 8281.8, 0.06);
    ck_assert_double_eq_tol(out.indentation * 1e3, 3.0984, 6e-5);
    ck_assert_double_eq_tol(out.duration * 1e3, 22.596, 6e-4);
    ck_assert_double_eq_tol(out.e, 0.6, 1e-5);
}
END_TEST

/* Damping below 1/2, between, at and above critical; e from 0.9 down to 0.006. */
START_TEST(cut_dashpot_at_any_damping)
{
    static const double xis[] = {0, 0.01, 0.3, 0.499, 0.5, 0.8, 0.999999, 1, 1.000001, 1.7, 6};
    for (int i = 0; i < (int)(sizeof xis / sizeof xis[0]); i++) {
        double m1 = 250e3, m2 = 320e3, m = m1 * m2 / (m1 + m2);
        struct equation q = {DASHPOT, 2.5e9, 1, 2 * xis[i] * sqrt(2.5e9 * m), false, INFINITY, 0, false};
        struct outcome out = collide(&q, m1, m2, 0.7, 2e-6);
        struct two_body_collision closed = kelvin_voigt_cut_collision(2.5e9, xis[i], m, 0.7);
        CLOSE(closed.force_n, out.force, 1e-7);
        CLOSE(closed.indentation_m, out.indentation, 1e-7);
        CLOSE(closed.duration_s, out.duration, 1e-7);
        ck_assert_double_eq_tol(closed.residual_m, out.residual, 1e-9);
        CLOSE(closed.restitution, out.e, 1e-7);
        CLOSE(thud_kelvin_voigt_cut_restitution(xis[i]), out.e, 1e-7);
    }
}
END_TEST

START_TEST(classical_dashpot)
{
    static const double es[] = {0.01, 0.3, 0.6, 0.95};
    for (int i = 0; i < 4; i++) {
        double xi = thud_kelvin_voigt_xi(es[i]);
        struct equation q = {DASHPOT, 2.5e9, 1, 2 * xi * sqrt(2.5e9 * 160e3), true, INFINITY, 0, false};
        struct outcome out = collide(&q, mass, mass, 0.5, 2e-6);
        CLOSE(out.e, es[i], 1e-8);
        check_balance(&out, mass, mass, 0.5);
        struct thud_law_setup setup = setup_of("kelvin-voigt", 160e3);
        set("kelvin-voigt", &setup, "restitution", es[i]);
        CLOSE(restitution("kelvin-voigt", &setup, 0.5), out.e, 1e-8);
    }
}
END_TEST

START_TEST(hertz_damp)
{
    static const double es[] = {0.3, 0.6, 0.95}, ns[] = {1, 1.5, 2.65};
    for (int formula = 0; formula < 4; formula++)
        for (int i = 0; i < 9; i++) {
            double e = es[i % 3], n = ns[i / 3], m1 = 320e3, m2 = 250e3, m = m1 * m2 / (m1 + m2), v = 0.4;
            double s[] = {0.75 * (1 - e * e), 1.5 * (1 - e), 1.6 * (1 - e) / e, thud_hertz_damp_s(e)};
            double k = 4e6 * pow(1e3, n - 1) * 100;
            struct equation q = {HERTZ_DAMP, k, n, s[formula] / v, false, INFINITY, 0, false};
            struct outcome out = collide(&q, m1, m2, v, 1e-5);
            struct thud_law_setup setup = setup_of("hertz-damp", m);
            set("hertz-damp", &setup, "formula", formula);
            set("hertz-damp", &setup, "restitution", e);
            set("hertz-damp", &setup, "exponent", n);
            set("hertz-damp", &setup, "stiffness", k);
            CLOSE(restitution("hertz-damp", &setup, v), out.e, 1e-7);
            check_balance(&out, m1, m2, v);
            if (formula == 3)
                CLOSE(out.e, e, 1e-7);
        }
}
END_TEST

/* Below the floor the damping stays that of the floor, and the bodies lose less. */
START_TEST(hertz_damp_below_the_floor)
{
    struct thud_law_setup setup = setup_of("hertz-damp", 160e3);
    set("hertz-damp", &setup, "speed-floor", 0.5);
    double k = setup.value[thud_law_param(thud_law_find("hertz-damp"), "stiffness")];
    struct equation q = {HERTZ_DAMP, k, 1.5, 0.75 * (1 - 0.36) / 0.5, false, INFINITY, 0, false};
    struct outcome out = collide(&q, mass, mass, 0.1, 1e-5);
    CLOSE(restitution("hertz-damp", &setup, 0.1), out.e, 1e-7);
    ck_assert_double_gt(out.e, restitution("hertz-damp", &setup, 0.5) + 0.1);
    ck_assert_double_eq_tol(restitution("hertz-damp", &setup, 0), 1, 1e-15);
}
END_TEST

/* The law's own branch against the printed force, approach and restitution. */
static void check_jankowski_force(struct thud_law_setup *setup, const struct equation *q)
{
    const struct thud_law *law = thud_law_find("jankowski");
    struct thud_law_memory memory;
    ck_assert_int_eq(thud_law_prepare(law, setup, NULL), THUD_OK);
    thud_law_onset(law, setup, 0.4, &memory);
    for (int phase = 0; phase < 2; phase++)
        for (double d = 1e-6; d < 0.1; d *= 3) {
            struct thud_branch b = law->branch(setup, &memory, (enum thud_phase)phase, false);
            double v = phase ? -0.3 : 0.3;
            CLOSE(thud_branch_force(&b, d, v, NULL, NULL), force(q, d, v, !phase, false), 1e-12);
        }
}

START_TEST(jankowski)
{
    static const double es[] = {0.3, 0.6, 0.95}, ns[] = {1.5, 1, 2.65};
    for (int i = 0; i < 9; i++) {
        double e = es[i % 3], n = ns[i / 3], k = 4e8 * pow(1e3, n - 1), m1 = 250e3, m2 = 320e3;
        double m = m1 * m2 / (m1 + m2);
        struct equation q = {JANKOWSKI, k, n, 2 * thud_jankowski_xi(e, n) * sqrt(k * m), false, INFINITY, 0, false};
        struct outcome out = collide(&q, m1, m2, 0.4, 4e-6);
        struct thud_law_setup setup = setup_of("jankowski", m);
        set("jankowski", &setup, "damping", 1);
        set("jankowski", &setup, "restitution", e);
        set("jankowski", &setup, "exponent", n);
        set("jankowski", &setup, "stiffness", k);
        CLOSE(restitution("jankowski", &setup, 0.4), out.e, 1e-6);
        CLOSE(out.e, e, 1e-6);
        check_balance(&out, m1, m2, 0.4);
        if (n == 1.5) {
            double xi = 4.5 * sqrt(5) * (1 - e * e) / (e * (e * (9 * THUD_PI - 16) + 16));
            q.c = 2 * xi * sqrt(k * m);
            out = collide(&q, m1, m2, 0.4, 4e-6);
            set("jankowski", &setup, "damping", 0);
            CLOSE(restitution("jankowski", &setup, 0.4), out.e, 1e-6);
        }
        check_jankowski_force(&setup, &q);
    }
}
END_TEST

/* A body against one a million times heavier parts as it would from a wall. */
START_TEST(mass_ratio)
{
    double heavy = mass * 1e6, m = mass * heavy / (mass + heavy), xi = thud_kelvin_voigt_cut_xi(0.6);
    struct equation q = {DASHPOT, 2.5e9, 1, 2 * xi * sqrt(2.5e9 * m), false, INFINITY, 0, false};
    struct outcome out = collide(&q, mass, heavy, 0.5, 2e-6);
    CLOSE(out.e, 0.6, 1e-8);
    out = collide(&q, heavy, mass, 0.5, 2e-6);
    CLOSE(out.e, 0.6, 1e-8);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("law collisions");
    TCase *tests = tcase_create("collisions");
    tcase_set_timeout(tests, 0);
    tcase_add_test(tests, concrete_figures);
    tcase_add_test(tests, concrete_exact);
    tcase_add_test(tests, cut_dashpot_at_any_damping);
    tcase_add_test(tests, classical_dashpot);
    tcase_add_test(tests, hertz_damp);
    tcase_add_test(tests, hertz_damp_below_the_floor);
    tcase_add_test(tests, jankowski);
    tcase_add_test(tests, mass_ratio);
    suite_add_tcase(suite, tests);
    return suite;
}
