/* Butterworth filters by the bilinear transform (Oppenheim and Schafer, Discrete-Time Signal Processing, ch. 7), as
 * sections of second order.
 *
 * The poles of the analog low pass of order n, corner 1 rad/s, lie on the unit circle:
 *
 *     p(k) = exp(i pi (2 k + n + 1) / (2 n)),  k = 0 .. n - 1
 *
 * With w = tan(pi f dt), the frequency of the analog filter that the bilinear transform s = (1 - 1/z) / (1 + 1/z) turns
 * into f, the high pass puts w1/s in place of s, the band pass (s^2 + w0^2) / (B s) with w0^2 = w1 w2 and B = w2 - w1.
 * The squared gain of one pass is therefore
 *
 *     |H|^2 = 1 / (1 + W^(2 n)),  W = w1/w or (w^2 - w0^2) / (B w),
 *
 * and that is the gain of two passes, which leave the phase as it was.
 *
 * A filter that runs backwards responds before the motion begins. Zeros are put at both ends, enough for the answer
 * to die away, and stay there: without them the motion would not begin at rest, and its displacement would drift again
 * (Boore 2005, BSSA 95, 745-750; 1.5 n / f1 at each end, where the band is not narrower than that). */
#include "ground/record_filter.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"
#include "ground/record_edit.h"

enum { SECTIONS_MAX = THUD_FILTER_ORDER_MAX };
static const double pad_periods = 1.5;  /* of the lowest frequency, for each order */
static const double samples_most = 2e8; /* with the zeros at both ends */

/* y = b0 x + s1, s1 = b1 x - a1 y + s2, s2 = b2 x - a2 y */
struct section {
    double b0, b1, b2, a1, a2;
};

/* (c2 s^2 + c1 s) / (s^2 + d1 s + d0), c2 or c1 zero. */
static struct section of_analog(double c2, double c1, double d1, double d0)
{
    double a0 = 1.0 + d1 + d0;
    return (struct section){(c2 + c1) / a0, -2.0 * c2 / a0, (c2 - c1) / a0, (2.0 * d0 - 2.0) / a0,
                            (1.0 - d1 + d0) / a0};
}

/* c s / (s + d). */
static struct section of_first_order(double c, double d)
{
    double a0 = 1.0 + d;
    return (struct section){c / a0, -c / a0, 0.0, (d - 1.0) / a0, 0.0};
}

static int high_pass(double w1, int order, struct section *section)
{
    int n = 0;
    for (int k = 0; k < order / 2; k++) { /* a pair each: 2 Re p = 2 cos of the pole's angle */
        double twice = 2.0 * cos(THUD_PI * (2.0 * k + order + 1.0) / (2.0 * order));
        section[n++] = of_analog(1.0, 0.0, -twice * w1, w1 * w1);
    }
    if (order % 2)
        section[n++] = of_first_order(1.0, w1);
    return n;
}

/* Each pole p of the low pass gives the two roots of s^2 - B p s + w0^2: with their conjugates a section each. */
static int band_pass(double w1, double w2, int order, struct section *section)
{
    double band = w2 - w1, centre2 = w1 * w2;
    int n = 0;
    for (int k = 0; k < order / 2; k++) {
        double angle = THUD_PI * (2.0 * k + order + 1.0) / (2.0 * order);
        double re = 0.5 * band * cos(angle), im = 0.5 * band * sin(angle); /* B p / 2 */
        double dre = re * re - im * im - centre2, dim = 2.0 * re * im, size = hypot(dre, dim);
        double root_re = sqrt(fmax(0.0, 0.5 * (size + dre))),
               root_im = copysign(sqrt(fmax(0.0, 0.5 * (size - dre))), dim);
        for (int side = -1; side <= 1; side += 2) {
            double r = re + side * root_re, i = im + side * root_im;
            section[n++] = of_analog(0.0, band, -2.0 * r, r * r + i * i);
        }
    }
    if (order % 2) /* p = -1 */
        section[n++] = of_analog(0.0, band, band, centre2);
    return n;
}

static void pass(const struct section *section, int sections, double *x, size_t n)
{
    for (int k = 0; k < sections; k++) {
        struct section c = section[k];
        double s1 = 0.0, s2 = 0.0;
        for (size_t i = 0; i < n; i++) {
            double in = x[i], out = c.b0 * in + s1;
            s1 = c.b1 * in - c.a1 * out + s2;
            s2 = c.b2 * in - c.a2 * out;
            x[i] = out;
        }
    }
}

static void turn(double *x, size_t n)
{
    for (size_t i = 0; i < n / 2; i++) {
        double kept = x[i];
        x[i] = x[n - 1 - i];
        x[n - 1 - i] = kept;
    }
}

static enum thud_status check(const struct thud_record_filter *filter, double dt, struct thud_error *err)
{
    double most = 0.5 / dt;
    if (filter->order < 1 || filter->order > THUD_FILTER_ORDER_MAX) {
        thud_error_set(err, THUD_INPUT, "a filter of order %d", filter->order);
        thud_error_allow(err, "1 to %d", THUD_FILTER_ORDER_MAX);
        return THUD_INPUT;
    }
    bool band = !isnan(filter->high_hz);
    if (filter->low_hz > 0.0 && filter->low_hz < most &&
        (!band || (filter->high_hz > filter->low_hz && filter->high_hz < most)))
        return THUD_OK;
    if (band)
        thud_error_set(err, THUD_INPUT, "a band from %g Hz to %g Hz", filter->low_hz, filter->high_hz);
    else
        thud_error_set(err, THUD_INPUT, "a corner of %g Hz", filter->low_hz);
    thud_error_allow(err, "above 0%s and below %g Hz, half of the samples in a second", band ? ", in this order," : "",
                     most);
    return THUD_INPUT;
}

double thud_record_filter_pad(const struct thud_record_filter *filter, double dt)
{
    if (isnan(filter->low_hz))
        return 0.0;
    double band = filter->high_hz - filter->low_hz; /* a narrow one rings for longer than its lowest period */
    double slowest = band < filter->low_hz ? band : filter->low_hz;
    return ceil(pad_periods * filter->order / (slowest * dt)) * dt;
}

enum thud_status thud_record_filter_apply(const struct thud_record *record, const struct thud_record_filter *filter,
                                          struct thud_record **out, struct thud_error *err)
{
    *out = NULL;
    double dt = record->dt_s;
    enum thud_status status = check(filter, dt, err);
    if (status != THUD_OK)
        return status;
    struct section section[SECTIONS_MAX];
    double w1 = tan(THUD_PI * filter->low_hz * dt);
    int sections = isnan(filter->high_hz) ? high_pass(w1, filter->order, section)
                                          : band_pass(w1, tan(THUD_PI * filter->high_hz * dt), filter->order, section);
    double pad = rint(thud_record_filter_pad(filter, dt) / dt), all = 2.0 * pad + (double)record->samples;
    if (!(all <= samples_most))
        return thud_error_refuse(err, THUD_INPUT, NULL, "a higher one, or longer steps",
                                 "a corner of %g Hz needs %.3g zeros at each end", filter->low_hz, pad);
    size_t n = (size_t)all;
    double *x = calloc(n, sizeof *x);
    if (!x)
        return thud_error_set(err, THUD_MEMORY, "out of memory for %zu samples", n);
    memcpy(x + (size_t)pad, record->a_mps2, record->samples * sizeof *x);
    for (int way = 0; way < 2; way++) {
        pass(section, sections, x, n);
        turn(x, n);
    }
    status = thud_record_like(record, x, n, dt, out, err);
    free(x);
    return status;
}
