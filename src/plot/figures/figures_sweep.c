#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
#include "base/statistics.h"
#include "plot/figures/figures_case.h"
#include "plot/figures/figures_run.h"
#include "plot/figures/figures_sweep.h"

enum { CURVES_MAX = THUD_COLORS, COLUMNS_MAX = 4 };
enum quantity { ACCELERATION, DRIFT };

static const char *const ratio_label[] = {"Peak acceleration ratio", "Peak drift ratio"};
static const char *const quantity_title[] = {"accelerations", "drifts"};

/* The runs of a curve or a map: one of each point of a record. */
struct wanted {
    int record, structure, floor;
    enum thud_case which;
    bool free;     /* over no pounding, and not over case `none` */
    const int *at; /* (naxes) of the keys that are not drawn; NULL: the first values */
};

/* A point's number for them; NaN where it has none. */
static double ratio(const struct thud_sweep_summary *d, const struct wanted *w, enum thud_sweep_end end,
                    enum quantity q)
{
    int k = thud_sweep_summary_find(d, w->which);
    const struct thud_sweep_ratio *x = k >= 0 ? thud_sweep_summary_ratio(d, k, w->structure, w->floor, end) : NULL;
    if (!x)
        return NAN;
    if (w->free)
        return q == ACCELERATION ? x->acceleration_free : x->drift_free;
    return q == ACCELERATION ? x->acceleration : x->drift;
}

/* What a figure of ratios shows, for its title. */
static const char *amplification(enum thud_case which)
{
    return which == THUD_CASE_NONE     ? "amplification by pounding without bumper"
           : which == THUD_CASE_BUMPER ? "amplification by the bumper"
           : which == THUD_CASE_CAVITY ? "amplification by the bumper in a cavity"
           : which == THUD_CASE_LINK   ? "amplification by the links"
                                       : "amplification against no bumper, scene as written";
}

/* In its own words, event and station; false where it says none, or what another of the study says too. */
static bool motion_name(const struct thud_sweep_table *table, int record, char text[128])
{
    const struct thud_record *own = table->motion ? table->motion[record] : NULL;
    if (!own || !*own->event || strcmp(thud_path_name(own->file), table->record[record]) != 0)
        return false;
    for (int r = 0; r < table->nrecords; r++) {
        const struct thud_record *other = table->motion[r];
        if (r != record && other && strcmp(other->event, own->event) == 0 && strcmp(other->station, own->station) == 0)
            return false;
    }
    snprintf(text, 128, "%s%s%.30s", own->event, *own->station ? ", " : "", own->station);
    return true;
}

/* By its event; else the last part of its file's path without the suffix: what fits a key. */
static const char *record_name(const struct thud_sweep_table *table, int record, char text[128])
{
    if (table->motions > 0) {
        snprintf(text, 128, "%d ground motions", table->motions);
        return text;
    }
    if (motion_name(table, record, text))
        return text;
    const char *name = thud_path_name(table->record[record]), *dot = strrchr(name, '.');
    bool suffix = dot && dot > name && strlen(dot) <= 5 && !strchr(dot, ' ') && !thud_ascii_is_digit(dot[1]);
    size_t length = suffix ? (size_t)(dot - name) : strlen(name);
    snprintf(text, 128, "%.*s", (int)(length < 127 ? length : 127), name);
    return text;
}

/* Keys past the first `free` ones are drawn at one value each. */
static bool drawn(const struct thud_sweep_table *table, const struct thud_sweep_summary *d, int free, const int *at)
{
    for (int a = free; a < table->naxes; a++) {
        if (d->at[a] != (at ? at[a] : 0))
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

/* "4-storey building A" where A is a letter or two, else "Annex, 4 storeys". */
static const char *structure_title(const struct thud_sweep_table *table, int structure, char text[160])
{
    const char *name = table->structure[structure];
    bool isolated = table->kind && table->kind[structure] == THUD_ISOLATED;
    int storeys = floors_of(table, structure) - isolated;
    if ((table->kind && table->kind[structure] == THUD_RIGID) || storeys < 1)
        snprintf(text, 160, "%s", name);
    else if (strlen(name) <= 2)
        snprintf(text, 160, "%d-storey building %s%s", storeys, name, isolated ? ", isolated" : "");
    else
        snprintf(text, 160, "%s, %d storey%s%s", name, storeys, storeys == 1 ? "" : "s", isolated ? ", isolated" : "");
    return text;
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

/* `table`: whose structures' names a key may stand for; NULL: it is shown by its number. */
static void axis_of_key(struct thud_panel *panel, enum thud_side side, const struct thud_sweep_axis *axis,
                        const struct thud_sweep_table *table)
{
    char label[192];
    const char *title = axis->param && axis->param->title ? axis->param->title : axis->key, *of = NULL;
    if (strstr(axis->key, "bumper.") && !strstr(title, "bumper"))
        of = "bumper";
    if (strstr(axis->key, "contact.") && !strstr(title, "contact"))
        of = "contact";
    if (strncmp(axis->key, "links.", 6) == 0)
        of = "link";
    int structure = 0;
    snprintf(label, sizeof label, "%c%s", thud_ascii_upper(title[0]), title[0] ? title + 1 : "");
    if (of)
        snprintf(label, sizeof label, "%c%s: %s", thud_ascii_upper(of[0]), of + 1, title);
    else if (table && sscanf(axis->key, "structures.%d.", &structure) == 1 && structure >= 1 &&
             structure <= table->nstructures)
        snprintf(label, sizeof label, "%s: %s", table->structure[structure - 1], title);
    thud_panel_axis(panel, side, label, numbers(axis) && axis->param->unit ? axis->param->unit : "");
    if (!numbers(axis))
        thud_panel_limits(panel, side, 0.5, axis->n + 0.5);
    for (int i = 0; !numbers(axis) && i < axis->n; i++)
        thud_panel_tick(panel, side, i + 1.0, axis->text[i]);
}

void thud_panel_varied(struct thud_panel *panel, enum thud_side side, const struct thud_sweep_axis *axis)
{
    axis_of_key(panel, side, axis, NULL);
}

/* Of a gap that is varied: the one from which no ground motion of the study causes contact without bumper, m; NaN: not
 * known, or not among those shown. */
static double free_gap(const struct thud_sweep_table *table, int varied)
{
    const struct thud_sweep_axis *axis = &table->axis[varied];
    int interface = strcmp(axis->key, "gap") == 0 ? 1 : 0;
    double widest = NAN;
    if (table->motions > 0 || !table->need || !numbers(axis))
        return NAN;
    if (strncmp(axis->key, "interfaces.", 11) == 0 && strcmp(axis->key + strlen(axis->key) - 4, ".gap") == 0)
        interface = atoi(axis->key + 11);
    for (int r = 0; r < table->nrecords; r++)
        if (interface > 0 && table->need[r].interface == interface)
            widest = fmax(widest, table->need[r].relative_displacement_m);
    return widest >= axis->value[0] && widest <= axis->value[axis->n - 1] ? widest : NAN;
}

static void varied_axis(struct thud_panel *panel, enum thud_side side, const struct thud_sweep_table *table, int which)
{
    const double at = free_gap(table, which) * thud_varied_factor(&table->axis[which]);
    axis_of_key(panel, side, &table->axis[which], table);
    if (!isnan(at))
        thud_panel_mark(panel, side, at, at, "");
}

/* What that line is, where one of the first axes has it. */
static const char *free_gap_note(const struct thud_sweep_table *table, int axes)
{
    const bool several = table->nrecords > 1, across = !isnan(free_gap(table, 0));
    if (!across && (axes < 2 || isnan(free_gap(table, 1))))
        return "";
    return across    ? several ? " Vertical line: no contact without bumper from here on, under any of the motions."
                               : " Vertical line: no contact without bumper from here on."
           : several ? " Level line: no contact without bumper from here up, under any of the motions."
                     : " Level line: no contact without bumper from here up.";
}

/* Keys that are not drawn, with their values. */
static void fixed_note(struct thud_figure *figure, const struct thud_sweep_table *table, int free, const int *at,
                       const char *before)
{
    char text[768];
    int n = snprintf(text, sizeof text, "%s%s", before, free_gap_note(table, 1));
    for (int a = free; a < table->naxes && n > 0 && (size_t)n < sizeof text; a++)
        n += snprintf(text + n, sizeof text - (size_t)n, " %s = %s.", table->axis[a].key,
                      table->axis[a].text[at ? at[a] : 0]);
    thud_figure_note(figure, text);
}

/* ---- amplification ---- */

static const char *helps(enum thud_case which)
{
    return which == THUD_CASE_LINK ? "Ratio to no link at the same gap; below 1 the links help."
                                   : "Ratio to no bumper at the same gap; below 1 the bumper helps.";
}
static const char pounds[] = "Ratio to no pounding at all; above 1 pounding harms.";

/* Of case none: to no pounding. */
static void ratio_axes(struct thud_panel *panel, const struct thud_sweep_table *table, enum quantity q,
                       enum thud_case which)
{
    varied_axis(panel, THUD_X, table, 0);
    thud_panel_axis(panel, THUD_Y, ratio_label[q], "");
    if (which != THUD_CASE_NONE)
        thud_panel_mark(panel, THUD_Y, 0.0, 1.0, which == THUD_CASE_LINK ? "links help" : "bumper helps");
    thud_panel_mark(panel, THUD_Y, 1.0, 1.0, "");
}

/* Whether a point is on a curve. */
static bool is_on(const struct thud_sweep_table *table, const struct wanted *w, const struct thud_sweep_summary *d)
{
    return d->record == w->record && drawn(table, d, 1, w->at);
}

/* The spread of a curve, behind all curves: a band, or a bar for each of the words of a list. */
static void ratio_shade(struct thud_panel *panel, const struct thud_sweep_table *table, const struct wanted *wanted,
                        enum quantity q, const char *name, int color)
{
    const struct thud_sweep_axis *axis = &table->axis[0];
    struct thud_style style = {.color = color, .thin = true};
    size_t each = numbers(axis) ? 1 : 3;
    if (!(table->sensitivity > 0) && table->motions == 0)
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

/* Fractiles over the ground motions of a structure's mean: the band from 16 to 84 % and the median. */
static void ratio_fractiles(struct thud_panel *panel, const struct thud_sweep_table *table, const struct wanted *wanted,
                            enum quantity q)
{
    const struct thud_sweep_axis *axis = &table->axis[0];
    size_t n = (size_t)axis->n, records = (size_t)table->nrecords;
    double *x = malloc((4 * n + n * records) * sizeof *x), *low = x + n, *median = low + n, *high = median + n;
    double *value = high + n; /* (n x records) */
    if (!x) {
        if (panel)
            panel->figure->failed = true;
        return;
    }
    for (size_t i = 0; i < n * records; i++)
        value[i] = NAN;
    for (size_t i = 0; i < table->npoints; i++) {
        const struct thud_sweep_summary *d = table->point[i];
        if (drawn(table, d, 1, wanted->at))
            value[(size_t)d->at[0] * records + (size_t)d->record] = ratio(d, wanted, THUD_SWEEP_VALUE, q);
    }
    for (size_t i = 0; i < n; i++) {
        struct thud_fractiles f = thud_fractiles_of(value + i * records, records, 1);
        x[i] = place(axis, (int)i);
        low[i] = f.p16;
        median[i] = f.median;
        high[i] = f.p84;
    }
    thud_panel_fill(panel, (struct thud_style){.color = 0, .thin = true}, "median", n, x, low, high);
    thud_panel_add(
        panel, (struct thud_style){.kind = numbers(axis) ? THUD_LINES_POINTS : THUD_POINTS, .color = 0, .wide = true},
        "median", n, x, median);
    free(x);
}

/* What the shades are, where there are any. */
static const char *shade_note(const struct thud_sweep_table *table, char text[128])
{
    text[0] = '\0';
    if (table->motions > 0)
        snprintf(text, 128, " Medians of %d ground motions, 16 to 84 %% shaded.", table->motions);
    else if (table->sensitivity > 0)
        snprintf(text, 128, " Shaded: spread under %g %% less or more gap, ground motion, stiffness, one at a time.",
                 100 * table->sensitivity);
    return text;
}

/* The panels of a quantity (a row) on one scale, so that what moves more is seen to move more; with those of `other`
 * too, another figure to be compared. */
static void same_scale(struct thud_figure *figure, const struct thud_figure *other)
{
    for (int row = 0; figure && row < figure->rows; row++)
        thud_figure_share_scale(figure, THUD_Y, row * figure->columns, 1, figure->columns, other);
}

struct thud_figure *thud_figure_by_floor(const struct thud_sweep_table *table, int record, enum thud_case which,
                                         const char *name, const char *title)
{
    int structure[COLUMNS_MAX], columns = columns_of(table, structure);
    bool free = which == THUD_CASE_NONE;
    char text[512], head[160];
    snprintf(text, sizeof text, "%s: %s, floor by floor", record_name(table, record, head), amplification(which));
    struct thud_figure *figure = thud_figure_create(name, title ? title : text, 2, columns > 0 ? columns : 1);
    for (int c = 0; c < columns; c++) {
        int floors = floors_of(table, structure[c]), step = (floors + CURVES_MAX - 1) / CURVES_MAX;
        assert(floors > 0);
        for (int q = ACCELERATION; q <= DRIFT; q++) {
            struct thud_panel *panel = thud_figure_panel(figure, q, c, structure_title(table, structure[c], head));
            ratio_axes(panel, table, (enum quantity)q, which);
            /* with more floors than curves every step-th from the top down, so that the top is there */
            int first = floors - (floors - 1) / step * step, curves = (floors - first) / step + 1;
            for (int i = 0; i < 2 * curves; i++) {
                int f = first + i % curves * step;
                struct wanted wanted = {
                    .record = record, .which = which, .structure = structure[c], .floor = f, .free = free};
                snprintf(text, sizeof text, "floor %d", f);
                (i < curves ? ratio_shade : ratio_line)(panel, table, &wanted, (enum quantity)q, text, f - 1);
            }
            snprintf(text, sizeof text, "Every %d. floor of %d", step, floors);
            if (step > 1)
                thud_panel_note(panel, text);
        }
    }
    char note[256], shades[128];
    snprintf(note, sizeof note, "%s%s", free ? pounds : helps(which), shade_note(table, shades));
    same_scale(figure, NULL);
    fixed_note(figure, table, 1, NULL, note);
    return figure;
}

static struct thud_figure *means(const struct thud_sweep_table *table, enum thud_case which, const char *name,
                                 const char *title)
{
    int structure[COLUMNS_MAX], columns = columns_of(table, structure);
    char text[256], head[160];
    if (table->nrecords == 1 && table->motions == 0)
        snprintf(text, sizeof text, "%s: %s, means over the floors", record_name(table, 0, head), amplification(which));
    else
        snprintf(text, sizeof text, "A%s, means over the floors", amplification(which) + 1);
    struct thud_figure *figure = thud_figure_create(name, title ? title : text, 2, columns > 0 ? columns : 1);
    for (int c = 0; c < columns; c++) {
        for (int q = ACCELERATION; q <= DRIFT; q++) {
            struct thud_panel *panel = thud_figure_panel(figure, q, c, structure_title(table, structure[c], head));
            ratio_axes(panel, table, (enum quantity)q, which);
            if (table->nrecords > CURVES_MAX) { /* a suite: what they say together */
                struct wanted wanted = {.which = which, .structure = structure[c], .floor = 0};
                ratio_fractiles(panel, table, &wanted, (enum quantity)q);
                continue;
            }
            int curves = table->nrecords;
            for (int i = 0; i < 2 * curves; i++) {
                int r = i % curves;
                struct wanted wanted = {.record = r, .which = which, .structure = structure[c], .floor = 0};
                (i < curves ? ratio_shade : ratio_line)(panel, table, &wanted, (enum quantity)q,
                                                        record_name(table, r, head), r);
            }
        }
    }
    char note[384], shades[128];
    if (table->nrecords > CURVES_MAX)
        snprintf(note, sizeof note, "%s Median of %d ground motions, 16 to 84 %% shaded.", helps(which),
                 table->nrecords);
    else
        snprintf(note, sizeof note, "%s%s", helps(which), shade_note(table, shades));
    fixed_note(figure, table, 1, NULL, note);
    return figure;
}

struct thud_figure *thud_figure_of_means(const struct thud_sweep_table *table, enum thud_case which, const char *name,
                                         const char *title)
{
    struct thud_figure *figure = means(table, which, name, title), *other = NULL;
    enum thud_case twin = which != THUD_CASE_BUMPER           ? THUD_CASE_BUMPER
                          : has_case(table, THUD_CASE_CAVITY) ? THUD_CASE_CAVITY
                                                              : THUD_CASE_LINK;
    if (which >= 0 && has_case(table, twin) && !(other = means(table, twin, name, title)) && figure)
        figure->failed = true;
    same_scale(figure, other);
    thud_figure_free(other);
    return figure;
}

struct thud_figure *thud_figure_of_pounding(const struct thud_sweep_table *table, int record, const char *name)
{
    int structure[COLUMNS_MAX], columns = columns_of(table, structure);
    char text[512], head[160];
    snprintf(text, sizeof text, "%s: means over the floors, ratio to no pounding", record_name(table, record, head));
    struct thud_figure *figure = thud_figure_create(name, text, 2, columns > 0 ? columns : 1);
    for (int c = 0; c < columns; c++) {
        for (int q = ACCELERATION; q <= DRIFT; q++) {
            struct thud_panel *panel = thud_figure_panel(figure, q, c, structure_title(table, structure[c], head));
            ratio_axes(panel, table, (enum quantity)q, THUD_CASE_NONE);
            for (int i = 0; i < 2 * (THUD_CASES + 1); i++) { /* what is shaded first */
                int which = i % (THUD_CASES + 1) + THUD_CASE_AS_WRITTEN;
                struct wanted wanted = {
                    .record = record, .which = (enum thud_case)which, .structure = structure[c], .free = true};
                if (has_case(table, wanted.which) && (i > THUD_CASES || table->motions > 0))
                    (i > THUD_CASES ? ratio_line : ratio_shade)(panel, table, &wanted, (enum quantity)q,
                                                                thud_case_title(wanted.which),
                                                                thud_case_color(wanted.which));
            }
        }
    }
    char note[256], shades[128];
    snprintf(note, sizeof note, "%s%s", pounds, table->motions > 0 ? shade_note(table, shades) : "");
    same_scale(figure, NULL);
    fixed_note(figure, table, 1, NULL, note);
    return figure;
}

/* ---- contacts ---- */

/* What is told of a run: of its contacts, the next two over a suite only; of the columns that slabs strike; of the
 * storeys of a structure. */
enum told {
    TOLD_FORCE,
    TOLD_IMPACTS,
    TOLD_POUNDING,
    TOLD_WORSE,
    TOLD_SHEAR,
    TOLD_CAPACITY,
    TOLD_DUCTILITY,
    TOLD_PERMANENT
};

static double told_of_storeys(const struct thud_sweep_storeys *storeys, enum told told)
{
    return told == TOLD_DUCTILITY ? storeys->ductility : 1e3 * storeys->permanent_m;
}

static double told_of_columns(const struct thud_sweep_run *run, const struct thud_sweep_shares *shares, enum told told,
                              enum thud_sweep_end end)
{
    if (end == THUD_SWEEP_VALUE || !shares)
        return told == TOLD_CAPACITY ? run->capacity_ratio : 1e-6 * run->shear_n;
    if (told == TOLD_CAPACITY)
        return end == THUD_SWEEP_LOW ? shares->capacity_low : shares->capacity_high;
    return 1e-6 * (end == THUD_SWEEP_LOW ? shares->shear_low_n : shares->shear_high_n);
}

/* Of run k of point i. */
static double told_of(const struct thud_sweep_table *table, size_t i, int k, enum told told, int structure,
                      enum thud_sweep_end end)
{
    if (told >= TOLD_DUCTILITY)
        return told_of_storeys(thud_sweep_summary_storeys(table->point[i], k, table->nstructures, structure, end),
                               told);
    const struct thud_sweep_run *run = &table->point[i]->run[k];
    const struct thud_sweep_shares *shares =
        table->shares ? &table->shares[i * THUD_SWEEP_CASES_MAX + (size_t)k] : NULL;
    if (told >= TOLD_SHEAR)
        return told_of_columns(run, shares, told, end);
    if (told == TOLD_IMPACTS)
        return run->impacts;
    if (told == TOLD_FORCE && (end == THUD_SWEEP_VALUE || !shares))
        return 1e-6 * run->force_n;
    if (told == TOLD_FORCE)
        return 1e-6 * (end == THUD_SWEEP_LOW ? shares->force_low_n : shares->force_high_n);
    if (!shares)
        return NAN;
    if (end == THUD_SWEEP_VALUE)
        return 100 * (told == TOLD_POUNDING ? shares->pounding : shares->worse);
    return 100 * (told == TOLD_POUNDING ? shares->pounding_band : shares->worse_band)[end == THUD_SWEEP_HIGH];
}

static void told_line(struct thud_panel *panel, const struct thud_sweep_table *table, int record, enum thud_case which,
                      enum told told, int structure)
{
    const struct thud_sweep_axis *axis = &table->axis[0];
    struct thud_style style = {.kind = numbers(axis) ? THUD_LINES_POINTS : THUD_POINTS,
                               .color = thud_case_color(which)};
    char name[64];
    snprintf(name, sizeof name, "%s%s", thud_case_title(which), told == TOLD_WORSE ? ": worse" : "");
    const bool share = told == TOLD_POUNDING || told == TOLD_WORSE,
               band = table->motions > 0 && (told == TOLD_FORCE || told >= TOLD_SHEAR);
    style.color += told == TOLD_WORSE ? 4 : 0;
    struct thud_series *shade = band ? thud_panel_fill(panel, (struct thud_style){.color = style.color, .thin = true},
                                                       name, (size_t)axis->n, NULL, NULL, NULL)
                                     : NULL;
    for (int i = 0; shade && i < axis->n; i++) {
        shade->x[i] = place(axis, i);
        shade->y[i] = shade->y_high[i] = NAN;
    }
    struct thud_series *series = thud_panel_add(panel, style, name, (size_t)axis->n, NULL, NULL);
    if (!series)
        return;
    for (int i = 0; i < axis->n; i++) {
        series->x[i] = place(axis, i);
        series->y[i] = NAN;
    }
    for (size_t i = 0; i < table->npoints; i++) {
        const struct thud_sweep_summary *d = table->point[i];
        bool is = d->record == record && (d->has_contact || told >= TOLD_DUCTILITY) && drawn(table, d, 1, NULL);
        int k = is ? thud_sweep_summary_find(d, which) : -1;
        if (k < 0)
            continue;
        series->y[d->at[0]] = told_of(table, i, k, told, structure, THUD_SWEEP_VALUE);
        const double low = told_of(table, i, k, told, structure, THUD_SWEEP_LOW),
                     high = told_of(table, i, k, told, structure, THUD_SWEEP_HIGH);
        if (shade) {
            shade->y[d->at[0]] = low;
            shade->y_high[d->at[0]] = high;
        } else if (share && !isnan(low)) { /* of counts a bar each, and no band between them */
            const double beside = 0.005 * (2 * (int)which - (int)THUD_CASES + (told == TOLD_WORSE)),
                         at = series->x[d->at[0]] + beside * (place(axis, axis->n - 1) - place(axis, 0));
            thud_panel_bars(panel, style.color, 1, &at, &low, &high);
        }
    }
}

/* From 0; impacts on a log axis where they are hundreds. */
static void contact_scale(struct thud_panel *panel, bool counts)
{
    double least = INFINITY, most = 0;
    for (int i = 0; panel && i < panel->nseries; i++)
        for (size_t k = 0; k < panel->series[i]->n; k++) {
            double y = panel->series[i]->y[k];
            if (y > 0) {
                least = fmin(least, y);
                most = fmax(most, y);
            }
        }
    if (counts && most >= 200 && most > 100 * least)
        thud_panel_log(panel, THUD_Y);
    else
        thud_panel_limits(panel, THUD_Y, 0.0, NAN);
}

struct thud_figure *thud_figure_of_contacts(const struct thud_sweep_table *table, int record, const char *name)
{
    char text[512], head[160];
    bool suite = table->motions > 0;
    snprintf(text, sizeof text, "%s: largest impact force and %s", record_name(table, record, head),
             suite ? "how many pound" : "number of impacts");
    struct thud_figure *figure = thud_figure_create(name, text, 1, 2);
    for (int i = 0; i < 2; i++) {
        struct thud_panel *panel = thud_figure_panel(figure, 0, i,
                                                     i == 0  ? "Largest impact force"
                                                     : suite ? "Ground motions that pound"
                                                             : "All impacts of the run");
        varied_axis(panel, THUD_X, table, 0);
        thud_panel_axis(panel, THUD_Y,
                        i == 0  ? "Force"
                        : suite ? "Share"
                                : "Impacts",
                        i == 0  ? "MN"
                        : suite ? "%"
                                : "");
        for (int which = THUD_CASE_AS_WRITTEN; which < THUD_CASES; which++) {
            if (has_case(table, (enum thud_case)which))
                told_line(panel, table, record, (enum thud_case)which,
                          i == 0  ? TOLD_FORCE
                          : suite ? TOLD_POUNDING
                                  : TOLD_IMPACTS,
                          0);
            if (i == 1 && suite && which != THUD_CASE_NONE && has_case(table, (enum thud_case)which))
                told_line(panel, table, record, (enum thud_case)which, TOLD_WORSE, 0);
        }
        if (i == 1 && suite)
            thud_panel_limits(panel, THUD_Y, -4, 104); /* so that none and all stand off the frame */
        else
            contact_scale(panel, i == 1);
    }
    char shades[128];
    snprintf(text, sizeof text, "%s%s", suite ? shade_note(table, shades) + 1 : "",
             suite ? " Worse: a structure's mean acceleration is larger than without bumper. Bars: 90 % bands of the "
                     "shares (Wilson)."
                   : "");
    fixed_note(figure, table, 1, NULL, text);
    return figure;
}

/* ---- storeys that yield, columns that slabs strike ---- */

/* Whether some run has such a number: a storey of the structure yields, columns are struck at all, or their capacity is
 * given. */
static bool is_told(const struct thud_sweep_table *table, enum told told, int structure)
{
    for (size_t i = 0; i < table->npoints; i++)
        for (int k = 0; k < table->point[i]->nruns; k++)
            if (!isnan(told_of(table, i, k, told, structure, THUD_SWEEP_VALUE)))
                return true;
    return false;
}

static bool has_yielding(const struct thud_sweep_table *table)
{
    for (int s = 0; s < table->nstructures; s++)
        if (is_told(table, TOLD_DUCTILITY, s))
            return true;
    return false;
}

/* A curve for each case. */
static void told_lines(struct thud_panel *panel, const struct thud_sweep_table *table, int record, enum told told,
                       int structure)
{
    for (int which = THUD_CASE_AS_WRITTEN; which < THUD_CASES; which++)
        if (has_case(table, (enum thud_case)which))
            told_line(panel, table, record, (enum thud_case)which, told, structure);
    contact_scale(panel, false);
}

static struct thud_figure *figure_of_yielding(const struct thud_sweep_table *table, int record, const char *name)
{
    int structure[COLUMNS_MAX], columns = columns_of(table, structure), n = 0;
    char text[512], head[160];
    for (int c = 0; c < columns; c++)
        if (is_told(table, TOLD_DUCTILITY, structure[c]))
            structure[n++] = structure[c];
    snprintf(text, sizeof text, "%s: storeys that yield, the largest of each building",
             record_name(table, record, head));
    struct thud_figure *figure = thud_figure_create(name, text, 2, n > 0 ? n : 1);
    for (int c = 0; c < n; c++)
        for (int row = 0; row < 2; row++) {
            struct thud_panel *panel = thud_figure_panel(figure, row, c, structure_title(table, structure[c], head));
            varied_axis(panel, THUD_X, table, 0);
            thud_panel_axis(panel, THUD_Y, row == 0 ? "Ductility" : "Permanent drift", row == 0 ? "" : "mm");
            told_lines(panel, table, record, row == 0 ? TOLD_DUCTILITY : TOLD_PERMANENT, structure[c]);
            if (row == 0)
                thud_panel_mark(panel, THUD_Y, 1.0, 1.0, "");
        }
    same_scale(figure, NULL);
    char shades[128];
    snprintf(text, sizeof text, "%s%s", thud_ductility_note, table->motions > 0 ? shade_note(table, shades) : "");
    fixed_note(figure, table, 1, NULL, text);
    return figure;
}

static struct thud_figure *figure_of_struck_columns(const struct thud_sweep_table *table, int record, const char *name)
{
    bool capacity = is_told(table, TOLD_CAPACITY, 0);
    char text[512], head[160];
    snprintf(text, sizeof text, "%s: columns that slabs strike", record_name(table, record, head));
    struct thud_figure *figure = thud_figure_create(name, text, 1, capacity ? 2 : 1);
    for (int i = 0; i < 1 + capacity; i++) {
        struct thud_panel *panel =
            thud_figure_panel(figure, 0, i, i == 0 ? "Largest shear" : "Largest shear over capacity");
        varied_axis(panel, THUD_X, table, 0);
        thud_panel_axis(panel, THUD_Y, i == 0 ? "Shear" : "Shear over capacity", i == 0 ? "MN" : "");
        told_lines(panel, table, record, i == 0 ? TOLD_SHEAR : TOLD_CAPACITY, 0);
        if (i == 1)
            thud_panel_mark(panel, THUD_Y, 1.0, 1.0, "capacity");
    }
    char shades[128];
    fixed_note(figure, table, 1, NULL, table->motions > 0 ? shade_note(table, shades) + 1 : "");
    return figure;
}

/* A dot in every cell where the response is larger: the two ends of the colours are one grey in print. */
static void add_harm(struct thud_panel *panel, const struct thud_map *map)
{
    static const double harm = 1.01;
    struct thud_series *dots =
        thud_panel_add(panel, (struct thud_style){.kind = THUD_POINTS, .color = THUD_COLORS - 1, .thin = true},
                       "ratio above 1.01", map->nx * map->ny, NULL, NULL);
    size_t n = 0;
    for (size_t i = 0; dots && i < map->nx * map->ny; i++)
        if (map->z[i] > harm) {
            dots->x[n] = map->x[i % map->nx];
            dots->y[n++] = map->y[i / map->nx];
        }
    if (dots)
        dots->n = n;
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
        if (d->record == wanted->record && drawn(table, d, 2, wanted->at))
            map->z[(size_t)d->at[1] * map->nx + (size_t)d->at[0]] = ratio(d, wanted, THUD_SWEEP_VALUE, q);
    }
    add_harm(panel, map);
}

/* One scale of colours for all panels, as far to one side of 1 as to the other. */
static void same_colors(struct thud_figure *figure)
{
    double half = 0.0;
    for (int p = 0; figure && p < figure->rows * figure->columns; p++) {
        double least, most;
        if (figure->panel[p].map && thud_map_range(figure->panel[p].map, &least, &most))
            half = fmax(half, fmax(most - 1.0, 1.0 - least));
    }
    for (int p = 0; figure && p < figure->rows * figure->columns; p++)
        if (figure->panel[p].map)
            figure->panel[p].map->reach = half;
}

struct thud_figure *thud_figure_of_map(const struct thud_sweep_table *table, int record, enum thud_case which,
                                       const int *at, const char *name)
{
    int structure[COLUMNS_MAX], columns = columns_of(table, structure);
    bool free = which == THUD_CASE_NONE;
    char text[768], head[160];
    int n = snprintf(text, sizeof text, "%s: %s, means over the floors", record_name(table, record, head),
                     amplification(which));
    for (int a = 2; a < table->naxes && n > 0 && (size_t)n < sizeof text; a++)
        n += snprintf(text + n, sizeof text - (size_t)n, ", %s %s", table->axis[a].key,
                      table->axis[a].text[at ? at[a] : 0]);
    struct thud_figure *figure = thud_figure_create(name, text, 2, columns > 0 ? columns : 1);
    for (int c = 0; c < columns; c++) {
        for (int q = ACCELERATION; q <= DRIFT; q++) {
            snprintf(text, sizeof text, "%s: %s", structure_title(table, structure[c], head), quantity_title[q]);
            struct thud_panel *panel = thud_figure_panel(figure, q, c, text);
            varied_axis(panel, THUD_X, table, 0);
            varied_axis(panel, THUD_Y, table, 1);
            struct wanted wanted = {
                .record = record, .which = which, .structure = structure[c], .floor = 0, .free = free, .at = at};
            fill_map(panel, table, &wanted, (enum quantity)q);
        }
    }
    same_colors(figure);
    bool line = numbers(&table->axis[0]) && numbers(&table->axis[1]);
    snprintf(text, sizeof text, "%s%s%s%s",
             free                      ? "Ratio to no pounding; red: pounding harms;"
             : which == THUD_CASE_LINK ? "Ratio to no link at the same gap; blue: the links help;"
                                       : "Ratio to no bumper at the same gap; blue: the bumper helps;",
             line ? " line: ratio 1 where there is contact;" : "", " white: no change; empty: no result.",
             free_gap_note(table, 2));
    thud_figure_note(figure, text);
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
        if (table->point[i]->has_contact)
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

/* Cases of a study whose figures are amplifications; `none`, over no pounding, where there is no other. */
static int shown_cases(const struct thud_sweep_table *table, enum thud_case *which)
{
    int n = compared(table, which);
    if (n == 0 && has_case(table, THUD_CASE_NONE))
        which[n++] = THUD_CASE_NONE;
    return n;
}

/* Settings of the keys past the two of a map; `at` gets number i of them. */
static int slices(const struct thud_sweep_table *table, int i, int at[THUD_VARY_MAX])
{
    int n = 1;
    for (int a = table->naxes - 1; a >= 2; a--) {
        at[a] = i / n % table->axis[a].n;
        n *= table->axis[a].n;
    }
    return n;
}

enum { MAPS_MOST = 24 };

/* What a study's figures are: `each` of every case and record, means of every case (before those where there are several
 * records), then `last` of every record. */
enum last { CONTACT_FORCES, POUNDING, YIELDING, STRUCK_COLUMNS, LAST };
struct list {
    int ncases, slices, each, means, last;
    enum last of_record[LAST]; /* (last) */
    enum thud_case which[THUD_CASES + 1];
};

static struct list list_of(const struct thud_sweep_table *table)
{
    struct list l = {0};
    int at[THUD_VARY_MAX];
    if (table->naxes == 0 || table->nrows == 0)
        return l;
    bool one = table->naxes == 1;
    l.ncases = shown_cases(table, l.which);
    l.slices = one ? 1 : slices(table, 0, at);
    if (l.slices > MAPS_MOST)
        l.slices = MAPS_MOST;
    l.each = table->nrecords * l.slices;
    l.means = one && !(l.ncases == 1 && l.which[0] == THUD_CASE_NONE);
    if (one && has_contacts(table)) {
        l.of_record[l.last++] = CONTACT_FORCES;
        l.of_record[l.last++] = POUNDING;
    }
    if (one && has_yielding(table))
        l.of_record[l.last++] = YIELDING;
    if (one && is_told(table, TOLD_SHEAR, 0))
        l.of_record[l.last++] = STRUCK_COLUMNS;
    return l;
}

int thud_sweep_figure_count(const struct thud_sweep_table *table)
{
    struct list l = list_of(table);
    return l.ncases * (l.each + l.means) + l.last * table->nrecords;
}

struct thud_figure *thud_sweep_figure(const struct thud_sweep_table *table, int index)
{
    struct list l = list_of(table);
    int per_case = l.each + l.means, c = per_case > 0 ? index / per_case : 0, at[THUD_VARY_MAX] = {0};
    char name[128], number[24] = "", slice[24] = "";
    if (per_case == 0 || c >= l.ncases) {
        static const char *const names[] = {"contact-forces", "pounding", "yielding", "struck-columns"};
        static struct thud_figure *(*const make[])(const struct thud_sweep_table *, int, const char *) = {
            thud_figure_of_contacts, thud_figure_of_pounding, figure_of_yielding, figure_of_struck_columns};
        int rest = index - l.ncases * per_case, record = rest / l.last;
        enum last which = l.of_record[rest % l.last];
        if (table->nrecords > 1)
            snprintf(number, sizeof number, "-%d", record + 1);
        snprintf(name, sizeof name, "%s%s", names[which], number);
        return make[which](table, record, name);
    }
    int i = index % per_case;
    bool first = l.means && table->nrecords > 1; /* what several motions say together comes before each of them */
    if (l.means && i == (first ? 0 : l.each)) {
        snprintf(name, sizeof name, "means-%s", thud_case_name(l.which[c]));
        return thud_figure_of_means(table, l.which[c], name, NULL);
    }
    i -= first;
    int record = i / l.slices;
    if (table->nrecords > 1)
        snprintf(number, sizeof number, "-%d", record + 1);
    if (l.slices > 1)
        snprintf(slice, sizeof slice, "-at%d", i % l.slices + 1);
    if (table->naxes > 1)
        slices(table, i % l.slices, at);
    snprintf(name, sizeof name, "%s-%s%s%s", table->naxes == 1 ? "floors" : "map", thud_case_name(l.which[c]), number,
             slice);
    return table->naxes == 1 ? thud_figure_by_floor(table, record, l.which[c], name, NULL)
                             : thud_figure_of_map(table, record, l.which[c], at, name);
}
