/* Lead-rubber bearings and pendulums: stick and slip, closed forms, energy, the linear limit, other methods, bad input. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/quantity.h"
#include "core/run/run_private.h"
#include "march.h"
#include "study/scene/solution.h"
#include "suite.h"

static struct thud_scene scene;

/* A rigid slab of 60 t with a stiff storey of 40 t on isolators, by keys and values up to NULL. */
static void isolated(const char *const *set)
{
    thud_scene_init(&scene);
    strcpy(scene.name, "drawn");
    scene.nstructures = 1;
    thud_structure_init(&scene.structure[0], THUD_ISOLATED);
    strcpy(scene.structure[0].name, "A");
    static const char *const body[] = {"mass", "40 t", "stiffness", "1e5 MN/m", "base-mass", "60 t", "damping", "0 %"};
    for (int i = 0; i < 8; i += 2) {
        char key[64];
        snprintf(key, sizeof key, "structures.1.%s", body[i]);
        ck_assert_int_eq(thud_scene_set(&scene, key, body[i + 1], NULL), THUD_OK);
    }
    for (int i = 0; set[i]; i += 2) {
        char key[64];
        snprintf(key, sizeof key, "structures.1.%s", set[i]);
        ck_assert_msg(thud_scene_set(&scene, key, set[i + 1], NULL) == THUD_OK, "%s", key);
    }
}

static const char *const pendulum[] = {
    "isolator.law", "pendulum", "isolator.radius", "2 m", "isolator.friction", "5 %", "isolator.yield", "1 mm", NULL};

/* The numbers of the bilinear loop: weight W, K_d = W/R, Q_d = mu W; none of its own damping. */
START_TEST(loop_of_a_pendulum)
{
    isolated(pendulum);
    const struct thud_isolator p = thud_structure_isolator(&scene.structure[0]);
    const double weight = 100e3 * THUD_GRAVITY, beyond = weight / 2, k = 0.05 * weight / 1e-3 + beyond;
    ck_assert_int_eq(thud_scene_check(&scene, NULL), THUD_OK);
    ck_assert_double_eq_tol(p.stiffness_npm / k, 1, 1e-14);
    ck_assert_double_eq_tol(p.hardening / (beyond / k), 1, 1e-14);
    ck_assert_double_eq(p.yield_m, 1e-3);
    ck_assert_double_eq(p.damping, 0);
    ck_assert(thud_scene_yields(&scene));
    ck_assert_int_eq(thud_scene_set(&scene, "structures.1.isolator.yield", "", NULL), THUD_OK);
    ck_assert_double_eq(thud_structure_isolator(&scene.structure[0]).yield_m, 1e-3);
    ck_assert_int_eq(thud_scene_set(&scene, "structures.1.isolation-damping", "3 %", NULL), THUD_OK);
    ck_assert_double_eq_tol(thud_structure_isolator(&scene.structure[0]).damping, 0.03, 1e-15);
}
END_TEST

/* A mass alone on a pendulum: mass 100 t, R 2 m. */
static struct thud_model *slider(double mu, double yield_m, double velocity)
{
    const double mass = 100e3, weight = mass * THUD_GRAVITY, beyond = weight / 2, k = mu * weight / yield_m + beyond,
                 r = beyond / k;
    struct thud_structure_input s = {
        .n = 1, .mass_kg = &mass, .stiffness_npm = &k, .velocity_mps = velocity, .yield_m = &yield_m, .hardening = &r};
    struct thud_model *model = NULL;
    ck_assert_int_eq(thud_model_create(&(struct thud_model_input){.nstructures = 1, .structure = &s}, &model, NULL),
                     THUD_OK);
    return model;
}

/* Thrown: after u_y it slides as an oscillator of 2 pi sqrt(R/g) about -mu R, and loses Q_d (u_max - u_y) to its turn; back it
 * is elastic over 2 u_y. */
START_TEST(slides_with_its_own_period)
{
    const double mu = 0.03, u_y = 1e-3, v = 1, omega = sqrt(THUD_GRAVITY / 2), mass = 100e3;
    const double beyond = mass * omega * omega, q = mu * mass * THUD_GRAVITY, k = q / u_y + beyond;
    const double fast = sqrt(k / mass), v1 = sqrt(v * v - fast * fast * u_y * u_y), t1 = asin(fast * u_y / v) / fast;
    const double rest = -q / beyond, reach = hypot(u_y - rest, v1 / omega), most = rest + reach;
    const double t2 = atan2(v1 / omega, u_y - rest) / omega;
    struct thud_model *model = slider(mu, u_y, v);
    struct march m = march_run(model, NULL, "exact", 0, 1e-6, true, t1 + t2 + 1e-9);
    const struct thud_storey_result *s = &m.result->structure[0].storey[0];
    ck_assert_double_eq_tol(m.result->structure[0].floor[0].drift.value, most, 1e-12);
    ck_assert_double_eq_tol(m.result->structure[0].floor[0].drift.time_s, t1 + t2, 1e-9);
    ck_assert_double_eq_tol(s->hysteretic_j / (q * (most - u_y)), 1, 1e-10);
    ck_assert_double_eq_tol(m.result->structure[0].base_shear.value / (q + beyond * most), 1, 1e-10);
    ck_assert_double_lt(m.result->energy.error_ratio, 1e-13);
    march_free(&m);
    thud_model_free(model);
}
END_TEST

/* 60 s of constant ground acceleration below what slides: the elastic give and nothing more, to rounding. Put on at once,
 * twice that give is passed through; put on over 2 s, up to just below friction. And stuck where a shock has left it, it
 * stays there to the last bit. */
START_TEST(never_creeps)
{
    enum { N = 6001 };
    static double a[N];
    const double mu = 0.05, u_y = 1e-3, mass = 100e3, k = mu * mass * THUD_GRAVITY / u_y + mass * THUD_GRAVITY / 2;
    struct thud_model *model = slider(mu, u_y, 0);
    for (int slow = 0; slow < 2; slow++) {
        const double most = (slow ? 0.98 : 0.49) * mu * THUD_GRAVITY, give = mass * most / k;
        struct thud_record *record;
        for (int i = 0; i < N; i++)
            a[i] = most * (slow && i < 200 ? i / 200.0 : 1);
        ck_assert_int_eq(thud_record_create(a, N, 0.01, &record, NULL), THUD_OK);
        struct march m = march_run(model, record, "exact", 0, 1e-6, true, 0);
        const struct thud_storey_result *s = &m.result->structure[0].storey[0];
        ck_assert_int_eq(s->excursions, 0);
        ck_assert_double_eq(s->plastic_m, 0);
        ck_assert_double_eq(s->hysteretic_j, 0);
        ck_assert_double_eq_tol(m.result->structure[0].floor[0].displacement.value, slow ? give : 2 * give,
                                slow ? 0.02 * give : 1e-12);
        march_free(&m);
        thud_record_free(record);
    }
    double left[2];
    for (int later = 0; later < 2; later++) {
        struct thud_record *record;
        for (int i = 0; i < N; i++)
            a[i] = i < 100 ? 2 * sin(2 * THUD_PI * i / 80) : i < 400 ? 0 : 0.2 * mu * THUD_GRAVITY;
        ck_assert_int_eq(thud_record_create(a, later ? N : 1000, 0.01, &record, NULL), THUD_OK);
        struct march m = march_run(model, record, "exact", 0, 1e-6, true, 0);
        left[later] = m.result->structure[0].storey[0].plastic_m;
        ck_assert_double_lt(m.result->energy.error_ratio, 1e-10);
        march_free(&m);
        thud_record_free(record);
    }
    ck_assert_double_gt(fabs(left[0]), 1e-3);
    ck_assert_double_eq(left[0], left[1]);
    thud_model_free(model);
}
END_TEST

static struct thud_record *shaking(void)
{
    struct thud_record *record = march_motion(0.7);
    strcpy(scene.record.file, "drawn");
    return record;
}

static double most(const char *method, double *residual)
{
    struct thud_record *record = shaking();
    struct thud_solution answer;
    strcpy(scene.analysis.method, method);
    scene.analysis.tolerance = 1e-10;
    scene.analysis.tail_s = 3;
    ck_assert_int_eq(thud_scene_solve(&scene, record, NULL, &answer, NULL), THUD_OK);
    const struct thud_structure_result *r = &thud_run_result(answer.run)->structure[0];
    double value = r->floor[0].displacement.value;
    *residual = r->storey ? r->storey[0].permanent_m : 0;
    ck_assert_double_lt(thud_run_result(answer.run)->energy.error_ratio, 1e-9);
    thud_solution_clear(&answer);
    thud_record_free(record);
    return value;
}

START_TEST(two_methods_agree)
{
    static const char *const lead[] = {"isolator.law",
                                       "lead-rubber",
                                       "isolator.strength",
                                       "60 kN",
                                       "isolator.post-yield",
                                       "0.7 MN/m",
                                       "isolator.yield",
                                       "10 mm",
                                       "stiffness",
                                       "100 MN/m",
                                       NULL};
    isolated(_i ? lead : pendulum);
    ck_assert_int_eq(thud_scene_set(&scene, "structures.1.stiffness", "100 MN/m", NULL), THUD_OK);
    double residual, other, a = most("auto", &residual), b = most("dormand-prince", &other);
    ck_assert_double_eq_tol(a / b, 1, 1e-7);
    ck_assert_double_eq_tol(residual, other, 1e-8);
    ck_assert_double_gt(fabs(residual), 1e-5);
}
END_TEST

static struct thud_solution moved(const char *method, const struct thud_record *record)
{
    struct thud_solution answer;
    struct thud_run_options options;
    strcpy(scene.analysis.method, method);
    scene.analysis.tolerance = 1e-10;
    scene.analysis.tail_s = 1;
    ck_assert_int_eq(thud_scene_options(&scene, &options, NULL), THUD_OK);
    options.keep_history = true;
    options.history_step_s = 1e-3;
    ck_assert_int_eq(thud_scene_solve(&scene, record, &options, &answer, NULL), THUD_OK);
    return answer;
}

/* Under a damped building most intervals pass in blocks while it slides; all peaks are those of the other method, and where the
 * steel of its storeys yields with it, too. */
START_TEST(slides_in_blocks)
{
    static const char *const damped[] = {"damping",
                                         "3 %",
                                         "stiffness",
                                         "40 MN/m",
                                         "isolator.law",
                                         "pendulum",
                                         "isolator.radius",
                                         "2 m",
                                         "isolator.friction",
                                         "3 %",
                                         "isolator.yield",
                                         "1 mm",
                                         NULL};
    isolated(damped);
    if (_i)
        ck_assert_int_eq(thud_scene_set(&scene, "structures.1.yield", "2 mm", NULL), THUD_OK);
    struct thud_record *record = shaking();
    struct thud_solution answer = moved("auto", record), other = moved("dormand-prince", record);
    const struct thud_result *a = thud_run_result(answer.run), *b = thud_run_result(other.run);
    ck_assert_int_gt(a->structure[0].storey[0].excursions, 20);
    if (!_i)
        ck_assert_int_gt(a->work.samples_fast, a->work.steps);
    ck_assert_double_lt(a->energy.error_ratio, 1e-12);
    ck_assert_double_eq_tol(a->energy.hysteretic_j / b->energy.hysteretic_j, 1, 1e-7);
    ck_assert_double_eq_tol(a->energy.viscous_j / b->energy.viscous_j, 1, 1e-7);
    ck_assert_double_eq_tol(a->structure[0].storey[0].plastic_m, b->structure[0].storey[0].plastic_m, 1e-9);
    ck_assert_double_lt(march_peaks_apart(a, b, 0.01), 1e-7);
    thud_solution_clear(&answer);
    thud_solution_clear(&other);
    thud_record_free(record);
}
END_TEST

/* Without strength lead-rubber bearings are linear ones. */
START_TEST(weak_bearings_are_linear)
{
    static const char *const lead[] = {"isolator.law",
                                       "lead-rubber",
                                       "isolator.strength",
                                       "0.001 N",
                                       "isolator.post-yield",
                                       "1 MN/m",
                                       "isolator.yield",
                                       "10 mm",
                                       "isolation-damping",
                                       "10 %",
                                       NULL};
    static const char *const linear[] = {"isolation-stiffness", "1 MN/m", NULL};
    double unused;
    isolated(lead);
    double a = most("auto", &unused);
    isolated(linear);
    double b = most("auto", &unused);
    ck_assert_double_eq_tol(a / b, 1, 1e-6);
}
END_TEST

/* m a h of one storey, stiff or not, damped or not. */
START_TEST(a_block_overturns_with_m_a_h)
{
    static const char *const linear[] = {"isolation-stiffness", "1 MN/m", "width", "6 m", "height", "4 m", NULL};
    isolated(linear);
    const char *const damping[] = {"0 %", "8 %"}, *const stiffness[] = {"1e5 MN/m", "40 MN/m"};
    ck_assert_int_eq(thud_scene_set(&scene, "structures.1.damping", damping[_i], NULL), THUD_OK);
    ck_assert_int_eq(thud_scene_set(&scene, "structures.1.stiffness", stiffness[_i], NULL), THUD_OK);
    struct thud_record *record = shaking();
    struct thud_solution answer = moved("auto", record);
    const struct thud_structure_result *r = &thud_run_result(answer.run)->structure[0];
    ck_assert_double_eq_tol(r->overturning.value / (40e3 * 4 * r->floor[1].acceleration.value), 1, 1e-9);
    ck_assert_double_eq_tol(r->overturning.time_s, r->floor[1].acceleration.time_s, 1e-6);
    thud_solution_clear(&answer);
    thud_record_free(record);
}
END_TEST

/* Two damped buildings whose isolators slide and whose storeys yield; where _i is 1 a spring with a dashpot and friction
 * tie them. */
static void neighbours(bool linked)
{
    static const char *const both[] = {"storeys", "3",     "mass", "40 t",  "stiffness", "30 MN/m", "damping",
                                       "5 %",     "yield", "2 mm", "width", "8 m",       NULL};
    static const char *const link[][2] = {
        {"law", "spring"}, {"from", "A.4"}, {"to", "B.4"}, {"stiffness", "5 MN/m"}, {"damping", "80 kN s/m"}};
    static const char *const friction[][2] = {
        {"law", "friction"}, {"from", "A.3"}, {"to", "B.2"}, {"stiffness", "20 MN/m"}, {"slip", "20 kN"}};
    isolated(pendulum);
    for (int i = 0; both[i]; i += 2) {
        char key[64];
        snprintf(key, sizeof key, "structures.1.%s", both[i]);
        ck_assert_msg(thud_scene_set(&scene, key, both[i + 1], NULL) == THUD_OK, "%s", key);
    }
    scene.structure[1] = scene.structure[0];
    scene.nstructures = 2;
    strcpy(scene.structure[1].name, "B");
    thud_law_choice_init(&scene.interface[0].contact, thud_law_find("kelvin-voigt"));
    ck_assert_int_eq(thud_scene_set(&scene, "gap", "1 mm", NULL), THUD_OK);
    ck_assert_int_eq(thud_scene_set(&scene, "contact.stiffness", "200 kN/mm", NULL), THUD_OK);
    ck_assert_int_eq(thud_scene_set(&scene, "contact.restitution", "0.6", NULL), THUD_OK);
    ck_assert_int_eq(thud_scene_set(&scene, "structures.2.stiffness", "55 MN/m", NULL), THUD_OK);
    ck_assert_int_eq(thud_scene_set(&scene, "structures.2.isolator.radius", "4 m", NULL), THUD_OK);
    for (int i = 0; i < 5 && linked; i++) {
        char key[64];
        snprintf(key, sizeof key, "links.1.%s", link[i][0]);
        ck_assert_msg(thud_scene_set(&scene, key, link[i][1], NULL) == THUD_OK, "%s", key);
    }
    for (int i = 0; i < 5 && linked; i++) {
        char key[64];
        snprintf(key, sizeof key, "links.2.%s", friction[i][0]);
        ck_assert_msg(thud_scene_set(&scene, key, friction[i][1], NULL) == THUD_OK, "%s", key);
    }
}

/* Sum over the floors of z (m a + force to its neighbour) of structure s (0: the left one). */
static double moment_in_row(const struct thud_history *h, const struct thud_solution *answer, size_t row, int s)
{
    const double *value = h->value + row * (size_t)h->columns;
    const struct thud_model *m = answer->model;
    double sum = 0;
    for (int i = 1; i < 4; i++)
        sum += 3 * i * m->mass_kg[4 * s + i] * value[thud_history_acceleration(h, 4 * s + i)];
    for (int c = 0; c < h->ncontacts; c++) {
        const int floor = s ? m->contact[c].right_floor : m->contact[c].left_floor;
        sum += (s ? -3 : 3) * (floor - 1) * value[thud_history_force(h, c)];
    }
    for (int l = 0; l < h->nlinks; l++) {
        const int dof = s ? m->link[l].right_dof - 4 : m->link[l].left_dof;
        sum += (s ? -3 : 3) * dof * value[thud_history_link_force(h, l)];
    }
    return sum;
}

/* Found by two methods, and no row of a history has a larger one. */
START_TEST(the_overturning_moment_is_what_isolators_hold)
{
    neighbours(_i);
    struct thud_record *record = shaking();
    ck_assert_int_eq(thud_scene_check(&scene, NULL), THUD_OK);
    struct thud_solution answer = moved("auto", record), other = moved("dormand-prince", record);
    const struct thud_result *r = thud_run_result(answer.run);
    const struct thud_history *h = thud_run_history(answer.run);
    ck_assert_int_gt(r->contact[3].impacts, 0);
    for (int s = 0; s < 2; s++) {
        const double most = r->structure[s].overturning.value;
        double seen = 0;
        for (size_t row = 0; row < h->rows; row++)
            seen = fmax(seen, fabs(moment_in_row(h, &answer, row, s)));
        ck_assert_int_gt(r->structure[s].storey[1].excursions, 0);
        ck_assert_double_gt(seen, 0.999 * most);
        ck_assert_double_lt(seen, most * (1 + 1e-9));
        ck_assert_double_eq_tol(thud_run_result(other.run)->structure[s].overturning.value / most, 1, 1e-7);
    }
    thud_solution_clear(&answer);
    thud_solution_clear(&other);
    thud_record_free(record);
}
END_TEST

/* What is wrong with the keys, by key and what is allowed. */
START_TEST(bad_input)
{
    static const struct {
        const char *set[9], *key, *what;
    } wrong[] = {
        {{"isolator.law", "pendulum", "isolator.friction", "5 %"}, "structures.1.isolator.radius", "not given"},
        {{"isolator.law", "pendulum", "isolator.radius", "2 m"}, "structures.1.isolator.friction", "not given"},
        {{"isolator.law", "lead-rubber", "isolator.strength", "1 MN"}, "structures.1.isolator.post-yield", "not given"},
        {{"isolator.law", "lead-rubber", "isolator.radius", "2 m"}, "structures.1.isolator.strength", "not given"},
        {{"isolator.radius", "2 m", "isolation-stiffness", "1 MN/m"}, "structures.1.isolator.radius", "have no radius"},
        {{"damping", "1 %"}, "structures.1.isolation-stiffness", "not given"},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        struct thud_error err = {0};
        isolated(wrong[i].set);
        ck_assert_int_eq(thud_scene_check(&scene, &err), THUD_INPUT);
        ck_assert_str_eq(err.key, wrong[i].key);
        ck_assert_msg(strstr(err.what, wrong[i].what), "%s", err.what);
    }
    isolated(pendulum);
    static const char *const value[][2] = {
        {"radius", "0 m"}, {"radius", "-1 m"}, {"friction", "101 %"}, {"friction", "0 %"}, {"law", "rubber"}};
    for (size_t i = 0; i < sizeof value / sizeof *value; i++) {
        char key[64];
        snprintf(key, sizeof key, "structures.1.isolator.%s", value[i][0]);
        ck_assert_int_eq(thud_scene_set(&scene, key, value[i][1], NULL), THUD_INPUT);
    }
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("isolators");
    TCase *tcase = tcase_create("isolators");
    tcase_add_test(tcase, loop_of_a_pendulum);
    tcase_add_test(tcase, slides_with_its_own_period);
    tcase_add_test(tcase, never_creeps);
    tcase_add_loop_test(tcase, two_methods_agree, 0, 2);
    tcase_add_loop_test(tcase, slides_in_blocks, 0, 2);
    tcase_add_test(tcase, weak_bearings_are_linear);
    tcase_add_loop_test(tcase, a_block_overturns_with_m_a_h, 0, 2);
    tcase_add_loop_test(tcase, the_overturning_moment_is_what_isolators_hold, 0, 2);
    tcase_add_test(tcase, bad_input);
    suite_add_tcase(suite, tcase);
    return suite;
}
