/* One collision of two free bodies under every law, integrated here from the printed equations (Runge-Kutta of order 4, events by
 * bisection) and held against what the laws and their closed forms answer. Nothing of thud computes a force in this file. */
#include <check.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "core/law.h"
#include "core/law_closed_form.h"

static const double pi = 3.14159265358979323846;
static const double mass = 320e3; /* of each body unless said otherwise */

/* The equations as printed; `c` in the sense of each. */
enum printed { DASHPOT, HERTZ_DAMP, JANKOWSKI, RUBBER };
struct equation {
    enum printed form;
    double k, n, c;          /* c: dashpot c; s/v0; 2 xi sqrt(k m); C */
    bool pulls;              /* dashpot: contact ends at d = 0 */
    double knee, post_yield; /* rubber; knee INFINITY elsewhere */
    bool continuous;
};

static double force(const struct equation *q, double d, double v, bool approach, bool past)
{
    double dn = d > 0 ? pow(d, q->n) : 0;
    switch (q->form) {
    case DASHPOT:
        return q->k * d + q->c * v;
    case HERTZ_DAMP:
        return q->k * dn * (1 + q->c * v);
    case JANKOWSKI:
        return q->k * dn + (approach && d > 0 ? q->c * pow(d, (q->n - 1) / 2) * v : 0);
    default:
        break;
    }
    double f = q->k * dn;
    if (past && (approach || q->continuous))
        f = q->k * pow(q->knee, q->n) + q->post_yield * (d - q->knee);
    return approach ? f : f * (1 + q->c * v);
}

struct outcome {
    double force, indentation, duration, e, residual, dissipated, momentum;
};

/* x1, x2, v1, v2, work done on the contact */
enum { X1, X2, V1, V2, WORK, STATE };
struct bodies {
    double m1, m2;
};

static void slope(const struct equation *q, const struct bodies *b, const double *y, bool approach, bool past, double *dy)
{
    double v = y[V1] - y[V2], f = force(q, y[X1] - y[X2], v, approach, past);
    dy[X1] = y[V1];
    dy[X2] = y[V2];
    dy[V1] = -f / b->m1;
    dy[V2] = f / b->m2;
    dy[WORK] = f * v;
}

static void rk4(const struct equation *q, const struct bodies *b, const double *y, bool approach, bool past, double h,
                double *out)
{
    double k[4][STATE], z[STATE];
    slope(q, b, y, approach, past, k[0]);
    for (int s = 1; s < 4; s++) {
        for (int i = 0; i < STATE; i++)
            z[i] = y[i] + h * (s == 3 ? 1 : 0.5) * k[s - 1][i];
        slope(q, b, z, approach, past, k[s]);
    }
    for (int i = 0; i < STATE; i++)
        out[i] = y[i] + h / 6 * (k[0][i] + 2 * k[1][i] + 2 * k[2][i] + k[3][i]);
}

/* > 0 until the event: 0 turn, 1 knee, 2 release. */
static double event(const struct equation *q, const double *y, bool approach, bool past, int which)
{
    double d = y[X1] - y[X2], v = y[V1] - y[V2];
    if (which == 0)
        return approach ? v : 1;
    if (which == 1) {
        if (approach)
            return past ? 1 : q->knee - d;
        return past ? d - q->knee : 1;
    }
    if (approach && (q->form != DASHPOT || q->pulls))
        return 1;
    return q->form == DASHPOT && !q->pulls ? force(q, d, v, approach, past) : d;
}

static struct outcome collide(const struct equation *q, double m1, double m2, double v0, double h)
{
    struct bodies b = {m1, m2};
    struct outcome out = {0};
    double y[STATE] = {0, 0, v0, 0, 0}, next[STATE], t = 0;
    bool approach = true, past = false;
    for (long steps = 0; steps < 4000000; steps++) {
        out.force = fmax(out.force, force(q, y[X1] - y[X2], y[V1] - y[V2], approach, past));
        out.indentation = fmax(out.indentation, y[X1] - y[X2]);
        /* small steps first: a power of d below 1 has no slope at first touch */
        double step = steps < 200 ? h * pow((double)(steps + 1) / 200, 4) : h;
        rk4(q, &b, y, approach, past, step, next);
        int hit = -1;
        for (int which = 0; which < 3; which++) {
            if (event(q, next, approach, past, which) > 0)
                continue;
            double lo = 0, hi = step;
            for (int i = 0; i < 60; i++) {
                double mid = 0.5 * (lo + hi), z[STATE];
                rk4(q, &b, y, approach, past, mid, z);
                if (event(q, z, approach, past, which) > 0)
                    lo = mid;
                else
                    hi = mid;
            }
            step = hi;
            hit = which;
            rk4(q, &b, y, approach, past, step, next);
        }
        memcpy(y, next, sizeof y);
        t += step;
        if (hit == 0) {
            out.force = fmax(out.force, force(q, y[X1] - y[X2], 0, true, past));
            out.indentation = fmax(out.indentation, y[X1] - y[X2]);
            approach = false;
        } else if (hit == 1) {
            past = approach;
        } else if (hit == 2) {
            break;
        }
    }
    out.duration = t;
    out.e = (y[V2] - y[V1]) / v0;
    out.residual = y[X1] - y[X2];
    /* what the contact took and did not give back; a spring still compressed at release is lost too */
    out.dissipated = y[WORK];
    out.momentum = (m1 * y[V1] + m2 * y[V2]) / (m1 * v0);
    return out;
}

/* Setting a law up. */
static struct thud_law_setup setup_of(const char *name, double m)
{
    struct thud_law_setup setup = {.mass_kg = m, .thickness_m = 0.05};
    thud_law_defaults(thud_law_find(name), &setup);
    return setup;
}

static void set(const char *name, struct thud_law_setup *setup, const char *param, double value)
{
    setup->value[thud_law_param(thud_law_find(name), param)] = value;
}

static double restitution(const char *name, struct thud_law_setup *setup, double v)
{
    const struct thud_law *law = thud_law_find(name);
    ck_assert_int_eq(law->prepare(setup, NULL), THUD_OK);
    return law->restitution(setup, v);
}

#define CLOSE(actual, expected, tolerance) ck_assert_double_eq_tol((actual) / (expected), 1, tolerance)

/* Every collision must hold these, whatever the law. */
static void check_balance(const struct outcome *out, double m1, double m2, double v0)
{
    double m = m1 * m2 / (m1 + m2);
    ck_assert_double_eq_tol(out->momentum, 1, 1e-9);
    CLOSE(out->dissipated, 0.5 * m * v0 * v0 * (1 - out->e * out->e), 1e-6);
}

static double rubber_k(void)
{
    return 0.36 * 1e3 * pow(1000, 2.65);
}

static struct thud_law_setup rubber_setup(double m)
{
    struct thud_law_setup setup = setup_of("rubber", m);
    set("rubber", &setup, "stiffness", rubber_k());
    return setup;
}

static struct equation rubber_equation(double c, bool continuous)
{
    return (struct equation){RUBBER, rubber_k(), 2.65, c, false, 0.04, 2.5e9, continuous};
}

/* Eq. (7). */
static double eq7(double cor, double m, double v)
{
    return 1.55 * (1 - cor * cor) / (pow(cor, 0.7076) * pow(m, 0.0025) * pow(v, 0.9755));
}

/* The reference figures of the paper's Table 1 for two bodies of 320 t: kN, mm, ms. */
struct figure {
    double v, force, indentation, duration, e, residual;
};

static void check_figure(const struct outcome *out, const struct figure *f)
{
    ck_assert_double_eq_tol(out->force / 1e3, f->force, 0.051);
    ck_assert_double_eq_tol(out->indentation * 1e3, f->indentation, 0.00051 + (f->indentation < 10 ? 0 : 0.0005));
    ck_assert_double_eq_tol(out->duration * 1e3, f->duration, f->duration < 100 ? 0.00051 : 0.0051);
    ck_assert_double_eq_tol(out->e, f->e, 5.1e-6);
    ck_assert_double_eq_tol(out->residual * 1e3, f->residual, 5.1e-5);
}

START_TEST(concrete_figures)
{
    static const struct figure figures[] = {{0.5, 8379.6, 3.1807, 22.850, 0.63229, 0.8118},
                                            {1.0, 16759.2, 6.3613, 22.850, 0.63229, 1.6237}};
    double xi = -log(0.6) / sqrt(pi * pi + log(0.6) * log(0.6));
    struct equation q = {DASHPOT, 2.5e9, 1, 2 * xi * sqrt(2.5e9 * 160e3), false, INFINITY, 0, false};
    for (int i = 0; i < 2; i++) {
        struct outcome out = collide(&q, mass, mass, figures[i].v, 2e-6);
        check_figure(&out, &figures[i]);
        check_balance(&out, mass, mass, figures[i].v);
        struct thud_pair_collision closed = thud_kelvin_voigt_cut_collision(2.5e9, xi, 160e3, figures[i].v);
        CLOSE(closed.force_n, out.force, 1e-7);
        CLOSE(closed.indentation_m, out.indentation, 1e-9);
        CLOSE(closed.duration_s, out.duration, 1e-9);
        CLOSE(closed.residual_m, out.residual, 1e-9);
        CLOSE(closed.restitution, out.e, 1e-9);
        struct thud_law_setup setup = setup_of("kelvin-voigt-no-tension", 160e3);
        CLOSE(restitution("kelvin-voigt-no-tension", &setup, figures[i].v), out.e, 1e-9);
    }
    ck_assert_double_eq_tol(force(&q, 0, 0.5, true, false) / 1e3, 3210, 1); /* at first touch */
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
        struct thud_pair_collision closed = thud_kelvin_voigt_cut_collision(2.5e9, xis[i], m, 0.7);
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
    ck_assert_int_eq(law->prepare(setup, NULL), THUD_OK);
    law->touch(setup, 0.4, &memory);
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
            double xi = 4.5 * sqrt(5) * (1 - e * e) / (e * (e * (9 * pi - 16) + 16));
            q.c = 2 * xi * sqrt(k * m);
            out = collide(&q, m1, m2, 0.4, 4e-6);
            set("jankowski", &setup, "damping", 0);
            CLOSE(restitution("jankowski", &setup, 0.4), out.e, 1e-6);
        }
        check_jankowski_force(&setup, &q);
    }
}
END_TEST

START_TEST(rubber_figures)
{
    static const struct {
        struct figure figure;
        bool exact, continuous;
    } rows[] = {
        {{0.5, 2566.5, 28.443, 203.86, 0.50953, 0}, false, false},
        {{1.0, 9643.6, 41.323, 148.07, 0.50177, 0}, false, false},
        {{1.0, 9643.6, 41.323, 148.58, 0.49838, 0}, true, false},
        {{0.5, 2566.5, 28.443, 205.81, 0.50000, 0}, true, true},
        {{1.0, 9643.6, 41.323, 146.80, 0.50000, 0}, true, true},
    };
    for (int i = 0; i < (int)(sizeof rows / sizeof rows[0]); i++) {
        double v = rows[i].figure.v;
        double c = rows[i].exact ? 1.86011 / v : eq7(0.5, 160e3, v);
        struct equation q = rubber_equation(c, rows[i].continuous);
        struct outcome out = collide(&q, mass, mass, v, 1e-5);
        check_figure(&out, &rows[i].figure);
        check_balance(&out, mass, mass, v);
        struct thud_law_setup setup = rubber_setup(160e3);
        set("rubber", &setup, "damping", rows[i].exact);
        set("rubber", &setup, "unloading", rows[i].continuous);
        /* 1.86011 is printed to six digits */
        CLOSE(restitution("rubber", &setup, v), out.e, rows[i].exact ? 3e-6 : 1e-8);
        struct thud_rubber_curve curve = thud_rubber_curve(rubber_k(), 2.65, 0.04, 2.5e9);
        double d = thud_rubber_curve_indentation(&curve, 0.5 * 160e3 * v * v);
        CLOSE(d, out.indentation, 1e-9);
        CLOSE(thud_rubber_curve_force(&curve, d), out.force, 1e-9);
    }
}
END_TEST

/* Speeds on both sides of the floor and of the knee, both unloadings, both ways to set the speed, unequal bodies. */
START_TEST(rubber_at_any_speed)
{
    static const double vs[] = {2e-4, 1e-3, 0.05, 0.9, 1.2, 3};
    double m1 = 250e3, m2 = 320e3, m = m1 * m2 / (m1 + m2);
    for (int i = 0; i < 48; i++) {
        double v = vs[i / 8], reference = i & 4 ? v : fmax(v, 1e-3);
        double c = i & 1 ? thud_rubber_cv(0.5) / reference : eq7(0.5, m, reference);
        struct equation q = rubber_equation(c, i & 2);
        struct outcome out = collide(&q, m1, m2, v, v < 0.01 ? 5e-4 : 2e-5);
        struct thud_law_setup setup = rubber_setup(m);
        set("rubber", &setup, "damping", i & 1);
        set("rubber", &setup, "unloading", (i & 2) / 2);
        set("rubber", &setup, "impact-speed", (i & 4) / 4);
        CLOSE(restitution("rubber", &setup, v), out.e, 2e-7);
        check_balance(&out, m1, m2, v);
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
    q = rubber_equation(thud_rubber_cv(0.5) / 1.2, true);
    out = collide(&q, heavy, mass, 1.2, 2e-5);
    struct thud_law_setup setup = rubber_setup(m);
    set("rubber", &setup, "damping", 1);
    set("rubber", &setup, "unloading", 1);
    CLOSE(restitution("rubber", &setup, 1.2), out.e, 1e-7);
    CLOSE(out.e, 0.5, 1e-7);
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
    tcase_add_test(tests, rubber_figures);
    tcase_add_test(tests, rubber_at_any_speed);
    tcase_add_test(tests, mass_ratio);
    suite_add_tcase(suite, tests);
    return suite;
}
