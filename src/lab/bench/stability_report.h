/* What came of thud_stability: for people, and as figures. */
#pragma once

#include <stdatomic.h>

#include "base/text.h"
#include "plot/figure/figure.h"
#include "study/methods/stability.h"

/* All jobs, in threads; what is done stays. Errors: THUD_CANCELLED, those of thud_stability_job. */
enum thud_status thud_stability_run(struct thud_stability *stability, const atomic_int *cancel,
                                    void (*progress)(int done, int jobs), struct thud_error *err);

void thud_stability_table(const struct thud_stability *stability, struct thud_text *out);

/* Methods against omega dt: a map of the verdicts of a kind, and the energy kept. Ask thud_figure_check. */
struct thud_figure *thud_stability_map(const struct thud_stability *stability, int kind);
struct thud_figure *thud_stability_energies(const struct thud_stability *stability);
