/* What contacts have gone through: their results, and the list of impacts. */
#pragma once

#include <stdbool.h>

#include "base/status.h"
#include "core/contact/event.h"
#include "core/model/result.h"

struct thud_contact_log {
    struct thud_contact_result *contact; /* (ncontacts), of the run's result */
    bool keep_impacts, keep_events;
    struct thud_impact *now;    /* (ncontacts) impacts that go on, and */
    bool *counted;              /* (ncontacts) whether they are among the impacts of the contact */
    double *waiting_s;          /* (ncontacts) time in which they have pushed, until they count */
    struct thud_impact *impact; /* (count), in the order of their ends */
    int count;
    struct thud_event_entry *event; /* (nevents), in the order of time */
    int nevents;
    double lost_j; /* in impulses so far */
};

/* Errors: THUD_MEMORY. */
enum thud_status thud_contact_log_init(struct thud_contact_log *log, const struct thud_state *state,
                                       struct thud_contact_result *contact, bool keep_impacts, struct thud_error *err);
/* An impact begins. */
void thud_contact_log_begin(struct thud_contact_log *log, int contact, double time_s, double approach_mps);
/* Adds an impact that is over, where impacts are kept. Errors: THUD_MEMORY. */
enum thud_status thud_contact_log_add(struct thud_contact_log *log, const struct thud_impact *impact,
                                      struct thud_error *err);
/* Adds an event that the state has just been switched by, where events are kept. Errors: THUD_MEMORY. */
enum thud_status thud_contact_log_event(struct thud_contact_log *log, const struct thud_state *state, double time_s,
                                        int row, enum thud_event event, int order, struct thud_error *err);
void thud_contact_log_clear(struct thud_contact_log *log);
