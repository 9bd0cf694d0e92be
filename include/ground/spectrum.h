/* Response spectra: peak response of damped oscillators to a ground motion, free vibration afterwards included. */
#pragma once

#include <stddef.h>

#include "ground/record.h"

/* Peaks of one oscillator over its continuous response, also between the samples. */
struct thud_spectrum_point {
    double period_s;
    double displacement_m;    /* Sd, relative to the ground */
    double velocity_mps;      /* Sv, relative to the ground (not the pseudo velocity) */
    double acceleration_mps2; /* Sa, total (not the pseudo acceleration) */
};

/* Computes the response of one oscillator; period 0: rigid. damping in [0, 1), period finite and >= 0 (asserted). */
struct thud_spectrum_point thud_spectrum_at(const struct thud_record *record, double period_s, double damping);

/* Returns the pseudo spectral acceleration omega^2 Sd at 5 % damping, to which ground motions are scaled; period > 0
 * (asserted). */
double thud_record_sa(const struct thud_record *record, double period_s);

/* Computes `count` points, periods in geometric steps from `from_s` to `to_s` (count > 1, 0 < from_s < to_s, asserted).
 */
void thud_spectrum_fill(const struct thud_record *record, double damping, double from_s, double to_s, size_t count,
                        struct thud_spectrum_point *point);
