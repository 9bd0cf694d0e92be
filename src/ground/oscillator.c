#include "ground/oscillator.h"

#include <assert.h>
#include <math.h>

/* State (x, v, load, slope of the load) as a 4 x 4 linear system; column `start` of its exponential over `dt` by
 * Taylor's series. With |omega dt| below 1/2 thirty terms are far more than the digits of a double. */
static void series(double omega, double damping, double dt, const double start[4], double *x, double *v)
{
    double term[4] = {start[0], start[1], start[2], start[3]};
    *x = term[0];
    *v = term[1];
    for (int k = 1; k <= 30; k++) {
        double h = dt / k;
        double next[4] = {h * term[1], h * (-omega * omega * term[0] - 2 * damping * omega * term[1] - term[2]),
                          h * term[3], 0};
        for (int i = 0; i < 4; i++)
            term[i] = next[i];
        *x += term[0];
        *v += term[1];
    }
}

static void closed(double omega, double damping, double dt, const double start[4], double *x, double *v)
{
    /* the particular solution is linear in time: xp = p + q t */
    double w2 = omega * omega;
    double q = -start[3] / w2, p = -(start[2] + 2 * damping * omega * q) / w2;
    double wd = omega * sqrt(1 - damping * damping), decay = exp(-damping * omega * dt);
    double c = cos(wd * dt), s = sin(wd * dt);
    double x0 = start[0] - p, v0 = start[1] - q;
    double b = (v0 + damping * omega * x0) / wd;
    double free_x = decay * (x0 * c + b * s);
    double free_v = decay * ((b * wd - damping * omega * x0) * c - (x0 * wd + damping * omega * b) * s);
    *x = free_x + p + q * dt;
    *v = free_v + q;
}

void thud_oscillator_init(struct thud_oscillator *o, double omega, double damping, double dt)
{
    assert(omega > 0 && damping >= 0 && damping < 1 && dt > 0);
    *o = (struct thud_oscillator){.omega_radps = omega, .damping = damping, .dt_s = dt};
    void (*flow)(double, double, double, const double *, double *, double *) = omega * dt < 0.5 ? series : closed;
    flow(omega, damping, dt, (const double[4]){1, 0, 0, 0}, &o->xx, &o->vx);
    flow(omega, damping, dt, (const double[4]){0, 1, 0, 0}, &o->xv, &o->vv);
    flow(omega, damping, dt, (const double[4]){0, 0, 1, -1 / dt}, &o->xa0, &o->va0);
    flow(omega, damping, dt, (const double[4]){0, 0, 0, 1 / dt}, &o->xa1, &o->va1);
}

void thud_oscillator_step(const struct thud_oscillator *o, double a0, double a1, double *x, double *v)
{
    double x0 = *x, v0 = *v;
    *x = o->xx * x0 + o->xv * v0 + o->xa0 * a0 + o->xa1 * a1;
    *v = o->vx * x0 + o->vv * v0 + o->va0 * a0 + o->va1 * a1;
}

double thud_oscillator_acceleration(const struct thud_oscillator *o, double a, double x, double v)
{
    return -a - 2 * o->damping * o->omega_radps * v - o->omega_radps * o->omega_radps * x;
}
