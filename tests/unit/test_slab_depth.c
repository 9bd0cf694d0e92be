/* What meets what where slabs have a depth, held against rules written here and against the mirrored scene. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/random.h"
#include "core/model/model.h"
#include "study/scene/level.h"
#include "study/scene/solution.h"
#include "suite.h"
#include "towers.h"

static void building(struct thud_structure *s, const char *name, int storeys, double height_m, double depth_m,
                     double base_m)
{
    thud_structure_init(s, THUD_SHEAR);
    strcpy(s->name, name);
    s->storeys = storeys;
    s->base_m = base_m;
    for (int i = 0; i < storeys; i++) {
        s->mass_kg[i] = 300e3;
        s->stiffness_npm[i] = 600e6;
        s->height_m[i] = height_m;
        s->slab_depth_m[i] = depth_m;
    }
}

/* Two neighbours: 4 storeys on the left, 6 on the right and `offset_m` higher. */
static void neighbours(struct thud_scene *scene, double offset_m, double depth_m)
{
    thud_scene_init(scene);
    scene->nstructures = 2;
    building(&scene->structure[0], "A", 4, 3, depth_m, 0);
    building(&scene->structure[1], "B", 6, 3, depth_m, offset_m);
    thud_interface_init(&scene->interface[0]);
}

/* Storeys of 2.4 to 4 m, slabs up to half of them, a ground up to 3 m higher or lower. */
static void draw(struct thud_scene *scene, struct thud_random *random, bool deep)
{
    neighbours(scene, 0, 0);
    for (int s = 0; s < 2; s++) {
        struct thud_structure *p = &scene->structure[s];
        p->base_m = s ? 6 * thud_random_unit(random) - 3 : 0;
        for (int i = 0; i < p->storeys; i++) {
            p->height_m[i] = 0.1 * floor(24 + 17 * thud_random_unit(random));
            p->slab_depth_m[i] = deep ? 0.5 * p->height_m[i] * thud_random_unit(random) : 0;
        }
    }
}

static double level_of(const struct thud_structure *s, int floor) /* from 1; 0: the ground */
{
    double z = s->base_m;
    for (int i = 0; i < floor; i++)
        z += s->height_m[i];
    return z;
}

/* Whether a contact of these floors is among them; `struck` as in thud_contact_pair. */
static const struct thud_contact_pair *among(const struct thud_contact_pair *contact_pair, int n, int left, int right,
                                             int struck)
{
    for (int i = 0; i < n; i++)
        if (contact_pair[i].left_floor == left && contact_pair[i].right_floor == right &&
            contact_pair[i].struck == struck)
            return &contact_pair[i];
    return NULL;
}

/* Up to the depth one contact for each pair of floors, beyond it each slab on the other's columns, never both. */
START_TEST(an_offset_that_grows)
{
    static struct thud_scene scene;
    struct thud_contact_pair contact_pair[THUD_CONTACT_PAIRS_MAX];
    neighbours(&scene, 0.01 * _i, 0.3);
    int n = thud_interface_contact_pairs(&scene, 0, contact_pair);
    if (_i < 30) {
        ck_assert_int_eq(n, 4);
        for (int f = 1; f <= 4; f++)
            ck_assert_ptr_nonnull(among(contact_pair, n, f, f, 0));
        return;
    }
    /* A's floors 1 to 4 strike B's columns (floor 1 those of B's first storey), B's 1 to 3 A's; B's 4 is above A */
    ck_assert_int_eq(n, 7);
    for (int f = 1; f <= 4; f++) {
        const struct thud_contact_pair *of_a = among(contact_pair, n, f, f, 1);
        ck_assert_ptr_nonnull(of_a);
        ck_assert_double_eq_tol(of_a->a_m, 3 - 0.01 * _i - 0.15, 1e-12);
        ck_assert_double_eq_tol(of_a->a_m + of_a->b_m, 2.7, 1e-12);
    }
    for (int f = 1; f <= 3; f++) {
        const struct thud_contact_pair *of_b = among(contact_pair, n, f + 1, f, -1);
        ck_assert_ptr_nonnull(of_b);
        ck_assert_double_eq_tol(of_b->a_m, 0.01 * _i - 0.15, 1e-12);
        ck_assert_double_eq_tol(of_b->a_m + of_b->b_m, 2.7, 1e-12);
    }
}
END_TEST

/* A thin face that rises past slabs of 30 cm, millimetre by millimetre, from above the neighbour's ground to its top, meets
 * the nearest floor or strikes columns, one at a time, whichever side it comes from. */
START_TEST(nothing_passes_between_faces_and_columns)
{
    static struct thud_scene scene;
    struct thud_contact_pair contact_pair[THUD_CONTACT_PAIRS_MAX];
    const double depth_m = (const double[]){0, 0.5e-2, 1.5e-2, 2.5e-2}[_i];
    for (int mm = 12; mm <= 12000; mm++) {
        const double middle_m = 1e-3 * mm;
        for (int side = 0; side < 2; side++) {
            neighbours(&scene, 0, 0.3);
            building(&scene.structure[side], "A", 4, 3, 0.3, 0);
            building(&scene.structure[1 - side], "B", 1, middle_m + 0.5 * depth_m, depth_m, 0);
            const int n = thud_interface_contact_pairs(&scene, 0, contact_pair);
            const struct thud_contact_pair *one = NULL, *thin = NULL;
            for (int i = 0; i < n; i++) /* those in which the thin slab is a face */
                if (contact_pair[i].struck == 0 || contact_pair[i].struck == (side == 0 ? -1 : 1)) {
                    ck_assert_ptr_null(thin);
                    thin = &contact_pair[i];
                }
            one = thin;
            ck_assert_msg(one, "nothing at %g m, depth %g m", middle_m, depth_m);
            const int floor = side == 0 ? one->left_floor : one->right_floor, storey = (mm + 10) / 3000 + 1;
            if (one->struck == 0) /* within 1 cm of the floor's face, or overlapping it */
                ck_assert_double_lt(fabs(middle_m - (3 * floor - 0.15)), 0.15 + 0.5 * depth_m + 0.0101);
            else
                ck_assert_int_eq(floor, storey);
        }
    }
}
END_TEST

/* The rule of slabs without depth: levels within 1 cm meet, any other slab between two floors strikes columns there. */
START_TEST(without_depth)
{
    static struct thud_scene scene;
    struct thud_contact_pair contact_pair[THUD_CONTACT_PAIRS_MAX];
    struct thud_random random = {(uint64_t)_i};
    draw(&scene, &random, false);
    int n = thud_interface_contact_pairs(&scene, 0, contact_pair), expected = 0;
    for (int side = 0; side < 2; side++) {
        const struct thud_structure *slab = &scene.structure[side], *other = &scene.structure[!side];
        for (int f = 1; f <= slab->storeys; f++) {
            double z = level_of(slab, f);
            for (int g = 1; g <= other->storeys; g++) {
                double upper = level_of(other, g), lower = level_of(other, g - 1);
                bool level = fabs(z - upper)<0.0101, between = z - lower> 0.0101 && upper - z > 0.0101;
                const struct thud_contact_pair *one = among(contact_pair, n, side ? g : f, side ? f : g,
                                                            level  ? 0
                                                            : side ? -1
                                                                   : 1);
                ck_assert_int_eq(one != NULL, level || between);
                if (between) {
                    ck_assert_double_eq_tol(one->a_m, z - lower, 1e-12);
                    ck_assert_double_eq_tol(one->b_m, upper - z, 1e-12);
                }
                expected += (level && side == 0) || between;
            }
        }
    }
    ck_assert_int_eq(n, expected);
}
END_TEST

/* Random storeys and depths: no floor both meets a floor and strikes columns, faces that overlap meet, columns are
 * struck in their clear height; and the mirrored scene has the same contacts in the same order. */
START_TEST(random_depths_and_the_mirror)
{
    static struct thud_scene scene, mirror;
    struct thud_contact_pair contact_pair[THUD_CONTACT_PAIRS_MAX], other[THUD_CONTACT_PAIRS_MAX];
    struct thud_random random = {(uint64_t)_i};
    draw(&scene, &random, true);
    mirror = scene;
    mirror.structure[0] = scene.structure[1];
    mirror.structure[1] = scene.structure[0];
    int n = thud_interface_contact_pairs(&scene, 0, contact_pair), floors[2][8] = {{0}}, struck[2][8] = {{0}};
    ck_assert_int_eq(n, thud_interface_contact_pairs(&mirror, 0, other));
    for (int i = 0; i < n; i++) {
        const struct thud_contact_pair *p = &contact_pair[i];
        ck_assert_int_eq(p->left_floor, other[i].right_floor);
        ck_assert_int_eq(p->right_floor, other[i].left_floor);
        ck_assert_int_eq(p->struck, -other[i].struck);
        ck_assert_double_eq(p->a_m, other[i].a_m);
        if (p->struck == 0) {
            floors[0][p->left_floor] = floors[1][p->right_floor] = 1;
            continue;
        }
        const struct thud_structure *columns = &scene.structure[p->struck > 0];
        int floor = p->struck > 0 ? p->right_floor : p->left_floor;
        struck[p->struck < 0][p->struck > 0 ? p->left_floor : p->right_floor] = 1;
        ck_assert(p->a_m > 0 && p->b_m > 0);
        ck_assert_double_eq_tol(p->a_m + p->b_m, thud_clear_height(columns, floor - 1), 1e-12);
    }
    for (int s = 0; s < 2; s++)
        for (int f = 1; f <= scene.structure[s].storeys; f++) {
            const struct thud_structure *own = &scene.structure[s], *neighbour = &scene.structure[!s];
            bool overlaps = false;
            for (int g = 1; g <= neighbour->storeys; g++) {
                double z = level_of(own, f), y = level_of(neighbour, g);
                overlaps = overlaps || fabs(z - y) < 0.0101 ||
                           (y - neighbour->slab_depth_m[g - 1] < z - 1e-6 && z - own->slab_depth_m[f - 1] < y - 1e-6);
            }
            ck_assert_int_eq(floors[s][f], overlaps);
            ck_assert(!(floors[s][f] && struck[s][f]));
        }
}
END_TEST

/* A wall that ends within a slab's face is touched by it, and one that ends below is not; a body, which has no depth,
 * meets the slab in whose face it stands. */
START_TEST(walls_and_bodies)
{
    static struct thud_scene scene;
    struct thud_contact_pair contact_pair[THUD_CONTACT_PAIRS_MAX];
    neighbours(&scene, 0, 0.3);
    thud_structure_init(&scene.structure[1], THUD_WALL);
    const struct {
        double top_m;
        int floors;
    } wall[] = {{2.6, 0}, {2.8, 1}, {3, 1}, {5.6, 1}, {5.8, 2}, {INFINITY, 4}};
    for (size_t i = 0; i < sizeof wall / sizeof *wall; i++) {
        scene.structure[1].height_m[0] = wall[i].top_m;
        ck_assert_int_eq(thud_interface_contact_pairs(&scene, 0, contact_pair), wall[i].floors);
    }
    thud_structure_init(&scene.structure[1], THUD_RIGID);
    scene.structure[1].height_m[0] = 5.75;
    ck_assert_int_eq(thud_interface_contact_pairs(&scene, 0, contact_pair), 1);
    ck_assert(contact_pair[0].left_floor == 2 && contact_pair[0].struck == 0);
    scene.structure[1].height_m[0] = 5.65;
    ck_assert_int_eq(thud_interface_contact_pairs(&scene, 0, contact_pair), 1);
    ck_assert(contact_pair[0].left_floor == 2 && contact_pair[0].struck == -1);
    ck_assert_double_eq_tol(contact_pair[0].a_m, 2.65, 1e-12);
    ck_assert_double_eq_tol(contact_pair[0].b_m, 0.05, 1e-12);
}
END_TEST

/* Every number of two results. */
static void same_result(const struct thud_scene *a, const struct thud_scene *b, const int *contact, int n)
{
    struct thud_record *record = thud_test_motion(1);
    struct thud_solution x, y;
    ck_assert_int_eq(thud_scene_solve(a, record, NULL, &x, NULL), THUD_OK);
    ck_assert_int_eq(thud_scene_solve(b, record, NULL, &y, NULL), THUD_OK);
    const struct thud_result *p = thud_run_result(x.run), *q = thud_run_result(y.run);
    for (int s = 0; s < 2; s++)
        for (int i = 0; i < q->structure[s].floors; i++)
            ck_assert_mem_eq(&p->structure[s].floor[i], &q->structure[s].floor[i], sizeof q->structure[s].floor[i]);
    for (int c = 0; c < n; c++) {
        ck_assert_int_gt(q->contact[c].impacts, 0);
        ck_assert_int_eq(p->contact[contact[c]].impacts, q->contact[c].impacts);
        ck_assert_double_eq(p->contact[contact[c]].force.value, q->contact[c].force.value);
        ck_assert_double_eq(p->contact[contact[c]].indentation.value, q->contact[c].indentation.value);
    }
    thud_solution_clear(&x);
    thud_solution_clear(&y);
    thud_record_free(record);
}

static void set(struct thud_scene *scene, const char *key, const char *text)
{
    struct thud_error err = {0};
    ck_assert_msg(thud_scene_set(scene, key, text, &err) == THUD_OK && thud_scene_check(scene, &err) == THUD_OK,
                  "%s=%s: %s", key, text, err.what);
}

/* The same value at every level is the one value, to the last bit. */
START_TEST(one_value_at_every_level)
{
    static struct thud_scene one, many;
    static const int each[] = {2, 3}; /* levels 3 and 4, which strike */
    thud_test_towers(&one);
    one.interface[0].has_bumper = _i > 0;
    many = one;
    set(&many, "gap-by-level", "[10 cm, none, 10 cm, none]");
    set(&many, "gap", _i == 0 ? "5 cm" : "10 cm");
    set(&many, "gap-by-level", "[10 cm, 10 cm, 10 cm, 10 cm]");
    if (_i > 0) {
        set(&many, "bumper.thickness", _i == 1 ? "5 cm" : "2 cm");
        set(&many, "bumper.thickness-by-level", "[5 cm, 5 cm, 5 cm, 5 cm]");
    }
    struct thud_model *model[2];
    ck_assert_int_eq(thud_scene_assemble(&one, &model[0], NULL), THUD_OK);
    ck_assert_int_eq(thud_scene_assemble(&many, &model[1], NULL), THUD_OK);
    for (int c = 0; c < 4; c++)
        ck_assert_double_eq(model[0]->contact[c].clearance_m, model[1]->contact[c].clearance_m);
    thud_model_free(model[0]);
    thud_model_free(model[1]);
    struct thud_record *record = thud_test_motion(1);
    struct thud_solution x, y;
    ck_assert_int_eq(thud_scene_solve(&one, record, NULL, &x, NULL), THUD_OK);
    ck_assert_int_eq(thud_scene_solve(&many, record, NULL, &y, NULL), THUD_OK);
    const struct thud_result *p = thud_run_result(x.run), *q = thud_run_result(y.run);
    for (int s = 0; s < 2; s++)
        for (int i = 0; i < p->structure[s].floors; i++)
            ck_assert_mem_eq(&p->structure[s].floor[i], &q->structure[s].floor[i], sizeof p->structure[s].floor[i]);
    for (int c = 0; c < 2; c++) {
        ck_assert_int_gt(p->contact[each[c]].impacts, 0);
        ck_assert_double_eq(p->contact[each[c]].force.value, q->contact[each[c]].force.value);
    }
    thud_solution_clear(&x);
    thud_solution_clear(&y);
    thud_record_free(record);
}
END_TEST

/* Two pairs of which one is 5 m apart strike as the other alone does, where heights leave that one alone. */
START_TEST(one_level_that_can_strike)
{
    static struct thud_scene alone, two;
    const int only = _i;
    thud_test_towers(&alone);
    for (int s = 0; s < 2; s++) {
        char key[40];
        snprintf(key, sizeof key, "structures.%d.storeys", s + 1);
        set(&alone, key, "2");
        alone.structure[s].stiffness_npm[0] = alone.structure[s].stiffness_npm[1] = s ? 60e6 : 140e6;
    }
    set(&alone, "levels", "aligned");
    alone.interface[0].has_bumper = false;
    two = alone;
    set(&alone, "gap", "6 cm");
    set(&alone, "structures.2.height", only ? "[3.5 m, 2.5 m]" : "[3 m, 3.5 m]");
    set(&two, "gap", "5 m");
    set(&two, "gap-by-level", only ? "[none, 6 cm]" : "[6 cm, none]");
    same_result(&two, &alone, &only, 1);
    struct thud_error err = {0};
    ck_assert_int_eq(thud_scene_set(&two, "gap-by-level", "[6 cm]", &err), THUD_OK);
    ck_assert_int_eq(thud_scene_check(&two, &err), THUD_INPUT);
    ck_assert_str_eq(err.key, "interfaces.1.gap-by-level");
}
END_TEST

/* Floors named by contact-levels strike as they do where all others are 5 m apart. */
START_TEST(contact_levels_that_can_strike)
{
    static struct thud_scene apart, named;
    static const char *const level[] = {"[4]", "[3]", "[4, 3]"}, *const gaps[] = {"[5 m, 5 m, 5 m, 6 cm]",
                                                                                  "[5 m, 5 m, 6 cm, 5 m]",
                                                                                  "[5 m, 5 m, 6 cm, 6 cm]"};
    static const int floor[][2] = {{4}, {3}, {3, 4}};
    struct thud_error err = {0};
    thud_test_towers(&apart);
    apart.interface[0].has_bumper = false;
    set(&apart, "gap", "6 cm");
    named = apart;
    set(&apart, "gap-by-level", gaps[_i]);
    set(&named, "contact-levels", level[_i]);
    struct thud_record *record = thud_test_motion(1);
    struct thud_solution x, y;
    ck_assert_int_eq(thud_scene_solve(&apart, record, NULL, &x, NULL), THUD_OK);
    ck_assert_int_eq(thud_scene_solve(&named, record, NULL, &y, NULL), THUD_OK);
    const struct thud_result *p = thud_run_result(x.run), *q = thud_run_result(y.run);
    ck_assert_int_eq(q->ncontacts, _i < 2 ? 1 : 2);
    for (int c = 0; c < q->ncontacts; c++) {
        const struct thud_contact_result *one = &p->contact[floor[_i][c] - 1];
        ck_assert_int_eq(q->contact[c].left_floor, floor[_i][c]);
        ck_assert_int_gt(one->impacts, 0);
        ck_assert_double_eq_tol(q->contact[c].force.value / one->force.value, 1, 1e-9);
    }
    for (int s = 0; s < 2; s++)
        for (int i = 0; i < p->structure[s].floors; i++)
            ck_assert_double_eq_tol(
                q->structure[s].floor[i].acceleration.value / p->structure[s].floor[i].acceleration.value, 1, 1e-9);
    thud_solution_clear(&x);
    thud_solution_clear(&y);
    thud_record_free(record);
    static const char *const wrong[] = {"[5]", "[4, 4]", "[2.5]"};
    ck_assert_int_eq(thud_scene_set(&named, "contact-levels", wrong[_i], &err), THUD_OK);
    ck_assert_int_eq(thud_scene_check(&named, &err), THUD_INPUT);
    ck_assert_str_eq(err.key, "interfaces.1.contact-levels");
}
END_TEST

/* A bumper at the top alone is where the bare laws have the bumper's clearance elsewhere too. */
START_TEST(a_bumper_at_the_top_alone)
{
    static struct thud_scene scene;
    struct thud_model *model;
    thud_test_towers(&scene);
    set(&scene, "bumper.cavity", "1 cm");
    set(&scene, "bumper.thickness-by-level", "[0 cm, 0 cm, none, 8 cm]");
    ck_assert_int_eq(thud_scene_assemble(&scene, &model, NULL), THUD_OK);
    static const double clearance_m[] = {0.1, 0.1, 0.06, 0.1 - 0.08 + 0.01}; /* the cavity is that of the wall */
    for (int c = 0; c < 4; c++) {
        ck_assert_double_eq_tol(model->contact[c].clearance_m, clearance_m[c], 1e-12);
        ck_assert_str_eq(model->contact[c].law->name, c < 2 ? scene.interface[0].contact.law->name : "rubber");
    }
    thud_model_free(model);
    struct thud_error err = {0};
    ck_assert_int_eq(thud_scene_set(&scene, "bumper.thickness-by-level", "[0 cm, 0 cm, 0 cm, 14 cm]", &err), THUD_OK);
    ck_assert_int_eq(thud_scene_check(&scene, &err), THUD_INPUT);
    ck_assert_ptr_nonnull(strstr(err.what, "the bumper at 4-4 projects by 13 cm into a gap of 10 cm"));
    char text[128];
    set(&scene, "bumper.thickness-by-level", "[0 cm, 0 cm, none, 8 cm]");
    thud_interface_clearance_text(&scene, 0, text, sizeof text);
    ck_assert_str_eq(text, "10 cm at 1-1 to 2-2, 6 cm at 3-3, 3 cm at 4-4");
    thud_interface_clearance_text(&scene, 0, text, 12); /* cut, not beyond */
    ck_assert_str_eq(text, "10 cm at 1-");
    ck_assert_int_eq(thud_scene_set(&scene, "bumper.thickness-by-level", "[0 cm, 0 cm, 0.9 cm, 8 cm]", &err), THUD_OK);
    ck_assert_int_eq(thud_scene_check(&scene, &err), THUD_INPUT);
    ck_assert_str_eq(err.key, "interfaces.1.bumper.thickness-by-level");
    ck_assert_str_eq(err.what, "the bumper at 3-3 is 0.9 cm thick, and its cavity 1 cm deep");
    set(&scene, "bumper.thickness-by-level", "");
    thud_interface_clearance_text(&scene, 0, text, sizeof text);
    ck_assert_str_eq(text, "6 cm");
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("slab_depth");
    TCase *tcase = tcase_create("slab_depth");
    tcase_add_loop_test(tcase, an_offset_that_grows, 0, 61);
    tcase_add_loop_test(tcase, nothing_passes_between_faces_and_columns, 0, 4);
    tcase_add_loop_test(tcase, without_depth, 0, 200);
    tcase_add_loop_test(tcase, random_depths_and_the_mirror, 0, 200);
    tcase_add_test(tcase, walls_and_bodies);
    tcase_add_loop_test(tcase, one_value_at_every_level, 0, 3);
    tcase_add_loop_test(tcase, one_level_that_can_strike, 0, 2);
    tcase_add_loop_test(tcase, contact_levels_that_can_strike, 0, 3);
    tcase_add_test(tcase, a_bumper_at_the_top_alone);
    suite_add_tcase(suite, tcase);
    return suite;
}
