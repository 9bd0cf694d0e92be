/* A damped oscillator under an acceleration that is linear within each step: the exact recurrence (Nigam and Jennings
 * 1969). */
#pragma once

/* x'' + 2 damping omega x' + omega^2 x = -a(t). Coefficients for one step, damping in [0, 1). */
struct thud_oscillator {
    double omega_radps, damping, dt_s;
    double xx, xv, vx, vv;     /* contact-free response of displacement and velocity */
    double xa0, xa1, va0, va1; /* from the acceleration at the step's start and end */
};

/* omega > 0, 0 <= damping < 1, dt > 0 (asserted). Small omega dt is summed as a series: the closed form loses its
 * digits there. */
void thud_oscillator_init(struct thud_oscillator *oscillator, double omega_radps, double damping, double dt_s);
void thud_oscillator_step(const struct thud_oscillator *oscillator, double a0_mps2, double a1_mps2, double *x_m,
                          double *v_mps);
/* Relative acceleration x'' that goes with a state. */
double thud_oscillator_acceleration(const struct thud_oscillator *oscillator, double a_mps2, double x_m, double v_mps);
