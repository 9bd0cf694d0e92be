/* A gnuplot script from a figure: the sheet, its key, title and footer. Everything a user may have typed goes through
 * thud_gnuplot_quote, and the terminal is told not to look for markup. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/utf8.h"
#include "base/version.h"
#include "plot/gnuplot/gnuplot_internal.h"

enum { PDF_DPI = 200 };
static const char default_font[] = "DejaVu Sans";

/* Width of a character of DejaVu Sans, ems. */
static double advance(unsigned char c)
{
    if (strchr("ijl'|", c))
        return 0.3;
    if (strchr(".,:;fIJrt()[]-/! ", c))
        return 0.39;
    if (strchr("mMwW%@", c))
        return 0.93;
    return c >= 'A' && c <= 'Z' ? 0.7 : c >= '0' && c <= '9' ? 0.64 : 0.62;
}

double thud_gnuplot_width(const char *text, double em)
{
    double sum = 0;
    for (size_t step; *text; text += step ? step : 1) {
        step = (size_t)thud_utf8_length(text);
        sum += step == 1 ? advance((unsigned char)*text) : 0.65;
    }
    return em * sum;
}

double thud_gnuplot_fit(const char *text, double widest, double em)
{
    double width = thud_gnuplot_width(text, em);
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
    bool cut = widest > 0.0 && thud_gnuplot_width(text, em) > widest, twice = strchr(text, '\'') != NULL;
    double used = em; /* with the sign that it goes on */
    const char *quote = twice ? "\"" : "'";
    thud_text_bytes(out, quote, 1);
    while (*text) {
        size_t size = (size_t)thud_utf8_length(text);
        used += size == 1 ? em * advance((unsigned char)*text) : 0.65 * em;
        if (cut && used > widest) {
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

/* Size of the title and of the footer, ems. */
static const double title_em = 1.15, note_em = 0.85;
enum { LINES_MAX = 8 };

/* Lines that a text takes, at most LINES_MAX; where each begins (the last one's end comes after it) in *at. */
static int wrapped_at(const char *text, double widest, double em, size_t at[LINES_MAX + 1])
{
    int n = 0;
    size_t begin = 0, length = strlen(text);
    while (begin < length && n < LINES_MAX) {
        double used = 0.0;
        size_t end = begin, blank = 0;
        while (end < length && used <= widest) {
            size_t step = (size_t)thud_utf8_length(text + end);
            used += em * (step == 1 ? advance((unsigned char)text[end]) : 0.65);
            if (text[end] == ' ')
                blank = end;
            end += step ? step : 1;
        }
        if (used > widest && blank > begin && n + 1 < LINES_MAX)
            end = blank + 1;
        else if (used > widest && n + 1 == LINES_MAX)
            end = length;
        if (at) {
            at[n] = begin;
            at[n + 1] = end;
        }
        begin = end;
        n++;
    }
    return n;
}

/* The same in lines of about one length: no unit or last word stands alone. */
static int wrapped(const char *text, double widest, double em, size_t at[LINES_MAX + 1])
{
    static const double shorter = 0.95;
    int n = wrapped_at(text, widest, em, NULL);
    while (n > 1 && n < LINES_MAX && wrapped_at(text, shorter * widest, em, NULL) == n)
        widest *= shorter;
    return wrapped_at(text, widest, em, at);
}

/* Room of a sample of a line and what follows a name in the key, ems. */
static const double sample_em = 2.6, behind_em = 1.6;

/* The key under the panels, in as many rows as it takes. */
static void lay_key(struct sheet *sheet)
{
    double line[24], left = 0.0, widest = 0.96 * sheet->width;
    int most = (int)(sizeof sheet->key / sizeof *sheet->key), row = 0;
    sheet->nkeys = thud_figure_key(sheet->figure, sheet->key, most);
    if (sheet->nkeys > most)
        sheet->nkeys = most;
    for (int i = 0; i < sheet->nkeys; i++) {
        double width = thud_gnuplot_width(sheet->key[i]->name, sheet->em) + (sample_em + 0.5) * sheet->em;
        if (left > 0.0 && left + width > widest) {
            row++;
            left = 0.0;
        }
        sheet->key_at[i].row = row;
        sheet->key_at[i].left = left;
        line[row] = left + width;
        left += width + behind_em * sheet->em;
    }
    for (int i = 0; i < sheet->nkeys; i++) /* each row in the middle */
        sheet->key_at[i].left += fmax(0.02 * sheet->width, 0.5 * (sheet->width - line[sheet->key_at[i].row]));
    sheet->key_rows = sheet->nkeys > 0 ? row + 1 : 0;
}

/* On paper panels below each other share what a page of A4 has between its margins. */
static const double page_mm = 240.0, lowest_em = 10.0;
/* A panel narrower than this many ems stands below its neighbour. */
static const double narrowest_em = 21.0;

static bool has_map(const struct thud_figure *figure)
{
    for (int i = 0; i < figure->rows * figure->columns; i++)
        if (figure->panel[i].map)
            return true;
    return false;
}

/* Size, font and room for the key, from the options and the figure. On paper an inch has 300 pixels, and as many as the
 * format itself counts where it has none of its own. */
static struct sheet make_sheet(const struct thud_figure *figure, const struct thud_picture_options *options,
                               struct thud_text *out)
{
    struct sheet sheet = {.figure = figure, .out = out, .rows = figure->rows, .columns = figure->columns};
    static const double dpi[] = {[THUD_PNG] = 300.0, [THUD_SVG] = 96.0, [THUD_PDF] = PDF_DPI, [THUD_SIXEL] = 96.0};
    bool paper = options->width_mm > 0.0;
    double inch = dpi[options->format], point = inch / 72.0;
    sheet.width = paper ? floor(options->width_mm / 25.4 * inch + 0.5) : options->width_px ? options->width_px : 1800;
    sheet.em = options->font_px > 0.0 ? options->font_px : paper ? 8.0 * point : sheet.width / 66.0;
    if (options->height_px && !(options->font_px > 0.0)) /* a flat sheet */
        sheet.em = fmin(sheet.em, 1.6 * options->height_px / 66.0);
    sheet.line = paper ? 0.5 * point : sheet.em / 14.0;
    bool strips = figure->panel[0].strip;
    double narrowest = strips ? 14.0 : figure->columns > 2 ? 15.0 : narrowest_em;
    /* where panels would be too narrow half as many stand side by side, or one */
    while (sheet.columns > 1 && sheet.width / sheet.columns < (narrowest + (has_map(figure) ? 6.0 : 0.0)) * sheet.em) {
        sheet.columns = sheet.columns % 2 == 0 && !strips ? sheet.columns / 2 : 1;
        sheet.rows = figure->rows * figure->columns / sheet.columns;
    }
    lay_key(&sheet);
    int title = wrapped(figure->title, 0.96 * sheet.width, title_em * sheet.em, NULL);
    int note = wrapped(figure->note, 0.96 * sheet.width, note_em * sheet.em, NULL);
    sheet.head = (0.8 + 1.6 * title) * sheet.em;
    sheet.foot = (0.6 + 1.3 * note + 1.6 * sheet.key_rows) * sheet.em;
    /* panels a little wider than high, room for their labels besides */
    double panel = sheet.width / sheet.columns, share = sheet.columns > 2 ? 0.8 : sheet.rows > 3 ? 0.4 : 0.52;
    if (sheet.columns == 1 && sheet.rows > 1)
        share = sheet.width < 40.0 * sheet.em ? 0.5 : 0.3;
    double height = fmax(sheet.rows > 4 ? 9.0 * sheet.em : 12.0 * sheet.em, share * panel + 4.0 * sheet.em);
    double page = (page_mm / 25.4 * inch - sheet.head - sheet.foot) / sheet.rows;
    if (paper && sheet.rows > 1 && height > page)
        height = fmin(height, fmax(lowest_em * sheet.em, page));
    if (strips) {
        sheet.foot += 3.6 * sheet.em;
        sheet.key_foot = 3.6 * sheet.em;
        height = fmax(4.2, fmin(9.0, 50.0 / sheet.rows)) * sheet.em;
    }
    if (sheet.columns == 1 && sheet.rows == 1)
        height = fmax(0.5 * panel, fmax(18.0, 1.35 * figure->panel[0].axis[THUD_Y].nticks + 5.0) * sheet.em);
    sheet.height = options->height_px ? options->height_px : floor(sheet.head + sheet.foot + sheet.rows * height);
    sheet.points = options->format == THUD_SVG ? 1.0 : options->format == THUD_PDF ? 54.0 / PDF_DPI : 0.75;
    sheet.dot = 0.75 * (options->format == THUD_PDF   ? 0.027 * sheet.em
                        : options->format == THUD_SVG ? 0.018 * sheet.em
                                                      : 0.041 * sheet.em);
    return sheet;
}

struct box thud_sheet_frame(const struct sheet *sheet, int panel)
{
    int row = panel / sheet->columns, column = panel % sheet->columns;
    double width = sheet->width / sheet->columns;
    double height = (sheet->height - sheet->head - sheet->foot) / sheet->rows;
    double names = 0.0; /* room for named ticks */
    const struct thud_panel *p = &sheet->figure->panel[panel];
    const struct thud_axis *axis = &p->axis[THUD_Y];
    for (int i = 0; i < axis->nticks; i++)
        names = fmax(names, thud_gnuplot_width(axis->tick[i].text, sheet->em));
    struct box box;
    box.left = column * width + fmin(fmax(5.8 * sheet->em, names + 3.0 * sheet->em), 0.5 * width);
    box.label = column * width + (column ? 1.6 : 1.1) * sheet->em;
    box.right = (column + 1) * width - (p->map ? 7.4 : 1.2) * sheet->em;
    double above = (*p->title ? 1.5 : 0.5) + (*p->note ? 1.1 : 0.0);
    box.top = sheet->height - sheet->head - row * height - above * sheet->em;
    box.bottom = sheet->height - sheet->head - (row + 1) * height + 3.7 * sheet->em;
    if (p->strip) {
        box.top = sheet->height - sheet->head - row * height - 0.3 * sheet->em;
        box.bottom = sheet->height - sheet->head - (row + 1) * height + 0.3 * sheet->em;
        box.left = column * width + 4.2 * sheet->em;
    }
    return box;
}

/* Each terminal counts in its own way (found by measuring): pngcairo takes 1/96 inch for a pixel, svg writes what it is
 * given, pdfcairo draws a point of text a third larger than 1/72 inch. */
static void terminal(const struct sheet *sheet, const struct thud_picture_options *options)
{
    static const char *const name[] = {"pngcairo noenhanced color", "svg noenhanced", "pdfcairo noenhanced color",
                                       "sixelgd noenhanced notransparent"};
    struct thud_text *out = sheet->out;
    thud_text_append(out, "set terminal %s background rgb 'white' linewidth LW ", name[options->format]);
    if (options->format == THUD_PDF)
        thud_text_append(out, "size W/%d.0in,H/%d.0in fontscale 1 ", PDF_DPI, PDF_DPI);
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
    double unit = options->format == THUD_PDF ? 120.0 / PDF_DPI : 1.0;
    char font[160];
    snprintf(font, sizeof font, "%.128s", options->font ? options->font : default_font);
    thud_text_append(out,
                     "\n# Sizes and places: change them here.\n"
                     "W = %.0f; H = %.0f    # of the picture, %s\nFONT = ",
                     sheet->width, sheet->height, options->format == THUD_PDF ? "200 to the inch" : "pixels");
    thud_gnuplot_quote(out, font, 0.0, 0.0);
    thud_text_append(out,
                     "; PT = %.4g    # size of the type\nLW = %.4g    # width of a thin line\n"
                     "DOT = %.3g    # size of a mark\nEX = %.5f; EY = %.5f    # an em, of W and of H\n",
                     sheet->em * sheet->points, sheet->line * unit, sheet->dot, sheet->em / sheet->width,
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
    size_t at[LINES_MAX + 1];
    int n = wrapped(text, 0.96 * sheet->width, size * sheet->em, at);
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
    bool band = sheet->key[i]->style.kind == THUD_FILL || sheet->key[i]->style.kind == THUD_BARS;
    thud_text_append(out, "%s'+' every ::0::%d using (%.5f+$0*%.3g*EX):(KEY-%.3g*EY%s)%s ", i ? ", \\\n     " : "plot ",
                     band ? 1 : 2, left, band ? sample_em : 0.5 * sample_em, 1.6 * row, band ? "-0.35*EY" : "", "");
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
    int note = wrapped(sheet->figure->note, 0.96 * sheet->width, note_em * sheet->em, NULL);
    snprintf(footer, sizeof footer, "%.3g*EY", 0.9 + 1.3 * (note - 1));
    wide_label(sheet, 1, sheet->figure->title, "1-1.3*EY", title_em);
    wide_label(sheet, 1 + LINES_MAX, sheet->figure->note, footer, note_em);
    for (int i = 0; i < sheet->nkeys; i++) {
        thud_text_append(out, "set label %d ", 40 + i);
        thud_gnuplot_quote(out, sheet->key[i]->name, 0.96 * sheet->width, sheet->em);
        thud_text_append(out, " at screen %.5f+%.3g*EX, screen KEY-%.3g*EY left\n",
                         sheet->key_at[i].left / sheet->width, sample_em + 0.5, 1.6 * sheet->key_at[i].row);
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
    struct sheet sheet = make_sheet(figure, options, script);
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
