/* What the files that switch contacts share. */
#ifndef THUD_CORE_CONTACT_H
#define THUD_CORE_CONTACT_H

#include "core/run_private.h"

/* Changes the mode and keeps the count of acting contacts. */
void thud_contact_set_mode(struct thud_run *run, int c, enum thud_contact_mode mode);

#endif
