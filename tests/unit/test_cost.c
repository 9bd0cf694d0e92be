/* What a run costs as its scene grows: the scenes are what they say they are (by closed forms and by runs made another
 * way), the fits find what was put in, and stopping keeps what is done.  Also the judge of the bench. */
#include <check.h>
#include <math.h>
#include <string.h>

#include "base/quantity.h"
#include "io/result/bench_rows.h"
#include "lab/bench/cost_jobs.h"
#include "towers.h"

static struct thud_scene scene;
static struct thud_record *record;

static void setup(void)
{
    thud_test_towers(&scene);
    scene.interface[0].has_bumper = false;
    record = thud_test_motion(1);
}

static void teardown(void)
{
    thud_record_free(record);
}

static struct thud_cost *cost_of(enum thud_cost_axis axis)
{
    struct thud_error err = {0};
    struct thud_cost *cost = NULL;
    ck_assert_msg(thud_cost_create(&scene, record, axis, &cost, &err) == THUD_OK, "%s", err.what);
    return cost;
}

static int size_at(struct thud_cost *cost, double size)
{
    int i = 0;
    while (i < thud_cost_count(cost) && fabs(thud_cost_point(cost, i)->size - size) > 1e-9)
        i++;
    ck_assert_int_lt(i, thud_cost_count(cost));
    return i;
}

static struct thud_model *model_of(struct thud_cost *cost, int i)
{
    struct thud_error err = {0};
    struct thud_model *model = NULL;
    ck_assert_msg(thud_cost_setup(cost, i, &model, &err) == THUD_OK, "%s", err.what);
    return model;
}

/* A chain of n equal storeys with half a mass on top: omega_j = 2 sqrt(k/m) sin((2 j - 1) pi / (4 n)). */
START_TEST(storeys_make_uniform_buildings)
{
    double m = scene.structure[0].mass_kg[0], k = scene.structure[0].stiffness_npm[0];
    for (int s = 0; s < 2; s++)
        scene.structure[s].mass_kg[scene.structure[s].storeys - 1] = m / 2;
    struct thud_cost *cost = cost_of(THUD_COST_STOREYS);
    static const int sizes[] = {2, 7, 50, 200};
    for (int i = 0; i < 4; i++) {
        int n = sizes[i];
        struct thud_model *model = model_of(cost, size_at(cost, n));
        ck_assert_int_eq(model->ndof, 2 * n);
        ck_assert_int_eq(model->ncontacts, n);
        for (int j = 0; j < n; j++) {
            double omega = 2 * sqrt(k / m) * sin((2 * j + 1) * THUD_PI / (4 * n));
            ck_assert_double_eq_tol(model->omega[j], omega, 1e-9 * omega + 1e-7);
            ck_assert_double_eq_tol(model->omega[n + j], sqrt(0.7) * omega, 1e-9 * omega + 1e-7);
        }
        thud_model_free(model);
    }
    thud_cost_free(cost);
}
END_TEST

START_TEST(buildings_stand_in_a_row)
{
    struct thud_cost *cost = cost_of(THUD_COST_BUILDINGS);
    struct thud_model *model = model_of(cost, size_at(cost, 5));
    ck_assert_int_eq(model->nstructures, 5);
    ck_assert_int_eq(model->ndof, 4 + 6 + 4 + 6 + 4);
    ck_assert_int_eq(model->ncontacts, 4 * 4);
    thud_model_free(model);
    thud_cost_free(cost);
}
END_TEST

static void run_all(struct thud_cost *cost, struct thud_bench_jobs jobs)
{
    struct thud_error err = {0};
    ck_assert_msg(thud_cost_jobs_run(cost, &jobs, &err) == THUD_OK, "%s", err.what);
}

/* The first of the row, and the motion once, are the scene itself; twice the motion is what a record of twice the
 * length gives. */
START_TEST(sizes_are_the_runs_they_say)
{
    struct thud_run_options options;
    struct thud_solution solution;
    struct thud_record *twice = NULL;
    struct thud_error err = {0};
    double a[20000];
    size_t n = record->samples;
    ck_assert(2 * n <= sizeof a / sizeof *a);
    memcpy(a, record->a_mps2, n * sizeof *a);
    memcpy(a + n, record->a_mps2, n * sizeof *a);
    ck_assert(thud_record_create(a, 2 * n, record->dt_s, &twice, &err) == THUD_OK);
    ck_assert(thud_scene_options(&scene, &options, &err) == THUD_OK);
    struct thud_cost *cost = cost_of(THUD_COST_DURATION);
    run_all(cost, (struct thud_bench_jobs){.repeats = 1});
    for (int i = 0; i < 2; i++) {
        ck_assert(thud_scene_solve(&scene, i ? twice : record, &options, &solution, &err) == THUD_OK);
        const struct thud_result *r = thud_run_result(solution.run);
        const struct thud_cost_point *p = thud_cost_point(cost, i);
        int impacts = 0;
        for (int c = 0; c < r->ncontacts; c++)
            impacts += r->contact[c].impacts;
        ck_assert_int_eq(p->state, THUD_COST_DONE);
        ck_assert_int_gt(impacts, 0);
        ck_assert_int_eq(p->impacts, impacts);
        ck_assert_int_eq(p->work.steps, r->work.steps);
        ck_assert_double_eq_tol(p->size, (i + 1) * (double)n * record->dt_s, 1e-9);
        ck_assert(p->repeats == 1);
        thud_solution_clear(&solution);
    }
    thud_record_free(twice);
    thud_cost_free(cost);
}
END_TEST

START_TEST(impacts_come_with_narrow_gaps)
{
    struct thud_cost *cost = cost_of(THUD_COST_IMPACTS);
    run_all(cost, (struct thud_bench_jobs){.repeats = 1});
    int last = thud_cost_count(cost) - 1;
    ck_assert_int_eq(thud_cost_point(cost, 0)->impacts, 0); /* a metre apart */
    ck_assert_double_eq_tol(thud_cost_point(cost, last)->clearance_m, 0, 1e-15);
    ck_assert_int_gt(thud_cost_point(cost, last)->impacts, 10);
    struct thud_cost_fit fit = thud_cost_fit(cost, THUD_COST_STEPS);
    ck_assert(!fit.power && fit.points == last + 1 && fit.b > 0);
    thud_cost_free(cost);
}
END_TEST

START_TEST(fits_find_what_was_put_in)
{
    struct thud_cost *cost = cost_of(THUD_COST_STOREYS);
    int n = thud_cost_count(cost);
    ck_assert_int_eq(thud_cost_fit(cost, THUD_COST_TIME).points, 0);
    for (int i = 0; i < n; i++) {
        struct thud_cost_point *p = thud_cost_point(cost, i);
        p->state = THUD_COST_DONE;
        p->seconds = 3e-6 * pow(p->size, 1.75);
        if (p->size < 10) /* what is fixed at small sizes does not bend the slope */
            p->seconds += 1;
    }
    struct thud_cost_fit fit = thud_cost_fit(cost, THUD_COST_TIME);
    ck_assert(fit.power);
    ck_assert_double_eq_tol(fit.b, 1.75, 1e-12);
    ck_assert_double_eq_tol(fit.a, 3e-6, 1e-15);
    ck_assert_double_eq_tol(fit.from, 15, 1e-12);
    thud_cost_free(cost);
    cost = cost_of(THUD_COST_IMPACTS);
    for (int i = 0; i < n; i++) {
        struct thud_cost_point *p = thud_cost_point(cost, i);
        p->state = THUD_COST_DONE;
        p->size = 7 * i;
        p->seconds = 2e-3 + 5e-5 * p->size;
    }
    fit = thud_cost_fit(cost, THUD_COST_TIME);
    ck_assert(!fit.power);
    ck_assert_double_eq_tol(fit.a, 2e-3, 1e-12);
    ck_assert_double_eq_tol(fit.b, 5e-5, 1e-12);
    thud_cost_free(cost);
}
END_TEST

struct stopper {
    atomic_int flag;
    int at;
};

static void stop_at(void *context, const char *what, int done, int count)
{
    struct stopper *stopper = context;
    ck_assert_str_eq(what, "storeys");
    ck_assert_int_lt(done, count);
    stopper->flag = done == stopper->at;
}

START_TEST(stopping_keeps_what_is_done)
{
    struct stopper stopper = {.at = 3};
    struct thud_bench_jobs jobs = {.repeats = 1, .cancel = &stopper.flag, .context = &stopper, .progress = stop_at};
    struct thud_cost *cost = cost_of(THUD_COST_STOREYS);
    struct thud_text csv = {0}, table = {0};
    ck_assert_int_eq(thud_cost_jobs_run(cost, &jobs, NULL), THUD_CANCELLED);
    for (int i = 0; i < thud_cost_count(cost); i++)
        ck_assert_int_eq(thud_cost_point(cost, i)->state, i < 3 ? THUD_COST_DONE : THUD_COST_WAITING);
    const struct thud_rows rows = thud_cost_rows(cost);
    thud_rows_csv(&rows, &csv);
    thud_cost_table(cost, &table);
    struct thud_figure *figure = thud_cost_figure(cost, "stopped");
    ck_assert_int_eq(thud_figure_check(figure, NULL), THUD_OK);
    ck_assert_ptr_nonnull(strstr(csv.data, "200,0.1,not-run"));
    ck_assert_ptr_nonnull(strstr(table.data, "no slope: too few sizes"));
    thud_figure_free(figure);
    thud_text_clear(&csv);
    thud_text_clear(&table);
    thud_cost_free(cost);
}
END_TEST

START_TEST(patience_passes_over_the_rest)
{
    struct thud_cost *cost = cost_of(THUD_COST_BUILDINGS);
    run_all(cost, (struct thud_bench_jobs){.repeats = 1, .patience_s = 1e-9});
    for (int i = 0; i < thud_cost_count(cost); i++)
        ck_assert_int_eq(thud_cost_point(cost, i)->state, i < 2 ? THUD_COST_DONE : THUD_COST_SKIPPED);
    thud_cost_free(cost);
}
END_TEST

START_TEST(what_cannot_grow_is_said)
{
    struct thud_cost *cost;
    struct thud_error err = {0};
    enum thud_cost_axis axis;
    ck_assert_int_eq(thud_cost_create(&scene, NULL, THUD_COST_DURATION, &cost, &err), THUD_INPUT);
    scene.structure[1].kind = THUD_RIGID;
    ck_assert_int_eq(thud_cost_create(&scene, record, THUD_COST_STOREYS, &cost, &err), THUD_INPUT);
    scene.nstructures = 1;
    ck_assert_int_eq(thud_cost_create(&scene, record, THUD_COST_IMPACTS, &cost, &err), THUD_INPUT);
    ck_assert_int_eq(thud_cost_axis_find("floors", &axis, &err), THUD_USAGE);
    for (int i = 0; i < THUD_COST_AXES; i++) {
        const char *name = thud_cost_axis_info((enum thud_cost_axis)i)->name;
        ck_assert_int_eq(thud_cost_axis_find(name, &axis, &err), THUD_OK);
        ck_assert_int_eq((int)axis, i);
        thud_cost_axis_find("floors", &axis, &err);
        ck_assert_ptr_nonnull(strstr(err.allowed, name));
    }
}
END_TEST

/* The exact method is judged by the independent one: its error is no mere zero, and what it differs by is what the
 * reference is trusted to. */
START_TEST(no_method_is_its_own_judge)
{
    const struct thud_method *exact = thud_method_find("exact");
    struct thud_bench *bench;
    struct thud_bench_jobs jobs = {.repeats = 1};
    struct thud_error err = {0};
    ck_assert(thud_bench_create(&scene, record, false, &bench, &err) == THUD_OK);
    int all = thud_bench_count(bench);
    thud_bench_only(bench, &exact, 1);
    int count = thud_bench_count(bench);
    ck_assert(count > 0 && count < all);
    ck_assert(thud_bench_jobs_run(bench, &jobs, &err) == THUD_OK);
    double trust = thud_bench_reference_error(bench);
    ck_assert(trust > 0 && trust < 1e-9);
    for (int i = 0; i < count; i++) {
        const struct thud_bench_point *p = thud_bench_point(bench, i);
        ck_assert_ptr_eq(p->method, exact);
        ck_assert(p->error.all > 0 && p->error.all < 2 * trust); /* concrete: no tolerance in it */
    }
    thud_bench_free(bench);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("cost");
    TCase *tc = tcase_create("cost");
    tcase_add_checked_fixture(tc, setup, teardown);
    tcase_add_test(tc, storeys_make_uniform_buildings);
    tcase_add_test(tc, buildings_stand_in_a_row);
    tcase_add_test(tc, sizes_are_the_runs_they_say);
    tcase_add_test(tc, impacts_come_with_narrow_gaps);
    tcase_add_test(tc, fits_find_what_was_put_in);
    tcase_add_test(tc, stopping_keeps_what_is_done);
    tcase_add_test(tc, patience_passes_over_the_rest);
    tcase_add_test(tc, what_cannot_grow_is_said);
    tcase_add_test(tc, no_method_is_its_own_judge);
    suite_add_tcase(suite, tc);
    return suite;
}
