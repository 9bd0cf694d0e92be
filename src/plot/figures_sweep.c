#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
#include "plot/figures_sweep.h"

enum { CURVES_MAX = THUD_COLORS, COLUMNS_MAX = 4 };
enum quantity { ACCELERATION, DRIFT };

static const char *const ratio_label[] = {"Peak acceleration ratio", "Peak deflection ratio"};

/* The runs of a curve or a map: one of each point of a record. */
struct wanted {
    int record, structure, floor;
    enum thud_case which;
};

/* A point's number for them; NaN where it has none. */
static double ratio(const struct thud_sweep_summary *d, const struct wanted *w, enum thud_sweep_end end,
                    enum quantity q)
{
    int k = thud_sweep_summary_find(d, w->which);
    const struct thud_sweep_ratio *x = k >= 0 ? thud_sweep_summary_ratio(d, k, w->structure, w->floor, end) : NULL;
    return !x ? NAN : q == ACCELERATION ? x->acceleration : x->drift;
}

/* A case as a reader calls it. */
const char *thud_case_title(enum thud_case which)
{
    return which == THUD_CASE_NONE     ? "no bumper"
           : which == THUD_CASE_BUMPER ? "bumper"
           : which == THUD_CASE_CAVITY ? "bumper in a cavity"
                                       : "as written";
}

/* Only the first value of every key past the first `free` ones is drawn. */
static bool drawn(const struct thud_sweep_table *table, const struct thud_sweep_summary *d, int free)
{
    for (int a = free; a < table->naxes; a++) {
        if (d->at[a] != 0)
            return false;
    }
    return true;
}

static bool has_case(const struct thud_sweep_table *table, enum thud_case which)
{
    for (size_t i = 0; i < table->npoints; i++) {
        if (thud_sweep_summary_find(table->point[i], which) >= 0)
            return true;
    }
    return false;
}

static int floors_of(const struct thud_sweep_table *table, int structure)
{
    int most = 0;
    for (size_t i = 0; i < table->npoints; i++) {
        int floors = thud_sweep_summary_floors(table->point[i], structure);
        most = floors > most ? floors : most;
    }
    return most;
}

/* Structures that have floors, at most COLUMNS_MAX of them; returns how many. */
static int columns_of(const struct thud_sweep_table *table, int *structure)
{
    int n = 0;
    for (int s = 0; s < table->nstructures && n < COLUMNS_MAX; s++) {
        if (floors_of(table, s) > 0)
            structure[n++] = s;
    }
    return n;
}

/* ---- the axis of what was varied ---- */

static bool numbers(const struct thud_sweep_axis *axis)
{
    return axis->param && !axis->words;
}

double thud_varied_factor(const struct thud_sweep_axis *axis)
{
    double unit = numbers(axis) && axis->param->unit && *axis->param->unit
                      ? thud_unit_factor(axis->param->unit, NULL, NULL)
                      : 1.0;
    return unit > 0.0 ? 1.0 / unit : 1.0;
}

/* Where value number i stands: the number in its shown unit, or its place in the list. */
static double place(const struct thud_sweep_axis *axis, int i)
{
    return numbers(axis) ? axis->value[i] * thud_varied_factor(axis) : i + 1.0;
}

void thud_panel_varied(struct thud_panel *panel, enum thud_side side, const struct thud_sweep_axis *axis)
{
    char label[192];
    const char *title = axis->param && axis->param->title ? axis->param->title : axis->key;
    snprintf(label, sizeof label, "%c%s", thud_ascii_upper(title[0]), title[0] ? title + 1 : "");
    thud_panel_axis(panel, side, label, numbers(axis) && axis->param->unit ? axis->param->unit : "");
    if (!numbers(axis))
        thud_panel_limits(panel, side, 0.5, axis->n + 0.5);
    for (int i = 0; !numbers(axis) && i < axis->n; i++)
        thud_panel_tick(panel, side, i + 1.0, axis->text[i]);
}

/* What is not drawn is said. */
static void fixed_note(struct thud_figure *figure, const struct thud_sweep_table *table, int free, const char *before)
{
    char text[768];
    int n = snprintf(text, sizeof text, "%s", before);
    for (int a = free; a < table->naxes && n > 0 && (size_t)n < sizeof text; a++)
        n += snprintf(text + n, sizeof text - (size_t)n, " %s = %s.", table->axis[a].key, table->axis[a].text[0]);
    thud_figure_note(figure, text);
}

/* ---- amplification ---- */

static const char helps[] = "Ratio to no bumper at the same gap; below 1 the bumper helps.";

static void ratio_axes(struct thud_panel *panel, const struct thud_sweep_table *table, enum quantity q)
{
    thud_panel_varied(panel, THUD_X, &table->axis[0]);
    thud_panel_axis(panel, THUD_Y, ratio_label[q], "");
    thud_panel_mark(panel, THUD_Y, 0.0, 1.0, "bumper helps");
    thud_panel_mark(panel, THUD_Y, 1.0, 1.0, "");
}

/* Whether a point is on a curve. */
static bool is_on(const struct thud_sweep_table *table, const struct wanted *w, const struct thud_sweep_summary *d)
{
    return d->record == w->record && drawn(table, d, 1);
}

/* The spread of a curve, behind all curves: a band, or a bar for each of the words of a list. */
static void ratio_shade(struct thud_panel *panel, const struct thud_sweep_table *table, const struct wanted *wanted,
                        enum quantity q, const char *name, int color)
{
    const struct thud_sweep_axis *axis = &table->axis[0];
    struct thud_style style = {.color = color, .thin = true};
    size_t each = numbers(axis) ? 1 : 3;
    if (!(table->sensitivity > 0))
        return;
    struct thud_series *series = thud_panel_fill(panel, style, name, each * (size_t)axis->n, NULL, NULL, NULL);
    if (!series)
        return;
    for (size_t i = 0; i < series->n; i++) {
        series->x[i] = place(axis, (int)(i / each)) + (each > 1 ? 0.2 * ((double)(i % each) - 0.5) : 0);
        series->y[i] = series->y_high[i] = NAN;
    }
    for (size_t i = 0; i < table->npoints; i++) {
        const struct thud_sweep_summary *d = table->point[i];
        for (size_t k = 0; is_on(table, wanted, d) && k < (each > 1 ? 2 : 1); k++) {
            series->y[(size_t)d->at[0] * each + k] = ratio(d, wanted, THUD_SWEEP_LOW, q);
            series->y_high[(size_t)d->at[0] * each + k] = ratio(d, wanted, THUD_SWEEP_HIGH, q);
        }
    }
}

static void ratio_line(struct thud_panel *panel, const struct thud_sweep_table *table, const struct wanted *wanted,
                       enum quantity q, const char *name, int color)
{
    const struct thud_sweep_axis *axis = &table->axis[0];
    struct thud_style style = {.kind = numbers(axis) ? THUD_LINES_POINTS : THUD_POINTS, .color = color};
    struct thud_series *series = thud_panel_add(panel, style, name, (size_t)axis->n, NULL, NULL);
    if (!series)
        return;
    for (int i = 0; i < axis->n; i++) {
        series->x[i] = place(axis, i);
        series->y[i] = NAN;
    }
    for (size_t i = 0; i < table->npoints; i++) {
        const struct thud_sweep_summary *d = table->point[i];
        if (is_on(table, wanted, d))
            series->y[d->at[0]] = ratio(d, wanted, THUD_SWEEP_VALUE, q);
    }
}

/* What the shades are, where there are any. */
static const char *shade_note(const struct thud_sweep_table *table, char text[128])
{
    text[0] = '\0';
    if (table->sensitivity > 0)
        snprintf(text, 128, " Shaded: spread under %g %% less or more gap, ground motion, stiffness, one at a time.",
                 100 * table->sensitivity);
    return text;
}

/* All panels on one scale, so that what moves more is seen to move more. */
static void same_scale(struct thud_figure *figure)
{
    double least = INFINITY, most = -INFINITY;
    for (int p = 0; figure && p < figure->rows * figure->columns; p++) {
        struct thud_range range = thud_panel_range(&figure->panel[p], THUD_Y);
        least = fmin(least, range.least);
        most = fmax(most, range.most);
    }
    for (int p = 0; figure && p < figure->rows * figure->columns; p++)
        thud_panel_limits(&figure->panel[p], THUD_Y, least, most);
}

struct thud_figure *thud_figure_by_floor(const struct thud_sweep_table *table, int record, enum thud_case which,
                                         const char *name, const char *title)
{
    int structure[COLUMNS_MAX], columns = columns_of(table, structure);
    char text[512];
    snprintf(text, sizeof text, "%s: amplification by the %s, floor by floor", table->record[record],
             thud_case_title(which));
    struct thud_figure *figure = thud_figure_create(name, title ? title : text, 2, columns > 0 ? columns : 1);
    for (int c = 0; c < columns; c++) {
        int floors = floors_of(table, structure[c]), step = (floors + CURVES_MAX - 1) / CURVES_MAX;
        assert(floors > 0);
        for (int q = ACCELERATION; q <= DRIFT; q++) {
            struct thud_panel *panel = thud_figure_panel(figure, q, c, table->structure[structure[c]]);
            ratio_axes(panel, table, (enum quantity)q);
            /* with more floors than curves every step-th from the top down, so that the top is there */
            int first = floors - (floors - 1) / step * step, curves = (floors - first) / step + 1;
            for (int i = 0; i < 2 * curves; i++) {
                int f = first + i % curves * step;
                struct wanted wanted = {.record = record, .which = which, .structure = structure[c], .floor = f};
                snprintf(text, sizeof text, "floor %d", f);
                (i < curves ? ratio_shade : ratio_line)(panel, table, &wanted, (enum quantity)q, text, f - 1);
            }
            snprintf(text, sizeof text, "Every %d. floor of %d", step, floors);
            if (step > 1)
                thud_panel_note(panel, text);
        }
    }
    char note[256], shades[128];
    snprintf(note, sizeof note, "%s%s", helps, shade_note(table, shades));
    same_scale(figure);
    fixed_note(figure, table, 1, note);
    return figure;
}

struct thud_figure *thud_figure_of_means(const struct thud_sweep_table *table, enum thud_case which, const char *name,
                                         const char *title)
{
    int structure[COLUMNS_MAX], columns = columns_of(table, structure);
    char text[256];
    snprintf(text, sizeof text, "Amplification by the %s, means over the floors", thud_case_title(which));
    struct thud_figure *figure = thud_figure_create(name, title ? title : text, 2, columns > 0 ? columns : 1);
    for (int c = 0; c < columns; c++) {
        for (int q = ACCELERATION; q <= DRIFT; q++) {
            struct thud_panel *panel = thud_figure_panel(figure, q, c, table->structure[structure[c]]);
            ratio_axes(panel, table, (enum quantity)q);
            int curves = table->nrecords < CURVES_MAX ? table->nrecords : CURVES_MAX;
            for (int i = 0; i < 2 * curves; i++) {
                int r = i % curves;
                struct wanted wanted = {.record = r, .which = which, .structure = structure[c], .floor = 0};
                (i < curves ? ratio_shade : ratio_line)(panel, table, &wanted, (enum quantity)q, table->record[r], r);
            }
        }
    }
    char note[384], shades[128];
    snprintf(note, sizeof note, "%s%s%s", helps, shade_note(table, shades),
             table->nrecords > CURVES_MAX ? " The first seven records only." : "");
    same_scale(figure);
    fixed_note(figure, table, 1, note);
    return figure;
}

/* ---- contacts ---- */

static void contact_line(struct thud_panel *panel, const struct thud_sweep_table *table, int record,
                         enum thud_case which, bool impacts)
{
    const struct thud_sweep_axis *axis = &table->axis[0];
    struct thud_style style = {.kind = numbers(axis) ? THUD_LINES_POINTS : THUD_POINTS,
                               .color = which < 0 ? 3 : (int)which};
    struct thud_series *series = thud_panel_add(panel, style, thud_case_title(which), (size_t)axis->n, NULL, NULL);
    if (!series)
        return;
    for (int i = 0; i < axis->n; i++) {
        series->x[i] = place(axis, i);
        series->y[i] = NAN;
    }
    for (size_t i = 0; i < table->npoints; i++) {
        const struct thud_sweep_summary *d = table->point[i];
        int k = d->record == record && d->touches && drawn(table, d, 1) ? thud_sweep_summary_find(d, which) : -1;
        if (k >= 0)
            series->y[d->at[0]] = impacts ? d->run[k].impacts : 1e-6 * d->run[k].force_n;
    }
}

struct thud_figure *thud_figure_of_contacts(const struct thud_sweep_table *table, int record, const char *name)
{
    char text[512];
    snprintf(text, sizeof text, "%s: contacts", table->record[record]);
    struct thud_figure *figure = thud_figure_create(name, text, 1, 2);
    for (int i = 0; i < 2; i++) {
        struct thud_panel *panel =
            thud_figure_panel(figure, 0, i, i ? "All impacts of the run" : "Largest impact force");
        thud_panel_varied(panel, THUD_X, &table->axis[0]);
        thud_panel_axis(panel, THUD_Y, i ? "Impacts" : "Force", i ? "" : "MN");
        thud_panel_limits(panel, THUD_Y, 0.0, NAN);
        for (int which = THUD_CASE_AS_WRITTEN; which < THUD_CASES; which++) {
            if (has_case(table, (enum thud_case)which))
                contact_line(panel, table, record, (enum thud_case)which, i == 1);
        }
    }
    fixed_note(figure, table, 1, "");
    return figure;
}

/* ---- two parameters ---- */

static void fill_map(struct thud_panel *panel, const struct thud_sweep_table *table, const struct wanted *wanted,
                     enum quantity q)
{
    const struct thud_sweep_axis *on_x = &table->axis[0], *on_y = &table->axis[1];
    double *x = malloc(((size_t)on_x->n + (size_t)on_y->n) * sizeof *x), *y = x ? x + on_x->n : NULL;
    for (int i = 0; x && i < on_x->n; i++)
        x[i] = place(on_x, i);
    for (int i = 0; x && i < on_y->n; i++)
        y[i] = place(on_y, i);
    struct thud_map *map =
        x ? thud_panel_map(panel, (size_t)on_x->n, x, (size_t)on_y->n, y, NULL, ratio_label[q], "") : NULL;
    free(x);
    if (!map) {
        if (panel)
            panel->figure->failed = true;
        return;
    }
    map->centre = 1.0;
    map->level = numbers(on_x) && numbers(on_y) ? 1.0 : NAN; /* nothing lies between words */
    for (size_t i = 0; i < table->npoints; i++) {
        const struct thud_sweep_summary *d = table->point[i];
        if (d->record == wanted->record && drawn(table, d, 2))
            map->z[(size_t)d->at[1] * map->nx + (size_t)d->at[0]] = ratio(d, wanted, THUD_SWEEP_VALUE, q);
    }
}

struct thud_figure *thud_figure_of_map(const struct thud_sweep_table *table, int record, enum thud_case which,
                                       const char *name)
{
    int structure[COLUMNS_MAX], columns = columns_of(table, structure);
    char text[512];
    snprintf(text, sizeof text, "%s: amplification by the %s, means over the floors", table->record[record],
             thud_case_title(which));
    struct thud_figure *figure = thud_figure_create(name, text, 2, columns > 0 ? columns : 1);
    for (int c = 0; c < columns; c++) {
        for (int q = ACCELERATION; q <= DRIFT; q++) {
            struct thud_panel *panel = thud_figure_panel(figure, q, c, table->structure[structure[c]]);
            thud_panel_varied(panel, THUD_X, &table->axis[0]);
            thud_panel_varied(panel, THUD_Y, &table->axis[1]);
            struct wanted wanted = {.record = record, .which = which, .structure = structure[c], .floor = 0};
            fill_map(panel, table, &wanted, (enum quantity)q);
        }
    }
    bool line = numbers(&table->axis[0]) && numbers(&table->axis[1]);
    snprintf(text, sizeof text, "Ratio to no bumper at the same gap; blue: the bumper helps;%s empty: no answer.",
             line ? " line: ratio 1;" : "");
    fixed_note(figure, table, 2, text);
    return figure;
}

/* ---- the list: per case with a ratio (by floor or as map per record, then the means), then the contacts per record
 * ---- */

/* Whether ratios of the scene as written are to something else than itself. */
static bool has_ratios(const struct thud_sweep_table *table)
{
    for (size_t i = 0; i < table->npoints; i++) {
        const struct thud_sweep_summary *d = table->point[i];
        const struct thud_sweep_ratio *x;
        int k = thud_sweep_summary_find(d, THUD_CASE_AS_WRITTEN);
        for (int s = 0; k >= 0 && s < table->nstructures; s++)
            for (int f = 0; (x = thud_sweep_summary_ratio(d, k, s, f, THUD_SWEEP_VALUE)) != NULL; f++)
                if (isfinite(x->acceleration) && x->acceleration != 1)
                    return true;
    }
    return false;
}

static bool has_contacts(const struct thud_sweep_table *table)
{
    for (size_t i = 0; i < table->npoints; i++)
        if (table->point[i]->touches)
            return true;
    return false;
}

/* Cases that are compared to `none`, which need not be among them; returns how many. */
static int compared(const struct thud_sweep_table *table, enum thud_case *which)
{
    int n = 0;
    for (int c = THUD_CASE_AS_WRITTEN; c < THUD_CASES; c++) {
        bool to_none = c > THUD_CASE_NONE || (c == THUD_CASE_AS_WRITTEN && has_ratios(table));
        if (to_none && has_case(table, (enum thud_case)c))
            which[n++] = (enum thud_case)c;
    }
    return n;
}

int thud_sweep_figure_count(const struct thud_sweep_table *table)
{
    enum thud_case which[THUD_CASES + 1];
    if (table->naxes == 0 || table->nrows == 0)
        return 0;
    return compared(table, which) * (table->nrecords + (table->naxes == 1)) +
           (table->naxes == 1 && has_contacts(table) ? table->nrecords : 0);
}

struct thud_figure *thud_sweep_figure(const struct thud_sweep_table *table, int index)
{
    enum thud_case which[THUD_CASES + 1];
    int cases = compared(table, which), per_case = table->nrecords + (table->naxes == 1);
    int c = index / per_case, record = index % per_case;
    char name[96], number[24] = "";
    if (c >= cases) {
        record = index - cases * per_case;
        if (table->nrecords > 1)
            snprintf(number, sizeof number, "-%d", record + 1);
        snprintf(name, sizeof name, "contact-forces%s", number);
        return thud_figure_of_contacts(table, record, name);
    }
    if (table->nrecords > 1 && record < table->nrecords)
        snprintf(number, sizeof number, "-%d", record + 1);
    const char *kind = record == table->nrecords ? "means" : table->naxes == 1 ? "floors" : "map";
    snprintf(name, sizeof name, "%s-%s%s", kind, thud_case_name(which[c]), number);
    if (record == table->nrecords)
        return thud_figure_of_means(table, which[c], name, NULL);
    return table->naxes == 1 ? thud_figure_by_floor(table, record, which[c], name, NULL)
                             : thud_figure_of_map(table, record, which[c], name);
}
