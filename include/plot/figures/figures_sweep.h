/* Figures of a parametric study: amplification against one varied key, and maps for two. */
#pragma once

#include "plot/figure/figure.h"
#include "study/sweep/sweep_table.h"

/* Prepares an axis of a panel for a varied key: title and unit, or words as ticks. Gives the factor from SI to shown
 * values (1 for words). */
void thud_panel_varied(struct thud_panel *panel, enum thud_side side, const struct thud_sweep_axis *axis);
double thud_varied_factor(const struct thud_sweep_axis *axis);

/* Adds the sentence on the line ("Vertical", "Level") at the gap above which there is no contact, of a scene with these
 * measures; `links`: they act there. */
void thud_figure_note_free_gap(struct thud_figure *figure, const char *line, int measures, bool links, bool several);

/* Draws the amplification of peak floor accelerations and interstorey drifts against the first varied key, for one
 * record and case. There is a curve per floor and a column of panels per structure. Case `none` is relative to no
 * pounding. `title` NULL: made from record and case. */
struct thud_figure *thud_figure_by_floor(const struct thud_sweep_table *table, int record, enum thud_case which,
                                         const char *name, const char *title);
/* Draws the same for the means over the floors, a curve per record; of more than seven the median and 16 to 84 %. */
struct thud_figure *thud_figure_of_means(const struct thud_sweep_table *table, enum thud_case which, const char *name,
                                         const char *title);
/* Draws the peak contact force and number of impacts against the first varied key, a curve per case, for one record. */
struct thud_figure *thud_figure_of_contacts(const struct thud_sweep_table *table, int record, const char *name);
/* Draws the means over the floors relative to no pounding, a curve per case, for one record. */
struct thud_figure *thud_figure_of_pounding(const struct thud_sweep_table *table, int record, const char *name);
/* Draws the amplification of the means over the first two varied keys (heat map with the contour at 1), for one record
 * and case. at (naxes): indices of the values of the other keys; NULL: the first. */
struct thud_figure *thud_figure_of_map(const struct thud_sweep_table *table, int record, enum thud_case which,
                                       const int *at, const char *name);

/* Number of records above which a study's figures are made by thud_sweep_suite_make: one of each kind, with medians and
 * bands. */
enum { THUD_SWEEP_FIGURE_RECORDS = THUD_COLORS };
/* Count all figures of a study; with one varied key these include ductility and permanent drift of yielding storeys,
 * and shear of struck columns. thud_sweep_figure makes one, from 0 (see thud_figure_check). */
int thud_sweep_figure_count(const struct thud_sweep_table *table);
struct thud_figure *thud_sweep_figure(const struct thud_sweep_table *table, int index);
