/* What two free bodies do in one collision under the Kelvin-Voigt law, in closed form: for tests of what a run gives. `xi`
 * damping ratio, v approach velocity at contact onset, m effective mass. */
#pragma once

/* Restitution of the classical law, whose force may pull (xi < 1). */
double kelvin_voigt_restitution(double xi);

/* One collision under the law that is cut where its force reaches 0. */
struct two_body_collision {
    double force_n;       /* largest; at contact onset where xi >= 1/2 */
    double indentation_m; /* largest */
    double duration_s;
    double restitution;
    double residual_m; /* indentation left where the force reaches 0 */
};
struct two_body_collision kelvin_voigt_cut_collision(double stiffness_npm, double xi, double mass_kg, double v_mps);
