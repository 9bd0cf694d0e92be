/* Observer of a run: what its contacts go through. Peaks of their forces and indentations, impulse, work and time in
 * contact, of each contact and of the impact that goes on; core/contact.h says where an impact begins, ends and counts. */
#pragma once

#include "core/contact/contact_log.h"
#include "core/observe/observer.h"

extern const struct thud_observer thud_observe_contacts; /* its own: a struct thud_contact_log */
