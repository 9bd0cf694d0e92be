/* Parametric studies: rows against single results, ratios by hand, shortcuts that change
 * nothing, needed gaps against a search by runs. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "study/scene/solution.h"
#include "study/scene/spacing.h"
#include "study_setup.h"
#include "sweep_rows.h"

static void set_up(void)
{
    study_set_up(1);
}

static struct thud_sweep_group *make_group(long index)
{
    struct thud_sweep_group *group;
    ck_assert_msg(thud_sweep_group_create(plan, index, &group, &error) == THUD_OK, "%s", error.what);
    for (bool done = false; !done;)
        ck_assert_int_eq(thud_sweep_group_advance(group, 5, &done, &error), THUD_OK);
    return group;
}

static struct thud_sweep_point *make_point(const struct thud_sweep_group *group, long index)
{
    struct thud_sweep_task *task;
    ck_assert_int_eq(thud_sweep_task_create(plan, group, index, &task, &error), THUD_OK);
    for (bool done = false; !done;)
        ck_assert_int_eq(thud_sweep_task_advance(task, 7, &done, &error), THUD_OK);
    struct thud_sweep_point *point = thud_sweep_task_take(task);
    thud_sweep_task_free(task);
    return point;
}

/* All points of the plan as text. */
static struct thud_text whole(struct thud_sweep_total *total)
{
    struct thud_text text = {0};
    long per_group = thud_sweep_points_per_group(plan);
    struct thud_sweep_group *group = NULL;
    thud_sweep_total_init(total);
    for (long i = 0; i < thud_sweep_points(plan); i++) {
        if (i % per_group == 0) {
            thud_sweep_group_free(group);
            group = make_group(i / per_group);
        }
        struct thud_sweep_point *point = make_point(group, i);
        thud_sweep_total_add(total, point);
        /* what a run cost is no result */
        for (int k = 0; k < point->ncases; k++) {
            enum thud_status status = point->effort[k].status;
            point->effort[k] = (struct thud_sweep_effort){.status = status};
        }
        thud_sweep_point_write(point, &text);
        thud_text_append(&text, "\n");
        free(point);
    }
    thud_sweep_group_free(group);
    return text;
}

/* Every number of the rows against a run of its own, ratios and means by hand. */
START_TEST(rows_are_those_of_single_runs)
{
    vary("gap=6 cm");
    ck_assert_int_eq(thud_sweep_cases(plan, "bumper,cavity", &error), THUD_OK);
    struct thud_sweep_group *group = make_group(0);
    struct thud_sweep_point *point = make_point(group, 0);
    struct thud_sweep_row row[24];
    struct thud_sweep_contact_row contact[8];
    ck_assert_int_eq(point->ncases, 3); /* `none` was added for the ratios */
    ck_assert_int_eq(sweep_rows(point, NULL), 24);
    ck_assert_int_eq(sweep_rows(point, row), 24);
    ck_assert_int_eq(sweep_contact_rows(point, contact), 8);
    struct thud_solution solution[4];
    struct thud_scene *now = malloc(2 * sizeof *now);
    *now = *scene;
    now->interface[0].gap_m = 0.06;
    static const enum thud_case which[] = {THUD_CASE_BUMPER, THUD_CASE_CAVITY, THUD_CASE_NONE, THUD_CASE_NONE};
    for (int k = 0; k < 4; k++) {
        if (k == 3)
            now->interface[0].gap_m = 10;
        ck_assert_int_eq(thud_scene_case(now, which[k], now + 1, &error), THUD_OK);
        ck_assert_int_eq(thud_scene_solve(now + 1, motion, NULL, &solution[k], &error), THUD_OK);
    }
    for (int k = 0, i = 0; k < 2; k++)
        for (int s = 0; s < 2; s++) {
            const struct thud_floor_result *floor[4];
            double sum[4] = {0}, drift[4] = {0};
            int n = s == 0 ? 4 : 6;
            for (int a = 0; a < 4; a++) {
                floor[a] = thud_run_result(solution[a].run)->structure[s].floor;
                for (int f = 0; f < n; f++) {
                    sum[a] += floor[a][f].acceleration.value;
                    drift[a] += floor[a][f].drift.value;
                }
            }
            ck_assert_int_eq(row[i].which, which[k]);
            ck_assert_int_eq(row[i].floor, 0);
            ck_assert_double_eq_tol(row[i].of[THUD_MEASURE_ACCELERATION], sum[k] / n, 1e-12 * sum[k]);
            ck_assert_double_eq_tol(row[i].of[THUD_MEASURE_ACCELERATION_RATIO], sum[k] / sum[2], 1e-13);
            ck_assert_double_eq_tol(row[i].of[THUD_MEASURE_DRIFT_RATIO], drift[k] / drift[2], 1e-13);
            ck_assert_double_eq_tol(row[i].of[THUD_MEASURE_DRIFT_FREE_RATIO], drift[k] / drift[3], 1e-13);
            i++;
            for (int f = 0; f < n; f++, i++) {
                ck_assert_int_eq(row[i].structure, s);
                ck_assert_int_eq(row[i].floor, f + 1);
                ck_assert(row[i].gap_m == 0.06);
                ck_assert(row[i].of[THUD_MEASURE_ACCELERATION] == floor[k][f].acceleration.value);
                ck_assert(row[i].of[THUD_MEASURE_DRIFT] == floor[k][f].drift.value);
                ck_assert(row[i].of[THUD_MEASURE_DISPLACEMENT] == floor[k][f].displacement.value);
                ck_assert(row[i].of[THUD_MEASURE_ACCELERATION_RATIO] ==
                          floor[k][f].acceleration.value / floor[2][f].acceleration.value);
                ck_assert(row[i].of[THUD_MEASURE_DISPLACEMENT_RATIO] ==
                          floor[k][f].displacement.value / floor[2][f].displacement.value);
                ck_assert(row[i].of[THUD_MEASURE_ACCELERATION_FREE_RATIO] ==
                          floor[k][f].acceleration.value / floor[3][f].acceleration.value);
            }
        }
    int impacts = 0;
    for (int k = 0; k < 2; k++)
        for (int c = 0; c < 4; c++) {
            const struct thud_contact_result *r = &thud_run_result(solution[k].run)->contact[c];
            const struct thud_sweep_contact *x = &contact[4 * k + c].of;
            ck_assert_int_eq(x->impacts, r->impacts);
            ck_assert(x->force_n == r->force.value && x->impulse_ns == r->impulse_ns);
            ck_assert_double_eq_tol(x->residual_gap_m, (k == 0 ? 0.01 : 0.02) + r->residual_m, 1e-15);
            impacts += x->impacts;
        }
    ck_assert_int_gt(impacts, 0);
    for (int k = 0; k < 4; k++)
        thud_solution_clear(&solution[k]);
    free(now);
    free(point);
    thud_sweep_group_free(group);
}
END_TEST

/* Ratios of a point filled by hand: the mean's ratio is that of the means, not the mean of the ratios. */
START_TEST(ratios_by_hand)
{
    vary("gap=6 cm");
    ck_assert_int_eq(thud_sweep_cases(plan, "none,bumper", &error), THUD_OK);
    static const double peak[6][3] = {{2, 0.1, 1}, {8, 0, 1}, {3, 0.2, 2}, {4, 0, 1}, {1, 0.05, 4}, {16, 0, 1}};
    struct thud_sweep_floor floor[6];
    for (int i = 0; i < 6; i++)
        floor[i] = (struct thud_sweep_floor){peak[i][0], peak[i][1], peak[i][2], NAN, NAN, NAN, NAN, NAN};
    floor[0] = (struct thud_sweep_floor){2, 0.1, 1, 3, -0.02, 4, 500, NAN};
    floor[1] = (struct thud_sweep_floor){8, 0, 1, 5, 0.04, 6, 700, NAN};
    floor[2] = (struct thud_sweep_floor){3, 0.2, 2, 7, -0.03, 8, 900, NAN}; /* of this case one storey yields */
    struct thud_sweep_point point = {.ncases = 2,
                                     .which = {THUD_CASE_NONE, THUD_CASE_BUMPER},
                                     .nstructures = 1,
                                     .nfloors = 2,
                                     .floors = {2},
                                     .floor = floor};
    struct thud_sweep_row row[6];
    ck_assert_int_eq(sweep_rows(&point, row), 6);
    ck_assert(row[0].of[THUD_MEASURE_ACCELERATION] == 5 && row[0].of[THUD_MEASURE_ACCELERATION_RATIO] == 1);
    ck_assert(row[3].of[THUD_MEASURE_ACCELERATION] == 3.5 && row[3].of[THUD_MEASURE_ACCELERATION_RATIO] == 0.7);
    ck_assert(row[4].of[THUD_MEASURE_ACCELERATION_RATIO] == 1.5 && row[5].of[THUD_MEASURE_ACCELERATION_RATIO] == 0.5);
    ck_assert(row[4].of[THUD_MEASURE_DRIFT_RATIO] == 2 && isnan(row[5].of[THUD_MEASURE_DRIFT_RATIO]));
    ck_assert(row[4].of[THUD_MEASURE_DISPLACEMENT_FREE_RATIO] == 0.5 &&
              row[5].of[THUD_MEASURE_ACCELERATION_FREE_RATIO] == 0.25);
    ck_assert(row[0].of[THUD_MEASURE_DUCTILITY] == 4 && row[0].of[THUD_MEASURE_EXCURSIONS] == 5 &&
              row[0].of[THUD_MEASURE_HYSTERETIC] == 600);
    ck_assert_double_eq_tol(row[0].of[THUD_MEASURE_PERMANENT], 0.03, 1e-17); /* of the sizes */
    ck_assert(row[1].of[THUD_MEASURE_PERMANENT] == -0.02 && row[2].of[THUD_MEASURE_DUCTILITY] == 5);
    ck_assert(row[3].of[THUD_MEASURE_DUCTILITY] == 7 && row[3].of[THUD_MEASURE_PERMANENT] == 0.03 &&
              row[4].of[THUD_MEASURE_PERMANENT] == -0.03);
    ck_assert(isnan(row[5].of[THUD_MEASURE_DUCTILITY]) && isnan(row[5].of[THUD_MEASURE_HYSTERETIC]));
    point.effort[1].status = THUD_DIVERGED; /* no result, no row */
    ck_assert_int_eq(sweep_rows(&point, row), 3);
}
END_TEST

/* Also where only the two lowest modes of each building are there. */
START_TEST(shortcuts_change_no_number)
{
    plan->scene.analysis.modes = 2 * _i;
    vary("gap=5 cm,9 cm,14 cm,30 cm");
    vary("structures.2.stiffness=600 MN/m,400 MN/m");
    ck_assert_int_eq(thud_sweep_cases(plan, "none,bumper,cavity", &error), THUD_OK);
    struct thud_sweep_total total;
    struct thud_text all = whole(&total);
    ck_assert_int_eq(total.asked, 24);
    ck_assert_int_eq(total.made + total.free, 24);
    ck_assert_int_gt(total.free, 3);
    ck_assert_int_gt(total.made, 10);
    ck_assert_int_gt(total.shared_runs, 10);
    static const unsigned some[] = {0, THUD_SWEEP_FREE, THUD_SWEEP_START, THUD_SWEEP_LEVELS};
    for (size_t i = 0; i < sizeof some / sizeof *some; i++) {
        unsigned shortcuts = plan->shortcuts = some[i];
        struct thud_text text = whole(&total);
        ck_assert_str_eq(text.data, all.data);
        ck_assert_int_eq(total.free > 0, (shortcuts & THUD_SWEEP_FREE) != 0);
        ck_assert_int_eq(total.shared_runs > 0, (shortcuts & THUD_SWEEP_START) != 0);
        thud_text_clear(&text);
    }
    thud_text_clear(&all);
}
END_TEST

/* Whether two models are the same but for their structures. */
static bool same_contacts(const struct thud_model *a, const struct thud_model *b)
{
    bool same = a->ncontacts == b->ncontacts;
    for (int c = 0; c < a->ncontacts && same; c++) {
        const struct thud_model_contact *p = &a->contact[c], *q = &b->contact[c];
        same = p->law == q->law && p->clearance_m == q->clearance_m && p->setup.thickness_m == q->setup.thickness_m;
        for (int i = 0; i < p->law->nparams && same; i++)
            same = p->setup.value[i] == q->setup.value[i] || (isnan(p->setup.value[i]) && isnan(q->setup.value[i]));
    }
    return same;
}

/* Each run's model against that of every run before it: the first with the same contacts makes it. A cavity 1 cm deep
 * is a bumper without one at a gap 1 cm wider. */
START_TEST(runs_with_the_same_contacts_are_made_by_the_first)
{
    enum { CASES = 3, POINTS = 2 * 11 };
    struct thud_model *model[POINTS * CASES] = {0};
    struct thud_scene *scenes = malloc(2 * sizeof *scenes);
    vary("bumper.thickness=4 cm,5 cm");
    vary("gap=4 cm:9 cm:0.5 cm");
    ck_assert_int_eq(thud_sweep_cases(plan, "none,bumper,cavity", &error), THUD_OK);
    ck_assert_int_eq(thud_sweep_points(plan), POINTS);
    struct thud_sweep_group *group = make_group(0);
    int shared = 0;
    for (long run = 0; run < POINTS * CASES; run++) {
        long first = run;
        ck_assert_int_eq(thud_sweep_scene(plan, run / CASES, scenes, &error), THUD_OK);
        if (thud_scene_case(scenes, plan->cases[run % CASES], scenes + 1, &error) == THUD_OK &&
            thud_scene_check(scenes + 1, &error) == THUD_OK)
            ck_assert_int_eq(thud_scene_assemble(scenes + 1, &model[run], &error), THUD_OK);
        for (long other = run - 1; other >= 0; other--)
            if (model[run] && model[other] && same_contacts(model[run], model[other]))
                first = other;
        ck_assert_msg(thud_sweep_maker(group, run / CASES, (int)(run % CASES)) == first / CASES, "run %ld", run);
        shared += first < run;
    }
    ck_assert_int_eq(shared, 11 + 9); /* case none again; each cavity of 5 cm but those at the two widest gaps */
    for (int run = 0; run < POINTS * CASES; run++)
        thud_model_free(model[run]);
    thud_sweep_group_free(group);
    free(scenes);
}
END_TEST

/* What a group keeps has a bound: where there are more results to share, the rest is made. */
START_TEST(what_is_kept_for_others_is_bounded)
{
    enum { GAPS = 15001 };
    vary("bumper.thickness=1 cm,2 cm");
    vary("gap=10 cm:85 cm:0.005 cm");
    ck_assert_int_eq(thud_sweep_cases(plan, "none", &error), THUD_OK);
    ck_assert_int_eq(thud_sweep_points(plan), 2 * GAPS);
    struct thud_sweep_group *group = make_group(0);
    long shared = 0, size = 10 * (long)sizeof(struct thud_sweep_floor) + 4 * (long)sizeof(struct thud_sweep_contact);
    for (long i = 0; i < GAPS; i++) {
        ck_assert_int_eq(thud_sweep_maker(group, i, 0), i);
        long maker = thud_sweep_maker(group, GAPS + i, 0);
        ck_assert(maker == i || maker == GAPS + i);
        shared += maker == i;
    }
    ck_assert_int_gt(shared, GAPS / 2);
    ck_assert_int_le(shared * size, THUD_SWEEP_SAME_BYTES);
    thud_sweep_group_free(group);
}
END_TEST

/* A wall between two pairs: what happens on one side does not concern the other, whose contacts are left out where
 * nothing closes them. */
START_TEST(levels_that_cannot_touch_are_left_out)
{
    plan->scene.nstructures = 3;
    plan->scene.structure[2] = plan->scene.structure[1];
    thud_structure_init(&plan->scene.structure[1], THUD_WALL);
    strcpy(plan->scene.structure[1].name, "W");
    plan->scene.structure[1].height_m[0] = INFINITY;
    plan->scene.interface[0].has_bumper = false;
    plan->scene.interface[1] = plan->scene.interface[0];
    plan->scene.interface[0].gap_m = 1;
    vary("interfaces.2.gap=3 cm,5 cm,2 m");
    struct thud_sweep_total total;
    struct thud_text all = whole(&total);
    ck_assert_int_eq(total.free, 1);
    ck_assert_int_eq(total.made, 2);
    ck_assert_int_eq(total.left_out, 8); /* four floors of A, twice */
    plan->shortcuts = 0;
    struct thud_text none = whole(&total);
    ck_assert_int_eq(total.made, 3);
    ck_assert_int_eq(total.left_out, 0);
    ck_assert_str_eq(none.data, all.data);
    thud_text_clear(&all);
    thud_text_clear(&none);
}
END_TEST

START_TEST(identical_neighbours_need_no_run)
{
    plan->scene.structure[0] = plan->scene.structure[1];
    plan->scene.interface[0].gap_m = 0.05;
    ck_assert_int_eq(thud_sweep_cases(plan, "none,bumper", &error), THUD_OK);
    struct thud_sweep_total total;
    struct thud_text text = whole(&total);
    ck_assert_int_eq(total.made, 0);
    thud_text_clear(&text);
}
END_TEST

/* Whether any contact closes at this gap without bumper. */
static bool in_contact(double gap)
{
    struct thud_scene *now = malloc(2 * sizeof *now);
    struct thud_solution solution;
    bool any = false;
    *now = *scene;
    now->interface[0].gap_m = gap;
    ck_assert_int_eq(thud_scene_case(now, THUD_CASE_NONE, now + 1, &error), THUD_OK);
    ck_assert_int_eq(thud_scene_solve(now + 1, motion, NULL, &solution, &error), THUD_OK);
    for (int c = 0; c < 4; c++)
        any |= thud_run_result(solution.run)->contact[c].impacts > 0;
    thud_solution_clear(&solution);
    free(now);
    return any;
}

START_TEST(needed_gap_is_where_contacts_end)
{
    struct thud_sweep_group *group = make_group(0);
    struct thud_sweep_point *point = make_point(group, 0);
    const struct thud_gap_level *need = point->level;
    ck_assert(thud_sweep_is_first(plan, point));
    ck_assert_int_eq(point->ncontacts, 4);
    double widest = 0, low = 0, high = 1;
    for (int c = 0; c < 4; c++) {
        widest = fmax(widest, need[c].relative_displacement_m);
        ck_assert_double_le(need[c].relative_displacement_m, thud_gap_value(&need[c], THUD_GAP_ABS) * (1 + 1e-12));
        ck_assert(thud_gap_value(&need[c], THUD_GAP_ABS) == need[c].left_m + need[c].right_m);
        ck_assert_double_eq_tol(thud_gap_value(&need[c], THUD_GAP_SRSS),
                                sqrt(pow(need[c].left_m, 2) + pow(need[c].right_m, 2)), 1e-15);
        ck_assert_double_lt(thud_gap_value(&need[c], THUD_GAP_DDC), thud_gap_value(&need[c], THUD_GAP_SRSS));
        ck_assert_int_eq(need[c].left_floor, c + 1);
    }
    /* periods of model.md, section 5 */
    ck_assert_double_eq_tol(need[0].correlation, thud_spacing_correlation(0.39791, 0.05, 0.58184, 0.05), 1e-5);
    for (int i = 0; i < 40; i++) {
        double middle = 0.5 * (low + high);
        if (in_contact(middle))
            low = middle;
        else
            high = middle;
    }
    ck_assert_double_eq_tol(widest, high, 1e-10);
    free(point);
    thud_sweep_group_free(group);
}
END_TEST

START_TEST(varied_peak_scales_the_motion)
{
    vary("record.peak=2 m/s2,4 m/s2");
    struct thud_sweep_group *one = make_group(0), *two = make_group(1);
    struct thud_sweep_point *a = make_point(one, 0), *b = make_point(two, 1);
    for (int c = 0; c < 4; c++)
        ck_assert_double_eq_tol(b->level[c].relative_displacement_m, 2 * a->level[c].relative_displacement_m, 1e-12);
    free(a);
    free(b);
    thud_sweep_group_free(one);
    thud_sweep_group_free(two);
}
END_TEST

START_TEST(impossible_points_have_no_rows)
{
    vary("gap=4 cm,6 cm");
    ck_assert_int_eq(thud_sweep_cases(plan, "none,bumper", &error), THUD_OK);
    struct thud_sweep_group *group = make_group(0);
    struct thud_sweep_point *narrow = make_point(group, 0), *wide = make_point(group, 1);
    ck_assert_int_eq(narrow->effort[1].status, THUD_INPUT);
    ck_assert_int_eq(sweep_rows(narrow, NULL), 12);
    ck_assert_int_eq(sweep_rows(wide, NULL), 24);
    free(narrow);
    free(wide);
    thud_sweep_group_free(group);
}
END_TEST

START_TEST(points_as_text_and_back)
{
    vary("gap=4 cm,6 cm");
    ck_assert_int_eq(thud_sweep_cases(plan, "none,bumper", &error), THUD_OK);
    struct thud_sweep_group *group = make_group(0);
    for (int i = 0; i < 2; i++) {
        struct thud_sweep_point *point = make_point(group, i), *back;
        struct thud_text text = {0}, again = {0};
        thud_sweep_point_write(point, &text);
        ck_assert_int_eq(thud_sweep_point_read(text.data, &back, &error), THUD_OK);
        thud_sweep_point_write(back, &again);
        ck_assert_str_eq(text.data, again.data);
        for (int f = 0; f < 30; f++)
            ck_assert(memcmp(&point->floor[f], &back->floor[f], sizeof *back->floor) == 0 ||
                      isnan(back->floor[f].drift_m));
        free(back);
        /* any byte that changes, and any end that is missing, is found */
        for (size_t at = 0; at < text.size; at += 7) {
            char kept = text.data[at];
            text.data[at] = kept == '1' ? '2' : '1';
            ck_assert_int_eq(thud_sweep_point_read(text.data, &back, &error), THUD_INPUT);
            text.data[at] = '\0';
            ck_assert_int_eq(thud_sweep_point_read(text.data, &back, &error), THUD_INPUT);
            text.data[at] = kept;
        }
        thud_text_clear(&text);
        thud_text_clear(&again);
        free(point);
    }
    thud_sweep_group_free(group);
}
END_TEST

START_TEST(fingerprints_tell_plans_apart)
{
    vary("gap=4 cm,6 cm");
    unsigned long long first = thud_sweep_fingerprint(plan);
    struct thud_sweep_plan *other = malloc(sizeof *other);
    thud_sweep_plan_init(other, scene);
    other->record = records;
    other->nrecords = 1;
    ck_assert_int_eq(thud_sweep_vary(other, "gap=4 cm,6 cm", &error), THUD_OK);
    ck_assert(thud_sweep_fingerprint(other) == first);
    other->shortcuts = 0;
    ck_assert(thud_sweep_fingerprint(other) == first);
    other->scene.interface[0].bumper.value[0] *= 1 + 1e-15;
    ck_assert(thud_sweep_fingerprint(other) != first);
    other->scene = *scene;
    motion->a_mps2[700] += 1e-9;
    ck_assert(thud_sweep_fingerprint(other) != first);
    static const char *const change[][2] = {{"structures.2.base", "0.2 m"},
                                            {"structures.1.slab-depth", "20 cm"},
                                            {"structures.1.column.EI", "90 MN m2"},
                                            {"structures.2.column.shape", "linear"},
                                            {"interfaces.1.levels", "aligned"}};
    for (size_t k = 0; k < sizeof change / sizeof *change; k++) {
        struct thud_scene before = other->scene;
        unsigned long long known = thud_sweep_fingerprint(other);
        ck_assert(thud_scene_set(&other->scene, change[k][0], change[k][1], NULL) == THUD_OK);
        ck_assert_msg(thud_sweep_fingerprint(other) != known, "%s", change[k][0]);
        other->scene = before;
        ck_assert(thud_sweep_fingerprint(other) == known);
    }
    thud_sweep_plan_clear(other);
    free(other);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("sweep");
    TCase *tcase = tcase_create("sweep");
    tcase_add_checked_fixture(tcase, set_up, study_tear_down);
    tcase_add_test(tcase, rows_are_those_of_single_runs);
    tcase_add_test(tcase, ratios_by_hand);
    tcase_add_loop_test(tcase, shortcuts_change_no_number, 0, 2);
    tcase_add_test(tcase, runs_with_the_same_contacts_are_made_by_the_first);
    tcase_add_test(tcase, what_is_kept_for_others_is_bounded);
    tcase_add_test(tcase, levels_that_cannot_touch_are_left_out);
    tcase_add_test(tcase, identical_neighbours_need_no_run);
    tcase_add_test(tcase, needed_gap_is_where_contacts_end);
    tcase_add_test(tcase, varied_peak_scales_the_motion);
    tcase_add_test(tcase, impossible_points_have_no_rows);
    tcase_add_test(tcase, points_as_text_and_back);
    tcase_add_test(tcase, fingerprints_tell_plans_apart);
    suite_add_tcase(suite, tcase);
    return suite;
}
