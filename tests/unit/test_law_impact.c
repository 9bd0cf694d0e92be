/* impact-material: the loop by its closed form and by the rule of increments that OpenSees states, what two bodies part
 * with, and motion by two methods. */
#include <check.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"
#include "core/laws/law.h"
#include "march.h"
#include "study/scene/two_body.h"
#include "suite.h"

static const double kh = 2.75e9, dm = 0.01, e = 0.6, ratio = 0.1;

/* As in the paper. */
static double lost_j(void)
{
    return kh * pow(dm, 2.5) * (1 - e * e) / 2.5;
}

static double k1(void)
{
    return kh * sqrt(dm) + lost_j() / (ratio * dm * dm);
}

static double k2(void)
{
    return kh * sqrt(dm) - lost_j() / ((1 - ratio) * dm * dm);
}

static struct march_law paper(void)
{
    return march_law("impact-material", "stiffness", kh, "restitution", e, "max-indentation", dm, NULL);
}

static struct march_law lines(double initial, double secondary, double yield)
{
    return march_law("impact-material", "initial-stiffness", initial, "secondary-stiffness", secondary,
                     "yield-indentation", yield, NULL);
}

/* The law along a path: what a contact that looks at every reversal makes of it. */
struct path {
    struct march_law law;
    struct thud_law_memory memory;
    enum thud_phase phase;
    double d;
};

static double force_on(const struct path *p, double d)
{
    struct thud_branch b = thud_law_branch_at(p->law.law, &p->law.setup, &p->memory, p->phase, d);
    return thud_branch_force(&b, d, 0, NULL, NULL);
}

static struct path begin(struct march_law law)
{
    struct path p = {.law = law, .phase = THUD_APPROACH};
    p.law.setup.mass_kg = 160e3;
    ck_assert_int_eq(thud_law_prepare(law.law, &p.law.setup, NULL), THUD_OK);
    thud_law_onset(law.law, &p.law.setup, 0.5, &p.memory);
    return p;
}

static void turn(struct path *p, enum thud_phase phase)
{
    if (phase != p->phase)
        thud_law_reversal(p->law.law, &p->law.setup, phase, p->d, &p->memory);
    p->phase = phase;
}

/* OpenSees: the last force plus K1 times the increment, but no further than the line it runs into. */
static double increment(double f, double d, double step)
{
    double next = f + k1() * step, upper = k1() * ratio * dm + k2() * (d + step - ratio * dm);
    return step > 0 ? fmin(next, upper) : fmax(next, k2() * (d + step));
}

START_TEST(any_path_is_that_of_the_increments)
{
    struct path p = begin(paper());
    double f = 0, to = 0;
    srand(1);
    for (int i = 0; i < 2000; i++) {
        to = (0.02 + rand() / (double)RAND_MAX) * (i % 7 ? 1.5 * dm : 0.2 * ratio * dm);
        double step = (to - p.d) / 16;
        turn(&p, step > 0 ? THUD_APPROACH : THUD_RESTITUTION);
        for (int k = 0; k < 16; k++) {
            f = increment(f, p.d, step);
            p.d += step;
            ck_assert_double_eq_tol(force_on(&p, p.d) / (kh * pow(dm, 1.5)), f / (kh * pow(dm, 1.5)), 1e-12);
        }
    }
}
END_TEST

/* 0 to d_m and back: K_eff d_m at the top, E inside; the corner of reloading lies d_y beyond where unloading ended. */
START_TEST(loop_by_closed_form)
{
    enum { N = 1000 };
    struct path p = begin(paper());
    double in = 0, out = 0, h = dm / N, dy = ratio * dm;
    for (int i = 0; i < N; i++)
        in += h * force_on(&p, (i + 0.5) * h);
    ck_assert_double_eq_tol(in / (0.628 * kh * pow(dm, 2.5)), 1, 1e-12);
    ck_assert_double_eq_tol(force_on(&p, dm) / (kh * pow(dm, 1.5)), 1, 1e-12);
    p.d = dm;
    turn(&p, THUD_RESTITUTION);
    for (int i = 0; i < N; i++)
        out += h * force_on(&p, (i + 0.5) * h);
    ck_assert_double_eq_tol((in - out) / lost_j(), 1, 1e-12);
    ck_assert_double_eq_tol(out / thud_law_energy(p.law.law, &p.law.setup, &p.memory, p.phase, dm), 1, 1e-12);
    ck_assert_double_eq_tol(force_on(&p, dm - 0.5 * dy), k2() * (dm - 0.5 * dy) + 0.5 * (k1() - k2()) * dy, 1);
    ck_assert_double_eq_tol(force_on(&p, 0.5 * dm), 0.5 * k2() * dm, 1);
    p.d = 0.5 * dm; /* on the lower line */
    turn(&p, THUD_APPROACH);
    ck_assert_double_eq_tol(force_on(&p, 0.5 * dm + 0.5 * dy), 0.5 * k2() * dm + 0.5 * k1() * dy, 1);
    ck_assert_double_eq_tol(force_on(&p, 0.5 * dm + 2 * dy), k1() * dy + k2() * (0.5 * dm + dy), 1);
    ck_assert_double_eq_tol(thud_law_ultimate(p.law.law, &p.law.setup, &p.memory, p.phase), 0.5 * dm + dy, 1e-15);
}
END_TEST

struct outcome {
    struct thud_contact_result contact;
    double error_ratio;
};

static struct outcome collide(const struct march_law *law, double mass_kg, double approach_mps)
{
    struct thud_two_body pair;
    struct thud_solution solution;
    struct thud_error err = {0};
    thud_two_body_concrete(&pair);
    pair.law = law->law;
    pair.setup = law->setup;
    pair.mass_kg[0] = pair.mass_kg[1] = 2 * mass_kg;
    pair.approach_mps = approach_mps;
    ck_assert_msg(thud_two_body_run(&pair, 1e-3, &solution, &err) == THUD_OK, "%s", err.what);
    struct outcome out = {thud_run_result(solution.run)->contact[0], thud_run_result(solution.run)->energy.error_ratio};
    thud_solution_clear(&solution);
    return out;
}

/* At d_m it gives sqrt(1 - 0.256/0.628) = 0.7696 for 0.6, and no loss at all below d_y. */
START_TEST(restitution_really_given)
{
    struct march_law law = paper();
    double mass = 160e3, energy = 0.628 * kh * pow(dm, 2.5), v = sqrt(2 * energy / mass);
    struct outcome got = collide(&law, mass, v);
    ck_assert_double_eq_tol(got.contact.restitution, 0.77, 5e-4);
    ck_assert_double_eq_tol(got.contact.restitution, sqrt(1 - 0.256 / 0.628), 1e-10);
    ck_assert_double_eq_tol(got.contact.indentation.value / dm, 1, 1e-10);
    ck_assert_double_eq_tol(got.contact.force.value / (kh * pow(dm, 1.5)), 1, 1e-10);
    ck_assert_double_eq_tol(got.contact.dissipated_j / lost_j(), 1, 1e-10);
    ck_assert_double_eq(got.contact.nominal_restitution, e);
    ck_assert_double_eq(got.contact.residual_m, 0);
    ck_assert_double_lt(got.error_ratio, 1e-12);
    law.setup.mass_kg = mass;
    ck_assert_int_eq(thud_law_prepare(law.law, &law.setup, NULL), THUD_OK);
    ck_assert_double_eq_tol(thud_law_restitution(law.law, &law.setup, v), sqrt(1 - 0.256 / 0.628), 1e-14);
    double slow = 0.99 * ratio * dm * sqrt(k1() / mass);
    ck_assert_double_eq_tol(collide(&law, mass, slow).contact.restitution, 1, 1e-10);
    ck_assert_double_eq(thud_law_restitution(law.law, &law.setup, slow), 1);
    ck_assert_double_lt(thud_law_restitution(law.law, &law.setup, 1.1 * slow), 1);
}
END_TEST

/* Four times the mass at half the speed has the same loop in twice the time; lengths and speeds times 3, d_y too, have
 * 3 times the force. */
START_TEST(neither_rate_nor_scale_matters)
{
    struct march_law law = lines(k1(), k2(), ratio * dm), large = lines(k1(), k2(), 3 * ratio * dm);
    struct outcome one = collide(&law, 160e3, 0.5), slow = collide(&law, 640e3, 0.25),
                   wide = collide(&large, 160e3, 1.5);
    ck_assert_double_eq_tol(slow.contact.force.value / one.contact.force.value, 1, 1e-10);
    ck_assert_double_eq_tol(slow.contact.indentation.value / one.contact.indentation.value, 1, 1e-10);
    ck_assert_double_eq_tol(slow.contact.dissipated_j / one.contact.dissipated_j, 1, 1e-10);
    ck_assert_double_eq_tol(slow.contact.restitution / one.contact.restitution, 1, 1e-10);
    ck_assert_double_eq_tol(slow.contact.contact_time_s / one.contact.contact_time_s, 2, 1e-9);
    ck_assert_double_eq_tol(wide.contact.force.value / one.contact.force.value, 3, 1e-9);
    ck_assert_double_eq_tol(wide.contact.restitution / one.contact.restitution, 1, 1e-10);
    ck_assert_double_eq_tol(wide.contact.contact_time_s / one.contact.contact_time_s, 1, 1e-9);
    ck_assert_double_nan(one.contact.nominal_restitution);
}
END_TEST

/* Towers that push on while in contact, so that reloading begins at many places. */
START_TEST(two_methods_agree)
{
    const int storeys[] = {4, 6};
    struct thud_record *record = march_motion(1.5);
    for (int wide = 0; wide < 2; wide++) {
        struct march_law law = wide ? lines(4e8, 1e8, 0.3e-3) : paper();
        struct thud_model *model = march_row(2, storeys, false, 0.01, &law);
        struct march a = march_run(model, record, "exact", 0, 0, true, 2),
                     b = march_run(model, record, "dormand-prince", 0, 1e-11, true, 2);
        ck_assert_msg(a.status == THUD_OK && b.status == THUD_OK, "%s %s", a.err.what, b.err.what);
        ck_assert_int_gt(a.result->contact[3].impacts, 5);
        ck_assert_double_lt(march_peaks_apart(a.result, b.result, 1e-3), 1e-6);
        ck_assert_double_lt(a.result->energy.error_ratio, 1e-11);
        march_free(&a);
        march_free(&b);
        thud_model_free(model);
    }
    thud_record_free(record);
}
END_TEST

static void check_refused(struct march_law law, const char *key)
{
    struct thud_error err = {0};
    law.setup.mass_kg = 160e3;
    ck_assert_int_eq(thud_law_prepare(law.law, &law.setup, &err), THUD_INPUT);
    ck_assert_str_eq(err.key, key);
}

START_TEST(values_are_checked)
{
    check_refused(lines(1e8, 2e8, 1e-3), "secondary-stiffness");
    check_refused(march_law("impact-material", "initial-stiffness", 1e8, NULL), "secondary-stiffness");
    check_refused(march_law("impact-material", "secondary-stiffness", 1e8, NULL), "initial-stiffness");
    struct march_law law = lines(2e8, 1e8, 1e-3);
    law.setup.value[thud_law_param(law.law, "restitution")] = 0.7;
    check_refused(law, "restitution");
    law = paper();
    law.setup.value[thud_law_param(law.law, "restitution")] = 1; /* no loop */
    law.setup.mass_kg = 160e3;
    ck_assert_int_eq(thud_law_prepare(law.law, &law.setup, NULL), THUD_OK);
    ck_assert_double_eq(thud_law_restitution(law.law, &law.setup, 1), 1);
}
END_TEST

Suite *thud_suite(void)
{
    Suite *suite = suite_create("law impact-material");
    TCase *tcase = tcase_create("law impact-material");
    tcase_set_timeout(tcase, 60);
    tcase_add_test(tcase, any_path_is_that_of_the_increments);
    tcase_add_test(tcase, loop_by_closed_form);
    tcase_add_test(tcase, restitution_really_given);
    tcase_add_test(tcase, neither_rate_nor_scale_matters);
    tcase_add_test(tcase, two_methods_agree);
    tcase_add_test(tcase, values_are_checked);
    suite_add_tcase(suite, tcase);
    return suite;
}
