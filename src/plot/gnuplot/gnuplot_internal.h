/* Shared by the files that make and run gnuplot scripts. */
#pragma once

#include "plot/gnuplot/gnuplot.h"

/* Size of the title and of the smallest letters (7 points where type has 8), room of a sample of a line and what
 * follows a name in the key, ems. */
#define THUD_TITLE_EM  1.15
#define THUD_SMALL_EM  0.875
#define THUD_SAMPLE_EM 2.6
#define THUD_BEHIND_EM 1.6
enum { THUD_PDF_DPI = 200, THUD_LINES_MAX = 8, THUD_PANELS_KNOWN = 64 };

#define THUD_GNUPLOT_DONE "thud: drawn to the end"

/* Places on the picture, in px from its lower left corner. */
struct box {
    double left, right, bottom, top;
    double label; /* middle of the y axis' label */
};

struct sheet {
    const struct thud_figure *figure;
    const char *title;
    struct thud_text *out;
    double width, height; /* px */
    double em;            /* px */
    double line;          /* px: the width of a thin line */
    double points;        /* font size as the terminal counts it, for 1 px of em */
    double dot;           /* point size as the terminal counts it */
    int rows, columns;    /* of panels: below each other where the sheet is too narrow for the figure's columns */
    const struct thud_series *key[24];
    int nkeys, key_rows;
    struct {
        int row;
        double left, em; /* px */
    } key_at[24];
    double head, foot; /* px: above and below the panels */
    bool one_x;        /* panels below each other have one x axis, at the lowest */
    double key_foot;   /* px: of the foot, what that axis takes above the key */
    /* Of the first panels, as they are asked for often and take a look at every point. */
    struct thud_range range[THUD_PANELS_KNOWN][2];
    bool hits_title[THUD_PANELS_KNOWN];
};

struct sheet thud_sheet_make(const struct thud_figure *figure, const struct thud_picture_options *options,
                             struct thud_text *out);
/* What an axis of a panel (from 0) shows. */
struct thud_range thud_sheet_range(const struct sheet *sheet, int panel, enum thud_side side);
/* The title of a strip stands inside, in its upper left corner: what share of the height it takes, and whether a curve
 * would run through it. */
double thud_sheet_title_share(const struct sheet *sheet, const struct box *box);
bool thud_sheet_hits_title(const struct sheet *sheet, int panel);
/* The frame of a panel. */
struct box thud_sheet_frame(const struct sheet *sheet, int panel);
/* Where the title of the y axis goes on in a second line, bytes; 0: in one it is not too long for the frame. */
size_t thud_sheet_break(const struct sheet *sheet, int panel);
/* The size of the names of ticks along y, which may take so much of the width; their room. */
double thud_sheet_names_em(const struct sheet *sheet, int panel);
double thud_sheet_names_room(const struct sheet *sheet);

/* In quotes for gnuplot, which then takes no character for anything but itself; at most `widest` px of it (0: all),
 * control characters as spaces. */
void thud_gnuplot_quote(struct thud_text *out, const char *text, double widest, double em);

/* Width of a text in letters of a size, about. */
double thud_gnuplot_width(const char *text, double em);
/* The em, made up to a quarter smaller where the text needs it to fit. */
double thud_gnuplot_fit(const char *text, double widest, double em);

/* Lines of about one length that a text takes, at most THUD_LINES_MAX: no unit or last word stands alone. Where each
 * begins (the last one's end comes after it) in *at, which may be NULL. */
int thud_gnuplot_wrap(const char *text, double widest, double em, size_t at[THUD_LINES_MAX + 1]);

/* Data blocks of a panel, and the panel itself. */
void thud_gnuplot_data(const struct sheet *sheet, int panel);
void thud_gnuplot_panel(const struct sheet *sheet, int panel);
/* How a series is drawn: "with lines lc rgb ..."; in the key a mark stands in the middle of its line. */
void thud_gnuplot_style(const struct sheet *sheet, const struct thud_series *series, bool key);

/* Makes of what gnuplot 5.4 to 6.0 write the same, and what readers take; an SVG gets the figure's own title and
 * description. The picture has failed where there is no memory for it. */
void thud_picture_mend(const struct thud_figure *figure, enum thud_picture_format format, struct thud_text *picture);
enum thud_status thud_picture_check(enum thud_picture_format format, const struct thud_text *picture,
                                    struct thud_error *err);
