/* Observer of a run: peaks of the continuous history, read from the polynomials of a segment before it is committed.
 *
 * What is looked at is kept small by bounds. With S = sqrt(sum of q'^2 + omega^2 q^2) of a structure, dS/dt is at most
 * the size of the forces in modal coordinates, and a floor's value is at most S times a number of its own (Cauchy and
 * Schwarz): where that is below the peaks so far, no floor is looked at. Within a segment, a value lies above those at
 * the two ends by at most h^2/8 times a bound of its second derivative. */
#ifndef THUD_CORE_OBSERVE_PEAKS_H
#define THUD_CORE_OBSERVE_PEAKS_H

#include "core/contact_log.h"
#include "core/segment.h"

enum { THUD_FLOOR_DISPLACEMENT, THUD_FLOOR_VELOCITY, THUD_FLOOR_ACCELERATION, THUD_FLOOR_DRIFT, THUD_FLOOR_QUANTITIES };

struct thud_peaks {
    struct thud_result *result; /* whose peaks rise */
    double *mode_max;     /* (2 x nmodes): largest part of each mode in a floor's displacement, and in its drift */
    double *per_speed;    /* (quantities x ndof): bound of a floor's value for a structure's S of 1 */
    double *ends;         /* (9 x nmodes) modal values at the two ends of a segment, and margins between */
    double *acceleration; /* (terms x nmodes, and nmodes more): total modal acceleration of a segment */
    double *block;
};

/* Errors: THUD_MEMORY; nothing stays allocated then. */
enum thud_status thud_peaks_init(struct thud_peaks *peaks, const struct thud_state *state, struct thud_result *result,
                                 struct thud_error *err);
void thud_peaks_clear(struct thud_peaks *peaks);
/* Raises the peaks by the segment up to s; those of contacts also in the log's impacts that go on. */
void thud_peaks_segment(struct thud_peaks *peaks, const struct thud_state *state, const struct thud_segment *seg,
                        struct thud_contact_log *log, double s);
struct thud_peak *thud_floor_peak(struct thud_result *result, int structure, int floor, int quantity);
/* The modes' total acceleration q'' + gamma a_g of the segment into peaks->acceleration: before thud_peaks_floor of an
 * acceleration. */
void thud_peaks_prepare(struct thud_peaks *peaks, const struct thud_state *state, const struct thud_segment *seg);
/* Peak of one quantity of one floor over the segment up to s. */
void thud_peaks_floor(struct thud_peaks *peaks, const struct thud_state *state, const struct thud_segment *seg,
                      int structure, int floor, int quantity, double s);

/* What a structure can come to: S, and contact force on it (by mass^(1/2)). */
struct thud_response_bound {
    double speed, force;
};
bool thud_response_bound_structure(struct thud_peaks *peaks, const struct thud_model *model, int structure,
                                   const struct thud_response_bound *reach);

#endif
