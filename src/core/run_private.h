/* The run from inside: for the files of core only. */
#ifndef THUD_CORE_RUN_PRIVATE_H
#define THUD_CORE_RUN_PRIVATE_H

#include "core/run.h"
#include "core/segment.h"
#include "core/tolerance.h"

enum thud_contact_mode {
    THUD_OPEN,   /* no contact */
    THUD_CLOSED, /* in contact, force by the law's branch */
    THUD_SLACK,  /* indented, but the law's force would pull and is cut at 0 */
    THUD_STUCK   /* held with d' = 0 by the force that keeps it so */
};

/* Why a function that an event watches starts at 0: that many of its lowest Taylor coefficients are 0 but for rounding.
 */
struct thud_zeros {
    int indentation, rate, knee, force;
};

struct thud_contact_state {
    enum thud_contact_mode mode;
    enum thud_phase phase;
    bool past_knee;
    struct thud_branch branch;
    struct thud_law_memory memory;
    struct thud_zeros zeros;
    double knee_m;              /* INFINITY where there is none */
    double hold_low, hold_high; /* STUCK: the force interval in which it holds */
    double expected_force_n;    /* of this contact, from its closing velocity: scale of the error measure */
    double residual_m;
    struct thud_impact impact; /* the one going on */
};

struct thud_flight;
struct thud_horizon;
struct thud_ledger {
    double initial_j, input_j, viscous_j, contact_work_j, largest_j;
};

struct thud_run {
    const struct thud_model *model;
    const struct thud_record *record;
    struct thud_run_options options;
    const struct thud_method *method;
    void *method_state;

    /* Time is grid * grid_dt_s + offset_s; the ground motion has its kinks at the grid. */
    double grid_dt_s, offset_s, end_s;
    long grid;
    bool done, failed;
    bool locates;       /* events are located; else contacts catch up at the ends of steps */
    double step_cap_s;  /* a stepping method's next step is to be no longer */
    double speed_bound; /* sqrt(2 E) that initial motion and ground can give at most, in modal coordinates */
    double ground_mps2; /* peak of the ground motion: what the structures feel anyway */
    double
        speed_mps;  /* largest first speed of a floor and largest speed of the ground: what others are small against */
    double *q, *qd; /* (nmodes) modal state */
    struct thud_contact_state *contact;
    int nactive; /* contacts CLOSED or STUCK */
    int stalls;  /* events in a row without progress in time */
    int passes;  /* moments passed over in a row because their events had no end */

    struct thud_segment seg;
    double *indentation;  /* (ncontacts x THUD_SEGMENT_TERMS): polynomials of the segment, scaled like it */
    int *known;           /* (ncontacts) its lowest orders that are no motion; -1 where it is not read yet */
    double *scratch;      /* (THUD_SEGMENT_TERMS x nmodes + 8 x nmodes) for one function at a time */
    double fastest_radps; /* of the model */
    double *shape;        /* (2 x nmodes): largest part of each mode in a floor's displacement, and in its drift */
    double *most;         /* (quantities x ndof): of a floor's value, for a structure's sqrt(2 energy) */
    double *ends;         /* (9 x nmodes) modal values at the two ends of a segment, and margins between */
    double *reach;        /* (nmodes) how far each mode may move in the segment */
    double *hold;         /* (ncontacts x ncontacts) */
    double *force_now;    /* (ncontacts) */
    double *collide;      /* of contact_impulse.c */
    int *set_now;         /* (ncontacts) */
    const struct thud_horizon *horizon;   /* of the motion without contact; NULL: not known */
    struct thud_horizon *horizon_to_fill; /* in the run without contact; NULL: not asked for */
    double *closing; /* (ncontacts) largest so far of left less right displacement; NULL: not asked for */
    struct thud_flight *flight;
    double *block; /* everything above that is an array of doubles */

    struct thud_ledger ledger;
    struct thud_result result;
    void *result_block;
    struct thud_impact *impacts;
    int nimpacts, impacts_capacity;
    struct thud_history history;
    double next_row_s;
    double close_rows_until_s; /* rows stand closer for a while after a contact */
    bool switched;             /* a contact has, at the end of the last segment: rows stand on both sides of the jump */
    bool row_waits;            /* the last row stays only if one has */
};

static inline double thud_run_now(const struct thud_run *run)
{
    return (double)run->grid * run->grid_dt_s + run->offset_s;
}

/* Time to the next kink of the ground motion or the end. */
double thud_run_remaining(const struct thud_run *run);
/* Ground acceleration at the two ends of grid interval i. */
static inline void thud_run_ground(const struct thud_run *run, long i, double *a0, double *a1)
{
    const struct thud_record *r = run->record;
    bool inside = r && (size_t)(i + 1) < r->samples;
    *a0 = inside ? r->a_mps2[i] : 0;
    *a1 = inside ? r->a_mps2[i + 1] : 0;
}

/* Values of contact c's two floors from modal values; 0 for a wall. */
void thud_model_sides(const struct thud_model *model, int c, const double *modal, double *left, double *right);
/* Left floor's value minus the right floor's, from modal values. */
double thud_model_gap_sum(const struct thud_model *model, int c, const double *modal);
/* A floor's value from modal values. */
double thud_model_floor(const struct thud_model *model, int dof, const double *modal);

static inline double thud_run_shift(const struct thud_run *run, int c)
{
    return run->model->contact[c].clearance_m + run->contact[c].residual_m;
}
static inline bool thud_contact_acts(const struct thud_contact_state *s)
{
    return s->mode == THUD_CLOSED || s->mode == THUD_STUCK;
}

/* contact.c */
void thud_contact_start(struct thud_run *run);
/* The run has gone on: nothing is known to be 0 any more, but for neighbours that touch and have not moved at all. */
void thud_contact_moved(struct thud_run *run);
/* Indentation polynomials of all contacts into run->indentation; earliest event in [0, s_end] of the segment: its s
 * (INFINITY: none), the contact and what it is. */
double thud_contact_next_event(struct thud_run *run, double s_end, int *contact, int *event);
/* Reads the indentation of contact c from the segment into run->indentation, once; how many of its lowest orders are no
 * motion (see thud_segment_indentation). */
int thud_contact_polynomial(struct thud_run *run, int c);
/* The segment has changed: nothing of it is read yet. */
static inline void thud_contact_forget(struct thud_run *run)
{
    for (int c = 0; c < run->model->ncontacts; c++)
        run->known[c] = -1;
}
/* Acts on an event at the run's state (already committed). */
enum thud_status thud_contact_switch(struct thud_run *run, int contact, int event, struct thud_error *err);
/* contact_catch_up.c, for runs that do not locate: the indentation polynomials of the segment that will be read; what
 * the committed state shows is acted on; whether the segment holds a force of contact c. */
void thud_contact_read(struct thud_run *run);
bool thud_contact_felt(const struct thud_run *run, int c);
enum thud_status thud_contact_catch_up(struct thud_run *run, bool *switched, struct thud_error *err);
/* Force of contact c (cut at 0 where the law does not pull) at indentation d and rate v, by its present branch. */
double thud_contact_force(const struct thud_run *run, int c, double d, double v);

/* contact_forces.c: at the run's state */
double thud_contact_indentation(const struct thud_run *run, int c);
double thud_contact_rate(const struct thud_run *run, int c);
/* Forces of all contacts into force (ncontacts); that of STUCK ones from the condition d'' = 0. */
void thud_contact_forces(const struct thud_run *run, double *force);
/* Second rate of the indentation of contact c under these forces. */
double thud_contact_acceleration(const struct thud_run *run, int c, const double *force);
/* More than rounding makes of the second rate of an indentation that is 0. */
static inline double thud_contact_rounding(const struct thud_run *run)
{
    return THUD_TOL_ACCELERATION * (run->ground_mps2 + run->speed_mps * run->fastest_radps);
}
/* Second rate of the modal coordinates without contact forces, out (nmodes). */
void thud_model_acceleration(const struct thud_model *model, const double *q, const double *qd, double ground,
                             double *out);
/* From that to the second rate with these contact forces. */
void thud_model_push(const struct thud_model *model, const double *force, double *qdd);
/* Fills the forces of the STUCK contacts from d'' = 0, given the accelerations without contact forces and the other
 * contacts' forces. `free` may be run->scratch, whose next ncontacts values are used. */
void thud_contact_hold(const struct thud_run *run, const double *free, double *force);
/* contact_impulse.c: impulses of all stereomechanical contacts that touch now. */
enum thud_status thud_contact_impulse(struct thud_run *run, int contact, struct thud_error *err);

/* run_limits.c: what a run may ask for, and what its response may not pass. */
enum thud_status thud_run_check_options(const struct thud_run_options *options, const struct thud_record *record,
                                        struct thud_error *err);
/* The step of a fixed-step method that was given none: a twentieth of the shortest period, of a mode or of a contact at
 * a closing of 1 m/s, and not above the record's step. */
double thud_run_default_step(const struct thud_run *run);
/* Fills run->ground_mps2 and run->speed_mps, from the first state. */
void thud_run_set_scales(struct thud_run *run);
/* Fills run->speed_bound. */
void thud_run_set_bound(struct thud_run *run);
/* THUD_DIVERGED when this state (q, qd) holds far more energy than can ever have come in. */
enum thud_status thud_run_check_state(struct thud_run *run, const double *q, const double *qd, struct thud_error *err);

/* THUD_DIVERGED: contacts hold or collide at once whose forces the modes that stay do not tell apart. */
enum thud_status thud_run_too_few_modes(const struct thud_run *run, struct thud_error *err);

/* peaks.c, ledger.c, history.c: what is read from a segment before it is committed up to s. */
void thud_peaks_start(struct thud_run *run);
void thud_peaks_segment(struct thud_run *run, double s);
enum { THUD_FLOOR_DISPLACEMENT, THUD_FLOOR_VELOCITY, THUD_FLOOR_ACCELERATION, THUD_FLOOR_DRIFT, THUD_FLOOR_QUANTITIES };
struct thud_peak *thud_floor_peak(struct thud_run *run, int structure, int floor, int quantity);
/* The modes' total acceleration q'' + gamma a_g of the segment into run->scratch, (terms - 2 x nmodes): before
 * thud_peaks_floor. */
void thud_peaks_prepare(struct thud_run *run);
/* Peak of one quantity of one floor over the segment up to s. */
void thud_peaks_floor(struct thud_run *run, int structure, int floor, int quantity, double s);
/* peaks_reach.c: fills run->most. */
void thud_reach_start(struct thud_run *run);
/* What a structure can come to: modal speed sqrt(2 energy), and contact force on it (by mass^(1/2)). */
struct thud_reach {
    double speed, force;
};
/* In the segment up to s; without bound for methods whose steps do not keep to the equations of motion. */
struct thud_reach thud_reach_segment(const struct thud_run *run, int structure, double s);
/* Whether a floor, and whether any floor of the structure, may then pass a peak. */
bool thud_reach_floor(const struct thud_run *run, int structure, int floor, const struct thud_reach *reach);
bool thud_reach_structure(const struct thud_run *run, int structure, const struct thud_reach *reach);
void thud_ledger_start(struct thud_run *run);
void thud_ledger_segment(struct thud_run *run, double s);
struct thud_ledger thud_ledger_at(struct thud_run *run, double s); /* as it will be at s; books nothing */
/* What the structures hold now, as the ledger has it, may be the most so far: the energy that its error is a part of.
 */
void thud_ledger_mark(struct thud_run *run);
void thud_ledger_finish(struct thud_run *run);
double thud_run_kinetic(const struct thud_run *run);
double thud_run_strain(const struct thud_run *run);
/* Rows of the segment up to s, whose peaks are read; switches: a contact will, or may, switch there. */
enum thud_status thud_history_segment(struct thud_run *run, double s, bool switches, struct thud_error *err);
enum thud_status thud_history_start(struct thud_run *run, struct thud_error *err);
enum thud_status thud_impacts_add(struct thud_run *run, const struct thud_impact *impact, struct thud_error *err);

/* flight.c: free flight over whole grid intervals by recurrence. */
enum thud_status thud_flight_create(struct thud_run *run, struct thud_error *err);
void thud_flight_free(struct thud_flight *flight);
/* Reads the peaks that are only known to be there: before a result is. */
void thud_flight_settle(struct thud_run *run);
/* Goes over a block of grid intervals, up to the first one in which a contact closes; *passed: how many. Errors:
 * THUD_MEMORY. */
enum thud_status thud_flight_go(struct thud_run *run, int *passed, struct thud_error *err);

#endif
