/* Contact forces of a batch of points, against the force at one point and against powers in long double. */
#include <check.h>
#include <math.h>

#include "base/quantity.h"
#include "core/motion/branch_batch.h"
#include "core/motion/nodes.h"

static const double d[THUD_BATCH] = {-1e-3, 0, 1e-20, 1e-9, 3.7e-5, 0.0123, 0.71, 4.2};
static const double v[THUD_BATCH] = {1, -2, 0.3, 0, -0.7, 1.9, -1e-9, 12};

static const struct thud_branch branches[] = {
    {.K = 0.36e3 * 8.9e7, .p = 2.65, .D = 0.36e3 * 8.9e7 * 1.3, .r = 2.65},
    {.K = 2e9, .p = 1.5},
    {.K = 2e9, .p = 1.5, .D = 3e6, .r = 0.25},
    {.D = 7e8, .r = 1, .p = 1, .k_npm = 2.5e9, .c_nspm = -3e5, .f0_n = -1e7},
    {.K = 5, .p = 11, .D = 0.2, .r = 0.01},
    {.K = 0.36e3 * 8.9e7, .p = 2.65, .D = 0.36e3 * 8.9e7 * 1.3, .r = 2.65, .column_npm = 3e8},
    {.K = 0.36e3 * 8.9e7, .p = 2.65, .column_npm = 3e4},
    {.K = 2e9, .p = 1.5, .D = 3e6, .r = 0.25, .column_npm = 1e9},
};

START_TEST(a_batch_is_its_points)
{
    const struct thud_branch *b = &branches[_i];
    double force[THUD_BATCH], fd[THUD_BATCH], fv[THUD_BATCH];
    thud_branch_batch(b, d, v, force, fd, fv);
    for (int i = 0; i < THUD_BATCH; i++) {
        double want_fd, want_fv, want = thud_branch_force(b, d[i], v[i], &want_fd, &want_fv);
        double parts = fabs(b->f0_n) + fabs(b->k_npm * d[i]) + fabs(b->c_nspm * v[i]);
        if (d[i] > 0)
            parts += fabs(b->K) * pow(d[i], b->p) + fabs(b->D) * pow(d[i], b->r) * fabs(v[i]);
        ck_assert_double_eq_tol(force[i], want, 5e-14 * parts + 1e-180);
        ck_assert_double_eq_tol(fv[i], want_fv, 5e-14 * (fabs(want_fv) + fabs(b->c_nspm)) + 1e-180);
        if (d[i] == 0) /* no side */
            ck_assert_double_eq(fd[i], b->k_npm);
        else
            ck_assert_double_eq_tol(fd[i], want_fd, 5e-14 * (fabs(want_fd) + parts / fabs(d[i])) + 1e-180);
    }
}
END_TEST

START_TEST(powers_are_right_over_their_range)
{
    double force[THUD_BATCH], fd[THUD_BATCH], fv[THUD_BATCH], x[THUD_BATCH], rest[THUD_BATCH] = {0}, worst = 0;
    const struct thud_branch b = {.K = 1, .p = 2.65};
    for (int k = 0; k < 20000; k++) {
        for (int i = 0; i < THUD_BATCH; i++)
            x[i] = exp(-25 + 25.0 * (THUD_BATCH * k + i) / (20000 * THUD_BATCH)); /* 1e-11 to 1 */
        thud_branch_batch(&b, x, rest, force, fd, fv);
        for (int i = 0; i < THUD_BATCH; i++) {
            long double want = powl((long double)x[i], 2.65L + ((long double)2.65 - 2.65L));
            worst = fmax(worst, (double)fabsl(force[i] / want - 1));
        }
    }
    ck_assert_double_lt(worst, 2e-14);
    ck_assert_double_gt(worst, 0);
}
END_TEST

START_TEST(numbers_without_bounds_do_not_pass_for_forces)
{
    const struct thud_branch b = branches[0];
    double force[THUD_BATCH], fd[THUD_BATCH], fv[THUD_BATCH];
    const double bad[THUD_BATCH] = {NAN, 1e200, 0.01, INFINITY, 0.01, 0.01, 0.01, 0.01};
    const double rate[THUD_BATCH] = {0, 0, NAN, 0, INFINITY, 0, 0, 0};
    thud_branch_batch(&b, bad, rate, force, fd, fv);
    ck_assert(isnan(force[0]));
    ck_assert(!(force[1] < 1e100));
    ck_assert(isnan(force[2]));
    ck_assert(!(force[3] < 1e100));
    ck_assert(!isfinite(force[4]));
    ck_assert(isfinite(force[5]));
}
END_TEST

Suite *thud_suite(void)
{
    Suite *s = suite_create("branch_batch");
    TCase *t = tcase_create("forces");
    tcase_add_loop_test(t, a_batch_is_its_points, 0, (int)(sizeof branches / sizeof *branches));
    tcase_add_test(t, powers_are_right_over_their_range);
    tcase_add_test(t, numbers_without_bounds_do_not_pass_for_forces);
    suite_add_tcase(s, t);
    return s;
}
