/* Where methods fail: each statement of the test cases, by closed forms and conserved quantities. */
#include <check.h>
#include <math.h>
#include <string.h>

#include "base/quantity.h"
#include "io/result/bench_rows.h"
#include "lab/bench/stability_report.h"
#include "study/methods/stability_private.h"
#include "towers.h"

static struct thud_test_case test_case(const char *name)
{
    struct thud_test_case e = {0};
    for (int i = 0; i < thud_test_case_count(); i++) {
        struct thud_error err = {0};
        ck_assert_msg(thud_test_case_run(i, &e, &err) == THUD_OK, "%s", err.what);
        if (strcmp(e.name, name) == 0)
            return e;
    }
    ck_abort_msg("no test case is called %s", name);
    return e;
}

#define NEAR(actual, expected, tolerance) ck_assert_double_eq_tol(actual, expected, tolerance)

/* A storey that yields is slowed by its yield force; found at the ends of steps alone, the turn lies elsewhere. */
START_TEST(an_unloading_is_missed)
{
    struct thud_test_case e = test_case("unloading-missed");
    double v = 0.6, omega = 12, d_y = 0.02;
    double permanent = 1e3 * (v * v / (omega * omega) - d_y * d_y) / (2 * d_y); /* m v^2 = k d_y^2 + 2 k d_y d_p */
    ck_assert_double_eq_tol(e.exact, permanent, 1e-9);
    ck_assert_double_eq_tol(e.computed, permanent, 1e-9);
    ck_assert_double_gt(fabs(e.naive - permanent), 1);
}
END_TEST

START_TEST(lagged_force_makes_energy)
{
    struct thud_test_case e = test_case("lagged-force");
    NEAR(e.naive, exp(THUD_PI * 0.125 / 2), 5e-3);
    NEAR(e.computed, 1, 1e-9);
}
END_TEST

START_TEST(trapezoidal_rule_gains_in_contact)
{
    struct thud_test_case e = test_case("trapezoidal-growth");
    ck_assert(e.naive > 10);
    NEAR(e.computed, 1, 1e-8);
}
END_TEST

START_TEST(graze_is_not_missed)
{
    struct thud_test_case e = test_case("grazing-contact");
    ck_assert(e.naive == 0);
    ck_assert(e.computed == 1);
}
END_TEST

START_TEST(both_roots_of_a_step_are_found)
{
    struct thud_test_case e = test_case("double-root");
    ck_assert(e.naive == 0);
    /* energy: v^2 + (omega gap)^2 = v0^2 */
    double v0 = 1.05 * 0.02 * 2 * THUD_PI, w = 0.02 * 2 * THUD_PI;
    NEAR(e.exact, sqrt(v0 * v0 - w * w), 1e-12);
    NEAR(e.computed, e.exact, 1e-9 * e.exact);
}
END_TEST

START_TEST(touch_at_the_start_is_an_event)
{
    struct thud_test_case e = test_case("event-at-the-start");
    ck_assert(e.naive < 0.95);
    NEAR(e.computed, 1, 1e-9);
}
END_TEST

START_TEST(slow_touch_does_not_glue)
{
    struct thud_test_case e = test_case("slow-onset");
    ck_assert(e.naive < 1e-3);
    NEAR(e.computed, 0.5, 1e-6);
}
END_TEST

START_TEST(stiff_restitution_stays_finite)
{
    struct thud_test_case e = test_case("stiff-restitution");
    ck_assert(!(fabs(e.naive - 1) < 0.02));
    NEAR(e.computed, 1, 1e-8);
}
END_TEST

START_TEST(force_jump_sticks)
{
    struct thud_test_case e = test_case("force-jump");
    ck_assert(fabs(e.naive - 1) > 0.02);
    NEAR(e.computed, 1, 1e-6);
}
END_TEST

START_TEST(endless_bounces_end)
{
    struct thud_test_case e = test_case("bounces-without-end");
    ck_assert(!(fabs(e.naive) < 0.01));
    NEAR(e.computed, 0, 1e-6);
}
END_TEST

START_TEST(dead_collision_is_dead)
{
    struct thud_test_case e = test_case("restitution-near-0");
    ck_assert(fabs(e.naive - 1e-3) > 0.01);
    NEAR(e.computed, 1e-3, 1e-8);
}
END_TEST

START_TEST(stiff_contact_keeps_energy)
{
    struct thud_test_case e = test_case("stiffness-1e13");
    ck_assert(fabs(e.naive - 1) > 0.02);
    NEAR(e.computed, 1, 1e-8);
}
END_TEST

/* Bodies that have parted keep their velocities: a run that ends there finds what one of two seconds does. */
START_TEST(parted_bodies_need_no_longer_run)
{
    static const char *const methods[] = {"newmark", "generalized-alpha", "lagged", "exact"};
    static const double speed_mps[] = {0.05, 2};
    for (size_t i = 0; i < sizeof methods / sizeof *methods; i++)
        for (size_t k = 0; k < 2; k++)
            for (int soft = 0; soft < 2; soft++) {
                struct thud_two_body pair;
                struct thud_solution whole;
                double found;
                soft ? thud_two_body_rubber(&pair) : thud_two_body_concrete(&pair);
                pair.approach_mps = speed_mps[k];
                pair.duration_s = 2;
                struct thud_stepping how = thud_stepping_of(methods[i], 1e-3, false);
                ck_assert_int_eq(thud_two_body_restitution(&pair, how, &found, NULL), THUD_OK);
                pair.method = how.method;
                pair.method_step_s = how.method->flags & THUD_METHOD_FIXED_STEP ? 1e-3 : 0;
                ck_assert_int_eq(thud_two_body_run(&pair, 2, &whole, NULL), THUD_OK);
                ck_assert_double_eq_tol(found * speed_mps[k], thud_two_body_separation(&whole), 1e-9 * speed_mps[k]);
                thud_solution_clear(&whole);
            }
}
END_TEST

START_TEST(light_body_leaves_as_it_must)
{
    struct thud_test_case e = test_case("mass-ratio-1e6");
    ck_assert(fabs(e.naive - 1) > 0.02);
    NEAR(e.computed, 1, 1e-8);
}
END_TEST

static const double omega_c = 62.83185307179586, bounced_s = 25;
static const double steps[] = {0.25, 0.125, 0.0625, 0.03125, 0.015625}; /* omega_c dt */
enum { STEPS = sizeof steps / sizeof *steps };

/* Share of its energy of motion at touch that a mass bouncing on a wall spring gains by each impact and the flight
 * behind it; impacts located. */
static double gain(const char *method, double omega_dt)
{
    struct thud_two_body bouncer = thud_bouncer();
    struct thud_solution solution;
    int n;
    thud_bouncer_spring(&bouncer, omega_c);
    ck_assert_int_eq(thud_bouncer_run(&bouncer, NULL, thud_stepping_of(method, omega_dt / omega_c, true), bounced_s,
                                      &solution, NULL, NULL),
                     THUD_OK);
    const struct thud_impact *impact = thud_run_impacts(solution.run, &n);
    ck_assert_int_gt(n, 30);
    double ratio = impact[n - 1].approach_mps / impact[0].approach_mps;
    thud_solution_clear(&solution);
    return (ratio * ratio - 1) / (n - 1);
}

/* The trapezoidal rule keeps the energy of a linear system at any step; so it does between impacts, and locating them
 * must take nothing away. */
START_TEST(located_newmark_keeps_energy)
{
    for (int i = 0; i < STEPS; i++)
        NEAR(gain("newmark", steps[i]), 0, 2e-7 * steps[i]);
}
END_TEST

/* Their damping of what a step does not resolve is of third order; a start behind each impact that were of a lower
 * order would show. */
START_TEST(located_alpha_methods_lose_by_their_damping_alone)
{
    static const char *const methods[] = {"hht", "generalized-alpha"};
    for (int k = 0; k < 2; k++)
        for (int i = 1; i + 1 < STEPS; i++) {
            double order = log2(gain(methods[k], steps[i]) / gain(methods[k], steps[i + 1]));
            ck_assert_msg(fabs(order - 3) < 0.1, "%s at %g: order %g", methods[k], steps[i], order);
        }
}
END_TEST

/* Central difference keeps v^2 + (omega x)^2 (1 - (omega h)^2/4), x from where the springs balance, and so gains where
 * the step that ends a contact is shorter, theta h, by (omega h)^2 (1 - theta^2)/4 of (omega x)^2 there: with x = d +
 * d_e, d = theta h v, and d_e the balance's place before the wall. */
START_TEST(located_central_difference_gains_by_its_last_step_alone)
{
    double gap = 0.02, w = thud_bouncer_omega_radps, v = sqrt(0.5 * 0.5 - w * w * gap * gap);
    double total = w * w + omega_c * omega_c, before = gap * w * w / total, omega = sqrt(total);
    for (int i = 0; i < STEPS; i++) {
        double h = steps[i] / omega_c, a = omega * h;
        double square = pow(a, 4) / 16, mixed = pow(a, 3) * omega * before / v / 2 * 2 / sqrt(27);
        double least = -1e-2 * (square + mixed), most = square + mixed;
        double found = gain("central-difference", steps[i]);
        ck_assert_msg(found > least && found < 1.1 * most, "at %g: %g, not within %g", steps[i], found, most);
    }
}
END_TEST

/* The whole study of the towers, made once for the tests that read it. */
static struct thud_stability *judged;

static void judge(void)
{
    static struct thud_scene scene;
    struct thud_record *record = thud_test_motion(1);
    thud_test_towers(&scene);
    ck_assert_int_eq(thud_stability_create(&scene, record, &judged, NULL), THUD_OK);
    for (int i = 0; i < judged->ncells; i++)
        ck_assert_int_eq(thud_stability_job(judged, i, NULL), THUD_OK);
    thud_record_free(record);
}

static void free_judged(void)
{
    thud_stability_free(judged);
}

START_TEST(free_vibration_is_bounded_up_to_the_limit)
{
    const struct thud_stability *s = judged;
    int beyond = 0;
    for (int i = 0; i < s->ncells; i++) {
        const struct thud_stability_cell *c = &s->cell[i];
        bool stable = isnan(c->omega_dt) || c->omega_dt < c->how.method->stability;
        ck_assert_msg((c->verdict[THUD_STABILITY_FREE] == THUD_BOUNDED) == stable, "%s at omega dt %g: %s",
                      c->how.method->name, c->omega_dt, thud_stability_verdict_word(c->verdict[THUD_STABILITY_FREE]));
        beyond += !stable;
        if (strcmp(c->how.method->name, "exact") == 0)
            for (int k = 0; k < THUD_STABILITY_KINDS; k++)
                ck_assert_int_eq(c->verdict[k], THUD_BOUNDED);
    }
    ck_assert_int_gt(beyond, 10);
}
END_TEST

static const struct thud_stability_cell *cell_of(const struct thud_stability *s, const char *method, bool located,
                                                 double omega_dt)
{
    for (int i = 0; i < s->ncells; i++) {
        const struct thud_stability_cell *c = &s->cell[i];
        if (strcmp(c->how.method->name, method) == 0 && c->how.locate == located &&
            (c->omega_dt == omega_dt || (isnan(c->omega_dt) && isnan(omega_dt))))
            return c;
    }
    ck_abort_msg("no cell of %s at %g", method, omega_dt);
    return NULL;
}

/* One start would call these bounded: the worst of several gains energy tens of times over. */
START_TEST(worst_start_at_the_wall_decides)
{
    const struct thud_stability *s = judged;
    static const double gaining[] = {2.7, 2.9, 3.6};
    for (int i = 0; i < 3; i++) {
        const struct thud_stability_cell *c = cell_of(s, "newmark", false, gaining[i]);
        ck_assert_int_ne(c->verdict[THUD_STABILITY_WALL], THUD_BOUNDED);
        ck_assert_msg(c->growth[THUD_STABILITY_WALL] > 25, "%g: %g", gaining[i], c->growth[THUD_STABILITY_WALL]);
        ck_assert_msg(c->end_least < 0.1 * c->growth[THUD_STABILITY_WALL], "all starts alike at %g", gaining[i]);
    }
    /* below the limit 2 of the linear system, with contacts that open and close */
    ck_assert_int_eq(cell_of(s, "central-difference", false, 1.9)->verdict[THUD_STABILITY_WALL], THUD_BLOWN_UP);
    ck_assert_int_eq(cell_of(s, "central-difference", false, 0.12)->verdict[THUD_STABILITY_WALL], THUD_BOUNDED);
}
END_TEST

/* The trapezoidal rule keeps the energy of each linear piece at any step, so with located impacts it gains none; what
 * it loses is what it stores when it leaves the wall. */
START_TEST(located_newmark_gains_from_no_start)
{
    const struct thud_stability *s = judged;
    int n = 0;
    for (int i = 0; i < s->ncells; i++)
        if (strcmp(s->cell[i].how.method->name, "newmark") == 0 && s->cell[i].how.locate) {
            NEAR(s->cell[i].growth[THUD_STABILITY_WALL], 1, 1e-3);
            n++;
        }
    ck_assert_int_eq(n, 11);
}
END_TEST

START_TEST(exact_alone_keeps_the_energy)
{
    const struct thud_stability *s = judged;
    int off = 0;
    const struct thud_stability_cell *exact = cell_of(s, "exact", true, NAN);
    NEAR(exact->growth[THUD_STABILITY_WALL], 1, 1e-9);
    NEAR(exact->end_least, 1, 1e-9);
    NEAR(exact->end_most, 1, 1e-9);
    for (int i = 0; i < s->ncells; i++) {
        const struct thud_stability_cell *c = &s->cell[i];
        if (c->omega_dt > 1.5 && !c->how.locate)
            off += !(fabs(c->end_most - 1) < 0.02 && fabs(c->end_least - 1) < 0.02);
    }
    ck_assert_int_gt(off, 40);
}
END_TEST

/* Every table and figure of a study stopped half-way: rows for what there is, and no number out of nothing. */
START_TEST(what_is_done_is_shown)
{
    struct thud_stability *s = NULL;
    struct thud_text text = {0};
    ck_assert_int_eq(thud_stability_create(NULL, NULL, &s, NULL), THUD_OK);
    for (int i = 0; i < 20; i++)
        ck_assert_int_eq(thud_stability_job(s, i, NULL), THUD_OK);
    ck_assert_int_lt(20, thud_stability_jobs(s));
    thud_stability_table(s, &text);
    ck_assert(strstr(text.data, "central-difference, located") != NULL);
    ck_assert(strstr(text.data, "nan") == NULL);
    thud_text_clear(&text);
    int rows[THUD_STABILITY_TABLES] = {s->ncells, s->ncells, s->nrestitutions, 0, s->nsummaries};
    for (int which = 0; which < THUD_STABILITY_TABLES; which++) {
        int lines = 0;
        const struct thud_rows table = thud_stability_rows(s, which);
        thud_rows_csv(&table, &text);
        for (size_t i = 0; i < text.size; i++)
            lines += text.data[i] == '\n';
        ck_assert_int_eq(lines, rows[which] + 1);
        thud_text_clear(&text);
    }
    struct thud_figure *map = thud_stability_map(s, THUD_STABILITY_WALL), *energies = thud_stability_energies(s);
    ck_assert_int_eq(thud_figure_check(map, NULL), THUD_OK);
    ck_assert_int_eq(thud_figure_check(energies, NULL), THUD_OK);
    ck_assert_int_eq((int)map->panel[0].map->nx, 11);
    thud_figure_free(map);
    thud_figure_free(energies);
    thud_stability_free(s);
}
END_TEST

Suite *thud_suite(void)
{
    Suite *suite = suite_create("stability");
    TCase *test_cases = tcase_create("test_cases"), *drift = tcase_create("drift"), *maps = tcase_create("maps");
    tcase_add_test(test_cases, an_unloading_is_missed);
    tcase_add_test(test_cases, lagged_force_makes_energy);
    tcase_add_test(test_cases, trapezoidal_rule_gains_in_contact);
    tcase_add_test(test_cases, graze_is_not_missed);
    tcase_add_test(test_cases, both_roots_of_a_step_are_found);
    tcase_add_test(test_cases, touch_at_the_start_is_an_event);
    tcase_add_test(test_cases, slow_touch_does_not_glue);
    tcase_add_test(test_cases, stiff_restitution_stays_finite);
    tcase_add_test(test_cases, force_jump_sticks);
    tcase_add_test(test_cases, endless_bounces_end);
    tcase_add_test(test_cases, dead_collision_is_dead);
    tcase_add_test(test_cases, stiff_contact_keeps_energy);
    tcase_add_test(test_cases, light_body_leaves_as_it_must);
    tcase_add_test(test_cases, parted_bodies_need_no_longer_run);
    tcase_set_timeout(test_cases, 60);
    tcase_set_timeout(drift, 60);
    tcase_add_test(drift, located_newmark_keeps_energy);
    tcase_add_test(drift, located_alpha_methods_lose_by_their_damping_alone);
    tcase_add_test(drift, located_central_difference_gains_by_its_last_step_alone);
    tcase_set_timeout(maps, 300);
    tcase_add_unchecked_fixture(maps, judge, free_judged);
    tcase_add_test(maps, free_vibration_is_bounded_up_to_the_limit);
    tcase_add_test(maps, what_is_done_is_shown);
    tcase_add_test(maps, exact_alone_keeps_the_energy);
    tcase_add_test(maps, worst_start_at_the_wall_decides);
    tcase_add_test(maps, located_newmark_gains_from_no_start);
    suite_add_tcase(suite, test_cases);
    suite_add_tcase(suite, drift);
    suite_add_tcase(suite, maps);
    return suite;
}
