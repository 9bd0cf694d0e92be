/* Motion without contact, in blocks: the buildings of a row that do not touch move as each of them alone, though the
 * power series in which peaks are read are made of one structure at a time. */
#include <check.h>
#include <math.h>

#include "core/run/baseline.h"
#include "core/run/run_private.h"
#include "march.h"

/* Peaks and their times of building `of` in `row` against building 0 of `alone`. */
static void compare(const struct thud_result *row, int of, const struct thud_result *alone)
{
    const struct thud_structure_result *a = &row->structure[of], *b = &alone->structure[0];
    ck_assert_int_eq(a->floors, b->floors);
    for (int i = 0; i < a->floors; i++) {
        const struct thud_peak x[] = {a->floor[i].displacement, a->floor[i].velocity, a->floor[i].acceleration,
                                      a->floor[i].drift},
                               y[] = {b->floor[i].displacement, b->floor[i].velocity, b->floor[i].acceleration,
                                      b->floor[i].drift};
        for (int q = 0; q < 4; q++) {
            ck_assert_double_gt(y[q].value, 0);
            ck_assert_double_eq_tol(x[q].value / y[q].value, 1, 1e-11);
            ck_assert_double_eq_tol(x[q].time_s, y[q].time_s, 1e-5); /* a peak is flat */
        }
    }
}

/* 0.02 s of the motion are 2 rad of the fastest mode: each interval is read in two series. */
START_TEST(a_row_that_does_not_touch)
{
    const int storeys[] = {6, 9, 1, 4, 17};
    enum { N = sizeof storeys / sizeof *storeys };
    struct march_law law = march_law("linear", "stiffness", 2.5e9, NULL);
    struct thud_record *record = march_motion(1);
    struct thud_model *model = march_row(N, storeys, _i, 5, &law);
    struct march row = march_run(model, record, "exact", 0, 0, true, 3);
    ck_assert_int_eq(row.status, THUD_OK);
    for (int s = 0; s < N; s++) {
        struct thud_model *one = march_row(1, &storeys[s], _i, 0, NULL);
        struct march alone = march_run(one, record, "exact", 0, 0, true, 3);
        ck_assert_int_eq(alone.status, THUD_OK);
        compare(row.result, s, alone.result);
        march_free(&alone);
        thud_model_free(one);
    }
    for (int c = 0; c < row.result->ncontacts; c++)
        ck_assert_int_eq(row.result->contact[c].impacts, 0);
    ck_assert_int_gt(row.result->ncontacts, 0);
    march_free(&row);
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

/* The clearance at which two buildings just touch is the largest relative displacement that a run without contact
 * finds: the search for contact, which looks at the series of a row's two structures, takes place in another way. */
START_TEST(touch_begins_where_the_largest_relative_displacement_ends)
{
    const int storeys[] = {5, 8, 3};
    struct march_law law = march_law("linear", "stiffness", 2.5e9, NULL);
    struct thud_record *record = march_motion(1);
    double most[2] = {0}; /* of each pair of neighbours, over its contacts */
    for (int i = 0; i < 2; i++) {
        double gap[] = {0, 0.8};
        while (gap[1] - gap[0] > 1e-12) { /* by bisection of whether there is contact */
            double middle = 0.5 * (gap[0] + gap[1]);
            struct thud_model *model = march_row(2, storeys + i, _i, middle, &law);
            struct march m = march_run(model, record, "exact", 0, 0, true, 3);
            bool in_contact = false;
            for (int c = 0; c < m.result->ncontacts; c++)
                in_contact = in_contact || m.result->contact[c].indentation.value > 0;
            gap[!in_contact] = middle;
            march_free(&m);
            thud_model_free(model);
        }
        most[i] = gap[1];
    }
    struct thud_model *model = march_row(3, storeys, _i, 1, &law);
    struct thud_baseline_motion *baseline;
    struct thud_run_options options;
    bool done = false;
    thud_run_options_init(&options);
    options.method = thud_method_find("exact");
    options.tail_s = 3;
    ck_assert_int_eq(thud_baseline_create(model, 0, record, &options, &baseline, NULL), THUD_OK);
    while (!done)
        ck_assert_int_eq(thud_baseline_advance(baseline, 1000, &done, NULL), THUD_OK);
    for (int i = 0; i < 2; i++) {
        double largest = 0;
        for (int c = 0; c < model->ncontacts; c++)
            if (model->contact[c].interface == i + 1)
                largest = fmax(largest, thud_baseline_relative_displacement(baseline, c));
        ck_assert_double_eq_tol(largest, most[i], 1e-10);
    }
    thud_baseline_free(baseline);
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

/* Of a segment's structures, which of them are at the start of a piece of this interval; the others have no number. */
static void check_place(const struct thud_free_vibration *f, const struct thud_model *m, const struct thud_segment *seg,
                        int t, unsigned has)
{
    for (int s = 0; s < m->nstructures; s++)
        for (int j = m->structure[s].first_mode; j < m->structure[s].first_mode + m->structure[s].modes; j++)
            for (int k = 0; k < seg->terms; k++) {
                if (!(has >> s & 1))
                    ck_assert(isnan(seg->q[k * m->nmodes + j]));
                else if (k == 0)
                    ck_assert_double_eq(seg->q[j], f->q[j * THUD_FREE_VIBRATION_ENDS + t]);
            }
}

static enum thud_status look_around(void *own, const struct thud_state *state, struct thud_free_vibration *f,
                                    int intervals, struct thud_error *err)
{
    int *looks = own;
    const struct thud_model *m = state->model;
    const int last = f->pieces - 1;
    (void)err;
    if (intervals < 6)
        return THUD_OK;
    ++*looks;
    ck_assert_int_eq(f->pieces > 1, f->dt_s > 0.1);
    check_place(f, m, thud_free_vibration_all_series(f, state, 1, 0), 1, 7);
    check_place(f, m, thud_free_vibration_series(f, state, 0, 3, 0), 3, 1);
    check_place(f, m, thud_free_vibration_series(f, state, 2, 5, 0), 5, 4);
    check_place(f, m, thud_free_vibration_series(f, state, 1, 5, 0), 5, 6);
    check_place(f, m, thud_free_vibration_series(f, state, 1, 3, 0), 3, 2);
    double q[2][MARCH_FLOORS_MAX], qd[MARCH_FLOORS_MAX]; /* the last piece ends where the interval does */
    thud_segment_state(thud_free_vibration_all_series(f, state, 3, last), m->nmodes, 1, q[0], qd);
    thud_free_vibration_series(f, state, 1, 2, last);
    thud_segment_state(thud_free_vibration_series(f, state, 0, 3, last), m->nmodes, 1, q[1], qd);
    for (int j = 0; j < m->structure[0].modes; j++) {
        ck_assert_double_eq(q[0][j], q[1][j]);
        ck_assert_double_eq_tol(q[0][j], f->q[j * THUD_FREE_VIBRATION_ENDS + 4], 1e-9);
    }
    return THUD_OK;
}

/* Every tenth sample of a motion. */
static struct thud_record *tenth_of(struct thud_record *record)
{
    double a[100];
    const size_t n = record->samples / 10;
    struct thud_record *out = NULL;
    for (size_t i = 0; i < n; i++)
        a[i] = record->a_mps2[10 * i];
    ck_assert_int_eq(thud_record_create(a, n, 10 * record->dt_s, &out, NULL), THUD_OK);
    thud_record_free(record);
    return out;
}

/* Whatever is asked for in whatever order, a segment never has structures at different times; also where an interval
 * takes several. */
START_TEST(a_series_is_of_one_time)
{
    static const struct thud_observer looking = {.block = look_around};
    const int storeys[] = {5, 8, 3};
    struct march_law law = march_law("linear", "stiffness", 2.5e9, NULL);
    struct thud_record *record = _i & 2 ? tenth_of(march_motion(1)) : march_motion(1);
    struct thud_model *model = march_row(3, storeys, _i & 1, 5, &law);
    struct thud_run_options options;
    struct thud_run *run;
    int looks = 0;
    thud_run_options_init(&options);
    ck_assert_int_eq(thud_run_create(model, record, &options, &run, NULL), THUD_OK);
    thud_run_observe(run, &looking, &looks);
    for (bool done = false; !done;)
        ck_assert_int_eq(thud_run_advance(run, 1000, &done, NULL), THUD_OK);
    ck_assert_int_gt(looks, _i & 2 ? 0 : 2);
    thud_run_free(run);
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

/* Behind a block that an event has cut short no other is made up to it: its interval is left to a segment at once. */
START_TEST(an_event_is_looked_for_once)
{
    const int storeys[] = {5, 8, 3};
    struct march_law law = march_law("linear", "stiffness", 2.5e9, NULL);
    struct thud_record *record = march_motion(1);
    struct thud_model *model = march_row(3, storeys, _i, 0.01, &law);
    struct thud_run_options options;
    struct thud_run *run;
    int cuts = 0;
    thud_run_options_init(&options);
    ck_assert_int_eq(thud_run_create(model, record, &options, &run, NULL), THUD_OK);
    const struct thud_free_vibration *f = run->free_vibration;
    for (bool done = false; !done;) {
        const long fast = run->work.samples_fast, steps = run->work.steps;
        const int ends = f->ends;
        const bool cut = f->size == 0;
        ck_assert_int_eq(thud_run_advance(run, 1, &done, NULL), THUD_OK);
        if (!cut)
            continue;
        cuts++;
        ck_assert_int_eq(f->ends, ends);
        ck_assert_int_eq(run->work.samples_fast, fast);
        ck_assert_int_eq(run->work.steps, steps + 1);
        ck_assert_int_gt(run->work.events, 0);
    }
    ck_assert_int_gt(cuts, 2);
    thud_run_free(run);
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("contact-free response");
    TCase *tcase = tcase_create("rows that do not touch");
    tcase_set_timeout(tcase, 60);
    tcase_add_loop_test(tcase, a_row_that_does_not_touch, 0, 2); /* 1: isolated, which couples modes */
    tcase_add_loop_test(tcase, touch_begins_where_the_largest_relative_displacement_ends, 0, 2);
    tcase_add_loop_test(tcase, a_series_is_of_one_time, 0, 4);
    tcase_add_loop_test(tcase, an_event_is_looked_for_once, 0, 2);
    suite_add_tcase(suite, tcase);
    return suite;
}
