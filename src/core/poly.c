#include "core/poly.h"

#include <math.h>
#include <stdbool.h>

#include "core/double_pair.h"
#include "core/tolerance.h"

enum { DEPTH_MAX = 48, INTERVALS_MAX = 4096 };

/* The highest even and odd orders, and which even order that is. */
static inline thud_double_pair top_pair(const double *c, int n, int *k)
{
    *k = (n - 1) & ~1;
    return n & 1 ? (thud_double_pair){c[n - 1], 0} : thud_double_pair_at(c + n - 2);
}

/* Even and odd orders side by side, each by Horner's scheme in s^2: half as long a way as one scheme in s. */
double thud_poly_value(const double *c, int n, double s)
{
    int k;
    double square = s * s;
    thud_double_pair v = top_pair(c, n, &k);
    for (k -= 2; k >= 0; k -= 2)
        v = v * square + thud_double_pair_at(c + k);
    return v[0] + s * v[1];
}

void thud_poly_value3(const double *c, int n, double s, double out[3])
{
    int k;
    double square = s * s;
    thud_double_pair v = top_pair(c, n, &k), d = {0, 0}, dd = {0, 0}; /* d, dd: by s^2, dd halved */
    for (k -= 2; k >= 0; k -= 2) {
        dd = dd * square + d;
        d = d * square + v;
        v = v * square + thud_double_pair_at(c + k);
    }
    out[0] = v[0] + s * v[1];
    out[1] = v[1] + 2 * s * (d[0] + s * d[1]);
    out[2] = 2 * d[0] + 6 * s * d[1] + 8 * square * (dd[0] + s * dd[1]);
}

/* |c[0]| + ... + |c[n - 1]| */
static double absolute_sum(const double *c, int n)
{
    thud_double_pair even = {0, 0}, odd = {0, 0};
    int k = 0;
    for (; k + 4 <= n; k += 4) {
        even += thud_double_pair_abs(thud_double_pair_at(c + k));
        odd += thud_double_pair_abs(thud_double_pair_at(c + k + 2));
    }
    even += odd;
    double sum = even[0] + even[1];
    for (; k < n; k++)
        sum += fabs(c[k]);
    return sum;
}

/* Bound of the third derivative on [0, 1]. */
static double third_bound(const double *c, int n)
{
    thud_double_pair sum = {0, 0}, k = {0, 1};
    int i = 0;
    for (; i + 2 <= n; i += 2, k += 2)
        sum += k * (k - 1) * (k - 2) * thud_double_pair_abs(thud_double_pair_at(c + i));
    double last = i < n ? (double)(i * (i - 1) * (i - 2)) * fabs(c[i]) : 0;
    return sum[0] + sum[1] + last;
}

/* Bound of how far p' may be from c[1] on [0, 1]. */
static double slope_bound(const double *c, int n)
{
    thud_double_pair sum = {0, 0}, k = {2, 3};
    int i = 2;
    for (; i + 2 <= n; i += 2, k += 2)
        sum += k * thud_double_pair_abs(thud_double_pair_at(c + i));
    return sum[0] + sum[1] + (i < n ? (double)i * fabs(c[i]) : 0);
}

struct search {
    const double *c;
    int n;
    double sign, noise, third;
    int intervals;
};

static double value(const struct search *f, double s)
{
    return f->sign * thud_poly_value(f->c, f->n, s);
}

/* Root of a function that rises on [a, b] with f(a) <= 0 < f(b), from s, where its value and derivatives are v:
 * Halley's method kept inside a shrinking bracket, until a bound of what is left says that it is there. */
static double rising_root(const struct search *f, double a, double b, double s, double v[3])
{
    for (int i = 0; i < 80; i++) {
        double p = f->sign * v[0], d = f->sign * v[1], dd = f->sign * v[2];
        if (p > 0)
            b = s;
        else
            a = s;
        double bend = dd / d, newton = p / d, next = s - newton / (1 - 0.5 * newton * bend);
        double moved = fabs(next - s), change = moved * (fabs(bend) + f->third / d * moved); /* of the slope, at most */
        if (moved <= THUD_TOL_ROOT * s || b - a <= THUD_TOL_ROOT * b)
            return s;
        bool inside = next > a && next < b;
        if (inside && change < 0.1 && (bend * bend + f->third / d) * moved * moved * moved <= THUD_TOL_ROOT_REST * next)
            return next;
        s = inside ? next : 0.5 * (a + b);
        thud_poly_value3(f->c, f->n, s, v);
    }
    return s;
}

static double first_above(struct search *f, double a, double b, int depth)
{
    double m = 0.5 * (a + b), r = 0.5 * (b - a), v[3];
    thud_poly_value3(f->c, f->n, m, v);
    double p = f->sign * v[0], d = f->sign * v[1], bend = fabs(v[2]), rest = f->third * r;
    double reach = r * (fabs(d) + r * (0.5 * bend + rest / 6));
    if (p + reach <= f->noise)
        return INFINITY;
    if (p - reach > 0)
        return a;                          /* above all the way */
    if (d - r * (bend + 0.5 * rest) > 0) { /* rises all the way */
        if (value(f, b) <= f->noise)
            return INFINITY;
        return value(f, a) > 0 ? a : rising_root(f, a, b, m, v);
    }
    if (depth == DEPTH_MAX || f->intervals++ > INTERVALS_MAX)
        return value(f, b) > f->noise ? b : INFINITY;
    double left = first_above(f, a, m, depth + 1);
    return left < INFINITY ? left : first_above(f, m, b, depth + 1);
}

double thud_poly_first_above(const double *c, int n, double s_end, double sign, int zeros, double noise)
{
    while (n > 1 && (zeros > 0 || c[0] == 0.0)) { /* p(s)/s has the same sign as p(s) */
        c++;
        n--;
        zeros--;
        noise = 0;
    }
    if (sign * c[0] > noise)
        return 0;
    /* how far it may come from its start, s_end being at most 1 */
    if (sign * c[0] + absolute_sum(c + 1, n - 1) <= noise)
        return INFINITY;
    if (n > 1 && sign * c[1] <= -slope_bound(c, n)) /* falls all the way */
        return INFINITY;
    struct search f = {c, n, sign, noise, third_bound(c, n), 0};
    return first_above(&f, 0, s_end, 0);
}

struct peak {
    const double *c;
    int n;
    double third, best, where;
    bool found;
    int intervals;
};

static void try_at(struct peak *f, double s)
{
    double v = fabs(s == 0 ? f->c[0] : thud_poly_value(f->c, f->n, s));
    if (v > f->best) {
        f->best = v;
        f->where = s;
        f->found = true;
    }
}

/* p' is monotone on [a, b]: its one root, if it is there, from s, where value and derivatives are v. A root is known to
 * 1e-12 when the last step's square, times a bound, is that. */
static void extremum(struct peak *f, double a, double b, double s, double v[3])
{
    double va[3], vb[3];
    thud_poly_value3(f->c, f->n, a, va);
    thud_poly_value3(f->c, f->n, b, vb);
    if ((va[1] > 0) == (vb[1] > 0))
        return;
    bool rising = vb[1] > va[1];
    for (int i = 0; i < 60; i++) {
        if ((v[1] > 0) == rising)
            b = s;
        else
            a = s;
        double next = s - v[1] / v[2], moved = fabs(next - s);
        if (!(moved > THUD_TOL_PEAK_PLACE)) /* s is the root, and may be an end of the bracket, whose middle is not */
            break;
        bool inside = next > a && next < b;
        s = inside ? next : 0.5 * (a + b);
        if (b - a <= THUD_TOL_PEAK_PLACE || (inside && f->third * moved * moved <= THUD_TOL_PEAK_PLACE * fabs(v[2])))
            break;
        thud_poly_value3(f->c, f->n, s, v);
    }
    try_at(f, s);
}

static void largest(struct peak *f, double a, double b, int depth)
{
    double m = 0.5 * (a + b), r = 0.5 * (b - a), v[3];
    thud_poly_value3(f->c, f->n, m, v);
    double rest = f->third * r;
    if (fabs(v[0]) + r * (fabs(v[1]) + r * (0.5 * fabs(v[2]) + rest / 6)) <= f->best)
        return;
    if (fabs(v[1]) > r * (fabs(v[2]) + 0.5 * rest))
        return; /* no extremum inside, and the ends are tried already */
    try_at(f, m);
    if (fabs(v[2]) > rest) {
        extremum(f, a, b, m, v);
        return;
    }
    if (depth == DEPTH_MAX || f->intervals++ > INTERVALS_MAX)
        return;
    largest(f, a, m, depth + 1);
    largest(f, m, b, depth + 1);
}

double thud_poly_peak(const double *c, int n, double s_end, double least, double *where)
{
    if (absolute_sum(c, n) <= least)
        return least;
    struct peak f = {c, n, third_bound(c, n), least, 0, false, 0};
    try_at(&f, 0);
    try_at(&f, s_end);
    if (n > 1 && fabs(c[1]) < slope_bound(c, n)) /* else it rises or falls all the way */
        largest(&f, 0, s_end, 0);
    if (f.found)
        *where = f.where;
    return f.best;
}
