/* Buildings on soil: periods and damping in closed form, the limit of rigid ground, what a half-space gives, other
 * methods, energy, symmetry, buildings by their matrix, and bad input. */
#include <check.h>
#include <lapacke.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"
#include "base/random.h"
#include "march.h"
#include "remarks.h"
#include "scenes.h"
#include "study/scene/building.h"
#include "study/scene/level.h"
#include "study/scene/solution.h"
#include "study/sweep/remark.h"
#include "suite.h"
#include "towers.h"

static struct thud_scene scene;

static void set(const char *path, const char *text)
{
    struct thud_error err = {0};
    char why[1400];
    ck_assert_msg(thud_scene_set(&scene, path, text, &err) == THUD_OK, "%s", thud_error_text(&err, why, sizeof why));
}

static struct thud_model *assembled(void)
{
    struct thud_model *model = NULL;
    struct thud_error err = {0};
    char why[1400];
    ck_assert_msg(thud_scene_check(&scene, &err) == THUD_OK && thud_scene_assemble(&scene, &model, &err) == THUD_OK,
                  "%s", thud_error_text(&err, why, sizeof why));
    return model;
}

enum { MASS = 100000 }; /* kg */
static const double k = 4e7, height = 3.5, zeta = 0.05;

/* A storey of 100 t on a foundation of next to no mass. */
static struct thud_model *oscillator(const struct thud_foundation_input *soil)
{
    const double mass = MASS;
    struct thud_structure_input s = {
        .n = 1, .mass_kg = &mass, .stiffness_npm = &k, .damping = zeta, .foundation = soil, .rise_m = &height};
    struct thud_model *model = NULL;
    ck_assert_int_eq(thud_model_create(&(struct thud_model_input){.nstructures = 1, .structure = &s}, &model, NULL),
                     THUD_OK);
    return model;
}

/* T~/T = sqrt(1 + k/K_x + k h^2/K_t); and the damping of springs in a row, each with its dashpot, under one force:
 * zeta~ = sum (C/K^2)/(sum 1/K)^2/(2 m omega~), of a rotation K = K_t/h^2. */
START_TEST(period_and_damping_of_an_oscillator)
{
    static const double ratio[][4] = {/* k/K_x, k h^2/K_t, and dashpots of the critical ones */
                                      {0.1, 0.3, 0.1, 0.02},
                                      {0.01, 0.02, 0, 0},
                                      {1, 2, 0.3, 0.2},
                                      {0.5, 1e-4, 0.05, 0}};
    const double h2 = height * height, omega = sqrt(k / MASS), c = 2 * zeta * sqrt(k * MASS);
    const struct thud_foundation_input soil = {.mass_kg = 1e-4,
                                               .inertia_kgm2 = 1e-4,
                                               .sway_npm = k / ratio[_i][0],
                                               .rocking_nmprad = k * h2 / ratio[_i][1],
                                               .sway_nspm = ratio[_i][2] * c / zeta,
                                               .rocking_nmsprad = ratio[_i][3] * c / zeta * h2};
    struct thud_model *model = oscillator(&soil);
    const struct thud_model_structure *p = &model->structure[0];
    const double give[] = {1 / k, 1 / soil.sway_npm, h2 / soil.rocking_nmprad},
                 dashpot[] = {c, soil.sway_nspm, soil.rocking_nmsprad / h2};
    double all = 0, loss = 0;
    for (int i = 0; i < 3; i++) {
        all += give[i];
        loss += dashpot[i] * give[i] * give[i];
    }
    ck_assert_double_eq_tol(omega / p->omega[0] / sqrt(1 + ratio[_i][0] + ratio[_i][1]), 1, 1e-8);
    ck_assert_double_eq_tol(p->soil_damping / (loss / (all * all) / (2 * MASS * p->omega[0])), 1, 1e-7);
    ck_assert_double_eq_tol(p->rigid_period_s * omega / (2 * THUD_PI), 1, 1e-14);
    /* the drift is the spring's part of the whole, whichever way it is read */
    ck_assert_double_eq_tol(thud_model_drift(p, p->phi, p->modes, 0) / p->phi[0], give[0] / all, 1e-7);
    thud_model_free(model);
}
END_TEST

/* Largest |rate| of q'' + D q' + Omega^2 q = 0, by LAPACK from the first-order system, and the largest rate of D alone. */
static double fastest_rate(const struct thud_model_structure *p, const double *omega, double *damping)
{
    const int n = p->modes, size = 2 * n;
    double a[32 * 32] = {0}, d[16 * 16], real[32], imaginary[32], fastest = 0;
    ck_assert_int_le(n, 16);
    for (int i = 0; i < n; i++) {
        a[i * size + n + i] = 1;
        a[(n + i) * size + i] = -omega[i] * omega[i];
        for (int j = 0; j < n; j++)
            a[(n + i) * size + n + j] = -(d[i * n + j] = p->damping[i * n + j]);
    }
    ck_assert_int_eq(LAPACKE_dgeev(LAPACK_ROW_MAJOR, 'N', 'N', size, a, size, real, imaginary, NULL, 1, NULL, 1), 0);
    for (int i = 0; i < size; i++) {
        fastest = fmax(fastest, hypot(real[i], imaginary[i]));
        ck_assert_double_lt(real[i], 1e-9 * omega[n - 1]);
    }
    ck_assert_int_eq(LAPACKE_dsyev(LAPACK_ROW_MAJOR, 'N', 'U', n, d, n, real), 0);
    *damping = real[n - 1];
    return fastest;
}

/* Pieces of a series and default steps are taken by it: no rate of a random building on soil is above the bound, and it is
 * that of the frequencies or of the dashpots, not of both. */
START_TEST(no_rate_is_above_the_bound)
{
    struct thud_random random = {20};
    double nearest = 0;
    for (int i = 0; i < 200; i++) {
        double mass[8], stiffness[8], rise[8], damping;
        const int n = 1 + i % 8;
        for (int floor = 0; floor < n; floor++) {
            mass[floor] = 1e5 * exp(2 * thud_random_unit(&random) - 1);
            stiffness[floor] = 1e8 * exp(2 * thud_random_unit(&random) - 1);
            rise[floor] = 3;
        }
        const double strong = exp(8 * thud_random_unit(&random) - 5);
        const struct thud_foundation_input soil = {.mass_kg = 1e5 * exp(6 * thud_random_unit(&random) - 4),
                                                   .inertia_kgm2 = 1e6 * exp(6 * thud_random_unit(&random) - 4),
                                                   .sway_npm = 1e8,
                                                   .rocking_nmprad = 1e10,
                                                   .sway_nspm = 1e7 * strong * thud_random_unit(&random),
                                                   .rocking_nmsprad = 1e8 * strong * thud_random_unit(&random)};
        struct thud_structure_input s = {.n = n,
                                         .mass_kg = mass,
                                         .stiffness_npm = stiffness,
                                         .damping = 0.2 * thud_random_unit(&random),
                                         .foundation = &soil,
                                         .rise_m = rise};
        struct thud_model *m = NULL;
        ck_assert_int_eq(thud_model_create(&(struct thud_model_input){.nstructures = 1, .structure = &s}, &m, NULL),
                         THUD_OK);
        const double rate = fastest_rate(&m->structure[0], m->omega, &damping), bound = thud_model_fastest(m, 0);
        ck_assert_double_le(rate, bound * (1 + 1e-9));
        ck_assert_double_le(bound, 1.3 * fmax(m->omega[m->nmodes - 1], damping));
        ck_assert_double_eq(bound, m->fastest_radps);
        nearest = fmax(nearest, damping > m->omega[m->nmodes - 1] ? rate / bound : 0);
        thud_model_free(m);
    }
    ck_assert_double_gt(nearest, 0.95);
}
END_TEST

/* At the step that a method takes by itself, on soft ground under a light foundation and on stiff ground under a heavy one. */
START_TEST(default_steps_are_stable)
{
    static const char *const ground[][2] = {{"100 m/s", "20 t"}, {"400 m/s", "400 t"}};
    struct thud_record *record = thud_test_motion(0.6);
    thud_test_towers(&scene);
    for (int s = 1; s <= 2; s++) {
        static const char *const key[][2] = {{"density", "1.9 t/m3"}, {"poisson", "0.4"}, {"radius", "9 m"}};
        char path[64];
        for (int i = 0; i < 5; i++) {
            snprintf(path, sizeof path, "structures.%d.foundation.%s", s, i < 3 ? key[i][0] : i == 3 ? "vs" : "mass");
            set(path, i < 3 ? key[i][1] : ground[_i][i - 3]);
        }
    }
    struct thud_model *model = assembled();
    struct march exact = march_run(model, record, "exact", 0, 1e-6, true, 1);
    ck_assert_int_eq(exact.status, THUD_OK);
    for (int i = 0; i < thud_method_count(); i++) {
        const struct thud_method *method = thud_method_at(i);
        if (method->order == 0)
            continue;
        struct march m = march_run(model, record, method->name, 0, 0, false, 1);
        ck_assert_msg(m.status == THUD_OK, "%s: %s", method->name, m.err.what);
        for (int s = 0; s < 2; s++)
            for (int floor = 0; floor < 4; floor++)
                ck_assert_msg(fabs(m.result->structure[s].floor[floor].drift.value /
                                       exact.result->structure[s].floor[floor].drift.value -
                                   1) < 0.05,
                              "%s: structure %d, storey %d", method->name, s + 1, floor + 1);
        march_free(&m);
    }
    march_free(&exact);
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

/* Ground so stiff that nothing of it is felt: the modes of rigid ground to rounding, the damping too. */
START_TEST(stiff_ground_is_rigid)
{
    thud_test_towers(&scene);
    struct thud_model *rigid = assembled();
    set("structures.2.foundation.mass", "400 t");
    set("structures.2.foundation.inertia", "1e4 t m2");
    set("structures.2.foundation.sway-stiffness", "1e9 MN/m");
    set("structures.2.foundation.rocking-stiffness", "1e9 GN m/rad");
    struct thud_model *stiff = assembled();
    const struct thud_model_structure *a = &rigid->structure[1], *b = &stiff->structure[1];
    ck_assert_int_eq(b->modes, a->modes + 2);
    for (int j = 0; j < a->modes; j++) {
        ck_assert_double_eq_tol(b->omega[j] / a->omega[j], 1, 2e-6);
        ck_assert_double_eq_tol(b->damping[j * b->modes + j] / (2 * 0.05 * a->omega[j]), 1, 1e-5);
        for (int i = 0; i < a->n; i++)
            ck_assert_double_eq_tol(b->phi[i * b->modes + j], a->phi[i * a->modes + j], 1e-8);
    }
    thud_model_free(rigid);
    thud_model_free(stiff);
}
END_TEST

/* Ten times stiffer ground is ten times nearer to rigid ground, in a run with contact too. */
START_TEST(runs_come_near_rigid_ground)
{
    struct thud_record *record = thud_test_motion(0.5);
    double apart[2];
    thud_test_towers(&scene);
    struct thud_model *model = assembled();
    struct march rigid = march_run(model, record, "exact", 0, 1e-9, true, 1);
    for (int i = 0; i < 2; i++) {
        set("structures.2.foundation.mass", "400 t");
        set("structures.2.foundation.inertia", "1e4 t m2");
        set("structures.2.foundation.sway-stiffness", i ? "1e6 MN/m" : "1e5 MN/m");
        set("structures.2.foundation.rocking-stiffness", i ? "1e6 GN m/rad" : "1e5 GN m/rad");
        struct thud_model *soil = assembled();
        struct march m = march_run(soil, record, "exact", 0, 1e-9, true, 1);
        ck_assert_int_eq(m.status, THUD_OK);
        apart[i] = fabs(m.result->structure[1].floor[5].displacement.value /
                            rigid.result->structure[1].floor[5].displacement.value -
                        1);
        march_free(&m);
        thud_model_free(soil);
    }
    ck_assert_double_lt(apart[0], 0.05);
    ck_assert_double_lt(apart[1], 0.2 * apart[0]);
    march_free(&rigid);
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

/* A disk of 10 m on soil of 200 m/s, 1.8 t/m3 and nu 0.4, by hand: G = 72 MPa. */
START_TEST(disk_on_a_half_space)
{
    thud_test_towers(&scene);
    set("structures.1.foundation.mass", "500 t");
    set("structures.1.foundation.vs", "200 m/s");
    set("structures.1.foundation.density", "1.8 t/m3");
    set("structures.1.foundation.poisson", "0.4");
    set("structures.1.foundation.radius", "10 m");
    const struct thud_foundation_input f = thud_structure_foundation(&scene.structure[0]);
    ck_assert_double_eq_tol(f.sway_npm, 8 * 72e6 * 10 / 1.6, 1);
    ck_assert_double_eq_tol(f.rocking_nmprad, 8 * 72e6 * 1000 / (3 * 0.6), 1);
    ck_assert_double_eq_tol(f.sway_nspm, 1800 * 200 * 314.1592653589793, 1e-3);
    ck_assert_double_eq_tol(f.rocking_nmsprad, 1800 * 200 * sqrt(6) * 7853.981633974483, 1e-2);
    ck_assert_double_eq_tol(f.inertia_kgm2, 500e3 * 25, 1e-6);
    set("structures.1.foundation.sway-damping", "3 MN s/m"); /* what is given counts */
    ck_assert_double_eq(thud_structure_foundation(&scene.structure[0]).sway_nspm, 3e6);
}
END_TEST

static void give_soil(void)
{
    set("structures.1.foundation.mass", "300 t");
    set("structures.1.foundation.inertia", "9000 t m2");
    set("structures.1.foundation.sway-stiffness", "2000 MN/m");
    set("structures.1.foundation.sway-damping", "30 MN s/m");
    set("structures.1.foundation.rocking-stiffness", "120 GN m/rad");
    set("structures.1.foundation.rocking-damping", "900 MN m s/rad");
    set("structures.2.foundation.mass", "400 t");
    set("structures.2.foundation.vs", "220 m/s");
    set("structures.2.foundation.density", "1.9 t/m3");
    set("structures.2.foundation.radius", "9 m");
}

/* Contact, slabs against columns, storeys that yield and P-Delta: the exact solution and Runge-Kutta's at 1e-10 agree, and
 * the energies balance. */
START_TEST(other_method_and_energy)
{
    struct thud_record *record = thud_test_motion(0.6);
    thud_test_towers(&scene);
    give_soil();
    if (_i & 1)
        set("structures.2.base", "1.2 m");
    if (_i & 2) {
        set("structures.2.yield", "25 mm");
        set("structures.2.hardening", "5 %");
        set("p-delta", "yes");
    }
    set("contact.law", "linear");
    set("contact.stiffness", "100 kN/mm");
    scene.interface[0].has_bumper = false;
    set("gap", "4 cm");
    struct thud_model *model = assembled();
    struct march exact = march_run(model, record, "exact", 0, 1e-10, true, 1),
                 other = march_run(model, record, "dormand-prince", 0, 1e-10, true, 1);
    ck_assert_int_eq(exact.status, THUD_OK);
    ck_assert_int_eq(other.status, THUD_OK);
    int impacts = 0;
    for (int c = 0; c < exact.result->ncontacts; c++)
        impacts += exact.result->contact[c].impacts;
    ck_assert_int_gt(impacts, 2);
    ck_assert_double_lt(march_peaks_apart(exact.result, other.result, 1e-3), 1e-7);
    for (int s = 0; s < 2; s++)
        for (int i = 0; i < 2; i++) {
            const struct thud_peak a = exact.result->structure[s].foundation[i].displacement,
                                   b = other.result->structure[s].foundation[i].displacement;
            ck_assert_double_gt(a.value, 1e-4);
            ck_assert_double_eq_tol(a.value / b.value, 1, 1e-7);
            ck_assert_double_eq_tol(a.time_s, b.time_s, 1e-4);
        }
    ck_assert_double_lt(exact.result->energy.error_ratio, 1e-12);
    march_free(&exact);
    march_free(&other);
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

/* A shear building by its matrix is the same on soil, and so is the row from its other side. */
START_TEST(by_its_matrix_and_mirrored)
{
    struct thud_record *record = thud_test_motion(0.6), *reversed = thud_test_motion(-0.6);
    thud_test_towers(&scene);
    give_soil();
    struct thud_model *model = assembled();
    struct march shear = march_run(model, record, "exact", 0, 1e-9, true, 1);
    struct thud_structure *s = &scene.structure[0];
    const int n = s->storeys;
    double matrix[16] = {0};
    for (int i = 0; i < n; i++) {
        matrix[i * n + i] += s->stiffness_npm[i];
        if (i > 0) {
            matrix[(i - 1) * n + i - 1] += s->stiffness_npm[i];
            matrix[(i - 1) * n + i] = matrix[i * n + i - 1] = -s->stiffness_npm[i];
        }
        s->stiffness_npm[i] = 0;
    }
    s->kind = THUD_MATRIX;
    s->period_factor = 1;
    ck_assert_int_eq(thud_structure_keep_shape(&scene, 0, n, matrix, NULL), THUD_OK);
    struct thud_structure left = scene.structure[0];
    scene.structure[0] = scene.structure[1];
    scene.structure[1] = left;
    struct thud_model *turned = assembled();
    struct march other = march_run(turned, reversed, "exact", 0, 1e-9, true, 1);
    ck_assert_int_eq(shear.status, THUD_OK);
    ck_assert_int_eq(other.status, THUD_OK);
    for (int b = 0; b < 2; b++) {
        const struct thud_structure_result *x = &shear.result->structure[b], *y = &other.result->structure[1 - b];
        ck_assert_double_eq_tol(x->base_shear.value / y->base_shear.value, 1, 1e-8);
        for (int i = 0; i < x->floors; i++) {
            ck_assert_double_eq_tol(x->floor[i].displacement.value / y->floor[i].displacement.value, 1, 1e-8);
            ck_assert_double_eq_tol(x->floor[i].drift.value / y->floor[i].drift.value, 1, 1e-8);
            ck_assert_double_eq_tol(x->floor[i].shear.value / y->floor[i].shear.value, 1, 1e-8);
        }
    }
    march_free(&shear);
    march_free(&other);
    thud_model_free(model);
    thud_model_free(turned);
    thud_record_free(record);
    thud_record_free(reversed);
}
END_TEST

/* A foundation that cannot be computed says what is missing, and where. */
START_TEST(refusals)
{
    static const struct {
        const char *key, *value, *refused;
    } bad[] = {{"mass", "", "structures.1.foundation.mass"},
               {"sway-stiffness", "", "structures.1.foundation.sway-stiffness"},
               {"rocking-stiffness", "", "structures.1.foundation.rocking-stiffness"},
               {"inertia", "", "structures.1.foundation.inertia"},
               {"vs", "200 m/s", "structures.1.foundation.density"}};
    struct thud_error err = {0};
    thud_test_towers(&scene);
    give_soil();
    char path[64];
    snprintf(path, sizeof path, "structures.1.foundation.%s", bad[_i].key);
    set(path, bad[_i].value);
    ck_assert_int_eq(thud_scene_check(&scene, &err), THUD_INPUT);
    ck_assert_str_eq(err.key, bad[_i].refused);
}
END_TEST

/* Under P-Delta a building may stand on rigid ground and fall on soft one. */
START_TEST(falls_on_soft_ground)
{
    struct thud_model *model = NULL;
    thud_test_towers(&scene);
    give_soil();
    set("p-delta", "yes");
    thud_model_free(assembled());
    set("structures.1.foundation.rocking-stiffness", "0.05 GN m/rad"); /* W h is some 0.09 */
    ck_assert_int_eq(thud_scene_assemble(&scene, &model, NULL), THUD_INPUT);
    ck_assert_ptr_null(model);
}
END_TEST

/* Without damping, what neither moves nor strains the storey is in the springs of the soil. */
START_TEST(soil_stores_the_rest)
{
    const struct thud_foundation_input soil = {
        .mass_kg = 2e4, .inertia_kgm2 = 3e5, .sway_npm = 2 * k, .rocking_nmprad = k * height * height};
    const double mass = MASS, v = 0.4;
    struct thud_structure_input s = {
        .n = 1, .mass_kg = &mass, .stiffness_npm = &k, .foundation = &soil, .rise_m = &height, .velocity_mps = v};
    struct thud_model *model = NULL;
    ck_assert_int_eq(thud_model_create(&(struct thud_model_input){.nstructures = 1, .structure = &s}, &model, NULL),
                     THUD_OK);
    struct march a = march_run(model, NULL, "exact", 0, 0, true, 0.21);
    ck_assert_int_eq(a.status, THUD_OK);
    const double sway = march_displacement(&a, 1), turn = march_displacement(&a, 2) / height,
                 drift = march_displacement(&a, 0) - sway - height * turn, v_floor = march_velocity(&a, 0),
                 v_sway = march_velocity(&a, 1), v_turn = march_velocity(&a, 2) / height;
    const double moving = 0.5 * (mass * v_floor * v_floor + soil.mass_kg * v_sway * v_sway +
                                 soil.inertia_kgm2 * v_turn * v_turn),
                 left = a.result->energy.initial_j - moving - 0.5 * k * drift * drift;
    ck_assert_double_gt(left, 0.1 * a.result->energy.initial_j);
    ck_assert_double_eq_tol(a.result->structure[0].soil_stored_j / left, 1, 1e-11);
    march_free(&a);
    thud_model_free(model);
}
END_TEST

/* A building that sways by u and turns by t as one body moves what strikes its columns at the height z over its foundation
 * by u + z t, however deep its slabs are. */
START_TEST(struck_columns_turn_with_the_building)
{
    static const char *const depth[] = {"0 cm", "30 cm", "150 cm"};
    const double u = 0.03, t = 0.002;
    thud_test_towers(&scene);
    give_soil();
    set("structures.1.slab-depth", depth[_i]);
    set("structures.2.slab-depth", depth[_i]);
    set("structures.2.base", "1.5 m");
    set("structures.1.height.2", "3.4 m");
    struct thud_model *m = assembled();
    double *q = calloc((size_t)m->nmodes, sizeof *q);
    int struck = 0;
    for (int c = 0; c < m->ncontacts; c++) {
        const struct thud_model_contact *at = &m->contact[c];
        if (at->struck == 0)
            continue;
        const int own = at->struck > 0, other = 1 - own, floor = own ? at->left_floor : at->right_floor;
        const struct thud_structure *slab = &scene.structure[other];
        const double z = thud_structure_elevation(slab, floor - 1) - 0.5 * thud_structure_depth(slab, floor - 1) -
                         scene.structure[own].base_m;
        const struct thud_model_structure *p = &m->structure[own];
        memset(q, 0, (size_t)m->nmodes * sizeof *q);
        for (int i = 0; i < p->dofs; i++) { /* q = Phi' M x */
            const double x =
                i < p->n    ? u + t * (thud_structure_elevation(&scene.structure[own], i) - scene.structure[own].base_m)
                : i == p->n ? u
                            : t * p->arm_m;
            for (int j = 0; j < p->modes; j++)
                q[p->first_mode + j] += p->phi[i * p->modes + j] * m->mass_kg[p->first + i] * x;
        }
        ck_assert_double_eq_tol(thud_model_gap_sum(m, c, q), (own ? -1 : 1) * (u + z * t), 1e-9);
        struck++;
    }
    ck_assert_int_ge(struck, 2);
    free(q);
    thud_model_free(m);
}
END_TEST

/* No mode moves a struck place by more than its bound of all places, from which it is told where a contact cannot close. */
START_TEST(struck_columns_keep_to_the_bounds_of_the_modes)
{
    for (unsigned long long seed = SCENES_SOIL; seed < SCENES_SOIL + 200; seed++) {
        struct scenes_one one;
        struct thud_model *m = NULL;
        scenes_draw(&one, seed);
        ck_assert_int_eq(thud_scene_assemble(&one.scene, &m, NULL), THUD_OK);
        for (int c = 0; c < m->ncontacts; c++)
            for (int right = 0; right < 2; right++) {
                const struct thud_model_side *side = right ? &m->contact[c].right : &m->contact[c].left;
                for (int j = 0; j < side->modes; j++)
                    ck_assert_double_le(fabs(side->row[j]), m->mode_max[side->first_mode + j]);
            }
        thud_model_free(m);
        scenes_clear(&one);
    }
}
END_TEST

/* theta = W d/(V h) with the drift on which the weight acts, out of histories in steps of half a millisecond. */
START_TEST(stability_coefficient_of_histories)
{
    struct thud_record *record = thud_test_motion(0.6);
    thud_test_towers(&scene);
    give_soil();
    set("structures.1.foundation.rocking-stiffness", "0.4 GN m/rad");
    set("structures.1.foundation.rocking-damping", "5 MN m s/rad");
    set("structures.1.gravity", "16 MN");
    set("gap", "50 cm");
    struct thud_model *m = assembled();
    const struct thud_model_structure *p = &m->structure[0];
    struct thud_run_options options;
    struct thud_run *run;
    bool done = false;
    thud_run_options_init(&options);
    options.method = thud_method_find(_i == 0 ? "exact" : "dormand-prince");
    options.keep_history = true;
    options.history_step_s = 5e-4;
    ck_assert_int_eq(thud_run_create(m, record, &options, &run, NULL), THUD_OK);
    while (!done)
        ck_assert_int_eq(thud_run_advance(run, 1000, &done, NULL), THUD_OK);
    const struct thud_result *result = thud_run_result(run);
    const struct thud_history *h = thud_run_history(run);
    double worst = 0, without = 0;
    for (int i = 0; i < p->n; i++) {
        double lean = 0, drift = 0;
        for (size_t row = 0; row < h->rows; row++) {
            const double *value = h->value + row * (size_t)h->columns, u = value[thud_history_displacement(h, i)],
                         below = value[thud_history_displacement(h, i > 0 ? i - 1 : p->n)],
                         turn = value[thud_history_displacement(h, p->n + 1)] / p->arm_m;
            lean = fmax(lean, fabs(u - below));
            drift = fmax(drift, fabs(u - below - turn * scene.structure[0].height_m[i]));
        }
        const double shear = drift * scene.structure[0].stiffness_npm[i],
                     by_hand = 16e6 * (p->n - i) * lean / (shear * scene.structure[0].height_m[i]),
                     theta = thud_stability_coefficient(&scene.structure[0], &result->structure[0], i);
        ck_assert_double_eq_tol(theta / by_hand, 1, 2e-5);
        worst = fmax(worst, theta);
        without = fmax(without, theta * drift / lean);
    }
    ck_assert(without < 0.1 && worst > 0.1);
    struct thud_error remark;
    bool found = false;
    const struct thud_remark_scope scope = {.scene = &scene, .result = result};
    for (int i = 0; nth_remark(&scope, THUD_REMARK_RESULT, i, &remark); i++)
        found = found || strstr(remark.what, "stability coefficient");
    ck_assert(found);
    thud_run_free(run);
    thud_model_free(m);
    thud_record_free(record);
}
END_TEST

/* A stiff building that rocks collapses where a storey leans by a tenth of its height, rotation and all. */
START_TEST(collapses_by_its_rotation)
{
    struct thud_record *record = thud_test_motion(50);
    thud_test_towers(&scene);
    give_soil();
    set("p-delta", "yes");
    set("structures.1.foundation.rocking-stiffness", "0.1 GN m/rad");
    set("structures.1.foundation.rocking-damping", "1 MN m s/rad");
    set("structures.2.stiffness", "9000 MN/m");
    set("gap", "90 cm");
    struct thud_model *m = assembled();
    static const char *const method[] = {"exact", "dormand-prince", "newmark"};
    double time_s = 0;
    for (int by = 0; by < 3; by++) {
        struct march a = march_run(m, record, method[by], by == 2 ? 1e-4 : 0, 1e-10, by < 2, 5);
        ck_assert_int_eq(a.status, THUD_OK);
        const struct thud_collapse *c = &a.result->collapse;
        ck_assert(c->happened && c->structure == 0);
        const double lean =
            march_displacement(&a, c->floor) - march_displacement(&a, c->floor > 0 ? c->floor - 1 : m->structure[0].n);
        ck_assert_double_eq_tol(fabs(lean), 0.1 * scene.structure[0].height_m[c->floor], by < 2 ? 1e-11 : 1e-3);
        ck_assert_double_lt(a.result->structure[0].floor[c->floor].drift.value, 0.7 * fabs(lean));
        if (by > 0)
            ck_assert_double_eq_tol(c->time_s, time_s, by == 1 ? 1e-7 : 1e-2);
        time_s = c->time_s;
        march_free(&a);
    }
    thud_model_free(m);
    thud_record_free(record);
}
END_TEST

Suite *thud_suite(void)
{
    Suite *suite = suite_create("soil");
    TCase *tcase = tcase_create("soil");
    tcase_add_loop_test(tcase, period_and_damping_of_an_oscillator, 0, 4);
    tcase_add_test(tcase, no_rate_is_above_the_bound);
    tcase_add_loop_test(tcase, default_steps_are_stable, 0, 2);
    tcase_add_test(tcase, stiff_ground_is_rigid);
    tcase_add_test(tcase, runs_come_near_rigid_ground);
    tcase_add_test(tcase, disk_on_a_half_space);
    tcase_add_loop_test(tcase, other_method_and_energy, 0, 4);
    tcase_add_test(tcase, by_its_matrix_and_mirrored);
    tcase_add_loop_test(tcase, refusals, 0, 5);
    tcase_add_test(tcase, falls_on_soft_ground);
    tcase_add_test(tcase, soil_stores_the_rest);
    tcase_add_loop_test(tcase, stability_coefficient_of_histories, 0, 2);
    tcase_add_test(tcase, collapses_by_its_rotation);
    tcase_add_loop_test(tcase, struck_columns_turn_with_the_building, 0, 3);
    tcase_add_test(tcase, struck_columns_keep_to_the_bounds_of_the_modes);
    tcase_set_timeout(tcase, 60);
    suite_add_tcase(suite, tcase);
    return suite;
}
