/* Figures as data: panels in a grid, each with axes, series, marks and perhaps a map. gnuplot and the terminal's own
 * charts draw the same object; nothing here knows either.
 *
 * A figure owns everything reached from it; texts and numbers handed over are copied, one thud_figure_free gives all
 * back. Running out of memory marks a figure as failed. Every function accepts NULL and a failed figure, and then does
 * nothing, so a figure is built without checks and checked once before it is drawn (thud_figure_check). */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/status.h"
#include "base/text.h"

enum thud_side { THUD_X, THUD_Y };

enum thud_series_kind {
    THUD_LINES,
    THUD_POINTS,
    THUD_LINES_POINTS,
    THUD_STEPS, /* constant from one x to the next */
    THUD_FILL,  /* a band between y and y_high; a thin one belongs to the curve of its name */
    THUD_BARS   /* from 0 to y */
};

/* Colours are indices into one palette. The first seven are distinguishable with colour blindness (Okabe and Ito 2008).
 * Five darker colours, with points of another shape, are for figures with many curves. An index past the end starts
 * again. */
enum { THUD_COLORS = 7, THUD_COLORS_ALL = 12, THUD_COLOR_GREY = -1 };
unsigned thud_color_rgb(int color); /* 0xRRGGBB */

struct thud_style {
    enum thud_series_kind kind;
    int color;
    int rank;    /* among those of one colour, from 1: the higher, the larger its marks; 0: alone */
    bool wide;   /* drawn heavier */
    bool thin;   /* drawn lighter: many curves, or what stands behind */
    bool dashed; /* of another state, to compare with */
};

/* Series of data in the axis' shown unit. NaN breaks a line. `y_high` is NULL unless the kind is THUD_FILL. */
struct thud_series {
    const char *name; /* in the key; empty: not there. The same name in two panels is one entry */
    struct thud_style style;
    size_t n;
    double *x, *y, *y_high;
};

/* Returns whether a series is drawn faintly behind its curve, and not in the key. */
static inline bool thud_series_is_shade(const struct thud_series *series)
{
    return series->style.kind == THUD_FILL && series->style.thin;
}

struct thud_tick {
    double at;
    const char *text;
};

struct thud_axis {
    const char *label, *unit; /* empty unit: a plain number */
    bool log;
    double least, most; /* NaN: from the data */
    bool results;       /* x holds results, as y does: none of them may lie on the frame */
    int nticks;         /* named ticks in place of numbers; 0: numbers */
    struct thud_tick *tick;
};

/* Reference line (from == to) or band across the panel at values of one axis, behind the series. */
struct thud_mark {
    enum thud_side side; /* the axis that `from` and `to` are values of */
    double from, to;
    const char *text; /* may be empty */
};

/* Label at a place, in front of the series: -1 left of it, 0 on it, 1 right of it. */
struct thud_label {
    double x, y;
    int side;
    const char *text;
};

/* Map of a quantity over two parameters: z is (ny x nx), row-major, NaN where there is none. Contours at `level`. */
struct thud_map {
    size_t nx, ny;
    double *x, *y, *z;
    const char *label, *unit;
    double centre;                 /* the palette's neutral value (1 for ratios); NaN: a palette from low to high */
    double level;                  /* of the contour; NaN: none */
    double reach;                  /* of the palette to either side of the centre; 0: from the data */
    const char *const *class_name; /* static: what z = 0, 1, ... are called; NULL: z is a quantity */
    int classes;
};

struct thud_panel {
    struct thud_figure *figure;
    const char *title;
    const char *note;         /* one line under the title */
    struct thud_axis axis[2]; /* by enum thud_side */
    int nseries, nmarks, nlabels;
    struct thud_series **series;
    struct thud_mark *mark;
    struct thud_label *label;
    struct thud_map *map; /* NULL: none */
    bool closer;          /* another panel's series, seen closer */
    bool strip;           /* one of a stack of small ones with one x axis, at the lowest; its title stands inside */
    bool drawing;         /* of things, not of results: no grid, no numbers along x */
    bool used;
};

struct thud_figure {
    const char *name; /* of its files, without a suffix: a-z, 0-9 and `-` */
    const char *title;
    const char *note; /* footer; may be empty */
    /* All motions of a study, or one and its kind. */
    enum { THUD_MOTIONS, THUD_MOTION_RECORDED, THUD_MOTION_SYNTHETIC } motion;
    int rows, columns;
    struct thud_panel *panel; /* (rows x columns), row-major */
    bool failed;
    struct thud_figure_block *blocks; /* private */
};

/* Returns a figure; NULL when out of memory. */
struct thud_figure *thud_figure_create(const char *name, const char *title, int rows, int columns);
void thud_figure_free(struct thud_figure *figure);
/* Returns a copy; NULL when out of memory. */
struct thud_figure *thud_figure_copy(const struct thud_figure *figure);
/* Write a figure as bytes for another process of the same program, and read the next figure from such bytes; NULL:
 * incomplete, or out of memory. */
void thud_figure_write(const struct thud_figure *figure, struct thud_text *out);
struct thud_figure *thud_figure_read(const char **bytes, const char *end);
/* Renames the files of the figure. */
void thud_figure_rename(struct thud_figure *figure, const char *name);
/* Returns THUD_MEMORY if anything could not be kept, else THUD_OK. */
enum thud_status thud_figure_check(const struct thud_figure *figure, struct thud_error *err);
/* Adds to the footer. */
void thud_figure_note(struct thud_figure *figure, const char *text);

/* Sets words in brackets after the title; "": none. A NULL figure is ignored. */
void thud_figure_title_add(struct thud_figure *figure, const char *text);
/* Does the same with what the motions are, "1 of 2 motions synthetic"; a figure of one of them says it of that one. */
void thud_figure_title_motions(struct thud_figure *figure, const char *motions);

/* Returns a new panel; row and column from 0, from the top left. */
struct thud_panel *thud_figure_panel(struct thud_figure *figure, int row, int column, const char *title);
void thud_panel_note(struct thud_panel *panel, const char *text);
void thud_panel_axis(struct thud_panel *panel, enum thud_side side, const char *label, const char *unit);
void thud_panel_limits(struct thud_panel *panel, enum thud_side side, double least, double most);
/* Marks an axis of shares in %, with 0 and 100 % inside the frame. */
void thud_panel_share_axis(struct thud_panel *panel, enum thud_side side, const char *label);
/* Marks x as an axis of results instead of inputs. */
void thud_panel_results_on_x(struct thud_panel *panel);
void thud_panel_log(struct thud_panel *panel, enum thud_side side);
void thud_panel_tick(struct thud_panel *panel, enum thud_side side, double at, const char *text);
void thud_panel_mark(struct thud_panel *panel, enum thud_side side, double from, double to, const char *text);

void thud_panel_label(struct thud_panel *panel, double x, double y, int side, const char *text);

/* Adds a series of n copied values; x or y NULL: zeros, to be filled by the caller. NULL when out of memory. */
struct thud_series *thud_panel_add(struct thud_panel *panel, struct thud_style style, const char *name, size_t n,
                                   const double *x, const double *y);
/* Does the same with `low` in y. */
struct thud_series *thud_panel_fill(struct thud_panel *panel, struct thud_style style, const char *name, size_t n,
                                    const double *x, const double *low, const double *high);
/* Adds ranges of n values, from low to high, as upright lines without a name; nothing if all are NaN. */
void thud_panel_bars(struct thud_panel *panel, int color, size_t n, const double *x, const double *low,
                     const double *high);
/* Adds a map; z NULL: NaN everywhere, to be filled. NULL when out of memory. */
struct thud_map *thud_panel_map(struct thud_panel *panel, size_t nx, const double *x, size_t ny, const double *y,
                                const double *z, const char *label, const char *unit);

/* Makes all panels of a figure strips, where there is more than a row of them. */
void thud_figure_strips(struct thud_figure *figure);

/* Makes `panel` a closer look at `from` between two values of x: same series and labels; the stretch is marked in
 * `from`. */
void thud_panel_zoom(struct thud_panel *panel, struct thud_panel *from, double least, double most);

/* Range of an axis: round limits that hold all data, marks at their place, and the tick spacing (0 on a log axis). */
struct thud_range {
    double least, most, step;
};
struct thud_range thud_panel_range(const struct thud_panel *panel, enum thud_side side);

/* Gives n panels, `step` apart in the list, one scale, so that their sizes compare. Those of `other` (or NULL), a
 * figure of the same shape, count too. A panel with both limits set keeps them, and closer looks follow the others. */
void thud_figure_share_scale(struct thud_figure *figure, enum thud_side side, int first, int step, int n,
                             const struct thud_figure *other);

/* Lists the key: every name once, in the order of the colours and of first appearance. Returns their number, and fills
 * at most `most`. */
int thud_figure_key(const struct thud_figure *figure, const struct thud_series **entry, int most);

/* Writes "Gap (cm)". Returns `text`. */
char *thud_axis_text(const struct thud_axis *axis, char *text, size_t size);

/* Writes all data of a figure as CSV: panel, series, then a column for each variable (an axis, a map's quantity, the
 * upper end of a band), headed by its name and unit. A row has numbers only in the columns of its panel. */
void thud_figure_csv(const struct thud_figure *figure, struct thud_text *out);

/* Writes a sentence for each panel of a figure: its quantities, and the range of each curve. */
void thud_figure_words(const struct thud_figure *figure, struct thud_text *out);

/* Finds the least and largest number of z; false: none. */
bool thud_map_range(const struct thud_map *map, double *least, double *most);

/* Computes pieces of the contour at map->level as pairs of points; returns their number, writes at most `most` (x0 y0
 * x1 y1 each). */
size_t thud_map_contour(const struct thud_map *map, double (*piece)[4], size_t most);
