/* A study's point with its spread, its table, and what more runs tell of a result, while one allocation after the
 * other fails: out of memory is said, or the result is the same without what was missing; nothing is left behind. */
#include <check.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../unit/sweep_rows.h"
#include "../unit/towers.h"
#include "app/sweep/sweep_study_private.h"
#include "fault.h"
#include "study/methods/truncation.h"
#include "study/sweep/sweep.h"

enum { SAMPLES = 120, ROWS = 24 };

static struct thud_scene *scene;
static struct thud_record *motion;
static struct thud_sweep_plan *plan;
static const struct thud_record *records[1];

static void set_up(void)
{
    double ground[SAMPLES];
    for (int i = 0; i < SAMPLES; i++)
        ground[i] = 7 * sin(0.02 * i * 9);
    scene = malloc(sizeof *scene);
    plan = malloc(sizeof *plan);
    thud_test_towers(scene);
    scene->structure[0].storeys = 2;
    scene->structure[1].storeys = 3;
    scene->structure[1].stiffness_npm[0] = 200e6;
    scene->interface[0].gap_m = 0.06;
    scene->analysis.tail_s = 0.2;
    ck_assert_int_eq(thud_record_create(ground, SAMPLES, 0.02, &motion, NULL), THUD_OK);
    records[0] = motion;
    thud_sweep_plan_init(plan, scene);
    plan->record = records;
    plan->nrecords = 1;
    plan->sensitivity = 1e-3;
    ck_assert_int_eq(thud_sweep_cases(plan, "none,bumper,as-written", NULL), THUD_OK);
}

static void tear_down(void)
{
    thud_sweep_plan_clear(plan);
    thud_record_free(motion);
    free(plan);
    free(scene);
}

/* Every allocation at first, then every seventh: later ones repeat themselves from run to run. */
static long after(long n)
{
    return n + (n < 80 ? 1 : 7);
}

static enum thud_status make_point(struct thud_sweep_point **point)
{
    struct thud_sweep_group *group = NULL;
    struct thud_sweep_task *task = NULL;
    enum thud_status status = thud_sweep_group_create(plan, 0, &group, NULL);
    for (bool done = false; status == THUD_OK && !done;)
        status = thud_sweep_group_advance(group, 100, &done, NULL);
    if (status == THUD_OK)
        status = thud_sweep_task_create(plan, group, 0, &task, NULL);
    if (status == THUD_OK)
        thud_sweep_task_leave(task, 0, 1);
    for (bool done = false; status == THUD_OK && !done;)
        status = thud_sweep_task_advance(task, 100, &done, NULL);
    *point = status == THUD_OK ? thud_sweep_task_take(task) : NULL;
    if (*point)
        status = thud_sweep_group_settle(group, *point, NULL);
    if (status != THUD_OK) {
        free(*point);
        *point = NULL;
    }
    thud_sweep_task_free(task);
    thud_sweep_group_free(group);
    return status;
}

START_TEST(a_point_with_its_spread)
{
    struct thud_sweep_point *whole, *point;
    static struct thud_sweep_row wanted[ROWS], row[ROWS];
    ck_assert_int_eq(make_point(&whole), THUD_OK);
    int rows = sweep_rows(whole, wanted);
    ck_assert_int_eq(rows, 3 * (3 + 4));
    ck_assert_int_gt(whole->changed.made, 6);
    long n = 0;
    for (bool fired = true; fired;) {
        long live = thud_fault_live();
        n = after(n);
        thud_fault_arm(THUD_FAULT_MEMORY, n);
        enum thud_status status = make_point(&point);
        fired = thud_fault_end();
        ck_assert_msg(status == THUD_OK || (fired && status == THUD_MEMORY), "allocation %ld: status %d", n,
                      (int)status);
        if (status == THUD_OK) {
            ck_assert_int_eq(sweep_rows(point, row), rows);
            ck_assert_int_eq(memcmp(row, wanted, (size_t)rows * sizeof *row), 0);
        }
        free(point);
        ck_assert_msg(thud_fault_live() == live, "allocation %ld leaves blocks", n);
    }
    ck_assert_int_gt(n, 100);
    free(whole);
}
END_TEST

static enum thud_status ask_for_more(void)
{
    struct thud_solution solution;
    struct thud_sensitivity *sensitivity = NULL;
    struct thud_truncation truncation;
    enum thud_status status = thud_scene_solve(scene, motion, NULL, &solution, NULL);
    if (status == THUD_OK)
        status = thud_sensitivity_run(scene, motion, 1e-3, thud_run_result(solution.run), &sensitivity, NULL);
    if (status == THUD_OK)
        status = thud_truncation_measure(scene, motion, &solution, &truncation, NULL);
    thud_sensitivity_free(sensitivity);
    thud_solution_clear(&solution);
    return status;
}

START_TEST(an_answer_with_all_that_more_runs_tell)
{
    long n = 0;
    scene->analysis.modes = 1;
    for (bool fired = true; fired;) {
        long live = thud_fault_live();
        n = after(n);
        thud_fault_arm(THUD_FAULT_MEMORY, n);
        enum thud_status status = ask_for_more();
        fired = thud_fault_end();
        ck_assert_msg(status == (fired ? THUD_MEMORY : THUD_OK), "allocation %ld: status %d", n, (int)status);
        ck_assert_msg(thud_fault_live() == live, "allocation %ld leaves blocks", n);
    }
    ck_assert_int_gt(n, 50);
}
END_TEST

/* A study delivers points as they come; what it keeps of them is a block each where there is to be a table, else
 * nothing. */
START_TEST(a_point_leaves_one_block_or_none)
{
    enum { POINTS = 40 };
    struct thud_sweep_point *point;
    ck_assert_int_eq(make_point(&point), THUD_OK);
    for (int table = 0; table < 2; table++) {
        struct thud_sweep_study study = {.plan = plan, .table = table};
        struct thud_sweep_outcome outcome;
        ck_assert_int_eq(thud_sweep_outcome_init(plan, &outcome, NULL), THUD_OK);
        ck_assert_int_eq(thud_sweep_study_deliver(&study, point, &outcome, NULL), THUD_OK);
        long live = thud_fault_live();
        for (int i = 0; i < POINTS; i++)
            ck_assert_int_eq(thud_sweep_study_deliver(&study, point, &outcome, NULL), THUD_OK);
        ck_assert_int_eq(thud_fault_live() - live, table ? POINTS : 0);
        ck_assert_uint_eq(outcome.rows.table.npoints, table ? POINTS + 1 : 0);
        ck_assert_int_eq(outcome.total.points, POINTS + 1);
        thud_sweep_outcome_clear(&outcome);
    }
    free(point);
}
END_TEST

/* Room is taken again and again, and each of it can be refused. */
START_TEST(a_table_without_memory_says_so)
{
    enum { POINTS = 70 };
    static const char *const names[] = {"motion"};
    struct thud_sweep_point *point;
    ck_assert_int_eq(make_point(&point), THUD_OK);
    long n = 0;
    for (bool fired = true; fired;) {
        struct thud_sweep_collector collector;
        enum thud_status status = THUD_OK;
        size_t added = 0;
        long live = thud_fault_live();
        thud_sweep_collector_init(&collector, plan, names);
        thud_fault_arm(THUD_FAULT_MEMORY, ++n);
        while (status == THUD_OK && added < POINTS) {
            status = thud_sweep_collector_add(&collector, plan, point, NULL);
            added += status == THUD_OK;
        }
        fired = thud_fault_end();
        ck_assert_msg(status == (fired ? THUD_MEMORY : THUD_OK), "allocation %ld: status %d", n, (int)status);
        ck_assert_uint_eq(collector.table.npoints, added);
        thud_sweep_collector_clear(&collector);
        ck_assert_msg(thud_fault_live() == live, "allocation %ld leaves blocks", n);
    }
    ck_assert_int_gt(n, POINTS);
    free(point);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("fault_sweep");
    TCase *tcase = tcase_create("fault_sweep");
    tcase_add_checked_fixture(tcase, set_up, tear_down);
    tcase_set_timeout(tcase, 60);
    tcase_add_test(tcase, a_point_with_its_spread);
    tcase_add_test(tcase, an_answer_with_all_that_more_runs_tell);
    tcase_add_test(tcase, a_point_leaves_one_block_or_none);
    tcase_add_test(tcase, a_table_without_memory_says_so);
    suite_add_tcase(suite, tcase);
    return suite;
}
