/* What elements say they are: the numbers of the table against models; a kind that is nothing of the kind, which
 * switches every shortcut off and changes no result; factors of first contact against runs with contact. */
#include <check.h>
#include <dirent.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/model/element.h"
#include "io/preset/preset.h"
#include "study/scene/first_contact.h"
#include "study/scene/scene_elements.h"
#include "study/scene/solution.h"
#include "study_setup.h"

/* The table, but for springs: of them nothing is known. */
const struct thud_element_kind thud_elements[] = {
#define THUD_ELEMENT(NAME, word, traits, dofs, states)                                                                 \
    {word, THUD_ELEMENT_##NAME == THUD_ELEMENT_SPRING ? THUD_UNKNOWN : (traits), dofs, states},
    THUD_ELEMENT_LIST(THUD_ELEMENT)
#undef THUD_ELEMENT
};

static void set_up(void)
{
    study_set_up(1);
}

static void set(const char *key, const char *value)
{
    ck_assert_msg(thud_scene_set(scene, key, value, &error) == THUD_OK, "%s: %s", error.key, error.what);
}

static void add_link(const char *law, const char *stiffness)
{
    set("links.1.law", law);
    set("links.1.from", "A.4");
    set("links.1.to", "B.4");
    set("links.1.stiffness", stiffness);
}

/* Degrees of freedom and states of each shipped scene are those of its model. */
START_TEST(numbers_are_those_of_the_model)
{
    DIR *folder = opendir("presets");
    int read = 0;
    ck_assert_ptr_nonnull(folder);
    for (struct dirent *entry; (entry = readdir(folder));) {
        char path[300];
        struct thud_model *model;
        const char *end = strrchr(entry->d_name, '.');
        if (!end || strcmp(end, ".yaml") != 0)
            continue;
        snprintf(path, sizeof path, "presets/%s", entry->d_name);
        struct thud_preset *preset;
        ck_assert_msg(thud_preset_read(path, &preset, &error) == THUD_OK, "%s: %s", path, error.what);
        const struct thud_scene *read_in = thud_preset_scene(preset);
        ck_assert_msg(thud_scene_assemble(read_in, &model, &error) == THUD_OK, "%s: %s", path, error.what);
        const struct thud_element_sum sum = thud_scene_elements(read_in);
        ck_assert_msg(sum.dofs == model->ndof && sum.states == model->nstoreys, "%s: %d of %d, %d of %d", path,
                      sum.dofs, model->ndof, sum.states, model->nstoreys);
        if (sum.traits != THUD_UNKNOWN)
            ck_assert_int_eq((sum.traits & THUD_SLIPS) != 0, model->nstoreys > 0);
        thud_model_free(model);
        thud_preset_free(preset);
        read++;
    }
    closedir(folder);
    ck_assert_int_gt(read, 10);
}
END_TEST

static struct thud_sweep_point *make_point(void)
{
    struct thud_sweep_group *group;
    struct thud_sweep_task *task;
    ck_assert_msg(thud_sweep_group_create(plan, 0, &group, &error) == THUD_OK, "%s", error.what);
    for (bool done = false; !done;)
        ck_assert_int_eq(thud_sweep_group_advance(group, 1000, &done, &error), THUD_OK);
    ck_assert_int_eq(thud_sweep_task_create(plan, group, 0, &task, &error), THUD_OK);
    for (bool done = false; !done;)
        ck_assert_int_eq(thud_sweep_task_advance(task, 1000, &done, &error), THUD_OK);
    struct thud_sweep_point *point = thud_sweep_task_take(task);
    thud_sweep_task_free(task);
    thud_sweep_group_free(group);
    return point;
}

/* A dashpot, and a spring, whose kind is nothing of the kind here: narrow and so wide that no run is needed. */
START_TEST(what_is_unknown_switches_every_shortcut_off)
{
    const bool unknown = _i > 1, wide = _i % 2;
    if (unknown) {
        add_link("spring", "100 MN/m");
    } else {
        set("links.1.law", "dashpot");
        set("links.1.from", "A.4");
        set("links.1.to", "B.4");
        set("links.1.damping", "1 MN s/m");
    }
    set("gap", wide ? "1 m" : "6 cm");
    plan->scene = *scene;
    ck_assert_int_eq(thud_sweep_cases(plan, "link", &error), THUD_OK);
    struct thud_sweep_point *point = make_point();
    const struct thud_sweep_effort *effort = &point->effort[0];
    ck_assert_int_eq(effort->made, unknown || !wide);
    ck_assert_int_eq(effort->shared_s > 0, !unknown && !wide);
    ck_assert_int_eq(thud_scene_scales(scene), !unknown);
    struct thud_solution solution;
    ck_assert_int_eq(thud_scene_case(scene, THUD_CASE_LINK, scene + 1, &error), THUD_OK);
    ck_assert_int_eq(thud_scene_solve(scene + 1, motion, NULL, &solution, &error), THUD_OK);
    ck_assert_int_eq(solution.model->traits == THUD_UNKNOWN, unknown);
    for (int s = 0, f = 0; s < point->nstructures; s++)
        for (int i = 0; i < point->floors[s]; i++, f++)
            ck_assert_double_eq(point->floor[f].drift_m,
                                thud_run_result(solution.run)->structure[s].floor[i].drift.value);
    thud_solution_clear(&solution);
    free(point);
}
END_TEST

static int impacts_at(double factor)
{
    struct thud_solution solution;
    struct thud_record *scaled;
    int impacts = 0;
    ck_assert_int_eq(thud_record_create(motion->a_mps2, motion->samples, motion->dt_s, &scaled, &error), THUD_OK);
    thud_record_scale(scaled, factor);
    ck_assert_msg(thud_scene_solve(scene, scaled, NULL, &solution, &error) == THUD_OK, "%s", error.what);
    for (int c = 0; c < solution.model->npairs; c++)
        impacts += thud_run_result(solution.run)->contact[c].impacts;
    thud_solution_clear(&solution);
    thud_record_free(scaled);
    return impacts;
}

/* Every kind that does not scale: contact at 1.001 of the factor and none at 0.999; a spring, of which that is not
 * known here, at the factor of a linear scene. */
START_TEST(first_contact_by_runs)
{
    static const struct {
        const char *law, *key, *value;
        double gap_m;
    } kind[] = {{"friction", "links.1.slip", "500 kN", 0.06},
                {"restrainer", "links.1.slack", "5 mm", 0.03},
                {"strut", "links.1.slack", "5 mm", 0.03},
                {"spring", "links.1.damping", "0 kN s/m", 0.03}};
    struct thud_needed_gap *gap;
    struct thud_first_contact found;
    add_link(kind[_i].law, "100 MN/m");
    set(kind[_i].key, kind[_i].value);
    scene->interface[0].gap_m = kind[_i].gap_m;
    scene->interface[0].has_bumper = false;
    ck_assert_int_eq(thud_needed_gap_run(scene, motion, &gap, &error), THUD_OK);
    ck_assert_int_eq(thud_first_contact_find(scene, motion, gap, &found, &error), THUD_OK);
    ck_assert(isfinite(found.first));
    ck_assert_int_eq(impacts_at(0.999 * found.first), 0);
    ck_assert_int_gt(impacts_at(1.001 * found.first), 0);
    const double linear = kind[_i].gap_m / thud_needed_gap_widest(gap, 0, THUD_GAP_EXACT, NULL);
    ck_assert_int_eq(fabs(found.first / linear - 1) < 2e-6, _i == 3);
    free(gap);
}
END_TEST

/* A gap that is used up before any storey yields: the factor is that of the elastic buildings, to rounding and not to the
 * 1e-6 of a search. */
START_TEST(first_contact_before_yielding)
{
    struct thud_needed_gap *gap;
    struct thud_first_contact found;
    scene->interface[0].has_bumper = false;
    scene->interface[0].gap_m = 0.004;
    ck_assert_int_eq(thud_needed_gap_run(scene, motion, &gap, &error), THUD_OK);
    const double elastic = 0.004 / thud_needed_gap_widest(gap, 0, THUD_GAP_EXACT, NULL);
    free(gap);
    for (int k = 0; k < scene->structure[0].storeys; k++) {
        scene->structure[0].yield_m[k] = 0.009;
        scene->structure[0].hardening[k] = 0.02;
    }
    ck_assert_int_eq(thud_needed_gap_run(scene, motion, &gap, &error), THUD_OK);
    ck_assert_double_gt(gap->ductility, 1);
    ck_assert_int_eq(thud_first_contact_find(scene, motion, gap, &found, &error), THUD_OK);
    free(gap);
    ck_assert_double_lt(fabs(found.first / elastic - 1), 1e-9);
}
END_TEST

/* Storeys that yield, at drifts and gaps found by a search: there is contact between the first factor and the one that
 * clears again, and none at its other side. */
START_TEST(a_stronger_motion_clears_again)
{
    static const double yield_m[][2] = {{0.009, 0.009}, {0.018, 0.012}}, gap_m[] = {0.06, 0.09};
    struct thud_needed_gap *gap;
    struct thud_first_contact found;
    scene->interface[0].has_bumper = false;
    scene->interface[0].gap_m = gap_m[_i];
    for (int s = 0; s < scene->nstructures; s++)
        for (int k = 0; k < scene->structure[s].storeys; k++) {
            scene->structure[s].yield_m[k] = yield_m[_i][s];
            scene->structure[s].hardening[k] = 0.02;
        }
    ck_assert_int_eq(thud_needed_gap_run(scene, motion, &gap, &error), THUD_OK);
    ck_assert_int_eq(thud_first_contact_find(scene, motion, gap, &found, &error), THUD_OK);
    free(gap);
    ck_assert_int_eq(impacts_at(0.999 * found.first), 0);
    ck_assert_int_gt(impacts_at(1.001 * found.first), 0);
    ck_assert_double_gt(found.clear_again, found.first);
    ck_assert_int_gt(impacts_at(0.9999 * found.clear_again), 0);
    ck_assert_int_eq(impacts_at(1.0001 * found.clear_again), 0);
    for (int i = 1; i < 10; i++)
        ck_assert_int_gt(impacts_at(found.first + (found.clear_again - found.first) * i / 10), 0);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("elements");
    TCase *tcase = tcase_create("elements");
    tcase_add_checked_fixture(tcase, set_up, study_tear_down);
    tcase_add_test(tcase, numbers_are_those_of_the_model);
    tcase_add_loop_test(tcase, what_is_unknown_switches_every_shortcut_off, 0, 4);
    tcase_add_loop_test(tcase, first_contact_by_runs, 0, 4);
    tcase_add_test(tcase, first_contact_before_yielding);
    tcase_add_loop_test(tcase, a_stronger_motion_clears_again, 0, 2);
    suite_add_tcase(suite, tcase);
    return suite;
}
