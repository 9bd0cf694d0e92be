/* Closed-form solutions of the impact laws for one collision of two free bodies. `xi` damping ratio, `e` restitution, v
 * approach velocity at contact onset, m effective mass m1 m2/(m1 + m2). No function here fails; arguments outside the
 * stated range are programming errors. */
#pragma once

/* Kelvin-Voigt, F = k d + c v with c = 2 xi sqrt(k m). */

/* Classical (the force may pull, contact ends at d = 0): xi = -ln e / sqrt(pi^2 + ln^2 e), the paper's eq. (3).
 * 0 < e <= 1. */
double thud_kelvin_voigt_xi(double e);
/* Cut where the force reaches 0: e = exp(-2 xi acos(xi)/sqrt(1 - xi^2)), with acosh and sqrt(xi^2 - 1) for xi > 1 and
 * e^-2 at 1, xi >= 0; and back, 0 < e <= 1. */
double thud_kelvin_voigt_cut_restitution(double xi);
double thud_kelvin_voigt_cut_xi(double e);

/* Damping in both phases, F = k d^n (1 + s v/v0), any n: e solves s (1 + e) = ln((1 + s)/(1 - s e)), s >= 0; and back,
 * 0 < e <= 1. */
double thud_hertz_damp_restitution(double s);
double thud_hertz_damp_s(double e);

/* Jankowski, approach k d^n + 2 xi sqrt(k d^(n-1) m) v, restitution k d^n. With w^2/2 the elastic energy per mass the
 * approach is a linear damped oscillator in w, so e^2 is the cut Kelvin-Voigt law's e at xi sqrt(2/(n + 1)); and back.
 */
double thud_jankowski_restitution(double xi, double n);
double thud_jankowski_xi(double e, double n);
/* The published fit for n = 3/2: (9 sqrt5/2)(1 - e^2)/(e (e (9 pi - 16) + 16)). */
double thud_jankowski_xi_published(double e);

/* Damping in restitution only, F_R = F (1 + C v): `cv` is C times the approach velocity. */

/* cv that gives e exactly where restitution follows the approach curve: cv e = x solves -x - ln(1 - x) = x^2/(2 e^2). 0
 * < e <= 1. */
double thud_rubber_cv(double e);
/* e for cv >= 0, where restitution starts with `ratio` of the energy stored in approach (1 on the same curve). */
double thud_rubber_restitution(double cv, double ratio);
/* C of the paper's eq. (7), s/m; m in kg, v in m/s (> 0). */
double thud_rubber_c_paper(double e, double mass_kg, double v_mps);

/* The bumper's approach curve, eq. (4): k d^n up to the ultimate compression, then a line of slope post_yield. */
struct thud_rubber_curve {
    double k, n; /* N/m^n */
    double ultimate_m, post_yield_npm;
    double ultimate_force_n, ultimate_energy_j;
};
struct thud_rubber_curve thud_rubber_curve(double k, double n, double ultimate_m, double post_yield_npm);
double thud_rubber_curve_force(const struct thud_rubber_curve *curve, double d_m);
double thud_rubber_curve_energy(const struct thud_rubber_curve *curve, double d_m);
/* Indentation at which the curve holds the energy: the largest one of a collision with m v^2/2 = energy. */
double thud_rubber_curve_indentation(const struct thud_rubber_curve *curve, double energy_j);
