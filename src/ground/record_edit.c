#include "ground/record_edit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"

enum thud_status thud_record_trim(struct thud_record *record, double from, double to, struct thud_error *err)
{
    double dt = record->dt_s, end = (double)(record->samples - 1);
    /* a time typed with its decimals selects the sample it means */
    double first = isnan(from) ? 0 : fmax(0, ceil(from / dt - 1e-6)),
           last = isnan(to) ? end : fmin(end, floor(to / dt + 1e-6));
    if (record->samples < 2 || !(last >= first + 1)) {
        thud_error_set(err, THUD_INPUT, "fewer than two samples lie between %g s and %g s", isnan(from) ? 0 : from,
                       isnan(to) ? end * dt : to);
        thud_error_allow(err, "the record lasts %g s", end * dt);
        return THUD_INPUT;
    }
    record->samples = (size_t)(last - first) + 1;
    memmove(record->a_mps2, record->a_mps2 + (size_t)first, record->samples * sizeof *record->a_mps2);
    return THUD_OK;
}

/* Polynomials that are orthonormal over n samples at x = -(n-1)/2 ... (n-1)/2 (Gram's), by their recurrence
 *
 *     r(k+1) q(k+1) = x q(k) - r(k) q(k-1),  r(k)^2 = k^2 (n^2 - k^2) / (4 (4 k^2 - 1)),  q(0) = 1/sqrt(n). */
static double recurrence(double n, int k)
{
    double k2 = (double)k * k;
    return sqrt(k2 * (n * n - k2) / (4 * (4 * k2 - 1)));
}

/* q(degree) at x. */
static double gram(double n, int degree, double x)
{
    double before = 0, now = 1 / sqrt(n);
    for (int k = 0; k < degree; k++) {
        double next = (x * now - (k ? recurrence(n, k) * before : 0)) / recurrence(n, k + 1);
        before = now;
        now = next;
    }
    return now;
}

/* The mean and, for degree 1, the straight line: as below, with sums of whole numbers. */
static void take_line(struct thud_record *record, int degree)
{
    double n = (double)record->samples, middle = (n - 1) / 2, sum = 0, moment = 0;
    for (size_t i = 0; i < record->samples; i++) {
        sum += record->a_mps2[i];
        moment += ((double)i - middle) * record->a_mps2[i];
    }
    double mean = sum / n, slope = 0;
    if (degree > 0 && record->samples > 1)
        slope = moment / (n * (n * n - 1) / 12); /* the sum of (i - middle)^2 */
    for (size_t i = 0; i < record->samples; i++)
        record->a_mps2[i] -= mean + slope * ((double)i - middle);
}

void thud_record_baseline(struct thud_record *record, int degree)
{
    double n = (double)record->samples, middle = (n - 1) / 2;
    if (degree < 0 || record->samples == 0)
        return;
    take_line(record, degree);
    for (int k = 2; k <= degree && (size_t)k < record->samples; k++) {
        double part = 0;
        for (size_t i = 0; i < record->samples; i++)
            part += record->a_mps2[i] * gram(n, k, (double)i - middle);
        for (size_t i = 0; i < record->samples; i++)
            record->a_mps2[i] -= part * gram(n, k, (double)i - middle);
    }
}

enum thud_status thud_record_taper(struct thud_record *record, double taper, struct thud_error *err)
{
    double duration = (double)(record->samples - 1) * record->dt_s;
    if (!(taper >= 0) || taper > duration / 2 * (1 + 1e-9)) {
        thud_error_set(err, THUD_INPUT, "%g s at each end cannot be tapered", taper);
        thud_error_allow(err, "0 to %g s, half of the motion", duration / 2);
        return THUD_INPUT;
    }
    for (size_t i = 0; i < record->samples && (double)i * record->dt_s < taper; i++) {
        double weight = 0.5 * (1 - cos(THUD_PI * (double)i * record->dt_s / taper));
        record->a_mps2[i] *= weight;
        record->a_mps2[record->samples - 1 - i] *= weight;
    }
    return THUD_OK;
}

enum thud_status thud_record_like(const struct thud_record *record, const double *a, size_t samples, double dt,
                                  struct thud_record **out, struct thud_error *err)
{
    enum thud_status status = thud_record_create(a, samples, dt, out, err);
    if (status)
        return status;
    struct thud_record kept = *record; /* its texts */
    kept.dt_s = dt;
    kept.samples = samples;
    kept.a_mps2 = (*out)->a_mps2;
    **out = kept;
    return THUD_OK;
}

/* The record at `position` samples from its start. */
static double between(const struct thud_record *record, double position)
{
    size_t i = (size_t)position;
    if (i + 1 >= record->samples)
        return record->a_mps2[record->samples - 1];
    double part = position - (double)i;
    return part == 0 ? record->a_mps2[i] : (1 - part) * record->a_mps2[i] + part * record->a_mps2[i + 1];
}

enum thud_status thud_record_resample(const struct thud_record *record, double dt, struct thud_record **out,
                                      struct thud_error *err)
{
    *out = NULL;
    double duration = (double)(record->samples - 1) * record->dt_s;
    if (!(dt > 0) || dt > duration || duration / dt > 1e8) {
        thud_error_set(err, THUD_INPUT, "cannot be resampled at %g s", dt);
        thud_error_allow(err, "above 0, at most %g s, and at most 1e8 samples", duration);
        return THUD_INPUT;
    }
    size_t samples = (size_t)floor(duration / dt + 1e-6) + 1;
    double *a = malloc(samples * sizeof *a);
    if (!a)
        return thud_error_set(err, THUD_MEMORY, "out of memory for %zu samples", samples);
    double ratio = dt / record->dt_s;
    for (size_t i = 0; i < samples; i++) {
        double position = (double)i * ratio, whole = rint(position);
        a[i] = between(record, fabs(position - whole) < 1e-9 * fmax(1, whole) ? whole : position);
    }
    enum thud_status status = thud_record_like(record, a, samples, dt, out, err);
    free(a);
    return status;
}

/* Weights of the samples up to `half` away, whose sum is 1. */
static void sinc_weights(double spacing, int half, double *weight)
{
    double sum = 0;
    for (int k = 0; k <= half; k++) {
        const double x = THUD_PI * k / spacing, at = THUD_PI * (k + half + 1) / (half + 1);
        weight[k] = (k > 0 ? sin(x) / x : 1) * (0.42 - 0.5 * cos(at) + 0.08 * cos(2 * at));
        sum += (k > 0 ? 2 : 1) * weight[k];
    }
    for (int k = 0; k <= half; k++)
        weight[k] /= sum;
}

enum thud_status thud_record_low_pass(struct thud_record *record, double spacing, int every, struct thud_error *err)
{
    static const int crossings = 16; /* of 0 by the sinc to either side */
    const int half = (int)(crossings * spacing) - 1;
    const size_t step = (size_t)every, n = (record->samples - 1) / step + 1;
    if (n < 2)
        return thud_error_refuse(err, THUD_INPUT, NULL, "fewer, or a longer part", "every %d of %zu samples leave one",
                                 every, record->samples);
    double *weight = malloc(((size_t)half + 1 + n) * sizeof *weight), *kept = weight + half + 1;
    if (!weight)
        return thud_error_set(err, THUD_MEMORY, "out of memory for %zu samples", n);
    sinc_weights(spacing, half, weight);
    for (size_t i = 0; i < n; i++) {
        const size_t at = i * step;
        kept[i] = weight[0] * record->a_mps2[at];
        for (size_t k = 1; k <= (size_t)half; k++)
            kept[i] += weight[k] * ((at >= k ? record->a_mps2[at - k] : 0) +
                                    (at + k < record->samples ? record->a_mps2[at + k] : 0));
    }
    memcpy(record->a_mps2, kept, n * sizeof *kept);
    record->samples = n;
    record->dt_s *= every;
    free(weight);
    return THUD_OK;
}
