/* Draws figures with gnuplot 5.4: the script as pure text, and the child process. No file is touched here: the picture
 * is returned as bytes, so that its writer sees every error of the disk. */
#pragma once

#include <stdatomic.h>
#include <stdbool.h>

#include "base/status.h"
#include "base/text.h"
#include "plot/figure/figure.h"

enum thud_picture_format {
    THUD_PNG,
    THUD_SVG,
    THUD_PDF,
    THUD_PICTURE_FORMATS, /* those of files; and for a terminal that draws them: */
    THUD_SIXEL = THUD_PICTURE_FORMATS
};

/* Options of a picture; 0: chosen for the figure. */
struct thud_picture_options {
    enum thud_picture_format format;
    int width_px, height_px;  /* PDF: 200 to the inch */
    double width_mm;          /* on paper: type of 8 points and lines of half a point there; before width_px */
    const char *font;         /* NULL: DejaVu Sans */
    double font_px;           /* height of an em */
    const char *program;      /* NULL: `gnuplot` from PATH */
    double deadline_s;        /* 0: 20 */
    const atomic_int *cancel; /* not NULL: drawing stops when it becomes other than 0 */
    bool none;                /* where a figure is saved: it is not */
    void (*drawing)(void *context, const struct thud_figure *figure); /* before each one that is saved; may be NULL */
    bool no_title;                                                    /* above the panels: a caption says it */
    bool no_data;     /* where a figure is saved: no CSV of it, its data stand in another file */
    char motions[64]; /* text on the ground motions after every title; empty: nothing */
};

const char *thud_picture_suffix(enum thud_picture_format format); /* "png" */
/* Reads a format. Errors: THUD_USAGE naming what is allowed. */
enum thud_status thud_picture_format_parse(const char *text, enum thud_picture_format *out, struct thud_error *err);
/* Reads "1800x1200". Errors: THUD_USAGE. */
enum thud_status thud_picture_size_parse(const char *text, int *width_px, int *height_px, struct thud_error *err);
/* Reads "90mm". Errors: THUD_USAGE. */
enum thud_status thud_picture_width_parse(const char *text, double *width_mm, struct thud_error *err);
/* Reads "DejaVu Serif" or "DejaVu Serif,28": copies the name to `name`; *font_px stays if no size is given. Errors:
 * THUD_USAGE. */
enum thud_status thud_picture_font_parse(const char *text, char *name, size_t size, double *font_px,
                                         struct thud_error *err);

/* Omits the closer looks beside strips if the picture has no room for the titles of both, and reports it. */
void thud_figure_fit(struct thud_figure *figure, const struct thud_picture_options *options);

/* Writes the script with all data inside. `output` is the file it writes when run by hand (a plain name; NULL: standard
 * output). Traces are reduced to what the picture can show. Errors: THUD_MEMORY. */
enum thud_status thud_gnuplot_script(const struct thud_figure *figure, const struct thud_picture_options *options,
                                     const char *output, struct thud_text *script, struct thud_error *err);

/* Draws the figure; `picture` (cleared on failure) gets the whole picture, checked from its first byte to its last
 * mark. Errors: THUD_GNUPLOT (missing, failed with gnuplot's own words, too slow, an incomplete picture),
 * THUD_CANCELLED, THUD_MEMORY. */
enum thud_status thud_gnuplot_draw(const struct thud_figure *figure, const struct thud_picture_options *options,
                                   struct thud_text *picture, struct thud_error *err);
