#include "core/numerics/poly.h"

#include <assert.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "core/numerics/tolerance.h"
#include "core/numerics/vec.h"

enum { DEPTH_MAX = 48, INTERVALS_MAX = 4096, TERMS_MAX = 40 };

/* The highest even and odd orders, and which even order that is. */
static inline thud_vec2 top_pair(const double *c, int n, int *k)
{
    *k = (n - 1) & ~1;
    return n & 1 ? thud_vec2_set(c[n - 1], 0) : thud_vec2_at(c + n - 2);
}

/* Even and odd orders side by side, each by Horner's scheme in s^2: half as long a way as one scheme in s. */
double thud_poly_value(const double *c, int n, double s)
{
    int k;
    double square = s * s;
    thud_vec2 v = top_pair(c, n, &k);
    for (k -= 2; k >= 0; k -= 2)
        v = v * square + thud_vec2_at(c + k);
    return v[0] + s * v[1];
}

void thud_poly_value3(const double *c, int n, double s, double out[3])
{
    int k;
    double square = s * s;
    thud_vec2 v = top_pair(c, n, &k), d = {0, 0}, dd = {0, 0}; /* d, dd: by s^2, dd halved */
    for (k -= 2; k >= 0; k -= 2) {
        dd = dd * square + d;
        d = d * square + v;
        v = v * square + thud_vec2_at(c + k);
    }
    out[0] = v[0] + s * v[1];
    out[1] = v[1] + 2 * s * (d[0] + s * d[1]);
    out[2] = 2 * d[0] + 6 * s * d[1] + 8 * square * (dd[0] + s * dd[1]);
}

/* Bounds on [0, 1] of how far p'' may be from its value at 0, and of |p'''|. */
static double bend_bound(const double *c, int n, double *third)
{
    thud_vec2 bend = {0, 0}, sum = {0, 0}, k = {3, 4};
    int i = 3;
    for (; i + 2 <= n; i += 2, k += 2) {
        thud_vec2 size = k * (k - 1) * thud_vec2_abs(thud_vec2_at(c + i));
        bend += size;
        sum += (k - 2) * size;
    }
    double last = i < n ? (double)(i * (i - 1)) * fabs(c[i]) : 0;
    *third = thud_vec2_sum(sum) + (double)(i - 2) * last;
    return thud_vec2_sum(bend) + last;
}

double thud_poly_move(const double *c, int n, double *slope)
{
    thud_vec2 move = {0, 0}, by_order = {0, 0}, k = {2, 3};
    int i = 2;
    for (; i + 2 <= n; i += 2, k += 2) {
        thud_vec2 size = thud_vec2_abs(thud_vec2_at(c + i));
        move += size;
        by_order += k * size;
    }
    double last = i < n ? fabs(c[i]) : 0;
    *slope = thud_vec2_sum(by_order) + (double)i * last;
    return thud_vec2_sum(move) + last + (n > 1 ? fabs(c[1]) : 0);
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

/* First s in [a, b] with p(s) > noise, by bisection of the interval. Taylor at the middle, with a bound of its third derivative,
 * decides most pieces at once:
 *   1) p stays below the noise: none;
 *   2) p is above 0 all the way: a;
 *   3) p' is above 0 all the way: at most one root, which is found;
 * and the others are halved, the left half first. So a pair of roots close together is seen, as no look at the ends
 * could. DEPTH_MAX and INTERVALS_MAX end it where p and its bounds are rounding. */
static double first_above(struct search *f, double a, double b, int depth)
{
    double m = 0.5 * (a + b), r = 0.5 * (b - a), v[3];
    thud_poly_value3(f->c, f->n, m, v);
    double p = f->sign * v[0], d = f->sign * v[1], bend = fabs(v[2]), rest = f->third * r;
    double bound = r * (fabs(d) + r * (0.5 * bend + rest / 6));
    if (p + bound <= f->noise)
        return INFINITY;
    if (p - bound > 0)
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

double thud_poly_first_above(const double *c, int n, double s_end, double sign, int suppressed, double noise)
{
    while (n > 1 && (suppressed > 0 || c[0] == 0.0)) { /* p(s)/s has the same sign as p(s) */
        c++;
        n--;
        suppressed--;
        noise = 0;
    }
    if (sign * c[0] > noise)
        return 0;
    double slope, move = thud_poly_move(c, n, &slope); /* s_end is at most 1 */
    if (sign * c[0] + move <= noise)
        return INFINITY;
    if (n > 1 && sign * c[1] <= -slope) /* falls all the way */
        return INFINITY;
    struct search f = {.c = c, .n = n, .sign = sign, .noise = noise};
    bend_bound(c, n, &f.third);
    return first_above(&f, 0, s_end, 0);
}

/* Coefficients of p(s + by) in place of those of p(s). */
static void shift(double *c, int n, double by)
{
    for (int i = 0; i + 1 < n; i++)
        for (int k = n - 2; k >= i; k--)
            c[k] += by * c[k + 1];
}

double thud_poly_above(const double *c, int n, double s_end)
{
    double rest[TERMS_MAX], at = 0, above = 0, sign = 1;
    int suppressed = 0;
    assert(n <= TERMS_MAX);
    memcpy(rest, c, (size_t)n * sizeof *c);
    for (int i = 0; i <= 2 * n && at < s_end; i++, sign = -sign) { /* it changes its sign n - 1 times at most */
        double length = fmin(thud_poly_first_above(rest, n, s_end - at, sign, suppressed, 0), s_end - at);
        above += sign < 0 ? length : 0; /* it was above until here */
        at += length;
        shift(rest, n, length);
        suppressed = suppressed || length > 0;
    }
    return above;
}

/* The largest |p|, and what the coefficients say of it. */
struct peak {
    const double *c;
    int n;
    double third, best, where; /* bound of |p'''| on [0, 1] */
    bool found;
    int intervals;
};

static void raise(struct peak *f, double s, double value)
{
    if (fabs(value) > f->best) {
        f->best = fabs(value);
        f->where = s;
        f->found = true;
    }
}

/* p' is monotone on [a, b], where it has these values at the ends: its one root, if it is there, by Newton's method from
 * where a straight line puts it. A root is known to 1e-12 when the last step's square, times a bound, is that. */
static void extremum(struct peak *f, double a, double b, double slope_a, double slope_b)
{
    if ((slope_a > 0) == (slope_b > 0))
        return;
    bool rising = slope_b > slope_a;
    double s = a + (b - a) * (slope_a / (slope_a - slope_b)), v[3];
    for (int i = 0; i < 60; i++) {
        thud_poly_value3(f->c, f->n, s, v);
        if ((v[1] > 0) == rising)
            b = s;
        else
            a = s;
        double next = s - v[1] / v[2], moved = fabs(next - s);
        if (!(moved > THUD_TOL_PEAK_PLACE)) { /* s is the root, and may be an end of the bracket, whose middle is not */
            raise(f, s, v[0]);
            return;
        }
        bool inside = next > a && next < b;
        s = inside ? next : 0.5 * (a + b);
        if (b - a <= THUD_TOL_PEAK_PLACE || (inside && f->third * moved * moved <= THUD_TOL_PEAK_PLACE * fabs(v[2])))
            break;
    }
    raise(f, s, thud_poly_value(f->c, f->n, s));
}

/* Inside [a, b], whose ends have been tried and where p' has these values. */
static void largest(struct peak *f, double a, double b, double slope_a, double slope_b, int depth)
{
    double m = 0.5 * (a + b), r = 0.5 * (b - a), v[3];
    thud_poly_value3(f->c, f->n, m, v);
    double rest = f->third * r;
    if (fabs(v[0]) + r * (fabs(v[1]) + r * (0.5 * fabs(v[2]) + rest / 6)) <= f->best)
        return;
    if (fabs(v[1]) > r * (fabs(v[2]) + 0.5 * rest))
        return; /* no extremum */
    raise(f, m, v[0]);
    if (fabs(v[2]) > rest) {
        extremum(f, a, b, slope_a, slope_b);
        return;
    }
    if (depth == DEPTH_MAX || f->intervals++ > INTERVALS_MAX)
        return;
    largest(f, a, m, slope_a, v[1], depth + 1);
    largest(f, m, b, v[1], slope_b, depth + 1);
}

/* An extremum may lie inside. */
static void look_inside(struct peak *f, double s_end)
{
    const double *c = f->c;
    double v[3];
    thud_poly_value3(c, f->n, s_end, v);
    double ends = fmax(fabs(c[0]), fabs(v[0])), bend = bend_bound(c, f->n, &f->third), start = 2 * fabs(c[2]);
    raise(f, 0, c[0]);
    raise(f, s_end, v[0]);
    if (ends + s_end * s_end / 8 * (start + bend) <= f->best) /* it lies above its ends by no more */
        return;
    if (start > bend) /* so that p' is monotone */
        extremum(f, 0, s_end, c[1], v[1]);
    else
        largest(f, 0, s_end, c[1], v[1], 0);
}

double thud_poly_peak(const double *c, int n, double s_end, double least, double *where)
{
    double slope, move = thud_poly_move(c, n, &slope);
    if (fabs(c[0]) + move <= least)
        return least;
    struct peak f = {c, n, 0, least, 0, false, 0};
    if (n > 2 && fabs(c[1]) < slope) {
        look_inside(&f, s_end);
    } else { /* it rises or falls all the way */
        raise(&f, 0, c[0]);
        raise(&f, s_end, thud_poly_value(c, n, s_end));
    }
    if (f.found)
        *where = f.where;
    return f.best;
}

void thud_lagrange_coefficients(int n, const double *node, double *out)
{
    for (int i = 0; i < n; i++) {
        double c[16] = {1};
        int degree = 0;
        double scale = 1;
        for (int k = 0; k < n; k++) {
            if (k == i)
                continue;
            degree++;
            for (int m = degree; m >= 0; m--)
                c[m] = (m > 0 ? c[m - 1] : 0) - node[k] * c[m];
            scale *= node[i] - node[k];
        }
        for (int m = 0; m < n; m++)
            out[m * n + i] = c[m] / scale;
    }
}
