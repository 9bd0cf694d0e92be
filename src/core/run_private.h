/* The run from inside: for the files of core only. */
#ifndef THUD_CORE_RUN_PRIVATE_H
#define THUD_CORE_RUN_PRIVATE_H

#include "core/contact.h"
#include "core/observe_peaks.h"
#include "core/run.h"
#include "core/segment.h"
#include "core/tolerance.h"

struct thud_free_vibration;
struct thud_early_end;
struct thud_ledger {
    double initial_j, input_j, viscous_j, contact_work_j, largest_j;
    double balanced_s; /* the last moment looked at when no more was unaccounted for than may be */
    bool closed;       /* nothing more comes: the balance is that of an earlier moment */
};

/* Events at one moment without end: see run.c. */
struct thud_progress {
    int stalls; /* events in a row without progress in time */
    int passes; /* moments passed over in a row because their events had no end */
};

struct thud_run {
    struct thud_run_options options;
    const struct thud_method *method;
    void *own; /* of the method */
    struct thud_state state;
    struct thud_segment seg; /* proposed */
    struct thud_progress progress;
    double speed_bound; /* sqrt(2 E) that initial motion and ground can give at most, in modal coordinates */
    bool done;
    bool switched; /* a contact has, at the end of the last segment: rows stand on both sides of the jump */

    struct thud_peaks peaks;
    double *scratch; /* (THUD_SEGMENT_TERMS x nmodes + 8 x nmodes) for one function at a time */
    struct thud_contact_log log;
    struct thud_ledger ledger;
    struct thud_history history;
    double next_row_s;
    double close_rows_until_s;                /* rows stand closer for a while after a contact */
    bool row_waits;                           /* see history.c */
    const struct thud_early_end *early_end;   /* of the motion without contact; NULL: not known */
    struct thud_early_end *early_end_to_fill; /* in the run without contact; NULL: not asked for */
    double *relative_m; /* (ncontacts) largest so far of left less right displacement; NULL: not asked for */
    struct thud_free_vibration *free_vibration;

    struct thud_work work;
    struct thud_result result;
    void *result_block;
};

/* A segment in run->seg, and how far it is taken. */
struct thud_proposal {
    double s, limit; /* of the event or, without one, the limit; and that of the next kink or the end */
    int contact;     /* of the event, -1 where there is none */
    enum thud_event event;
    bool switched, passed; /* ends with the event; or at a moment whose events have no end */
};

/* run_propose.c: the next segment up to its first event. Errors: as the method's step; THUD_DIVERGED. */
enum thud_status thud_run_propose(struct thud_run *run, struct thud_proposal *p, struct thud_error *err);
/* Counts the steps that stay at one moment, or so near to it that no motion lies between, and passes that moment over
 * where its events have no end. Errors: THUD_DIVERGED (it has been passed over too often). */
enum thud_status thud_run_watch_progress(struct thud_run *run, struct thud_proposal *p, struct thud_error *err);
/* run_setup.c: fills the results that are made from others. */
void thud_run_finish(struct thud_run *run);

/* run_limits.c: what a run may ask for, and what its response may not pass. */
enum thud_status thud_run_check_options(const struct thud_run_options *options, const struct thud_record *record,
                                        struct thud_error *err);
/* Fills the scales of run->state from the first state. */
void thud_run_set_scales(struct thud_run *run);
/* Fills run->speed_bound. */
void thud_run_set_bound(struct thud_run *run);
/* THUD_DIVERGED when this state (q, qd) holds far more energy than can ever have come in. */
enum thud_status thud_run_check_state(struct thud_run *run, const double *q, const double *qd, struct thud_error *err);

/* ledger.c, history.c: what is read from a segment before it is committed up to s. */
void thud_ledger_start(struct thud_run *run);
void thud_ledger_segment(struct thud_run *run, double s);
struct thud_ledger thud_ledger_at(struct thud_run *run, double s); /* as it will be at s; books nothing */
/* What the structures hold now, as the ledger has it, may be the most so far: the energy that its error is a part of.
 */
void thud_ledger_mark(struct thud_run *run);
/* Books what impulses have lost since the last time. */
void thud_ledger_impulses(struct thud_run *run);
void thud_ledger_finish(struct thud_run *run);
/* Looks at the balance now and then, so that an error can say when it was lost. */
void thud_ledger_watch(struct thud_run *run);
/* The balance of this moment stands for the end: the run leaves out the rest, in which nothing new happens. */
void thud_ledger_close(struct thud_run *run);
/* At the end: THUD_DIVERGED when more of the energy is unaccounted for than may be. */
enum thud_status thud_ledger_judge(const struct thud_run *run, struct thud_error *err);
/* Rows of the segment up to s, whose peaks are read; switches: a contact will, or may, switch there. */
enum thud_status thud_history_segment(struct thud_run *run, double s, bool switches, struct thud_error *err);
enum thud_status thud_history_start(struct thud_run *run, struct thud_error *err);

/* free_vibration.c: free flight over whole grid intervals by recurrence. */
enum thud_status thud_free_vibration_create(struct thud_run *run, struct thud_error *err);
void thud_free_vibration_free(struct thud_free_vibration *flight);
/* Reads the peaks that are only known to be there: before a result is. */
void thud_free_vibration_read_deferred(struct thud_run *run);
/* Goes over a block of grid intervals, up to the first one in which a contact closes; *passed: how many. Errors:
 * THUD_MEMORY. */
enum thud_status thud_free_vibration_go(struct thud_run *run, int *passed, struct thud_error *err);

#endif
