#include "core/intensity.h"

#include <math.h>

#include "base/quantity.h"
#include "core/spectrum.h"

#define PI 3.14159265358979323846

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

static void peaks(const struct thud_record *record, struct thud_intensity *out)
{
    double mean = mean_of(record), v = 0, u = 0, dt = record->dt_s;
    for (size_t i = 0; i < record->samples; i++) {
        if (i)
            advance(record->a_mps2[i - 1] - mean, record->a_mps2[i] - mean, dt, &v, &u);
        double t = (double)i * dt;
        take_peak(record->a_mps2[i], t, &out->pga_mps2, &out->pga_time_s);
        take_peak(v, t, &out->pgv_mps, &out->pgv_time_s);
        take_peak(u, t, &out->pgd_m, &out->pgd_time_s);
    }
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
    double sum = 0;
    for (size_t i = 0; i + 1 < record->samples; i++) {
        sum += square_part(record->a_mps2[i], record->a_mps2[i + 1], record->dt_s, 1);
        out->cav_mps += abs_step(record->a_mps2[i], record->a_mps2[i + 1], record->dt_s);
    }
    out->arias_mps = PI / (2 * THUD_GRAVITY) * sum;
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

/* Coarse search over periods, then finer around the best. */
static double predominant(const struct thud_record *record)
{
    enum { COARSE = 121, FINE = 21 };
    double from = 0.02, to = 10, best = NAN, largest = 0;
    for (int pass = 0; pass < 2; pass++) {
        int count = pass ? FINE : COARSE;
        double low = from, high = to;
        for (int i = 0; i < count; i++) {
            double period = low * pow(high / low, (double)i / (count - 1));
            double sa = thud_spectrum_at(record, period, 0.05).acceleration_mps2;
            if (sa > largest) {
                largest = sa;
                best = period;
            }
        }
        double ratio = pow(high / low, 1.0 / (count - 1));
        from = best / ratio;
        to = best * ratio;
        if (isnan(best))
            break;
    }
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
    out.predominant_s = predominant(record);
    return out;
}
