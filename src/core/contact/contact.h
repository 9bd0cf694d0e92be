/* The states of a contact: what follows an event. One automaton for all laws; its guards are in core/event.c. */
#pragma once

#include "core/contact/contact_log.h"
#include "core/contact/event.h"

/* All contacts of the state open, with what is fixed for them. */
void thud_contact_start(struct thud_state *state);
/* The state has gone on: clears the guards suppressed at the last event, but for neighbours that touch and have not
 * moved at all. */
void thud_contact_moved(struct thud_state *state);
/* Acts on an event at the state. Errors: THUD_DIVERGED (impulses of contacts that the modes do not tell apart),
 * THUD_MEMORY. */
enum thud_status thud_contact_switch(struct thud_state *state, struct thud_contact_log *log, int contact,
                                     enum thud_event event, struct thud_error *err);

/* Closes the contacts that begin in the segment up to s, which starts at the state. Errors: THUD_MEMORY. */
enum thud_status thud_contacts_begin(struct thud_state *state, struct thud_contact_log *log,
                                     const struct thud_segment *seg, double s, struct thud_error *err);
/* Releases and opens the contacts that have come to that in the segment, whose end up to s the state is, one after the
 * other. Errors: THUD_MEMORY. */
enum thud_status thud_contacts_end(struct thud_state *state, struct thud_contact_log *log,
                                   const struct thud_segment *seg, double s, struct thud_error *err);

/* contact_update.c, for runs that do not locate: acts on what the state shows; apart: no contact is indented there.
 * Errors: as thud_contact_switch. */
enum thud_status thud_contact_update(struct thud_state *state, struct thud_contact_log *log, bool apart, bool *switched,
                                     struct thud_error *err);

/* The rule for all methods and laws: an impact counts, and its time, when its impulse is above THUD_TOL_IMPACT of what
 * would stop the effective mass from the velocity scale of the run. */
bool thud_impact_counts(const struct thud_state *state, int c, double impulse_ns);

/* Counts the impact of contact c that goes on, once, as soon as its impulse is large enough; those of impulsive laws are
 * counted as they happen. */
void thud_impact_count(const struct thud_state *state, struct thud_contact_log *log, int c);
