/* Observer of a run without contact: largest relative displacement (left less right, m, at least 0) of the two sides of
 * each contact, and largest displacement of the struck place where it is no floor's. */
#ifndef THUD_CORE_OBSERVE_RELATIVE_H
#define THUD_CORE_OBSERVE_RELATIVE_H

#include "core/observer.h"

extern const struct thud_observer thud_observe_relative; /* its own: the values (2 x ncontacts) */

#endif
