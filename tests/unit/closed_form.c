#include "closed_form.h"

#include <math.h>

#include "base/quantity.h"

double kelvin_voigt_restitution(double xi)
{
    return exp(-THUD_PI * xi / sqrt((1 - xi) * (1 + xi)));
}

/* acos(xi)/sqrt(1 - xi^2), continued through xi = 1: half the contact's duration times omega. */
static double half_angle(double xi)
{
    if (xi == 1)
        return 1;
    return xi < 1 ? acos(xi) / sqrt((1 - xi) * (1 + xi)) : acosh(xi) / sqrt((xi - 1) * (xi + 1));
}

/* With cos(phi) = xi and theta = omega sqrt(1 - xi^2) t every derivative of d adds phi to an angle: d ~ sin(theta), v ~
 * sin(phi - theta), F ~ sin(2 phi - theta), F' ~ -sin(3 phi - theta), each times exp(-xi omega t). Largest d at theta =
 * phi, release at 2 phi, largest F at 3 phi - pi where that is > 0 (xi < 1/2), else at contact onset. */
struct two_body_collision kelvin_voigt_cut_collision(double stiffness_npm, double xi, double mass_kg, double v_mps)
{
    double omega = sqrt(stiffness_npm / mass_kg), b = half_angle(xi);
    struct two_body_collision out;
    out.restitution = exp(-2 * xi * b);
    out.duration_s = 2 * b / omega;
    out.indentation_m = v_mps / omega * exp(-xi * b);
    out.residual_m = 2 * xi * v_mps / omega * out.restitution;
    double force = 2 * xi;
    if (xi < 0.5)
        force = exp(-xi * (3 * b - THUD_PI / sqrt((1 - xi) * (1 + xi))));
    out.force_n = mass_kg * omega * v_mps * force;
    return out;
}
