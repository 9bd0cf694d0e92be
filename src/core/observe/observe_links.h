/* Force, stroke and loss of the links. Those that are contacts have theirs from the contacts' log at the end. */
#pragma once

#include "core/observe/observer.h"

/* Its own state is the result. */
extern const struct thud_observer thud_observe_links;

/* At the end of a run: the links that are contacts, and what those of friction have lost. */
void thud_links_finish(const struct thud_state *state, struct thud_result *result);
