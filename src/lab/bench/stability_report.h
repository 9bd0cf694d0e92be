/* What came of thud_stability: for people, and as figures. */
#pragma once

#include "base/text.h"
#include "plot/figure/figure.h"
#include "study/methods/stability.h"

void thud_stability_table(const struct thud_stability *stability, struct thud_text *out);

/* Methods against omega dt: a map of the verdicts of a kind, and the energy kept. Ask thud_figure_check. */
struct thud_figure *thud_stability_map(const struct thud_stability *stability, int kind);
struct thud_figure *thud_stability_energies(const struct thud_stability *stability);
