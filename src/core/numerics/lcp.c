/* Principal pivoting (Murty 1974): a guess of which z are above 0, the linear equations for those, and one index changes
 * sides where z or w is below 0, the least first, so that it cannot go round in circles. n is the number of contacts
 * that are closed at one moment, seldom above ten: a new Cholesky factor for each guess costs less than updating one. */
#include "core/numerics/lcp.h"

#include <lapacke.h>
#include <string.h>

#include "base/largest.h"
#include "core/numerics/tolerance.h"

/* The shift r, and how often: each time what is left falls by r over the smallest eigenvalue that is not 0. */
static const double shift = 1e-6;
enum { SHIFTED = 4 };

size_t thud_lcp_work(int n)
{
    size_t size = (size_t)n;
    return size * size + 4 * size;
}

/* Cholesky factor of M + shift D, of which `a` holds M, in its place. */
static bool factor(int n, double more, double *a)
{
    for (int i = 0; i < n; i++)
        a[i * n + i] *= 1 + more;
    if (n > 0 && LAPACKE_dpotrf_work(LAPACK_COL_MAJOR, 'L', n, a, n) != 0)
        return false;
    for (int i = 0; i < n; i++) { /* the row's own diagonal is the sum of the squares of its part of the factor */
        double all = 0;
        for (int j = 0; j <= i; j++)
            all += a[j * n + i] * a[j * n + i];
        if (!(a[i * n + i] * a[i * n + i] > THUD_TOL_DEPENDENT * all))
            return false;
    }
    return true;
}

bool thud_is_definite(int n, const double *m, double *work)
{
    memcpy(work, m, (size_t)n * (size_t)n * sizeof *work);
    return factor(n, 0, work);
}

static void solve_factored(int n, const double *a, double *b)
{
    if (n > 0)
        LAPACKE_dpotrs_work(LAPACK_COL_MAJOR, 'L', n, 1, a, n, b, n);
}

bool thud_semidefinite_solve(int n, const double *m, double *b, double *work)
{
    const size_t size = (size_t)n;
    double *a = work, *x = work + size * size;
    if (thud_is_definite(n, m, a)) {
        solve_factored(n, a, b);
        return true;
    }
    memcpy(a, m, size * size * sizeof *a);
    if (!factor(n, shift, a))
        return false;
    memset(x, 0, size * sizeof *x);
    for (int k = 0; k < SHIFTED; k++) {
        for (int i = 0; i < n; i++)
            x[i] = b[i] + shift * m[i * n + i] * x[i];
        solve_factored(n, a, x);
    }
    memcpy(b, x, size * sizeof *b);
    return true;
}

/* z of the basic set from M_bb z_b = -q_b, 0 elsewhere. false: not positive definite. */
static bool solve_basic(int n, const double *m, double more, const double *q, const double *basic, double *z,
                        double *matrix, double *rhs)
{
    int count = 0;
    for (int i = 0; i < n; i++)
        if (basic[i] > 0)
            rhs[count++] = -q[i];
    for (int i = 0, a = 0; i < n; i++) {
        if (!(basic[i] > 0))
            continue;
        for (int j = 0, b = 0; j < n; j++)
            if (basic[j] > 0)
                matrix[a * count + b++] = m[i * n + j];
        a++;
    }
    if (!factor(count, more, matrix))
        return false;
    solve_factored(count, matrix, rhs);
    for (int i = 0, a = 0; i < n; i++)
        z[i] = basic[i] > 0 ? rhs[a++] : 0;
    return true;
}

/* w_i = q_i + (M z)_i + more D_ii z_i. */
static double complement(int n, const double *m, double more, double q, const double *z, int i)
{
    double w = q + more * m[i * n + i] * z[i];
    for (int j = 0; j < n; j++)
        w += m[i * n + j] * z[j];
    return w;
}

/* Of M + more D. Errors: THUD_DIVERGED where that is not definite, or the pivots do not end. */
static enum thud_status pivots(int n, const double *m, double more, const double *q, double *z, double *work,
                               struct thud_error *err)
{
    double *matrix = work, *rhs = work + (size_t)n * (size_t)n, *basic = rhs + n;
    const double size = thud_largest_size(q, n);
    memset(basic, 0, (size_t)n * sizeof *basic);
    for (long count = 0; count < 1000L * (n + 1); count++) {
        if (!solve_basic(n, m, more, q, basic, z, matrix, rhs))
            return thud_error_set(err, THUD_DIVERGED, "a complementarity problem is not positive definite");
        int wrong = -1;
        for (int i = 0; i < n && wrong < 0; i++)
            if (basic[i] > 0 ? z[i] < 0 : complement(n, m, more, q[i], z, i) < -THUD_TOL_COMPLEMENTARITY * size)
                wrong = i;
        if (wrong < 0)
            return THUD_OK;
        basic[wrong] = basic[wrong] > 0 ? 0 : 1;
    }
    return thud_error_set(err, THUD_DIVERGED, "the pivoting of a complementarity problem does not end");
}

enum thud_status thud_lcp_solve(int n, const double *m, const double *q, double *z, double *work, bool *unique,
                                struct thud_error *err)
{
    double *shifted = work + thud_lcp_work(n) - n;
    enum thud_status status = pivots(n, m, 0, q, z, work, NULL);
    if (unique)
        *unique = status == THUD_OK;
    if (status == THUD_OK)
        return THUD_OK;
    memset(z, 0, (size_t)n * sizeof *z);
    for (int k = 0; k < SHIFTED; k++) {
        for (int i = 0; i < n; i++)
            shifted[i] = q[i] - shift * m[i * n + i] * z[i];
        status = pivots(n, m, shift, shifted, z, work, err);
        if (status != THUD_OK)
            return status;
    }
    for (int i = 0; i < n; i++)
        if (complement(n, m, 0, q[i], z, i) < -THUD_TOL_SOLVABLE * thud_largest_size(q, n))
            return thud_error_set(err, THUD_DIVERGED, "a complementarity problem has no solution");
    return THUD_OK;
}
