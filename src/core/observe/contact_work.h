/* Work done on contacts and impulse of their forces over a segment.
 *
 *     W = integral of F d' dt,   J = integral of F dt
 *
 * Of a power series: of the force polynomials that were applied, and, at points of a quadrature, of what the law's force
 * differs from them by. Of a step whose events are not located: mean force of its two ends times the indentation between
 * them. */
#pragma once

#include "core/observe/observer.h"

/* Fills out (ncontacts) from the segment up to o->s, contacts with a force alone, and returns how many; o->work is not
 * read. */
int thud_contact_works(const struct thud_observation *o, struct thud_contact_work *out);
