/* Modes left out: the sum of those that stay by each one's own oscillator, an error that falls with every mode added,
 * energy that stays in balance in contact, every other method, and studies with their shortcuts. */
#include <check.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "ground/oscillator.h"
#include "scenes.h"
#include "study/methods/truncation.h"
#include "towers.h"

enum { FLOORS = 10, FINE = 200 };

static struct thud_scene *scene;
static struct thud_record *motion;
static struct thud_error error;

static void set_up(void)
{
    scene = malloc(sizeof *scene);
    thud_test_towers(scene);
    scene->interface[0].has_bumper = false;
    scene->interface[0].gap_m = 5;
    motion = thud_test_motion(1);
}

static void tear_down(void)
{
    thud_record_free(motion);
    free(scene);
}

static struct thud_solution answer_of(int modes, bool history)
{
    struct thud_solution solution;
    struct thud_run_options options;
    scene->analysis.modes = modes;
    ck_assert_int_eq(thud_scene_options(scene, &options, &error), THUD_OK);
    options.keep_history = history;
    ck_assert_msg(thud_scene_solve(scene, motion, &options, &solution, &error) == THUD_OK, "%s", error.what);
    return solution;
}

/* Sums over the kept modes of one floor at a moment. */
struct motion {
    double displacement, velocity, acceleration;
};

static struct motion floor_motion(const struct thud_model *m, int dof, int modes, const double *x, const double *v,
                                  const double *a)
{
    const struct thud_model_structure *s = &m->structure[m->dof_structure[dof]];
    struct motion sum = {0};
    for (int j = 0; j < s->n && j < modes; j++) {
        double share = s->phi[(dof - s->first) * s->n + j] * m->gamma[s->first + j];
        sum.displacement += share * x[s->first + j];
        sum.velocity += share * v[s->first + j];
        sum.acceleration += share * a[s->first + j];
    }
    return sum;
}

/* Largest values of every floor over the ground motion, the modes of the whole model marched in small steps. */
static void march(const struct thud_model *m, int modes, struct motion most[FLOORS])
{
    struct thud_oscillator oscillator[FLOORS];
    double x[FLOORS] = {0}, v[FLOORS] = {0}, total[FLOORS] = {0};
    memset(most, 0, FLOORS * sizeof *most);
    for (int j = 0; j < FLOORS; j++)
        thud_oscillator_init(&oscillator[j], m->omega[j], m->zeta[j], motion->dt_s / FINE);
    for (size_t i = 0; i < (motion->samples - 1) * FINE; i++) {
        const double *a = motion->a_mps2 + i / FINE;
        double slope = (a[1] - a[0]) / FINE, a0 = a[0] + slope * (double)(i % FINE), a1 = a0 + slope;
        for (int j = 0; j < FLOORS; j++) {
            thud_oscillator_step(&oscillator[j], a0, a1, &x[j], &v[j]);
            total[j] = thud_oscillator_acceleration(&oscillator[j], a1, x[j], v[j]) + a1;
        }
        for (int dof = 0; dof < FLOORS; dof++) {
            struct motion now = floor_motion(m, dof, modes, x, v, total);
            most[dof].displacement = fmax(most[dof].displacement, fabs(now.displacement));
            most[dof].velocity = fmax(most[dof].velocity, fabs(now.velocity));
            most[dof].acceleration = fmax(most[dof].acceleration, fabs(now.acceleration));
        }
    }
}

START_TEST(what_stays_is_the_sum_of_its_modes)
{
    scene->analysis.tail_s = 0;
    struct thud_solution whole = answer_of(0, false);
    for (int modes = 1; modes <= 5; modes += 2) {
        struct thud_solution few = answer_of(modes, false);
        struct motion most[FLOORS];
        march(whole.model, modes, most);
        ck_assert_int_eq(few.model->left_out, FLOORS - (modes < 4 ? modes : 4) - modes);
        for (int s = 0, dof = 0; s < 2; s++)
            for (int i = 0; i < few.model->structure[s].n; i++, dof++) {
                const struct thud_floor_result *r = &thud_run_result(few.run)->structure[s].floor[i];
                ck_assert_double_eq_tol(r->displacement.value / most[dof].displacement, 1, 1e-6);
                ck_assert_double_eq_tol(r->velocity.value / most[dof].velocity, 1, 1e-6);
                ck_assert_double_eq_tol(r->acceleration.value / most[dof].acceleration, 1, 1e-6);
            }
        thud_solution_clear(&few);
    }
    thud_solution_clear(&whole);
}
END_TEST

/* Sum over time and floors of m (u - u of all modes)^2: by orthogonality that of the modes left out alone. */
static double distance(const struct thud_solution *few, const struct thud_solution *all)
{
    const struct thud_history *a = thud_run_history(few->run), *b = thud_run_history(all->run);
    double sum = 0;
    size_t i = 0, k = 0, both = 0;
    while (i < a->rows && k < b->rows) { /* the peaks of each have rows of their own */
        if (a->time_s[i] != b->time_s[k]) {
            *(a->time_s[i] < b->time_s[k] ? &i : &k) += 1;
            continue;
        }
        for (int dof = 0; dof < FLOORS; dof++) {
            int column = thud_history_displacement(a, dof);
            double d =
                a->value[i * (size_t)a->columns + (size_t)column] - b->value[k * (size_t)b->columns + (size_t)column];
            sum += all->model->mass_kg[dof] * d * d;
        }
        i++;
        k++;
        both++;
    }
    ck_assert_uint_gt(both, a->rows / 2);
    return sum;
}

START_TEST(every_mode_brings_it_nearer)
{
    struct thud_solution all = answer_of(0, true);
    double before = INFINITY;
    for (int modes = 1; modes <= 6; modes++) {
        struct thud_solution few = answer_of(modes, true);
        double now = distance(&few, &all);
        ck_assert(now < before);
        ck_assert((modes == 6) == (now == 0));
        before = now;
        thud_solution_clear(&few);
    }
    thud_solution_clear(&all);
}
END_TEST

START_TEST(all_modes_are_the_same_answer)
{
    scene->interface[0].gap_m = 0.05;
    struct thud_solution all = answer_of(0, false), six = answer_of(6, false), more = answer_of(77, false);
    const struct thud_solution *same[] = {&six, &more};
    for (int k = 0; k < 2; k++) {
        ck_assert_int_eq(same[k]->model->left_out, 0);
        for (int s = 0; s < 2; s++)
            ck_assert_int_eq(memcmp(thud_run_result(all.run)->structure[s].floor,
                                    thud_run_result(same[k]->run)->structure[s].floor,
                                    (size_t)all.model->structure[s].n * sizeof(struct thud_floor_result)),
                             0);
    }
    thud_solution_clear(&all);
    thud_solution_clear(&six);
    thud_solution_clear(&more);
}
END_TEST

/* In contact the model with fewer modes is a model like any other: its energies add up, and the change is measured. */
START_TEST(in_contact_energy_adds_up_and_the_error_is_told)
{
    scene->interface[0].gap_m = 0.05;
    for (int modes = 1; modes <= 6; modes++) {
        struct thud_truncation t;
        struct thud_solution few = answer_of(modes, false);
        const struct thud_result *r = thud_run_result(few.run);
        ck_assert_int_gt(r->contact[3].impacts, 0);
        ck_assert(r->energy.error_ratio < 1e-10);
        ck_assert_int_eq(thud_truncation_measure(scene, motion, &few, &t, &error), THUD_OK);
        ck_assert_int_eq(t.modes, modes);
        if (modes == 6)
            ck_assert(t.acceleration == 0 && t.drift == 0 && t.force == 0);
        else
            ck_assert(t.acceleration > 1e-3 && t.drift > 1e-3 && t.force > 1e-3 && isfinite(t.force));
        thud_solution_clear(&few);
    }
}
END_TEST

/* An isolated building's damping couples its modes; one that is left out slows none of the others. */
START_TEST(damping_that_couples_modes_is_cut_too)
{
    struct thud_model *all, *few;
    struct thud_structure *s = &scene->structure[0];
    s->kind = THUD_ISOLATED;
    s->base_mass_kg = 320e3;
    s->isolation_stiffness_npm = 20e6;
    s->isolation_damping = 0.1;
    ck_assert_int_eq(thud_scene_assemble(scene, &all, &error), THUD_OK);
    scene->analysis.modes = 2;
    ck_assert_int_eq(thud_scene_assemble(scene, &few, &error), THUD_OK);
    ck_assert_int_eq(few->structure[0].modes, 2);
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) {
            double whole = all->structure[0].damping[i * 5 + j];
            ck_assert(whole != 0 && few->structure[0].damping[i * 2 + j] == whole);
        }
    for (int j = 0; j < 5; j++) /* what the building has, whatever stays of it */
        ck_assert(few->structure[0].omega[j] == all->structure[0].omega[j]);
    ck_assert_int_eq(few->left_out, 3 + 4);
    thud_model_free(all);
    thud_model_free(few);
}
END_TEST

/* A mode that is left out is not there: nothing marches it, and no step is short for its sake. */
START_TEST(what_is_left_out_costs_nothing)
{
    scene->interface[0].gap_m = 0.05;
    strcpy(scene->analysis.method, "rk4");
    struct thud_solution few = answer_of(1, false), all = answer_of(0, false);
    ck_assert_int_eq(few.model->ndof, FLOORS);
    ck_assert_int_eq(few.model->nmodes, 2);
    ck_assert_int_eq(all.model->nmodes, FLOORS);
    ck_assert_int_lt(thud_run_result(few.run)->work.steps, thud_run_result(all.run)->work.steps);
    thud_solution_clear(&few);
    thud_solution_clear(&all);
}
END_TEST

/* Second methods on the same few modes, in contact. */
START_TEST(other_methods_find_the_same)
{
    static const struct {
        const char *method;
        double step_s, tolerance;
    } other[] = {{"dormand-prince", NAN, 1e-6}, {"rk4", 1e-4, 1e-5}, {"newmark", 1e-4, 2e-3}, {"hht", 1e-4, 2e-3}};
    scene->interface[0].gap_m = 0.05;
    for (int modes = 1; modes <= 3; modes += 2) {
        strcpy(scene->analysis.method, "exact");
        struct thud_solution exact = answer_of(modes, false);
        ck_assert_int_gt(thud_run_result(exact.run)->contact[3].impacts, 0);
        for (size_t i = 0; i < sizeof other / sizeof *other; i++) {
            strcpy(scene->analysis.method, other[i].method);
            scene->analysis.step_s = other[i].step_s;
            struct thud_solution solution = answer_of(modes, false);
            for (int s = 0; s < 2; s++)
                for (int k = 0; k < exact.model->structure[s].n; k++) {
                    const struct thud_floor_result *a = &thud_run_result(solution.run)->structure[s].floor[k],
                                                   *b = &thud_run_result(exact.run)->structure[s].floor[k];
                    ck_assert_double_eq_tol(a->acceleration.value / b->acceleration.value, 1, other[i].tolerance);
                    ck_assert_double_eq_tol(a->drift.value / b->drift.value, 1, other[i].tolerance);
                }
            thud_solution_clear(&solution);
        }
        thud_solution_clear(&exact);
    }
}
END_TEST

/* Two buildings of one shape, of one mode each, touch on all floors at once: two modes cannot be given four impulses.
 * That is said, not guessed at. */
START_TEST(blows_that_few_modes_do_not_tell_apart)
{
    struct thud_solution solution;
    struct thud_interface *at = &scene->interface[0];
    at->contact.law = thud_law_find("stereomechanical");
    at->contact.value[thud_law_param(at->contact.law, "restitution")] = 0.6;
    at->gap_m = 0;
    scene->structure[1] = scene->structure[0];
    for (int i = 0; i < scene->structure[1].storeys; i++)
        scene->structure[1].stiffness_npm[i] *= 0.5;
    scene->analysis.modes = 1;
    ck_assert_int_eq(thud_scene_solve(scene, motion, NULL, &solution, &error), THUD_DIVERGED);
    ck_assert_ptr_nonnull(
        strstr(error.what, "more contacts are closed at once than the modes can distinguish, at t = "));
    ck_assert_str_eq(error.key, "modes");
    thud_solution_clear(&solution);
    at->contact.value[thud_law_param(at->contact.law, "restitution")] = 1e-9; /* and then they are held */
    ck_assert_int_eq(thud_scene_solve(scene, motion, NULL, &solution, &error), THUD_DIVERGED);
    ck_assert_str_eq(error.key, "modes");
    thud_solution_clear(&solution);
    scene->analysis.modes = 0;
    ck_assert_int_eq(thud_scene_solve(scene, motion, NULL, &solution, &error), THUD_OK);
    thud_solution_clear(&solution);
}
END_TEST

/* Two equal buildings side by side, of one mode each, that a third one pushes: their contacts let go and are held again
 * at one moment, and a method whose steps end at events crept on by a billionth of a nanosecond. */
START_TEST(events_at_one_moment_do_not_stop_a_method)
{
    struct scenes_one one;
    struct scenes_solution solution;
    scenes_draw(&one, 50104);
    one.scene.analysis.modes = 1;
    scenes_run(&one, &(struct scenes_options){.method = "dormand-prince", .most = 20000}, &solution);
    ck_assert_int_eq(solution.status, THUD_OK);
    ck_assert(!solution.stopped && solution.largest[SCENES_IMPACTS] > 0);
    scenes_answer_clear(&solution);
    scenes_clear(&one);
}
END_TEST

/* Modes of each building by its own key: those of all by analysis.modes, which its own key goes before. */
START_TEST(a_building_has_modes_of_its_own)
{
    scene->interface[0].gap_m = 0.06;
    struct thud_solution all = answer_of(2, false), whole = answer_of(0, false);
    ck_assert_int_eq(thud_scene_set(scene, "structures.1.modes", "2", &error), THUD_OK);
    ck_assert_int_eq(thud_scene_set(scene, "structures.2.modes", "2", &error), THUD_OK);
    struct thud_solution each = answer_of(_i, false);
    const struct thud_result *a = thud_run_result(all.run), *b = thud_run_result(each.run);
    ck_assert_int_eq(each.model->left_out, 2 + 4);
    for (int s = 0; s < 2; s++)
        for (int i = 0; i < a->structure[s].floors; i++)
            ck_assert_mem_eq(&a->structure[s].floor[i], &b->structure[s].floor[i], sizeof a->structure[s].floor[i]);
    thud_solution_clear(&each);
    scene->structure[1].modes = 0;
    scene->interface[0].gap_m = 5; /* B alone: none of its modes is left out */
    each = answer_of(0, false);
    ck_assert_int_eq(each.model->left_out, 2);
    scene->structure[0].modes = 0;
    thud_solution_clear(&whole);
    whole = answer_of(0, false);
    a = thud_run_result(whole.run);
    b = thud_run_result(each.run);
    ck_assert_double_eq(a->structure[1].floor[5].acceleration.value, b->structure[1].floor[5].acceleration.value);
    ck_assert_double_ne(a->structure[0].floor[3].acceleration.value, b->structure[0].floor[3].acceleration.value);
    thud_solution_clear(&each);
    thud_solution_clear(&whole);
    thud_solution_clear(&all);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("truncation");
    TCase *tcase = tcase_create("truncation");
    tcase_add_checked_fixture(tcase, set_up, tear_down);
    tcase_add_test(tcase, what_stays_is_the_sum_of_its_modes);
    tcase_add_test(tcase, every_mode_brings_it_nearer);
    tcase_add_test(tcase, all_modes_are_the_same_answer);
    tcase_add_test(tcase, in_contact_energy_adds_up_and_the_error_is_told);
    tcase_add_test(tcase, damping_that_couples_modes_is_cut_too);
    tcase_add_test(tcase, what_is_left_out_costs_nothing);
    tcase_add_test(tcase, other_methods_find_the_same);
    tcase_add_test(tcase, blows_that_few_modes_do_not_tell_apart);
    tcase_add_loop_test(tcase, a_building_has_modes_of_its_own, 0, 3);
    tcase_add_test(tcase, events_at_one_moment_do_not_stop_a_method);
    suite_add_tcase(suite, tcase);
    return suite;
}
