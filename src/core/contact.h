/* What the files that switch contacts share. */
#ifndef THUD_CORE_CONTACT_H
#define THUD_CORE_CONTACT_H

#include "core/run_private.h"

enum thud_event {
    THUD_EVENT_TOUCH,
    THUD_EVENT_GONE,     /* indentation back to 0 */
    THUD_EVENT_RELEASE,  /* the force would begin to pull */
    THUD_EVENT_REENGAGE, /* the force cut at 0 would push again */
    THUD_EVENT_TURN,     /* approach to restitution or back */
    THUD_EVENT_KNEE,
    THUD_EVENT_HOLD_UP, /* stuck: pushed further in */
    THUD_EVENT_HOLD_DOWN
};

/* Changes the mode and keeps the count of acting contacts. */
void thud_contact_set_mode(struct thud_run *run, int c, enum thud_contact_mode mode);
/* Other contacts' impulses have changed the rate of contact c by so much, to what it is now: it goes on in the phase of
 * that rate, with nothing of it known to be 0. */
void thud_contact_struck(struct thud_run *run, int c, double change);

#endif
