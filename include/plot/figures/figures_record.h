/* Figures of a ground motion: its histories, its response spectrum. */
#pragma once

#include "ground/record.h"
#include "ground/spectrum.h"
#include "plot/figure/figure.h"

/* Draws acceleration, velocity and displacement over time, one above the other. `name` is that of the files. Ask
 * thud_figure_check. */
struct thud_figure *thud_figure_of_motion(const struct thud_record *record, const char *name, const char *title);

/* Draws the acceleration of a whole recording in its own time: the part from `from_s` to `to_s` (NaN: its ends) that is
 * used, and what is cut off. Ask thud_figure_check. */
struct thud_figure *thud_figure_of_parts(const struct thud_record *whole, double from_s, double to_s, const char *name,
                                         const char *title);

/* Period to be marked. */
struct thud_period_mark {
    double period_s;
    char text[80];
};

/* Draws Sa, Sv and Sd over the period on a log axis; marks outside the shown periods are omitted. Ask
 * thud_figure_check. */
struct thud_figure *thud_figure_of_spectrum(const struct thud_spectrum_point *point, size_t count, double damping,
                                            const struct thud_period_mark *mark, int nmarks, const char *name,
                                            const char *title);
