/* Figures of a parametric study: amplification against what was varied, and maps where two things were. */
#pragma once

#include "plot/figure/figure.h"
#include "study/sweep/sweep_table.h"

/* An axis of a panel for a varied key: its title and unit, or its words as ticks; and from its SI values to what is
 * shown (1 for words). */
void thud_panel_varied(struct thud_panel *panel, enum thud_side side, const struct thud_sweep_axis *axis);
double thud_varied_factor(const struct thud_sweep_axis *axis);

/* What the line of the gap from which there is no contact is, in a sentence. */
extern const char thud_free_gap_words[];

/* Amplification of the peak floor accelerations and interstorey drifts against the first varied key, a curve per
 * floor, a column of panels per structure, for one record and case; of case `none` over no pounding. `title` may be
 * NULL: made from record and case. */
struct thud_figure *thud_figure_by_floor(const struct thud_sweep_table *table, int record, enum thud_case which,
                                         const char *name, const char *title);
/* The same of the means over the floors, a curve per record; of more than seven the median, and a band from 16 to 84 %. */
struct thud_figure *thud_figure_of_means(const struct thud_sweep_table *table, enum thud_case which, const char *name,
                                         const char *title);
/* Largest contact force and number of impacts against the first varied key, a curve per case, for one record. */
struct thud_figure *thud_figure_of_contacts(const struct thud_sweep_table *table, int record, const char *name);
/* Ratios of the means over the floors to no pounding, a curve per case, for one record. */
struct thud_figure *thud_figure_of_pounding(const struct thud_sweep_table *table, int record, const char *name);
/* Amplification of the means over the first two varied keys (heat map with the contour at 1), for one record and case;
 * at (naxes): places of the others' values, NULL: the first. */
struct thud_figure *thud_figure_of_map(const struct thud_sweep_table *table, int record, enum thud_case which,
                                       const int *at, const char *name);

/* With more records than this a study's figures are better of thud_sweep_suite_make: one of each kind, with medians and
 * bands. */
enum { THUD_SWEEP_FIGURE_RECORDS = THUD_COLORS };
/* All figures a study gives (of one varied key also ductility and permanent drift of storeys that yield, and shear of
 * columns that slabs strike), counted from 0: thud_sweep_figure makes one (ask thud_figure_check). */
int thud_sweep_figure_count(const struct thud_sweep_table *table);
struct thud_figure *thud_sweep_figure(const struct thud_sweep_table *table, int index);
