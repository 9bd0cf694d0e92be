/* Points by several threads: all of them, once, in their order, whatever the number of threads; stopped on request and
 * on failure. */
#include <check.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "app/sweep/sweep_jobs.h"
#include "study_setup.h"

static void set_up(void)
{
    study_set_up(0.2);
    vary("gap=5.5:9:0.5 cm");
    vary("structures.1.stiffness=300 MN/m,400 MN/m,500 MN/m,600 MN/m,700 MN/m");
}

struct taken {
    struct thud_text text;
    long next, step, stop_at;
    atomic_int cancel;
    long shown;
    bool results; /* alone, not what they cost */
    struct thud_sweep_total total;
};

static enum thud_status take(void *context, struct thud_sweep_point *point, struct thud_error *err)
{
    struct taken *t = context;
    ck_assert_int_eq(point->index, t->next);
    thud_sweep_total_add(&t->total, point);
    for (int k = 0; k < point->ncases && t->results; k++)
        point->effort[k] = (struct thud_sweep_effort){.status = point->effort[k].status};
    thud_sweep_point_write(point, &t->text);
    thud_text_append(&t->text, "\n");
    free(point);
    t->next += t->step;
    if (t->next == t->stop_at)
        return thud_error_set(err, THUD_OUTPUT, "no more room");
    return THUD_OK;
}

static void show(void *context, long done, long count, double elapsed_s)
{
    struct taken *t = context;
    ck_assert_int_ge(done, t->shown);
    ck_assert_int_le(done, count);
    ck_assert(elapsed_s >= 0);
    t->shown = done;
}

static enum thud_status run(int threads, long first, long step, struct taken *taken, struct thud_error *err)
{
    long points = thud_sweep_points(plan);
    taken->next = first;
    taken->step = step;
    struct thud_sweep_jobs jobs = {.plan = plan,
                                   .first = first,
                                   .step = step,
                                   .count = (points - first + step - 1) / step,
                                   .threads = threads,
                                   .cancel = &taken->cancel,
                                   .context = taken,
                                   .take = take,
                                   .progress = show};
    return thud_sweep_jobs_run(&jobs, err);
}

START_TEST(any_number_of_threads_gives_the_same)
{
    struct taken one = {0};
    ck_assert_int_eq(run(1, 0, 1, &one, NULL), THUD_OK);
    ck_assert_int_eq(one.next, 40);
    ck_assert_int_eq(one.shown, 40);
    for (int threads = 2; threads <= 16; threads *= 2) {
        struct taken more = {0};
        ck_assert_int_eq(run(threads, 0, 1, &more, NULL), THUD_OK);
        ck_assert_str_eq(one.text.data, more.text.data);
        thud_text_clear(&more.text);
    }
    thud_text_clear(&one.text);
}
END_TEST

/* Cases of the same contacts at other gaps: taken over where the other point is in the same work, made where it is not
 * (in parts, or where a study goes on); the results, and what is told of their cost, are the same. */
START_TEST(what_is_the_same_is_taken_over)
{
    ck_assert_int_eq(thud_sweep_cases(plan, "bumper,as-written,none,cavity", &error), THUD_OK);
    struct taken all = {.results = true}, each = {.results = true};
    ck_assert_int_eq(run(1, 0, 1, &all, NULL), THUD_OK);
    ck_assert_int_gt(all.total.reused, 40); /* as written is case bumper */
    for (int threads = 1; threads <= 8; threads *= 2)
        for (long step = 1; step <= 3; step++) {
            struct taken part[3] = {0};
            long made = 0, reused = 0;
            for (long k = 0; k < step; k++) {
                part[k].results = true;
                ck_assert_int_eq(run(threads, k, step, &part[k], NULL), THUD_OK);
                made += part[k].total.made;
                reused += part[k].total.reused;
            }
            ck_assert_int_eq(made, all.total.made);
            ck_assert_int_eq(reused, all.total.reused);
            const char *from[3] = {part[0].text.data, part[1].text.data, part[2].text.data}, *line = all.text.data;
            for (long i = 0; i < 40; i++) {
                size_t size = strcspn(line, "\n") + 1;
                ck_assert_msg(strncmp(from[i % step], line, size) == 0, "point %ld of %ld parts", i, step);
                from[i % step] += size;
                line += size;
            }
            for (long k = 0; k < step; k++)
                thud_text_clear(&part[k].text);
        }
    plan->shortcuts &= ~(unsigned)THUD_SWEEP_SAME;
    ck_assert_int_eq(run(2, 0, 1, &each, NULL), THUD_OK);
    ck_assert_str_eq(each.text.data, all.text.data);
    ck_assert_int_eq(each.total.made, all.total.made + all.total.reused);
    thud_text_clear(&all.text);
    thud_text_clear(&each.text);
}
END_TEST

START_TEST(some_of_the_points)
{
    struct taken part = {0}, none = {0};
    ck_assert_int_eq(run(3, 2, 7, &part, NULL), THUD_OK);
    ck_assert_int_eq(part.next, 44);
    ck_assert_int_eq(run(2, 40, 1, &none, NULL), THUD_OK);
    ck_assert_ptr_null(none.text.data);
    thud_text_clear(&part.text);
}
END_TEST

START_TEST(stopped_by_the_taker)
{
    struct taken taken = {.stop_at = 5};
    error = (struct thud_error){0};
    ck_assert_int_eq(run(4, 0, 1, &taken, &error), THUD_OUTPUT);
    ck_assert_str_eq(error.what, "no more room");
    ck_assert_int_eq(taken.next, 5);
    thud_text_clear(&taken.text);
}
END_TEST

START_TEST(stopped_on_request)
{
    struct taken taken = {.cancel = 1};
    error = (struct thud_error){0};
    ck_assert_int_eq(run(2, 0, 1, &taken, &error), THUD_CANCELLED);
    ck_assert_int_eq(taken.next, 0);
}
END_TEST

/* A group that cannot be made ends the work with its message. */
START_TEST(stopped_by_a_base_that_fails)
{
    struct taken taken = {0};
    error = (struct thud_error){0};
    strcpy(plan->scene.analysis.method, "clairvoyance");
    ck_assert_int_eq(run(3, 0, 1, &taken, &error), THUD_INPUT);
    ck_assert_ptr_nonnull(strstr(error.what, "clairvoyance"));
    ck_assert_int_eq(taken.next, 0);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("sweep jobs");
    TCase *tcase = tcase_create("jobs");
    tcase_add_checked_fixture(tcase, set_up, study_tear_down);
    tcase_add_test(tcase, any_number_of_threads_gives_the_same);
    tcase_add_test(tcase, what_is_the_same_is_taken_over);
    tcase_add_test(tcase, some_of_the_points);
    tcase_add_test(tcase, stopped_by_the_taker);
    tcase_add_test(tcase, stopped_on_request);
    tcase_add_test(tcase, stopped_by_a_base_that_fails);
    suite_add_tcase(suite, tcase);
    return suite;
}
