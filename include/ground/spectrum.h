/* Response spectra: the largest response of damped oscillators to a ground motion, free vibration afterwards included.
 */
#pragma once

#include <stddef.h>

#include "ground/record.h"

/* Peaks of one oscillator over the continuous response, between the samples too. */
struct thud_spectrum_point {
    double period_s;
    double displacement_m;    /* Sd, relative to the ground */
    double velocity_mps;      /* Sv, relative to the ground (not the pseudo velocity) */
    double acceleration_mps2; /* Sa, total (not the pseudo acceleration) */
};

/* Computes the response of one oscillator; period 0: rigid. damping in [0, 1), period finite and not negative (asserted). */
struct thud_spectrum_point thud_spectrum_at(const struct thud_record *record, double period_s, double damping);

/* Pseudo spectral acceleration omega^2 Sd at 5 % damping, what ground motions are scaled to; period > 0 (asserted). */
double thud_record_sa(const struct thud_record *record, double period_s);

/* `count` points, periods in geometric steps from `from_s` to `to_s` (count > 1, 0 < from_s < to_s, asserted). */
void thud_spectrum_fill(const struct thud_record *record, double damping, double from_s, double to_s, size_t count,
                        struct thud_spectrum_point *point);
