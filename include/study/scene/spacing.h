/* Combination rules of the codes for the gap between neighbours, from their peak displacements at one level. */
#pragma once

/* Returns the sum of the two. */
double thud_spacing_abs(double left_m, double right_m);
/* Returns the square root of the sum of squares. */
double thud_spacing_srss(double left_m, double right_m);
/* Returns the double difference combination sqrt(a^2 + b^2 - 2 rho a b). */
double thud_spacing_ddc(double left_m, double right_m, double correlation);
/* Returns rho of the double difference combination from the first periods and damping ratios (Jeng, Kasai and Maison,
 * "A spectral difference method to estimate building separations to avoid pounding", Earthquake Spectra 8 (1992)
 * 201-223). It is Der Kiureghian's coefficient for two modes under white noise, with r = Tb/Ta:
 *
 *     rho = 8 sqrt(za zb) (zb + za r) r^1.5 / ((1 - r^2)^2 + 4 za zb (1 + r^2) r + 4 (za^2 + zb^2) r^2)
 *
 * 1 for equal undamped periods, 0 for a wall, a free body or unequal undamped ones. */
double thud_spacing_correlation(double left_period_s, double left_damping, double right_period_s, double right_damping);
