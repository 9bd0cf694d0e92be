/* What of the contract in core/law.h can be looked at before a run, and at each of its branches. */
#pragma once

#include "core/laws/law.h"

/* Why no run can follow this branch, as the end of a sentence; NULL: it can. */
const char *thud_branch_fault(const struct thud_law *law, const struct thud_branch *branch, enum thud_phase phase);

/* Which parameter is the whole stiffness of the law, in which the columns are part of it from the start; -1: none. */
int thud_law_spring(const struct thud_law *law);
