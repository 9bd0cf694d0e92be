/* Where the panels and the key of a picture stand. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "plot/gnuplot/gnuplot_internal.h"

/* The key under the panels, in as many rows as it takes. */
static void lay_key(struct sheet *sheet)
{
    double line[24], left = 0.0, widest = 0.96 * sheet->width;
    int most = (int)(sizeof sheet->key / sizeof *sheet->key), row = 0;
    sheet->nkeys = thud_figure_key(sheet->figure, sheet->key, most);
    if (sheet->nkeys > most)
        sheet->nkeys = most;
    if (sheet->nkeys == 1) /* nothing to tell apart */
        sheet->nkeys = 0;
    for (int i = 0; i < sheet->nkeys; i++) {
        const double beside = (THUD_SAMPLE_EM + 0.5) * sheet->em;
        sheet->key_at[i].em = thud_gnuplot_fit(sheet->key[i]->name, widest - beside, sheet->em);
        double width = fmin(widest, thud_gnuplot_width(sheet->key[i]->name, sheet->key_at[i].em) + beside);
        if (left > 0.0 && left + width > widest) {
            row++;
            left = 0.0;
        }
        sheet->key_at[i].row = row;
        sheet->key_at[i].left = left;
        line[row] = left + width;
        left += width + THUD_BEHIND_EM * sheet->em;
    }
    for (int i = 0; i < sheet->nkeys; i++) /* each row in the middle */
        sheet->key_at[i].left += fmax(0.02 * sheet->width, 0.5 * (sheet->width - line[sheet->key_at[i].row]));
    sheet->key_rows = sheet->nkeys > 0 ? row + 1 : 0;
}

/* On paper panels below each other share three quarters of what a page of A4 has between its margins: a caption and
 * text stand beside them. */
static const double page_mm = 180.0, lowest_em = 9.0;
/* A panel narrower than this many ems stands below its neighbour. */
static const double narrowest_em = 21.0;

double thud_sheet_names_room(const struct sheet *sheet)
{
    return 0.43 * sheet->width / sheet->columns;
}

static double names_width(const struct thud_panel *panel, double em)
{
    double widest = 0.0;
    for (int i = 0; i < panel->axis[THUD_Y].nticks; i++)
        widest = fmax(widest, thud_gnuplot_width(panel->axis[THUD_Y].tick[i].text, em));
    return widest;
}

/* Where half as many panels, or one, are to stand side by side: they are narrower than so many ems, or would cut a
 * title or the names of ticks. */
static bool too_narrow(const struct sheet *sheet, double least)
{
    const double width = sheet->width / sheet->columns, em = sheet->em, room = thud_sheet_names_room(sheet);
    for (int i = 0; i < sheet->figure->rows * sheet->figure->columns; i++) {
        const struct thud_panel *panel = &sheet->figure->panel[i];
        const double names = names_width(panel, THUD_SMALL_EM * em), map = panel->map ? 6.0 * em : 0.0,
                     frame = width - fmax(5.8 * em, fmin(names, room) + 3.0 * em) - 1.8 * em - map;
        if (width < least * em + map ||
            (!panel->strip && (names > room || thud_gnuplot_width(panel->title, THUD_SMALL_EM * em) > 1.1 * frame)))
            return true;
    }
    return false;
}

void thud_figure_fit(struct thud_figure *figure, const struct thud_picture_options *options)
{
    if (thud_figure_check(figure, NULL) != THUD_OK || figure->columns != 2 || !figure->panel[0].strip)
        return;
    const struct sheet sheet = thud_sheet_make(figure, options, NULL);
    const double frame = sheet.width / 2 - 5.4 * sheet.em;
    double widest = 0.0;
    for (int i = 0; i < figure->rows; i++)
        widest = fmax(widest, thud_gnuplot_width(figure->panel[2 * i].title, THUD_SMALL_EM * sheet.em));
    if (widest <= frame)
        return;
    figure->columns = 1;
    for (int i = 0; i < figure->rows; i++) {
        figure->panel[i] = figure->panel[2 * i];
        figure->panel[i].nmarks = 0; /* of the closer look */
    }
    thud_figure_note(figure, "A wider picture shows the largest impact closer.");
}

struct thud_range thud_sheet_range(const struct sheet *sheet, int panel, enum thud_side side)
{
    return panel < THUD_PANELS_KNOWN ? sheet->range[panel][side] : thud_panel_range(&sheet->figure->panel[panel], side);
}

static bool would_hit(const struct sheet *sheet, int number)
{
    const struct thud_panel *panel = &sheet->figure->panel[number];
    struct box box = thud_sheet_frame(sheet, number);
    struct thud_range x = thud_sheet_range(sheet, number, THUD_X), y = thud_sheet_range(sheet, number, THUD_Y);
    double width = thud_gnuplot_width(panel->title, THUD_SMALL_EM * sheet->em) + sheet->em;
    double right = x.least + (x.most - x.least) * width / (box.right - box.left);
    double low = y.most - (y.most - y.least) * thud_sheet_title_share(sheet, &box);
    for (int i = 0; i < panel->nseries; i++)
        for (size_t k = 0; k < panel->series[i]->n; k++)
            if (panel->series[i]->x[k] >= x.least && panel->series[i]->x[k] <= right && panel->series[i]->y[k] >= low)
                return true;
    return false;
}

double thud_sheet_title_share(const struct sheet *sheet, const struct box *box)
{
    return fmin(0.4, 1.4 * sheet->em / (box->top - box->bottom));
}

bool thud_sheet_hits_title(const struct sheet *sheet, int panel)
{
    return panel < THUD_PANELS_KNOWN ? sheet->hits_title[panel] : would_hit(sheet, panel);
}

/* Whether panels below each other can share one x axis. */
static bool has_one_x(const struct sheet *sheet)
{
    const struct thud_panel *panel = sheet->figure->panel;
    for (int i = 0; i < sheet->rows * sheet->columns; i++) {
        const struct thud_panel *top = &panel[i % sheet->columns];
        const struct thud_range x = thud_sheet_range(sheet, i, THUD_X),
                                first = thud_sheet_range(sheet, i % sheet->columns, THUD_X);
        const struct thud_axis *axis = &panel[i].axis[THUD_X];
        if (!panel[i].used || panel[i].drawing || axis->nticks > 0 || strcmp(axis->label, top->axis[THUD_X].label) ||
            x.least != first.least || x.most != first.most)
            return false;
    }
    return sheet->rows > 1;
}

/* Size, font and room for the key, from the options and the figure. On paper an inch has 300 pixels, and as many as the
 * format itself counts where it has none of its own. */
struct sheet thud_sheet_make(const struct thud_figure *figure, const struct thud_picture_options *options,
                             struct thud_text *out)
{
    struct sheet sheet = {.figure = figure,
                          .title = options->no_title ? "" : figure->title,
                          .out = out,
                          .rows = figure->rows,
                          .columns = figure->columns};
    const int known = (int)fmin(THUD_PANELS_KNOWN, figure->rows * figure->columns);
    for (int i = 0; i < known; i++)
        for (int side = 0; side < 2; side++)
            sheet.range[i][side] = thud_panel_range(&figure->panel[i], (enum thud_side)side);
    static const double dpi[] = {[THUD_PNG] = 300.0, [THUD_SVG] = 96.0, [THUD_PDF] = THUD_PDF_DPI, [THUD_SIXEL] = 96.0};
    bool paper = options->width_mm > 0.0;
    double inch = dpi[options->format], point = inch / 72.0;
    sheet.width = paper ? floor(options->width_mm / 25.4 * inch + 0.5) : options->width_px ? options->width_px : 1800;
    sheet.em = options->font_px > 0.0 ? options->font_px : paper ? 8.0 * point : sheet.width / 66.0;
    if (options->height_px && !(options->font_px > 0.0)) /* a flat sheet */
        sheet.em = fmin(sheet.em, 1.6 * options->height_px / 66.0);
    sheet.line = paper ? 0.5 * point : sheet.em / 14.0;
    bool strips = figure->panel[0].strip;
    double narrowest = strips ? 14.0 : figure->columns > 2 ? 15.0 : narrowest_em;
    while (sheet.columns > 1 && too_narrow(&sheet, narrowest)) {
        sheet.columns = sheet.columns % 2 == 0 && !strips ? sheet.columns / 2 : 1;
        sheet.rows = figure->rows * figure->columns / sheet.columns;
    }
    lay_key(&sheet);
    int title = !*sheet.title ? 0 : thud_gnuplot_wrap(sheet.title, 0.96 * sheet.width, THUD_TITLE_EM * sheet.em, NULL);
    int note = thud_gnuplot_wrap(figure->note, 0.96 * sheet.width, THUD_SMALL_EM * sheet.em, NULL);
    sheet.head = (0.8 + 1.6 * title) * sheet.em;
    sheet.one_x = strips || has_one_x(&sheet);
    sheet.key_foot = strips ? 3.6 * sheet.em : sheet.one_x ? 3.0 * sheet.em : 0.0;
    sheet.foot = (0.6 + 1.3 * note + 1.6 * sheet.key_rows) * sheet.em + sheet.key_foot;
    /* panels a little wider than high, room for their labels besides */
    double panel = sheet.width / sheet.columns, share = sheet.columns > 2 ? 0.8 : sheet.rows > 3 ? 0.4 : 0.52;
    if (sheet.columns == 1 && sheet.rows > 1)
        share = sheet.width < 40.0 * sheet.em ? 0.5 : 0.3;
    double height =
        fmax(sheet.rows > 4 ? 9.0 * sheet.em : 12.0 * sheet.em, share * panel + 4.0 * sheet.em - sheet.key_foot);
    double page = (page_mm / 25.4 * inch - sheet.head - sheet.foot) / sheet.rows;
    if (paper && sheet.rows > 1 && height > page)
        height = fmin(height, fmax(lowest_em * sheet.em, page));
    if (strips)
        height = fmax(4.2, fmin(9.0, 50.0 / sheet.rows)) * sheet.em;
    if (sheet.columns == 1 && sheet.rows == 1)
        height = fmax(0.5 * panel, fmax(18.0, 1.35 * figure->panel[0].axis[THUD_Y].nticks + 5.0) * sheet.em);
    sheet.height = options->height_px ? options->height_px : floor(sheet.head + sheet.foot + sheet.rows * height);
    sheet.points = options->format == THUD_SVG ? 1.0 : options->format == THUD_PDF ? 54.0 / THUD_PDF_DPI : 0.75;
    /* a mark of size 1 has a radius, px: 3.1 of pngcairo and sixelgd, 8.8 of pdfcairo, 0.375 em of svg */
    const double radius = options->format == THUD_PDF ? 8.8 : options->format == THUD_SVG ? 0.375 * sheet.em : 3.1;
    sheet.dot = 0.1 * sheet.em / radius;
    for (int i = 0; i < known; i++)
        sheet.hits_title[i] = figure->panel[0].strip && figure->panel[i].used && would_hit(&sheet, i);
    return sheet;
}

/* Of the numbers along y, what is beyond the usual three digits pushes the label out. */
static double numbers_width(const struct sheet *sheet, int of)
{
    const struct thud_panel *panel = &sheet->figure->panel[of];
    double widest = 0.0;
    char number[32];
    const struct thud_axis *axis = &panel->axis[THUD_Y];
    if (!panel->used || axis->log || axis->nticks > 0)
        return 0.0;
    const struct thud_range range = thud_sheet_range(sheet, of, THUD_Y);
    for (double at = range.least; at <= range.most + 0.5 * range.step && range.step > 0.0; at += range.step) {
        snprintf(number, sizeof number, "%.4g", fabs(at) < 1e-9 * range.step ? 0.0 : at);
        widest = fmax(widest, thud_gnuplot_width(number, sheet->em) + 0.6 * sheet->em);
    }
    return widest;
}

double thud_sheet_names_em(const struct sheet *sheet, int panel)
{
    const double width = names_width(&sheet->figure->panel[panel], sheet->em), room = thud_sheet_names_room(sheet);
    return sheet->em * fmax(0.75, fmin(1.0, room / fmax(width, sheet->em)));
}

/* Top and bottom of a frame. */
static struct box upright(const struct sheet *sheet, int panel)
{
    const struct thud_panel *p = &sheet->figure->panel[panel];
    const double height = (sheet->height - sheet->head - sheet->foot) / sheet->rows,
                 top = sheet->height - sheet->head - panel / sheet->columns * height,
                 above = (*p->title ? 1.5 : 0.5) + (*p->note ? 1.1 : 0.0),
                 below = p->drawing     ? 1.2
                         : sheet->one_x ? 0.7
                                        : 3.7;
    return (struct box){.top = top - (p->strip ? 0.3 : above) * sheet->em,
                        .bottom = top - height + (p->strip ? 0.3 : below) * sheet->em};
}

size_t thud_sheet_break(const struct sheet *sheet, int panel)
{
    const struct thud_panel *p = &sheet->figure->panel[panel];
    const struct box box = upright(sheet, panel);
    char text[512], half[512];
    size_t best = 0;
    if (!p->used || p->strip ||
        thud_gnuplot_width(thud_axis_text(&p->axis[THUD_Y], text, sizeof text), sheet->em) <=
            1.25 * (box.top - box.bottom))
        return 0;
    double least = INFINITY; /* of the longer line */
    for (const char *blank = strchr(text, ' '); blank; blank = strchr(blank + 1, ' ')) {
        snprintf(half, sizeof half, "%.*s", (int)(blank - text), text);
        const double longer = fmax(thud_gnuplot_width(half, 1.0), thud_gnuplot_width(blank + 1, 1.0));
        best = longer < least ? (size_t)(blank - text) : best;
        least = fmin(least, longer);
    }
    return best;
}

struct box thud_sheet_frame(const struct sheet *sheet, int panel)
{
    const int column = panel % sheet->columns;
    const double width = sheet->width / sheet->columns;
    const struct thud_panel *p = &sheet->figure->panel[panel];
    double names = names_width(p, thud_sheet_names_em(sheet, panel)); /* room for named ticks */
    bool broken = false;
    for (int i = column; i < sheet->rows * sheet->columns;
         i += sheet->columns) { /* below each other: they begin alike */
        names = fmax(names, numbers_width(sheet, i));
        broken |= thud_sheet_break(sheet, i) > 0;
    }
    struct box box = upright(sheet, panel);
    box.left = column * width + fmin(fmax(5.8 * sheet->em, names + 3.0 * sheet->em), 0.5 * width) +
               (broken ? 0.9 * sheet->em : 0.0);
    box.label = column * width + (column ? 1.6 : 1.1) * sheet->em;
    char last[32]; /* number along x, which may be at the frame's end */
    snprintf(last, sizeof last, "%.4g", thud_sheet_range(sheet, panel, THUD_X).most);
    box.right =
        (column + 1) * width - (p->map ? 7.8 : fmax(1.2, 0.5 * thud_gnuplot_width(last, 1.0) + 0.1)) * sheet->em;
    if (p->strip)
        box.left = column * width + 4.2 * sheet->em;
    return box;
}
