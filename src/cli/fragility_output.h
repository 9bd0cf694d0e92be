/* What `thud fragility` says once its runs are done. */
#ifndef THUD_CLI_FRAGILITY_OUTPUT_H
#define THUD_CLI_FRAGILITY_OUTPUT_H

#include "app/sweep/fragility_report.h"
#include "cli/args.h"
#include "plot/gnuplot/gnuplot.h"

/* --event, --hazard, --samples and --seed into *out. Errors: THUD_USAGE, THUD_INPUT. */
enum thud_status thud_fragility_options_read(const struct thud_args *args, const struct thud_sweep_plan *plan,
                                             struct thud_fragility_study *out, struct thud_error *err);
/* Files and figures into `folder` (NULL: none), then table, CSV or JSON into `out`. Errors: THUD_OUTPUT, THUD_GNUPLOT
 * (all else is done then), THUD_USAGE, THUD_MEMORY, THUD_CANCELLED. */
enum thud_status thud_fragility_deliver(const struct thud_args *args, struct thud_fragility_study *study,
                                        const char *folder, const struct thud_picture_options *pictures,
                                        struct thud_text *out, struct thud_error *err);

#endif
