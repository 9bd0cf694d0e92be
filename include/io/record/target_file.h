/* Reads a target spectrum. */
#pragma once

#include "ground/target.h"

/* Reads the spectrum of a code (thud_target_parse), or a file NAME.csv. The file has a header with units
 * (`period_s,sa_g`), then rows of increasing period and pseudo spectral acceleration at 5 % damping. The table of ASCE
 * 7-22 is such a file. Errors: THUD_INPUT with line and column, THUD_MEMORY. */
enum thud_status thud_target_read(const char *text, struct thud_target *out, struct thud_error *err);
