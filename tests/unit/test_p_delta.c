/* P-Delta: periods and motions in closed form, collapse on a negative slope, energy with the work of the weight, and
 * what other methods and studies make of it. */
#include <check.h>
#include <math.h>
#include <string.h>

#include "base/quantity.h"
#include "march.h"
#include "remarks.h"
#include "study/scene/solution.h"
#include "study/sweep/remark.h"
#include "suite.h"

static const double mass_kg = 100e3, height_m = 3;

struct one {
    double omega, theta, zeta, yield_m, hardening, velocity_mps;
};

/* A storey of stiffness k on the ground, with W = theta k h above it. */
static struct thud_model *oscillator(const struct one *o)
{
    double k = mass_kg * o->omega * o->omega, geometric = o->theta * k, collapse = 0.1 * height_m;
    struct thud_structure_input s = {.n = 1,
                                     .mass_kg = &mass_kg,
                                     .stiffness_npm = &k,
                                     .damping = o->zeta,
                                     .velocity_mps = o->velocity_mps,
                                     .yield_m = o->yield_m > 0 ? &o->yield_m : NULL,
                                     .hardening = o->yield_m > 0 ? &o->hardening : NULL,
                                     .geometric_npm = &geometric,
                                     .collapse_m = &collapse};
    struct thud_model *model = NULL;
    ck_assert_int_eq(thud_model_create(&(struct thud_model_input){.nstructures = 1, .structure = &s}, &model, NULL),
                     THUD_OK);
    return model;
}

START_TEST(period_of_an_oscillator)
{
    static const double theta[] = {0.01, 0.1, 0.3, 0.9};
    const struct one o = {.omega = 12, .theta = theta[_i], .velocity_mps = 0.5};
    struct thud_model *model = oscillator(&o);
    struct march m = march_run(model, NULL, "exact", 0, 1e-6, true, 3);
    const double period = 2 * THUD_PI / o.omega / sqrt(1 - o.theta), net = 2 * THUD_PI / period,
                 k = mass_kg * o.omega * o.omega, most = o.velocity_mps / net;
    ck_assert_double_eq_tol(m.result->structure[0].period_s[0] / period, 1, 1e-14);
    ck_assert_double_eq_tol(march_displacement(&m, 0), most * sin(3 * net), 1e-13);
    /* the storey bears k d, more than what decelerates the mass */
    ck_assert_double_eq_tol(m.result->structure[0].base_shear.value / (k * most), 1, 1e-12);
    double d = march_displacement(&m, 0), v = march_velocity(&m, 0);
    const struct thud_energy *e = &m.result->energy;
    ck_assert_double_eq_tol(e->strain_j, 0.5 * k * d * d, 1e-9 * k * d * d);
    ck_assert_double_eq_tol(e->gravity_j, 0.5 * o.theta * k * d * d, 1e-9 * k * d * d);
    ck_assert_double_eq_tol(e->kinetic_j, 0.5 * mass_kg * v * v, 1e-9 * e->initial_j);
    ck_assert_double_lt(e->error_ratio, 1e-13);
    march_free(&m);
    thud_model_free(model);
}
END_TEST

/* Thrown beyond yield, where the slope is r k - W/h < 0: d - d* goes with cosh and sinh about the drift d* at which the
 * yield force and the weight would balance, and comes to a tenth of the height. */
static double falls_at(const struct one *o, double *velocity)
{
    const double k = o->omega * o->omega, net = sqrt(k * (1 - o->theta)), v0 = o->velocity_mps; /* per mass */
    const double t1 = asin(net * o->yield_m / v0) / net, v1 = v0 * cos(net * t1);
    const double lambda = sqrt(k * (o->theta - o->hardening)),
                 rest = (1 - o->hardening) * k * o->yield_m / (lambda * lambda), from = o->yield_m - rest,
                 to = 0.1 * height_m - rest;
    double low = 0, high = 20 / lambda;
    for (int i = 0; i < 200; i++) {
        double t = 0.5 * (low + high), d = from * cosh(lambda * t) + v1 / lambda * sinh(lambda * t);
        if (d < to)
            low = t;
        else
            high = t;
    }
    *velocity = from * lambda * sinh(lambda * low) + v1 * cosh(lambda * low);
    return t1 + low;
}

START_TEST(falls_on_a_negative_slope)
{
    static const double hardening[] = {0, 0.05, 0.15};
    const struct one o = {.omega = 8, .theta = 0.2, .yield_m = 0.03, .hardening = hardening[_i], .velocity_mps = 1.5};
    struct thud_model *model = oscillator(&o);
    struct march m = march_run(model, NULL, "exact", 0, 1e-6, true, 5);
    double velocity, time_s = falls_at(&o, &velocity);
    const struct thud_collapse *c = &m.result->collapse;
    ck_assert_int_eq(m.status, THUD_OK);
    ck_assert(c->happened);
    ck_assert_int_eq(c->structure, 0);
    ck_assert_int_eq(c->floor, 0);
    ck_assert_double_eq_tol(c->time_s, time_s, 1e-11);
    ck_assert_double_eq_tol(m.result->end_s, time_s, 1e-11);
    ck_assert_double_eq_tol(c->drift_m, 0.3, 1e-15);
    ck_assert_double_eq_tol(m.result->structure[0].floor[0].drift.value, 0.3, 1e-13);
    ck_assert_double_eq_tol(march_velocity(&m, 0), velocity, 1e-10);
    ck_assert_double_lt(m.result->energy.error_ratio, 1e-12);
    const double k = mass_kg * o.omega * o.omega, plastic = 0.3 - o.yield_m;
    ck_assert_double_eq_tol(m.result->energy.gravity_j / (0.5 * o.theta * k * 0.09), 1, 1e-12);
    ck_assert_double_eq_tol(m.result->energy.hysteretic_j / ((1 - o.hardening) * k * o.yield_m * plastic), 1, 1e-12);
    march_free(&m);
    /* another method that locates events, and one that sees them at the ends of its steps */
    m = march_run(model, NULL, "dormand-prince", 0, 1e-11, true, 5);
    ck_assert(m.result->collapse.happened);
    ck_assert_double_eq_tol(m.result->collapse.time_s, time_s, 1e-8);
    march_free(&m);
    m = march_run(model, NULL, "newmark", 1e-4, 0, false, 5);
    ck_assert(m.result->collapse.happened);
    ck_assert_double_eq_tol(m.result->collapse.time_s, time_s, 3e-4);
    march_free(&m);
    thud_model_free(model);
}
END_TEST

/* Not thrown so far that the weight wins, it turns before d*, comes to rest to one side and stands. */
START_TEST(stands_below_the_balance)
{
    const struct one o = {.omega = 8, .theta = 0.2, .zeta = 0.05, .yield_m = 0.03, .velocity_mps = 0.4};
    struct thud_model *model = oscillator(&o);
    struct march m = march_run(model, NULL, "exact", 0, 1e-6, true, 60);
    const struct thud_storey_result *r = &m.result->structure[0].storey[0];
    ck_assert(!m.result->collapse.happened);
    ck_assert_double_gt(r->plastic_m, 0);
    ck_assert_double_eq_tol(m.result->end_s, 60, 1e-9);
    /* at rest k (d - d_p) = W d/h */
    ck_assert_double_eq_tol(r->permanent_m, r->plastic_m / (1 - o.theta), 1e-14);
    ck_assert_double_eq_tol(march_displacement(&m, 0), r->permanent_m, 1e-8);
    march_free(&m);
    thud_model_free(model);
}
END_TEST

/* An elastic storey too collapses at a tenth of its height; just below it swings on. */
START_TEST(elastic_storeys_collapse)
{
    struct one o = {.omega = 3, .theta = 0.5, .velocity_mps = 2};
    const double net = o.omega * sqrt(1 - o.theta), reach = 0.3 * net;
    struct thud_model *model = oscillator(&o);
    struct march m = march_run(model, NULL, "exact", 0, 1e-6, true, 60);
    ck_assert(m.result->collapse.happened);
    ck_assert_double_eq_tol(m.result->collapse.time_s, asin(reach / o.velocity_mps) / net, 1e-12);
    ck_assert_double_eq_tol(m.result->end_s, m.result->collapse.time_s, 1e-15);
    ck_assert_double_eq_tol(m.result->structure[0].floor[0].drift.value, 0.3, 1e-13);
    march_free(&m);
    m = march_run(model, NULL, "newmark", 1e-3, 0, false, 60); /* at the end of the first step behind it */
    ck_assert(m.result->collapse.happened);
    ck_assert_double_eq_tol(m.result->collapse.time_s, asin(reach / o.velocity_mps) / net, 1.1e-3);
    ck_assert_double_eq_tol(m.result->end_s, m.result->collapse.time_s, 1e-12);
    march_free(&m);
    thud_model_free(model);
    for (int below = 0; below < 2; below++) {
        o.velocity_mps = reach * (below ? 1 - 1e-9 : 1 + 1e-9);
        model = oscillator(&o);
        m = march_run(model, NULL, "exact", 0, 1e-6, true, 60);
        ck_assert(m.result->collapse.happened != below);
        march_free(&m);
        thud_model_free(model);
    }
}
END_TEST

static void two_storeys(struct thud_scene *scene)
{
    thud_scene_init(scene);
    strcpy(scene->name, "drawn");
    scene->nstructures = 1;
    thud_structure_init(&scene->structure[0], THUD_SHEAR);
    strcpy(scene->structure[0].name, "A");
    ck_assert_int_eq(thud_scene_set(scene, "structures.1.storeys", "2", NULL), THUD_OK);
    ck_assert_int_eq(thud_scene_set(scene, "structures.1.mass", "[200 t, 100 t]", NULL), THUD_OK);
    ck_assert_int_eq(thud_scene_set(scene, "structures.1.stiffness", "20 MN/m", NULL), THUD_OK);
}

/* The model of a scene has W/h of all the floors above, by their masses or by what hangs on them; the coefficient of the
 * table is that of the storey itself; a storey that cannot bear its weight is refused. */
START_TEST(weights_of_a_scene)
{
    static struct thud_scene scene;
    struct thud_model *model;
    struct thud_error err = {0};
    two_storeys(&scene);
    ck_assert_int_eq(thud_scene_set(&scene, "p-delta", "yes", NULL), THUD_OK);
    ck_assert_int_eq(thud_scene_assemble(&scene, &model, NULL), THUD_OK);
    ck_assert_double_eq_tol(model->structure[0].geometric_npm[0], 300e3 * THUD_GRAVITY / 3, 1e-6);
    ck_assert_double_eq_tol(model->structure[0].geometric_npm[1], 100e3 * THUD_GRAVITY / 3, 1e-6);
    thud_model_free(model);
    ck_assert_int_eq(thud_scene_set(&scene, "structures.1.gravity", "[6 MN, 3 MN]", NULL), THUD_OK);
    ck_assert_int_eq(thud_scene_assemble(&scene, &model, NULL), THUD_OK);
    ck_assert_double_eq_tol(model->structure[0].geometric_npm[0], 3e6, 1e-6);
    /* K - K_G by hand: 17 and 19 MN/m, 200 and 100 t */
    const double a = (17e6 + 19e6) / 200e3, c = 19e6 / 100e3, b2 = 19e6 * 19e6 / (200e3 * 100e3);
    const double low = 0.5 * (a + c) - sqrt(0.25 * (a - c) * (a - c) + b2);
    ck_assert_double_eq_tol(model->structure[0].omega[0], sqrt(low), 1e-12);
    thud_model_free(model);
    ck_assert_int_eq(thud_scene_check(&scene, &err), THUD_OK);
    ck_assert_int_eq(thud_scene_set(&scene, "structures.1.gravity.2", "57.1 MN", NULL), THUD_OK);
    ck_assert_int_eq(thud_scene_check(&scene, &err), THUD_INPUT);
    ck_assert_str_eq(err.key, "structures.1.stiffness.1");
    ck_assert_ptr_nonnull(strstr(err.what, "buckles under its own weight"));
    ck_assert_int_eq(thud_scene_set(&scene, "p-delta", "no", NULL), THUD_OK);
    ck_assert_int_eq(thud_scene_check(&scene, &err), THUD_OK);
}
END_TEST

/* A building thrown to one side: with its weight it goes further, and theta, which was a remark, is part of the result. */
START_TEST(theta_is_remarked_without)
{
    static struct thud_scene scene;
    for (int with = 0; with < 2; with++) {
        struct thud_solution solution;
        struct thud_error remark = {0};
        bool found = false;
        two_storeys(&scene);
        scene.structure[0].gravity_n[0] = scene.structure[0].gravity_n[1] = 4e6;
        scene.p_delta = with == 1;
        scene.analysis.tail_s = 2;
        double a[] = {0, 1, 0, -1, 0};
        struct thud_record *record;
        ck_assert_int_eq(thud_record_create(a, 5, 0.1, &record, NULL), THUD_OK);
        strcpy(scene.record.file, "drawn");
        ck_assert_int_eq(thud_scene_solve(&scene, record, NULL, &solution, NULL), THUD_OK);
        const struct thud_result *r = thud_run_result(solution.run);
        ck_assert_double_eq_tol(thud_stability_coefficient(&scene.structure[0], &r->structure[0], 0), 8.0 / 60, 1e-12);
        const struct thud_remark_scope scope = {.scene = &scene, .result = r};
        for (int i = 0; nth_remark(&scope, THUD_REMARK_RESULT, i, &remark); i++)
            found = found || strstr(remark.what, "stability coefficient");
        ck_assert(found == (with == 0));
        ck_assert_double_eq(r->energy.gravity_j > 0, with);
        thud_solution_clear(&solution);
        thud_record_free(record);
    }
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("p-delta");
    TCase *tcase = tcase_create("p-delta");
    tcase_add_loop_test(tcase, period_of_an_oscillator, 0, 4);
    tcase_add_loop_test(tcase, falls_on_a_negative_slope, 0, 3);
    tcase_add_test(tcase, stands_below_the_balance);
    tcase_add_test(tcase, elastic_storeys_collapse);
    tcase_add_test(tcase, weights_of_a_scene);
    tcase_add_test(tcase, theta_is_remarked_without);
    suite_add_tcase(suite, tcase);
    return suite;
}
