/* Sobol indices against closed forms, Latin hypercubes by their strata, inputs by name, and samples of a scene. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/sweep/uncertainty_study.h"
#include "base/quantity.h"
#include "study/scene/needed_gap.h"
#include "study/scene/solution.h"
#include "study/uncertainty/sobol.h"
#include "study/uncertainty/uncertainty.h"
#include "study_setup.h"

static void set_up(void)
{
    study_set_up(1);
}

enum { D = 3 };
static const double pi = THUD_PI;

static double ishigami(const double *u)
{
    double x[D];
    for (int i = 0; i < D; i++)
        x[i] = pi * (2 * u[i] - 1);
    return sin(x[0]) + 7 * pow(sin(x[1]), 2) + 0.1 * pow(x[2], 4) * sin(x[0]);
}

static double additive(const double *u)
{
    return 1 * u[0] + 2 * u[1] + 3 * u[2];
}

/* `bounds`: low and high of the first-order indices and then the total ones, (2 x 2 x D); NULL: not wanted. */
static void indices_of(double (*f)(const double *), size_t n, unsigned seed, double first[D], double total[D],
                       double *bounds)
{
    struct thud_random random = {seed};
    double *u = malloc(2 * n * D * sizeof *u), *a = malloc((2 + D) * n * sizeof *a), *b = a + n, *ab = b + n;
    ck_assert_int_eq(thud_latin_hypercube(&random, n, D, u, &error), THUD_OK);
    ck_assert_int_eq(thud_latin_hypercube(&random, n, D, u + n * D, &error), THUD_OK);
    for (size_t r = 0; r < n; r++) {
        a[r] = f(u + r * D);
        b[r] = f(u + (n + r) * D);
        for (int i = 0; i < D; i++) {
            double mixed[D];
            memcpy(mixed, u + r * D, sizeof mixed);
            mixed[i] = u[(n + r) * D + (size_t)i];
            ab[(size_t)i * n + r] = f(mixed);
        }
    }
    ck_assert_int_eq(thud_sobol_indices(a, b, ab, n, D, first, total, &error), THUD_OK);
    if (bounds)
        ck_assert_int_eq(thud_sobol_intervals(a, b, ab, n, D, &random, bounds, bounds + 2 * D, &error), THUD_OK);
    free(u);
    free(a);
}

static void indices(double (*f)(const double *), size_t n, double first[D], double total[D])
{
    indices_of(f, n, 7, first, total, NULL);
}

/* a = 7, b = 0.1: V1 = (1 + b pi^4/5)^2/2, V2 = a^2/8, V13 = b^2 pi^8 8/225. */
START_TEST(the_ishigami_function)
{
    double first[D], total[D], p4 = pow(pi, 4), v1 = 0.5 * pow(1 + 0.1 * p4 / 5, 2), v2 = 49 / 8.0;
    double v13 = 0.01 * p4 * p4 * 8 / 225, v = v1 + v2 + v13;
    indices(ishigami, 1 << 15, first, total);
    ck_assert_double_eq_tol(first[0], v1 / v, 0.02);
    ck_assert_double_eq_tol(first[1], v2 / v, 0.02);
    ck_assert_double_eq_tol(first[2], 0, 0.02);
    ck_assert_double_eq_tol(total[0], (v1 + v13) / v, 0.02);
    ck_assert_double_eq_tol(total[1], v2 / v, 0.02);
    ck_assert_double_eq_tol(total[2], v13 / v, 0.02);
}
END_TEST

/* Over several seeds the 95 % intervals cover the six indices nearly as often as they say, and shrink as 1/sqrt(n). */
START_TEST(intervals_cover_what_is_known)
{
    enum { SEEDS = 12, ROWS = 256 };
    double p4 = pow(pi, 4), v1 = 0.5 * pow(1 + 0.1 * p4 / 5, 2), v2 = 49 / 8.0, v13 = 0.01 * p4 * p4 * 8 / 225;
    double v = v1 + v2 + v13, known[2 * D] = {v1 / v, v2 / v, 0, (v1 + v13) / v, v2 / v, v13 / v};
    double first[D], total[D], bounds[4 * D], wide[4 * D];
    int covered = 0;
    for (unsigned seed = 1; seed <= SEEDS; seed++) {
        indices_of(ishigami, ROWS, seed, first, total, bounds);
        for (int i = 0; i < 2 * D; i++) {
            covered += bounds[i] <= known[i] && known[i] <= bounds[2 * D + i];
            double own = i < D ? first[i] : total[i - D];
            ck_assert(bounds[i] <= own && own <= bounds[2 * D + i]);
        }
    }
    ck_assert_msg(covered >= 0.9 * 2 * D * SEEDS, "%d of %d", covered, 2 * D * SEEDS);
    indices_of(ishigami, ROWS / 16, 1, first, total, wide);
    double ratio = 0;
    for (int i = 0; i < 2 * D; i++)
        ratio += (wide[2 * D + i] - wide[i]) / (bounds[2 * D + i] - bounds[i]) / (2 * D);
    ck_assert_msg(ratio > 2 && ratio < 8, "%g", ratio); /* 4 */
}
END_TEST

/* Of a sum every index is its share, total and first the same, and they add up to 1. */
START_TEST(additivity)
{
    double first[D], total[D], sum = 0;
    indices(additive, 1 << 14, first, total);
    for (int i = 0; i < D; i++) {
        ck_assert_double_eq_tol(first[i], (i + 1.0) * (i + 1.0) / 14, 0.01);
        ck_assert_double_eq_tol(total[i], first[i], 0.01);
        sum += first[i];
    }
    ck_assert_double_eq_tol(sum, 1, 0.015);
}
END_TEST

/* The manual's formulas by hand, m being 102. */
START_TEST(formulas_by_hand)
{
    const double a[] = {100, 104}, b[] = {105, 99}, ab[] = {104, 102};
    double first, total;
    ck_assert_int_eq(thud_sobol_indices(a, b, ab, 2, 1, &first, &total, &error), THUD_OK);
    const double variance = (4 + 4 + 9 + 9) / 4.0;
    ck_assert_double_eq_tol(first, (3 * 4 + -3 * -2) / 2.0 / variance, 1e-14);
    ck_assert_double_eq_tol(total, (16 + 4) / 2.0 / (2 * variance), 1e-14);
}
END_TEST

START_TEST(nothing_varies_and_missing_rows)
{
    double a[] = {1, 1, NAN, 1}, b[] = {1, 1, 5, 1}, ab[] = {1, 1, 1, 1}, first, total;
    ck_assert_int_eq(thud_sobol_indices(a, b, ab, 4, 1, &first, &total, &error), THUD_OK);
    ck_assert(isnan(first) && isnan(total));
}
END_TEST

START_TEST(every_stratum_once)
{
    enum { N = 50 };
    double u[N * D], other[N * D];
    struct thud_random random = {3}, again = {3};
    ck_assert_int_eq(thud_latin_hypercube(&random, N, D, u, &error), THUD_OK);
    ck_assert_int_eq(thud_latin_hypercube(&again, N, D, other, &error), THUD_OK);
    ck_assert(memcmp(u, other, sizeof u) == 0);
    for (int j = 0; j < D; j++) {
        int hit[N] = {0};
        for (int i = 0; i < N; i++)
            hit[(int)(u[i * D + j] * N)]++;
        for (int i = 0; i < N; i++)
            ck_assert_int_eq(hit[i], 1);
    }
}
END_TEST

/* The first points of the first two dimensions in closed form (van der Corput in Gray code order); in every dimension
 * the first 2^k points fill each of the 2^k intervals once, also shifted; and in the first pair of dimensions each of
 * their rectangles of area 2^-k (a (0, 2)-sequence). */
START_TEST(sobol_points_fill_their_intervals)
{
    enum { K = 6, N = 1 << K, DIMENSIONS = THUD_SOBOL_DIMENSIONS };
    static const double known[][2] = {{0, 0},           {0.5, 0.5},       {0.75, 0.25},     {0.25, 0.75},
                                      {0.375, 0.375},   {0.875, 0.875},   {0.625, 0.125},   {0.125, 0.625},
                                      {0.1875, 0.3125}, {0.6875, 0.8125}, {0.9375, 0.0625}, {0.4375, 0.5625}};
    static double u[N * DIMENSIONS];
    for (int shifted = 0; shifted < 2; shifted++) {
        struct thud_random random = {11};
        thud_sobol_sequence(shifted ? &random : NULL, N, DIMENSIONS, u);
        for (size_t i = 0; !shifted && i < sizeof known / sizeof *known; i++)
            for (int j = 0; j < 2; j++)
                ck_assert_msg(u[i * DIMENSIONS + (size_t)j] == known[i][j], "point %zu dimension %d: %.17g", i, j,
                              u[i * DIMENSIONS + (size_t)j]);
        for (int j = 0; j < DIMENSIONS; j++) {
            int hit[N] = {0};
            for (int i = 0; i < N; i++)
                hit[(int)(u[i * DIMENSIONS + j] * N)]++;
            for (int i = 0; i < N; i++)
                ck_assert_int_eq(hit[i], 1);
        }
        for (int a = 0; a <= K; a++) {
            int hit[N] = {0}, nx = 1 << a, ny = N / nx;
            for (int i = 0; i < N; i++)
                hit[(int)(u[i * DIMENSIONS] * nx) * ny + (int)(u[i * DIMENSIONS + 1] * ny)]++;
            for (int i = 0; i < N; i++)
                ck_assert_int_eq(hit[i], 1);
        }
    }
}
END_TEST

/* Root mean square error of the mean of the Ishigami function (a/2 = 3.5) over several seeds. */
static double mean_error(bool sobol, size_t n)
{
    enum { SEEDS = 20 };
    double square = 0, *u = malloc(n * D * sizeof *u);
    ck_assert_ptr_nonnull(u);
    for (unsigned seed = 1; seed <= SEEDS; seed++) {
        struct thud_random random = {seed};
        double mean = 0;
        if (sobol)
            thud_sobol_sequence(&random, n, D, u);
        for (size_t i = 0; !sobol && i < n * D; i++)
            u[i] = thud_random_unit(&random);
        for (size_t i = 0; i < n; i++)
            mean += ishigami(u + i * D) / (double)n;
        square += pow(mean - 3.5, 2) / SEEDS;
    }
    free(u);
    return sqrt(square);
}

/* Random numbers give sigma / sqrt(n); the sequence falls nearly as 1/n. */
START_TEST(sobol_converges_faster_than_chance)
{
    double coarse = mean_error(true, 256), fine = mean_error(true, 8192);
    double sigma = sqrt(0.5 * pow(1 + 0.1 * pow(pi, 4) / 5, 2) + 49 / 8.0 + 0.01 * pow(pi, 8) * 8 / 225);
    ck_assert_double_eq_tol(mean_error(false, 8192) / (sigma / sqrt(8192)), 1, 0.5);
    ck_assert_msg(fine < 0.1 * sigma / sqrt(8192), "%g", fine);
    ck_assert_msg(log(coarse / fine) / log(8192 / 256.0) > 0.8, "order %g", log(coarse / fine) / log(8192 / 256.0));
}
END_TEST

START_TEST(inputs_by_name)
{
    struct thud_inputs inputs;
    thud_inputs_init(&inputs);
    ck_assert_int_eq(thud_inputs_set(&inputs, "gap=8 %", &error), THUD_OK);
    ck_assert_double_eq_tol(inputs.size[THUD_INPUT_GAP], 0.08, 1e-15);
    ck_assert_int_eq(thud_inputs_set(&inputs, "contact-stiffness=3", &error), THUD_OK);
    const char *const wrong[] = {"gap",
                                 "gap=",
                                 "gaps=5 %",
                                 "gap=5 cm",
                                 "gap=95 %",
                                 "contact-stiffness=0.5",
                                 "restitution=2",
                                 "elevation=5 %",
                                 "elevation=11 m",
                                 "yield=95 %",
                                 "hardening=2",
                                 "stiffness.=5 %",
                                 "restitution.A=0.1",
                                 "elevation.common=5 cm",
                                 "ground-motion=2"};
    ck_assert_int_eq(thud_inputs_set(&inputs, "elevation=5 cm", &error), THUD_OK);
    ck_assert_double_eq_tol(inputs.size[THUD_INPUT_ELEVATION], 0.05, 1e-15);
    ck_assert_int_eq(thud_inputs_set(&inputs, "stiffness.common=7 %", &error), THUD_OK);
    ck_assert_double_eq_tol(inputs.common[THUD_INPUT_STIFFNESS], 0.07, 1e-15);
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        ck_assert_msg(thud_inputs_set(&inputs, wrong[i], &error) == THUD_USAGE, "%s", wrong[i]);
}
END_TEST

static double size_of(const struct thud_uncertainty *u, const char *name)
{
    for (int i = 0; i < u->ninputs; i++)
        if (strcmp(u->input[i].name, name) == 0)
            return u->input[i].size;
    return 0;
}

/* Every building has its own, one may have another size, and all may share something besides. */
START_TEST(inputs_of_each_building)
{
    struct thud_inputs inputs;
    struct thud_uncertainty *u;
    const char *const said[] = {"stiffness=15 %", "stiffness.B=5 %", "stiffness.common=12 %", "mass.1=3 %",
                                "damping=0"};
    thud_inputs_init(&inputs);
    for (size_t i = 0; i < sizeof said / sizeof *said; i++)
        ck_assert_int_eq(thud_inputs_set(&inputs, said[i], &error), THUD_OK);
    ck_assert_int_eq(thud_uncertainty_create(scene, motion, NULL, 0, THUD_CASE_AS_WRITTEN, &inputs, &u, &error),
                     THUD_OK);
    ck_assert_double_eq_tol(size_of(u, "stiffness.A"), 0.15, 1e-15);
    ck_assert_double_eq_tol(size_of(u, "stiffness.B"), 0.05, 1e-15);
    ck_assert_double_eq_tol(size_of(u, "stiffness.common"), 0.12, 1e-15);
    ck_assert_double_eq_tol(size_of(u, "mass.A"), 0.03, 1e-15);
    ck_assert(size_of(u, "mass.B") == 0 && size_of(u, "damping.A") == 0 && size_of(u, "gap") == 0.05);
    thud_uncertainty_free(u);
    const char *const absent[] = {"stiffness.C=5 %", "yield.A=5 %", "gap.2=5 %",         "yield=20 %",
                                  "hardening=0.1",   "link=5 %",    "yield.common=10 %", "soil-stiffness=1.2"};
    for (size_t i = 0; i < sizeof absent / sizeof *absent; i++) {
        thud_inputs_init(&inputs);
        ck_assert_int_eq(thud_inputs_set(&inputs, absent[i], &error), THUD_OK);
        ck_assert_int_eq(thud_uncertainty_create(scene, motion, NULL, 0, THUD_CASE_AS_WRITTEN, &inputs, &u, &error),
                         THUD_INPUT);
    }
    ck_assert_str_eq(error.what, "this scene has no soil-stiffness that could be uncertain");
    ck_assert(strstr(error.allowed, "gap, stiffness, damping, mass, contact-stiffness") == error.allowed);
    ck_assert_ptr_null(strstr(error.allowed, "yield"));
    thud_inputs_init(&inputs); /* none of what is not there is what there is */
    ck_assert_int_eq(thud_inputs_set(&inputs, "yield=0", &error), THUD_OK);
    ck_assert_int_eq(thud_uncertainty_create(scene, motion, NULL, 0, THUD_CASE_AS_WRITTEN, &inputs, &u, &error),
                     THUD_OK);
    thud_uncertainty_free(u);
}
END_TEST

/* A suite: the place of the last input chooses the motion, evenly; without a choice it is the scene's own. */
START_TEST(a_motion_of_a_suite)
{
    struct thud_inputs inputs;
    struct thud_uncertainty *u;
    struct thud_record *twice;
    thud_inputs_init(&inputs);
    ck_assert_int_eq(thud_record_create(motion->a_mps2, motion->samples, motion->dt_s, &twice, &error), THUD_OK);
    thud_record_scale(twice, 2);
    const struct thud_record *suite[] = {motion, twice};
    scene->interface[0].gap_m = 1;
    ck_assert_int_eq(thud_uncertainty_create(scene, motion, suite, 2, THUD_CASE_AS_WRITTEN, &inputs, &u, &error),
                     THUD_OK);
    ck_assert_str_eq(u->input[u->ninputs - 1].name, "ground-motion");
    ck_assert(thud_uncertainty_record(u, 0.49) == motion && thud_uncertainty_record(u, 0.51) == twice);
    ck_assert(thud_uncertainty_record(u, 1) == twice && thud_uncertainty_record(u, NAN) == motion);
    double *x = malloc(2 * (size_t)u->nquantities * sizeof *x), *y = x + u->nquantities, place[THUD_DRAWN_MAX];
    for (int i = 0; i < u->ninputs; i++)
        place[i] = 0.5;
    place[u->ninputs - 1] = NAN;
    ck_assert_int_eq(thud_uncertainty_evaluate(u, place, x, &error), THUD_OK);
    place[u->ninputs - 1] = 0.75;
    ck_assert_int_eq(thud_uncertainty_evaluate(u, place, y, &error), THUD_OK);
    for (int q = 0; q < u->nquantities; q++)
        if (x[q] > 0 && !thud_quantity_is_ratio(&u->quantity[q]))
            ck_assert_double_eq_tol(y[q] / x[q], 2, 1e-9);
    free(x);
    thud_uncertainty_free(u);
    thud_record_free(twice);
}
END_TEST

/* Without a motion of the scene's own the nominal one is that of the median needed gap, which a factor on a motion
 * multiplies where nothing yields. */
START_TEST(the_nominal_motion_of_a_suite)
{
    static const double factor[] = {3, 0.5, 2, 1, 4};
    struct thud_inputs inputs;
    struct thud_uncertainty *u;
    struct thud_record *suite[5];
    thud_inputs_init(&inputs);
    for (int i = 0; i < 5; i++) {
        ck_assert_int_eq(thud_record_create(motion->a_mps2, motion->samples, motion->dt_s, &suite[i], &error), THUD_OK);
        thud_record_scale(suite[i], factor[i]);
    }
    for (int n = 2; n <= 5; n++) { /* of 3 0.5 | 2 | 1 | 4 the lower median is 0.5, 2, 1, 2 */
        static const int median[] = {1, 2, 3, 2};
        ck_assert_int_eq(thud_uncertainty_create(scene, NULL, (const struct thud_record *const *)suite, n,
                                                 THUD_CASE_AS_WRITTEN, &inputs, &u, &error),
                         THUD_OK);
        ck_assert(thud_uncertainty_record(u, NAN) == suite[median[n - 2]]);
        thud_uncertainty_free(u);
    }
    for (int i = 0; i < 5; i++)
        thud_record_free(suite[i]);
}
END_TEST

/* Of one input: of the structure or interface `of`, or of all of them. */
static void change(struct thud_scene *to, enum thud_input input, int of, double size, double u, double *factor)
{
    struct thud_drawn_input drawn = {.input = input, .of = of, .size = size};
    thud_input_change(to, &drawn, u, factor);
}

START_TEST(changes_of_a_scene)
{
    double factor = 1;
    scene[1] = scene[0];
    change(scene, THUD_INPUT_STIFFNESS, -1, 0.1, 1, &factor);
    ck_assert_double_eq_tol(scene->structure[1].stiffness_npm[3], 1.1 * scene[1].structure[1].stiffness_npm[3], 1);
    scene->structure[1] = scene[1].structure[1];
    change(scene, THUD_INPUT_STIFFNESS, 0, 0.1, 0.5, &factor);
    change(scene, THUD_INPUT_STIFFNESS, 1, 0.1, 0, &factor);
    ck_assert_double_eq_tol(scene->structure[0].stiffness_npm[1], 1.1 * scene[1].structure[0].stiffness_npm[1], 1);
    ck_assert_double_eq_tol(scene->structure[1].stiffness_npm[3], 0.9 * scene[1].structure[1].stiffness_npm[3], 1);
    change(scene, THUD_INPUT_DAMPING, -1, 0.2, 0, &factor);
    ck_assert_double_eq_tol(scene->structure[0].damping, 0.8 * scene[1].structure[0].damping, 1e-15);
    change(scene, THUD_INPUT_MASS, -1, 0.05, 0, &factor);
    ck_assert_double_eq_tol(scene->structure[0].mass_kg[0], 0.95 * scene[1].structure[0].mass_kg[0], 1e-6);
    scene->structure[0].yield_m[1] = scene[1].structure[0].yield_m[1] = 0.01;
    scene->structure[0].hardening[1] = scene[1].structure[0].hardening[1] = 0.05;
    scene->structure[1].yield_shear_n[0] = scene[1].structure[1].yield_shear_n[0] = 1e6;
    scene->structure[1].column_ei_nm2[2] = scene[1].structure[1].column_ei_nm2[2] = 1e8;
    change(scene, THUD_INPUT_YIELD, -1, 0.1, 1, &factor);
    ck_assert_double_eq_tol(scene->structure[0].yield_m[1], 0.011, 1e-15);
    ck_assert_double_eq_tol(scene->structure[1].yield_shear_n[0], 1.1e6, 1e-7);
    ck_assert(scene->structure[0].yield_m[0] == 0 && scene->structure[1].yield_shear_n[1] == 0);
    change(scene, THUD_INPUT_HARDENING, -1, 0.1, 0, &factor);
    ck_assert(scene->structure[0].hardening[1] == 0);                                  /* no less */
    ck_assert(scene->structure[0].hardening[0] == scene[1].structure[0].hardening[0]); /* elastic */
    change(scene, THUD_INPUT_COLUMNS, -1, 0.2, 0, &factor);
    ck_assert_double_eq_tol(scene->structure[1].column_ei_nm2[2], 0.8e8, 1);
    change(scene, THUD_INPUT_ELEVATION, 1, 0.05, 1, &factor);
    ck_assert(scene->structure[0].base_m == 0);
    ck_assert_double_eq_tol(scene->structure[1].base_m, 0.05, 1e-15);
    change(scene, THUD_INPUT_GAP, -1, 0.5, 0, &factor);
    ck_assert_double_eq_tol(scene->interface[0].gap_m,
                            fmax(0.5 * scene[1].interface[0].gap_m,
                                 scene[1].interface[0].has_bumper ? scene[1].interface[0].bumper_thickness_m : 0),
                            1e-15);
    for (int i = 0; i < THUD_INPUTS; i++) { /* the middle is nominal */
        struct thud_scene *same = malloc(sizeof *same);
        *same = scene[1];
        change(same, (enum thud_input)i, i == THUD_INPUT_ELEVATION ? 0 : -1, 2, 0.5, &factor);
        ck_assert_msg(memcmp(same, &scene[1], sizeof *same) == 0, "%s", thud_input_info((enum thud_input)i)->name);
        free(same);
    }
    ck_assert(factor == 1);
    scene->structure[1].kind = THUD_ISOLATED; /* isolators have the one or the other */
    scene->structure[1].isolator_law = THUD_ISOLATOR_LEAD_RUBBER;
    scene->structure[1].isolator_strength_n = 1e6;
    scene->structure[1].isolator_friction = NAN;
    change(scene, THUD_INPUT_YIELD, 1, 0.1, 1, &factor);
    ck_assert_double_eq_tol(scene->structure[1].isolator_strength_n, 1.1e6, 1e-7);
    ck_assert(isnan(scene->structure[1].isolator_friction));
    change(scene, THUD_INPUT_MOTION, -1, 0.3, 1, &factor);
    ck_assert_double_eq_tol(factor, 1.3, 1e-15);
}
END_TEST

/* Where the elevation that is drawn lets floors meet, no columns are struck, and there is no shear of 0. */
START_TEST(a_shear_needs_struck_columns)
{
    struct thud_inputs inputs = {.size = {0}};
    struct thud_uncertainty *u;
    inputs.size[THUD_INPUT_ELEVATION] = 0.5;
    inputs.size[THUD_INPUT_CONTACT_STIFFNESS] = 1;
    snprintf(scene->record.file, sizeof scene->record.file, "motion");
    for (int s = 0; s < 2; s++)
        for (int i = 0; i < scene->structure[s].storeys; i++)
            scene->structure[s].column_ei_nm2[i] = 160e6;
    scene->structure[1].base_m = 0.5;
    ck_assert_int_eq(thud_uncertainty_create(scene, motion, NULL, 0, THUD_CASE_NONE, &inputs, &u, &error), THUD_OK);
    ck_assert_int_eq(u->ninputs, 2);
    ck_assert_str_eq(u->input[1].name, "elevation.B");
    double place[] = {0.5, 0.5}, *x = malloc((size_t)u->nquantities * sizeof *x);
    const int last = u->nquantities - 1;
    ck_assert(u->quantity[last].measure == THUD_MEASURE_SHEAR);
    for (int met = 0; met < 2; met++) {
        place[1] = met ? 0 : 0.5;
        ck_assert_int_eq(thud_uncertainty_evaluate(u, place, x, &error), THUD_OK);
        ck_assert(met ? isnan(x[last]) : x[last] >= 0);
        ck_assert(x[last - 1] >= 0);
    }
    free(x);
    thud_uncertainty_free(u);
}
END_TEST

/* A sample is a run of the changed scene; without contact the response is linear in the motion. */
START_TEST(samples_are_runs)
{
    struct thud_inputs inputs = {.size = {0}};
    struct thud_uncertainty *u;
    double half = 0.5, most = 1, *x, *y;
    inputs.size[THUD_INPUT_CONTACT_STIFFNESS] = 1;
    inputs.size[THUD_INPUT_MOTION] = 0.5;
    scene->interface[0].gap_m = 1;
    snprintf(scene->record.file, sizeof scene->record.file, "motion");
    ck_assert_int_eq(thud_uncertainty_create(scene, motion, NULL, 0, THUD_CASE_AS_WRITTEN, &inputs, &u, &error),
                     THUD_OK);
    ck_assert_int_eq(u->ninputs, 1);
    x = malloc(2 * (size_t)u->nquantities * sizeof *x);
    y = x + u->nquantities;
    ck_assert_int_eq(thud_uncertainty_evaluate(u, &half, x, &error), THUD_OK);
    ck_assert_int_eq(thud_uncertainty_evaluate(u, &most, y, &error), THUD_OK);
    struct thud_solution solution;
    ck_assert_int_eq(thud_scene_case(scene, THUD_CASE_NONE, scene + 1, &error), THUD_OK);
    ck_assert_int_eq(thud_scene_solve(scene + 1, motion, NULL, &solution, &error), THUD_OK);
    const struct thud_structure_result *s = &thud_run_result(solution.run)->structure[0];
    double largest = 0, sum = 0;
    for (int i = 0; i < s->floors; i++) {
        largest = fmax(largest, s->floor[i].acceleration.value);
        sum += s->floor[i].acceleration.value;
    }
    ck_assert(u->quantity[1].measure == THUD_MEASURE_ACCELERATION && x[1] == largest);
    ck_assert(u->quantity[3].measure == THUD_MEASURE_MEAN_ACCELERATION && x[3] == sum / s->floors);
    thud_solution_clear(&solution);
    struct thud_needed_gap *gap; /* whatever the gap of the scene is */
    ck_assert_int_eq(thud_needed_gap_run(scene, motion, &gap, &error), THUD_OK);
    ck_assert(u->quantity[0].measure == THUD_MEASURE_GAP && x[0] > 0);
    ck_assert_double_eq(x[0], thud_needed_gap_widest(gap, 0, THUD_GAP_EXACT, NULL));
    free(gap);
    for (int q = 0; q < u->nquantities; q++)
        if (x[q] > 0)
            ck_assert_double_eq_tol(y[q] / x[q], thud_quantity_is_ratio(&u->quantity[q]) ? 1 : 1.5, 1e-9);
    free(x);
    thud_uncertainty_free(u);
    inputs.size[THUD_INPUT_MOTION] = 0;
    ck_assert_int_eq(thud_uncertainty_create(scene, motion, NULL, 0, THUD_CASE_AS_WRITTEN, &inputs, &u, &error),
                     THUD_INPUT);
}
END_TEST

Suite *thud_suite(void);
/* An input at both of whose ends a quantity is larger than between them moves it, however alike the ends are. */
START_TEST(the_strongest_input_is_that_of_the_widest_span)
{
    const struct thud_uncertainty inputs = {.ninputs = 3};
    const struct thud_uncertainty_study study = {.uncertainty = &inputs};
    const struct thud_uncertainty_told told = {
        .nominal = 1, .of = {[THUD_INPUT_LEAST] = {0.9, 1.5, 1.0}, [THUD_INPUT_MOST] = {1.1, 1.5, 0.7}}};
    ck_assert_double_eq_tol(thud_uncertainty_span(&told, 0), 0.2, 1e-15);
    ck_assert_double_eq_tol(thud_uncertainty_span(&told, 1), 0.5, 1e-15);
    ck_assert_double_eq_tol(thud_uncertainty_span(&told, 2), 0.3, 1e-15);
    ck_assert_int_eq(thud_uncertainty_strongest(&study, &told), 1);
}
END_TEST

Suite *thud_suite(void)
{
    Suite *suite = suite_create("uncertainty");
    TCase *tcase = tcase_create("uncertainty");
    tcase_set_timeout(tcase, 60);
    tcase_add_checked_fixture(tcase, set_up, study_tear_down);
    tcase_add_test(tcase, the_ishigami_function);
    tcase_add_test(tcase, intervals_cover_what_is_known);
    tcase_add_test(tcase, additivity);
    tcase_add_test(tcase, formulas_by_hand);
    tcase_add_test(tcase, nothing_varies_and_missing_rows);
    tcase_add_test(tcase, every_stratum_once);
    tcase_add_test(tcase, sobol_points_fill_their_intervals);
    tcase_add_test(tcase, sobol_converges_faster_than_chance);
    tcase_add_test(tcase, inputs_by_name);
    tcase_add_test(tcase, inputs_of_each_building);
    tcase_add_test(tcase, a_motion_of_a_suite);
    tcase_add_test(tcase, the_nominal_motion_of_a_suite);
    tcase_add_test(tcase, changes_of_a_scene);
    tcase_add_test(tcase, a_shear_needs_struck_columns);
    tcase_add_test(tcase, samples_are_runs);
    tcase_add_test(tcase, the_strongest_input_is_that_of_the_widest_span);
    suite_add_tcase(suite, tcase);
    return suite;
}
