/* What of the contract in core/law.h can be looked at before a run, and at each of its branches. */
#ifndef THUD_CORE_LAW_CHECK_H
#define THUD_CORE_LAW_CHECK_H

#include "core/laws/law.h"

/* Why no run can follow this branch, as the end of a sentence; NULL: it can. */
const char *thud_branch_fault(const struct thud_law *law, const struct thud_branch *branch, enum thud_phase phase);

/* Puts the law through a contact of some depths. Errors: THUD_INPUT with the key "law". */
enum thud_status thud_law_check(const struct thud_law *law, const struct thud_law_setup *setup, struct thud_error *err);

#endif
