/* Reads a target spectrum. */
#pragma once

#include "ground/target.h"

/* Reads a code's spectrum (thud_target_parse), or a file NAME.csv: a header whose columns name their units
 * (`period_s,sa_g`), then rows of rising period and pseudo spectral acceleration; damping 5 %. The table of ASCE 7-22
 * is such a file. Errors: THUD_INPUT with line and column, THUD_MEMORY. */
enum thud_status thud_target_read(const char *text, struct thud_target *out, struct thud_error *err);
