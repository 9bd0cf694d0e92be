/* Peaks of a run whose events are not located, from the ends of its steps, which are all that such steps know. Most ends
 * are far below the peaks so far: the sizes of the modal values show it, else all floors are compared side by side. */
#pragma once

#include "core/observe/observer.h"

/* Squared sizes of a structure's modal values: omega q, q', and the total accelerations; of quiet ends also the energy sum
 * below which all three are. */
struct thud_end_sizes {
    double strain, kinetic, push, energy;
};

struct thud_end_peaks {
    const double *shape; /* (nmodes x stride) each mode at the floors of its structure */
    const double
        *per_speed; /* (quantities x ndof): bound of a floor's value by the root of the energy sum, no contact */
    int stride;
    double quiet_energy; /* sum of omega^2 q^2 + q'^2 of all structures below which no end without contact has one */
    struct thud_end_sizes *quiet; /* (nstructures) below which a step's end has no new peak; 0: not known */
    double *most;                 /* (nstructures x quantities x stride) peaks so far; INFINITY: none is looked for */
    double *value;                /* (quantities x stride) of a step's end; the ground's stands before them */
};

/* Reads shape and per_speed as long as it lives. Errors: THUD_MEMORY. */
enum thud_status thud_end_peaks_init(struct thud_end_peaks *ends, const struct thud_state *state, const double *shape,
                                     int stride, const double *per_speed, struct thud_error *err);
/* The end of the step o, whose floors' peaks rise in the result. */
void thud_end_peaks_add(struct thud_end_peaks *ends, const struct thud_observation *o, struct thud_result *result);
