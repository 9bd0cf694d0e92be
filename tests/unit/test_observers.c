/* Observers of a run: each may be left out, or one added, and the motion keeps its bits; one that asks for segments
 * alone is shown the whole motion, in free vibration and in a study too. */
#include <check.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/observe/observe_contacts.h"
#include "core/run/baseline.h"
#include "core/run/run_private.h"
#include "march.h"
#include "observe_gap.h"
#include "scenes.h"

static const int towers[] = {4, 5};

/* Laws and methods of every kind: nonlinear, linear with and without residual, sticking, impulses; located, in steps. */
static const struct scene {
    const char *law, *method;
    bool locate, history;
} scenes[] = {
    {"rubber", "exact", true, false},
    {"rubber", "exact", true, true},
    {"hertz-damp", "exact", true, false},
    {"kelvin-voigt-no-tension", "exact", true, true},
    {"stereomechanical", "exact", true, false},
    {"rubber", "dormand-prince", true, false},
    {"jankowski", "newmark", true, false},
    {"kelvin-voigt", "hht", false, false},
    {"rubber", "hht", false, true},
};
enum { SCENES = sizeof scenes / sizeof *scenes };

static struct thud_model *make_model(const char *name)
{
    struct march_law law = march_law(name, NULL);
    if (strcmp(name, "rubber") == 0)
        law = march_law("rubber", "stiffness", 0.36e3 * pow(1000, 2.65), "thickness", 0.05, NULL);
    return march_row(2, towers, false, 0.03, &law);
}

static struct thud_run_options options_of(const struct scene *scene)
{
    struct thud_run_options o;
    thud_run_options_init(&o);
    o.method = thud_method_find(scene->method);
    o.locate = scene->locate;
    o.keep_history = scene->history;
    o.unjudged = true;
    return o;
}

/* The observer with this table, or all. */
static void leave_out(struct thud_run *run, const struct thud_observer *table)
{
    int left = 0;
    for (int i = 0; i < run->observers; i++)
        if (table && run->observer[i].table != table)
            run->observer[left++] = run->observer[i];
    run->observers = left;
}

static void finish(struct thud_run *run)
{
    struct thud_error err = {0};
    for (bool done = false; !done;)
        ck_assert_msg(thud_run_advance(run, 1000, &done, &err) == THUD_OK, "%s", err.what);
}

static void check_same_motion(const struct thud_run *a, const struct thud_run *b)
{
    const size_t n = (size_t)a->state.model->nmodes * sizeof(double);
    ck_assert(memcmp(a->state.q, b->state.q, n) == 0);
    ck_assert(memcmp(a->state.qd, b->state.qd, n) == 0);
    ck_assert_int_eq(a->work.steps, b->work.steps);
    ck_assert_int_eq(a->work.events, b->work.events);
    ck_assert_int_eq(a->work.force_evaluations, b->work.force_evaluations);
    ck_assert_int_eq(a->work.samples_fast, b->work.samples_fast);
    ck_assert_int_eq(a->work.samples_jumped, b->work.samples_jumped);
}

/* Leaves out each of them in turn, and then all. Returns the number of events. */
static long check_left_out(const struct thud_model *model, const struct thud_record *record,
                           const struct thud_run_options *options)
{
    struct thud_run *all, *run;
    ck_assert_int_eq(thud_run_create(model, record, options, &all, NULL), THUD_OK);
    const int observers = all->observers;
    const struct thud_observer *out[THUD_OBSERVERS_MAX + 1] = {NULL};
    for (int i = 0; i < observers; i++)
        out[i] = all->observer[i].table;
    finish(all);
    for (int i = 0; i <= observers; i++) {
        ck_assert_int_eq(thud_run_create(model, record, options, &run, NULL), THUD_OK);
        leave_out(run, out[i]);
        finish(run);
        check_same_motion(run, all);
        thud_run_free(run);
    }
    long events = all->work.events;
    thud_run_free(all);
    return events;
}

START_TEST(each_may_be_left_out)
{
    struct thud_model *model = make_model(scenes[_i].law);
    struct thud_record *record = march_motion(1);
    struct thud_run_options options = options_of(&scenes[_i]);
    ck_assert_int_gt(check_left_out(model, record, &options), 10);
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

/* Random scenes, with storeys that yield and with struck columns. */
START_TEST(each_may_be_left_out_of_random_scenes)
{
    static const unsigned long long seed[4][2] = {{3, 41},
                                                  {SCENES_WIDE + 6, SCENES_WIDE + 13},
                                                  {SCENES_YIELDING + 2, SCENES_YIELDING + 15},
                                                  {SCENES_COLUMNS + 7, SCENES_COLUMNS + 12}};
    long events = 0;
    for (int i = 0; i < 2; i++) {
        struct scenes_one one;
        struct thud_model *model;
        struct thud_run_options options = options_of(&scenes[i]); /* with and without histories */
        scenes_draw(&one, seed[_i][i]);
        options.tail_s = one.scene.analysis.tail_s;
        ck_assert_int_eq(thud_scene_assemble(&one.scene, &model, NULL), THUD_OK);
        events += check_left_out(model, one.record, &options);
        thud_model_free(model);
        scenes_clear(&one);
    }
    ck_assert_int_gt(events, 10);
}
END_TEST

/* Its pieces follow each other from the start to the end, and the gap widens by the residual indentations alone. */
START_TEST(one_more_sees_the_whole_motion)
{
    struct thud_model *model = make_model(scenes[_i].law);
    struct thud_record *record = march_motion(1);
    struct thud_run_options options = options_of(&scenes[_i]);
    struct thud_run *all, *run;
    struct observe_gap gap = {.narrowest_m = INFINITY};
    ck_assert_int_eq(thud_run_create(model, record, &options, &all, NULL), THUD_OK);
    finish(all);
    ck_assert_int_eq(thud_run_create(model, record, &options, &run, NULL), THUD_OK);
    thud_run_observe(run, &observe_gap, &gap);
    finish(run);
    check_same_motion(run, all);
    ck_assert_double_eq_tol(gap.covered_s, run->state.end_s, 1e-9);
    ck_assert_double_eq_tol(gap.until_s, run->state.end_s, 1e-9);
    ck_assert_double_lt(gap.hole_s, 1e-9);
    const struct thud_contact_result *c = &run->result.contact[0];
    ck_assert_double_eq_tol(gap.widened_m, c->residual_m, 1e-12);
    ck_assert_double_eq_tol(gap.gap_m, 0.03 + c->residual_m - thud_model_gap_sum(model, 0, run->state.q), 1e-12);
    ck_assert_int_gt(gap.switches, 10);
    if (scenes[_i].history) { /* at the ends of pieces the histories have the gap too, as the negative indentation */
        const struct thud_history *h = thud_run_history(run);
        double least = INFINITY;
        for (size_t i = 0; i < h->rows; i++)
            least = fmin(least, -h->value[i * (size_t)h->columns + (size_t)thud_history_indentation(h, 0)]);
        ck_assert_double_ge(gap.narrowest_m, least - 1e-9);
        ck_assert_double_lt(gap.narrowest_m, fmax(0.5 * least, 1e-6));
    }
    thud_run_free(all);
    thud_run_free(run);
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

/* Two runs of a study, which leaves out the end of a run where nothing new comes: in the second there is this observer
 * too, or without `with` the peaks are not. */
static void study_runs(struct observe_gap *with, double *shared_s, struct thud_run *run[2],
                       void (*check)(struct thud_run *const run[2]))
{
    struct thud_model *model = make_model("kelvin-voigt-no-tension");
    struct thud_record *record = march_motion(1);
    struct thud_run_options options = options_of(&scenes[2]);
    struct thud_baseline_motion *baseline;
    options.tail_s = 30;
    ck_assert_int_eq(thud_baseline_create(model, 0, record, &options, &baseline, NULL), THUD_OK);
    for (bool done = false; !done;)
        ck_assert_int_eq(thud_baseline_advance(baseline, 1000, &done, NULL), THUD_OK);
    for (int i = 0; i < 2; i++) {
        ck_assert_int_eq(thud_baseline_run(baseline, model, record, &options, &run[i], shared_s, NULL), THUD_OK);
        if (i == 1 && with) {
            with->until_s = *shared_s;
            thud_run_observe(run[i], &observe_gap, with);
        } else if (i == 1) {
            leave_out(run[i], &thud_observe_peaks);
        }
        finish(run[i]);
    }
    ck_assert_int_gt(run[0]->work.samples_jumped, 500);
    ck_assert_int_gt(run[0]->work.events, 10);
    ck_assert_int_eq(run[1]->work.events, run[0]->work.events);
    ck_assert_double_eq(run[1]->result.contact[0].force.value, run[0]->result.contact[0].force.value);
    check(run);
    for (int j = 0; j < model->nmodes; j++)
        ck_assert_double_eq_tol(run[1]->state.qd[j], run[0]->state.qd[j], 1e-12 * run[0]->state.speed_mps);
    thud_run_free(run[0]);
    thud_run_free(run[1]);
    thud_baseline_free(baseline);
    thud_model_free(model);
    thud_record_free(record);
}

static void check_all_of_it(struct thud_run *const run[2])
{
    ck_assert_int_eq(run[1]->work.samples_jumped, 0);
    for (int s = 0; s < 2; s++)
        for (int i = 0; i < towers[s]; i++) {
            const struct thud_floor_result *a = &run[0]->result.structure[s].floor[i],
                                           *b = &run[1]->result.structure[s].floor[i];
            ck_assert_double_eq(a->displacement.value, b->displacement.value);
            ck_assert_double_eq(a->acceleration.value, b->acceleration.value);
        }
}

/* One that cannot say whether it needs the end is shown it. */
START_TEST(one_more_sees_the_end_in_a_study_too)
{
    struct observe_gap gap = {.narrowest_m = INFINITY};
    struct thud_run *run[2];
    double shared_s;
    study_runs(&gap, &shared_s, run, check_all_of_it);
    ck_assert_double_gt(gap.covered_s, 30);
    ck_assert_double_eq_tol(gap.covered_s, gap.until_s - shared_s, 1e-9);
    ck_assert_double_lt(gap.hole_s, 1e-9);
}
END_TEST

static void check_sooner(struct thud_run *const run[2])
{
    ck_assert_int_ge(run[1]->work.samples_jumped, run[0]->work.samples_jumped);
}

/* Without the peaks, the end begins where no contact can follow. */
/* An observer: the length of the shortest piece. */
static enum thud_status note_shortest(void *own, const struct thud_observation *o, struct thud_error *err)
{
    double *shortest_s = own;
    (void)err;
    *shortest_s = fmin(*shortest_s, o->s * o->seg->h_s);
    return THUD_OK;
}

/* A body meets the wall so short before a kink of the ground motion that rounding alone lies between: the motion goes on
 * from the kink, as a piece of that length would have nothing but rounding in it. */
START_TEST(no_piece_is_of_rounding_alone)
{
    static const struct thud_observer shortest = {.segment = note_shortest};
    static const double zeros[40];
    const struct march_law law = march_law("linear", "stiffness", 1e9, NULL);
    struct thud_record *record = NULL;
    ck_assert_int_eq(thud_record_create(zeros, 40, 0.01, &record, NULL), THUD_OK);
    for (double before = 1e-15; before < 2e-13; before *= 10) {
        struct thud_model *model = march_mass_and_wall(320e3, 0, 0, 1, 0.05 * (1 - before), &law);
        struct thud_run_options options;
        struct thud_run *run = NULL;
        double shortest_s = INFINITY;
        bool done = false;
        thud_run_options_init(&options);
        options.keep_history = true; /* without it what is free of contact is one block */
        ck_assert_int_eq(thud_run_create(model, record, &options, &run, NULL), THUD_OK);
        thud_run_observe(run, &shortest, &shortest_s);
        while (!done)
            ck_assert_int_eq(thud_run_advance(run, 1000, &done, NULL), THUD_OK);
        ck_assert_int_eq(run->result.contact[0].impacts, 1);
        ck_assert_msg(shortest_s > 1e-13, "%g before: a piece of %g s", before, shortest_s);
        thud_run_free(run);
        thud_model_free(model);
    }
    thud_record_free(record);
}
END_TEST

START_TEST(the_end_is_asked_of_those_that_are_there)
{
    struct thud_run *run[2];
    double shared_s;
    study_runs(NULL, &shared_s, run, check_sooner);
}
END_TEST

/* An observer of one more quantity: the largest total acceleration of each floor at the ends of pieces. */
enum { FLOORS = 9, MODES = 64 };
struct accelerations {
    double largest_mps2[FLOORS];
};

static enum thud_status note_accelerations(void *own, const struct thud_observation *o, struct thud_error *err)
{
    struct accelerations *a = own;
    const struct thud_model *m = o->state->model;
    double q[MODES], qd[MODES], force[MODES], out[MODES];
    (void)err;
    ck_assert(m->ndof == FLOORS && m->nmodes <= MODES && m->nrows <= MODES);
    for (int end = 0; end < 2; end++) {
        thud_observation_state(o, end * o->s, q, qd);
        thud_observation_forces(o, end * o->s, force);
        thud_observation_acceleration(o, end * o->s, q, qd, force, out);
        for (int i = 0; i < m->ndof; i++)
            a->largest_mps2[i] = fmax(a->largest_mps2[i], fabs(thud_model_floor(m, i, out)));
    }
    return THUD_OK;
}

/* It finds the peaks of the run, which have code of their own: all of them where a step knows its ends alone, with and
 * without polynomials, and none larger where they are read inside of steps too. */
START_TEST(accelerations_by_any_method)
{
    static const struct {
        const char *method;
        bool locate, history;
        double least;
    } by[] = {{"kr-alpha", false, false, 1 - 1e-9}, {"kr-alpha", false, true, 1 - 1e-9},
              {"hht", false, false, 1 - 1e-9},      {"rk4", true, false, 0.98},
              {"dormand-prince", true, false, 0.5}, {"exact", true, false, 0.5}};
    static const struct thud_observer table = {.segment = note_accelerations};
    const struct scene scene = {"kelvin-voigt", by[_i].method, by[_i].locate, by[_i].history};
    struct thud_record *record = march_motion(1);
    struct thud_model *model = make_model(scene.law);
    struct thud_run_options options = options_of(&scene);
    struct accelerations seen = {0};
    struct thud_run *run = NULL;
    bool done = false;
    ck_assert_int_eq(thud_run_create(model, record, &options, &run, NULL), THUD_OK);
    thud_run_observe(run, &table, &seen);
    while (!done)
        ck_assert_int_eq(thud_run_advance(run, 1000, &done, NULL), THUD_OK);
    for (int s = 0, i = 0; s < model->nstructures; s++)
        for (int f = 0; f < model->structure[s].n; f++, i++) {
            const double peak = run->result.structure[s].floor[f].acceleration.value;
            ck_assert_double_gt(peak, 5);
            ck_assert_double_ge(seen.largest_mps2[i], by[_i].least * peak);
            ck_assert_double_le(seen.largest_mps2[i], (1 + 1e-9) * peak);
        }
    thud_run_free(run);
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

Suite *thud_suite(void)
{
    Suite *s = suite_create("observers");
    TCase *t = tcase_create("observers");
    tcase_add_loop_test(t, each_may_be_left_out, 0, SCENES);
    tcase_add_loop_test(t, each_may_be_left_out_of_random_scenes, 0, 4);
    tcase_add_loop_test(t, one_more_sees_the_whole_motion, 0, SCENES);
    tcase_add_test(t, one_more_sees_the_end_in_a_study_too);
    tcase_add_loop_test(t, accelerations_by_any_method, 0, 6);
    tcase_add_test(t, no_piece_is_of_rounding_alone);
    tcase_add_test(t, the_end_is_asked_of_those_that_are_there);
    suite_add_tcase(s, t);
    return s;
}
