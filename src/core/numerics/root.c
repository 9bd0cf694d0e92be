#include "core/numerics/root.h"

#include <assert.h>
#include <float.h>
#include <math.h>

/* Secant through the bracket's ends, with the standing end's value halved when it stands twice (Illinois), and
 * bisection whenever two such steps have not halved the bracket: never slower than three times bisection. */
double thud_root(double (*f)(double x, const void *context), const void *context, double lo, double hi)
{
    double f_lo = f(lo, context), f_hi = f(hi, context);
    assert(!(f_lo > 0 && f_hi > 0) && !(f_lo < 0 && f_hi < 0));
    if (f_lo == 0)
        return lo;
    double width = hi - lo; /* when last checked */
    int standing = 0;       /* which end stood in the last step: -1 lo, 1 hi */
    for (int i = 0; f_hi != 0 && hi - lo > 2 * DBL_EPSILON * fmax(fabs(lo), fabs(hi)) + DBL_MIN; i++) {
        double x = lo + (hi - lo) * (f_lo / (f_lo - f_hi));
        if (i % 3 == 2) {
            if (hi - lo > 0.5 * width)
                x = 0.5 * (lo + hi);
            width = hi - lo;
        }
        x = fmin(fmax(x, nextafter(lo, hi)), nextafter(hi, lo)); /* a step of 0 would never end */
        double fx = f(x, context);
        if (fx != 0 && (fx < 0) == (f_lo < 0)) {
            lo = x;
            f_lo = fx;
            if (standing == 1)
                f_hi *= 0.5;
            standing = 1;
        } else {
            hi = x;
            f_hi = fx;
            if (standing == -1)
                f_lo *= 0.5;
            standing = -1;
        }
    }
    return hi;
}
