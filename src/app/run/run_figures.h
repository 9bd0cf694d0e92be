/* All figures of one scene's run, or of one study, as files. */
#ifndef THUD_APP_RUN_FIGURES_H
#define THUD_APP_RUN_FIGURES_H

#include "core/run/run.h"
#include "plot/figures/figures_run.h"
#include "plot/gnuplot/gnuplot.h"
#include "study/sweep/sweep_table.h"

/* A finished run with history and impacts as a source of figures; everything stays where it is. */
struct thud_figure_source thud_run_source(const char *name, const struct thud_scene *scene, const struct thud_run *run);

/* Whatever there is to show: force, velocity, acceleration, displacement, drift, loop, envelope, energy. Errors: as
 * thud_figure_deliver; after a failed gnuplot scripts and data are still written. */
enum thud_status thud_run_figures_save(const struct thud_figure_source *source, int nsources, const char *folder,
                                       const struct thud_picture_options *options, struct thud_error *err);

/* All figures of a study. Errors: likewise. */
enum thud_status thud_sweep_figures_save(const struct thud_sweep_table *table, const char *folder,
                                         const struct thud_picture_options *options, struct thud_error *err);

#endif
