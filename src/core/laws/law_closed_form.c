#include "core/laws/law_closed_form.h"

#include <math.h>

#include "base/quantity.h"
#include "core/numerics/root.h"

double thud_kelvin_voigt_xi(double e)
{
    double l = log(e);
    return -l / sqrt(THUD_PI * THUD_PI + l * l);
}

/* acos(xi)/sqrt(1 - xi^2), continued through xi = 1: half the contact's duration times omega. */
static double half_angle(double xi)
{
    if (xi < 1)
        return acos(xi) / sqrt((1 - xi) * (1 + xi));
    if (xi > 1)
        return acosh(xi) / sqrt((xi - 1) * (xi + 1));
    return 1;
}

double thud_kelvin_voigt_cut_restitution(double xi)
{
    return exp(-2 * xi * half_angle(xi));
}

static double cut_excess(double xi, const void *decay)
{
    return xi * half_angle(xi) - *(const double *)decay;
}

/* xi half_angle(xi) = decay. It grows from 0 like pi xi/2 and never lies above that; it lies above xi for xi <= 1 and
 * above ln xi beyond, which brackets the root. */
static double xi_of_decay(double decay)
{
    if (decay <= 0)
        return 0;
    return thud_root(cut_excess, &decay, 0.99 * decay * 2 / THUD_PI, decay < 1 ? decay : 1.01 * exp(decay));
}

double thud_kelvin_voigt_cut_xi(double e)
{
    return xi_of_decay(-0.5 * log(e));
}

/* p(y) = y - 1 + exp(-y) without cancellation. On a curve F_A with F = F_A (1 + C v) the energy per mass between rest
 * and speed v, times C^2, is p(y) with C v = exp(-y) - 1: one function serves approach (y < 0) and restitution (y > 0).
 */
static double energy_of(double y)
{
    if (fabs(y) > 0.7)
        return y + expm1(-y);
    double sum = 0;
    for (int k = 19; k >= 2; k--)
        sum = (1 - y * sum) / k;
    /* sum is now 1/2 - y/6 + y^2/24 - ... */
    return y * y * sum;
}

/* y >= 0 with p(y) = energy: Newton on a convex rising function, from above, so it only falls. */
static double energy_inverse(double energy)
{
    double y = energy + sqrt(2 * energy);
    for (int i = 0; i < 60; i++) {
        double slope = -expm1(-y), step = (energy_of(y) - energy) / slope;
        if (!(step > 1e-16 * y))
            break;
        y -= step;
    }
    return y;
}

/* Below this p(y) is y^2/2 to the last bit, and its square root no longer underflows. */
static const double tiny = 1e-100;

double thud_hertz_damp_restitution(double s)
{
    if (s < tiny)
        return 1;
    return -expm1(-energy_inverse(energy_of(-log1p(s)))) / s;
}

/* Energy given back less energy taken, over x^2 so that e near 1 keeps its digits; x = s e. */
static double hertz_damp_excess(double y, const void *context)
{
    double e = *(const double *)context, x = -expm1(-y);
    if (x == 0)
        return 0.5 - 0.5 / (e * e);
    return (energy_of(y) - energy_of(-log1p(x / e))) / (x * x);
}

double thud_hertz_damp_s(double e)
{
    if (e >= 1)
        return 0;
    /* p(y) >= y - 1 and the energy taken is at most s <= 1/e */
    double y = thud_root(hertz_damp_excess, &e, 0, 2 + 1 / e);
    return -expm1(-y) / e;
}

double thud_jankowski_restitution(double xi, double n)
{
    double z = xi * sqrt(2 / (n + 1));
    return exp(-z * half_angle(z));
}

double thud_jankowski_xi(double e, double n)
{
    return xi_of_decay(-log(e)) * sqrt((n + 1) / 2);
}

double thud_jankowski_xi_published(double e)
{
    return 4.5 * sqrt(5.0) * (1 - e * e) / (e * (e * (9 * THUD_PI - 16) + 16));
}

static double rubber_excess(double y, const void *context)
{
    double e = *(const double *)context, x = -expm1(-y);
    if (x == 0)
        return 0.5 - 0.5 / (e * e);
    return energy_of(y) / (x * x) - 0.5 / (e * e);
}

double thud_rubber_cv(double e)
{
    if (e >= 1)
        return 0;
    double y = thud_root(rubber_excess, &e, 0, 2 + 0.5 / (e * e)); /* p(y) >= y - 1, x <= 1 */
    return -expm1(-y) / e;
}

double thud_rubber_restitution(double cv, double ratio)
{
    if (cv < tiny)
        return sqrt(ratio);
    return -expm1(-energy_inverse(0.5 * cv * cv * ratio)) / cv;
}

double thud_rubber_c_paper(double e, double mass_kg, double v_mps)
{
    return 1.55 * (1 - e * e) / (pow(e, 0.7076) * pow(mass_kg, 0.0025) * pow(v_mps, 0.9755));
}

struct thud_rubber_curve thud_rubber_curve(double k, double n, double ultimate_m, double post_yield_npm)
{
    double force = k * pow(ultimate_m, n);
    return (struct thud_rubber_curve){k, n, ultimate_m, post_yield_npm, force, force * ultimate_m / (n + 1)};
}

double thud_rubber_curve_force(const struct thud_rubber_curve *curve, double d_m)
{
    if (d_m <= 0)
        return 0;
    if (d_m <= curve->ultimate_m)
        return curve->k * pow(d_m, curve->n);
    return curve->ultimate_force_n + curve->post_yield_npm * (d_m - curve->ultimate_m);
}

double thud_rubber_curve_energy(const struct thud_rubber_curve *curve, double d_m)
{
    if (d_m <= 0)
        return 0;
    if (d_m <= curve->ultimate_m)
        return curve->k * pow(d_m, curve->n + 1) / (curve->n + 1);
    double y = d_m - curve->ultimate_m;
    return curve->ultimate_energy_j + y * (curve->ultimate_force_n + 0.5 * curve->post_yield_npm * y);
}

double thud_rubber_curve_indentation(const struct thud_rubber_curve *curve, double energy_j)
{
    if (energy_j <= 0)
        return 0;
    if (energy_j <= curve->ultimate_energy_j)
        return pow((curve->n + 1) * energy_j / curve->k, 1 / (curve->n + 1));
    double more = energy_j - curve->ultimate_energy_j, f = curve->ultimate_force_n;
    return curve->ultimate_m + 2 * more / (f + sqrt(f * f + 2 * curve->post_yield_npm * more));
}
