/* A figure as files: NAME.png (or svg, pdf), NAME.gp that draws it again, and NAME.csv with all its data. */
#pragma once

#include "base/status.h"
#include "core/run/run.h"
#include "plot/figures/figures_run.h"
#include "plot/gnuplot/gnuplot.h"
#include "study/sweep/sweep_table.h"

/* Saves and frees. A NULL figure is one that memory did not suffice for; `options` NULL: all chosen. Draws, then
 * makes the folder and writes: the figure's files are there together or, when it was stopped or the disk is full, as
 * they were before. Where gnuplot fails script and data are written all the same, for they can be drawn elsewhere; an
 * older picture is then left as it was. After THUD_GNUPLOT in `before` (may be THUD_OK) the picture is not
 * tried again: only script and data are written. Returns the first failure of a series of figures: a failed disk counts
 * more than a failed gnuplot. Errors: THUD_OUTPUT, THUD_GNUPLOT, THUD_CANCELLED, THUD_MEMORY. */
enum thud_status thud_figure_deliver(struct thud_figure *figure, const char *folder,
                                     const struct thud_picture_options *options, enum thud_status before,
                                     struct thud_error *err);

/* ---- All figures of one scene's run, or of one study, as files ---- */

/* A finished run with history and impacts as a source of figures; everything stays where it is. */
struct thud_figure_source thud_run_source(const char *name, enum thud_case which, const struct thud_scene *scene,
                                          const struct thud_run *run);

/* Whatever there is to show: force, velocity, acceleration, displacement, drift, loop, envelope, energy. Errors: as
 * thud_figure_deliver; after a failed gnuplot scripts and data are still written. */
enum thud_status thud_run_figures_save(const struct thud_figure_source *source, int nsources, const char *folder,
                                       const struct thud_picture_options *options, struct thud_error *err);

/* All figures of a study. Errors: likewise. */
enum thud_status thud_sweep_figures_save(const struct thud_sweep_table *table, const char *folder,
                                         const struct thud_picture_options *options, struct thud_error *err);
