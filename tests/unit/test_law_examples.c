/* Laws that are added by one file and one word, and what a law may not be. The examples go through the tests of all laws
 * beside this; here they are held against results by hand. */
#include <check.h>
#include <math.h>
#include <string.h>

#include "core/run/run_private.h"
#include "law_examples.h"
#include "march.h"
#include "study/scene/two_body.h"
#include "suite.h"

static struct thud_solution collide(const char *law, double approach_mps, const char *method, const char *param[],
                                    const double *value)
{
    struct thud_two_body pair;
    struct thud_solution solution;
    struct thud_error err = {0};
    thud_two_body_concrete(&pair);
    pair.law = thud_law_find(law);
    memset(&pair.setup, 0, sizeof pair.setup);
    thud_law_defaults(pair.law, &pair.setup);
    for (int i = 0; param[i]; i++)
        thud_two_body_set(&pair, param[i], value[i]);
    pair.approach_mps = approach_mps;
    pair.method = thud_method_find(method);
    pair.method_step_s = 1e-4;
    pair.locate = true;
    ck_assert_msg(thud_two_body_run(&pair, 1e-3, &solution, &err) == THUD_OK, "%s: %s", method, err.what);
    return solution;
}

/* F = 5 MN is reached at 8/3 mm and stays: of 80/3 kJ, 20 kJ go into 4 mm that stay, a quarter comes back. */
START_TEST(permanent_indentation_by_hand)
{
    static const char *param[] = {"stiffness", "hardening", "yield-indentation", "residual", NULL};
    for (int i = 0; i < thud_method_count(); i++)
        for (int recover = 0; recover < 2; recover++) {
            const struct thud_method *method = thud_method_at(i);
            const double value[] = {1.875e9, 0, 8e-3 / 3, recover};
            if (!(method->flags & (THUD_METHOD_LOCATES | THUD_METHOD_CAN_LOCATE)))
                continue;
            double near = strcmp(method->name, "exact") == 0 ? 1e-11 : method->order > 2 ? 1e-6 : 2e-3;
            struct thud_solution solution = collide("permanent-indentation", sqrt(1.0 / 3), method->name, param, value);
            const struct thud_contact_result *c = &thud_run_result(solution.run)->contact[0];
            ck_assert_int_eq(c->impacts, 1);
            ck_assert_double_eq_tol(c->force.value / 5e6, 1, near);
            ck_assert_double_eq_tol(c->indentation.value / (20e-3 / 3), 1, near);
            ck_assert_double_eq_tol(c->restitution, 0.5, near);
            ck_assert_double_eq_tol(c->residual_m, recover ? 0 : 4e-3, 4e-3 * near);
            ck_assert_double_eq_tol(c->dissipated_j / 20e3, 1, 2 * near);
            thud_solution_clear(&solution);
        }
}
END_TEST

/* A mass that a soft spring throws against a wall again and again, 1 m/s at first. */
static struct march thrown(const struct march_law *law, const char *method, double tolerance, double tail_s)
{
    struct thud_model *model = march_mass_and_wall(160e3, 2, 0, 1, 0, law);
    return march_run(model, NULL, method, 0, tolerance, true, tail_s);
}

static void finish(struct march *m)
{
    struct thud_model *model = (struct thud_model *)m->run->state.model;
    march_free(m);
    thud_model_free(model);
}

/* The second contact is not as fast as the first: it goes no deeper, along what the first has left. */
START_TEST(reloading_follows_what_the_last_contact_left)
{
    static const char *const name[] = {"permanent-indentation", "remembered-path"};
    for (int i = 0; i < 2; i++) {
        struct march_law law = march_law(name[i], "stiffness", 2.5e9, NULL);
        struct march one = thrown(&law, "exact", 0, 1), two = thrown(&law, "exact", 0, 2.5);
        ck_assert_int_eq(one.status, THUD_OK);
        ck_assert_int_eq(two.status, THUD_OK);
        const struct thud_contact_result *first = &one.result->contact[0], *second = &two.result->contact[0];
        ck_assert_int_eq(first->impacts, 1);
        ck_assert_int_eq(second->impacts, 2);
        ck_assert_double_lt(first->restitution, 0.9);
        ck_assert_double_eq_tol(second->restitution, 1, 1e-6);
        ck_assert_double_eq_tol(second->indentation.value / first->indentation.value, 1, 1e-9);
        ck_assert_double_eq_tol(second->dissipated_j / first->dissipated_j, 1, 1e-6);
        ck_assert_double_eq(second->residual_m, first->residual_m);
        finish(&one);
        finish(&two);
    }
}
END_TEST

/* An indentation that stays in the clearance, and one that the law goes through without force, are one motion. */
START_TEST(a_law_may_have_a_gap_of_its_own)
{
    struct march_law keep = march_law("permanent-indentation", "stiffness", 2.5e9, NULL), recover = keep;
    recover.setup.value[thud_law_param(recover.law, "residual")] = 1;
    struct march a = thrown(&keep, "exact", 0, 6), b = thrown(&recover, "exact", 0, 6);
    ck_assert_int_eq(a.status, THUD_OK);
    ck_assert_int_eq(b.status, THUD_OK);
    ck_assert_int_gt(a.result->contact[0].impacts, 2);
    ck_assert_double_gt(a.result->contact[0].residual_m, 1e-3);
    ck_assert_double_eq(b.result->contact[0].residual_m, 0);
    ck_assert_double_lt(march_distance(&a, &b), 1e-9);
    ck_assert_double_eq_tol(a.result->contact[0].dissipated_j / b.result->contact[0].dissipated_j, 1, 1e-9);
    finish(&a);
    finish(&b);
}
END_TEST

/* A mass at rest that is pushed against the spring with m a goes in to 2 m a/k, where a return would start with
 * 0.36 * 2 m a < m a: it sticks there with m a until the push falls below 0.72 m a. */
START_TEST(a_linear_law_sticks)
{
    static const char *const method[] = {"exact", "dormand-prince"};
    enum { SAMPLES = 101, HELD = 50 };
    const double m = 160e3, a = 5, k = 1e8, dt = 0.02;
    double push[SAMPLES];
    for (int i = 0; i < SAMPLES; i++)
        push[i] = i <= HELD ? -a : -a * (1 - (i - HELD) / (double)(SAMPLES - 1 - HELD));
    for (size_t i = 0; i < sizeof method / sizeof *method; i++)
        for (int end = HELD; end < SAMPLES; end += SAMPLES - 1 - HELD) {
            struct thud_record *record;
            ck_assert_int_eq(thud_record_create(push, (size_t)end + 1, dt, &record, NULL), THUD_OK);
            struct march_law law = march_law("remembered-path", "stiffness", k, NULL);
            struct thud_model *model = march_mass_and_wall(m, 0, 0, 0, 0, &law);
            struct march run = march_run(model, record, method[i], 0, 1e-9, true, 0);
            ck_assert_msg(run.status == THUD_OK, "%s: %s", method[i], run.err.what);
            const struct thud_contact_result *c = &run.result->contact[0];
            ck_assert_double_eq_tol(c->force.value / (2 * m * a), 1, 1e-8);
            ck_assert_double_eq_tol(c->indentation.value / (2 * m * a / k), 1, 1e-8);
            if (end == HELD) {
                ck_assert_int_eq(run.run->state.contact[0].mode, THUD_STICKING);
                ck_assert_double_eq_tol(march_displacement(&run, 0) / (2 * m * a / k), 1, 1e-8);
                ck_assert_double_eq_tol(march_velocity(&run, 0), 0, 1e-9);
                ck_assert_double_eq_tol(c->impulse_ns / (m * a * HELD * dt), 1, 1e-8);
            } else {
                ck_assert_int_ne(run.run->state.contact[0].mode, THUD_STICKING);
                ck_assert_double_lt(march_displacement(&run, 0), 2 * m * a / k);
            }
            ck_assert_double_lt(run.result->energy.error_ratio, 1e-8);
            march_free(&run);
            thud_model_free(model);
            thud_record_free(record);
        }
}
END_TEST

/* Motion of the towers with each example, by two methods that share nothing. */
START_TEST(two_methods_agree)
{
    static const char *const name[] = {"permanent-indentation", "remembered-path"};
    const int storeys[] = {4, 6};
    struct thud_record *record = march_motion(1.5);
    struct march_law law = march_law(name[_i], "stiffness", 2.5e9, NULL);
    struct thud_model *model = march_row(2, storeys, false, 0.02, &law);
    struct march a = march_run(model, record, "exact", 0, 1e-9, true, 2),
                 b = march_run(model, record, "dormand-prince", 0, 1e-10, true, 2);
    ck_assert_msg(a.status == THUD_OK && b.status == THUD_OK, "%s %s", a.err.what, b.err.what);
    ck_assert_int_gt(a.result->contact[3].impacts, 3);
    ck_assert_double_lt(march_peaks_apart(a.result, b.result, 1e-3), 1e-5);
    march_free(&a);
    march_free(&b);
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

/* ---- what is refused ---- */

static double no_energy(const struct thud_law_setup *setup, const struct thud_law_memory *memory, double d_m)
{
    (void)setup;
    (void)memory;
    return 0.5 * d_m * d_m;
}

/* The branch is that of the parameters: approach, restitution, and what stands at the places of their coefficients. */
static struct thud_branch given_branch(const struct thud_law_setup *setup, const struct thud_law_memory *memory,
                                       enum thud_phase phase, bool past_ultimate)
{
    (void)memory;
    (void)past_ultimate;
    const double *v = setup->value + (phase == THUD_APPROACH ? 0 : 7);
    return (struct thud_branch){
        .f0_n = v[0], .k_npm = v[1], .c_nspm = v[2], .K = v[3], .p = v[4], .D = v[5], .r = v[6]};
}

static double at_zero(const struct thud_law_setup *setup, const struct thud_law_memory *memory, enum thud_phase phase)
{
    (void)setup;
    (void)memory;
    (void)phase;
    return 0;
}

static void no_reversal(const struct thud_law_setup *setup, enum thud_phase phase, double d_m,
                        struct thud_law_memory *memory)
{
    (void)setup;
    (void)phase;
    (void)d_m;
    (void)memory;
}

static void check_refused(struct thud_law law, const double *value, double column_npm, const char *why)
{
    struct thud_law_setup setup = {.mass_kg = 1, .column_npm = column_npm};
    struct thud_error err = {0};
    if (value)
        memcpy(setup.value, value, 14 * sizeof *value);
    law.name = "odd";
    if (!why) {
        ck_assert_msg(thud_law_prepare(&law, &setup, &err) == THUD_OK, "%s", err.what);
        return;
    }
    ck_assert_int_eq(thud_law_prepare(&law, &setup, &err), THUD_INPUT);
    ck_assert_str_eq(err.key, "law");
    ck_assert_msg(strstr(err.what, why), "%s", err.what);
    ck_assert_ptr_nonnull(strstr(err.what, "the law odd cannot be used: "));
}

START_TEST(what_is_no_law_is_refused)
{
    const struct thud_law both = {.flags = THUD_LAW_REVERSES, .branch = given_branch, .elastic_energy = no_energy};
    /* f0 k c K p D r of approach and restitution */
    static const struct {
        double value[14];
        double column;
        const char *why;
    } row[] = {
        {{0, 1, 0, 0, 0, 0, 0, 0, 1}, 0, NULL},
        {{0, NAN, 0, 0, 0, 0, 0, 0, 1}, 0, "not a number"},
        {{0, 0, 0, -1, 2, 0, 0, 0, 0, 0, -1, 2}, 0, "above 0"},
        {{0, 0, 0, 1, 2, 1, 2, 0, 0, 0, 1, 2, 1, 2}, 0, NULL},                       /* K d^p (1 + s v) */
        {{0, 1, 0, 1, 2, 1, 2, 0, 1, 0, 1, 2, 1, 2}, 0, "no other terms"},           /* and k d */
        {{0, 0, 0, 1, 2, 1, 1, 0, 0, 0, 1, 2}, 0, NULL},                             /* a dashpot in approach */
        {{0, 0, 0, 1, 2, 1, 1, 0, 0, 0, 1, 2, 1, 1}, 0, "holds for approach alone"}, /* and in restitution */
        {{0, 1, 0, 1, 2, 0, 0, 0, 1, 0, 1, 2}, 0, NULL},                             /* k d + K d^p */
        {{0, 1, 0, 1, 2, 0, 0, 0, 1, 0, 1, 2}, 5, "in series"},                      /* and columns */
        {{-1, 0, 0, 1, 2, 0, 0, -1, 0, 0, 1, 2}, 0, "below 0"},                      /* K d^p - f0 */
        {{-1, 2, -3, 0, 1, 6, 1, -1, 2, -3, 0, 1, 6, 1}, 0, NULL},                   /* (2 d - 1)(1 + 3 v) */
        {{-1, 2, 0, 0, 1, 6, 1, -1, 2, 0, 0, 1, 6, 1}, 0, "needs a power"},          /* 2 d - 1 + 6 d v */
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++)
        check_refused(both, row[i].value, row[i].column, row[i].why);
    struct thud_law law = both;
    law.flags |= THUD_LAW_LINEAR;
    check_refused(law, row[4].value, 0, "declared linear");
    law = both;
    law.ultimate = at_zero;
    check_refused(law, row[0].value, 0, "not above 0");
    law = both;
    law.nparams = THUD_LAW_PARAMS_MAX + 1;
    check_refused(law, row[0].value, 0, "more parameters");
    law = both;
    law.branch = NULL;
    check_refused(law, NULL, 0, "no branches");
    law = both;
    law.elastic_energy = NULL;
    check_refused(law, NULL, 0, "no elastic energy");
    law = both;
    law.flags = 0;
    law.reversal = no_reversal;
    check_refused(law, row[0].value, 0, "undeclared reversal");
}
END_TEST

Suite *thud_suite(void)
{
    Suite *suite = suite_create("law examples");
    TCase *tcase = tcase_create("law examples");
    tcase_set_timeout(tcase, 60);
    tcase_add_test(tcase, permanent_indentation_by_hand);
    tcase_add_test(tcase, reloading_follows_what_the_last_contact_left);
    tcase_add_test(tcase, a_law_may_have_a_gap_of_its_own);
    tcase_add_test(tcase, a_linear_law_sticks);
    tcase_add_loop_test(tcase, two_methods_agree, 0, 2);
    tcase_add_test(tcase, what_is_no_law_is_refused);
    suite_add_tcase(suite, tcase);
    return suite;
}
