/* Floor spectra: what oscillators (equipment, ceilings, pipes) on a building's floors feel, driven by the floors' total
 * acceleration as the run computes it, impacts and impulses included. */
#ifndef THUD_CORE_FLOOR_SPECTRA_H
#define THUD_CORE_FLOOR_SPECTRA_H

struct thud_floor_spectra_choice {
    int nfloors, nperiods;
    const int *dof;         /* (nfloors) floors, of the model's */
    const double *period_s; /* (nperiods) above 0, ascending */
    double damping;         /* ratio of every oscillator, above 0 and below 1 */
};

#endif
