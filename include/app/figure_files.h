/* A figure as files: NAME.png (or svg, pdf), NAME.gp that draws it again, and NAME.csv with all its data. */
#ifndef THUD_APP_FIGURE_FILES_H
#define THUD_APP_FIGURE_FILES_H

#include "base/status.h"
#include "plot/gnuplot.h"

/* Saves and frees. A NULL figure is one that memory did not suffice for; `options` NULL: all chosen. Makes the folder,
 * then writes script and data first, so that they are there also when the picture fails; each file whole or not at all.
 * An older picture is left as it was on failure. After THUD_GNUPLOT in `before` (may be THUD_OK) the picture is not
 * tried again: only script and data are written. Returns the first failure of a series of figures: a failed disk counts
 * more than a failed gnuplot. Errors: THUD_OUTPUT, THUD_GNUPLOT, THUD_CANCELLED, THUD_MEMORY. */
enum thud_status thud_figure_deliver(struct thud_figure *figure, const char *folder,
                                     const struct thud_picture_options *options, enum thud_status before,
                                     struct thud_error *err);

#endif
