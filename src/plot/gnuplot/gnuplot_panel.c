/* One panel of a gnuplot script: its data, axes, marks and series. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plot/gnuplot/gnuplot_internal.h"
#include "plot/gnuplot/reduce.h"

static const char grid_color[] = "#D9D9D9";

/* ---- data ---- */

static void begin_block(const struct sheet *sheet, int panel, const char *what, int i)
{
    thud_text_append(sheet->out, "$P%d%s%d << EOD\n", panel + 1, what, i + 1);
}

/* A closed or empty block still needs a row: gnuplot refuses a block without one. */
static void end_block(const struct sheet *sheet)
{
    thud_text_append(sheet->out, "NaN NaN NaN\nEOD\n");
}

/* `to` NULL: all points, as of few: above each other each of them is seen. */
static void series_block(const struct sheet *sheet, int panel, int i, const struct thud_reduce *to)
{
    enum { FEW = 200 };
    const struct thud_series *series = sheet->figure->panel[panel].series[i];
    to = series->n > FEW ? to : NULL;
    size_t *index = malloc((series->n + 1) * sizeof *index);
    if (!index) {
        sheet->out->failed = 1;
        return;
    }
    size_t n = to ? thud_reduce(to, series->n, series->x, series->y, series->y_high, index) : series->n;
    for (size_t k = 0; !to && k < n; k++)
        index[k] = k;
    begin_block(sheet, panel, "S", i);
    for (size_t k = 0; k < n; k++) {
        double x = series->x[index[k]], y = series->y[index[k]], high = series->y_high ? series->y_high[index[k]] : 0.0;
        if (isfinite(x) && isfinite(y) && isfinite(high)) {
            thud_text_append(sheet->out, series->y_high ? "%.7g %.7g %.7g\n" : "%.7g %.7g\n", x, y, high);
        } else
            thud_text_append(sheet->out, "\n"); /* breaks the line */
    }
    end_block(sheet);
    free(index);
}

/* Where the cell of a map ends: half-way to its neighbour, on a log axis by ratio. */
static double cell_edge(const double *at, size_t n, size_t i, int side, bool log)
{
    if (n < 2)
        return at[i] + 0.5 * side;
    size_t near = side < 0 ? (i ? i - 1 : 1) : i + 1 < n ? i + 1 : n - 2;
    bool beyond = side < 0 ? i == 0 : i + 1 == n;
    if (log)
        return beyond ? at[i] * sqrt(at[i] / at[near]) : sqrt(at[i] * at[near]);
    return beyond ? at[i] + 0.5 * (at[i] - at[near]) : 0.5 * (at[i] + at[near]);
}

static void map_block(const struct sheet *sheet, int panel, const struct thud_map *map)
{
    bool log_x = sheet->figure->panel[panel].axis[THUD_X].log, log_y = sheet->figure->panel[panel].axis[THUD_Y].log;
    begin_block(sheet, panel, "M", 0);
    for (size_t j = 0; j < map->ny; j++) {
        for (size_t i = 0; i < map->nx; i++) {
            double z = map->z[j * map->nx + i];
            if (isfinite(z))
                thud_text_append(sheet->out, "%.7g %.7g %.7g %.7g %.7g %.7g %.7g\n", map->x[i], map->y[j],
                                 cell_edge(map->x, map->nx, i, -1, log_x), cell_edge(map->x, map->nx, i, 1, log_x),
                                 cell_edge(map->y, map->ny, j, -1, log_y), cell_edge(map->y, map->ny, j, 1, log_y), z);
        }
    }
    thud_text_append(sheet->out, "NaN NaN NaN NaN NaN NaN ");
    end_block(sheet);
    begin_block(sheet, panel, "C", 0);
    size_t n = isnan(map->level) ? 0 : thud_map_contour(map, NULL, 0);
    double(*piece)[4] = n ? malloc(n * sizeof *piece) : NULL;
    if (n && !piece)
        sheet->out->failed = 1;
    else
        thud_map_contour(map, piece, n);
    for (size_t i = 0; piece && i < n; i++)
        thud_text_append(sheet->out, "%.7g %.7g\n%.7g %.7g\n\n", piece[i][0], piece[i][1], piece[i][2], piece[i][3]);
    free(piece);
    end_block(sheet);
}

void thud_gnuplot_data(const struct sheet *sheet, int panel)
{
    const struct thud_panel *p = &sheet->figure->panel[panel];
    struct thud_range x = thud_sheet_range(sheet, panel, THUD_X), y = thud_sheet_range(sheet, panel, THUD_Y);
    struct box box = thud_sheet_frame(sheet, panel);
    struct thud_reduce to = {x.least,
                             x.most,
                             y.least,
                             y.most,
                             (size_t)fmax(2.0, 2.0 * (box.right - box.left)),
                             (size_t)fmax(2.0, 2.0 * (box.top - box.bottom))};
    for (int i = 0; i < p->nseries; i++)
        series_block(sheet, panel, i,
                     p->axis[THUD_X].log || p->axis[THUD_Y].log ? NULL : &to); /* its cells are linear */
    if (p->map)
        map_block(sheet, panel, p->map);
}

/* ---- axes ---- */

/* 10 to a whole power, as people write it. */
static void power_text(int power, char *text, size_t size)
{
    static const char *const digit[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    char plain[16];
    snprintf(plain, sizeof plain, "%d", power);
    snprintf(text, size, "10");
    for (const char *c = plain; *c; c++)
        strncat(text, *c == '-' ? "⁻" : digit[*c - '0'], size - strlen(text) - 1);
}

/* No more than `most` of them with their number; 0: none. */
static void log_ticks(struct thud_text *out, const struct thud_range *range, int most)
{
    int from = (int)floor(log10(range->least) - 1e-9), to = (int)ceil(log10(range->most) + 1e-9);
    int inside = (int)(floor(log10(range->most) + 1e-9) - ceil(log10(range->least) - 1e-9));
    const int stride = most > 0 ? 1 + inside / most : 1;
    const bool few = to - from <= 2 && most > 0;
    const char *comma = "";
    for (int power = from; power <= to; power++) {
        char text[64];
        if (from >= -2 && to <= 3) /* 0.01 to 1000 are read more easily so */
            snprintf(text, sizeof text, "%g", pow(10.0, power));
        else
            power_text(power, text, sizeof text);
        if (power % stride == 0)
            thud_text_append(out, "%s'%s' 1e%d", comma, most > 0 ? text : "", power);
        else
            thud_text_append(out, "%s'' 1e%d 1", comma, power);
        comma = ", ";
        for (int times = 2; times <= 9 && stride == 1; times++) {
            if (few && (times == 2 || times == 5))
                thud_text_append(out, ", '%g' %de%d", times * pow(10.0, power), times, power);
            else
                thud_text_append(out, ", '' %de%d 1", times, power);
        }
    }
}

/* A tick's text is a format to gnuplot: % is doubled. */
static void named_ticks(struct thud_text *out, const struct thud_axis *axis, double em, double widest)
{
    for (int i = 0; i < axis->nticks; i++) {
        struct thud_text quoted = {0};
        thud_gnuplot_quote(&quoted, axis->tick[i].text, widest, em);
        if (i)
            thud_text_append(out, ", ");
        for (const char *c = quoted.data; c && *c; c++)
            thud_text_bytes(out, *c == '%' ? "%%" : c, *c == '%' ? 2 : 1);
        out->failed |= quoted.failed;
        thud_text_append(out, " %.7g", axis->tick[i].at);
        thud_text_clear(&quoted);
    }
}

/* Titles stand where the sheet has room for them: the terminals disagree about distances in characters. A long one is
 * written smaller before it is cut, so that its unit stays. */
static void x_title(const struct sheet *sheet, int number, const struct box *box)
{
    const double length = box->right - box->left;
    char text[512];
    thud_axis_text(&sheet->figure->panel[number - 1].axis[THUD_X], text, sizeof text);
    const double em = thud_gnuplot_fit(text, 1.15 * length, sheet->em);
    thud_text_append(sheet->out, "set label 92 ");
    thud_gnuplot_quote(sheet->out, text, 1.35 * length, em);
    thud_text_append(sheet->out, " at graph 0.5, screen B%d-2.85*EY center font sprintf(',%%.4g', %.3g*PT)\n", number,
                     em / sheet->em);
}

/* In one line, or in two beside each other. */
static void y_title(const struct sheet *sheet, int number, const struct box *box)
{
    const double length = box->top - box->bottom, at = (box->left - box->label) / sheet->em - 0.2;
    const size_t part = thud_sheet_break(sheet, number - 1);
    char text[512];
    thud_axis_text(&sheet->figure->panel[number - 1].axis[THUD_Y], text, sizeof text);
    text[part] = part > 0 ? '\0' : *text;
    double em = thud_gnuplot_fit(text, 1.15 * length, sheet->em);
    if (part > 0)
        em = fmin(em, thud_gnuplot_fit(text + part + 1, 1.15 * length, sheet->em));
    for (int line = 0; line < 1 + (part > 0); line++) {
        const char *own = text + (line > 0 ? part + 1 : 0);
        thud_text_append(sheet->out, "set label %d ", 93 + 2 * line);
        thud_gnuplot_quote(sheet->out, own, 1.35 * length, em);
        thud_text_append(sheet->out,
                         " at screen L%d-%.4g*EX, graph 0.5 center rotate by 90 font sprintf(',%%.4g', %.3g*PT)\n",
                         number, at + (part > 0 ? 0.3 - 1.1 * line : 0.0), em / sheet->em);
    }
}

/* The step, made longer until the numbers at it stand apart in a frame that is `ems` wide or high. */
static double roomy_step(const struct thud_range *range, enum thud_side side, double ems)
{
    const double digit = 0.64, line = 1.25;
    double step = range->step;
    for (int i = 0; i < 6; i++) {
        size_t longest = 0;
        for (int end = 0; end < 2; end++) {
            char text[32];
            double at = step * (end ? floor(range->most / step + 1e-9) : ceil(range->least / step - 1e-9));
            size_t n = (size_t)snprintf(text, sizeof text, "%.4g", at);
            longest = n > longest ? n : longest;
        }
        const double need = side == THUD_X ? digit * (double)longest + 0.5 : line;
        if (need * (range->most - range->least) <= ems * step)
            break;
        double lead = step / pow(10.0, floor(log10(step) + 1e-9));
        step *= lead > 1.9 && lead < 2.1 ? 2.5 : 2.0; /* 1, 2, 5, 10; 2.5, 5, 10 */
    }
    return step;
}

/* The numbers along y of a strip, which has room for three: 0 and one to either side, none of them at an edge where the
 * next strip has its own. Where they would touch only the upper one has its number: it says the scale. */
static void strip_ticks(struct thud_text *out, const struct thud_range *range, double ems_of_one)
{
    const double reach = 0.85 * fmax(fabs(range->least), fabs(range->most)), unit = pow(10.0, floor(log10(reach))),
                 step = unit * (reach >= 5.0 * unit   ? 5.0
                                : reach >= 2.0 * unit ? 2.0
                                                      : 1.0);
    const double line = 0.95;
    thud_text_append(out, "(");
    if (2.0 * step * ems_of_one >= line)
        thud_text_append(out, "'%g' %.10g, ", -step, -step);
    thud_text_append(out, "%s 0, '%g' %.10g)\n", step * ems_of_one < line ? "''" : "", step, step);
}

/* Room above the curves for the titles of strips, as a share of the height: the same in all that show the same range,
 * so that they stay comparable. */
static double strip_headroom(const struct sheet *sheet, const struct box *box, const struct thud_range *range)
{
    for (int i = 0; i < sheet->figure->rows * sheet->figure->columns; i++) {
        const struct thud_panel *panel = &sheet->figure->panel[i];
        if (!panel->used)
            continue;
        struct thud_range y = thud_sheet_range(sheet, i, THUD_Y);
        if (y.least == range->least && y.most == range->most && thud_sheet_hits_title(sheet, i))
            return thud_sheet_title_share(sheet, box);
    }
    return 0.0;
}

static void put_axis(const struct sheet *sheet, const struct thud_panel *panel, enum thud_side side, int number,
                     const struct box *box)
{
    struct thud_text *out = sheet->out;
    const struct thud_axis *a = &panel->axis[side];
    char name = side == THUD_X ? 'x' : 'y';
    struct thud_range range = thud_sheet_range(sheet, number - 1, side);
    double most = range.most;
    if (panel->strip && side == THUD_Y && !a->log)
        most = range.least + (range.most - range.least) / (1.0 - strip_headroom(sheet, box, &range));
    double hair = a->log ? 1e-7 : 0.0; /* gnuplot drops a tick that its logarithm puts outside by the last bit */
    thud_text_append(out, "set %crange [%.10g:%.10g]\n%s logscale %c\n", name, range.least * (1.0 - hair) + 0.0,
                     most * (1.0 + hair) + 0.0, /* + 0.0: no -0 */ a->log ? "set" : "unset", name);
    const bool last = !sheet->one_x || number > (sheet->rows - 1) * sheet->columns;
    if (side == THUD_X && last)
        x_title(sheet, number, box);
    if (side == THUD_Y && !panel->strip)
        y_title(sheet, number, box);
    if (!last && side == THUD_X)
        thud_text_append(out, "set format x ''\n");
    if (a->nticks) /* a font of ticks may be a variable but no expression */
        thud_text_append(out, "NAMES = sprintf(',%%.4g', %.3g*PT)\n",
                         side == THUD_Y ? thud_sheet_names_em(sheet, number - 1) / sheet->em : 1.0);
    thud_text_append(out, "set %ctics %s", name, side == THUD_X && sheet->points == 1.0 ? "offset 0,0.5 " : "");
    if (a->nticks) {
        thud_text_append(out, "(");
        const double em = side == THUD_Y ? thud_sheet_names_em(sheet, number - 1) : sheet->em;
        named_ticks(out, a, em, side == THUD_Y ? thud_sheet_names_room(sheet) : 0.0);
        thud_text_append(out, ") font NAMES\n");
    } else if (a->log) {
        thud_text_append(out, "(");
        double room = side == THUD_X ? (box->right - box->left) / (2.5 * sheet->em)
                                     : (box->top - box->bottom) / (1.2 * sheet->em);
        log_ticks(out, &range, side == THUD_X && !last ? 0 : (int)fmin(9, fmax(2, room)));
        thud_text_append(out, ")\n");
    } else if (panel->strip && side == THUD_Y && range.least <= 0.0 && range.most >= 0.0) {
        strip_ticks(out, &range, (box->top - box->bottom) / sheet->em / (most - range.least));
    } else
        thud_text_append(
            out, "autofreq %.10g\n",
            roomy_step(&range, side, (side == THUD_X ? box->right - box->left : box->top - box->bottom) / sheet->em));
}

/* ---- what is drawn ---- */

/* Lines told apart without their colours: each colour has its own dashes, long enough for a curve and too long to be
 * lost in its spikes. What is drawn heavier, stands behind, or is alone and so not in the key, is solid. */
static const char *dashes(const struct thud_style *style, bool alone)
{
    static const char *const pattern[] = {"", "(14,5)", "(14,4,3,4)", "(4,4)", "(22,5)", "(14,4,3,4,3,4)", "(9,4)"};
    if (style->dashed)
        return "(2,4)";
    bool solid = style->thin || style->wide || alone;
    return solid ? "" : style->color < 0 ? "(6,3)" : pattern[style->color % THUD_COLORS];
}

void thud_gnuplot_style(const struct sheet *sheet, const struct thud_series *series, bool key)
{
    static const int shape[THUD_COLORS] = {7, 9, 5, 13, 11, 15, 6}; /* others in the second round of colours */
    static const char *const with[] = {
        [THUD_LINES] = "lines", [THUD_POINTS] = "points",     [THUD_LINES_POINTS] = "linespoints",
        [THUD_STEPS] = "steps", [THUD_FILL] = "filledcurves", [THUD_BARS] = "boxes"};
    enum { MARKS_MOST = 100 }; /* where more would touch there are none: none of the highest is left out */
    struct thud_style style = series->style;
    if (style.kind == THUD_LINES_POINTS && series->n > MARKS_MOST)
        style.kind = THUD_LINES;
    double width = style.wide && style.kind != THUD_POINTS ? 3.0 : style.thin ? 1.0 : 1.8;
    bool bars = style.kind == THUD_BARS && !key;
    const int mark = style.color < 0 ? 0 : style.color + 3 * (style.color / THUD_COLORS);
    thud_text_append(sheet->out, "with %s ", style.kind == THUD_BARS && key ? "filledcurves" : with[style.kind]);
    if (style.kind == THUD_FILL || style.kind == THUD_BARS)
        thud_text_append(sheet->out, "fs transparent solid %s noborder ",
                         bars || style.kind == THUD_BARS ? "0.8"
                         : style.thin                    ? "0.18"
                         : style.wide                    ? "0.6"
                                                         : "0.25");
    else {
        thud_text_append(sheet->out, "lw %.2g ", width);
        const char *dash = dashes(&style, !*series->name || sheet->nkeys == 0);
        if (style.kind != THUD_POINTS && *dash)
            thud_text_append(sheet->out, "dt %s ", dash);
    }
    const double size = style.rank > 0                                              ? 0.4 + 0.6 * style.rank
                        : style.kind == THUD_LINES_POINTS || series->n > MARKS_MOST ? 1.0
                        : style.wide                                                ? 2.4 /* rings around others */
                        : style.thin                                                ? 0.7
                                                                                    : 1.5;
    if (style.kind == THUD_POINTS || style.kind == THUD_LINES_POINTS)
        thud_text_append(sheet->out, "pt %d ps %.3g*DOT ", shape[mark % THUD_COLORS], size);
    if (key && (style.kind == THUD_POINTS || style.kind == THUD_LINES_POINTS))
        thud_text_append(sheet->out, "pi 3 ");
    bool behind =
        style.thin && style.color < 0; /* many curves: light, so that others are seen among them in grey too */
    thud_text_append(sheet->out, "lc rgb '#%06X'", behind ? 0xB8B8B8U : thud_color_rgb(style.color));
}

/* Whether a vertical line would run through words at the right. */
static bool has_line_right(const struct sheet *sheet, int number_of)
{
    const struct thud_panel *panel = &sheet->figure->panel[number_of];
    const struct thud_range x = thud_sheet_range(sheet, number_of, THUD_X);
    for (int i = 0; i < panel->nmarks; i++)
        if (panel->mark[i].side == THUD_X && panel->mark[i].from == panel->mark[i].to &&
            2.0 * panel->mark[i].from > x.least + x.most)
            return true;
    return false;
}

/* Whether the name of mark i stands on the left of its line. It stands towards the wider half, unless it would run into
 * another line there and has more room on the other side. */
static bool stands_left(const struct sheet *sheet, int number_of, int i, const struct box *box)
{
    const struct thud_panel *panel = &sheet->figure->panel[number_of];
    const struct thud_range x = thud_sheet_range(sheet, number_of, THUD_X);
    const bool by_ratio = panel->axis[THUD_X].log;
    const double width = by_ratio ? log(x.most / x.least) : x.most - x.least, from = panel->mark[i].from;
    const double needed = thud_gnuplot_width(panel->mark[i].text, THUD_SMALL_EM * sheet->em) + 0.8 * sheet->em;
    double room[2] = {INFINITY, INFINITY}; /* left, right: px to the next line or the frame */
    for (int k = -1; k <= panel->nmarks; k++) {
        const double to = k < 0 ? x.least : k == panel->nmarks ? x.most : panel->mark[k].from;
        const double away = (by_ratio ? log(to / from) : to - from) / width * (box->right - box->left);
        if (k == i || (k >= 0 && k < panel->nmarks && panel->mark[k].side != THUD_X))
            continue;
        room[away > 0.0] = fmin(room[away > 0.0], fabs(away));
    }
    const bool left = 2.0 * from > x.least + x.most;
    return room[!left] < needed && room[left] > room[!left] ? !left : left;
}

static void put_marks(const struct sheet *sheet, int number_of, const struct box *box)
{
    const struct thud_panel *panel = &sheet->figure->panel[number_of];
    struct thud_text *out = sheet->out;
    const bool left = has_line_right(sheet, number_of), low = box->top - box->bottom < 10.0 * sheet->em;
    for (int i = 0; i < panel->nmarks; i++) {
        const struct thud_mark *mark = &panel->mark[i];
        struct thud_range range = thud_sheet_range(sheet, number_of, mark->side);
        double from = fmax(fmin(mark->from, mark->to), range.least), to = fmin(fmax(mark->from, mark->to), range.most);
        bool across = mark->side == THUD_X;
        if (!(from <= to))
            continue;
        if (mark->from == mark->to)
            thud_text_append(out,
                             across ? "set arrow %d from first %.9g, graph 0 to first %.9g, graph 1"
                                    : "set arrow %d from graph 0, first %.9g to graph 1, first %.9g",
                             i + 1, from, to);
        else
            thud_text_append(out,
                             across ? "set object %d rectangle from first %.9g, graph 0 to first %.9g, graph 1"
                                    : "set object %d rectangle from graph 0, first %.9g to graph 1, first %.9g",
                             i + 1, from, to);
        if (mark->from == mark->to) /* a map would cover what is behind it */
            thud_text_append(out, " nohead %s lw 1.4 lc rgb '#404040'\n", panel->map ? "front" : "back");
        else
            thud_text_append(out, " back fs solid 1.0 noborder fc rgb '#E8F1F7'\n");
        if (!*mark->text || (low && mark->from != mark->to)) /* words of a band would lie on its curves */
            continue;
        thud_text_append(out, "set label %d ", 100 + i);
        thud_gnuplot_quote(out, mark->text, 0.0, sheet->em);
        if (across)
            thud_text_append(out, " at first %.9g, graph 1 %s", from,
                             stands_left(sheet, number_of, i, box) ? "right offset -0.4,-0.65"
                                                                   : "left offset 0.4,-0.65");
        else
            thud_text_append(out, " at graph %s, first %.9g %s offset 0,%s", left ? "0.015" : "0.985", from,
                             left ? "left" : "right", mark->from == mark->to ? "0.5" : "0.7");
        thud_text_append(out, " front font sprintf(',%%.4g', SMALL*PT) textcolor rgb '#404040'\n");
    }
}

static void put_labels(const struct sheet *sheet, const struct thud_panel *panel)
{
    static const char *const side[] = {"right", "center", "left"};
    for (int i = 0; i < panel->nlabels; i++) {
        const struct thud_label *label = &panel->label[i];
        thud_text_append(sheet->out, "set label %d ", 200 + i);
        thud_gnuplot_quote(sheet->out, label->text, 0.0, sheet->em);
        thud_text_append(sheet->out, " at first %.9g, first %.9g %s front font sprintf(',%%.4g', SMALL*PT)\n", label->x,
                         label->y, side[label->side + 1]);
    }
}

static void color_box(const struct sheet *sheet, int number, double least, double most)
{
    thud_text_append(sheet->out,
                     "set cbrange [%.9g:%.9g]\nset colorbox user origin R%d+0.8*EX,B%d size 1.1*EX,T%d-B%d\n", least,
                     most, number, number, number, number);
}

/* One color for each class, with its name. */
static void class_colors(const struct sheet *sheet, const struct thud_map *map, int number)
{
    thud_text_append(sheet->out, "set palette maxcolors %d\nset cbtics (", map->classes);
    for (int i = 0; i < map->classes; i++) {
        thud_text_append(sheet->out, i > 0 ? ", " : "");
        thud_gnuplot_quote(sheet->out, map->class_name[i], 0.0, sheet->em);
        thud_text_append(sheet->out, " %d", i);
    }
    thud_text_append(sheet->out, ") scale 0\n");
    color_box(sheet, number, -0.5, map->classes - 0.5);
}

static void map_colors(const struct sheet *sheet, const struct thud_map *map, int number, const struct box *box)
{
    struct thud_text *out = sheet->out;
    struct thud_axis label = {.label = map->label, .unit = map->unit};
    char text[512];
    double least = 0.0, most = 1.0;
    if (!thud_map_range(map, &least, &most))
        least = most = isnan(map->centre) ? 0.0 : map->centre;
    if (!(most > least))
        most = least + 1.0;
    const double ems = (box->top - box->bottom) / sheet->em;
    thud_text_append(out, "set palette maxcolors 0\n");
    if (isnan(map->centre))
        thud_text_append(out, "set palette defined (0 '#FFF7D6', 1 '#E69F00', 2 '#9C3A00', 3 '#2B0B00')\n");
    else {
        double half = map->reach > 0.0 ? map->reach : fmax(fabs(most - map->centre), fabs(map->centre - least));
        least = map->centre - half;
        most = map->centre + half;
        thud_text_append(out,
                         "set palette defined (-2 '#00406B', -1 '#5AA5D0', 0 '#FFFFFF', 1 '#EFA060', 2 '#8A3300')\n");
    }
    if (map->class_name) {
        class_colors(sheet, map, number);
        return;
    }
    const struct thud_range range = {least, most, pow(10.0, floor(log10(most - least)) - 1.0)};
    thud_text_append(out, "set cbtics autofreq %.10g scale default\n", roomy_step(&range, THUD_Y, ems));
    color_box(sheet, number, least, most);
    thud_text_append(out, "set label 94 ");
    const double length = box->top - box->bottom,
                 em = thud_gnuplot_fit(thud_axis_text(&label, text, sizeof text), 1.15 * length, sheet->em);
    thud_gnuplot_quote(out, text, 1.5 * length, em);
    thud_text_append(out, " at screen R%d+6.6*EX, graph 0.5 center rotate by 90 font sprintf(',%%.4g', %.3g*PT)\n",
                     number, em / sheet->em);
}

/* Edges of a band beside others, with the dashes of its curve: bands that overlap cannot be told apart in grey. */
static void put_edges(const struct sheet *sheet, int number_of, int i)
{
    const struct thud_panel *panel = &sheet->figure->panel[number_of];
    const struct thud_series *band = panel->series[i];
    int bands = 0;
    for (int k = 0; k < panel->nseries; k++)
        bands += panel->series[k]->style.kind == THUD_FILL && panel->series[k]->style.thin;
    if (band->style.kind != THUD_FILL || !band->style.thin || bands < 2)
        return;
    const char *dash = dashes(&(struct thud_style){.color = band->style.color}, false);
    for (int side = 2; side <= 3; side++)
        thud_text_append(sheet->out, ", $P%dS%d using 1:%d with lines lw 0.7 %s%s lc rgb '#%06X'", number_of + 1, i + 1,
                         side, *dash ? "dt " : "", dash, thud_color_rgb(band->style.color));
}

/* A reference in grey dashes is drawn over the other curves: where they coincide both are seen. */
static bool is_over(const struct thud_series *series)
{
    return series->style.color < 0 && !series->style.thin && !series->style.wide && series->style.kind != THUD_FILL;
}

static void put_plots(const struct sheet *sheet, int number_of)
{
    const struct thud_panel *panel = &sheet->figure->panel[number_of];
    struct thud_text *out = sheet->out;
    const char *comma = "plot ";
    if (panel->map) {
        thud_text_append(out, "%s$P%dM1 using 1:2:3:4:5:6:7 with boxxyerror fs solid 1.0 lw 0.3 lc palette", comma,
                         number_of + 1);
        comma = ", ";
        thud_text_append(out, "%s$P%dC1 with lines lw 2.2 lc rgb '#000000'", comma, number_of + 1);
    }
    for (int k = 0; k < 2 * panel->nseries; k++) {
        const int i = k % panel->nseries;
        if (is_over(panel->series[i]) != (k >= panel->nseries))
            continue;
        thud_text_append(out, "%s$P%dS%d using 1:2%s ", comma, number_of + 1, i + 1,
                         panel->series[i]->y_high ? ":3" : "");
        thud_gnuplot_style(sheet, panel->series[i], false);
        put_edges(sheet, number_of, i);
        comma = ", ";
    }
    thud_text_append(out, "%s\n", *comma == 'p' ? "plot NaN" : "");
}

void thud_gnuplot_panel(const struct sheet *sheet, int number_of)
{
    const struct thud_panel *panel = &sheet->figure->panel[number_of];
    struct thud_text *out = sheet->out;
    struct box box = thud_sheet_frame(sheet, number_of);
    if (!panel->used)
        return;
    int number = number_of + 1;
    thud_text_append(out, "\nreset\nset margins screen L%d, screen R%d, screen B%d, screen T%d\n", number, number,
                     number, number);
    thud_text_append(out, "unset key\nset border 31 back lw 1 lc rgb '#404040'\nset tics nomirror out scale 0.5\n");
    thud_text_append(out, "set format '%%h'\nset grid back lt 1 lw 0.8 lc rgb '%s'\nset boxwidth 0.8 relative\n",
                     grid_color);
    put_axis(sheet, panel, THUD_X, number_of + 1, &box);
    put_axis(sheet, panel, THUD_Y, number_of + 1, &box);
    if (panel->drawing)
        thud_text_append(out, "unset grid\nunset xtics\n");
    double room = 1.1 * (box.right - box.left), em = thud_gnuplot_fit(panel->title, room, sheet->em);
    if (panel->strip)
        em = THUD_SMALL_EM * sheet->em;
    thud_text_append(out, "set label 90 ");
    thud_gnuplot_quote(out, panel->title, room, em);
    if (panel->strip)
        thud_text_append(out, " at graph 0.01, screen T%d-0.7*EY left front font sprintf(',%%.4g', %.3g*PT)\n", number,
                         THUD_SMALL_EM);
    else
        thud_text_append(out, " at graph 0.5, screen T%d+%.3g*EY center font sprintf(',%%.4g', %.3g*PT)\n", number,
                         *panel->note ? 1.9 : 0.8, em / sheet->em);
    if (*panel->note) {
        thud_text_append(out, "set label 91 ");
        em = THUD_SMALL_EM * sheet->em;
        thud_gnuplot_quote(out, panel->note, room, em);
        thud_text_append(out,
                         " at graph 0.5, screen T%d+0.7*EY center font sprintf(',%%.4g', %.3g*PT) "
                         "textcolor rgb '#404040'\n",
                         number, em / sheet->em);
    }
    if (panel->map)
        map_colors(sheet, panel->map, number_of + 1, &box);
    put_marks(sheet, number_of, &box);
    put_labels(sheet, panel);
    put_plots(sheet, number_of);
}
