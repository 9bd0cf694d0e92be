/* The motion without contact, kept: a run that begins in it goes as one from t = 0, bit for bit, and its largest
 * closings are those that a dense look at the histories finds. */
#include <check.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/run/baseline.h"

enum { FLOORS_A = 2, FLOORS_B = 3, CONTACTS = 2, SAMPLES = 1500, FINER = 20 };

static struct thud_record *record;

/* A motion of 30 s with several bursts, so that the largest relative displacements come late; so many samples for
 * each of the plain one. */
static void make_record(int times)
{
    static double a[SAMPLES * FINER];
    for (int i = 0; i < SAMPLES * times; i++) {
        double t = 0.02 / times * i;
        a[i] =
            4 * exp(-0.5 * pow((t - 8) / 2, 2)) * sin(9 * t) + 7 * exp(-0.5 * pow((t - 20) / 2.5, 2)) * sin(13 * t + 1);
    }
    ck_assert_int_eq(thud_record_create(a, (size_t)(SAMPLES * times), 0.02 / times, &record, NULL), THUD_OK);
}

static void set_up(void)
{
    make_record(1);
}

static void tear_down(void)
{
    thud_record_free(record);
}

static struct thud_model *make_model(double clearance, bool isolated)
{
    static const double mass[] = {3.2e5, 3.2e5, 2.5e5}, stiffness[] = {2e8, 2e8, 2e8}, soft[] = {1e8, 1e8, 1e8};
    struct thud_structure_input structure[2] = {
        {.n = FLOORS_A, .mass_kg = mass + 1, .stiffness_npm = stiffness, .damping = 0.05},
        {.n = FLOORS_B,
         .mass_kg = mass,
         .stiffness_npm = soft,
         .damping = 0.05,
         .isolated = isolated,
         .isolation_damping = 0.1}};
    struct thud_contact_input contact[CONTACTS];
    const struct thud_law *law = thud_law_find("kelvin-voigt-no-tension");
    ck_assert_ptr_nonnull(law);
    for (int c = 0; c < CONTACTS; c++) {
        contact[c] = (struct thud_contact_input){.interface = 1,
                                                 .left_floor = c + 1,
                                                 .right_floor = c + 1,
                                                 .right_structure = 1,
                                                 .clearance_m = clearance,
                                                 .law = law};
        thud_law_defaults(law, &contact[c].setup);
        contact[c].setup.value[thud_law_param(law, "stiffness")] = 2.5e9;
        contact[c].setup.value[thud_law_param(law, "restitution")] = 0.6;
    }
    struct thud_model_input input = {
        .nstructures = 2, .structure = structure, .ncontacts = CONTACTS, .contact = contact};
    struct thud_model *model;
    struct thud_error error;
    ck_assert_msg(thud_model_create(&input, &model, &error) == THUD_OK, "%s", error.what);
    return model;
}

static struct thud_run_options options(void)
{
    struct thud_run_options o;
    thud_run_options_init(&o);
    return o;
}

static void finish(struct thud_run *run)
{
    bool done = false;
    while (!done)
        ck_assert_int_eq(thud_run_advance(run, 100, &done, NULL), THUD_OK);
}

static struct thud_baseline_motion *make_baseline(const struct thud_model *model)
{
    struct thud_run_options o = options();
    struct thud_baseline_motion *baseline;
    ck_assert_int_eq(thud_baseline_create(model, 0, record, &o, &baseline, NULL), THUD_OK);
    struct thud_error error = {0};
    for (bool done = false; !done;)
        ck_assert_msg(thud_baseline_advance(baseline, 3, &done, &error) == THUD_OK, "%s", error.what);
    return baseline;
}

static void assert_same(const struct thud_result *a, const struct thud_result *b)
{
    for (int s = 0; s < a->nstructures; s++)
        ck_assert_int_eq(memcmp(a->structure[s].floor, b->structure[s].floor,
                                (size_t)a->structure[s].floors * sizeof(struct thud_floor_result)),
                         0);
    for (int c = 0; c < a->ncontacts; c++) {
        ck_assert_int_eq(a->contact[c].impacts, b->contact[c].impacts);
        ck_assert(a->contact[c].force.value == b->contact[c].force.value);
        ck_assert(a->contact[c].force.time_s == b->contact[c].force.time_s);
        ck_assert(a->contact[c].impulse_ns == b->contact[c].impulse_ns);
        ck_assert(a->contact[c].residual_m == b->contact[c].residual_m);
    }
}

static void compare(double clearance, bool isolated, double least_shared, bool contact)
{
    struct thud_model *model = make_model(clearance, isolated), *other = make_model(0.5, isolated);
    struct thud_baseline_motion *baseline = make_baseline(other);
    struct thud_run_options o = options();
    struct thud_run *whole, *begun;
    double shared;
    ck_assert_int_eq(thud_run_create(model, record, &o, &whole, NULL), THUD_OK);
    ck_assert_int_eq(thud_baseline_run(baseline, model, record, &o, &begun, &shared, NULL), THUD_OK);
    ck_assert_double_ge(shared, least_shared);
    finish(whole);
    finish(begun);
    assert_same(thud_run_result(whole), thud_run_result(begun));
    ck_assert(contact == (thud_run_result(whole)->contact[1].impacts > 0));
    if (!contact)
        assert_same(thud_run_result(whole), thud_baseline_result(baseline));
    thud_run_free(whole);
    thud_run_free(begun);
    thud_baseline_free(baseline);
    thud_model_free(model);
    thud_model_free(other);
}

START_TEST(a_run_begun_late_answers_the_same)
{
    compare(0, false, 0, true);
    compare(0.01, false, 1, true);
    compare(0.05, false, 5, true);
    compare(1, false, 25, false);
}
END_TEST

/* 30000 intervals: more moments than are kept, so that they are thinned more than once. */
START_TEST(a_long_motion_is_kept_thinner)
{
    thud_record_free(record);
    make_record(FINER);
    compare(0.01, false, 1, true);
    compare(0.05, false, 4.9, true);
    compare(1, false, 25, false);
}
END_TEST

START_TEST(modes_that_couple_share_as_well)
{
    compare(0.02, true, 1, true);
    compare(2, true, 25, false);
}
END_TEST

/* The largest relative displacement against a contact-free history whose rows lie so densely that no peak is lost
 * between them. */
static void against_history(bool isolated)
{
    struct thud_model *model = make_model(10, isolated);
    struct thud_baseline_motion *baseline = make_baseline(model);
    struct thud_run_options o = options();
    struct thud_run *run;
    o.keep_history = true;
    o.history_step_s = 1e-4;
    ck_assert_int_eq(thud_run_create(model, record, &o, &run, NULL), THUD_OK);
    finish(run);
    const struct thud_history *h = thud_run_history(run);
    for (int c = 0; c < CONTACTS; c++) {
        double most = 0;
        int left = thud_history_displacement(h, c), right = thud_history_displacement(h, FLOORS_A + c);
        for (size_t i = 0; i < h->rows; i++) {
            const double *row = h->value + i * (size_t)h->columns;
            most = fmax(most, row[left] - row[right]);
        }
        ck_assert_double_gt(most, 0.01);
        ck_assert_double_ge(thud_baseline_relative_displacement(baseline, c), most * (1 - 1e-12));
        ck_assert_double_le(thud_baseline_relative_displacement(baseline, c), most * (1 + 1e-5));
    }
    thud_run_free(run);
    thud_baseline_free(baseline);
    thud_model_free(model);
}

START_TEST(largest_closings_are_those_of_the_history)
{
    against_history(false);
    against_history(true);
}
END_TEST

/* A clearance just above the largest relative displacement is never used up; one just below it is. */
START_TEST(the_needed_gap_is_exact)
{
    struct thud_model *model = make_model(1, false);
    struct thud_baseline_motion *baseline = make_baseline(model);
    double closing =
        fmax(thud_baseline_relative_displacement(baseline, 0), thud_baseline_relative_displacement(baseline, 1));
    for (int side = -1; side <= 1; side += 2) {
        struct thud_model *near = make_model(closing * (1 + side * 1e-9), false);
        struct thud_run_options o = options();
        struct thud_run *run;
        ck_assert_int_eq(thud_run_create(near, record, &o, &run, NULL), THUD_OK);
        finish(run);
        int impacts = thud_run_result(run)->contact[0].impacts + thud_run_result(run)->contact[1].impacts;
        ck_assert_int_eq(impacts > 0, side < 0);
        thud_run_free(run);
        thud_model_free(near);
    }
    thud_baseline_free(baseline);
    thud_model_free(model);
}
END_TEST

/* Without a ground motion free bodies go straight on: displacement and closing are speed times time. */
START_TEST(free_bodies_without_a_ground_motion)
{
    static const double mass[] = {320e3};
    const double speed[] = {0.5, -0.25}, tail = 0.4;
    struct thud_structure_input structure[2] = {{.n = 1, .mass_kg = mass, .velocity_mps = speed[0]},
                                                {.n = 1, .mass_kg = mass, .velocity_mps = speed[1]}};
    struct thud_contact_input contact = {.interface = 1,
                                         .left_floor = 1,
                                         .right_floor = 1,
                                         .right_structure = 1,
                                         .clearance_m = 10,
                                         .law = thud_law_find("linear")};
    thud_law_defaults(contact.law, &contact.setup);
    struct thud_model_input input = {.nstructures = 2, .structure = structure, .ncontacts = 1, .contact = &contact};
    struct thud_model *model;
    struct thud_baseline_motion *baseline;
    struct thud_run_options o = options();
    o.tail_s = tail;
    ck_assert_int_eq(thud_model_create(&input, &model, NULL), THUD_OK);
    ck_assert_int_eq(thud_baseline_create(model, 0, NULL, &o, &baseline, NULL), THUD_OK);
    for (bool done = false; !done;)
        ck_assert_int_eq(thud_baseline_advance(baseline, 1, &done, NULL), THUD_OK);
    const struct thud_result *r = thud_baseline_result(baseline);
    for (int s = 0; s < 2; s++) {
        ck_assert_double_eq_tol(r->structure[s].floor[0].displacement.value, fabs(speed[s]) * tail, 1e-15);
        ck_assert_double_eq_tol(r->structure[s].floor[0].velocity.value, fabs(speed[s]), 1e-15);
    }
    ck_assert_double_eq_tol(thud_baseline_relative_displacement(baseline, 0), (speed[0] - speed[1]) * tail, 1e-15);
    thud_baseline_free(baseline);
    thud_model_free(model);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("baseline");
    TCase *tcase = tcase_create("baseline");
    tcase_add_checked_fixture(tcase, set_up, tear_down);
    tcase_add_test(tcase, a_run_begun_late_answers_the_same);
    tcase_add_test(tcase, a_long_motion_is_kept_thinner);
    tcase_add_test(tcase, modes_that_couple_share_as_well);
    tcase_add_test(tcase, largest_closings_are_those_of_the_history);
    tcase_add_test(tcase, the_needed_gap_is_exact);
    tcase_add_test(tcase, free_bodies_without_a_ground_motion);
    suite_add_tcase(suite, tcase);
    return suite;
}
