/* Intensity measures of a ground motion. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "ground/record.h"

/* Intensity measures. Integrals are exact for an acceleration linear between the samples. Velocity and displacement are
 * those of the acceleration less its mean, from rest; their peaks are those of the continuous motions. NaN: not defined
 * (a record of zeros has no significant duration). */
struct thud_intensity {
    double pga_mps2, pga_time_s;
    double pgv_mps, pgv_time_s;
    double pgd_m, pgd_time_s;
    double mean_mps2;           /* of the acceleration, removed for velocity and displacement */
    double end_m;               /* displacement at the last sample */
    bool drifts;                /* the displacement is due to a baseline error or noise, not to the ground */
    double arias_mps;           /* pi/(2 g) times the integral of a^2 */
    double arias_trapezoid_mps; /* by the trapezoidal rule on a^2, as in the flatfiles of PEER; larger */
    double d5_95_s, d5_75_s;    /* between 5 % and 95 % (75 %) of the Arias intensity */
    double t5_s, t75_s, t95_s;  /* when they are reached */
    double cav_mps;             /* integral of |a| */
    double bracketed_s;         /* from the first to the last time that |a| is 0.05 g; 0 if it never is */
    double duration_s;          /* (samples - 1) dt */
};

enum { THUD_BRACKET_PER_MILLE = 50 }; /* threshold of the bracketed duration in g/1000 */

struct thud_intensity thud_intensity_of(const struct thud_record *record);

/* Returns the period (s, 0.02 to 10) of the largest total acceleration at 5 % damping, to 1 %; NaN for a record of
 * zeros. It takes ten times as long as all the rest. */
double thud_record_predominant_period(const struct thud_record *record);

/* Computes velocity and displacement at the samples (each `samples` long, either may be NULL) of the acceleration less
 * its mean, from rest. */
void thud_record_integrate(const struct thud_record *record, double *velocity_mps, double *displacement_m);
