/* The cases of a scene side by side: the same numbers whatever the number of threads, each as soon as it has ended, and
 * begun anew at any moment. */
#include <check.h>
#include <math.h>
#include <string.h>

#include "app/run/live_cases.h"
#include "study/scene/solution.h"
#include "towers.h"

static struct thud_scene scene;
static struct thud_record *record;
static struct thud_live live;

static void set_up(void)
{
    thud_test_towers(&scene);
    scene.interface[0].gap_m = 0.055;
    record = thud_test_motion(1.0);
    memset(&live, 0, sizeof live);
}

static void tear_down(void)
{
    thud_live_clear(&live);
    thud_record_free(record);
}

static void finish(void)
{
    while (thud_live_advance(&live))
        ;
}

static void expect_all_done(void)
{
    ck_assert(!live.running && !live.work);
    for (int i = 0; i < THUD_LIVE_CASES; i++) {
        ck_assert_int_eq((int)live.which[i].state, (int)THUD_LIVE_DONE);
        ck_assert_ptr_null(live.which[i].old);
    }
}

/* Numbers of every case, as bits. */
struct numbers {
    double force[THUD_LIVE_CASES], peak[THUD_LIVE_CASES], need, abs, srss;
    int impacts[THUD_LIVE_CASES];
};

static struct numbers numbers(void)
{
    struct numbers n;
    memset(&n, 0, sizeof n);
    for (int i = 0; i < THUD_LIVE_CASES; i++) {
        n.force[i] = thud_live_force(&live, (enum thud_live_which)i, 1, &n.impacts[i]);
        n.peak[i] = thud_live_peak(&live, (enum thud_live_which)i, 1, THUD_PEAK_ACCELERATION);
    }
    n.need = live.need[0].relative_displacement_m;
    n.abs = live.need[0].abs_m;
    n.srss = live.need[0].srss_m;
    return n;
}

START_TEST(any_number_of_threads_gives_the_same)
{
    struct numbers alone = {0};
    for (int threads = -1; threads <= 4; threads++) {
        live.threads = threads;
        enum thud_live_history history = threads == 2   ? THUD_LIVE_WHOLE
                                         : threads == 3 ? THUD_LIVE_LOOK
                                                        : THUD_LIVE_NO_HISTORY;
        thud_live_start(&live, &scene, record, history); /* they change no number */
        ck_assert(live.running);
        finish();
        expect_all_done();
        struct numbers now = numbers();
        if (threads < 0)
            alone = now;
        ck_assert_int_eq(memcmp(&alone, &now, sizeof now), 0);
        ck_assert_int_eq((int)live.history, (int)history);
    }
    ck_assert_int_gt(alone.impacts[THUD_LIVE_BUMPER], 3);
    ck_assert_int_eq(alone.impacts[THUD_LIVE_FREE], 0);
    ck_assert_double_gt(alone.need, scene.interface[0].gap_m);
    ck_assert_double_ge(alone.abs, alone.need);
}
END_TEST

/* A run made alone says the same as the case. */
START_TEST(the_cases_are_runs_of_their_scenes)
{
    static const enum thud_case name[] = {[THUD_LIVE_NONE] = THUD_CASE_NONE, [THUD_LIVE_BUMPER] = THUD_CASE_BUMPER};
    thud_live_start(&live, &scene, record, THUD_LIVE_NO_HISTORY);
    finish();
    for (int i = THUD_LIVE_NONE; i < THUD_LIVE_CASES; i++) {
        struct thud_scene one;
        struct thud_solution solution = {0};
        ck_assert_int_eq(thud_scene_case(&scene, name[i], &one, NULL), THUD_OK);
        ck_assert_int_eq(thud_scene_solve(&one, record, NULL, &solution, NULL), THUD_OK);
        const struct thud_result *wanted = thud_run_result(solution.run),
                                 *found = thud_live_result(&live, (enum thud_live_which)i);
        for (int floor = 0; floor < 6; floor++)
            ck_assert(wanted->structure[1].floor[floor].drift.value == found->structure[1].floor[floor].drift.value);
        thud_solution_clear(&solution);
    }
}
END_TEST

/* One thread ends the cases one after the other: the first has its numbers while the others still show the old ones. */
START_TEST(each_is_there_as_soon_as_it_has_ended)
{
    thud_live_start(&live, &scene, record, THUD_LIVE_NO_HISTORY);
    finish();
    struct numbers before = numbers();
    scene.interface[0].gap_m = 0.06;
    for (int threads = -1; threads <= 1; threads += 2) {
        int seen = 0;
        unsigned long ended = live.ended;
        live.threads = threads;
        thud_live_start(&live, &scene, record, THUD_LIVE_NO_HISTORY);
        double progress = thud_live_progress(&live);
        for (bool going = true; going;) {
            going = thud_live_advance(&live);
            ck_assert_double_ge(thud_live_progress(&live), progress);
            progress = thud_live_progress(&live);
            bool bumper = live.which[THUD_LIVE_BUMPER].state == THUD_LIVE_DONE,
                 none = live.which[THUD_LIVE_NONE].state == THUD_LIVE_DONE;
            ck_assert(bumper || !none);
            if (!bumper || none)
                continue;
            seen++;
            struct numbers now = numbers();
            ck_assert(now.peak[THUD_LIVE_NONE] == before.peak[THUD_LIVE_NONE]);
            ck_assert(now.peak[THUD_LIVE_BUMPER] != before.peak[THUD_LIVE_BUMPER]);
            ck_assert(thud_live_is_old(&live, THUD_LIVE_NONE) && !thud_live_is_old(&live, THUD_LIVE_BUMPER));
        }
        ck_assert(seen > 0 || threads > 0);       /* a thread may end them all between two looks */
        ck_assert_uint_eq(live.ended - ended, 4); /* and the gap that is needed */
        ck_assert_double_eq_tol(progress, 1.0, 1e-12);
        expect_all_done();
        before = numbers();
        scene.interface[0].gap_m = 0.055;
    }
}
END_TEST

/* A start stops what goes on, wherever it is; so do a stop and a clear. The record may go at once. */
START_TEST(begun_anew_at_any_moment)
{
    thud_live_start(&live, &scene, record, THUD_LIVE_NO_HISTORY);
    finish();
    struct numbers wanted = numbers();
    for (int i = 0; i < 60; i++) {
        struct thud_record *other = thud_test_motion(0.5 + 0.01 * i);
        scene.interface[0].gap_m = 0.05 + 0.0001 * i;
        live.threads = i % 4;
        thud_live_start(&live, &scene, other, i % 5 ? THUD_LIVE_NO_HISTORY : THUD_LIVE_WHOLE);
        for (int k = 0; k < i % 7; k++)
            thud_live_advance(&live);
        if (i % 3 == 0)
            thud_live_clear(&live);
        else
            thud_live_stop(&live);
        thud_record_free(other);
    }
    scene.interface[0].gap_m = 0.055;
    thud_live_start(&live, &scene, record, THUD_LIVE_NO_HISTORY);
    finish();
    expect_all_done();
    struct numbers now = numbers();
    ck_assert_int_eq(memcmp(&wanted, &now, sizeof now), 0);
}
END_TEST

/* A column of a history at a time, along straight lines. */
static double at_time(const struct thud_history *h, int column, double t)
{
    size_t low = 0, high = h->rows - 1;
    while (high - low > 1) {
        size_t middle = low + (high - low) / 2;
        *(h->time_s[middle] <= t ? &low : &high) = middle;
    }
    double a = h->value[low * (size_t)h->columns + (size_t)column],
           b = h->value[high * (size_t)h->columns + (size_t)column], width = h->time_s[high] - h->time_s[low];
    return width > 0 ? a + (t - h->time_s[low]) / width * (b - a) : a;
}

static double largest_of(const struct thud_history *h, int column)
{
    double most = 0.0;
    for (size_t i = 0; i < h->rows; i++)
        most = fmax(most, fabs(h->value[i * (size_t)h->columns + (size_t)column]));
    return most;
}

/* What is kept for a look has far fewer rows; its curves go by the whole ones, and through every peak. */
START_TEST(a_look_shows_the_same)
{
    struct thud_live whole;
    memset(&whole, 0, sizeof whole);
    thud_live_start(&live, &scene, record, THUD_LIVE_LOOK);
    finish();
    thud_live_start(&whole, &scene, record, THUD_LIVE_WHOLE);
    while (thud_live_advance(&whole))
        ;
    const struct thud_run *run = live.which[THUD_LIVE_BUMPER].run;
    const struct thud_history *look = thud_run_history(run), *all = thud_run_history(whole.which[THUD_LIVE_BUMPER].run);
    ck_assert_uint_lt(2 * look->rows, all->rows);
    ck_assert_int_eq(look->columns, all->columns);
    for (int c = 0; c < look->ncontacts; c++)
        ck_assert_double_eq_tol(largest_of(look, thud_history_force(look, c)),
                                thud_run_result(run)->contact[c].force.value, 1.0);
    int column[] = {thud_history_displacement(look, 3), thud_history_velocity(look, 9), thud_history_force(look, 3)};
    for (size_t k = 0; k < sizeof column / sizeof *column; k++) {
        double most = largest_of(all, column[k]), worst = 0.0;
        ck_assert_double_gt(most, 0.0);
        for (size_t i = 0; i < all->rows; i++) {
            double t = all->time_s[i], value = all->value[i * (size_t)all->columns + (size_t)column[k]];
            bool jump = (i > 0 && all->time_s[i - 1] == t) || (i + 1 < all->rows && all->time_s[i + 1] == t);
            worst = jump ? worst : fmax(worst, fabs(value - at_time(look, column[k], t)));
        }
        ck_assert_double_le(worst, 0.05 * most);
    }
    ck_assert(isnan(look->value[thud_history_energy(look, 0)]));
    ck_assert(isfinite(all->value[thud_history_energy(all, 0)]));
    for (size_t i = 1; i < look->rows; i++)
        ck_assert(look->time_s[i] >= look->time_s[i - 1]);
    thud_live_clear(&whole);
}
END_TEST

/* A step far too long: every case ends with its reason, and nothing hangs. */
START_TEST(what_fails_says_so)
{
    ck_assert_int_eq(thud_scene_set(&scene, "analysis.method", "central-difference", NULL), THUD_OK);
    ck_assert_int_eq(thud_scene_set(&scene, "analysis.step", "0.01 s", NULL), THUD_OK);
    ck_assert_int_eq(thud_scene_set(&scene, "structures.1.stiffness", "1e6 MN/m", NULL), THUD_OK);
    for (int threads = -1; threads <= 2; threads++) {
        live.threads = threads;
        thud_live_start(&live, &scene, record, THUD_LIVE_NO_HISTORY);
        finish();
        for (int i = 0; i < THUD_LIVE_CASES; i++) {
            ck_assert_int_eq((int)live.which[i].state, (int)THUD_LIVE_FAILED);
            ck_assert_int_ne(live.which[i].error.what[0], '\0');
            ck_assert_ptr_null(thud_live_result(&live, (enum thud_live_which)i));
        }
        ck_assert(!live.running);
    }
}
END_TEST

START_TEST(without_a_bumper_two_cases)
{
    scene.interface[0].has_bumper = false;
    thud_live_start(&live, &scene, record, THUD_LIVE_NO_HISTORY);
    finish();
    ck_assert_int_eq((int)live.which[THUD_LIVE_BUMPER].state, (int)THUD_LIVE_ABSENT);
    ck_assert_int_eq((int)live.which[THUD_LIVE_NONE].state, (int)THUD_LIVE_DONE);
    ck_assert(isfinite(live.need[0].srss_m));
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("live cases");
    TCase *cases = tcase_create("cases");
    tcase_set_timeout(cases, 120.0);
    tcase_add_checked_fixture(cases, set_up, tear_down);
    tcase_add_test(cases, any_number_of_threads_gives_the_same);
    tcase_add_test(cases, the_cases_are_runs_of_their_scenes);
    tcase_add_test(cases, each_is_there_as_soon_as_it_has_ended);
    tcase_add_test(cases, begun_anew_at_any_moment);
    tcase_add_test(cases, a_look_shows_the_same);
    tcase_add_test(cases, what_fails_says_so);
    tcase_add_test(cases, without_a_bumper_two_cases);
    suite_add_tcase(suite, cases);
    return suite;
}
