#include "ground/intensity.h"

#include <math.h>

#include "base/quantity.h"
#include "ground/oscillator.h"
#include "ground/spectrum.h"

/* The displacement at the end over the largest one. Of 22 processed records of 1940 to 2019 the integral of the
 * acceleration ends below 0.46, of those whose baseline is off or whose noise was left in at 1.00. */
static const double drift_share = 0.5;

static double mean_of(const struct thud_record *record)
{
    double sum = 0;
    for (size_t i = 0; i < record->samples; i++)
        sum += record->a_mps2[i];
    return record->samples ? sum / (double)record->samples : 0;
}

/* Velocity and displacement behind one step, the acceleration going from a0 to a1. */
static void advance(double a0, double a1, double dt, double *v, double *u)
{
    *u += dt * *v + dt * dt * (2 * a0 + a1) / 6;
    *v += dt * (a0 + a1) / 2;
}

void thud_record_integrate(const struct thud_record *record, double *velocity, double *displacement)
{
    double mean = mean_of(record), v = 0, u = 0;
    for (size_t i = 0; i < record->samples; i++) {
        if (i)
            advance(record->a_mps2[i - 1] - mean, record->a_mps2[i] - mean, record->dt_s, &v, &u);
        if (velocity)
            velocity[i] = v;
        if (displacement)
            displacement[i] = u;
    }
}

static void take_peak(double value, double time, double *peak, double *when)
{
    if (fabs(value) > *peak) {
        *peak = fabs(value);
        *when = time;
    }
}

/* Velocity and displacement at time t within a step: v0 + a0 t + s t^2/2 and its integral, s the slope of a. */
static void motion_within(double a0, double slope, double t, double *v, double *u)
{
    *u += t * (*v + t * (a0 / 2 + t * slope / 6));
    *v += t * (a0 + t * slope / 2);
}

/* Peaks inside a step of the straight line from a0 to a1: of the velocity where the line crosses zero, of the
 * displacement where the velocity does. */
static void peaks_within(double a0, double a1, double from, double dt, double v0, double u0, struct thud_intensity *out)
{
    const double slope = (a1 - a0) / dt;
    double time[3] = {-a0 / slope, NAN, NAN};
    if (fabs(slope) * dt > 1e-9 * fabs(a0)) {
        const double root = sqrt(a0 * a0 - 2 * slope * v0), q = -(a0 + copysign(root, a0));
        time[1] = q / slope;
        time[2] = 2 * v0 / q;
    } else {
        time[1] = -v0 / a0;
    }
    for (int k = 0; k < 3; k++) {
        if (!(time[k] > 0 && time[k] < dt))
            continue;
        double v = v0, u = u0;
        motion_within(a0, slope, time[k], &v, &u);
        take_peak(v, from + time[k], &out->pgv_mps, &out->pgv_time_s);
        take_peak(u, from + time[k], &out->pgd_m, &out->pgd_time_s);
    }
}

static void peaks(const struct thud_record *record, struct thud_intensity *out)
{
    double mean = mean_of(record), v = 0, u = 0, dt = record->dt_s;
    out->mean_mps2 = mean;
    for (size_t i = 0; i < record->samples; i++) {
        double t = (double)i * dt;
        if (i) {
            const double before = record->a_mps2[i - 1] - mean, after = record->a_mps2[i] - mean;
            peaks_within(before, after, t - dt, dt, v, u, out);
            advance(before, after, dt, &v, &u);
        }
        take_peak(record->a_mps2[i], t, &out->pga_mps2, &out->pga_time_s);
        take_peak(v, t, &out->pgv_mps, &out->pgv_time_s);
        take_peak(u, t, &out->pgd_m, &out->pgd_time_s);
    }
    out->end_m = u;
    out->drifts = fabs(u) > drift_share * out->pgd_m;
}

/* Integral of a^2 over the first part u (0 to 1) of a step. */
static double square_part(double a0, double a1, double dt, double u)
{
    double d = a1 - a0;
    return dt * u * (a0 * a0 + u * (a0 * d + u * d * d / 3));
}

static double abs_step(double a0, double a1, double dt)
{
    if ((a0 < 0) == (a1 < 0) || a0 == 0 || a1 == 0)
        return dt * (fabs(a0) + fabs(a1)) / 2;
    return dt * (a0 * a0 + a1 * a1) / (2 * fabs(a1 - a0)); /* two triangles */
}

/* When the integral of a^2 reaches `target`: within the step by bisection of its growing cubic. */
static double time_of(const struct thud_record *record, double target)
{
    double sum = 0;
    for (size_t i = 0; i + 1 < record->samples; i++) {
        double a0 = record->a_mps2[i], a1 = record->a_mps2[i + 1], dt = record->dt_s;
        double part = square_part(a0, a1, dt, 1);
        if (part > 0 && sum + part >= target) {
            double left = 0, right = 1;
            for (int k = 0; k < 50; k++) {
                double u = 0.5 * (left + right);
                if (sum + square_part(a0, a1, dt, u) < target)
                    left = u;
                else
                    right = u;
            }
            return ((double)i + 0.5 * (left + right)) * dt;
        }
        sum += part;
    }
    return (double)(record->samples - 1) * record->dt_s; /* rounding only */
}

static void energy(const struct thud_record *record, struct thud_intensity *out)
{
    double sum = 0, trapezoids = 0;
    for (size_t i = 0; i + 1 < record->samples; i++) {
        const double before = record->a_mps2[i], after = record->a_mps2[i + 1];
        trapezoids += record->dt_s * (before * before + after * after) / 2;
        sum += square_part(record->a_mps2[i], record->a_mps2[i + 1], record->dt_s, 1);
        out->cav_mps += abs_step(record->a_mps2[i], record->a_mps2[i + 1], record->dt_s);
    }
    out->arias_mps = THUD_PI / (2 * THUD_GRAVITY) * sum;
    out->arias_trapezoid_mps = THUD_PI / (2 * THUD_GRAVITY) * trapezoids;
    out->t5_s = out->t75_s = out->t95_s = out->d5_95_s = out->d5_75_s = NAN;
    if (!(sum > 0))
        return;
    out->t5_s = time_of(record, 0.05 * sum);
    out->t75_s = time_of(record, 0.75 * sum);
    out->t95_s = time_of(record, 0.95 * sum);
    out->d5_75_s = out->t75_s - out->t5_s;
    out->d5_95_s = out->t95_s - out->t5_s;
}

/* Where |a| crosses the threshold within a step, as a part of it from its start. */
static double crossing(double a0, double a1, double threshold)
{
    double to = copysign(threshold, fabs(a1) > fabs(a0) ? a1 : a0);
    return (to - a0) / (a1 - a0);
}

static double bracketed(const struct thud_record *record)
{
    double threshold = THUD_BRACKET_PER_MILLE / 1000.0 * THUD_GRAVITY, first = NAN, last = NAN;
    for (size_t i = 0; i < record->samples; i++) {
        double a = record->a_mps2[i];
        if (fabs(a) < threshold)
            continue;
        double start = (double)i, end = (double)i;
        if (i > 0 && fabs(record->a_mps2[i - 1]) < threshold)
            start += crossing(record->a_mps2[i - 1], a, threshold) - 1;
        if (i + 1 < record->samples && fabs(record->a_mps2[i + 1]) < threshold)
            end += crossing(a, record->a_mps2[i + 1], threshold);
        if (isnan(first))
            first = start;
        last = end;
    }
    return isnan(first) ? 0 : (last - first) * record->dt_s;
}

/* ---- predominant period ---- */

#define SHORTEST 0.02 /* s, range of the search */
#define LONGEST  10.0
enum { BATCH = 4, COARSE = 63 * BATCH, NEAR = 4 };

/* Largest total acceleration of four oscillators side by side, looked at `finest` radians or less apart: enough to tell
 * which is the largest, and a long record takes well under a second. */
static void four_peaks(const struct thud_record *record, const double *period, double finest, double *peak)
{
    double damping = 0.05, shortest = fmin(fmin(period[0], period[1]), fmin(period[2], period[3]));
    int parts = (int)fmin(ceil(2 * THUD_PI / shortest * record->dt_s / finest), 1000);
    struct thud_oscillator o[BATCH];
    double x[BATCH] = {0}, v[BATCH] = {0}, c[BATCH], k[BATCH];
    for (int l = 0; l < BATCH; l++) {
        double omega = 2 * THUD_PI / period[l];
        thud_oscillator_init(&o[l], omega, damping, record->dt_s / parts);
        c[l] = 2 * damping * omega;
        k[l] = omega * omega;
        peak[l] = 0;
    }
    for (size_t i = 0; i + 1 < record->samples; i++) {
        double before = record->a_mps2[i], slope = (record->a_mps2[i + 1] - before) / parts;
        for (int part = 1; part <= parts; part++) {
            double after = record->a_mps2[i] + slope * part;
            for (int l = 0; l < BATCH; l++) {
                double x0 = x[l], v0 = v[l];
                x[l] = o[l].xx * x0 + o[l].xv * v0 + o[l].xa0 * before + o[l].xa1 * after;
                v[l] = o[l].vx * x0 + o[l].vv * v0 + o[l].va0 * before + o[l].va1 * after;
                double total = fabs(c[l] * v[l] + k[l] * x[l]);
                peak[l] = total > peak[l] ? total : peak[l];
            }
            before = after;
        }
    }
}

/* The largest exact Sa among periods around `about`, in NEAR geometric steps to either side within a factor `ratio`. */
static void refine(const struct thud_record *record, double about, double ratio, double *largest, double *best)
{
    for (int i = -NEAR; i <= NEAR; i++) {
        const double period = fmin(fmax(about * pow(ratio, (double)i / NEAR), SHORTEST), LONGEST);
        const double sa = thud_spectrum_at(record, period, 0.05).acceleration_mps2;
        if (sa > *largest) {
            *largest = sa;
            *best = period;
        }
    }
}

/* Scans the spectrum in steps of a quarter of the half-power bandwidth of 5 % damping (2.5 %), then refines every
 * maximum of the scan that its error can hide: 3 % by sampling half a radian apart, 3 % by half a step of period.
 * NaN: nothing moves. */
double thud_record_predominant_period(const struct thud_record *record)
{
    const double ratio = pow(LONGEST / SHORTEST, 1.0 / (COARSE - 1)), hidden = 0.94;
    double period[COARSE], peak[COARSE + 2] = {0}, scanned = 0, largest = 0, best = NAN;
    for (int i = 0; i < COARSE; i += BATCH) {
        for (int l = 0; l < BATCH; l++)
            period[i + l] = SHORTEST * pow(ratio, i + l);
        four_peaks(record, period + i, 0.5, peak + 1 + i);
    }
    for (int i = 1; i <= COARSE; i++)
        scanned = fmax(scanned, peak[i]);
    for (int i = 1; i <= COARSE && scanned > 0; i++)
        if (peak[i] >= hidden * scanned && peak[i] >= peak[i - 1] && peak[i] >= peak[i + 1])
            refine(record, period[i - 1], ratio, &largest, &best);
    return best;
}

struct thud_intensity thud_intensity_of(const struct thud_record *record)
{
    struct thud_intensity out = {0};
    if (record->samples == 0)
        return out;
    out.duration_s = (double)(record->samples - 1) * record->dt_s;
    peaks(record, &out);
    energy(record, &out);
    out.bracketed_s = bracketed(record);
    return out;
}
