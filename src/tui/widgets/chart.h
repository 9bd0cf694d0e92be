/* A figure's panel drawn in a pane: the same data that gnuplot draws. */
#pragma once

#include "plot/figure/figure.h"
#include "tui/terminal/canvas.h"

/* Where the plot proper stands in its pane, and what it shows. */
struct thud_chart_frame {
    struct thud_pane plot;
    struct thud_range x, y;
    struct thud_range all; /* of x, where nothing is zoomed */
    bool x_log, y_log;
};

/* The part of x that is shown; none where it does not go up. */
struct thud_chart_window {
    double from, to;
};

struct thud_chart {
    double cursor; /* x of an upright line; NaN: none */
    bool has_here; /* another upright line stands at `here`: what holds now */
    double here;
    struct thud_chart_window window;
    struct thud_chart_frame *drawn; /* gets where the plot stands; NULL: nobody asks */
};

void thud_chart_draw(const struct thud_pane *pane, const struct thud_panel *panel, const struct thud_chart *chart);
/* All panels of a figure in their grid, or one of them (from 0; -1: all, where there is room). */
void thud_chart_figure(const struct thud_pane *pane, const struct thud_figure *figure, int only,
                       const struct thud_chart *chart);

/* The window around `at` that shows `factor` as much of a chart as it shows now; none once that is all of it. */
struct thud_chart_window thud_chart_zoom(const struct thud_chart_frame *frame, double factor, double at);
/* The same width moved by a part of it, within all there is. */
struct thud_chart_window thud_chart_pan(const struct thud_chart_frame *frame, double part);
/* x at a part of the plot's width. */
double thud_chart_at(const struct thud_range *range, bool log, double along);

/* A series at x, along straight lines between its points; where it has several values there, the largest. NaN: none. */
double thud_chart_value(const struct thud_series *series, double x);
/* All series of a panel at x, as a line of words. */
void thud_chart_words(const struct thud_panel *panel, double x, char *text, size_t size);

/* Draws title, key, axes and their labels; false when the pane is too small for a plot. */
bool thud_chart_axes(const struct thud_pane *pane, const struct thud_panel *panel, struct thud_chart_frame *frame);
/* 0 to 1 along an axis. */
double thud_chart_along(const struct thud_range *range, bool log, double value);
/* What a series is called in the key, from 0: its number among those that have a line there of their own. */
int thud_chart_number(const struct thud_panel *panel, int index);
struct thud_look thud_chart_look(const struct thud_series *series, int index);
