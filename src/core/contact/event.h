/* Location of the first event of a segment: the first guard that fires. */
#pragma once

#include "core/contact/segment.h"

enum thud_event {
    THUD_EVENT_NONE = -1,
    THUD_EVENT_ONSET,      /* contact begins */
    THUD_EVENT_SEPARATION, /* indentation back to 0 */
    THUD_EVENT_RELEASE,    /* the force would begin to pull */
    THUD_EVENT_REENGAGE,   /* the force cut at 0 would push again */
    THUD_EVENT_REVERSAL,   /* of the velocity: approach to restitution or back */
    THUD_EVENT_BRANCH,     /* the indentation passes the ultimate compression */
    THUD_EVENT_UNSTICK_IN, /* the constraint force leaves its interval: pushed further in */
    THUD_EVENT_UNSTICK_OUT,
    THUD_EVENT_YIELD_UP, /* of a storey: its drift reaches the bound |d - d_p| = d_y */
    THUD_EVENT_YIELD_DOWN,
    THUD_EVENT_UNLOAD,  /* a storey that yields turns back */
    THUD_EVENT_COLLAPSE /* the drift of a storey comes to what it can stand: the run ends */
};

/* By event: "onset", "reversal", ...; and what its guard watches: "d rises", ... */
extern const struct thud_event_words {
    const char *name, *guard;
} thud_event_words[];

/* s of the earliest event in [0, s_end] of the segment, with its row (a contact, or a storey that yields; of a collapse the number of
 * rows and the floor above the storey), what it is,
 * and how many of the lowest coefficients of its guard were suppressed (order); INFINITY where there is none.
 * Reads the indentation of the contacts that may have one, for its notes. */
double thud_event_first(const struct thud_state *state, const struct thud_segment *seg, double s_end, int *contact,
                        enum thud_event *event, int *order);
/* The first event of storey k where its drift is the polynomial d (n terms): while it is elastic, the distance of the
 * drift from the bound on either side must not rise above 0; while it yields, the rate of the drift must not turn back.
 * fresh: it may have just switched. */
double thud_event_storey(const struct thud_state *state, int k, const double *d, int n, bool fresh, double s_end,
                         enum thud_event *event, int *order);
