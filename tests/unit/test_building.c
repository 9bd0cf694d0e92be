/* Buildings by their stiffness matrix, by modes: shear buildings given so, condensed frames, and what files are refused. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/quantity.h"
#include "core/model/lateral.h"
#include "core/model/model.h"
#include "core/model/modes.h"
#include "io/building/building_file.h"
#include "io/file/file.h"
#include "io/preset/preset.h"
#include "plane_frame.h"
#include "remarks.h"
#include "study/scene/building.h"
#include "study/scene/solution.h"
#include "study/suite/gap_suite.h"
#include "suite.h"
#include "towers.h"

/* Periods, longest first, and the mass that takes part in each mode, (sum m phi)^2, kg: (n) each. */
static enum thud_status lateral_modes(int n, const double *mass_kg, const double *k, double *period_s,
                                      double *participating_kg, struct thud_error *err)
{
    const size_t square = (size_t)n * (size_t)n;
    double *phi = malloc((2 * square + 4 * (size_t)n) * sizeof *phi);
    if (!phi)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    double *omega = phi + square;
    enum thud_status status = thud_modes_matrix(n, mass_kg, k, omega, phi, omega + n, err);
    for (int j = 0; j < n && status == THUD_OK; j++) {
        double sum = 0;
        for (int i = 0; i < n; i++)
            sum += mass_kg[i] * phi[i * n + j];
        period_s[j] = 2 * THUD_PI / omega[j];
        participating_kg[j] = sum * sum;
    }
    free(phi);
    return status;
}

enum { N = 6 };

static struct thud_scene scene, other; /* large */

/* The tridiagonal matrix of a structure's storeys. */
static void matrix_of(const struct thud_structure *s, double *k)
{
    const int n = s->storeys;
    memset(k, 0, (size_t)(n * n) * sizeof *k);
    for (int i = 0; i < n; i++) {
        k[i * n + i] += s->stiffness_npm[i];
        if (i == 0)
            continue;
        k[(i - 1) * n + i - 1] += s->stiffness_npm[i];
        k[(i - 1) * n + i] = k[i * n + i - 1] = -s->stiffness_npm[i];
    }
}

/* Turns a shear building into one that is read: by its matrix, or by `modes` of its modes, scaled anyhow. */
static void give(struct thud_scene *to, int index, int modes)
{
    struct thud_structure *s = &to->structure[index];
    double k[36], row[N * (1 + N)];
    struct thud_model *model;
    const int n = s->storeys;
    ck_assert_int_eq(thud_scene_assemble(to, &model, NULL), THUD_OK);
    const struct thud_model_structure *m = &model->structure[index];
    for (int j = 0; j < modes; j++) {
        row[j * (1 + n)] = 2 * THUD_PI / m->omega[j];
        for (int i = 0; i < n; i++)
            row[j * (1 + n) + 1 + i] = (j % 2 ? -3.7 : 1e-3) * m->phi[i * n + j];
    }
    thud_model_free(model);
    matrix_of(s, k);
    s->kind = modes > 0 ? THUD_MODES : THUD_MATRIX;
    s->period_factor = 1;
    memset(s->stiffness_npm, 0, sizeof s->stiffness_npm);
    ck_assert_int_eq(thud_structure_keep_shape(to, index, modes > 0 ? modes : n, modes > 0 ? row : k, NULL), THUD_OK);
}

static void same(const char *what, double value, double expected, double scale, double tolerance)
{
    ck_assert_msg(fabs(value - expected) <= tolerance * scale, "%s: %.15g, not %.15g", what, value, expected);
}

/* Every peak of two runs of the same buildings. */
static void compare(const struct thud_scene *a, const struct thud_scene *b, double tolerance)
{
    struct thud_record *record = thud_test_motion(1);
    struct thud_solution x, y;
    ck_assert_int_eq(thud_scene_solve(a, record, NULL, &x, NULL), THUD_OK);
    ck_assert_int_eq(thud_scene_solve(b, record, NULL, &y, NULL), THUD_OK);
    const struct thud_result *p = thud_run_result(x.run), *q = thud_run_result(y.run);
    ck_assert_int_gt(q->contact[3].impacts, 0);
    for (int s = 0; s < q->nstructures; s++) {
        same("base shear", p->structure[s].base_shear.value, q->structure[s].base_shear.value,
             q->structure[s].base_shear.value, tolerance);
        for (int i = 0; i < q->structure[s].floors; i++) {
            const struct thud_floor_result *u = &p->structure[s].floor[i], *v = &q->structure[s].floor[i];
            same("acceleration", u->acceleration.value, v->acceleration.value, v->acceleration.value, tolerance);
            same("displacement", u->displacement.value, v->displacement.value, v->displacement.value, tolerance);
            same("velocity", u->velocity.value, v->velocity.value, v->velocity.value, tolerance);
            same("drift", u->drift.value, v->drift.value, v->drift.value, tolerance);
            same("storey shear", u->shear.value, v->shear.value, v->shear.value, tolerance);
            same("moment of the shear", u->shear.time_s, v->shear.time_s, 1, 1e-6);
        }
    }
    for (int c = 0; c < q->ncontacts; c++) {
        same("force", p->contact[c].force.value, q->contact[c].force.value, q->contact[3].force.value, tolerance);
        ck_assert_int_eq(p->contact[c].impacts, q->contact[c].impacts);
    }
    same("strain energy", p->energy.strain_j, q->energy.strain_j, q->energy.input_j, tolerance);
    same("damping", p->energy.viscous_j, q->energy.viscous_j, q->energy.input_j, tolerance);
    same("unaccounted energy", p->energy.error_ratio, q->energy.error_ratio, 1, fmax(tolerance, 1e-6));
    thud_solution_clear(&x);
    thud_solution_clear(&y);
    thud_record_free(record);
}

/* A shear building is the same building by its matrix and by all its modes; without the bumper no tolerance plays. */
START_TEST(a_shear_building_by_its_matrix_or_modes)
{
    thud_test_towers(&scene);
    scene.interface[0].has_bumper = false;
    for (int i = 0; i < 6; i++) {
        scene.structure[1].stiffness_npm[i] *= 1 - 0.1 * i;
        scene.structure[1].mass_kg[i] *= 1 + 0.07 * i;
    }
    other = scene;
    give(&other, 0, _i == 1 ? 4 : 0);
    give(&other, 1, _i == 2 ? 6 : 0);
    compare(&other, &scene, 1e-9);
}
END_TEST

/* Fixed steps see the same motion; so does the yield of a neighbour. */
START_TEST(a_matrix_under_other_methods)
{
    thud_test_towers(&scene);
    scene.interface[0].has_bumper = false;
    strcpy(scene.analysis.method, _i ? "newmark" : "dormand-prince");
    scene.analysis.step_s = _i ? 1e-3 : NAN;
    other = scene;
    give(&other, 0, 0);
    compare(&other, &scene, _i ? 1e-9 : 1e-4);
}
END_TEST

/* Modes that are given stay; what they leave out has a tenth of the shortest of their periods. */
START_TEST(fewer_modes_than_floors)
{
    double k[36], period_s[N], kg[N], full[36], exact_s[N];
    thud_test_towers(&scene);
    other = scene;
    give(&other, 1, 3);
    matrix_of(&scene.structure[1], full);
    ck_assert_int_eq(lateral_modes(N, scene.structure[1].mass_kg, full, exact_s, kg, NULL), THUD_OK);
    ck_assert_int_eq(thud_structure_lateral(&other, 1, k, NULL), THUD_OK);
    ck_assert_int_eq(lateral_modes(N, other.structure[1].mass_kg, k, period_s, kg, NULL), THUD_OK);
    for (int j = 0; j < N; j++)
        ck_assert_double_eq_tol(period_s[j], j < 3 ? exact_s[j] : exact_s[2] / 10, 1e-9 * exact_s[j < 3 ? j : 2]);
    struct thud_error warning;
    ck_assert(nth_unusual(&other, 0, &warning));
    ck_assert_str_eq(warning.key, "structures.2.periods");
    ck_assert_ptr_nonnull(strstr(warning.what, "3 of 6 modes"));
    other.structure[1].period_factor = 1.4;
    ck_assert_int_eq(thud_structure_lateral(&other, 1, k, NULL), THUD_OK);
    ck_assert_int_eq(lateral_modes(N, other.structure[1].mass_kg, k, period_s, kg, NULL), THUD_OK);
    ck_assert_double_eq_tol(period_s[0], 1.4 * exact_s[0], 1e-9);
}
END_TEST

/* Shapes that are not quite orthogonal keep their periods; such as overlap by more are refused. */
START_TEST(shapes_that_overlap)
{
    double row[3 * 4] = {0.9, 0.3, 0.7, 1, 0.3, 1, 0.6, -0.7, 0.15, 0.8, -1, 0.45}, k[9], period_s[3], kg[3];
    double mass[3] = {1e5, 1e5, 1e5};
    int a, b;
    const double overlap = thud_lateral_overlap(3, 3, mass, row, &a, &b);
    ck_assert(overlap > 0.01 && overlap < 0.1);
    ck_assert_int_eq(thud_lateral_from_modes(3, 3, mass, row, k, NULL), THUD_OK);
    ck_assert_int_eq(lateral_modes(3, mass, k, period_s, kg, NULL), THUD_OK);
    for (int j = 0; j < 3; j++)
        ck_assert_double_eq_tol(period_s[j], row[4 * j], 1e-10);
    thud_test_towers(&scene);
    give(&scene, 0, 4);
    ck_assert_int_eq(thud_structure_check_shape(&scene, 0, NULL), THUD_OK);
    scene.structure[0].mass_kg[3] *= 1.5; /* not the masses of these shapes */
    struct thud_error err = {0};
    ck_assert_int_eq(thud_scene_check(&scene, &err), THUD_INPUT);
    ck_assert_str_eq(err.key, "structures.1.periods");
    ck_assert_ptr_nonnull(strstr(err.what, "overlap"));
    memcpy(row + 4, row, 4 * sizeof *row);
    ck_assert_int_eq(thud_lateral_from_modes(3, 3, mass, row, k, NULL), THUD_INPUT);
}
END_TEST

/* One storey, one bay: k = 24 EI_c/h^3 (1 + 6 g)/(4 + 6 g), g = (EI_b/L)/(EI_c/h) (Chopra, eq. 1.3.5). A wall of n
 * storeys: the flexibility of a cantilever, a^2 (3 b - a)/(6 EI) of a load at b felt at a <= b. */
START_TEST(frames_with_their_rotations_condensed)
{
    for (double beam = 1e3; beam < 1e13; beam *= 10) {
        const struct plane_frame portal = {1, 2, 3.2, 6.5, 40e6, beam};
        double k, g = beam / 6.5 / (40e6 / 3.2);
        plane_frame_stiffness(&portal, &k);
        ck_assert_double_eq_tol(k / (24 * 40e6 / (3.2 * 3.2 * 3.2) * (1 + 6 * g) / (4 + 6 * g)), 1, 1e-9);
    }
    double k[36];
    const struct plane_frame *wall = &plane_wall_shipped;
    plane_frame_stiffness(wall, k);
    ck_assert_int_eq(thud_lateral_invert(N, k, NULL), THUD_OK);
    for (int i = 0; i < N; i++)
        for (int j = i; j < N; j++) {
            double a = (i + 1) * wall->height_m, b = (j + 1) * wall->height_m;
            ck_assert_double_eq_tol(k[i * N + j] / (a * a * (3 * b - a) / (6 * wall->column_nm2)), 1, 1e-8);
        }
}
END_TEST

/* The shipped files are those of the condensed frames, to the digits that they have. */
START_TEST(the_shipped_files)
{
    static const char frame[] = "presets/frame-beside-wall.frame.csv", wall[] = "presets/frame-beside-wall.wall.csv";
    const double mass[N] = {300e3, 300e3, 300e3, 300e3, 300e3, 240e3};
    double k[36], period_s[N], kg[N], read[36];
    struct thud_building_table table;
    struct thud_building_ask ask = {.content = THUD_CONTENT_STIFFNESS, .floors = N};
    ck_assert_int_eq(thud_building_file_read(frame, &ask, &table, NULL), THUD_OK);
    plane_frame_stiffness(&plane_frame_shipped, k);
    for (int i = 0; i < 36; i++)
        ck_assert_double_eq_tol(table.value[i], k[i], 1e-8 * k[0]);
    thud_building_table_clear(&table);
    ask.content = THUD_CONTENT_PERIODS;
    ck_assert_int_eq(thud_building_file_read(wall, &ask, &table, NULL), THUD_OK);
    plane_frame_stiffness(&plane_wall_shipped, k);
    ck_assert_int_eq(thud_lateral_from_modes(N, N, mass, table.value, read, NULL), THUD_OK);
    for (int i = 0; i < 36; i++)
        ck_assert_double_eq_tol(read[i], k[i], 1e-6 * k[0]);
    ck_assert_int_eq(lateral_modes(N, mass, k, period_s, kg, NULL), THUD_OK);
    for (int j = 0; j < N; j++)
        ck_assert_double_eq_tol(table.value[j * (1 + N)], period_s[j], 1e-8 * period_s[j]);
    thud_building_table_clear(&table);
}
END_TEST

/* The shear of a storey is the sum of K u over the floors from it up: no sample of the history passes the peak, which one
 * of them comes near; and it is no product of one storey's drift. */
START_TEST(storey_shears_of_a_frame_and_a_wall)
{
    struct thud_record *record = thud_test_motion(0.5);
    struct thud_solution solution;
    struct thud_run_options options;
    double k[2][36], shear[2][N] = {{0}};
    thud_test_towers(&scene);
    scene.interface[0].has_bumper = false;
    scene.interface[0].gap_m = 0.01;
    thud_run_options_init(&options);
    options.keep_history = true;
    options.history_step_s = 1e-3;
    plane_frame_stiffness(&plane_frame_shipped, k[0]);
    plane_frame_stiffness(&plane_wall_shipped, k[1]);
    for (int s = 0; s < 2; s++) {
        thud_structure_init(&scene.structure[s], THUD_MATRIX);
        snprintf(scene.structure[s].name, 2, "%c", 'A' + s);
        ck_assert_int_eq(thud_scene_set(&scene, s ? "structures.2.storeys" : "structures.1.storeys", "6", NULL),
                         THUD_OK);
        ck_assert_int_eq(thud_scene_set(&scene, s ? "structures.2.mass" : "structures.1.mass", "250 t", NULL), THUD_OK);
        ck_assert_int_eq(thud_structure_keep_shape(&scene, s, N, k[s], NULL), THUD_OK);
    }
    ck_assert_int_eq(thud_scene_solve(&scene, record, &options, &solution, NULL), THUD_OK);
    const struct thud_result *r = thud_run_result(solution.run);
    const struct thud_history *h = thud_run_history(solution.run);
    ck_assert_int_gt(r->contact[5].impacts, 0);
    for (size_t t = 0; t < h->rows; t++)
        for (int s = 0; s < 2; s++) {
            double v = 0;
            for (int i = N - 1; i >= 0; i--) {
                for (int j = 0; j < N; j++)
                    v += k[s][i * N + j] *
                         h->value[t * (size_t)h->columns + (size_t)thud_history_displacement(h, s * N + j)];
                shear[s][i] = fmax(shear[s][i], fabs(v));
            }
        }
    for (int s = 0; s < 2; s++)
        for (int i = 0; i < N; i++) {
            double peak = r->structure[s].floor[i].shear.value;
            ck_assert_msg(shear[s][i] <= peak * (1 + 1e-9) && shear[s][i] > 0.98 * peak, "%d.%d: %g, sampled %g", s, i,
                          peak, shear[s][i]);
        }
    ck_assert(!thud_structure_bends(&scene.structure[0], &solution.model->structure[0]));
    ck_assert(thud_structure_bends(&scene.structure[1], &solution.model->structure[1]));
    ck_assert(fabs(r->energy.error_ratio) < 1e-6);
    thud_solution_clear(&solution);
    thud_record_free(record);
}
END_TEST

/* With P-Delta a shear building by its matrix stays the same building; one that its weight pushes over is refused. */
START_TEST(a_matrix_under_its_weight)
{
    struct thud_error err = {0};
    thud_test_towers(&scene);
    scene.interface[0].has_bumper = false;
    scene.p_delta = true;
    for (int i = 0; i < 6; i++)
        scene.structure[1].gravity_n[i] = 50e6;
    other = scene;
    give(&other, 1, 0);
    compare(&other, &scene, 1e-9);
    for (int i = 0; i < 6; i++)
        other.structure[1].gravity_n[i] = 500e6;
    ck_assert_int_eq(thud_scene_check(&other, &err), THUD_INPUT);
    ck_assert_ptr_nonnull(strstr(err.what, "buckles under its own weight"));
}
END_TEST

/* Tied to its neighbour by a link, such a building has the modes of the shear building that it is, and its storey shears
 * are still those of its own stiffness. */
START_TEST(a_matrix_that_is_tied)
{
    double mass[4] = {3e5, 3e5, 3e5, 2e5}, storeys[4] = {6e8, 5e8, 4e8, 3e8}, k[16], q[8], u[4];
    struct thud_structure shear;
    memset(&shear, 0, sizeof shear);
    shear.storeys = 4;
    memcpy(shear.stiffness_npm, storeys, sizeof storeys);
    matrix_of(&shear, k);
    struct thud_structure_input structure[2] = {{.n = 4, .mass_kg = mass, .stiffness_npm = storeys, .damping = 0.05},
                                                {.n = 4, .mass_kg = mass, .matrix_npm = k, .damping = 0.05}};
    const struct thud_link_input link = {.left_floor = 2,
                                         .right_floor = 4,
                                         .left_structure = 0,
                                         .right_structure = 1,
                                         .stiffness_npm = 1e8,
                                         .damping_nspm = 1e6};
    struct thud_model_input input = {.nstructures = 2, .structure = structure, .nlinks = 1, .link = &link};
    struct thud_model *by_matrix, *by_storeys;
    ck_assert_int_eq(thud_model_create(&input, &by_matrix, NULL), THUD_OK);
    structure[1].matrix_npm = NULL;
    structure[1].stiffness_npm = storeys;
    ck_assert_int_eq(thud_model_create(&input, &by_storeys, NULL), THUD_OK);
    for (int j = 0; j < 8; j++) {
        ck_assert_double_eq_tol(by_matrix->omega[j], by_storeys->omega[j], 1e-9 * by_storeys->omega[j]);
        q[j] = j % 3 - 1.3;
    }
    const struct thud_model_structure *m = &by_matrix->structure[1];
    ck_assert_int_eq(m->modes, 8);
    for (int i = 0; i < 4; i++)
        u[i] = thud_model_floor(by_matrix, 4 + i, q);
    for (int i = 0; i < 4; i++) {
        double v = 0, expected = storeys[i] * (u[i] - (i > 0 ? u[i - 1] : 0));
        for (int j = 0; j < m->modes; j++)
            v += m->shear[i * m->modes + j] * q[j];
        ck_assert_double_eq_tol(v, expected, 1e-9 * storeys[0] * fabs(u[3]));
    }
    thud_model_free(by_matrix);
    thud_model_free(by_storeys);
}
END_TEST

/* ---- files ---- */

static char path[64];

static void write_file(const char *text)
{
    FILE *file = fopen(path, "w");
    ck_assert_ptr_nonnull(file);
    ck_assert_int_ge(fputs(text, file), 0);
    ck_assert_int_eq(fclose(file), 0);
}

static void make_file(void)
{
    strcpy(path, "/tmp/thud-building-XXXXXX");
    int file = mkstemp(path);
    ck_assert_int_ge(file, 0);
    close(file);
}

static void remove_file(void)
{
    unlink(path);
}

static const struct {
    const char *text;
    enum thud_building_content content;
    int floors;
    const char *unit;
    enum thud_floor_order order;
    int line, column;
    const char *what, *allowed;
} refused[] = {
    {"a (kN/m),b\n4,-2\n-2,2\n-1,0\n", 0, 0, "", 0, 4, 0, "3 rows of 2 values", "as many rows"},
    {"a (kN/m),b\n4,-2\n-2,2,1\n", 0, 0, "", 0, 3, 0, "3 values in this row, 2", "same number"},
    {"a (kN/m),b\n4,-2\n-2.1,3\n", 0, 0, "", 0, 3, 1, "not symmetric: -2.1 in row 2, column 1, and -2 in row 1",
     "1e-06"},
    {"a (kN/m),b\n1,-2\n-2,3\n", 0, 0, "", 0, 2, 1, "least eigenvalue is -236.1 N/m", "stands on its ground"},
    {"a (kN/m),b\n4,-2\n-2,-3\n", 0, 0, "", 0, 3, 4, "not positive definite", "ground"},
    {"a (kN),b\n4,-2\n-2,2\n", 0, 0, "", 0, 1, 0, "kN is not a unit of a stiffness", "kN/m"},
    {"a,b\n4,-2\n-2,2\n", 0, 0, "", 0, 1, 0, "unit of the matrix is not specified", "unit: kN/m"},
    {"a,b\n4,-2\n-2,2\n", 0, 0, "s", 0, 0, 0, "s is not a unit", "kN/m"},
    {"a (kN/m),b\n4,-2\n-2,2\n", 0, 0, "MN/m", 0, 1, 0, "the header states kN/m, but `unit` MN/m", "one of the two"},
    {"a (kN/m),b (MN/m)\n4,-2\n-2,2\n", 0, 0, "", 0, 1, 1, "the unit twice", "one unit"},
    {"a (mm/kN),b\n1,1\n1,2\n", 0, 0, "", 0, 1, 0, "mm/kN is the unit of a flexibility", "flexibility-matrix"},
    {"a (kN/m),b\n4,-2\n-2,2\n", 1, 0, "", 0, 1, 0, "kN/m is the unit of a stiffness", "stiffness-matrix"},
    {"a (kN/m),b\n4,-2\n-2,2\n", 0, 3, "", 0, 2, 0, "2 rows and columns, and the building has 3 floors", "every floor"},
    {"a (kN/m),b\n2,-2\n-2,4\n", 0, 0, "", 0, 2, 0, "from the roof down", "roof-first"},
    {"a (kN/m),b\n4,x\n-2,4\n", 0, 0, "", 0, 2, 3, "\"x\" is not a number", "after the labels"},
    {"a (kN/m),b\n4,\xd0\xb2\n-2,4\n", 0, 0, "", 0, 2, 3, "\"\xd0\xb2\" is not a number", "after the labels"},
    {"a (kN/m),b\n", 0, 0, "", 0, 0, 0, "no row of numbers", ""},
    {"Mode,Period (s),a,b\n1,0.5,1\n", 2, 0, "", 0, 2, 0, "3 values in this row, 4 names", "under every name"},
    {"Mode,Period (s),a,b\n1,0.5,0.5,1\n", 2, 3, "", 0, 2, 0, "2 shape values in a row, and the building has 3",
     "every floor"},
    {"Mode,Period (s),a,b\n1,0.5,0.5,1\n2,0,1,-1\n", 2, 0, "", 0, 3, 3, "period of mode 2 is 0", "above 0"},
    {"Mode,Period (s),a,b\n1,-1,0.5,1\n", 2, 0, "", 0, 2, 3, "period of mode 1 is -1", "above 0"},
    {"Mode,Period (s),a,b\n1,0.5,0.5+0.1i,1\n", 2, 0, "", 0, 2, 7, "\"0.5+0.1i\" is complex", "undamped"},
    {"Mode,Period (s),a,b\n1,0.5,0,0\n", 2, 0, "", 0, 2, 7, "shape of mode 1 is 0", "this direction"},
    {"Mode,Period (s),a\n1,0.5,1\n2,0.2,1\n", 2, 0, "", 0, 3, 0, "2 modes of 1 floors", "as many modes"},
    {"Mode,T1,a,b\n1,0.5,0.5,1\n", 2, 0, "s", 0, 1, 0, "no column of the header is the period", "Period (s)"},
    {"Mode,Period,a,b\n1,0.5,0.5,1\n", 2, 0, "", 0, 1, 0, "unit of the periods is not specified", "unit: s"},
    {"Mode,Period (s),a,b\n1,0.5,1,0.5\n", 2, 0, "", 0, 2, 0, "from the roof down", "lowest-first"},
    {"Mode,Period (s)\n1,0.5\n", 2, 0, "", 0, 2, 0, "no column of a floor", "from the lowest up"},
};

START_TEST(files_that_are_refused)
{
    struct thud_building_ask ask = {.content = refused[_i].content,
                                    .floors = refused[_i].floors,
                                    .unit = refused[_i].unit,
                                    .order = refused[_i].order};
    struct thud_building_table table;
    struct thud_error err = {0};
    char message[1200];
    make_file();
    write_file(refused[_i].text);
    enum thud_status status = thud_building_file_read(path, &ask, &table, &err);
    remove_file();
    thud_error_text(&err, message, sizeof message);
    ck_assert_int_eq(status, THUD_INPUT);
    ck_assert_msg(strstr(err.what, refused[_i].what) != NULL, "%s lacks \"%s\"", message, refused[_i].what);
    ck_assert_msg(strstr(err.allowed, refused[_i].allowed) != NULL, "%s lacks \"%s\"", message, refused[_i].allowed);
    ck_assert_str_eq(err.file, path);
    ck_assert_msg(err.line == refused[_i].line && err.column == refused[_i].column, "%s: not at %d:%d", message,
                  refused[_i].line, refused[_i].column);
    ck_assert_ptr_null(table.value);
}
END_TEST

/* The same matrix and modes, as programs write them. */
static const struct {
    const char *text, *unit;
    enum thud_floor_order order;
} spelled[] = {
    {"Story,Story1,Story2\n,kN/m,kN/m\nStory1,5e3,-2000\nStory2,-2000,2000\n", "", 0},
    {"TABLE: Stiffness\n\"Story\";\"Story1 (N/mm)\";\"Story2\"\nS1;5000;-2000\nS2;-2000;2000\n", "", 0},
    {"5,-2\n-2,2\n", "MN/m", 0},
    {"\xef\xbb\xbf# lateral stiffness\nkN/mm\t\n5\t-2\t\n-2\t2\t\n", "", 0},
    {"floor,2,1\n2,2,-2\n1,-2,5\n", "MN/m", THUD_ORDER_ROOF_FIRST},
    {"floor,1,2\n1,5,-2\n2,-2,5\n", "MN/m", THUD_ORDER_LOWEST_FIRST},
};

START_TEST(files_as_programs_write_them)
{
    struct thud_building_ask ask = {.any = true, .unit = spelled[_i].unit, .order = spelled[_i].order};
    struct thud_building_table table;
    struct thud_error err = {0};
    char message[1200];
    make_file();
    write_file(spelled[_i].text);
    enum thud_status status = thud_building_file_read(path, &ask, &table, &err);
    remove_file();
    ck_assert_msg(status == THUD_OK, "%s", thud_error_text(&err, message, sizeof message));
    ck_assert_int_eq(table.floors, 2);
    ck_assert_int_eq(table.content, THUD_CONTENT_STIFFNESS);
    const double k[] = {5e6, -2e6, -2e6, _i == 5 ? 5e6 : 2e6};
    for (int i = 0; i < 4; i++)
        ck_assert_double_eq_tol(table.value[i], k[i], 1e-6);
    thud_building_table_clear(&table);
}
END_TEST

/* A flexibility is the inverse, in its own unit, and stands from the roof down where that is said. */
START_TEST(a_flexibility_and_its_order)
{
    struct thud_building_ask ask = {.content = THUD_CONTENT_FLEXIBILITY, .order = THUD_ORDER_ROOF_FIRST};
    struct thud_building_table table;
    make_file();
    write_file("roof (mm/kN),first\n0.8333333333333333,0.3333333333333333\n0.3333333333333333,0.3333333333333333\n");
    enum thud_status status = thud_building_file_read(path, &ask, &table, NULL);
    remove_file();
    ck_assert_int_eq(status, THUD_OK);
    const double k[] = {5e6, -2e6, -2e6, 2e6};
    for (int i = 0; i < 4; i++)
        ck_assert_double_eq_tol(table.value[i], k[i], 1e-6);
    thud_building_table_clear(&table);
}
END_TEST

/* Parts of the scene's shape follow their structures through every change. */
START_TEST(what_was_read_stays_with_its_building)
{
    double k[2][36], got[36];
    struct thud_error err = {0};
    thud_test_towers(&scene);
    matrix_of(&scene.structure[0], k[0]);
    matrix_of(&scene.structure[1], k[1]);
    give(&scene, 0, 0);
    give(&scene, 1, 0);
    give(&scene, 0, 0); /* again, from the matrix: its storeys have no stiffness any more */
    ck_assert_int_eq(thud_structure_keep_shape(&scene, 0, 4, k[0], NULL), THUD_OK);
    struct thud_structure left = scene.structure[0];
    scene.structure[0] = scene.structure[1];
    scene.structure[1] = left;
    for (int s = 0; s < 2; s++) {
        ck_assert_int_eq(thud_structure_lateral(&scene, s, got, NULL), THUD_OK);
        ck_assert_mem_eq(got, k[1 - s], (size_t)(s ? 16 : 36) * sizeof *got);
    }
    ck_assert_int_eq(thud_scene_set(&scene, "structures.1.storeys", "5", NULL), THUD_OK);
    ck_assert_int_eq(thud_scene_check(&scene, &err), THUD_INPUT);
    ck_assert_str_eq(err.key, "structures.1.stiffness-matrix");
    ck_assert_int_eq(thud_scene_set(&scene, "structures.2.yield", "2 cm", &err), THUD_INPUT);
    ck_assert_ptr_nonnull(strstr(err.what, "a building by its matrix has no storeys that could yield"));
}
END_TEST

/* A preset saved in another folder still has its files, and its comments. */
START_TEST(files_go_with_a_preset_that_is_saved_elsewhere)
{
    static const char text[] =
        "structures:\n  - kind: matrix # from the frame program\n    storeys: 2\n    mass: 200 t\n"
        "    stiffness-matrix: k.csv # kN/m\n  - {kind: shear, storeys: 1, mass: 300 t, stiffness: 600 MN/m}\n"
        "interfaces:\n  - gap: 5 cm # the line\n    contact: {law: linear, stiffness: 2 kN/m}\n";
    char folder[] = "/tmp/thud-XXXXXX", own[80], file[80], elsewhere[80], expected[200], *saved;
    size_t size;
    struct thud_preset *preset;
    struct thud_error err = {0};
    ck_assert_ptr_nonnull(mkdtemp(folder));
    snprintf(own, sizeof own, "%s/a.yaml", folder);
    snprintf(file, sizeof file, "%s/k.csv", folder);
    snprintf(elsewhere, sizeof elsewhere, "%s/sub", folder);
    ck_assert_int_eq(mkdir(elsewhere, 0700), 0);
    snprintf(elsewhere, sizeof elsewhere, "%s/sub/b.yaml", folder);
    ck_assert_int_eq(thud_file_write(own, text, strlen(text), NULL), THUD_OK);
    static const char matrix[] = "Story (kN/m),1,2\n1,500000,-200000\n2,-200000,200000\n";
    ck_assert_int_eq(thud_file_write(file, matrix, strlen(matrix), NULL), THUD_OK);
    ck_assert_msg(thud_preset_read(own, &preset, &err) == THUD_OK, "%s", err.what);
    scene = *thud_preset_scene(preset);
    ck_assert_int_eq(thud_preset_save(preset, &scene, own, NULL), THUD_OK);
    ck_assert_int_eq(thud_file_read(own, 1 << 20, &saved, &size, NULL), THUD_OK);
    ck_assert(size == strlen(text) && memcmp(saved, text, size) == 0); /* where it was */
    free(saved);
    ck_assert_int_eq(thud_preset_save(preset, &scene, elsewhere, NULL), THUD_OK);
    thud_preset_free(preset);
    ck_assert_msg(thud_preset_read(elsewhere, &preset, &err) == THUD_OK, "%s", err.what);
    thud_preset_free(preset);
    ck_assert_int_eq(thud_file_read(elsewhere, 1 << 20, &saved, &size, NULL), THUD_OK);
    snprintf(expected, sizeof expected, "    stiffness-matrix: %s # kN/m\n", file);
    ck_assert_ptr_nonnull(strstr(saved, expected));
    ck_assert_ptr_nonnull(strstr(saved, "kind: matrix # from the frame program\n"));
    ck_assert_ptr_nonnull(strstr(saved, "- gap: 5 cm # the line\n"));
    free(saved);
    remove(own);
    remove(file);
    remove(elsewhere);
    snprintf(elsewhere, sizeof elsewhere, "%s/sub", folder);
    rmdir(elsewhere);
    rmdir(folder);
}
END_TEST

/* The codes' tables by hand, powers by logarithms. */
START_TEST(an_estimated_building)
{
    static const char *const words[] = {"concrete-frame", "steel-frame", "wall", "masonry"};
    static const double en1998[] = {0.075, 0.085, 0.050, 0.050}, asce7[] = {0.0466, 0.0724, 0.0488, 0.0488},
                        power[] = {0.9, 0.8, 0.75, 0.75};
    struct thud_structure *s = &scene.structure[1];
    thud_test_towers(&scene);
    ck_assert_int_eq(thud_scene_set(&scene, "structures.2.kind", "estimated", NULL), THUD_OK);
    same("the mass that it had", s->mass_kg[0],
         thud_scene_get(&scene, "structures.2.area", (char[64]){0}, 64, NULL) == THUD_OK ? 1000 * s->area_m2 : 0, 1, 0);
    ck_assert_int_eq(thud_scene_set(&scene, "structures.2.area", "250 m2", NULL), THUD_OK);
    ck_assert_int_eq(thud_scene_set(&scene, "structures.2.height", "[4 m, 3.2 m, 3 m, 3 m, 3 m, 3 m]", NULL), THUD_OK);
    ck_assert_int_eq(thud_scene_set(&scene, "structures.2.system", words[_i], NULL), THUD_OK);
    ck_assert_int_eq(thud_scene_set(&scene, "structures.2.period-factor", _i % 2 ? "1.3" : "1", NULL), THUD_OK);
    const double height = 19.2, expected = en1998[_i] * exp(0.75 * log(height)), factor = _i % 2 ? 1.3 : 1;
    const struct thud_estimate e = thud_structure_estimate(s);
    same("EN 1998-1", e.en1998_s, expected, expected, 1e-12);
    same("ASCE 7", e.asce7_s, asce7[_i] * exp(power[_i] * log(height)), expected, 1e-12);
    struct thud_model *model;
    struct thud_error err = {0};
    ck_assert_int_eq(thud_scene_check(&scene, &err), THUD_OK);
    ck_assert_int_eq(thud_scene_assemble(&scene, &model, NULL), THUD_OK);
    same("T1", 2 * THUD_PI / model->structure[1].omega[0], factor * expected, expected, 1e-12);
    for (int i = 0; i < 6; i++) {
        ck_assert_double_eq(s->mass_kg[i], 250e3);
        ck_assert_double_eq(s->stiffness_npm[i], s->stiffness_npm[0]);
    }
    thud_model_free(model);
    ck_assert_int_eq(thud_scene_set(&scene, "structures.2.yield", "2 cm", &err), THUD_INPUT);
    ck_assert_int_eq(thud_scene_set(&scene, "structures.2.area", "", NULL), THUD_INPUT);
}
END_TEST

/* Runs at each period by hand: what is enough for all of them is the range that is told. */
START_TEST(the_gap_over_the_periods_of_estimated_buildings)
{
    struct thud_record *record = thud_test_motion(1);
    thud_test_towers(&scene);
    thud_scene_set(&scene, "structures.2.kind", "estimated", NULL);
    if (_i == 1)
        thud_scene_set(&scene, "structures.1.kind", "estimated", NULL);
    const int periods = thud_gap_periods(&scene);
    ck_assert_int_eq(periods, _i == 1 ? 81 : 15);
    double need_m[81] = {0}, least = INFINITY, most = 0;
    for (int p = 0; p < periods; p++)
        ck_assert_int_eq(thud_gap_at_periods(&scene, record, p, need_m + p, NULL), THUD_OK);
    for (int p = 0; p < periods; p++) {
        const int n = _i == 1 ? 9 : 15;
        struct thud_needed_gap *gap;
        char text[64];
        other = scene;
        for (int s = 1 - _i; s < 2; s++) {
            const int step = _i == 1 && s == 1 ? p / n : p % n;
            snprintf(text, sizeof text, "%.17g", 0.7 * pow(2, step / (n - 1.0)));
            thud_scene_set(&other, s ? "structures.2.period-factor" : "structures.1.period-factor", text, NULL);
        }
        ck_assert_int_eq(thud_needed_gap_run(&other, record, &gap, NULL), THUD_OK);
        least = fmin(least, thud_needed_gap_widest(gap, 1, THUD_GAP_EXACT, NULL));
        most = fmax(most, thud_needed_gap_widest(gap, 1, THUD_GAP_EXACT, NULL));
        free(gap);
    }
    struct thud_gap_range range;
    ck_assert_int_eq(thud_gap_period_range(&scene, (const double[81]){-1}, &range), 0); /* nothing can touch */
    ck_assert_int_eq(thud_gap_period_range(&scene, need_m, &range), 1);
    same("least", range.least_m, least, least, 1e-9);
    same("most", range.most_m, most, most, 1e-9);
    ck_assert(range.most_m > 1.1 * range.least_m);
    ck_assert(isnan(range.left_factor) == (_i == 0) && range.right_factor >= 0.7 - 1e-12 &&
              range.right_factor <= 1.4 + 1e-12);
    thud_record_free(record);
}
END_TEST

Suite *thud_suite(void)
{
    Suite *suite = suite_create("building");
    TCase *tcase = tcase_create("building");
    tcase_add_loop_test(tcase, a_shear_building_by_its_matrix_or_modes, 0, 3);
    tcase_add_loop_test(tcase, a_matrix_under_other_methods, 0, 2);
    tcase_add_test(tcase, fewer_modes_than_floors);
    tcase_add_test(tcase, shapes_that_overlap);
    tcase_add_test(tcase, frames_with_their_rotations_condensed);
    tcase_add_test(tcase, the_shipped_files);
    tcase_add_test(tcase, storey_shears_of_a_frame_and_a_wall);
    tcase_add_test(tcase, a_matrix_under_its_weight);
    tcase_add_test(tcase, a_matrix_that_is_tied);
    tcase_add_loop_test(tcase, files_that_are_refused, 0, (int)(sizeof refused / sizeof *refused));
    tcase_add_loop_test(tcase, files_as_programs_write_them, 0, (int)(sizeof spelled / sizeof *spelled));
    tcase_add_test(tcase, a_flexibility_and_its_order);
    tcase_add_test(tcase, files_go_with_a_preset_that_is_saved_elsewhere);
    tcase_add_loop_test(tcase, an_estimated_building, 0, 4);
    tcase_add_loop_test(tcase, the_gap_over_the_periods_of_estimated_buildings, 0, 2);
    tcase_add_test(tcase, what_was_read_stays_with_its_building);
    suite_add_tcase(suite, tcase);
    return suite;
}
