/* Version of the program. */
#pragma once

#include "base/text.h"

#define THUD_VERSION "0.1.0"

/* Appends "thud 0.1.0, commit 1a2b3c4d". */
void thud_version_name(struct thud_text *out);
/* Appends "thud 0.1.0" and the build configuration. */
void thud_version_text(struct thud_text *out);
