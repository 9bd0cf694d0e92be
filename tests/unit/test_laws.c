/* The tables of the laws and their branches, against the equations as printed, finite differences and quadrature. */
#include <check.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"
#include "core/laws/law.h"
#include "law_examples.h"

static const double mass = 160e3; /* effective */

static struct thud_law_setup setup_of(const struct thud_law *law)
{
    struct thud_law_setup setup = {.mass_kg = mass, .thickness_m = 0.05};
    thud_law_defaults(law, &setup);
    if (law == thud_law_find("rubber")) /* the one law whose stiffness has no default */
        setup.value[thud_law_param(law, "stiffness")] = 0.36e3 * pow(1000, 2.65);
    return setup;
}

static double value_of(const struct thud_law *law, const struct thud_law_setup *setup, const char *name)
{
    return setup->value[thud_law_param(law, name)];
}

static void set(const struct thud_law *law, struct thud_law_setup *setup, const char *name, double value)
{
    ck_assert_int_ge(thud_law_param(law, name), 0);
    setup->value[thud_law_param(law, name)] = value;
}

static double force_at(const struct thud_law *law, const struct thud_law_setup *setup,
                       const struct thud_law_memory *memory, enum thud_phase phase, double d, double v)
{
    struct thud_branch branch = thud_law_branch_at(law, setup, memory, phase, d);
    return thud_branch_force(&branch, d, v, NULL, NULL);
}

/* A law ready for a contact that began at v. */
static const struct thud_law *ready(const char *name, double v, struct thud_law_setup *setup,
                                    struct thud_law_memory *memory)
{
    const struct thud_law *law = thud_law_find(name);
    *setup = setup_of(law);
    ck_assert_int_eq(thud_law_prepare(law, setup, NULL), THUD_OK);
    *memory = (struct thud_law_memory){0};
    thud_law_onset(law, setup, v, memory);
    return law;
}

/* The laws whose equations stand here; a law may be added without a word of it in this file. */
static const char *const known[] = {"none",
                                    "linear",
                                    "kelvin-voigt",
                                    "kelvin-voigt-no-tension",
                                    "hertz",
                                    "hertz-damp",
                                    "jankowski",
                                    "rubber",
                                    "impact-material",
                                    "stereomechanical",
                                    "permanent-indentation", /* and the examples */
                                    "remembered-path"};
enum { NAMES = sizeof known / sizeof *known };

static bool is_here(const struct thud_law *law)
{
    for (int i = 0; i < NAMES; i++)
        if (strcmp(law->name, known[i]) == 0)
            return true;
    return false;
}

START_TEST(list)
{
    int here = 0;
    for (int i = 0; i < thud_law_count(); i++) { /* each is found by its name, which no other one has */
        ck_assert_ptr_eq(thud_law_find(thud_law_at(i)->name), thud_law_at(i));
        here += is_here(thud_law_at(i));
    }
    ck_assert_int_eq(here, NAMES);
    ck_assert_ptr_null(thud_law_find("kelvin"));
    ck_assert_int_eq(thud_law_param(thud_law_find("rubber"), "exponent"), 1);
    ck_assert_int_eq(thud_law_param(thud_law_find("linear"), "exponent"), -1);
    ck_assert_int_eq(thud_law_param(thud_law_find("none"), "stiffness"), -1);
}
END_TEST

static void check_param(const struct thud_param *p)
{
    ck_assert(p->name[0] && p->title[0] && p->help[0] && p->unit);
    if (p->kind == THUD_PARAM_CHOICE) {
        int n = 0;
        while (p->choices[n])
            n++;
        ck_assert(n >= 2 && p->fallback >= 0 && p->fallback < n);
        return;
    }
    ck_assert_int_eq(p->kind, THUD_PARAM_QUANTITY);
    if (isnan(p->fallback))
        return;
    ck_assert(!(p->fallback < p->least) && !(p->fallback > p->most));
    ck_assert(!(p->least_open && p->fallback == p->least) && !(p->most_open && p->fallback == p->most));
    ck_assert(!(p->fallback < p->soft_least) && !(p->fallback > p->soft_most));
}

START_TEST(tables)
{
    for (int i = 0; i < thud_law_count(); i++) {
        const struct thud_law *law = thud_law_at(i);
        ck_assert(law->title[0] && law->reference[0] && law->summary[0] && law->nparams <= THUD_LAW_PARAMS_MAX);
        for (int j = 0; j < law->nparams; j++) {
            check_param(&law->params[j]);
            ck_assert_int_eq(thud_law_param(law, law->params[j].name), j);
        }
        struct thud_law_setup setup;
        thud_law_defaults(law, &setup);
        for (int j = 0; j < THUD_LAW_PARAMS_MAX; j++) {
            double expected = j < law->nparams ? law->params[j].fallback : 0;
            ck_assert(setup.value[j] == expected || (isnan(expected) && isnan(setup.value[j])));
        }
    }
}
END_TEST

static double typed(const char *text, enum thud_dimension dimension)
{
    struct thud_quantity q;
    ck_assert_int_eq(thud_quantity_parse(text, dimension, NULL, &q, NULL), THUD_OK);
    return q.value;
}

/* The paper's Table 1, as people type it. */
START_TEST(defaults)
{
    const struct thud_law *concrete = thud_law_find("kelvin-voigt-no-tension"), *rubber = thud_law_find("rubber"),
                          *hertz = thud_law_find("hertz");
    struct thud_law_setup setup;
    thud_law_defaults(concrete, &setup);
    ck_assert_double_eq(value_of(concrete, &setup, "stiffness"), typed("2500 kN/mm", THUD_STIFFNESS));
    ck_assert_double_eq(value_of(concrete, &setup, "restitution"), 0.6);
    ck_assert_double_eq(value_of(concrete, &setup, "damping"), 0);
    ck_assert(concrete->keeps_residual(&setup));
    set(concrete, &setup, "residual", 1);
    ck_assert(!concrete->keeps_residual(&setup));
    thud_law_defaults(rubber, &setup);
    ck_assert_double_eq(value_of(rubber, &setup, "exponent"), 2.65);
    ck_assert_double_eq(value_of(rubber, &setup, "restitution"), 0.5);
    ck_assert_double_eq(value_of(rubber, &setup, "max-strain"), 0.8);
    ck_assert_double_eq(value_of(rubber, &setup, "post-yield"), typed("2500 kN/mm", THUD_STIFFNESS));
    ck_assert_double_eq(value_of(rubber, &setup, "speed-floor"), typed("1 mm/s", THUD_VELOCITY));
    ck_assert_double_nan(value_of(rubber, &setup, "stiffness"));
    ck_assert(!rubber->keeps_residual);
    thud_law_defaults(hertz, &setup);
    ck_assert_double_eq_tol(value_of(hertz, &setup, "stiffness") / typed("87 kN/mm^1.5", THUD_POWER_STIFFNESS), 1,
                            1e-15);
}
END_TEST

START_TEST(flags)
{
    for (int i = 0; i < thud_law_count(); i++) {
        struct thud_law_setup setup;
        struct thud_law_memory memory;
        const struct thud_law *law = ready(thud_law_at(i)->name, 0.5, &setup, &memory);
        struct thud_law_memory after = memory;
        thud_law_reversal(law, &setup, THUD_RESTITUTION, 0.06, &after);
        bool linear = true, one = true, turns = false;
        for (double d = 0.003; d < 0.06; d *= 1.7)
            for (double v = -0.4; v < 0.5; v += 0.3) {
                double f = force_at(law, &setup, &memory, THUD_APPROACH, d, v);
                double back = force_at(law, &setup, &after, THUD_RESTITUTION, d, v);
                double twice = force_at(law, &setup, &memory, THUD_APPROACH, 2 * d, 2 * v);
                turns |= f != back;
                one &= fabs(twice - 2 * f) <= 1e-12 * fabs(f);
                struct thud_branch b = thud_law_branch_at(law, &setup, &memory, THUD_APPROACH, d);
                linear &= b.K == 0 && b.D == 0;
                b = thud_law_branch_at(law, &setup, &after, THUD_RESTITUTION, d);
                linear &= b.K == 0 && b.D == 0;
            }
        bool no_force = law->flags & (THUD_LAW_NO_FORCE | THUD_LAW_IMPULSIVE);
        ck_assert_int_eq(linear, no_force || (law->flags & THUD_LAW_LINEAR) != 0);
        ck_assert_int_eq(one, (law->flags & (THUD_LAW_DEGREE_ONE | THUD_LAW_NO_FORCE)) != 0);
        ck_assert_int_eq(turns, (law->flags & THUD_LAW_REVERSES) != 0);
        if (!is_here(law))
            continue;
        ck_assert_int_eq((law->flags & THUD_LAW_PULLS) != 0, strcmp(law->name, "kelvin-voigt") == 0);
        ck_assert_int_eq((law->flags & THUD_LAW_NO_FORCE) != 0, strcmp(law->name, "none") == 0);
        ck_assert_int_eq((law->flags & THUD_LAW_IMPULSIVE) != 0, strcmp(law->name, "stereomechanical") == 0);
    }
}
END_TEST

/* Each force as printed, at d and v; v0 = 0.5. */
static double printed(const char *name, enum thud_phase phase, double d, double v)
{
    double e = 0.6, k = 2.5e9, kh = 87e3 * pow(1000, 1.5);
    double c = -2 * log(e) / sqrt(THUD_PI * THUD_PI + log(e) * log(e)) * sqrt(k * mass);
    double xi = 4.5 * sqrt(5) * (1 - e * e) / (e * (e * (9 * THUD_PI - 16) + 16));
    if (strcmp(name, "linear") == 0)
        return k * d;
    if (strncmp(name, "kelvin-voigt", 12) == 0)
        return k * d + c * v;
    if (strcmp(name, "hertz") == 0)
        return kh * pow(d, 1.5);
    if (strcmp(name, "hertz-damp") == 0)
        return kh * pow(d, 1.5) * (1 + 0.75 * (1 - e * e) * v / 0.5);
    if (strcmp(name, "jankowski") == 0)
        return kh * pow(d, 1.5) + (phase == THUD_APPROACH ? 2 * xi * sqrt(kh * sqrt(d) * mass) * v : 0);
    if (strcmp(name, "remembered-path") == 0)
        return (phase == THUD_APPROACH ? 1 : 0.36) * k * d;
    if (strcmp(name, "permanent-indentation") == 0)
        return phase == THUD_APPROACH && d > 1e-3 ? k * 1e-3 + 0.1 * k * (d - 1e-3) : k * d;
    if (strcmp(name, "impact-material") == 0) {
        double keff = kh * sqrt(0.01), lost = kh * pow(0.01, 2.5) * (1 - 0.36) / 2.5;
        double k1 = keff + lost / (0.1 * 0.01 * 0.01), k2 = keff - lost / (0.9 * 0.01 * 0.01);
        return phase == THUD_APPROACH && d > 1e-3 ? k1 * 1e-3 + k2 * (d - 1e-3) : k1 * d;
    }
    if (strcmp(name, "rubber") != 0)
        return 0;
    double kr = 0.36e3 * pow(1000, 2.65), cor = 0.5;
    double C = 1.55 * (1 - cor * cor) / (pow(cor, 0.7076) * pow(mass, 0.0025) * pow(0.5, 0.9755));
    if (phase == THUD_RESTITUTION)
        return kr * pow(d, 2.65) * (1 + C * v);
    return d <= 0.04 ? kr * pow(d, 2.65) : kr * pow(0.04, 2.65) + 2.5e9 * (d - 0.04);
}

START_TEST(forces_as_printed)
{
    for (int i = 0; i < thud_law_count(); i++) {
        struct thud_law_setup setup;
        struct thud_law_memory memory;
        const struct thud_law *law = ready(thud_law_at(i)->name, 0.5, &setup, &memory);
        for (double d = 1e-6; d < 0.1 && is_here(law); d *= 1.3)
            for (double v = -0.5; v < 0.6; v += 0.1)
                for (int phase = THUD_APPROACH; phase <= THUD_RESTITUTION; phase++) {
                    double f = force_at(law, &setup, &memory, (enum thud_phase)phase, d, v);
                    double expected = printed(law->name, (enum thud_phase)phase, d, v);
                    ck_assert_double_eq_tol(f, expected, 1e-12 * (fabs(expected) + 1e6 * d));
                }
    }
}
END_TEST

START_TEST(derivatives)
{
    static const double exponents[] = {1, 1.5, 0.25, 2.65, 6};
    for (int i = 0; i < 25; i++) {
        struct thud_branch b = {
            .f0_n = -3, .k_npm = 5, .c_nspm = 7, .K = 11, .p = exponents[i % 5], .D = 13, .r = exponents[i / 5]};
        for (double d = 0.01; d < 2; d *= 3)
            for (double v = -2; v < 3; v += 1) {
                double fd, fv, h = 1e-6 * d, none = thud_branch_force(&b, d, v, &fd, &fv);
                ck_assert_double_eq_tol(none, -3 + 5 * d + 7 * v + 11 * pow(d, b.p) + 13 * pow(d, b.r) * v, 1e-12);
                double by_d =
                    (thud_branch_force(&b, d + h, v, NULL, NULL) - thud_branch_force(&b, d - h, v, NULL, NULL)) /
                    (2 * h);
                double by_v =
                    (thud_branch_force(&b, d, v + h, NULL, NULL) - thud_branch_force(&b, d, v - h, NULL, NULL)) /
                    (2 * h);
                ck_assert_double_eq_tol(fd, by_d, 1e-7 * (1 + fabs(fd)) / fmin(d, 1));
                ck_assert_double_eq_tol(fv, by_v, 1e-7 * (1 + fabs(fv)) / fmin(d, 1));
            }
    }
}
END_TEST

static void check_edge(struct thud_branch b, double d, double v, double f, double fd, double fv)
{
    double by_d, by_v;
    ck_assert_double_eq(thud_branch_force(&b, d, v, &by_d, &by_v), f);
    ck_assert_double_eq(by_d, fd);
    ck_assert_double_eq(by_v, fv);
}

/* At d = 0 the limit from the right, below it the linear part alone. */
START_TEST(edges)
{
    struct thud_branch b = {.f0_n = 1, .k_npm = 2, .c_nspm = 3, .K = 5, .p = 1.5, .D = 7, .r = 0.25};
    check_edge(b, 0, 0, 1, 2, 3);
    check_edge(b, 0, 4, 13, INFINITY, 3);
    check_edge(b, 0, -4, -11, -INFINITY, 3);
    check_edge(b, -2, 4, 9, 2, 3);
    b.p = b.r = 1;
    check_edge(b, 0, 4, 13, 2 + 5 + 28, 3);
    check_edge(b, -2, 4, 9, 2, 3);
    b.p = b.r = 2.65;
    check_edge(b, 0, 4, 13, 2, 3);
    b.K = b.D = 0;
    check_edge(b, 1, 4, 15, 2, 3);
    b.p = b.r = 0; /* no power at all */
    check_edge(b, 0, 4, 13, 2, 3);
    b.D = 7;
    b.r = 1;
    check_edge(b, 2, 4, 1 + 4 + 12 + 56, 2 + 28, 3 + 14);
    check_edge(b, 0, 4, 13, 2 + 28, 3);
}
END_TEST

/* Energy under the force of an approach at rest, by Simpson's rule in d = s^2. */
static void check_approach_energy(const struct thud_law *law, const struct thud_law_setup *setup,
                                  const struct thud_law_memory *memory)
{
    for (int far = 0; far < 2; far++) {
        enum { N = 2000 };
        double from = far ? 0.2 : 0, h = 0.1 / N,
               sum = far ? thud_law_energy(law, setup, memory, THUD_APPROACH, 0.04) : 0;
        double s[3];
        for (int j = 0; j < N; j++)
            for (int part = 0; part < 3; part++) {
                s[part] = from + h * (j + 0.5 * part);
                double f = force_at(law, setup, memory, THUD_APPROACH, s[part] * s[part], 0);
                sum += h / 6 * (part == 1 ? 4 : 1) * f * 2 * s[part];
            }
        double d = (from + 0.1) * (from + 0.1);
        ck_assert_double_eq_tol(thud_law_energy(law, setup, memory, THUD_APPROACH, d), sum, 1e-9 * sum + 1e-12);
    }
}

/* Where branches at rest part: what restitution gives back, and no less of it told before the reversal than after. */
static void check_returned_energy(const struct thud_law *law, const struct thud_law_setup *setup,
                                  const struct thud_law_memory *memory)
{
    enum { N = 100000 };
    for (double top = 3e-4; top < 0.1; top *= 3) {
        struct thud_law_memory after = *memory;
        thud_law_reversal(law, setup, THUD_RESTITUTION, top, &after);
        double sum = 0, h = top / N;
        for (int j = 0; j < N; j++)
            sum += h * fmax(force_at(law, setup, &after, THUD_RESTITUTION, (j + 0.5) * h, 0), 0);
        ck_assert_double_eq_tol(thud_law_energy(law, setup, &after, THUD_RESTITUTION, top) / sum, 1, 1e-8);
        ck_assert_double_eq_tol(thud_law_energy(law, setup, memory, THUD_APPROACH, top) / sum, 1, 1e-8);
    }
}

START_TEST(elastic_energy)
{
    static const char *const keeps[] = {"impact-material", "permanent-indentation", "remembered-path"};
    for (int i = 0; i < thud_law_count(); i++) {
        struct thud_law_setup setup;
        struct thud_law_memory memory;
        const struct thud_law *law = ready(thud_law_at(i)->name, 0.5, &setup, &memory);
        bool parts = false;
        for (size_t k = 0; k < sizeof keeps / sizeof *keeps; k++)
            parts |= strcmp(law->name, keeps[k]) == 0;
        (parts ? check_returned_energy : check_approach_energy)(law, &setup, &memory);
        ck_assert_double_eq(thud_law_energy(law, &setup, &memory, THUD_APPROACH, 0), 0);
    }
}
END_TEST

START_TEST(touch_and_floor)
{
    struct thud_law_setup setup;
    struct thud_law_memory fast, slow, rest;
    static const char *const names[] = {"hertz-damp", "rubber"};
    for (int i = 0; i < 2; i++) {
        const struct thud_law *law = ready(names[i], 1e-3, &setup, &fast);
        thud_law_onset(law, &setup, 1e-5, &slow);
        thud_law_onset(law, &setup, 0, &rest);
        ck_assert_double_eq(slow.own[0], fast.own[0]);
        ck_assert_double_eq(rest.own[0], fast.own[0]);
        thud_law_onset(law, &setup, 1, &fast);
        ck_assert_double_lt(fast.own[0], slow.own[0] / 500);
        set(law, &setup, "speed-floor", 1e-5);
        thud_law_onset(law, &setup, 1e-5, &rest);
        ck_assert_double_gt(rest.own[0], slow.own[0] * 50);
    }
}
END_TEST

/* Without a law's own losses bodies part as they met; without touch there is nothing to tell. */
START_TEST(plain_restitution)
{
    struct thud_law_setup setup;
    struct thud_law_memory memory;
    static const char *const lossless[] = {"linear", "hertz"};
    for (int i = 0; i < 2; i++) {
        const struct thud_law *law = ready(lossless[i], 1, &setup, &memory);
        ck_assert_double_eq(thud_law_nominal(law, &setup), 1);
        ck_assert_double_eq(thud_law_restitution(law, &setup, 0.5), 1);
    }
    const struct thud_law *law = ready("none", 1, &setup, &memory);
    ck_assert_double_nan(thud_law_nominal(law, &setup));
    ck_assert_double_nan(thud_law_restitution(law, &setup, 1));
    law = ready("stereomechanical", 1, &setup, &memory);
    set(law, &setup, "restitution", 0.25);
    ck_assert_double_eq(thud_law_nominal(law, &setup), 0.25);
    ck_assert_double_eq(thud_law_restitution(law, &setup, 1), 0.25);
}
END_TEST

START_TEST(jankowski_exponent)
{
    const struct thud_law *law = thud_law_find("jankowski");
    struct thud_law_setup setup = setup_of(law);
    struct thud_error err;
    set(law, &setup, "exponent", 2);
    ck_assert_int_eq(thud_law_prepare(law, &setup, &err), THUD_INPUT);
    ck_assert_str_eq(err.key, "damping");
    ck_assert_ptr_nonnull(strstr(err.allowed, "exact"));
    set(law, &setup, "damping", 1);
    set(law, &setup, "stiffness", 1e10);
    ck_assert_int_eq(thud_law_prepare(law, &setup, &err), THUD_OK);
    ck_assert_double_eq_tol(thud_law_restitution(law, &setup, 1), 0.6, 1e-14);
}
END_TEST

/* The default stiffness holds for the default exponent only. */
START_TEST(stiffness_goes_with_exponent)
{
    static const char *const names[] = {"hertz-damp", "jankowski"};
    for (int i = 0; i < 2; i++) {
        const struct thud_law *law = thud_law_find(names[i]);
        struct thud_law_setup setup = setup_of(law);
        struct thud_error err;
        if (i == 1)
            set(law, &setup, "damping", 1);
        ck_assert_int_eq(thud_law_prepare(law, &setup, &err), THUD_OK);
        set(law, &setup, "exponent", 2);
        ck_assert_int_eq(thud_law_prepare(law, &setup, &err), THUD_INPUT);
        ck_assert_str_eq(err.key, "stiffness");
        ck_assert_str_eq(err.allowed, "a number of kN/mm^2");
        set(law, &setup, "stiffness", typed("87 kN/mm^2", THUD_POWER_STIFFNESS));
        ck_assert_int_eq(thud_law_prepare(law, &setup, &err), THUD_OK);
    }
}
END_TEST

/* Trial values of an iteration that runs away may not pass for a force. */
START_TEST(numbers_without_bounds_do_not_pass_for_forces)
{
    const double k = 0.36e3 * 8.9e7, column = _i ? 3e8 : 0;
    const struct thud_branch b = {.K = k, .p = 2.65, .D = 1.3 * k, .r = 2.65, .column_npm = column};
    double fd, fv;
    ck_assert(isnan(thud_branch_force(&b, NAN, 0, &fd, &fv)));
    ck_assert(isnan(thud_branch_force(&b, 0.01, NAN, &fd, &fv)));
    ck_assert(!isfinite(thud_branch_force(&b, 0.01, INFINITY, &fd, &fv)));
    ck_assert(!(thud_branch_force(&b, INFINITY, 0, &fd, &fv) < 1e100));
    ck_assert(isfinite(thud_branch_force(&b, 0.01, 1, &fd, &fv)) && isfinite(fd) && isfinite(fv));
}
END_TEST

/* Powers by tables and a series against the library's. */
START_TEST(powers_by_tables)
{
    static const double exponent[] = {0.25, 0.9, 1.825, 2.65, 4};
    struct thud_powers powers;
    thud_powers_fill(&powers, exponent[_i]);
    for (double d = 1e-25; d < 1e4; d *= 1.0137) {
        double want = pow(d, exponent[_i]);
        ck_assert_double_eq_tol(thud_power(&powers, d), want, 1e-14 * want);
    }
}
END_TEST

Suite *thud_suite(void)
{
    Suite *suite = suite_create("laws");
    TCase *tests = tcase_create("laws");
    tcase_set_timeout(tests, 0);
    tcase_add_loop_test(tests, powers_by_tables, 0, 5);
    tcase_add_test(tests, list);
    tcase_add_test(tests, tables);
    tcase_add_test(tests, defaults);
    tcase_add_test(tests, flags);
    tcase_add_test(tests, forces_as_printed);
    tcase_add_test(tests, derivatives);
    tcase_add_test(tests, edges);
    tcase_add_test(tests, elastic_energy);
    tcase_add_test(tests, touch_and_floor);
    tcase_add_loop_test(tests, numbers_without_bounds_do_not_pass_for_forces, 0, 2); /* 1: with columns */
    tcase_add_test(tests, plain_restitution);
    tcase_add_test(tests, jankowski_exponent);
    tcase_add_test(tests, stiffness_goes_with_exponent);
    suite_add_tcase(suite, tests);
    return suite;
}
