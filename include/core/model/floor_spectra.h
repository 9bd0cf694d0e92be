/* Floor response spectra: response of oscillators (equipment, ceilings, pipes) on a building's floors, driven by the
 * computed total floor accelerations, impacts and impulses included. */
#pragma once

struct thud_floor_spectra_choice {
    int nfloors, nperiods;
    const int *dof;         /* (nfloors) floors, of the model's */
    const double *period_s; /* (nperiods) above 0, ascending */
    double damping;         /* ratio of every oscillator, above 0 and below 1 */
};
