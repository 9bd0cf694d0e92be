/* A gnuplot script from a figure: the sheet, its key, title and footer. Everything a user may have typed goes through
 * thud_gnuplot_quote, and the terminal is told not to look for markup. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/utf8.h"
#include "base/version.h"
#include "plot/gnuplot/gnuplot_internal.h"

static const char default_font[] = "DejaVu Sans";

/* Each terminal has its own unit (found by measuring): pngcairo takes 1/96 inch for a pixel, and svg writes what it is
 * given. pdfcairo draws a point of text a third larger than 1/72 inch. */
static void terminal(const struct sheet *sheet, const struct thud_picture_options *options)
{
    static const char *const name[] = {[THUD_PNG] = "pngcairo noenhanced color",
                                       [THUD_SVG] = "svg noenhanced",
                                       [THUD_PDF] = "pdfcairo noenhanced color",
                                       [THUD_SIXEL] = "sixelgd noenhanced notransparent"};
    struct thud_text *out = sheet->out;
    thud_text_append(out, "set terminal %s background rgb 'white' linewidth LW ", name[options->format]);
    if (options->format == THUD_PDF)
        thud_text_append(out, "size W/%d.0in,H/%d.0in fontscale 1 ", THUD_PDF_DPI, THUD_PDF_DPI);
    else
        thud_text_append(out, "size W,H ");
    if (options->format == THUD_SIXEL) { /* which takes no expression there */
        char font[200];
        snprintf(font, sizeof font, "%.128s,%.4g", options->font ? options->font : default_font,
                 sheet->em * sheet->points);
        thud_text_append(out, "font ");
        thud_gnuplot_quote(out, font, 0.0, 0.0);
        thud_text_append(out, "\n");
    } else {
        thud_text_append(out, "font sprintf('%%s,%%.4g', FONT, PT)\n");
    }
}

/* Every size and place that a hand may want to change, at the top of the script. */
static void variables(const struct sheet *sheet, const struct thud_picture_options *options)
{
    struct thud_text *out = sheet->out;
    double unit = options->format == THUD_PDF ? 120.0 / THUD_PDF_DPI : 1.0;
    char font[160];
    snprintf(font, sizeof font, "%.128s", options->font ? options->font : default_font);
    thud_text_append(out,
                     "\n# Sizes and places: change them here.\n"
                     "W = %.0f; H = %.0f    # of the picture, %s\nFONT = ",
                     sheet->width, sheet->height, options->format == THUD_PDF ? "200 to the inch" : "pixels");
    thud_gnuplot_quote(out, font, 0.0, 0.0);
    thud_text_append(out,
                     "; PT = %.4g    # size of the type\nSMALL = %g    # of the smallest letters, of PT\nLW = %.4g    "
                     "# width of a thin line\n"
                     "DOT = %.3g    # size of a mark\nEX = %.5f; EY = %.5f    # an em, of W and of H\n",
                     sheet->em * sheet->points, THUD_SMALL_EM, sheet->line * unit, sheet->dot, sheet->em / sheet->width,
                     sheet->em / sheet->height);
    for (int i = 0; i < sheet->figure->rows * sheet->figure->columns; i++) {
        struct box box = thud_sheet_frame(sheet, i);
        if (sheet->figure->panel[i].used)
            thud_text_append(out,
                             "L%d = %.5f; R%d = %.5f; B%d = %.5f; T%d = %.5f    # panel %d: left, right, bottom, top\n",
                             i + 1, box.left / sheet->width, i + 1, box.right / sheet->width, i + 1,
                             box.bottom / sheet->height, i + 1, box.top / sheet->height, i + 1);
    }
    thud_text_append(out, "KEY = %.5f    # height of the key\n\n",
                     (sheet->foot - sheet->key_foot - 1.0 * sheet->em) / sheet->height);
}

/* A text across the sheet, in as many lines as it takes: the first one at `height`. */
static void wide_label(const struct sheet *sheet, int number, const char *text, const char *height, double size)
{
    size_t at[THUD_LINES_MAX + 1];
    int n = thud_gnuplot_wrap(text, 0.96 * sheet->width, size * sheet->em, at);
    for (int i = 0; i < n; i++) {
        struct thud_text line = {0};
        size_t length = at[i + 1] - at[i];
        while (length > 0 && i + 1 < n && text[at[i] + length - 1] == ' ')
            length--;
        thud_text_bytes(&line, text + at[i], length);
        thud_text_append(sheet->out, "set label %d ", number + i);
        thud_gnuplot_quote(sheet->out, line.data ? line.data : "", 0.0, 0.0);
        thud_text_append(sheet->out, " at screen 0.5, screen %s-%.3g*EY center font sprintf(',%%.4g', %.3g*PT) ",
                         height, (number == 1 ? 1.6 : 1.3) * i, size);
        thud_text_append(sheet->out, "textcolor rgb '%s'\n", number == 1 ? "black" : "#404040");
        sheet->out->failed |= line.failed;
        thud_text_clear(&line);
    }
}

/* An entry of the key: a piece of its line, or of its band. */
static void key_sample(const struct sheet *sheet, int i)
{
    struct thud_text *out = sheet->out;
    double left = sheet->key_at[i].left / sheet->width;
    int row = sheet->key_at[i].row;
    const enum thud_series_kind kind = sheet->key[i]->style.kind;
    const bool band = kind == THUD_FILL || kind == THUD_BARS, points = kind == THUD_POINTS;
    thud_text_append(out, "%s'+' every ::0::%d using (%.5f+$0*%.3g*EX):(KEY-%.3g*EY%s)%s ", i ? ", \\\n     " : "plot ",
                     band ? 1 : 2, points ? left + 0.2 * THUD_SAMPLE_EM * sheet->em / sheet->width : left,
                     band     ? THUD_SAMPLE_EM
                     : points ? 0.3 * THUD_SAMPLE_EM
                              : 0.5 * THUD_SAMPLE_EM,
                     1.6 * row, band ? "-0.35*EY" : "", "");
    if (band)
        thud_text_append(out, ":(KEY-%.3g*EY+0.35*EY) ", 1.6 * row);
    thud_gnuplot_style(sheet, sheet->key[i], true);
}

/* Title, footer and key on a plot that shows nothing else. */
static void surroundings(const struct sheet *sheet)
{
    struct thud_text *out = sheet->out;
    thud_text_append(out, "\nreset\nset margins screen 0, screen 1, screen 0, screen 1\nunset border\nunset tics\n"
                          "unset key\nset samples 3\n");
    thud_text_append(out, "set xrange [0:1]\nset yrange [0:1]\n");
    char footer[32];
    int note = thud_gnuplot_wrap(sheet->figure->note, 0.96 * sheet->width, THUD_SMALL_EM * sheet->em, NULL);
    snprintf(footer, sizeof footer, "%.3g*EY", 0.9 + 1.3 * (note - 1));
    wide_label(sheet, 1, sheet->title, "1-1.3*EY", THUD_TITLE_EM);
    wide_label(sheet, 1 + THUD_LINES_MAX, sheet->figure->note, footer, THUD_SMALL_EM);
    for (int i = 0; i < sheet->nkeys; i++) {
        thud_text_append(out, "set label %d ", 40 + i);
        thud_gnuplot_quote(out, sheet->key[i]->name, 0.96 * sheet->width - (THUD_SAMPLE_EM + 0.5) * sheet->em,
                           sheet->key_at[i].em);
        thud_text_append(out, " at screen %.5f+%.3g*EX, screen KEY-%.3g*EY left font sprintf(',%%.4g', %.3g*PT)\n",
                         sheet->key_at[i].left / sheet->width, THUD_SAMPLE_EM + 0.5, 1.6 * sheet->key_at[i].row,
                         sheet->key_at[i].em / sheet->em);
    }
    for (int i = 0; i < sheet->nkeys; i++)
        key_sample(sheet, i);
    thud_text_append(out, sheet->nkeys ? "\n" : "plot NaN notitle\n");
}

enum thud_status thud_gnuplot_script(const struct thud_figure *figure, const struct thud_picture_options *options,
                                     const char *output, struct thud_text *script, struct thud_error *err)
{
    enum thud_status status = thud_figure_check(figure, err);
    if (status != THUD_OK)
        return status;
    struct sheet sheet = thud_sheet_make(figure, options, script);
    int panels = figure->rows * figure->columns;
    thud_text_append(script, "# A figure by thud " THUD_VERSION "; `gnuplot` and this file's name draw it again.\n"
                             "set encoding utf8\n");
    variables(&sheet, options);
    for (int i = 0; i < panels; i++)
        thud_gnuplot_data(&sheet, i);
    terminal(&sheet, options);
    if (output) {
        thud_text_append(script, "set output ");
        thud_gnuplot_quote(script, output, 0.0, 0.0);
        thud_text_append(script, "\n");
    }
    thud_text_append(script, "set multiplot\n");
    for (int i = 0; i < panels; i++)
        thud_gnuplot_panel(&sheet, i);
    surroundings(&sheet);
    thud_text_append(script, "unset multiplot\nset output\n");
    if (!script->failed)
        return THUD_OK;
    thud_text_clear(script);
    return thud_error_set(err, THUD_MEMORY, "out of memory for a figure's script");
}
