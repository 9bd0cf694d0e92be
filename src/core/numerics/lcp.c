#include "core/numerics/lcp.h"

#include <lapacke.h>
#include <math.h>

#include "core/numerics/tolerance.h"

size_t thud_lcp_work(int n)
{
    size_t size = (size_t)n;
    return size * size + 3 * size;
}

/* z of the basic set from M_bb z_b = -q_b, 0 elsewhere. false: not positive definite. */
static int solve_basic(int n, const double *m, const double *q, const double *basic, double *z, double *matrix,
                       double *rhs)
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
    if (count > 0 && LAPACKE_dposv_work(LAPACK_COL_MAJOR, 'L', count, 1, matrix, count, rhs, count) != 0)
        return 0;
    for (int i = 0, a = 0; i < n; i++)
        z[i] = basic[i] > 0 ? rhs[a++] : 0;
    return 1;
}

enum thud_status thud_lcp_solve(int n, const double *m, const double *q, double *z, double *work,
                                struct thud_error *err)
{
    double *matrix = work, *rhs = work + (size_t)n * (size_t)n, *basic = rhs + n, size = 0;
    for (int i = 0; i < n; i++) {
        basic[i] = 0;
        size = fmax(size, fabs(q[i]));
    }
    for (long pivots = 0; pivots < 1000L * (n + 1); pivots++) {
        if (!solve_basic(n, m, q, basic, z, matrix, rhs))
            return thud_error_set(err, THUD_DIVERGED, "a complementarity problem is not positive definite");
        int wrong = -1;
        for (int i = 0; i < n && wrong < 0; i++) {
            double w = q[i];
            for (int j = 0; j < n; j++)
                w += m[i * n + j] * z[j];
            if (basic[i] > 0 ? z[i] < 0 : w < -THUD_TOL_COMPLEMENTARITY * size)
                wrong = i;
        }
        if (wrong < 0)
            return THUD_OK;
        basic[wrong] = basic[wrong] > 0 ? 0 : 1;
    }
    return thud_error_set(err, THUD_DIVERGED, "a complementarity problem has no end of pivots");
}
