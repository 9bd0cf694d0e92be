/* The run from inside: for the files of core only. */
#pragma once

#include "core/contact/contact.h"
#include "core/motion/free_vibration.h"
#include "core/numerics/tolerance.h"
#include "core/observe/observe_floors.h"
#include "core/observe/observe_history.h"
#include "core/observe/observe_peaks.h"
#include "core/observe/observe_steps.h"
#include "core/observe/observe_sums.h"
#include "core/run/early_end.h"
#include "core/run/run.h"

enum { THUD_OBSERVERS_MAX = 10 };

/* Endless events at one instant: see run.c. */
struct thud_progress {
    int stalls;  /* events in a row without progress in time */
    int passes;  /* moments passed over in a row because their events had no end */
    long events; /* since from_s, in at most a part of the run's duration */
    double from_s;
};

/* Of a ground motion. */
struct thud_run_ground {
    double peak_mps2, speed_mps;
    double impulse_mps; /* the integral of |a_g| */
};

struct thud_run {
    struct thud_run_options options;
    struct thud_run_ground ground;
    const struct thud_method *method;
    void *own;                                  /* of the method */
    struct thud_free_vibration *free_vibration; /* NULL: the method goes through the contact-free response too */
    const struct thud_early_end *early_end;     /* of the motion without contact; NULL: not known */

    struct thud_blocks memory; /* of all below whose size the model decides */
    struct thud_state state;
    struct thud_segment seg; /* proposed */
    double *end;             /* (2 x nmodes) q, q' where it is taken to */
    struct thud_progress progress;
    bool done;

    struct thud_listener {
        const struct thud_observer *table;
        void *own;
    } observer[THUD_OBSERVERS_MAX]; /* (observers), asked in this order */
    int observers;
    struct thud_contact_work *contact_work; /* (ncontacts) over the segment at hand */
    struct thud_contact_log log;
    struct thud_peaks peaks;
    struct thud_sums sums;
    struct thud_history_rows rows;
    struct thud_ledger ledger;
    struct thud_floor_oscillators floors;
    struct thud_steps steps;

    struct thud_work work;
    struct thud_result result;
};

/* A segment in run->seg, and how far it is taken. */
struct thud_proposal {
    double s, limit; /* of the event or, without one, the limit; and that of the next kink or the end */
    int contact;     /* row of the event: contact or storey; -1 where there is none */
    enum thud_event event;
    int order;             /* suppressed coefficients of its guard */
    bool switched, passed; /* ends with the event; or at a moment whose events have no end */
};

/* run_propose.c: the next segment up to its first event. Errors: as the method's step; THUD_DIVERGED. */
enum thud_status thud_run_propose(struct thud_run *run, struct thud_proposal *p, struct thud_error *err);
/* Counts the steps that stay at one moment, or so near to it that no motion lies between, and passes that moment over
 * where its events have no end. Errors: THUD_DIVERGED (it has been passed over too often; or so many events crowd in a
 * short time that the run would not end). */
enum thud_status thud_run_watch_progress(struct thud_run *run, struct thud_proposal *p, struct thud_error *err);
/* run_setup.c: thud_run_create, with what depends on the record or on the structures alone taken from a run of the same;
 * like: NULL, or any run. */
enum thud_status thud_run_create_like(const struct thud_model *model, const struct thud_record *record,
                                      const struct thud_run_options *options, const struct thud_run *like,
                                      struct thud_run **out, struct thud_error *err);
/* Fills the results that are made from others. */
void thud_run_finish(struct thud_run *run);

/* run_limits.c: what a run may ask for, and what its response may not pass. */
enum thud_status thud_run_check_options(const struct thud_run_options *options, const struct thud_record *record,
                                        struct thud_error *err);
/* Whether the motion is slow enough for series: THUD_INPUT where fast modes would take endlessly many. */
enum thud_status thud_run_check_rates(const struct thud_run *run, struct thud_error *err);
/* Fills run->ground, and the scales of run->state from the first state. */
void thud_run_set_scales(struct thud_run *run, const struct thud_run *like);
/* Fills run->state.energy_most. */
void thud_run_set_bound(struct thud_run *run);
/* At the end: THUD_DIVERGED when more of the energy is unaccounted for than may be. */
enum thud_status thud_run_judge(const struct thud_run *run, struct thud_error *err);
/* THUD_DIVERGED when this state (q, qd) holds far more energy than can ever have come in. */
enum thud_status thud_run_check_state(struct thud_run *run, const double *q, const double *qd, struct thud_error *err);

/* run_collapse.c: notes that the storey below a floor has collapsed, which ends the run; and looks for one by the peaks
 * of methods that do not locate events. */
void thud_run_collapse(struct thud_run *run, int dof);
void thud_run_watch_collapse(struct thud_run *run);

/* run_contact_free.c: free vibration over a block of intervals, or early to the end; *passed: whether anything was.
 * Errors: those of the observers. Takes the series that were made from *budget: one is as much work as a segment. */
enum thud_status thud_run_contact_free(struct thud_run *run, long *budget, bool *passed, struct thud_error *err);

/* Adds an observer, whose own stays the caller's. */
void thud_run_observe(struct thud_run *run, const struct thud_observer *table, void *own);
