/* The paper's figures by name, and the report that holds them all. */
#ifndef THUD_APP_PAPER_FIGURES_H
#define THUD_APP_PAPER_FIGURES_H

#include "app/paper/paper_report.h"
#include "plot/gnuplot/gnuplot.h"

enum {
    THUD_PAPER_FIGURES = 9,
    THUD_PAPER_ALL = (1 << THUD_PAPER_FIGURES) - 1,
    THUD_PAPER_REPORT = 1 << THUD_PAPER_FIGURES
};

/* "fig2" to "fig10". */
const char *thud_paper_figure_name(int index);
/* A set of figures from their names, `all` for all of them with the report, which is also what no name means. Errors:
 * THUD_USAGE. */
enum thud_status thud_paper_figures_parse(int n, const char *const *name, unsigned *which, struct thud_error *err);
/* Whether a set needs the parametric study. */
bool thud_paper_needs_study(unsigned which);

/* Writes a set of figures into a folder; the report too where it is in the set (study->pair is filled here and may be
 * NULL). `study` may be NULL where none is needed. Errors: as thud_figure_deliver, and those of runs. */
enum thud_status thud_paper_figures_save(unsigned which, const struct thud_paper_study *study, const char *folder,
                                         const struct thud_picture_options *options, struct thud_error *err);

#endif
