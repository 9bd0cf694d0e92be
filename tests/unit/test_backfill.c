/* Soil behind a wall: loading, unloading and reloading in closed form, a light stiff wall against one that moves with
 * the ground, and another method with the ledger. */
#include <check.h>
#include <math.h>

#include "march.h"

static const double k_max = 3e8, f_ult = 5e6, r_f = 0.7;

static double curve(double x)
{
    return x / (1 / k_max + r_f * x / f_ult);
}

/* Its work, the integral of the curve. */
static double work(double x)
{
    const double a = 1 / k_max, b = r_f / f_ult;
    return x / b - a / (b * b) * log1p(b * x / a);
}

static struct thud_law_setup soil_setup(void)
{
    struct thud_law_setup setup = {.mass_kg = 1, .value = {k_max, f_ult, r_f}};
    ck_assert_int_eq(thud_law_prepare(&thud_law_backfill, &setup, NULL), THUD_OK);
    return setup;
}

static double force_at(const struct thud_law_setup *setup, const struct thud_law_memory *memory, enum thud_phase phase,
                       double d)
{
    const struct thud_branch b = thud_law_branch_at(&thud_law_backfill, setup, memory, phase, d);
    return thud_branch_force(&b, d, 0, NULL, NULL);
}

/* In, out to a force, in again past where it was, out to nothing, and a second contact from the gap on. */
START_TEST(loops_in_closed_form)
{
    const struct thud_law_setup setup = soil_setup();
    const double first = 0.02, second = 0.05, third = 0.07, left = second - curve(second) / k_max, near = 1e-12 * f_ult;
    struct thud_law_memory memory = {0};
    thud_law_onset(&thud_law_backfill, &setup, 1, &memory);
    ck_assert_double_eq_tol(force_at(&setup, &memory, THUD_APPROACH, first), curve(first), near);
    thud_law_reversal(&thud_law_backfill, &setup, THUD_RESTITUTION, first, &memory);
    const double half = first - 0.5 * curve(first) / k_max;
    ck_assert_double_eq_tol(force_at(&setup, &memory, THUD_RESTITUTION, half), 0.5 * curve(first), near);
    thud_law_reversal(&thud_law_backfill, &setup, THUD_APPROACH, half, &memory);
    ck_assert_double_eq_tol(force_at(&setup, &memory, THUD_APPROACH, half), 0.5 * curve(first), near);
    ck_assert_double_eq(thud_law_ultimate(&thud_law_backfill, &setup, &memory, THUD_APPROACH), first);
    ck_assert_double_eq_tol(force_at(&setup, &memory, THUD_APPROACH, second), curve(second), near);
    thud_law_reversal(&thud_law_backfill, &setup, THUD_RESTITUTION, second, &memory);
    ck_assert_double_eq_tol(force_at(&setup, &memory, THUD_RESTITUTION, left), 0, near);
    ck_assert_double_eq_tol(thud_law_energy(&thud_law_backfill, &setup, &memory, THUD_RESTITUTION, second),
                            0.5 * curve(second) * curve(second) / k_max, 1e-6);
    thud_law_onset(&thud_law_backfill, &setup, 1, &memory); /* beyond the gap that it has left */
    ck_assert_double_eq_tol(force_at(&setup, &memory, THUD_APPROACH, 1e-3), 1e-3 * k_max, near);
    ck_assert_double_eq_tol(force_at(&setup, &memory, THUD_APPROACH, third - left), curve(third), near);
}
END_TEST

/* A body thrown into the soil comes to rest where its work is done, and leaves with what K_max gives back; thrown in
 * anew by a link's pull it would find the gap: its size is exact. */
START_TEST(a_body_thrown_into_the_soil)
{
    const double m = 2e5, v = 2;
    const struct thud_structure_input s[] = {{.n = 1, .mass_kg = &m, .velocity_mps = v}, {.n = 0}};
    const struct thud_link_input soil = {.left_floor = 1,
                                         .right_structure = 1,
                                         .law = &thud_law_backfill,
                                         .setup.value = {k_max, f_ult, r_f},
                                         .clearance_m = 0.01};
    struct thud_model *model = NULL;
    const struct thud_model_input input = {.nstructures = 2, .structure = s, .nlinks = 1, .link = &soil};
    ck_assert_int_eq(thud_model_create(&input, &model, NULL), THUD_OK);
    struct march a = march_run(model, NULL, _i ? "dormand-prince" : "exact", 0, 1e-11, true, 0.5);
    double x = 0.01;
    for (int i = 0; i < 60; i++) /* Newton: the work is the motion's */
        x -= (work(x) - 0.5 * m * v * v) / curve(x);
    const double back = 0.5 * curve(x) * curve(x) / k_max, lost = 0.5 * m * v * v - back;
    ck_assert_int_eq(a.status, THUD_OK);
    ck_assert_double_eq_tol(a.result->link[0].stroke.value, x, 1e-9 * x);
    ck_assert_double_eq_tol(a.result->link[0].force.value, curve(x), 1e-9 * curve(x));
    ck_assert_double_eq_tol(a.result->link[0].lost_j, lost, 1e-8 * lost);
    ck_assert_double_eq_tol(march_velocity(&a, 0), -sqrt(2 * back / m), 1e-8 * v);
    ck_assert_double_eq_tol(a.result->contact[0].residual_m, x - curve(x) / k_max, 1e-9 * x);
    ck_assert_double_lt(a.result->energy.error_ratio, 1e-10);
    march_free(&a);
    thud_model_free(model);
}
END_TEST

/* An oscillator beside a wall of this mass, stiffness and soil; mass 0: it moves with the ground. */
static struct thud_model *beside_wall(double wall_kg, double wall_npm, bool soil)
{
    static const double mass = 3e5, stiffness = 1.2e7;
    const struct march_law law =
        soil ? march_law("kelvin-voigt-no-tension", "stiffness", 2.5e8, "restitution", 0.6, NULL)
             : march_law("linear", "stiffness", 2.5e8, NULL);
    const struct thud_structure_input s[] = {
        {.n = 1, .mass_kg = &mass, .stiffness_npm = &stiffness, .damping = 0.1},
        {.n = wall_kg > 0, .mass_kg = &wall_kg, .stiffness_npm = &wall_npm, .damping = 0.05}};
    const struct thud_contact_input contact = {.interface = 1,
                                               .left_floor = 1,
                                               .right_floor = wall_kg > 0,
                                               .right_structure = 1,
                                               .clearance_m = 0.02,
                                               .law = law.law,
                                               .setup = law.setup};
    const struct thud_link_input link = {.left_structure = 1,
                                         .left_floor = 1,
                                         .right_structure = 1,
                                         .law = &thud_law_backfill,
                                         .setup.value = {k_max, f_ult, r_f}};
    struct thud_model *model = NULL;
    const struct thud_model_input input = {
        .nstructures = 2, .structure = s, .ncontacts = 1, .contact = &contact, .nlinks = soil, .link = &link};
    ck_assert_int_eq(thud_model_create(&input, &model, NULL), THUD_OK);
    return model;
}

/* The stiffer and lighter the wall, the more it is one that moves with the ground. (The dashpot of a viscous law goes
 * with the effective mass, so that beside a light wall it is another one.) */
START_TEST(a_light_stiff_wall)
{
    struct thud_record *record = march_motion(1);
    struct thud_model *rigid = beside_wall(0, 0, false);
    struct march b = march_run(rigid, record, "exact", 0, 0, true, 1);
    double before = INFINITY;
    ck_assert_int_gt(b.result->contact[0].impacts, 0);
    for (double k = 1e10; k < 1e13; k *= 100) {
        struct thud_model *model = beside_wall(100, k, false);
        struct march a = march_run(model, record, "exact", 0, 0, true, 1);
        const double apart = fabs(a.result->contact[0].force.value / b.result->contact[0].force.value - 1);
        ck_assert_double_lt(apart, 0.1 * before);
        before = apart;
        march_free(&a);
        thud_model_free(model);
    }
    ck_assert_double_lt(before, 1e-3);
    march_free(&b);
    thud_model_free(rigid);
    thud_record_free(record);
}
END_TEST

/* Struck again and again, so that the soil is loaded, left, met and loaded further. */
START_TEST(against_dormand_prince)
{
    struct thud_record *record = march_motion(1);
    struct thud_model *model = beside_wall(3e4, 4e7, true);
    struct march a = march_run(model, record, "exact", 0, 1e-9, true, 1),
                 b = march_run(model, record, "dormand-prince", 0, 1e-11, true, 1);
    ck_assert_int_eq(a.status, THUD_OK);
    ck_assert_int_eq(b.status, THUD_OK);
    ck_assert_int_gt(a.result->link[0].engaged, 3);
    ck_assert_int_eq(a.result->link[0].engaged, b.result->link[0].engaged);
    ck_assert_double_gt(a.result->link[0].lost_j, 0);
    ck_assert_double_lt(march_peaks_apart(a.result, b.result, 0.01), 1e-7);
    ck_assert_double_eq_tol(a.result->link[0].lost_j, b.result->link[0].lost_j, 1e-7 * b.result->link[0].lost_j);
    ck_assert_double_lt(a.result->energy.error_ratio, 1e-9);
    ck_assert_double_lt(b.result->energy.error_ratio, 1e-10);
    march_free(&a);
    march_free(&b);
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("backfill");
    TCase *tcase = tcase_create("backfill");
    tcase_add_test(tcase, loops_in_closed_form);
    tcase_add_loop_test(tcase, a_body_thrown_into_the_soil, 0, 2);
    tcase_add_test(tcase, a_light_stiff_wall);
    tcase_add_test(tcase, against_dormand_prince);
    suite_add_tcase(suite, tcase);
    return suite;
}
