/* One run: a model, a ground motion, a method; advanced in slices, so that it can be cancelled, shown and shared. */
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
    double tail_s;         /* after the record; the duration where there is none */
    bool keep_impacts;     /* list impacts one by one */
    bool keep_events;      /* list events one by one */
    bool keep_history;     /* record histories */
    double history_step_s; /* between rows outside contacts; 0: the record's step */
    /* > 0: spacing of contact rows next to the peaks, with energies NaN: a third of the time, for a preview. 0: as fine
     * as the impulse of the forces requires. */
    double history_look_s;
    /* Oscillators on floors; NULL: none. Read only by thud_run_create. Exact method only. */
    const struct thud_floor_spectra_choice *floor_spectra;
    const struct thud_step_watch *watch; /* has to outlive the run; NULL: nobody */
    bool unjudged; /* energy unaccounted for does not end the run: for studies of how methods fail */
};
void thud_run_options_init(struct thud_run_options *options);

/* Creates a run. `model` and `record` (NULL: no ground motion) must outlive it. Errors: THUD_INPUT, THUD_MEMORY. */
enum thud_status thud_run_create(const struct thud_model *model, const struct thud_record *record,
                                 const struct thud_run_options *options, struct thud_run **out, struct thud_error *err);

/* Advances the run by at most `budget` segments. Errors: THUD_DIVERGED with time, floor and limit (what was found before stays
 * readable), also at the end when more of the energy is unaccounted for than thud_run_balance allows; THUD_MEMORY. */
enum thud_status thud_run_advance(struct thud_run *run, long budget, bool *done, struct thud_error *err);

/* Returns the largest fraction of the energy that may be unaccounted for at the end of a run. */
double thud_run_balance(const struct thud_run *run);

double thud_run_time(const struct thud_run *run);
double thud_run_end(const struct thud_run *run);
/* Returns the result, valid until the run is freed or advanced. Before the end, a peak of contact-free response may
 * still be that at the end of a ground motion interval. */
const struct thud_result *thud_run_result(const struct thud_run *run);
const struct thud_impact *thud_run_impacts(const struct thud_run *run, int *count);
const struct thud_event_entry *thud_run_events(const struct thud_run *run, int *count);
const struct thud_history *thud_run_history(const struct thud_run *run);
/* Returns the pseudo-acceleration so far, m/s2, by index of floor and period in options.floor_spectra. */
double thud_run_floor_spectrum(const struct thud_run *run, int floor, int period);
void thud_run_free(struct thud_run *run);
