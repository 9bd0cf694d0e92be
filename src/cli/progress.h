/* How far a long work is, on standard error: a line that renews itself on a terminal, one every few seconds elsewhere,
 * none with --quiet. One work at a time. */
#ifndef THUD_CLI_PROGRESS_H
#define THUD_CLI_PROGRESS_H

#include <stdbool.h>

#include "base/status.h"
#include "cli/args.h"

/* Whether anything will be shown. */
bool thud_progress_start(const struct thud_args *args);
void thud_progress_show(const char *fmt, ...) THUD_PRINTF(1, 2);
/* Wipes out the line of a terminal, before something else is written there; `end`: nothing more will be shown. */
void thud_progress_wipe(void);
void thud_progress_end(void);
/* What is being done; for struct thud_site_report_options and its like. */
void thud_progress_what(void *context, const char *what);
/* Of the points of a study, with the time that is left; for struct thud_sweep_study and its like. */
/* Of the figures that are drawn one after another. */
void thud_progress_drawing(void *context, const char *figure);
void thud_progress_points(void *context, long done, long count, double elapsed_s);

#endif
