/* Observer of a run: peaks of the continuous history, read from the polynomials of a segment before it is committed.
 *
 * What is looked at is kept small by bounds. With S = sqrt(sum of q'^2 + omega^2 q^2) of a structure, dS/dt is at most
 * the size of the forces in modal coordinates, and a floor's value is at most S times a number of its own (Cauchy and
 * Schwarz): where that is below the peaks so far, no floor is looked at. Within a segment, a value lies above those at
 * the two ends by at most h^2/8 times a bound of its second derivative. */
#pragma once

#include "core/observe/end_peaks.h"
#include "core/observe/observer.h"

struct thud_free_vibration;
struct thud_sum;

/* The values of one quantity of one floor, or of a sum over modes, in a block of free vibration. */
struct thud_peak_row {
    int structure, floor, quantity;
    const double *x;
    struct thud_peak *peak;
    double margin;              /* how far it may lie above its ends inside an interval */
    const struct thud_sum *sum; /* NULL: a floor's */
};

struct thud_peaks {
    struct thud_result *result; /* whose peaks rise */
    int stride;                 /* floors of the largest structure, an even number */
    double *per_speed;          /* (quantities x ndof): bound of a floor's value for a structure's S of 1 */
    double *ground;             /* (nstructures) size of a ground acceleration of 1 in modal coordinates */
    double *per_force; /* (nstructures x nrows) and so of a row's force, also on what the structure is tied to */
    double *shape;     /* (2 x nmodes x stride) each mode at the floors of its structure, and their drifts */
    double *as_speed;  /* (nstructures) S that lets accelerations come to no less than a force of 1 does */
    double *quiet;     /* (nstructures) S up to which no peak could be passed when it was last looked at */
    /* A segment, or one structure in it */
    double *push;   /* (rows of the segment) bounds of their forces */
    double *modal;  /* (rows x stride) accelerations of the modes at the two ends, and bounds of derivatives */
    double *value;  /* (rows x stride) of the floors at the two ends */
    double *series; /* (stride x terms) polynomials of the floors' displacements, of those */
    bool *made;     /* (stride) whose has been made */
    double
        *acceleration; /* (terms x nmodes, and nmodes more): total modal acceleration of a stepping method's segment */
    struct thud_end_peaks of_ends; /* where the ends of steps alone are read */
    /* A block */
    struct thud_peak_row *row; /* (quantities x floors of one structure) those that may pass in the block */
    double *upper; /* (rows x intervals of a block) bound of each inside an interval; 0: it need not be read */
    int *due;      /* (rows) those read in one interval */
};

/* Bounds of the row inside the intervals in which it may pass both what it has reached and what it surely reaches in the
 * block, by interval into upper (0 elsewhere); these intervals into list, and how many. */
int thud_peak_row_intervals(const struct thud_model *model, struct thud_free_vibration *f,
                            const struct thud_peak_row *row, int intervals, double *upper, int *list);

extern const struct thud_observer thud_observe_peaks;

/* Errors: THUD_MEMORY. */
enum thud_status thud_peaks_init(struct thud_peaks *peaks, const struct thud_state *state, struct thud_result *result,
                                 struct thud_error *err);
void thud_peaks_clear(struct thud_peaks *peaks);

/* Whether a floor of the structure may pass a peak at this S. */
bool thud_response_bound_structure(struct thud_peaks *peaks, const struct thud_model *model, int structure,
                                   double speed);
