/* One run of a model under a ground motion by a method. It advances in slices, so it can be cancelled, shown and
 * shared. */
#pragma once

#include <stdbool.h>

#include "base/status.h"
#include "core/methods/method.h"
#include "core/model/floor_spectra.h"
#include "core/model/model.h"
#include "core/model/result.h"
#include "core/model/step_watch.h"
#include "ground/record.h"

struct thud_run;

struct thud_run_options {
    const struct thud_method *method; /* NULL: auto */
    double tolerance;                 /* 1e-6: every peak within 1e-5 of the converged value */
    double step_s;         /* fixed-step methods; NaN: a twentieth of the shortest period of a mode or contact */
    bool locate;           /* fixed-step methods: locate events */
    double tail_s;         /* after the record; without a record, the duration */
    bool keep_impacts;     /* list impacts one by one */
    bool keep_events;      /* list events one by one */
    bool keep_history;     /* record histories */
    double history_step_s; /* between rows outside contacts; 0: the record's step */
    /* > 0: spacing of contact rows next to the peaks, without energies (NaN): for previews, in a third of the time. 0:
     * as fine as the impulse of the forces requires. */
    double history_look_s;
    /* Oscillators on floors; NULL: none. Read only by thud_run_create. Exact method only. */
    const struct thud_floor_spectra_choice *floor_spectra;
    const struct thud_step_watch *watch; /* must outlive the run; NULL: none */
    bool unjudged;                       /* an energy error does not end the run: for studies of how methods fail */
};
void thud_run_options_init(struct thud_run_options *options);

/* Creates a run. `model` and `record` (NULL: no ground motion) must outlive it. Errors: THUD_INPUT, THUD_MEMORY. */
enum thud_status thud_run_create(const struct thud_model *model, const struct thud_record *record,
                                 const struct thud_run_options *options, struct thud_run **out, struct thud_error *err);

/* Advances the run by at most `budget` segments. Errors: THUD_DIVERGED with time, floor and limit (earlier results stay
 * readable), also at the end if the energy error exceeds thud_run_balance; THUD_MEMORY. */
enum thud_status thud_run_advance(struct thud_run *run, long budget, bool *done, struct thud_error *err);

/* Returns the largest energy error allowed at the end of a run, relative to the largest energy. */
double thud_run_balance(const struct thud_run *run);

double thud_run_time(const struct thud_run *run);
double thud_run_end(const struct thud_run *run);
/* Returns the result, valid until the run is freed or advanced. Before the end of the run, a peak of the contact-free
 * response may still be its value at the end of a ground motion interval. */
const struct thud_result *thud_run_result(const struct thud_run *run);
const struct thud_impact *thud_run_impacts(const struct thud_run *run, int *count);
const struct thud_event_entry *thud_run_events(const struct thud_run *run, int *count);
const struct thud_history *thud_run_history(const struct thud_run *run);
/* Returns the pseudo-acceleration so far, m/s2, by index of floor and period in options.floor_spectra. */
double thud_run_floor_spectrum(const struct thud_run *run, int floor, int period);
void thud_run_free(struct thud_run *run);
