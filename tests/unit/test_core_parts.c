/* The core's mathematical parts against closed forms: modes, quadrature, Lobatto points, complementarity problems. */
#include <check.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "base/arena.h"
#include "base/largest.h"
#include "base/quantity.h"
#include "core/model/modes.h"
#include "core/numerics/lcp.h"
#include "core/numerics/poly.h"
#include "core/numerics/quadrature.h"
#include "march.h"

/* Uniform shear building: omega_j = 2 sqrt(k/m) sin((2 j - 1) pi / (2 (2 n + 1))). */
START_TEST(uniform_building)
{
    enum { N = 100 };
    static double mass[N], k[N], omega[N], phi[N * N], work[4 * N + N * N];
    for (int i = 0; i < N; i++) {
        mass[i] = 320e3;
        k[i] = 6e8;
    }
    ck_assert_int_eq(thud_modes_shear(N, mass, k, omega, phi, work, NULL), THUD_OK);
    for (int j = 0; j < N; j++) {
        double expected = 2 * sqrt(6e8 / 320e3) * sin((2 * j + 1) * THUD_PI / (2 * (2 * N + 1)));
        ck_assert_double_eq_tol(omega[j] / expected, 1, 1e-10);
    }
    double mass_sum = 0; /* sum of the effective masses is the mass */
    for (int j = 0; j < N; j++) {
        double gamma = 0, norm = 0;
        for (int i = 0; i < N; i++) {
            gamma += phi[i * N + j] * mass[i];
            norm += phi[i * N + j] * mass[i] * phi[i * N + j];
        }
        ck_assert_double_eq_tol(norm, 1, 1e-12);
        ck_assert(phi[j] > 0);
        mass_sum += gamma * gamma;
    }
    ck_assert_double_eq_tol(mass_sum / (N * 320e3), 1, 1e-12);
}
END_TEST

START_TEST(the_papers_buildings)
{
    static const double six[] = {10.799, 31.685, 50.497, 66.052, 77.481, 84.341},
                        four[] = {15.790, 45.099, 68.062, 82.063};
    double mass[6] = {320e3, 320e3, 320e3, 320e3, 320e3, 250e3}, k[6] = {6e8, 6e8, 6e8, 6e8, 6e8, 6e8};
    double omega[6], phi[36], work[60];
    ck_assert_int_eq(thud_modes_shear(6, mass, k, omega, phi, work, NULL), THUD_OK);
    for (int j = 0; j < 6; j++)
        ck_assert_double_eq_tol(omega[j], six[j], 5.1e-4);
    ck_assert_double_eq_tol(2 * THUD_PI / omega[0], 0.58184, 5.1e-6);
    ck_assert_int_eq(thud_modes_shear(4, mass + 2, k, omega, phi, work, NULL), THUD_OK);
    for (int j = 0; j < 4; j++)
        ck_assert_double_eq_tol(omega[j], four[j], 5.1e-4);
    ck_assert_double_eq_tol(2 * THUD_PI / omega[0], 0.39791, 5.1e-6);
}
END_TEST

/* Two masses on an isolator: C = [c_b + c_s, -c_s; -c_s, c_s] in the floors' coordinates. */
START_TEST(isolated_damping)
{
    double mass[] = {4e5, 3e5}, k[] = {2e7, 6e8}, omega[2], phi[4], work[12], d[4];
    ck_assert_int_eq(thud_modes_shear(2, mass, k, omega, phi, work, NULL), THUD_OK);
    ck_assert_int_eq(thud_modes_isolated_damping(2, mass, k, 0.05, 0.15, phi, d, NULL), THUD_OK);
    double cb = 2 * 0.15 * sqrt(k[0] * 7e5), cs = 2 * 0.05 * sqrt(k[1] * mass[1]);
    double c[] = {cb + cs, -cs, -cs, cs};
    for (int a = 0; a < 2; a++)
        for (int b = 0; b < 2; b++) {
            double sum = 0;
            for (int i = 0; i < 2; i++)
                for (int j = 0; j < 2; j++)
                    sum += phi[i * 2 + a] * c[i * 2 + j] * phi[j * 2 + b];
            ck_assert_double_eq_tol(d[a * 2 + b], sum, 1e-9 * fabs(cb / mass[1]));
        }
}
END_TEST

START_TEST(quadrature_is_exact_to_degree_15)
{
    for (int degree = 0; degree <= 16; degree++) {
        double sum = 0;
        for (int i = 0; i < THUD_QUADRATURE_POINTS; i++)
            sum += thud_quadrature_weight[i] * pow(thud_quadrature_node[i], degree);
        double error = fabs(sum * (degree + 1) - 1);
        if (degree <= 15)
            ck_assert_double_lt(error, 1e-14);
        else
            ck_assert_double_gt(error, 1e-13);
    }
}
END_TEST

/* Lobatto's points: the ends and the roots of P'_(n-1), in closed form for 4 and 5; with n points polynomials to degree
 * 2 n - 3 are integrated exactly, and the polynomials through them are 1 at one and 0 at the others. */
START_TEST(lobatto_points)
{
    double node[THUD_LOBATTO_INNER + 2] = {0}, coefficient[100];
    ck_assert_double_eq_tol(thud_lobatto_of(4)->node[0], 0.5 - 0.5 * sqrt(1.0 / 5), 1e-15);
    ck_assert_double_eq_tol(thud_lobatto_of(5)->node[0], 0.5 - 0.5 * sqrt(3.0 / 7), 1e-15);
    for (int rule = 0; rule < THUD_LOBATTO_RULES; rule++) {
        const struct thud_lobatto *by = &thud_lobatto[rule];
        const int n = by->inner + 2;
        ck_assert_ptr_eq(thud_lobatto_of(n), by);
        ck_assert_int_eq(by->order, 2 * n - 2);
        for (int i = 0; i < by->inner; i++)
            node[i + 1] = by->node[i];
        node[n - 1] = 1;
        for (int degree = 0; degree <= by->order; degree++) {
            double sum = by->end_weight * ((degree == 0) + 1);
            for (int i = 0; i < by->inner; i++)
                sum += by->weight[i] * pow(by->node[i], degree);
            double error = fabs(sum * (degree + 1) - 1);
            if (degree < by->order)
                ck_assert_double_lt(error, 2e-15);
            else
                ck_assert_double_gt(error, 5e-15);
        }
        if (n > 10) /* for works alone, no nodes of a step */
            continue;
        thud_lagrange_coefficients(n, node, coefficient);
        for (int i = 0; i < n; i++)
            for (int j = 0; j < n; j++) {
                double value = 0;
                for (int m = n - 1; m >= 0; m--)
                    value = value * node[j] + coefficient[m * n + i];
                ck_assert_double_eq_tol(value, i == j, 1e-9);
            }
    }
}
END_TEST

static void check_lcp(int n, const double *m, const double *q, const double *z, double tolerance)
{
    for (int i = 0; i < n; i++) {
        double w = q[i];
        for (int j = 0; j < n; j++)
            w += m[i * n + j] * z[j];
        ck_assert_double_ge(z[i], 0);
        ck_assert_double_ge(w, -tolerance);
        ck_assert_double_le(fabs(w * z[i]), tolerance * (1 + fabs(z[i])));
    }
}

START_TEST(complementarity_small)
{
    double z[2], work[64];
    ck_assert_int_eq(thud_lcp_solve(1, (double[]){4}, (double[]){-2}, z, work, NULL, NULL), THUD_OK);
    ck_assert_double_eq(z[0], 0.5);
    ck_assert_int_eq(thud_lcp_solve(1, (double[]){4}, (double[]){2}, z, work, NULL, NULL), THUD_OK);
    ck_assert_double_eq(z[0], 0);
    /* q1 pushes, and its push alone relieves the second */
    ck_assert_int_eq(thud_lcp_solve(2, (double[]){2, 1, 1, 2}, (double[]){-4, -1}, z, work, NULL, NULL), THUD_OK);
    ck_assert_double_eq_tol(z[0], 2, 1e-15);
    ck_assert_double_eq(z[1], 0);
    ck_assert_int_eq(thud_lcp_solve(2, (double[]){2, 1, 1, 2}, (double[]){-3, -3}, z, work, NULL, NULL), THUD_OK);
    ck_assert_double_eq_tol(z[0], 1, 1e-15);
    ck_assert_double_eq_tol(z[1], 1, 1e-15);
    ck_assert_int_eq(thud_lcp_solve(1, (double[]){-1}, (double[]){-1}, z, work, NULL, NULL), THUD_DIVERGED);
}
END_TEST

/* Rows that depend on each other: the smallest solution where there are many, and a refusal where there is none. */
START_TEST(complementarity_of_dependent_rows)
{
    static const double walls[] = {1, -1, -1, 1}, same[] = {1, 1, 1, 1, 1, 1, 1, 1, 1};
    double z[3], work[64], b[] = {3, 3, 3}, two[] = {0.5, -0.5};
    ck_assert_int_eq(thud_lcp_solve(2, walls, (double[]){1, -1}, z, work, NULL, NULL), THUD_OK);
    ck_assert_double_eq_tol(z[0], 0, 1e-12);
    ck_assert_double_eq_tol(z[1], 1, 1e-12);
    ck_assert_int_eq(thud_lcp_solve(3, same, (double[]){-3, -3, -3}, z, work, NULL, NULL), THUD_OK);
    ck_assert_int_eq(thud_lcp_solve(2, walls, (double[]){-1, -1}, two, work, NULL, NULL), THUD_DIVERGED);
    ck_assert(thud_semidefinite_solve(3, same, b, work));
    ck_assert_double_eq_tol(z[0] + z[1] + z[2], 3, 1e-8);
    ck_assert(!thud_is_definite(3, same, work));
    for (int i = 0; i < 3; i++) {
        ck_assert_double_eq_tol(b[i], 1, 1e-8);
    }
}
END_TEST

START_TEST(complementarity_random)
{
    enum { N = 40 };
    static double a[N * N], m[N * N], q[N], z[N];
    double *work = malloc(thud_lcp_work(N) * sizeof *work);
    unsigned seed = 7;
    for (int trial = 0; trial < 60; trial++) {
        int n = 1 + trial % N;
        for (int i = 0; i < n * n; i++) {
            seed = seed * 1664525u + 1013904223u;
            a[i] = (double)(seed >> 8) / 8388608.0 - 1;
        }
        for (int i = 0; i < n; i++) {
            seed = seed * 1664525u + 1013904223u;
            q[i] = (double)(seed >> 8) / 8388608.0 - 1;
            for (int j = 0; j < n; j++) {
                m[i * n + j] = i == j ? 0.05 : 0;
                for (int k = 0; k < n; k++)
                    m[i * n + j] += a[i * n + k] * a[j * n + k];
            }
        }
        ck_assert_int_eq(thud_lcp_solve(n, m, q, z, work, NULL, NULL), THUD_OK);
        check_lcp(n, m, q, z, 1e-9);
    }
    free(work);
}
END_TEST

/* Pieces of a block start on 16 bytes, do not overlap, hold 0 and end with it. */
START_TEST(pieces_of_a_block)
{
    const size_t count[] = {3, 0, 1, 5}, size[] = {sizeof(double), sizeof(double), 200, 1};
    struct thud_arena arena;
    char *piece[4];
    size_t bytes = 0;
    for (int i = 0; i < 4; i++)
        bytes += thud_arena_room(count[i], size[i]);
    ck_assert(thud_arena_open(&arena, bytes));
    for (int i = 0; i < 4; i++) {
        piece[i] = thud_arena_take(&arena, count[i], size[i]);
        ck_assert_uint_eq((uintptr_t)piece[i] % 16, 0);
        ck_assert(i == 0 || piece[i] >= piece[i - 1] + count[i - 1] * size[i - 1]);
        for (size_t b = 0; b < count[i] * size[i]; b++)
            ck_assert_int_eq(piece[i][b], 0);
    }
    ck_assert_ptr_eq(arena.next, arena.end);
    free(piece[0]);
    double *first, *none;
    int *last;
    ck_assert_int_eq(THUD_LAY(NULL, THUD_PIECE(first, 3), THUD_PIECE(none, 0), THUD_PIECE(last, 5)), THUD_OK);
    ck_assert(none >= first + 3 && (void *)last >= (void *)none);
    for (int i = 0; i < 5; i++)
        ck_assert(last[i] == 0 && (i >= 3 || first[i] == 0));
    free(first);
    struct thud_blocks blocks = {NULL};
    for (int i = 0; i < 3; i++) {
        ck_assert_int_eq(THUD_LAY_IN(&blocks, NULL, THUD_PIECE(first, 3), THUD_PIECE(last, 5)), THUD_OK);
        ck_assert_uint_eq((uintptr_t)first % 16, 0);
        ck_assert((void *)first > (void *)blocks.last && first[0] == 0 && last[4] == 0);
        first[0] = last[4] = 7;
    }
    thud_blocks_free(&blocks);
    ck_assert_ptr_null(blocks.last);
    thud_blocks_free(&blocks);
}
END_TEST

#if defined __SANITIZE_ADDRESS__
#include <sanitizer/asan_interface.h>

/* A storey's row in place of a contact's, and an index past the state of a motion, are seen. */
START_TEST(indices_past_their_arrays_are_seen)
{
    const struct march_law law = march_law("linear", "stiffness", 1e9, NULL);
    struct thud_model *model = march_mass_and_wall(1000, 10, 0, 1, 0.01, &law);
    struct march m = march_run(model, NULL, "exact", 0, 1e-6, true, 1);
    const struct thud_result *r = m.result;
    ck_assert_int_eq(m.status, THUD_OK);
    for (int past = 0; past < 4; past++) {
        ck_assert(__asan_address_is_poisoned(&r->contact[r->ncontacts + past].interface));
        ck_assert(__asan_address_is_poisoned(&r->contact[r->ncontacts + past].right_floor));
        ck_assert(__asan_address_is_poisoned(&r->structure[0].floor[1 + past].drift));
        ck_assert(__asan_address_is_poisoned(&model->contact[model->nrows + past].clearance_m));
        ck_assert(__asan_address_is_poisoned(&model->omega[model->nmodes + past]));
    }
    ck_assert(!__asan_address_is_poisoned(&r->contact[r->ncontacts - 1].right_floor));
    ck_assert(!__asan_address_is_poisoned(&model->omega[model->nmodes - 1]));
    march_free(&m);
    thud_model_free(model);
}
END_TEST
#endif

/* A NaN on either side stays one: what has been largest so far, or what comes next. */
START_TEST(larger_and_smaller)
{
    static const double x[] = {-INFINITY, -1, -1e-300, 0, 1e-300, 2, INFINITY, NAN};
    enum { N = sizeof x / sizeof *x };
    for (int i = 0; i < N; i++)
        for (int k = 0; k < N; k++) {
            const double larger = thud_larger(x[i], x[k]), smaller = thud_smaller(x[i], x[k]);
            const bool either = isnan(x[i]) || isnan(x[k]);
            ck_assert(either ? isnan(larger) : larger == x[i > k ? i : k]);
            ck_assert(either ? isnan(smaller) : smaller == x[i < k ? i : k]);
        }
}
END_TEST

Suite *thud_suite(void)
{
    Suite *suite = suite_create("core parts");
    TCase *tc = tcase_create("core parts");
    tcase_add_test(tc, uniform_building);
    tcase_add_test(tc, the_papers_buildings);
    tcase_add_test(tc, isolated_damping);
    tcase_add_test(tc, quadrature_is_exact_to_degree_15);
    tcase_add_test(tc, lobatto_points);
    tcase_add_test(tc, complementarity_small);
    tcase_add_test(tc, complementarity_of_dependent_rows);
    tcase_add_test(tc, complementarity_random);
    tcase_add_test(tc, pieces_of_a_block);
    tcase_add_test(tc, larger_and_smaller);
#if defined __SANITIZE_ADDRESS__
    tcase_add_test(tc, indices_past_their_arrays_are_seen);
#endif
    suite_add_tcase(suite, tc);
    return suite;
}
