/* The parts of thud-preset(5) that come from the program's own tables, as mdoc. */
#ifndef THUD_CLI_MANUAL_H
#define THUD_CLI_MANUAL_H

#include "base/param.h"
#include "base/text.h"

/* A list of parameters, each with its meaning, unit, bounds and default. */
void thud_manual_params(struct thud_text *out, const struct thud_param *params, int n);

/* The units of every dimension. */
void thud_manual_units(struct thud_text *out);

/* Every law with its force, its parameters and its reference. */
void thud_manual_laws(struct thud_text *out);

#endif
