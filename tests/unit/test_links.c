/* Links between neighbours: closed forms, limits, symmetry, energy, and the propagator of tied structures against power
 * series and another method. */
#include <check.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/run/run_private.h"
#include "march.h"
#include "study/scene/scene.h"

enum { STOREYS = 4 };
static const double tower_mass[] = {320e3, 320e3, 320e3, 250e3, 320e3, 320e3},
                    tower_stiffness[] = {6e8, 6e8, 6e8, 6e8, 6e8, 6e8};

/* Two towers of 4 and 6 storeys, 0.15 m apart or what is given, with these links. */
static struct thud_model *towers(double gap, const struct march_law *law, const struct thud_link_input *link,
                                 int nlinks)
{
    const struct thud_structure_input s[] = {
        {.n = STOREYS, .mass_kg = tower_mass, .stiffness_npm = tower_stiffness, .damping = 0.05},
        {.n = STOREYS + 2, .mass_kg = tower_mass, .stiffness_npm = tower_stiffness, .damping = 0.05}};
    struct thud_contact_input contact[STOREYS];
    struct thud_model *model = NULL;
    for (int i = 0; i < STOREYS; i++)
        contact[i] = (struct thud_contact_input){.interface = 1,
                                                 .left_floor = i + 1,
                                                 .right_floor = i + 1,
                                                 .right_structure = 1,
                                                 .clearance_m = gap,
                                                 .law = law->law,
                                                 .setup = law->setup};
    const struct thud_model_input input = {
        .nstructures = 2, .structure = s, .ncontacts = STOREYS, .contact = contact, .nlinks = nlinks, .link = link};
    ck_assert_int_eq(thud_model_create(&input, &model, NULL), THUD_OK);
    return model;
}

static struct march_law concrete(void)
{
    return march_law("kelvin-voigt-no-tension", "stiffness", 2.5e9, "restitution", 0.6, NULL);
}

/* Two oscillators of one storey, the left one with an initial velocity of 1 m/s. */
static struct thud_model *oscillators(const double mass[2], const double stiffness[2],
                                      const struct thud_link_input *link, int nlinks)
{
    const struct thud_structure_input s[] = {{.n = 1, .mass_kg = mass, .stiffness_npm = stiffness, .velocity_mps = 1},
                                             {.n = 1, .mass_kg = mass + 1, .stiffness_npm = stiffness + 1}};
    struct thud_model *model = NULL;
    const struct thud_model_input input = {.nstructures = 2, .structure = s, .nlinks = nlinks, .link = link};
    ck_assert_int_eq(thud_model_create(&input, &model, NULL), THUD_OK);
    return model;
}

static const struct thud_link_input first_floors = {.left_floor = 1, .right_structure = 1, .right_floor = 1};

/* Equal oscillators with a dashpot between them: their sum swings as each alone does, x = sin(w t)/w, their difference
 * as an oscillator of the damping ratio c/(m w), also beyond the critical one. The dashpot loses what the difference
 * loses. */
START_TEST(a_dashpot_between_equal_oscillators)
{
    const double m[] = {320e3, 320e3}, w = 2 * 3.141592653589793, k[] = {m[0] * w * w, m[1] * w * w}, t = 3.3;
    const double zeta = (double[]){0.1, 0.7, 1.6}[_i];
    struct thud_link_input link = first_floors;
    link.damping_nspm = zeta * m[0] * w;
    struct thud_model *model = oscillators(m, k, &link, 1);
    struct march a = march_run(model, NULL, "exact", 0, 0, true, t);
    double sum = sin(w * t) / w, sum_rate = cos(w * t), difference, rate;
    if (zeta < 1) {
        double wd = w * sqrt(1 - zeta * zeta), fade = exp(-zeta * w * t);
        difference = fade * sin(wd * t) / wd;
        rate = fade * (cos(wd * t) - zeta * w / wd * sin(wd * t));
    } else {
        double s = w * sqrt(zeta * zeta - 1), slow = exp((s - zeta * w) * t), fast = exp((-s - zeta * w) * t);
        difference = (slow - fast) / (2 * s);
        rate = ((s - zeta * w) * slow + (s + zeta * w) * fast) / (2 * s);
    }
    ck_assert_int_eq(a.status, THUD_OK);
    ck_assert_double_eq_tol(march_displacement(&a, 0), 0.5 * (sum + difference), 1e-12);
    ck_assert_double_eq_tol(march_displacement(&a, 1), 0.5 * (sum - difference), 1e-12);
    ck_assert_double_eq_tol(march_velocity(&a, 0), 0.5 * (sum_rate + rate), 1e-11);
    double lost = 0.25 * m[0] * (1 - rate * rate - w * w * difference * difference);
    ck_assert_double_eq_tol(a.result->link[0].lost_j, lost, 1e-10 * lost);
    ck_assert_double_eq_tol(a.result->energy.viscous_j, lost, 1e-10 * lost);
    ck_assert_double_eq_tol(a.result->link[0].force.value, link.damping_nspm, 1e-9 * link.damping_nspm); /* c 1 m/s */
    ck_assert_double_lt(a.result->energy.error_ratio, 1e-11);
    march_free(&a);
    thud_model_free(model);
}
END_TEST

/* The same beside a body that presses a soft wall all the time, under samples 1 s apart, so that steps of contact turn by
 * 2 pi: what the dashpot loses is still right to rounding. */
START_TEST(a_dashpot_beside_a_long_contact)
{
    const double m[] = {320e3, 320e3}, w = 2 * 3.141592653589793, k[] = {m[0] * w * w, m[1] * w * w}, zeta = 0.01;
    const struct march_law soft = march_law("hertz", "stiffness", 1e4, NULL);
    const struct thud_structure_input s[] = {{.n = 1, .mass_kg = m, .stiffness_npm = k, .velocity_mps = 1},
                                             {.n = 1, .mass_kg = m + 1, .stiffness_npm = k + 1},
                                             {.n = 1, .mass_kg = m, .velocity_mps = 0.1},
                                             {.n = 0}};
    struct thud_link_input link = first_floors;
    link.damping_nspm = zeta * m[0] * w;
    const struct thud_contact_input contact = {.interface = 3,
                                               .left_structure = 2,
                                               .left_floor = 1,
                                               .right_structure = 3,
                                               .law = soft.law,
                                               .setup = soft.setup};
    const struct thud_model_input input = {
        .nstructures = 4, .structure = s, .ncontacts = 1, .contact = &contact, .nlinks = 1, .link = &link};
    struct thud_model *model = NULL;
    struct thud_record *still = NULL;
    ck_assert_int_eq(thud_model_create(&input, &model, NULL), THUD_OK);
    ck_assert_int_eq(thud_record_create((const double[]){0, 0, 0, 0}, 4, 1, &still, NULL), THUD_OK);
    struct march a = march_run(model, still, "exact", 0, 1e-9, true, 0.3);
    ck_assert_int_eq(a.status, THUD_OK);
    ck_assert_double_eq_tol(a.result->contact[0].contact_time_s, a.result->end_s, 1e-9);
    const double t = a.result->end_s, wd = w * sqrt(1 - zeta * zeta), fade = exp(-zeta * w * t),
                 difference = fade * sin(wd * t) / wd, rate = fade * (cos(wd * t) - zeta * w / wd * sin(wd * t)),
                 lost = 0.25 * m[0] * (1 - rate * rate - w * w * difference * difference);
    ck_assert_double_eq_tol(a.result->link[0].lost_j, lost, 1e-11 * lost);
    march_free(&a);
    thud_record_free(still);
    thud_model_free(model);
}
END_TEST

/* A spring between them: the difference swings at sqrt(w^2 + 2 k_l/m); its largest stroke and force. */
START_TEST(a_spring_between_equal_oscillators)
{
    const double m[] = {320e3, 320e3}, w = 2 * 3.141592653589793, k[] = {m[0] * w * w, m[1] * w * w}, t = 3.3;
    struct thud_link_input link = first_floors;
    link.stiffness_npm = 1.7 * k[0];
    struct thud_model *model = oscillators(m, k, &link, 1);
    struct march a = march_run(model, NULL, "exact", 0, 0, true, t);
    double wd = w * sqrt(1 + 2 * 1.7);
    ck_assert_double_eq_tol(march_displacement(&a, 0), 0.5 * (sin(w * t) / w + sin(wd * t) / wd), 1e-12);
    ck_assert_double_eq_tol(a.result->link[0].stroke.value, 1 / wd, 1e-10 / wd);
    ck_assert_double_eq_tol(a.result->link[0].force.value, link.stiffness_npm / wd, 1e-4 * k[0] / wd);
    ck_assert_double_eq(a.result->link[0].lost_j, 0);
    const double difference = sin(wd * t) / wd, stored = 0.5 * link.stiffness_npm * difference * difference;
    ck_assert_double_eq_tol(a.result->link[0].stored_j, stored, 1e-10 * stored);
    march_free(&a);
    thud_model_free(model);
}
END_TEST

/* A free body presses an elastic strut, and the run ends before it turns: k d^2/2 is stored, and nothing is lost. */
START_TEST(an_elastic_strut_stores)
{
    const double m = 320e3, k = 5e8, v = 1, w = sqrt(k / m), t = 0.3 * acos(-1) / w, d = v / w * sin(w * t);
    const struct thud_structure_input s[] = {{.n = 1, .mass_kg = &m, .velocity_mps = v}, {.n = 0}};
    struct thud_link_input link = {.left_floor = 1, .right_structure = 1, .law = thud_law_find("linear")};
    link.setup.value[thud_law_param(link.law, "stiffness")] = k;
    struct thud_model *model = NULL;
    const struct thud_model_input input = {.nstructures = 2, .structure = s, .nlinks = 1, .link = &link};
    ck_assert_int_eq(thud_model_create(&input, &model, NULL), THUD_OK);
    static const char *const method[] = {"exact", "dormand-prince"};
    for (int i = 0; i < 2; i++) {
        struct march a = march_run(model, NULL, method[i], 0, 1e-11, true, t);
        ck_assert_int_eq(a.status, THUD_OK);
        ck_assert_double_eq_tol(a.result->link[0].stored_j, 0.5 * k * d * d, 1e-9 * k * d * d);
        ck_assert_double_eq(a.result->link[0].lost_j, 0);
        march_free(&a);
    }
    thud_model_free(model);
}
END_TEST

/* A free body on a link of friction to the ground: the spring until it slips, then all of its motion but that of the
 * spring's last give is lost, and it swings in that give. */
START_TEST(friction_stops_a_body)
{
    const double m = 320e3, k = 5e8, slip = 4e5;
    const struct thud_structure_input s[] = {{.n = 1, .mass_kg = &m, .velocity_mps = 1}, {.n = 0}};
    const struct thud_link_input link = {
        .left_floor = 1, .right_structure = 1, .stiffness_npm = k, .slip_n = _i == 0 ? slip : 1e9};
    struct thud_model *model = NULL;
    const struct thud_model_input input = {.nstructures = 2, .structure = s, .nlinks = 1, .link = &link};
    ck_assert_int_eq(thud_model_create(&input, &model, NULL), THUD_OK);
    static const char *const method[] = {"exact", "dormand-prince"};
    for (int i = 0; i < 2; i++) {
        struct march a = march_run(model, NULL, method[i], 0, 1e-11, true, 2);
        const double give = slip / k, lost = 0.5 * m - 0.5 * k * give * give, w = sqrt(k / m);
        ck_assert_int_eq(a.status, THUD_OK);
        if (_i == 0) {
            ck_assert_double_eq_tol(a.result->energy.hysteretic_j, lost, 1e-9 * lost);
            ck_assert_double_eq_tol(a.result->link[0].lost_j, lost, 1e-9 * lost);
            ck_assert_double_eq_tol(a.result->link[0].stored_j + a.result->energy.kinetic_j, 0.5 * k * give * give,
                                    1e-9 * lost); /* it swings in the give */
            ck_assert_double_gt(a.result->link[0].stored_j, 0.01 * k * give * give);
            ck_assert_double_eq_tol(a.result->link[0].stroke.value, lost / slip + give, 1e-10);
            ck_assert_double_eq(a.result->link[0].force.value, slip);
            ck_assert_int_eq(a.result->link[0].engaged, 1);
        } else { /* it holds */
            ck_assert_double_eq(a.result->link[0].lost_j, 0);
            ck_assert_double_eq_tol(a.result->link[0].stroke.value, 1 / w, 1e-9);
            ck_assert_double_eq_tol(a.result->link[0].force.value, k / w, 1e-9 * k / w);
        }
        ck_assert_double_lt(a.result->energy.error_ratio, 1e-10);
        march_free(&a);
    }
    thud_model_free(model);
}
END_TEST

/* The stiffer the link, the more its floors are one body on both springs. */
START_TEST(a_very_stiff_link_makes_two_floors_one)
{
    const double m[] = {320e3, 180e3}, k[] = {6e7, 2e7}, t = 2;
    const double w = sqrt((k[0] + k[1]) / (m[0] + m[1])), v = m[0] / (m[0] + m[1]);
    double before = INFINITY;
    for (double stiffness = 1e11; stiffness < 1e16; stiffness *= 100) {
        struct thud_link_input link = first_floors;
        link.stiffness_npm = stiffness;
        link.damping_nspm = 2 * sqrt(stiffness * 115200); /* what the blow of the tie leaves between them dies out */
        struct thud_model *model = oscillators(m, k, &link, 1);
        struct march a = march_run(model, NULL, "exact", 0, 0, true, t);
        double off = fmax(fabs(march_displacement(&a, 0) - v * sin(w * t) / w),
                          fabs(march_displacement(&a, 0) - march_displacement(&a, 1)));
        ck_assert_double_lt(off, 0.2 * before);
        before = off;
        march_free(&a);
        thud_model_free(model);
    }
    ck_assert_double_lt(before, 1e-6);
}
END_TEST

/* The ends of a link have the name of a building, and no other text of it: not that of a unit or a file. */
START_TEST(ends_follow_the_name_alone)
{
    struct thud_scene *scene = calloc(1, sizeof *scene);
    ck_assert_ptr_nonnull(scene);
    thud_scene_init(scene);
    scene->nstructures = 2;
    thud_structure_init(&scene->structure[0], THUD_SHEAR);
    thud_structure_init(&scene->structure[1], THUD_MODES);
    static const char *const set[][2] = {
        {"structures.1.name", "A"},    {"structures.2.name", "s"},  {"structures.2.unit", "s"},
        {"structures.2.periods", "s"}, {"links.1.law", "dashpot"},  {"links.1.from", "A.1"},
        {"links.1.to", "s.1"},         {"structures.2.unit", "ms"}, {"structures.2.periods", "modes.csv"}};
    char text[THUD_NAME_MAX + 8];
    for (size_t i = 0; i < sizeof set / sizeof *set; i++)
        ck_assert_int_eq(thud_scene_set(scene, set[i][0], set[i][1], NULL), THUD_OK);
    ck_assert_int_eq(thud_scene_get(scene, "links.1.to", text, sizeof text, NULL), THUD_OK);
    ck_assert_str_eq(text, "s.1");
    ck_assert_int_eq(thud_scene_set(scene, "structures.2.name", "B", NULL), THUD_OK);
    ck_assert_int_eq(thud_scene_get(scene, "links.1.to", text, sizeof text, NULL), THUD_OK);
    ck_assert_str_eq(text, "B.1");
    free(scene);
}
END_TEST

/* A tie to the ground is a stiffer storey. */
START_TEST(a_link_to_the_ground)
{
    const double m[] = {320e3, 180e3}, k[] = {6e7, 2e7}, stiffer[] = {9e7, 2e7};
    struct thud_link_input link = {.left_floor = 1, .right_structure = 1, .stiffness_npm = 3e7};
    struct thud_model *tied = oscillators(m, k, &link, 1), *stiff = oscillators(m, stiffer, NULL, 0);
    struct thud_record *record = march_motion(1);
    struct march a = march_run(tied, record, "exact", 0, 0, true, 1),
                 b = march_run(stiff, record, "exact", 0, 0, true, 1);
    ck_assert_double_eq_tol(march_displacement(&a, 0), march_displacement(&b, 0), 1e-11);
    ck_assert_double_eq_tol(march_displacement(&a, 1), march_displacement(&b, 1), 1e-11);
    march_free(&a);
    march_free(&b);
    thud_model_free(tied);
    thud_model_free(stiff);
    thud_record_free(record);
}
END_TEST

static void same_bits(const struct thud_model *with, const struct thud_model *without)
{
    struct thud_record *record = march_motion(1);
    struct march a = march_run(with, record, "exact", 0, 0, true, 1),
                 b = march_run(without, record, "exact", 0, 0, true, 1);
    ck_assert_int_gt(b.result->contact[STOREYS - 1].impacts, 0);
    for (int s = 0; s < 2; s++)
        ck_assert_mem_eq(a.result->structure[s].floor, b.result->structure[s].floor,
                         (size_t)b.result->structure[s].floors * sizeof *b.result->structure[s].floor);
    ck_assert_mem_eq(&a.result->energy, &b.result->energy, sizeof b.result->energy);
    march_free(&a);
    march_free(&b);
    thud_record_free(record);
}

/* A link of no stiffness and no damping, and a restrainer whose slack is never used up, change no bit. */
START_TEST(a_link_of_nothing_changes_nothing)
{
    struct march_law law = concrete(), tie = march_law("linear", "stiffness", 1e8, NULL);
    struct thud_link_input link[2] = {first_floors, first_floors};
    link[1].law = tie.law;
    link[1].setup = tie.setup;
    link[1].tension = true;
    link[1].clearance_m = 5;
    struct thud_model *with = towers(0.02, &law, link, 2), *without = towers(0.02, &law, NULL, 0);
    same_bits(with, without);
    thud_model_free(with);
    thud_model_free(without);
}
END_TEST

/* The tie holds as far as a contact would press were the motion mirrored. */
START_TEST(a_restrainer_is_the_mirrored_contact)
{
    struct march_law law = concrete(), tie = march_law("linear", "stiffness", 3e8, NULL);
    struct thud_record *record = march_motion(1), *mirrored = march_motion(-1);
    struct thud_link_input link = {.left_floor = 4,
                                   .right_structure = 1,
                                   .right_floor = 4,
                                   .law = tie.law,
                                   .setup = tie.setup,
                                   .tension = true,
                                   .clearance_m = 0.02};
    struct thud_model *held = towers(5, &law, &link, 1);
    link.tension = false;
    struct thud_model *pressed = towers(5, &law, &link, 1);
    struct march a = march_run(held, record, "exact", 0, 0, true, 1),
                 b = march_run(pressed, mirrored, "exact", 0, 0, true, 1);
    ck_assert_int_gt(b.result->link[0].engaged, 3);
    ck_assert_int_eq(a.result->link[0].engaged, b.result->link[0].engaged);
    ck_assert_double_eq(a.result->link[0].force.value, b.result->link[0].force.value);
    ck_assert_double_eq(a.result->link[0].stroke.value, b.result->link[0].stroke.value);
    ck_assert_double_eq_tol(a.result->link[0].force.value, 3e8 * a.result->link[0].stroke.value,
                            1e-9 * a.result->link[0].force.value);
    for (int i = 0; i < STOREYS + 2; i++)
        ck_assert_double_eq(a.result->structure[1].floor[i].acceleration.value,
                            b.result->structure[1].floor[i].acceleration.value);
    march_free(&a);
    march_free(&b);
    thud_model_free(held);
    thud_model_free(pressed);
    thud_record_free(record);
    thud_record_free(mirrored);
}
END_TEST

/* All kinds at once; the i-th has them stronger. */
static struct thud_model *tied_towers(double gap, double strength, struct march_law *tie)
{
    struct march_law law = concrete();
    *tie = march_law("linear", "stiffness", 2e8 * strength, NULL);
    const struct thud_link_input link[] = {
        {.left_floor = 4, .right_structure = 1, .right_floor = 4, .damping_nspm = 2e6 * strength},
        {.left_floor = 2, .right_structure = 1, .right_floor = 3, .stiffness_npm = 3e7, .damping_nspm = 1e6 * strength},
        {.left_floor = 3, .right_structure = 1, .right_floor = 5, .stiffness_npm = 1e7 * strength},
        {.left_floor = 3,
         .right_structure = 1,
         .right_floor = 3,
         .law = tie->law,
         .setup = tie->setup,
         .tension = true,
         .clearance_m = 0.01},
        {.left_floor = 1,
         .right_structure = 1,
         .right_floor = 2,
         .law = tie->law,
         .setup = tie->setup,
         .clearance_m = 0.002},
        {.left_floor = 3, .right_structure = 1, .right_floor = 2, .stiffness_npm = 5e7, .slip_n = 6e4}};
    return towers(gap, &law, link, 6);
}

static struct march way(const struct thud_model *model, const struct thud_record *record, bool blocks)
{
    struct march m = {0};
    struct thud_run_options options;
    bool done = false;
    thud_run_options_init(&options);
    options.method = thud_method_find("exact");
    options.tail_s = 2;
    m.status = thud_run_create(model, record, &options, &m.run, &m.err);
    ck_assert_int_eq(m.status, THUD_OK);
    ck_assert_ptr_nonnull(m.run->free_vibration);
    if (!blocks)
        m.run->free_vibration = NULL;
    while (m.status == THUD_OK && !done)
        m.status = thud_run_advance(m.run, 1000, &done, &m.err);
    ck_assert_int_eq(m.status, THUD_OK);
    m.result = thud_run_result(m.run);
    return m;
}

static void compare_links(const struct thud_result *a, const struct thud_result *b, double tolerance)
{
    for (int i = 0; i < b->nlinks; i++) {
        const struct thud_link_result *p = &a->link[i], *q = &b->link[i];
        ck_assert_double_eq_tol(p->force.value, q->force.value, tolerance * q->force.value);
        ck_assert_double_eq_tol(p->stroke.value, q->stroke.value, tolerance * fmax(q->stroke.value, 1e-3));
        ck_assert_double_eq_tol(p->lost_j, q->lost_j, tolerance * fmax(q->lost_j, 100));
        ck_assert_int_eq(p->engaged, q->engaged);
    }
}

/* Blocks of free vibration by the propagator of the tied towers, and power series alone; apart and pounding. */
START_TEST(propagator_against_series)
{
    struct march_law tie;
    struct thud_record *record = march_motion(1);
    struct thud_model *model = tied_towers(_i == 0 ? 2 : 0.01, 1, &tie);
    struct march a = way(model, record, true), b = way(model, record, false);
    ck_assert_int_gt(a.result->work.samples_fast, 50);
    ck_assert_int_eq(b.result->work.samples_fast, 0);
    ck_assert_double_lt(march_peaks_apart(a.result, b.result, 0.01), 1e-10);
    ck_assert_double_lt(march_distance(&a, &b), 1e-10);
    compare_links(a.result, b.result, 1e-10);
    ck_assert_double_lt(a.result->energy.error_ratio, 1e-12);
    double lost = 0;
    for (int i = 0; i < 5; i++)
        lost += a.result->link[i].lost_j;
    ck_assert_double_lt(lost, a.result->energy.viscous_j);
    march_free(&a);
    march_free(&b);
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

/* Another method, which knows the model's equations and no propagator; links of 1 and of 30 times the strength. */
START_TEST(against_dormand_prince)
{
    struct march_law tie;
    struct thud_record *record = march_motion(1);
    struct thud_model *model = tied_towers(0.02, _i == 0 ? 1 : 30, &tie);
    struct march a = march_run(model, record, "exact", 0, 0, true, 1);
    struct march b = march_run(model, record, "dormand-prince", 0, 1e-10, true, 1);
    ck_assert_int_eq(a.status, THUD_OK);
    ck_assert_int_eq(b.status, THUD_OK);
    ck_assert_int_gt(a.result->link[3].engaged, 0);
    ck_assert_int_gt(a.result->link[5].engaged, 0);
    ck_assert_double_lt(march_peaks_apart(a.result, b.result, 0.01), 1e-7);
    compare_links(a.result, b.result, 1e-7);
    ck_assert_double_lt(a.result->energy.error_ratio, 1e-11);
    march_free(&a);
    march_free(&b);
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("links");
    TCase *tcase = tcase_create("links");
    tcase_set_timeout(tcase, 60);
    tcase_add_loop_test(tcase, a_dashpot_between_equal_oscillators, 0, 3);
    tcase_add_test(tcase, ends_follow_the_name_alone);
    tcase_add_test(tcase, a_dashpot_beside_a_long_contact);
    tcase_add_test(tcase, a_spring_between_equal_oscillators);
    tcase_add_test(tcase, an_elastic_strut_stores);
    tcase_add_loop_test(tcase, friction_stops_a_body, 0, 2);
    tcase_add_test(tcase, a_very_stiff_link_makes_two_floors_one);
    tcase_add_test(tcase, a_link_to_the_ground);
    tcase_add_test(tcase, a_link_of_nothing_changes_nothing);
    tcase_add_test(tcase, a_restrainer_is_the_mirrored_contact);
    tcase_add_loop_test(tcase, propagator_against_series, 0, 2);
    tcase_add_loop_test(tcase, against_dormand_prince, 0, 2);
    suite_add_tcase(suite, tcase);
    return suite;
}
