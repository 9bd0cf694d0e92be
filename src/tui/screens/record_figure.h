/* What a ground motion looks like. */
#pragma once

#include "ground/intensity.h"
#include "plot/figure/figure.h"
#include "tui/document/doc.h"
#include "tui/terminal/canvas.h"

enum thud_record_curve {
    THUD_RECORD_ACCELERATION,
    THUD_RECORD_VELOCITY,
    THUD_RECORD_DISPLACEMENT,
    THUD_RECORD_SPECTRUM,
    THUD_RECORD_CURVES
};
const char *thud_record_curve_title(enum thud_record_curve curve);
/* Of the document's ground motion, which must be there, as `thud record` writes it; where a part of it is used, the
 * acceleration shows what is cut off as well. NULL when out of memory. */
struct thud_figure *thud_record_figure(const struct thud_doc *doc, enum thud_record_curve curve);
const struct thud_panel *thud_record_panel(const struct thud_figure *figure,
                                           enum thud_record_curve curve); /* its own */
/* Draws the measures from row `y` on; returns the row after them. */
int thud_record_measures(const struct thud_intensity *intensity, const struct thud_record *record,
                         const struct thud_pane *pane, int y);
