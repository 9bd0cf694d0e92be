/* Shared by the files that make figures of runs. */
#pragma once

#include "plot/figures/figures_case.h"
#include "plot/figures/figures_run.h"

enum { THUD_CURVES_MAX = THUD_COLORS, THUD_ROWS_MAX = 6 };

struct thud_shown_unit thud_shown_force(double peak_n);

/* What a figure over time shows, and in which unit. */
struct thud_run_words {
    const char *label, *title, *unit;
    double factor;
};
extern const struct thud_run_words thud_run_words[THUD_RUN_FIGURES];

/* Time of the largest impact of all sources, with room around it; false where there was none. */
bool thud_source_zoom(const struct thud_figure_source *source, int nsources, double *from_s, double *to_s);

/* Adds history column(s) as a line: value = factor (column - less), less < 0: nothing taken off. */
struct thud_series *thud_source_line(struct thud_panel *panel, const struct thud_figure_source *source, int column,
                                     int less, double factor, const char *name, int color);

/* "Two towers: Impact force (MN); kobe scaled to 0.821 g, bumper, gap 10 cm" */
void thud_source_title(const struct thud_figure_source *source, int nsources, const char *what, char *text,
                       size_t size);
/* The colour of its curve beside those of other cases; alone the first one. */
static inline int thud_source_color(const struct thud_figure_source *source, int nsources)
{
    return nsources > 1 ? thud_case_color(source->which) : 0;
}
/* Histories of cases stand one above the other, a strip for each: this many at most, and as many for a place. */
enum { THUD_STRIPS_MAX = 12 };
static inline int thud_source_places(int nsources)
{
    return nsources < THUD_STRIPS_MAX ? THUD_STRIPS_MAX / nsources : 1;
}
/* "A, floor 4" of a lone source; "A, floor 4: bumper" of one of several. */
const char *thud_source_strip(const struct thud_figure_source *source, int nsources, const char *place, char text[256]);
/* Whether there is a ground motion; and its strip at the top of a figure, with the closer look. */
bool thud_source_ground(const struct thud_figure_source *source);
void thud_figure_ground(struct thud_figure *figure, const struct thud_figure_source *source, double from, double to);
/* The rows from `first_row` on with the same y axis. */
void thud_figure_same_height(struct thud_figure *figure, int first_row);

/* Ends the panels of a whole run where nothing changes by more than a twentieth of the peaks any more. It does so only
 * if the rest is a good part, and the figure's note says so. */
void thud_figure_shorten(struct thud_figure *figure);

/* "floor 3", or with both structures where there are several interfaces. */
void thud_source_contact_name(const struct thud_figure_source *source, int contact, char *text, size_t size);

/* Indices of the `most` largest of n values that are > 0 (all where there are none), in their own order; returns how
 * many. */
int thud_pick_largest(const double *value, int n, int most, int *index);

int thud_source_first_dof(const struct thud_figure_source *source, int structure);
/* Lines of a source: of a floor, of a contact only while it is closed. The largest force of all contacts. */
void thud_source_floor(struct thud_panel *panel, const struct thud_figure_source *source, int structure, int floor,
                       enum thud_run_figure which, const char *name, int color);
void thud_source_loop(struct thud_panel *panel, const struct thud_figure_source *source, int contact, double factor,
                      const char *name, int color);
double thud_source_force(const struct thud_figure_source *source, int nsources);
void thud_loop_axes(struct thud_panel *panel, const char *unit);

/* Whether a structure has something to show: it has floors, and for the deflections more than a rigid body's one. */
bool thud_source_shown(const struct thud_figure_source *source, int structure, enum thud_run_figure which);
/* Whether a storey yields in a source, or there is a link where those count. */
bool thud_source_yields(const struct thud_figure_source *source, int nsources, bool links);
#define THUD_RUN_FIGURE(NAME, name, maker, needs)                                                                      \
    struct thud_figure *thud_figure_##maker(enum thud_run_figure which, const struct thud_figure_source *source,       \
                                            int nsources);
THUD_RUN_FIGURE_LIST(THUD_RUN_FIGURE)
#undef THUD_RUN_FIGURE
