/* The version, in one place. */
#pragma once

#include "base/text.h"

#define THUD_VERSION "0.1.0"

/* "thud 0.1.0, commit 1a2b3c4d". */
void thud_version_name(struct thud_text *out);
/* "thud 0.1.0", and how it was built. */
void thud_version_text(struct thud_text *out);
