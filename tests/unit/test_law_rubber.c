/* The bumper: what may be given, knees, both unloadings, both ways to set the speed. */
#include <check.h>
#include <math.h>
#include <string.h>

#include "core/laws/law.h"
#include "core/laws/law_closed_form.h"

static const struct thud_law *rubber(void)
{
    return thud_law_find("rubber");
}

static void set(struct thud_law_setup *setup, const char *name, double value)
{
    setup->value[thud_law_param(rubber(), name)] = value;
}

static struct thud_law_setup bumper(void)
{
    struct thud_law_setup setup = {.mass_kg = 160e3, .thickness_m = 0.05};
    thud_law_defaults(rubber(), &setup);
    set(&setup, "stiffness", 0.36e3 * pow(1000, 2.65));
    return setup;
}

static void check_refused(struct thud_law_setup *setup, const char *key, const char *allowed)
{
    struct thud_error err;
    ck_assert_int_eq(thud_law_prepare(rubber(), setup, &err), THUD_INPUT);
    ck_assert_int_eq(err.status, THUD_INPUT);
    ck_assert_str_eq(err.key, key);
    ck_assert_ptr_nonnull(strstr(err.allowed, allowed));
    ck_assert(err.what[0]);
    ck_assert_int_eq(thud_law_prepare(rubber(), setup, NULL), THUD_INPUT);
}

/* Stiffness, or the three values of eq. (6): one of the two, whole. */
START_TEST(stiffness_given_once)
{
    static const char *const three[] = {"alpha", "area", "material-stiffness"};
    struct thud_law_setup setup = bumper();
    ck_assert_int_eq(thud_law_prepare(rubber(), &setup, NULL), THUD_OK);
    for (int i = 0; i < 3; i++) {
        struct thud_law_setup both = setup, part = setup;
        set(&both, three[i], 1);
        check_refused(&both, three[i], "stiffness");
        set(&part, "stiffness", NAN);
        for (int j = 0; j < 3; j++)
            set(&part, three[j], j == i ? NAN : 1);
        check_refused(&part, three[i], "alpha");
    }
    set(&setup, "stiffness", NAN);
    check_refused(&setup, "stiffness", "alpha, area");
    setup = bumper();
    setup.thickness_m = 0;
    check_refused(&setup, "thickness", "> 0");
}
END_TEST

/* Eq. (6): alpha A K_r is the force at a strain of 1. */
START_TEST(stiffness_from_material)
{
    struct thud_law_setup setup = bumper();
    struct thud_law_memory memory;
    set(&setup, "stiffness", NAN);
    set(&setup, "alpha", 2.2);
    set(&setup, "area", 1.5);
    set(&setup, "material-stiffness", 3e6);
    for (double n = 1.5; n < 4; n += 1.15) {
        set(&setup, "exponent", n);
        ck_assert_int_eq(thud_law_prepare(rubber(), &setup, NULL), THUD_OK);
        thud_law_onset(rubber(), &setup, 1, &memory);
        struct thud_branch b = rubber()->branch(&setup, &memory, THUD_APPROACH, false);
        ck_assert_double_eq_tol(thud_branch_force(&b, 0.05, 0.3, NULL, NULL) / (2.2 * 1.5 * 3e6), 1, 1e-13);
    }
}
END_TEST

static double at_knee(const struct thud_law_setup *setup, enum thud_phase phase, bool past, double v)
{
    struct thud_law_memory memory;
    thud_law_onset(rubber(), setup, 1, &memory);
    struct thud_branch b = rubber()->branch(setup, &memory, phase, past);
    return thud_branch_force(&b, thud_law_ultimate(rubber(), setup, &memory, THUD_APPROACH), v, NULL, NULL);
}

/* Force is continuous at the ultimate compression in approach, and in restitution by either unloading; the paper's has
 * no other branch beyond. */
START_TEST(knee)
{
    for (int unloading = 0; unloading < 2; unloading++) {
        struct thud_law_setup setup = bumper();
        set(&setup, "unloading", unloading);
        ck_assert_int_eq(thud_law_prepare(rubber(), &setup, NULL), THUD_OK);
        ck_assert_double_eq_tol(thud_law_ultimate(rubber(), &setup, &(struct thud_law_memory){0}, THUD_APPROACH), 0.04,
                                1e-17);
        ck_assert_double_eq(thud_law_ultimate(rubber(), &setup, &(struct thud_law_memory){0}, THUD_RESTITUTION),
                            unloading == 0 ? INFINITY : setup.value[thud_law_param(rubber(), "max-strain")] * 0.05);
        for (double v = -0.5; v < 0.6; v += 0.25)
            for (int phase = 0; phase < 2; phase++) {
                double below = at_knee(&setup, (enum thud_phase)phase, false, v);
                double above = at_knee(&setup, (enum thud_phase)phase, true, v);
                ck_assert_double_eq_tol(above, below, 1e-8 * 6335e3);
            }
    }
    struct thud_law_setup setup = bumper();
    struct thud_law_memory memory;
    thud_law_prepare(rubber(), &setup, NULL);
    thud_law_onset(rubber(), &setup, 1, &memory);
    /* at the ultimate compression itself the curve below holds */
    ck_assert(thud_law_branch_at(rubber(), &setup, &memory, THUD_APPROACH,
                                 thud_law_ultimate(rubber(), &setup, &(struct thud_law_memory){0}, THUD_APPROACH))
                  .K > 0);
    double beyond = nextafter(thud_law_ultimate(rubber(), &setup, &(struct thud_law_memory){0}, THUD_APPROACH), 1);
    ck_assert(thud_law_branch_at(rubber(), &setup, &memory, THUD_APPROACH, beyond).K == 0);
}
END_TEST

/* Past the ultimate compression eq. (5) as printed drops at the turn; continuous unloading starts where approach ended. */
START_TEST(turn_past_the_knee)
{
    struct thud_law_setup setup = bumper();
    struct thud_law_memory memory;
    double d = 0.045, f[2][2];
    for (int unloading = 0; unloading < 2; unloading++) {
        set(&setup, "unloading", unloading);
        thud_law_prepare(rubber(), &setup, NULL);
        thud_law_onset(rubber(), &setup, 1, &memory);
        for (int phase = 0; phase < 2; phase++) {
            struct thud_branch b = thud_law_branch_at(rubber(), &setup, &memory, (enum thud_phase)phase, d);
            f[unloading][phase] = thud_branch_force(&b, d, 0, NULL, NULL);
        }
    }
    double k = 0.36e3 * pow(1000, 2.65), line = k * pow(0.04, 2.65) + 2.5e9 * (d - 0.04), curve = k * pow(d, 2.65);
    ck_assert_double_eq_tol(f[0][0] / line, 1, 1e-13);
    ck_assert_double_eq_tol(f[0][1] / curve, 1, 1e-13);
    ck_assert_double_eq_tol(f[1][0] / line, 1, 1e-13);
    ck_assert_double_eq_tol(f[1][1] / line, 1, 1e-13);
}
END_TEST

/* continuous: F_A (1 + C v) on both sides of the ultimate compression. */
START_TEST(continuous_unloading)
{
    struct thud_law_setup setup = bumper();
    struct thud_law_memory memory;
    set(&setup, "unloading", 1);
    set(&setup, "damping", 1);
    thud_law_prepare(rubber(), &setup, NULL);
    thud_law_onset(rubber(), &setup, 2, &memory);
    struct thud_rubber_curve curve = thud_rubber_curve(0.36e3 * pow(1000, 2.65), 2.65, 0.04, 2.5e9);
    for (double d = 0.001; d < 0.08; d += 0.003)
        for (double v = -1; v < 0.1; v += 0.2) {
            struct thud_branch b = thud_law_branch_at(rubber(), &setup, &memory, THUD_RESTITUTION, d);
            double expected = thud_rubber_curve_force(&curve, d) * (1 + thud_rubber_cv(0.5) / 2 * v);
            ck_assert_double_eq_tol(thud_branch_force(&b, d, v, NULL, NULL), expected, 1e-7);
        }
}
END_TEST

/* energy: what a free pair that stores U(d) had as approach velocity; touch: the turn changes nothing. */
START_TEST(speed_from_energy)
{
    struct thud_law_setup setup = bumper();
    struct thud_law_memory grazing, straight;
    thud_law_prepare(rubber(), &setup, NULL);
    thud_law_onset(rubber(), &setup, 1e-6, &grazing);
    double before = grazing.own[0];
    rubber()->reversal(&setup, THUD_RESTITUTION, 0.02, &grazing);
    ck_assert_double_eq(grazing.own[0], before);
    set(&setup, "impact-speed", 1);
    for (int damping = 0; damping < 2; damping++) {
        set(&setup, "damping", damping);
        thud_law_prepare(rubber(), &setup, NULL);
        for (double d = 0.001; d < 0.06; d *= 1.5) {
            double v = sqrt(2 * thud_law_energy(rubber(), &setup, &grazing, THUD_APPROACH, d) / setup.mass_kg);
            thud_law_onset(rubber(), &setup, 1e-6, &grazing);
            rubber()->reversal(&setup, THUD_RESTITUTION, d, &grazing);
            thud_law_onset(rubber(), &setup, fmax(v, 1e-3), &straight);
            if (v > 1e-3)
                ck_assert_double_eq_tol(grazing.own[0] / straight.own[0], 1, 1e-13);
        }
        rubber()->reversal(&setup, THUD_RESTITUTION, 0, &grazing); /* a turn at no indentation: no division by 0 */
        ck_assert(isfinite(grazing.own[0]));
    }
    /* at the exact damping restitution is the one asked for at any speed, and in the limit at rest */
    set(&setup, "unloading", 1);
    thud_law_prepare(rubber(), &setup, NULL);
    for (double v = 10; v > 1e-12; v /= 10)
        ck_assert_double_eq_tol(thud_law_restitution(rubber(), &setup, v), 0.5, 1e-12);
    ck_assert_double_eq_tol(thud_law_restitution(rubber(), &setup, 0), 0.5, 1e-12);
}
END_TEST

static int count_unusual(struct thud_law_setup *setup)
{
    struct thud_error err;
    int n = 0;
    ck_assert_int_eq(thud_law_prepare(rubber(), setup, NULL), THUD_OK);
    while (rubber()->unusual(setup, n, &err))
        n++;
    return n;
}

/* Work done on a bumper that is compressed from d1 to d2 and let go again, so slowly that no dashpot acts: midpoints of
 * its two branches. */
static double slow_cycle(const struct thud_law_setup *setup, double d1, double d2)
{
    enum { PARTS = 400 };
    struct thud_law_memory memory;
    double work = 0;
    thud_law_onset(rubber(), setup, 1, &memory);
    thud_law_reversal(rubber(), setup, THUD_RESTITUTION, d2, &memory);
    for (int i = 0; i < PARTS; i++)
        for (int phase = 0; phase < 2; phase++) {
            double d = d1 + (i + 0.5) / PARTS * (d2 - d1);
            struct thud_branch b = thud_law_branch_at(rubber(), setup, &memory, (enum thud_phase)phase, d);
            work += (phase == THUD_APPROACH ? 1 : -1) * thud_branch_force(&b, d, 0, NULL, NULL) * (d2 - d1) / PARTS;
        }
    return work;
}

/* The remark on a soft line holds for the bumpers that gain energy in some cycle up to their thickness, and for no other
 * one; the gain of all of the compression past delta_u is that of the closed form. unloading continuous gains none. */
START_TEST(soft_lines_create_energy)
{
    static const double exponent[] = {1, 1.5, 2.65, 4}, strain[] = {0.5, 0.8, 0.95};
    for (int c = 0; c < 12; c++) {
        double n = exponent[c % 4], u = strain[c / 4] * 0.05, k = 6e6 / pow(u, n), force = k * pow(u, n);
        double chord = (k * pow(0.05, n) - force) / (0.05 - u), slope = n * force / u;
        for (double line = 0.25 * chord; line < 4 * chord; line *= 1.3) {
            struct thud_law_setup setup = bumper();
            struct thud_error err;
            double least = INFINITY, unit = 1e-6 * force * (0.05 - u);
            set(&setup, "exponent", n);
            set(&setup, "stiffness", k);
            set(&setup, "max-strain", strain[c / 4]);
            set(&setup, "post-yield", line);
            ck_assert_int_eq(thud_law_prepare(rubber(), &setup, NULL), THUD_OK);
            for (int i = 0; i < 20; i++)
                least = fmin(least, slow_cycle(&setup, u + i * (0.05 - u) / 20, u + (i + 1) * (0.05 - u) / 20));
            bool gains = rubber()->unusual(&setup, 0, &err);
            if (fabs(line / chord - 1) > 0.1) /* where the last twentieth tells it */
                ck_assert_msg(gains == (least < -unit), "n %g, line %g of %g: %g J", n, line, chord, least);
            double whole = 0.5 * line * (0.05 - u) * (0.05 - u) + force * (0.05 - u) -
                           k * (pow(0.05, n + 1) - pow(u, n + 1)) / (n + 1);
            ck_assert_double_eq_tol(slow_cycle(&setup, 0, 0.05) / force, whole / force, 1e-5);
            if (gains) {
                ck_assert_ptr_nonnull(strstr(err.what, "more energy than it takes"));
                ck_assert_ptr_nonnull(strstr(err.allowed, "unloading: continuous"));
            }
            set(&setup, "unloading", 1);
            ck_assert_int_eq(thud_law_prepare(rubber(), &setup, NULL), THUD_OK);
            ck_assert(fabs(slow_cycle(&setup, 0, 0.05)) < unit);
            ck_assert_int_eq(rubber()->unusual(&setup, 0, &err), line < slope);
            ck_assert(line >= slope || !strstr(err.what, "more energy"));
        }
    }
}
END_TEST

/* The force at the ultimate strain is k (0.8 * 5 cm)^2.65, the slope there 2.65 times that over 4 cm; from there to the
 * thickness the curve rises by (1.25^2.65 - 1) times the force. */
START_TEST(what_is_unusual_together)
{
    struct thud_error err;
    struct thud_law_setup setup = bumper(), weak = setup, strong = setup, both = setup;
    double force = setup.value[thud_law_param(rubber(), "stiffness")] * pow(0.04, 2.65), slope = 2.65 * force / 0.04;
    double chord = (pow(1.25, 2.65) - 1) * force / 0.01;
    ck_assert_int_eq(count_unusual(&setup), 0);
    set(&setup, "post-yield", 1.001 * chord);
    ck_assert_int_eq(count_unusual(&setup), 0);
    set(&setup, "post-yield", 0.999 * chord);
    ck_assert_int_eq(count_unusual(&setup), 1);
    set(&setup, "unloading", 1);
    set(&setup, "post-yield", 1.001 * slope);
    ck_assert_int_eq(count_unusual(&setup), 0);
    set(&setup, "post-yield", 0.999 * slope);
    ck_assert_int_eq(count_unusual(&setup), 1);
    ck_assert(rubber()->unusual(&setup, 0, &err));
    ck_assert_str_eq(err.key, "post-yield");

    set(&weak, "stiffness", weak.value[thud_law_param(rubber(), "stiffness")] * 0.99 * 0.1e6 / force);
    ck_assert_int_eq(count_unusual(&weak), 1);
    ck_assert(rubber()->unusual(&weak, 0, &err));
    ck_assert_str_eq(err.key, "stiffness");
    ck_assert_ptr_nonnull(strstr(err.what, "0.099 MN"));

    /* alpha A / t^n K, eq. (6), in place of the stiffness; far too hard, so the line after it is softer */
    set(&strong, "stiffness", NAN);
    set(&strong, "alpha", 1);
    set(&strong, "area", 1);
    set(&strong, "material-stiffness", 400e6);
    set(&strong, "post-yield", 1e15);
    ck_assert_int_eq(count_unusual(&strong), 1);
    ck_assert(rubber()->unusual(&strong, 0, &err));
    ck_assert_str_eq(err.key, "material-stiffness");

    set(&both, "stiffness", both.value[thud_law_param(rubber(), "stiffness")] * 1.01 * 100e6 / force);
    set(&both, "post-yield", slope);
    ck_assert_int_eq(count_unusual(&both), 2);
    ck_assert(rubber()->unusual(&both, 0, &err));
    ck_assert_str_eq(err.key, "stiffness");
    ck_assert_ptr_nonnull(strstr(err.what, "101 MN"));
    ck_assert(rubber()->unusual(&both, 1, &err));
    ck_assert_str_eq(err.key, "post-yield");
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("rubber");
    TCase *tests = tcase_create("rubber");
    tcase_set_timeout(tests, 0);
    tcase_add_test(tests, stiffness_given_once);
    tcase_add_test(tests, stiffness_from_material);
    tcase_add_test(tests, knee);
    tcase_add_test(tests, turn_past_the_knee);
    tcase_add_test(tests, continuous_unloading);
    tcase_add_test(tests, speed_from_energy);
    tcase_add_test(tests, soft_lines_create_energy);
    tcase_add_test(tests, what_is_unusual_together);
    suite_add_tcase(suite, tests);
    return suite;
}
