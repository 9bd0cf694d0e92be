/* Floor spectra: what oscillators (equipment, ceilings, pipes) on a building's floors feel, driven by the floors' total
 * acceleration as the run computes it, impacts and impulses included. */
#pragma once

struct thud_floor_spectra_choice {
    int nfloors, nperiods;
    const int *dof;         /* (nfloors) floors, of the model's */
    const double *period_s; /* (nperiods) above 0, ascending */
    double damping;         /* ratio of every oscillator, above 0 and below 1 */
};
