/* Random scenes answered in every way that must give the same result (tests/soak/cross.c takes many more). */
#include <check.h>
#include <string.h>

#include "scenes.h"
#include "scenes_check.h"

/* Every way that `only` names gives the same result. */
static void holds(unsigned long long seed, const char *only)
{
    struct scenes_tally tally = {.only = only};
    scenes_check(seed, &tally);
    ck_assert_int_eq(tally.wrong, 0);
    ck_assert_int_eq(tally.wild, 0);
}

START_TEST(drawn_scenes)
{
    /* those of the first that take no time, here and below */
    static const unsigned long long seeds[] = {1,  2,  3,  4,  6,  8,  10, 12, 14, 16, 22, 24, 27,  29,
                                               31, 33, 35, 37, 39, 41, 45, 47, 49, 52, 54, 55, 1103};
    struct scenes_tally tally = {.only = ""};
    for (size_t i = 0; i < sizeof seeds / sizeof *seeds; i++)
        scenes_check(seeds[i], &tally);
    ck_assert_int_eq(tally.wrong, 0);
    ck_assert_int_gt(tally.pounding, 8);
}
END_TEST

/* Storeys that yield, in all kinds of rows. */
START_TEST(yielding_scenes)
{
    static const unsigned long long seeds[] = {1, 2, 3, 4, 5, 7, 8, 9, 12, 13};
    struct scenes_tally tally = {.only = ""};
    for (size_t i = 0; i < sizeof seeds / sizeof *seeds; i++)
        scenes_check(SCENES_YIELDING + seeds[i], &tally);
    ck_assert_int_eq(tally.wrong, 0);
    ck_assert_int_gt(tally.pounding, 3);
}
END_TEST

/* Lead-rubber bearings and pendulums, in some scenes under storeys that yield. */
START_TEST(scenes_on_isolators)
{
    static const unsigned long long seeds[] = {0, 2, 4, 6, 7, 8, 9, 10, 11};
    struct scenes_tally tally = {.only = ""};
    for (size_t i = 0; i < sizeof seeds / sizeof *seeds; i++)
        scenes_check(SCENES_ISOLATORS + seeds[i], &tally);
    ck_assert_int_eq(tally.wrong, 0);
    ck_assert_int_gt(tally.pounding, 3);
}
END_TEST

/* Buildings on soil: shear, by their matrix and isolated ones, elastic and yielding, with P-Delta and without. */
START_TEST(scenes_on_soil)
{
    static const unsigned long long seeds[] = {0, 2, 4, 5, 7, 8, 9, 10, 11, 12};
    struct scenes_tally tally = {.only = ""};
    for (size_t i = 0; i < sizeof seeds / sizeof *seeds; i++)
        scenes_check(SCENES_SOIL + seeds[i], &tally);
    ck_assert_int_eq(tally.wrong, 0);
    ck_assert_int_gt(tally.pounding, 3);
}
END_TEST

/* Isolators, walls that give, links and all else together. */
START_TEST(mixed_scenes)
{
    static const unsigned long long seeds[] = {2, 16, 25, 28, 31, 40009};
    struct scenes_tally tally = {.only = ""};
    for (size_t i = 0; i < sizeof seeds / sizeof *seeds; i++)
        scenes_check(SCENES_MIXED + seeds[i], &tally);
    ck_assert_int_eq(tally.wrong, 0);
    ck_assert_int_gt(tally.pounding, 3);
}
END_TEST

/* The weight on drifting storeys, elastic and yielding. */
START_TEST(scenes_with_p_delta)
{
    struct scenes_tally tally = {.only = ""};
    static const unsigned long long seeds[] = {0, 1, 3, 4, 6, 7, 8, 9, 14, 17, 18};
    for (size_t i = 0; i < sizeof seeds / sizeof *seeds; i++)
        scenes_check(SCENES_P_DELTA + seeds[i], &tally);
    ck_assert_int_eq(tally.wrong, 0);
    ck_assert_int_gt(tally.pounding, 3);
}
END_TEST

/* Springs, dashpots, restrainers and struts between neighbours, in all kinds of rows. */
START_TEST(linked_scenes)
{
    static const unsigned long long seeds[] = {0, 1, 2, 3, 4, 5, 6, 9, 10, 11, 13};
    struct scenes_tally tally = {.only = ""};
    for (size_t i = 0; i < sizeof seeds / sizeof *seeds; i++)
        scenes_check(SCENES_LINKS + seeds[i], &tally);
    ck_assert_int_eq(tally.wrong, 0);
    ck_assert_int_gt(tally.pounding, 3);
}
END_TEST

/* Light and heavy floors in one building, dashpots up to the critical ones, walls, isolated buildings and first speeds. */
START_TEST(wide_scenes)
{
    static const unsigned long long seeds[] = {2,  4,  7,  8,  28, 31, 40, 43,  66,  70,  73,  74,
                                               77, 78, 84, 94, 95, 97, 99, 100, 101, 105, 107, 108};
    struct scenes_tally tally = {.only = ""};
    for (size_t i = 0; i < sizeof seeds / sizeof *seeds; i++)
        scenes_check(SCENES_WIDE + seeds[i], &tally);
    ck_assert_int_eq(tally.wrong, 0);
    ck_assert_int_gt(tally.pounding, 20);
}
END_TEST

/* Slabs against columns that give, or do not, in rows of buildings. */
START_TEST(scenes_of_columns)
{
    static const unsigned long long seeds[] = {4, 5, 7, 9, 14, 18, 20, 22, 24};
    struct scenes_tally tally = {.only = ""};
    for (size_t i = 0; i < sizeof seeds / sizeof *seeds; i++)
        scenes_check(SCENES_COLUMNS + seeds[i], &tally);
    ck_assert_int_eq(tally.wrong, 0);
    ck_assert_int_gt(tally.pounding, 8);
}
END_TEST

/* Buildings by their matrix or modes among others, also where slabs strike their columns; with Dormand-Prince as well. */
START_TEST(scenes_of_matrices)
{
    static const unsigned long long seeds[] = {0, 1, 2, 3, 6, 8, 9, 10, 11};
    struct scenes_tally tally = {.only = "", .slow = true};
    for (size_t i = 0; i < sizeof seeds / sizeof *seeds; i++)
        scenes_check(SCENES_MATRICES + seeds[i], &tally);
    scenes_tally_print(&tally, stdout);
    ck_assert_int_eq(tally.wrong, 0);
    ck_assert_int_gt(tally.pounding, 4);
}
END_TEST

/* Scenes that once had another result for every tolerance: a blow at one level reversed the rate of a contact at
 * another one, which then went on in the wrong phase for a step. */
START_TEST(scenes_whose_answers_differed)
{
    static const unsigned long long seeds[] = {1129, 1344};
    holds(seeds[_i], "tolerance");
}
END_TEST

/* A contact at rest that once bounced off the error of its rate when its neighbour was struck (6335): held no more for
 * the shortest time, and a peak there. */
START_TEST(a_held_contact_does_not_bounce)
{
    holds(6335, "tolerance 1e-8");
}
END_TEST

/* Scenes that once had another peak when their record's intervals were halved or their row mirrored: one that Newton's
 * method met to the last bit was lost. */
START_TEST(scenes_that_lost_a_peak)
{
    static const unsigned long long seeds[] = {1243, 1307};
    holds(seeds[_i], "halved");
}
END_TEST

/* Neighbours without a clearance that stand still at first: by rounding they touched when the ground began to move, but
 * a study knew that they need not (391, 30176, 40036); or the other way round, where a study's run began later than the
 * ground (255, 6335). */
START_TEST(neighbours_at_rest_do_not_touch)
{
    static const unsigned long long seeds[] = {391, 255, 6335, 30176, 40036};
    struct scenes_tally tally = {.only = "study"};
    scenes_check(seeds[_i], &tally);
    ck_assert_int_eq(tally.wrong, 0);
}
END_TEST

/* A building that moves by a micrometre beside a body that moves by a metre: its series ended where its terms were small
 * beside the body's, and its accelerations, 1e-7 m/s2, were off by 3e-4 of themselves. */
START_TEST(series_end_by_each_structure)
{
    holds(SCENES_WIDE + 281, "halved");
}
END_TEST

/* Modes whose motion dies out within an interval to less than the smallest number were taken for some that damping
 * couples, and stood still between contacts: an acceleration was off by 2.4e-4 of itself. */
START_TEST(modes_that_die_out_in_an_interval_move)
{
    holds(SCENES_WIDE + 589, "resampled");
}
END_TEST

/* An undamped building that leans on a Hertz wall fifteen times: each contact lost 0.08 of the tolerance, all of them more
 * than the ledger allowed, and there was no result. */
START_TEST(many_contacts_add_up_in_the_ledger)
{
    holds(SCENES_COARSE + 8001, "tolerance 1e-6");
}
END_TEST

/* A step 32 times as long as the sliver before it took over how fast the forces had been found there: the rates at its nodes
 * were still those of the first guess, and the ledger lost 4e-7 in this one step. */
START_TEST(forces_are_found_anew_in_a_longer_step)
{
    struct scenes_one one;
    struct scenes_solution a;
    scenes_draw(&one, SCENES_COARSE + SCENES_COLUMNS + 8020);
    scenes_run(&one, &(struct scenes_options){.tolerance = 1e-6}, &a);
    ck_assert_int_eq(a.status, THUD_OK);
    ck_assert_double_le(a.error_ratio, 1e-8);
    scenes_answer_clear(&a);
    scenes_clear(&one);
}
END_TEST

/* A force that begins to hold a contact well inside its interval was taken for one at its end, by ten times a coarse
 * tolerance: the contact let go at once, turned, and was held again, 100,000 times. */
START_TEST(held_contacts_let_go_at_the_end_of_their_interval)
{
    static const unsigned long long seeds[] = {SCENES_SOIL + 201, SCENES_ISOLATORS + 29, SCENES_MATRICES + 79};
    static const double tolerance = 1e-2;
    struct scenes_one one;
    struct scenes_solution a, other;
    int at;
    scenes_draw(&one, SCENES_COARSE + seeds[_i]);
    scenes_run(&one, &(struct scenes_options){.method = "dormand-prince", .tolerance = 1e-9}, &other);
    scenes_run(&one, &(struct scenes_options){.tolerance = tolerance, .most = 20000}, &a);
    ck_assert_msg(a.status == THUD_OK, "%s", a.err.what);
    ck_assert_int_eq(a.stopped, false);
    ck_assert_double_le(scenes_apart(&a, &other, 1e-2, NULL, 0, &at), 10 * tolerance);
    scenes_answer_clear(&a);
    scenes_answer_clear(&other);
    scenes_clear(&one);
}
END_TEST

/* A swing of 12 m over which an undamped mode of 2,000 rad/s rides: the series ended where its terms were small beside the
 * swing, and thousands of them put an acceleration off by 3e-8. */
START_TEST(series_end_by_accelerations_too)
{
    holds(SCENES_COARSE + SCENES_WIDE + 5035, "resampled");
}
END_TEST

/* The force of a storey that yields to a hundred times and more its yield drift: nearly all of it cancels the elastic
 * spring's, and an error was allowed as a part of all of it. Accelerations were off by 8 to 100 times the tolerance. */
START_TEST(yielding_storeys_keep_to_their_yield_force)
{
    static const double tolerance[] = {1e-4, 1e-6, 1e-8, 1e-9};
    struct scenes_one one;
    struct scenes_solution a, other;
    scenes_draw(&one, SCENES_COARSE + SCENES_ISOLATORS + 24);
    scenes_run(&one, &(struct scenes_options){.method = "dormand-prince", .tolerance = 1e-11}, &other);
    scenes_run(&one, &(struct scenes_options){.tolerance = tolerance[_i]}, &a);
    int at;
    ck_assert_int_eq(a.status, THUD_OK);
    ck_assert_double_le(scenes_apart(&a, &other, 1e-2, NULL, 0, &at), tolerance[_i]);
    scenes_answer_clear(&a);
    scenes_answer_clear(&other);
    scenes_clear(&one);
}
END_TEST

/* Scenes that once had no result, or none in any time: an indentation of rounding's size at contact onset held against
 * one of 0 (38); steps made tiny by the next kink, or by a touch, that never grew again (119, 196, 226); a row
 * of bounces come to rest with a speed left over, which a force had to undo at once (1094, 2110, 2668); equal
 * neighbours that rounding now held and now let go (1526, 20010); a contact without a force, struck by another one
 * (6791); a force that rounding alone kept from its tolerance (50290); bounces under a heavy load, which followed each other
 * in less than a moment before they were slow enough to end (7148); a leaning building that lives by the work of its
 * weight, beside which the energy of the ground is nothing (21194); damping with d^(1/4) that begins at rest, where no
 * mode of vibration (73054) or no ground motion (72036) gives a speed to measure its error by. */
START_TEST(scenes_that_had_no_answer)
{
    static const unsigned long long seeds[] = {38,
                                               119,
                                               196,
                                               226,
                                               1094,
                                               2110,
                                               2668,
                                               1526,
                                               20010,
                                               6791,
                                               50290,
                                               SCENES_LINKS + 7148,
                                               SCENES_P_DELTA + 21194,
                                               SCENES_COARSE + SCENES_WIDE + 73054,
                                               SCENES_COLUMNS + 72036};
    struct scenes_one one;
    struct scenes_solution solution;
    scenes_draw(&one, seeds[_i]);
    scenes_run(&one, &(struct scenes_options){.tolerance = 1e-10, .most = 30000}, &solution);
    ck_assert_msg(solution.status == THUD_OK, "%llu: %s", seeds[_i], solution.err.what);
    ck_assert_msg(!solution.stopped, "%llu: %ld steps", seeds[_i], solution.steps);
    scenes_answer_clear(&solution);
    scenes_clear(&one);
}
END_TEST

/* Impulses at speeds that are taken as rest, whose sum of energies is rounding's. It chatters for long: its first
 * steps. */
START_TEST(impulses_at_rest_give_no_energy)
{
    struct scenes_one one;
    struct scenes_solution solution;
    scenes_draw(&one, SCENES_WIDE + 299);
    scenes_run(&one, &(struct scenes_options){.tolerance = 1e-9, .slice = 100, .most = 1500}, &solution);
    ck_assert_msg(solution.status == THUD_OK, "%s", solution.err.what);
    scenes_answer_clear(&solution);
    scenes_clear(&one);
}
END_TEST

/* Damping that goes with a low power of the indentation: the force of a slab on a column all but jumps right after contact
 * onset, and is largest in Dormand-Prince's first step, whose polynomial must not go beyond it. */
START_TEST(forces_that_jump_at_onset)
{
    struct scenes_one one;
    struct scenes_solution exact, other;
    int at;
    scenes_draw(&one, SCENES_COLUMNS + 579);
    scenes_run(&one, &(struct scenes_options){.tolerance = 1e-8}, &exact);
    scenes_run(&one, &(struct scenes_options){.method = "dormand-prince", .tolerance = 1e-9}, &other);
    double off = scenes_apart(&other, &exact, 1e-2, NULL, 0, &at);
    ck_assert_msg(off < 1e-6, "%s: off by %g", scenes_kind_name(exact.number[at].kind), off);
    scenes_answer_clear(&exact);
    scenes_answer_clear(&other);
    scenes_clear(&one);
}
END_TEST

/* Equal neighbours whose forces differ by rounding: one more that rounding now held and now let go, with its ground motion
 * or stiffness changed by 1e-9. */
START_TEST(equal_neighbours_do_not_switch_without_end)
{
    holds(20010, "nudged");
}
END_TEST

/* Equal neighbours that touch press on each other with forces of 1e-20 to 1e-4 N, which steps at coarse tolerances do not
 * resolve: they closed, turned and opened again in each step, up to a refusal. Now they take no more steps than fine
 * ones. */
START_TEST(equal_neighbours_rest_on_each_other)
{
    static const struct {
        unsigned long long seed;
        double tolerance;
    } known[] = {
        {SCENES_COARSE + 8011, 1e-3},
        {SCENES_EQUAL + SCENES_YIELDING + 72, 1e-3},
        {SCENES_EQUAL + SCENES_YIELDING + 77, 1e-4},
        {SCENES_EQUAL + SCENES_YIELDING + 89, 1e-4},
        {SCENES_EQUAL + SCENES_YIELDING + 149, 1e-4},
        {SCENES_EQUAL + SCENES_LINKS + 29, 1e-3},
        {SCENES_EQUAL + SCENES_LINKS + 37, 1e-3},
        {SCENES_EQUAL + SCENES_LINKS + 93, 1e-3},
        {SCENES_EQUAL + SCENES_LINKS + 121, 1e-3},
    };
    struct scenes_one one;
    struct scenes_solution fine, coarse;
    scenes_draw(&one, known[_i].seed);
    scenes_run(&one, &(struct scenes_options){.tolerance = 1e-7}, &fine);
    scenes_run(&one, &(struct scenes_options){.tolerance = known[_i].tolerance}, &coarse);
    ck_assert_msg(coarse.status == THUD_OK, "%s", coarse.err.what);
    ck_assert_int_eq(fine.status, THUD_OK);
    ck_assert_msg(coarse.steps <= 1.2 * (double)fine.steps, "%ld steps, and %ld fine ones", coarse.steps, fine.steps);
    scenes_answer_clear(&coarse);
    scenes_answer_clear(&fine);
    scenes_clear(&one);
}
END_TEST

/* A force that falls by its branch's damping in 1e-11 s: at the very moment of a turn or of a release its polynomial
 * has the wrong slope, and one state of the contact called for the other without end (2551). A light wall that is
 * pressed between two contacts moves by less than its forces are right to, and one of them turned to and fro in each step
 * (30027, 53,959 steps). Peaks stay near those of fine steps. */
START_TEST(stiff_contacts_do_not_chatter)
{
    static const struct {
        unsigned long long seed;
        long most;
        const char *method; /* that fine steps are taken by */
        double near;
    } known[] = {{2551, 100000, "exact", INFINITY}, {SCENES_MIXED + 30027, 1000, "dormand-prince", 1e-3}};
    struct scenes_one one;
    struct scenes_solution solution, fine;
    int at;
    scenes_draw(&one, known[_i].seed);
    scenes_run(&one, &(struct scenes_options){.tolerance = 1e-4, .most = known[_i].most}, &solution);
    scenes_run(&one, &(struct scenes_options){.method = known[_i].method, .tolerance = 1e-7}, &fine);
    ck_assert_msg(solution.status == THUD_OK, "%s", solution.err.what);
    ck_assert_msg(!solution.stopped, "%ld steps", solution.steps);
    const double apart = scenes_apart(&solution, &fine, 1e-2, NULL, 0, &at);
    ck_assert_msg(apart <= known[_i].near, "%s %d: off by %g", scenes_kind_name(solution.number[at].kind),
                  solution.number[at].place + 1, apart);
    scenes_answer_clear(&solution);
    scenes_answer_clear(&fine);
    scenes_clear(&one);
}
END_TEST

/* Steps that once stayed at 1/100 of what the tolerance asks for: after a sliver of time before a kink of the ground
 * motion (171), or where stiff contacts make more of an error in a step of middle length than in a long one (1170). */
START_TEST(steps_do_not_stay_short)
{
    static const unsigned long long seeds[] = {171, 1170};
    struct scenes_one one;
    struct scenes_solution solution;
    scenes_draw(&one, seeds[_i]);
    scenes_run(&one, &(struct scenes_options){.tolerance = 1e-6, .most = 20000}, &solution);
    ck_assert_msg(solution.status == THUD_OK, "%s", solution.err.what);
    ck_assert_int_lt(solution.steps, 6000);
    scenes_answer_clear(&solution);
    scenes_clear(&one);
}
END_TEST

/* Scenes in which a stepping method lost speeds, or got others, where an event lay so close to a step's start that the
 * step to it was lost in rounding. */
START_TEST(no_step_is_lost_in_rounding)
{
    static const unsigned long long seeds[] = {30226, 20477};
    struct scenes_tally tally = {.only = "dormand-prince", .slow = true};
    scenes_check(seeds[_i], &tally);
    ck_assert_int_eq(tally.wrong, 0);
    ck_assert_int_eq(tally.wild, 0);
}
END_TEST

/* Rubber whose damping goes by the stored energy, at clearance 0, and the same scene at 1/64 of its size: a speed of 1 nm/s
 * that was to keep out a division by 0 changed a force by 1.4e-6 of it. */
START_TEST(damping_by_energy_has_no_size)
{
    struct scenes_tally tally = {.only = "lengths down", .slow = true};
    scenes_check(488, &tally);
    ck_assert_int_eq(tally.wrong, 0);
    ck_assert_int_eq(tally.wild, 0);
}
END_TEST

/* What the rounding of many steps once left before a kink, 1e-18 s, was too short for the contact forces (40005, its
 * intervals halved). */
START_TEST(no_sliver_before_a_kink)
{
    struct scenes_one one;
    struct scenes_solution solution;
    scenes_draw(&one, 40005);
    scenes_resample(&one, 2);
    scenes_run(&one, &(struct scenes_options){.tolerance = 1e-10, .most = 30000}, &solution);
    ck_assert_msg(solution.status == THUD_OK, "%s", solution.err.what);
    ck_assert(!solution.stopped);
    scenes_answer_clear(&solution);
    scenes_clear(&one);
}
END_TEST

/* Bounces that lose no energy and are pressed on came ever closer together and ended the run: held contacts are solved
 * together, and the scene has one answer in every way. */
START_TEST(bounces_that_are_pressed_on_come_to_rest)
{
    struct scenes_tally tally = {.only = ""};
    scenes_check(SCENES_WIDE + 175, &tally);
    ck_assert_int_eq(tally.wrong, 0);
    ck_assert_int_eq(tally.failed, 0);
}
END_TEST

/* After a sliver of time before a kink of the ground motion the first guess of the forces was their polynomial 16000
 * steps on, 1e58 N, to which the iteration converged: no step was short enough at t = 2.6 s. */
START_TEST(guesses_stay_near_the_last_step)
{
    struct scenes_one one;
    struct scenes_solution solution;
    scenes_draw(&one, SCENES_WIDE + 299);
    scenes_run(&one, &(struct scenes_options){.tolerance = 1e-6, .most = 10500}, &solution);
    ck_assert_msg(solution.status == THUD_OK, "%s", solution.err.what);
    scenes_answer_clear(&solution);
    scenes_clear(&one);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("cross");
    TCase *tcase = tcase_create("cross");
    tcase_set_timeout(tcase, 60);
    tcase_add_test(tcase, drawn_scenes);
    tcase_add_test(tcase, linked_scenes);
    tcase_add_test(tcase, wide_scenes);
    tcase_add_test(tcase, yielding_scenes);
    tcase_add_test(tcase, scenes_with_p_delta);
    tcase_add_test(tcase, scenes_on_isolators);
    tcase_add_test(tcase, scenes_on_soil);
    tcase_add_test(tcase, mixed_scenes);
    tcase_add_test(tcase, scenes_of_columns);
    tcase_add_test(tcase, scenes_of_matrices);
    tcase_add_loop_test(tcase, neighbours_at_rest_do_not_touch, 0, 5);
    tcase_add_test(tcase, series_end_by_each_structure);
    tcase_add_test(tcase, modes_that_die_out_in_an_interval_move);
    tcase_add_test(tcase, many_contacts_add_up_in_the_ledger);
    tcase_add_test(tcase, forces_are_found_anew_in_a_longer_step);
    tcase_add_loop_test(tcase, held_contacts_let_go_at_the_end_of_their_interval, 0, 3);
    tcase_add_test(tcase, series_end_by_accelerations_too);
    tcase_add_loop_test(tcase, yielding_storeys_keep_to_their_yield_force, 0, 4);
    tcase_add_test(tcase, a_held_contact_does_not_bounce);
    tcase_add_loop_test(tcase, scenes_that_lost_a_peak, 0, 2);
    tcase_add_loop_test(tcase, scenes_whose_answers_differed, 0, 2);
    tcase_add_loop_test(tcase, steps_do_not_stay_short, 0, 2);
    tcase_add_loop_test(tcase, no_step_is_lost_in_rounding, 0, 2);
    tcase_add_test(tcase, damping_by_energy_has_no_size);
    tcase_add_test(tcase, no_sliver_before_a_kink);
    tcase_add_test(tcase, bounces_that_are_pressed_on_come_to_rest);
    tcase_add_test(tcase, guesses_stay_near_the_last_step);
    tcase_add_loop_test(tcase, stiff_contacts_do_not_chatter, 0, 2);
    tcase_add_test(tcase, equal_neighbours_do_not_switch_without_end);
    tcase_add_loop_test(tcase, equal_neighbours_rest_on_each_other, 0, 9);
    tcase_add_test(tcase, impulses_at_rest_give_no_energy);
    tcase_add_test(tcase, forces_that_jump_at_onset);
    tcase_add_loop_test(tcase, scenes_that_had_no_answer, 0, 15);
    suite_add_tcase(suite, tcase);
    return suite;
}
