/* Two free bodies through the whole run: every law against its closed forms and against the figures of the study. */
#include <check.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "closed_form.h"
#include "core/laws/law_closed_form.h"
#include "core/run/run.h"
#include "law_examples.h"
#include "study/scene/two_body.h"

struct outcome {
    double force, indentation, duration, restitution, residual, energy_error;
    int impacts;
};

static struct outcome collide(const struct thud_two_body *pair)
{
    struct thud_solution solution;
    struct thud_error err = {0};
    ck_assert_msg(thud_two_body_run(pair, 1e-3, &solution, &err) == THUD_OK, "%s", err.what);
    const struct thud_result *r = thud_run_result(solution.run);
    const struct thud_contact_result *c = &r->contact[0];
    int n;
    const struct thud_impact *impact = thud_run_impacts(solution.run, &n);
    ck_assert_int_ge(n, 1);
    struct outcome out = {c->force.value,
                          c->indentation.value,
                          impact[0].duration_s,
                          c->separation_mps / c->approach_mps,
                          c->residual_m,
                          r->energy.error_ratio,
                          c->impacts};
    thud_solution_clear(&solution);
    return out;
}

START_TEST(concrete_by_closed_form)
{
    for (double e = 0.1; e < 0.999; e += 0.1)
        for (int exact = 0; exact < 2; exact++) {
            struct thud_two_body pair;
            thud_two_body_concrete(&pair);
            thud_two_body_set(&pair, "restitution", e);
            thud_two_body_set(&pair, "damping", exact);
            double xi = exact ? thud_kelvin_voigt_cut_xi(e) : thud_kelvin_voigt_xi(e);
            struct two_body_collision want = kelvin_voigt_cut_collision(2.5e9, xi, 160e3, 0.5);
            struct outcome got = collide(&pair);
            ck_assert_int_eq(got.impacts, 1);
            ck_assert_double_eq_tol(got.force / want.force_n, 1, 1e-9);
            ck_assert_double_eq_tol(got.indentation / want.indentation_m, 1, 1e-9);
            ck_assert_double_eq_tol(got.duration / want.duration_s, 1, 1e-9);
            ck_assert_double_eq_tol(got.restitution / want.restitution, 1, 1e-9);
            ck_assert_double_eq_tol(got.residual / want.residual_m, 1, 1e-9);
            ck_assert_double_lt(got.energy_error, 1e-12);
            if (exact)
                ck_assert_double_eq_tol(got.restitution, e, 1e-9);
        }
}
END_TEST

/* Energy balance gives the largest indentation, and the law's own restitution the speed of parting. */
START_TEST(rubber_by_closed_form)
{
    static const double speeds[] = {0.003, 0.05, 0.5, 0.93, 1.0, 2.0};
    for (size_t i = 0; i < sizeof speeds / sizeof *speeds; i++)
        for (int variant = 0; variant < 8; variant++) {
            struct thud_two_body pair;
            thud_two_body_rubber(&pair);
            pair.approach_mps = speeds[i];
            pair.duration_s = 8;
            thud_two_body_set(&pair, "damping", variant & 1);
            thud_two_body_set(&pair, "unloading", variant >> 1 & 1);
            thud_two_body_set(&pair, "impact-speed", variant >> 2 & 1);
            struct thud_rubber_curve curve = thud_rubber_curve(0.36e3 * pow(1000, 2.65), 2.65, 0.04, 2.5e9);
            double d = thud_rubber_curve_indentation(&curve, 0.5 * 160e3 * speeds[i] * speeds[i]);
            struct thud_law_setup setup = pair.setup;
            setup.mass_kg = 160e3;
            ck_assert_int_eq(thud_law_prepare(pair.law, &setup, NULL), THUD_OK);
            struct outcome got = collide(&pair);
            ck_assert_double_eq_tol(got.indentation / d, 1, 1e-9);
            ck_assert_double_eq_tol(got.force / thud_rubber_curve_force(&curve, d), 1, 1e-8);
            ck_assert_double_eq_tol(got.restitution / thud_law_restitution(pair.law, &setup, speeds[i]), 1, 1e-7);
            ck_assert_double_lt(got.energy_error, 1e-8);
            ck_assert_double_eq(got.residual, 0);
        }
}
END_TEST

/* The study's figures, made by another solver. */
START_TEST(table_1)
{
    static const struct {
        bool rubber;
        double speed, damping, unloading, force_kn, indentation_mm, duration_ms, restitution, residual_mm;
    } row[] = {{false, 0.5, 0, 0, 8379.6, 3.1807, 22.850, 0.63229, 0.8118},
               {false, 1.0, 0, 0, 16759.2, 6.3613, 22.850, 0.63229, 1.6237},
               {true, 0.5, 0, 0, 2566.5, 28.443, 203.86, 0.50953, 0},
               {true, 1.0, 0, 0, 9643.6, 41.323, 148.07, 0.50177, 0},
               {true, 1.0, 1, 0, 9643.6, 41.323, 148.58, 0.49838, 0},
               {false, 0.5, 1, 0, 8281.8, 3.0984, 22.596, 0.60000, NAN},
               {true, 0.5, 1, 1, 2566.5, 28.443, 205.81, 0.50000, 0},
               {true, 1.0, 1, 1, 9643.6, 41.323, 146.80, 0.50000, 0}};
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        struct thud_two_body pair;
        if (row[i].rubber)
            thud_two_body_rubber(&pair);
        else
            thud_two_body_concrete(&pair);
        pair.approach_mps = row[i].speed;
        thud_two_body_set(&pair, "damping", row[i].damping);
        if (row[i].rubber)
            thud_two_body_set(&pair, "unloading", row[i].unloading);
        struct outcome got = collide(&pair);
        ck_assert_double_eq_tol(1e-3 * got.force / row[i].force_kn, 1, 1e-4);
        ck_assert_double_eq_tol(1e3 * got.indentation / row[i].indentation_mm, 1, 1e-4);
        ck_assert_double_eq_tol(1e3 * got.duration / row[i].duration_ms, 1, 1e-4);
        ck_assert_double_eq_tol(got.restitution, row[i].restitution, 1e-4);
        if (!isnan(row[i].residual_mm))
            ck_assert_double_eq_tol(1e3 * got.residual, row[i].residual_mm, 1e-4);
    }
}
END_TEST

/* Every law that has a force, at every mass ratio: the bodies part with the restitution that the law says it really
 * gives. */
START_TEST(every_law_tells_its_restitution)
{
    static const double ratios[] = {1, 1e3, 1e6};
    for (int i = 0; i < thud_law_count(); i++)
        for (size_t k = 0; k < sizeof ratios / sizeof *ratios; k++) {
            const struct thud_law *law = thud_law_at(i);
            if (law->flags & THUD_LAW_NO_FORCE)
                continue;
            struct thud_two_body pair;
            thud_two_body_concrete(&pair);
            pair.law = law;
            memset(&pair.setup, 0, sizeof pair.setup);
            thud_law_defaults(law, &pair.setup);
            pair.setup.thickness_m = 0.05;
            if (thud_law_param(law, "alpha") >= 0)
                thud_two_body_set(&pair, "stiffness", 0.36e3 * pow(1000, 2.65));
            pair.mass_kg[1] = 320e3 * ratios[k];
            pair.duration_s = 2;
            struct thud_law_setup setup = pair.setup;
            setup.mass_kg = pair.mass_kg[0] * pair.mass_kg[1] / (pair.mass_kg[0] + pair.mass_kg[1]);
            ck_assert_int_eq(thud_law_prepare(law, &setup, NULL), THUD_OK);
            struct outcome got = collide(&pair);
            ck_assert_msg(fabs(got.restitution - thud_law_restitution(law, &setup, 0.5)) < 1e-6,
                          "%s at %g: %.12g, not %.12g", law->name, ratios[k], got.restitution,
                          thud_law_restitution(law, &setup, 0.5));
            ck_assert_double_lt(got.energy_error, 1e-7);
        }
}
END_TEST

Suite *thud_suite(void)
{
    Suite *suite = suite_create("free pair");
    TCase *tc = tcase_create("free pair");
    tcase_set_timeout(tc, 60);
    tcase_add_test(tc, concrete_by_closed_form);
    tcase_add_test(tc, rubber_by_closed_form);
    tcase_add_test(tc, table_1);
    tcase_add_test(tc, every_law_tells_its_restitution);
    suite_add_tcase(suite, tc);
    return suite;
}
