/* A gnuplot script from a figure: the sheet, its key, title and footer. Everything a user may have typed goes through
 * thud_gnuplot_quote, and the terminal is told not to look for markup. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/utf8.h"
#include "base/version.h"
#include "plot/gnuplot_internal.h"

enum { PDF_DPI = 200 };

static const double char_em = 0.55; /* mean width of DejaVu Sans, on the safe side */

/* About how wide a text is, px. */
static double width_of(const char *text, double em)
{
    return char_em * em * thud_utf8_columns(text);
}

double thud_gnuplot_fit(const char *text, double widest, double em)
{
    double width = width_of(text, em);
    return width > widest ? em * fmax(0.75, widest / width) : em;
}

/* A byte that means something within double quotes: as an octal escape. */
static void escaped(struct thud_text *out, char byte)
{
    thud_text_append(out, "\\%03o", (unsigned)(unsigned char)byte);
}

/* gnuplot 5.4 does not read an apostrophe doubled at the beginning of a single-quoted text, nor two in a row: a text
 * with an apostrophe stands in double quotes. */
void thud_gnuplot_quote(struct thud_text *out, const char *text, double widest, double em)
{
    size_t most = widest > 0.0 ? (size_t)fmax(3.0, widest / (char_em * em)) : (size_t)-1, n = 0;
    bool cut = widest > 0.0 && width_of(text, em) > widest, twice = strchr(text, '\'') != NULL;
    const char *quote = twice ? "\"" : "'";
    thud_text_bytes(out, quote, 1);
    while (*text) {
        size_t size = (size_t)thud_utf8_length(text);
        if (cut && ++n == most) {
            thud_text_append(out, "…");
            break;
        }
        if (size == 0)
            thud_text_bytes(out, "?", 1);
        else if (size == 1 && ((unsigned char)*text < 0x20 || *text == 0x7f))
            thud_text_bytes(out, " ", 1);
        else if (twice && strchr("\"\\`@$", *text))
            escaped(out, *text);
        else
            thud_text_bytes(out, text, size);
        text += size ? size : 1;
    }
    thud_text_bytes(out, quote, 1);
}

/* Size, font and room for the key, from the options and the figure. */
static struct sheet make_sheet(const struct thud_figure *figure, const struct thud_picture_options *options,
                               struct thud_text *out)
{
    struct sheet sheet = {.figure = figure, .out = out};
    sheet.width = options->width_px ? options->width_px : 1800;
    double share = figure->columns > 1 ? 0.36 : 0.42; /* height of a row over the sheet's width */
    if (figure->rows == 1)
        share = figure->columns > 2 ? 0.42 : 0.55;
    sheet.height = options->height_px ? options->height_px : floor(sheet.width * (0.08 + share * figure->rows));
    sheet.em = options->font_px > 0.0 ? options->font_px : fmin(sheet.width, 1.6 * sheet.height) / 66.0;
    sheet.line = sheet.em / 14.0;
    sheet.points = options->format == THUD_SVG ? 1.0 : options->format == THUD_PDF ? 54.0 / PDF_DPI : 0.75;
    sheet.dot = options->format == THUD_PDF   ? 0.027 * sheet.em
                : options->format == THUD_SVG ? 0.018 * sheet.em
                                              : 0.041 * sheet.em;
    int most = (int)(sizeof sheet.key / sizeof *sheet.key);
    sheet.nkeys = thud_figure_key(figure, sheet.key, most);
    if (sheet.nkeys > most)
        sheet.nkeys = most;
    double widest = 0.0;
    for (int i = 0; i < sheet.nkeys; i++)
        widest = fmax(widest, width_of(sheet.key[i]->name, sheet.em));
    widest = fmin(widest, 0.22 * sheet.width);
    sheet.key_left = sheet.width - (sheet.nkeys ? widest + 4.5 * sheet.em : 0.8 * sheet.em);
    return sheet;
}

struct box thud_sheet_frame(const struct sheet *sheet, int panel)
{
    int row = panel / sheet->figure->columns, column = panel % sheet->figure->columns;
    double head = *sheet->figure->title ? 2.6 * sheet->em : 0.8 * sheet->em;
    double foot = *sheet->figure->note ? 2.0 * sheet->em : 0.4 * sheet->em;
    double width = sheet->key_left / sheet->figure->columns;
    double height = (sheet->height - head - foot) / sheet->figure->rows;
    double names = 0.0; /* room for named ticks */
    const struct thud_axis *axis = &sheet->figure->panel[panel].axis[THUD_Y];
    for (int i = 0; i < axis->nticks; i++)
        names = fmax(names, width_of(axis->tick[i].text, sheet->em));
    struct box box;
    box.left = column * width + fmin(fmax(6.8 * sheet->em, names + 3.4 * sheet->em), 0.5 * width);
    box.label = column * width + (column ? 2.0 : 1.4) * sheet->em;
    box.right = (column + 1) * width - (sheet->figure->panel[panel].map ? 8.0 : 1.2) * sheet->em;
    box.top = sheet->height - head - row * height - (*sheet->figure->panel[panel].note ? 3.4 : 2.3) * sheet->em;
    box.bottom = sheet->height - head - (row + 1) * height + 3.7 * sheet->em;
    return box;
}

/* Each terminal counts in its own way (found by measuring): pngcairo takes 1/96 inch for a pixel, svg writes what it is
 * given, pdfcairo draws a point of text a third larger than 1/72 inch. */
static void terminal(const struct sheet *sheet, const struct thud_picture_options *options)
{
    static const char *const name[] = {"pngcairo noenhanced color", "svg noenhanced", "pdfcairo noenhanced color"};
    struct thud_text *out = sheet->out;
    double points = sheet->em * sheet->points, unit = options->format == THUD_PDF ? 120.0 / PDF_DPI : 1.0;
    thud_text_append(out, "set terminal %s background rgb 'white' linewidth %.4g ", name[options->format],
                     sheet->line * unit);
    if (options->format == THUD_PDF)
        thud_text_append(out, "size %.4fin,%.4fin fontscale 1 ", sheet->width / PDF_DPI, sheet->height / PDF_DPI);
    else
        thud_text_append(out, "size %.0f,%.0f ", sheet->width, sheet->height);
    char font[160];
    snprintf(font, sizeof font, "%.128s,%.4g", options->font ? options->font : "DejaVu Sans", points);
    thud_text_append(out, "font ");
    thud_gnuplot_quote(out, font, 0.0, 0.0);
    thud_text_append(out, "\n");
}

/* A line of text across the sheet. */
static void wide_label(const struct sheet *sheet, int number, const char *text, double height, double em)
{
    if (!*text)
        return;
    em = thud_gnuplot_fit(text, 0.96 * sheet->width, em);
    thud_text_append(sheet->out, "set label %d ", number);
    thud_gnuplot_quote(sheet->out, text, 0.96 * sheet->width, em);
    thud_text_append(sheet->out, " at screen 0.5, screen %.5f center font ',%.4g' textcolor rgb '%s'\n", height,
                     em * sheet->points, number == 1 ? "black" : "#404040");
}

/* Title, footer and key on a plot that shows nothing else. */
static void surroundings(const struct sheet *sheet)
{
    struct thud_text *out = sheet->out;
    thud_text_append(out, "\nreset\nset margins screen 0, screen 1, screen 0, screen 1\nunset border\nunset tics\n");
    thud_text_append(out, "set xrange [0:1]\nset yrange [0:1]\n");
    wide_label(sheet, 1, sheet->figure->title, 1.0 - 1.3 * sheet->em / sheet->height, 1.2 * sheet->em);
    wide_label(sheet, 2, sheet->figure->note, sheet->em / sheet->height, 0.85 * sheet->em);
    thud_text_append(
        out, "set key at screen %.5f, screen %.5f left top Left reverse samplen 2 spacing 1.25 noautotitle\n",
        (sheet->key_left + 0.4 * sheet->em) / sheet->width, thud_sheet_frame(sheet, 0).top / sheet->height);
    thud_text_append(out, "plot NaN notitle");
    for (int i = 0; i < sheet->nkeys; i++) {
        thud_text_append(out, ", NaN ");
        thud_gnuplot_style(sheet, sheet->key[i]);
        thud_text_append(out, " title ");
        thud_gnuplot_quote(out, sheet->key[i]->name, 0.22 * sheet->width, sheet->em);
    }
    thud_text_append(out, "\n");
}

enum thud_status thud_gnuplot_script(const struct thud_figure *figure, const struct thud_picture_options *options,
                                     const char *output, struct thud_text *script, struct thud_error *err)
{
    enum thud_status status = thud_figure_check(figure, err);
    if (status != THUD_OK)
        return status;
    struct sheet sheet = make_sheet(figure, options, script);
    int panels = figure->rows * figure->columns;
    thud_text_append(script, "# A figure by thud " THUD_VERSION "; `gnuplot` and this file's name draw it again.\n"
                             "set encoding utf8\n");
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
