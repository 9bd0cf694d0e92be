#include "core/poly.h"

#include <math.h>
#include <stdbool.h>

enum { DEPTH_MAX = 48, INTERVALS_MAX = 4096 };

double thud_poly_value(const double *c, int n, double s)
{
    double v = 0;
    for (int k = n - 1; k >= 0; k--)
        v = v * s + c[k];
    return v;
}

void thud_poly_value3(const double *c, int n, double s, double out[3])
{
    double v = 0, d = 0, dd = 0;
    for (int k = n - 1; k >= 0; k--) {
        dd = dd * s + d;
        d = d * s + v;
        v = v * s + c[k];
    }
    out[0] = v;
    out[1] = d;
    out[2] = 2 * dd;
}

/* Bound of |p'''| on [0, 1]. */
static double third_bound(const double *c, int n)
{
    double b = 0;
    for (int k = 3; k < n; k++)
        b += (double)(k * (k - 1) * (k - 2)) * fabs(c[k]);
    return b;
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

/* Root of a function that rises on [a, b] with f(a) <= 0 < f(b): Newton kept inside a shrinking bracket. */
static double rising_root(const struct search *f, double a, double b)
{
    double s = 0.5 * (a + b);
    for (int i = 0; i < 80; i++) {
        double v[3];
        thud_poly_value3(f->c, f->n, s, v);
        double p = f->sign * v[0], d = f->sign * v[1];
        if (p > 0)
            b = s;
        else
            a = s;
        double next = s - p / d;
        if (!(next > a && next < b))
            next = 0.5 * (a + b);
        if (fabs(next - s) <= 4e-16 * fabs(next) || b - a <= 4e-16 * b)
            return next;
        s = next;
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
        return value(f, a) > 0 ? a : rising_root(f, a, b);
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
    double reach = 0; /* how far it may come from its start, s_end being at most 1 */
    for (int k = 1; k < n; k++)
        reach += fabs(c[k]);
    if (sign * c[0] + reach <= noise)
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
    double v = fabs(thud_poly_value(f->c, f->n, s));
    if (v > f->best) {
        f->best = v;
        f->where = s;
        f->found = true;
    }
}

/* p' is monotone on [a, b]: its one root, if it is there. */
static void extremum(struct peak *f, double a, double b)
{
    double va[3], vb[3];
    thud_poly_value3(f->c, f->n, a, va);
    thud_poly_value3(f->c, f->n, b, vb);
    if ((va[1] > 0) == (vb[1] > 0))
        return;
    bool rising = vb[1] > va[1];
    double s = 0.5 * (a + b);
    for (int i = 0; i < 60; i++) {
        double v[3];
        thud_poly_value3(f->c, f->n, s, v);
        if ((v[1] > 0) == rising)
            b = s;
        else
            a = s;
        double next = s - v[1] / v[2];
        if (!(next > a && next < b))
            next = 0.5 * (a + b);
        double moved = fabs(next - s);
        s = next;
        if (moved <= 1e-12)
            break;
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
        extremum(f, a, b);
        return;
    }
    if (depth == DEPTH_MAX || f->intervals++ > INTERVALS_MAX)
        return;
    largest(f, a, m, depth + 1);
    largest(f, m, b, depth + 1);
}

double thud_poly_peak(const double *c, int n, double s_end, double least, double *where)
{
    double sum = 0;
    for (int k = 0; k < n; k++)
        sum += fabs(c[k]);
    if (sum <= least)
        return least;
    struct peak f = {c, n, third_bound(c, n), least, 0, false, 0};
    try_at(&f, 0);
    try_at(&f, s_end);
    largest(&f, 0, s_end, 0);
    if (f.found)
        *where = f.where;
    return f.best;
}
