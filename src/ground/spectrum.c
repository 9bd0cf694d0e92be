#include "ground/spectrum.h"
#include "base/quantity.h"

#include <assert.h>
#include <math.h>
#include <stdbool.h>

#include "ground/oscillator.h"

/* A quantity with its first two derivatives. */
struct jet {
    double y, d, s;
};

/* What is watched at an instant: displacement, velocity, total acceleration. */
struct instant {
    struct jet of[3];
};

static struct instant look(const struct thud_oscillator *o, double a, double slope, double x, double v)
{
    double w = o->omega_radps, c = 2 * o->damping * w, k = w * w;
    double acc = -a - c * v - k * x;        /* x'' */
    double jerk = -slope - c * acc - k * v; /* x''' */
    return (struct instant){{{x, v, acc}, {v, acc, jerk}, {-c * v - k * x, -c * acc - k * v, -c * jerk - k * acc}}};
}

/* Largest |y| inside a step of length h, taken as the polynomial of fifth degree through both ends' jets. The slope
 * changes its sign there: bisection cannot miss it. */
static double inner_peak(struct jet a, struct jet b, double h)
{
    double d0 = a.d * h, s0 = a.s * h * h, d1 = b.d * h, s1 = b.s * h * h, rise = b.y - a.y;
    double c3 = 10 * rise - 6 * d0 - 4 * d1 - 1.5 * s0 + 0.5 * s1;
    double c4 = -15 * rise + 8 * d0 + 7 * d1 + 1.5 * s0 - s1;
    double c5 = 6 * rise - 3 * (d0 + d1) - 0.5 * (s0 - s1);
    double left = 0, right = 1, u = 0;
    for (int i = 0; i < 45; i++) {
        u = 0.5 * (left + right);
        double slope = d0 + u * (s0 + u * (3 * c3 + u * (4 * c4 + u * 5 * c5)));
        if ((slope < 0) == (d0 < 0))
            left = u;
        else
            right = u;
    }
    return fabs(a.y + u * (d0 + u * (0.5 * s0 + u * (c3 + u * (c4 + u * c5)))));
}

static void watch(double peak[3], const struct instant *from, const struct instant *to, double h)
{
    for (int i = 0; i < 3; i++) {
        struct jet a = from->of[i], b = to->of[i];
        double ends = fmax(fabs(a.y), fabs(b.y));
        peak[i] = fmax(peak[i], ends);
        bool turns = (a.d < 0) != (b.d < 0);
        if (turns && ends + h * fmax(fabs(a.d), fabs(b.d)) > peak[i])
            peak[i] = fmax(peak[i], inner_peak(a, b, h));
    }
}

/* One step of the record, in `parts` equal parts (the oscillator is made for a part). */
static void step(const struct thud_oscillator *o, int parts, double a0, double a1, double *x, double *v, double peak[3])
{
    double h = o->dt_s, slope = (a1 - a0) / (h * parts);
    struct instant from = look(o, a0, slope, *x, *v);
    for (int k = 1; k <= parts; k++) {
        double before = a0 + (a1 - a0) * (k - 1) / parts, after = a0 + (a1 - a0) * k / parts;
        thud_oscillator_step(o, before, after, x, v);
        struct instant to = look(o, after, slope, *x, *v);
        watch(peak, &from, &to, h);
        from = to;
    }
}

/* Within an interval the response is a straight line and an oscillation that decays: at equal phases of its cycles a
 * convex sequence where the oscillation adds to the line. So its largest value lies in the first period or in the last,
 * and those between are passed in closed form. */
static double damped_period(double omega, double damping)
{
    return 2 * THUD_PI / (omega * sqrt(1 - damping * damping));
}

struct thud_spectrum_point thud_spectrum_at(const struct thud_record *record, double period, double damping)
{
    assert(period >= 0 && isfinite(period) && damping >= 0 && damping < 1);
    struct thud_spectrum_point point = {.period_s = period};
    if (period == 0 || record->samples == 0) {
        point.acceleration_mps2 = thud_record_peak(record);
        return point;
    }
    const double omega = 2 * THUD_PI / period, dt = record->dt_s, ends = damped_period(omega, damping);
    const bool skips = 2 * ends < dt;
    const int parts = (int)ceil(omega * (skips ? ends : dt) / 0.2); /* a part is short enough for the polynomial */
    struct thud_oscillator o, middle;
    thud_oscillator_init(&o, omega, damping, (skips ? ends : dt) / parts);
    thud_oscillator_init(&middle, omega, damping, skips ? dt - 2 * ends : dt);
    double x = 0, v = 0, peak[3] = {0, 0, 0};
    for (size_t i = 0; i + 1 < record->samples; i++) {
        const double a0 = record->a_mps2[i], a1 = record->a_mps2[i + 1];
        const double after = a0 + (a1 - a0) * (ends / dt), before = a1 - (a1 - a0) * (ends / dt);
        step(&o, parts, a0, skips ? after : a1, &x, &v, peak);
        if (skips) {
            thud_oscillator_step(&middle, after, before, &x, &v);
            step(&o, parts, before, a1, &x, &v, peak);
        }
    }
    /* left alone, it turns back within one more period */
    thud_oscillator_init(&o, omega, damping, period / 50);
    step(&o, 50, 0, 0, &x, &v, peak);
    point.displacement_m = peak[0];
    point.velocity_mps = peak[1];
    point.acceleration_mps2 = peak[2];
    return point;
}

void thud_spectrum_fill(const struct thud_record *record, double damping, double from, double to, size_t count,
                        struct thud_spectrum_point *point)
{
    assert(count > 1 && from > 0 && to > from);
    for (size_t i = 0; i < count; i++) {
        double part = (double)i / (double)(count - 1);
        double period = i == 0 ? from : i == count - 1 ? to : from * pow(to / from, part);
        point[i] = thud_spectrum_at(record, period, damping);
    }
}

double thud_record_sa(const struct thud_record *record, double period_s)
{
    static const double damping = 0.05;
    double omega = 2 * THUD_PI / period_s;
    assert(period_s > 0);
    return omega * omega * thud_spectrum_at(record, period_s, damping).displacement_m;
}
