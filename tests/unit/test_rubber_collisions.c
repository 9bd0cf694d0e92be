/* Collisions on the bumper, integrated from the printed equations, against the law and its closed forms. */
#include "collision.h"
#include "core/laws/law_closed_form.h"

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

/* Speeds on both sides of the floor and of the ultimate compression, both unloadings, both ways to set the speed, unequal bodies. */
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

/* A body against one a million times heavier. */
START_TEST(mass_ratio)
{
    double heavy = mass * 1e6, m = mass * heavy / (mass + heavy);
    struct equation q = rubber_equation(thud_rubber_cv(0.5) / 1.2, true);
    struct outcome out = collide(&q, heavy, mass, 1.2, 2e-5);
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
    Suite *suite = suite_create("rubber collisions");
    TCase *tests = tcase_create("collisions");
    tcase_set_timeout(tests, 0);
    tcase_add_test(tests, rubber_figures);
    tcase_add_test(tests, rubber_at_any_speed);
    tcase_add_test(tests, mass_ratio);
    suite_add_tcase(suite, tests);
    return suite;
}
