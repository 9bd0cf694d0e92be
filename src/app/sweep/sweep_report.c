#include "app/sweep/sweep_report.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/run/result_table.h"
#include "app/run/summary_line.h"
#include "app/sweep/gap_report.h"
#include "io/result/study_rows.h"
#include "io/result/sweep_csv.h"
#include "study/scene/level.h"
#include "study/sweep/sweep_best.h"

enum { PLACE = 80, NAME = 9, HEAD = 9 }; /* columns: of a place, at least of a name, of the case before it */

static const char *short_name(const char *path)
{
    return *path ? thud_path_name(path) : "-";
}

static const char *place_of(const struct thud_sweep_plan *plan, const struct thud_sweep_summary *d, char text[PLACE])
{
    return thud_sweep_setting(plan, plan->naxes, d->at, -1, false, text, PLACE);
}

/* Least and largest of a ratio, and where the largest is. */
struct span {
    double least, most;
    int floor;
    const struct thud_sweep_summary *at; /* NULL: there is none */
};

static void widen(struct span *span, double x, const struct thud_sweep_summary *d, int floor)
{
    if (isnan(x))
        return;
    if (!span->at || x < span->least)
        span->least = x;
    if (!span->at || x > span->most)
        *span = (struct span){span->at ? span->least : x, x, floor, d};
}

/* "0.942 to 1.014", or one number where both are shown alike; `none` where there is none. */
static void put_span(const struct span *span, const char *fmt, const char *none, int columns, struct thud_text *out)
{
    char least[32], most[32], text[72];
    snprintf(text, sizeof text, "%s", none);
    if (span->at) {
        snprintf(least, sizeof least, fmt, span->least);
        snprintf(most, sizeof most, fmt, span->most);
        snprintf(text, sizeof text, strcmp(least, most) ? "%s to %s" : "%s", least, most + strspn(most, " "));
    }
    thud_text_append(out, " %-*s", columns, text);
}

/* `free`: over no pounding, else over case none. */
static void put_structure(const struct thud_sweep_plan *plan, const struct thud_sweep_table *table, int record,
                          enum thud_case which, int structure, bool free, struct thud_text *out)
{
    struct span mean = {0}, floor = {0}, drift = {0};
    char at[PLACE];
    for (size_t i = 0; i < table->npoints; i++) {
        const struct thud_sweep_summary *d = table->point[i];
        const struct thud_sweep_ratio *x;
        int k = d->record == record ? thud_sweep_summary_find(d, which) : -1;
        for (int f = 0; k >= 0 && (x = thud_sweep_summary_ratio(d, k, structure, f, THUD_SWEEP_VALUE)) != NULL; f++) {
            widen(f == 0 ? &mean : &floor, free ? x->acceleration_free : x->acceleration, d, f);
            if (f == 0)
                widen(&drift, free ? x->drift_free : x->drift, d, f);
        }
    }
    if (!mean.at || !floor.at)
        return;
    thud_text_append(out, "  %-8s ", thud_case_name(which));
    thud_text_padded(out, plan->scene.structure[structure].name, thud_scene_names_width(&plan->scene, NAME));
    put_span(&mean, "%5.3f", "", 14, out);
    thud_text_append(out, "  %5.3f on floor %-3d ", floor.most, floor.floor);
    put_span(&drift, "%5.3f", "  -", 14, out);
    thud_table_whole(out, place_of(plan, floor.at, at), 11);
    thud_text_append(out, "\n");
}

/* Whether links act in the motion of a required gap, of a scene that has them. */
static const char *linked(const struct thud_sweep_table *table)
{
    return !(table->measures & THUD_HAS_LINKS) ? "" : table->need_links ? "links act, " : "without links, ";
}

static void put_need(const struct thud_sweep_plan *plan, const struct thud_sweep_table *table, int record,
                     struct thud_text *out)
{
    const struct thud_sweep_need_row *worst = table->need ? &table->need[record] : NULL;
    if (!worst || worst->level.interface == 0)
        return;
    const struct thud_sweep_need_row *least = worst + table->nrecords;
    struct thud_text words = {0};
    char interface[24] = "", pair[40], at[PLACE];
    const double ddc_m = thud_gap_value(&worst->level, THUD_GAP_DDC);
    bool varies = thud_sweep_points(plan) > thud_sweep_points_per_group(plan) * table->nrecords;
    if (table->nstructures > 2)
        snprintf(interface, sizeof interface, "interface %d, ", worst->level.interface);
    thud_contact_pair_name(worst->level.left_floor, worst->level.right_floor, worst->level.struck, pair, sizeof pair);
    thud_text_append(&words, "required gap %.2f cm (%s%sfloors %s)",
                     thud_table_gap_cm(worst->level.relative_displacement_m), linked(table), interface, pair);
    if (varies)
        thud_text_append(&words, " at %s", thud_sweep_setting(plan, plan->nouter, worst->at, -1, true, at, PLACE));
    thud_text_append(&words, "; ABS %.2f, SRSS %.2f", thud_table_gap_cm(thud_gap_value(&worst->level, THUD_GAP_ABS)),
                     thud_table_gap_cm(thud_gap_value(&worst->level, THUD_GAP_SRSS)));
    if (!isnan(ddc_m)) /* where storeys yield it has no value */
        thud_text_append(&words, ", DDC %.2f", thud_table_gap_cm(ddc_m));
    thud_text_append(&words, " cm");
    thud_table_words(out, "  ", &words, 4);
    if (varies) {
        thud_text_append(&words, "least %.2f cm at %s (needed-gaps.csv of -o has every point's)",
                         thud_table_gap_cm(least->level.relative_displacement_m),
                         thud_sweep_setting(plan, plan->nouter, least->at, -1, true, at, PLACE));
        thud_table_words(out, "    ", &words, 6);
    }
    if (worst->fall.happened)
        thud_gap_collapse(&plan->scene, &worst->fall, "Storey", out);
}

/* Least and largest of a number of the runs of a case, and where the largest is; `structure` -1: of the columns that
 * slabs strike. */
static struct span span_of(const struct thud_sweep_table *table, int record, enum thud_case which, int structure,
                           bool second)
{
    struct span span = {0};
    for (size_t i = 0; i < table->npoints; i++) {
        const struct thud_sweep_summary *d = table->point[i];
        int k = d->record == record ? thud_sweep_summary_find(d, which) : -1;
        if (k < 0)
            continue;
        const enum thud_measure measure = structure < 0 ? (second ? THUD_MEASURE_COLUMNS : THUD_MEASURE_SHEAR)
                                          : second      ? THUD_MEASURE_PERMANENT
                                                        : THUD_MEASURE_DUCTILITY;
        const double factor = measure == THUD_MEASURE_SHEAR ? 1e-6 : measure == THUD_MEASURE_PERMANENT ? 1e3 : 1;
        widen(&span, factor * thud_sweep_summary_value(d, k, measure, structure, THUD_SWEEP_VALUE), d, 0);
    }
    return span;
}

/* What yielding storeys and struck columns come to, a line for each case and structure. */
static void put_yielding(const struct thud_sweep_plan *plan, const struct thud_sweep_table *table, int record,
                         struct thud_text *out)
{
    const int width = thud_scene_names_width(&plan->scene, NAME);
    bool head[2] = {false};
    char at[PLACE];
    for (int s = 0; s <= table->nstructures; s++)
        for (int k = 0; k < plan->ncases; k++) {
            bool columns = s == table->nstructures;
            struct span first = span_of(table, record, plan->cases[k], columns ? -1 : s, false);
            struct span second = span_of(table, record, plan->cases[k], columns ? -1 : s, true);
            if (!first.at)
                continue;
            if (!head[columns])
                thud_text_append(out, "  %-*s %s\n", HEAD + width, columns ? "struck columns" : "storeys that yield",
                                 columns ? "largest shear, MN   over capacity       at"
                                         : "largest ductility   permanent, mm       at");
            head[columns] = true;
            thud_text_append(out, "  %-8s ", thud_case_name(plan->cases[k]));
            thud_text_padded(out, columns ? "" : plan->scene.structure[s].name, width);
            put_span(&first, "%6.3f", "", 18, out);
            put_span(&second, "%6.3g", "     -", 18, out);
            thud_table_whole(out, place_of(plan, first.at, at), 11);
            thud_text_append(out, "\n");
        }
}

/* Where the spread of a ratio is widest, against the ratio. */
struct widest {
    const struct thud_sweep_summary *at; /* NULL: there is none */
    int run, structure, floor;
    double change;
};

static void compare_spread(struct widest *widest, const struct thud_sweep_summary *d, int k, int nstructures)
{
    for (int s = 0; s < nstructures; s++)
        for (int f = 0; thud_sweep_summary_ratio(d, k, s, f, THUD_SWEEP_LOW); f++) {
            double x = thud_sweep_summary_ratio(d, k, s, f, THUD_SWEEP_VALUE)->acceleration;
            double low = thud_sweep_summary_ratio(d, k, s, f, THUD_SWEEP_LOW)->acceleration;
            double high = thud_sweep_summary_ratio(d, k, s, f, THUD_SWEEP_HIGH)->acceleration;
            double change = fmax(high / x - 1, 1 - low / x);
            if (change > widest->change)
                *widest = (struct widest){d, k, s, f, change};
        }
}

static void put_spread(const struct thud_sweep_plan *plan, const struct thud_sweep_table *table, int record,
                       enum thud_case which, struct thud_text *out)
{
    struct widest w = {0};
    char at[PLACE];
    for (size_t i = 0; i < table->npoints; i++) {
        const struct thud_sweep_summary *d = table->point[i];
        int k = d->record == record ? thud_sweep_summary_find(d, which) : -1;
        if (k >= 0)
            compare_spread(&w, d, k, table->nstructures);
    }
    if (!w.at)
        return;
    int digits = thud_spread_digits(w.change);
    thud_text_append(out, "  %-8s widest spread %.3g to %.3g, of ", thud_case_name(which),
                     thud_sweep_summary_ratio(w.at, w.run, w.structure, w.floor, THUD_SWEEP_LOW)->acceleration,
                     thud_sweep_summary_ratio(w.at, w.run, w.structure, w.floor, THUD_SWEEP_HIGH)->acceleration);
    if (w.floor > 0)
        thud_text_append(out, "%s floor %d", plan->scene.structure[w.structure].name, w.floor);
    else
        thud_text_append(out, "%s's mean", plan->scene.structure[w.structure].name);
    thud_text_append(out, " at %s: ", place_of(plan, w.at, at));
    if (digits == 0)
        thud_text_append(out, "no digit means anything\n");
    else
        thud_text_append(out, "%d digit%s anything\n", digits, digits == 1 ? " means" : "s mean");
}

/* Whether no case has a bumper or a link: over case none all ratios would be 1. */
static bool is_bare(const struct thud_sweep_plan *plan)
{
    bool bare = true;
    for (int k = 0; k < plan->ncases; k++)
        bare = bare && (plan->cases[k] == THUD_CASE_NONE || !thud_scene_has_measure(&plan->scene));
    return bare;
}

static bool has_rows(const struct thud_sweep_table *table, int record, enum thud_case which)
{
    for (size_t i = 0; i < table->npoints; i++)
        if (table->point[i]->record == record && thud_sweep_summary_find(table->point[i], which) >= 0)
            return true;
    return false;
}

void thud_sweep_report(const struct thud_sweep_plan *plan, const struct thud_sweep_outcome *outcome,
                       struct thud_text *out)
{
    const struct thud_sweep_table *table = &outcome->rows.table;
    const bool bare = is_bare(plan);
    if (outcome->too_many)
        return;
    for (int r = 0; r < table->nrecords; r++) {
        thud_text_append(out, "%s\n", short_name(table->record[r]));
        put_need(plan, table, r, out);
        bool head = false;
        for (int k = 0; k < plan->ncases; k++) {
            enum thud_case which = plan->cases[k];
            if ((which == THUD_CASE_NONE && !bare) || !has_rows(table, r, which))
                continue;
            if (!head && bare && (table->measures & THUD_HAS_LINKS))
                thud_text_append(out, "  over %s\n", thud_case_free_words(table->measures, table->free_links));
            if (!head)
                thud_text_append(out, "  %-*s mean accel.     worst floor         mean drift        at\n",
                                 HEAD + thud_scene_names_width(&plan->scene, NAME),
                                 !bare                              ? "over case none"
                                 : table->measures & THUD_HAS_LINKS ? ""
                                                                    : "over no pounding");
            head = true;
            for (int s = 0; s < table->nstructures; s++)
                put_structure(plan, table, r, which, s, bare, out);
            put_spread(plan, table, r, which, out);
        }
        put_yielding(plan, table, r, out);
    }
}

/* Why a case of a point is not possible, in the scene's own words. */
static void put_reason(const struct thud_sweep_plan *plan, long point, int k, struct thud_text *out)
{
    struct thud_error why = {0};
    struct thud_scene *scene = malloc(2 * sizeof *scene);
    if (!scene)
        return;
    if (thud_sweep_scene(plan, point, scene, &why) == THUD_OK &&
        thud_scene_case(scene, plan->cases[k], scene + 1, &why) == THUD_OK)
        (void)thud_scene_check(scene + 1, &why);
    char text[1600];
    if (why.what[0])
        thud_text_append(out, "    %s\n", thud_error_text(&why, text, sizeof text));
    free(scene);
}

/* "1 run", "2 runs" */
static void put_runs(long n, struct thud_text *out)
{
    thud_text_append(out, "%ld run%s", n, n == 1 ? "" : "s");
}

static void put_missing(const struct thud_sweep_plan *plan, const char *one, const char *more, const char *what,
                        long count, long point, int k, bool reason, struct thud_text *out)
{
    int at[THUD_VARY_MAX];
    if (count == 0)
        return;
    put_runs(count, out);
    thud_text_append(out, " %s%s, first case %s", count == 1 ? one : more, what,
                     k < plan->ncases ? thud_case_name(plan->cases[k]) : "none");
    int record = thud_sweep_place(plan, point, at);
    for (int a = 0; a < plan->naxes; a++)
        thud_text_append(out, ", %s %s", plan->axis[a].key, plan->axis[a].text[at[a]]);
    if (record < plan->nrecords && plan->record[record])
        thud_text_append(out, ", %s", short_name(plan->record[record]->file));
    thud_text_append(out, "\n");
    if (reason && k < plan->ncases)
        put_reason(plan, point, k, out);
}

void thud_sweep_report_work(const struct thud_sweep_plan *plan, const struct thud_sweep_total *total,
                            struct thud_text *out)
{
    struct thud_text words = {0};
    put_runs(total->asked, &words);
    if (total->references > 0)
        thud_text_append(&words, " and %ld of case none for the ratios", total->references);
    thud_text_append(&words, ": %ld made, %ld answered by the motion without pounding", total->made, total->free);
    if (total->reused > 0)
        thud_text_append(&words, ", %ld the same as another (equal clearances and laws)", total->reused);
    thud_table_words(out, "", &words, 2);
    if (plan->scene.analysis.modes > 0)
        thud_text_append(out, "each building's lowest %d modes only: thud run gives the error of that\n",
                         plan->scene.analysis.modes);
    if (plan->sensitivity > 0) {
        thud_text_append(
            out, "spread under %g %% less or more gap, ground motion and stiffness, one at a time: %ld more runs\n",
            100 * plan->sensitivity, total->changed.made + total->changed.free);
        if (total->changed.failed > 0)
            thud_text_append(out, "%ld of them have no result: the spread is missing there\n", total->changed.failed);
    }
    if (total->shared_runs > 0) {
        put_runs(total->shared_runs, out);
        thud_text_append(out, " began where a contact could first be: %.0f of %.0f s were shared\n", total->shared_s,
                         total->end_s);
    }
    if (total->left_out > 0)
        thud_text_append(out, "%ld contacts that nothing can close were left out\n", total->left_out);
    put_missing(plan, "is", "are", " not possible", total->impossible, total->impossible_point, total->impossible_case,
                true, out);
    put_missing(plan, "has", "have", " no result (the integration failed)", total->diverged, total->diverged_point,
                total->diverged_case, false, out);
}

/* What stands behind a row of the best values: why it may be none. */
static const char *best_remark(const struct thud_sweep_best *best)
{
    return best->idle ? "is struck by nothing, or hardly" : best->at_end ? "at the end of its range" : "";
}

static const char *best_record(const struct thud_sweep_table *table, const struct thud_sweep_best *best)
{
    return best->record < 0 ? "worst of all" : short_name(table->record[best->record]);
}

static void put_best(const struct thud_sweep_plan *plan, const struct thud_sweep_table *table, int axis,
                     const struct thud_sweep_best *best, int width, int wide, struct thud_text *out)
{
    const struct thud_sweep_axis *along = &plan->axis[axis];
    char at[PLACE];
    const char *remark = best_remark(best);
    thud_text_append(out, "  ");
    thud_text_padded(out, best_record(table, best), width);
    thud_text_append(out, " %-8s ", thud_case_name(best->which));
    thud_text_padded(out, thud_sweep_setting(plan, plan->naxes, best->at, axis, false, at, PLACE), wide);
    thud_text_append(out, " %-10s %6.3f %6.3f %6.3f\n", best->idle ? "-" : along->text[best->at[axis]], best->ratio,
                     best->drift_ratio, best->worst_ratio);
    if (!best->idle)
        thud_text_append(out, "    flat from %s to %s%s%s\n", along->text[best->flat_least],
                         along->text[best->flat_most], *remark ? ", " : "", remark);
    else if (*remark)
        thud_text_append(out, "    %s\n", remark);
}

/* Columns of best.csv between those of its own: the other keys, and three values of the varied one, as a number or a
 * word, named with its unit. */
enum { BEST, FLAT_FROM, FLAT_TO, BEST_VALUES };
struct best_columns {
    bool other[THUD_VARY_MAX]; /* axes */
    struct thud_made_columns axes, made;
    struct thud_schema names, best, ratios, flat, last;
};

static void name_best(const struct thud_sweep_plan *plan, int axis, struct best_columns *out)
{
    static const char *const name[] = {"best", "flat_from", "flat_to"};
    const struct thud_column *own = thud_best_schema.column;
    const struct thud_sweep_axis *along = &plan->axis[axis];
    *out = (struct best_columns){.names = {"", "", own, 2},
                                 .best = {"", "", out->made.column, 1},
                                 .ratios = {"", "", own + 4, 2},
                                 .flat = {"", "", out->made.column + FLAT_FROM, 2},
                                 .last = {"", "", own + 8, 2}};
    for (int a = 0; a < plan->naxes; a++)
        out->other[a] = a != axis;
    thud_axis_columns(plan, out->other, &out->axes);
    for (int i = 0; i < BEST_VALUES; i++)
        thud_column_add(&out->made, along->words, "%s%s", name[i], along->words ? "" : thud_si_suffix(along->param));
}

/* A value of an axis: its number, or its word. */
static union thud_column_value value_on(const struct thud_sweep_axis *axis, int at)
{
    return axis->words ? (union thud_column_value){.text = axis->text[at]}
                       : (union thud_column_value){.number = axis->value[at]};
}

/* NULL: the names. */
static void put_best_csv(const struct thud_sweep_plan *plan, int axis, const struct thud_sweep_best *best,
                         struct thud_text *out)
{
    struct best_columns c;
    struct thud_best_row row = {0};
    name_best(plan, axis, &c);
    const struct thud_part part[] = {{&c.names, 0, &row},  {&c.axes.schema, 0, c.axes.cell}, {&c.best, 0, c.made.cell},
                                     {&c.ratios, 0, &row}, {&c.flat, 0, c.made.cell},        {&c.last, 0, &row}};
    enum { PARTS = sizeof part / sizeof *part };
    if (!best) {
        thud_parts_names(part, PARTS, out);
        return;
    }
    bool known = best->record >= 0 && best->record < plan->nrecords && plan->record[best->record];
    row = (struct thud_best_row){best->record < 0 ? "worst of all"
                                 : known          ? plan->record[best->record]->file
                                                  : "",
                                 thud_case_name(best->which),
                                 best->ratio,
                                 best->drift_ratio,
                                 best->worst_ratio,
                                 best->idle ? "is struck by nothing or hardly" : best_remark(best)};
    thud_axis_cells(plan, c.other, best->at, c.axes.cell);
    c.made.cell[BEST] = value_on(&plan->axis[axis], best->at[axis]);
    c.made.cell[FLAT_FROM] = value_on(&plan->axis[axis], best->flat_least);
    c.made.cell[FLAT_TO] = value_on(&plan->axis[axis], best->flat_most);
    thud_parts_csv(part, PARTS, out);
}

enum thud_status thud_sweep_report_best(const struct thud_sweep_plan *plan, const struct thud_sweep_table *table,
                                        int axis, bool csv, struct thud_text *out, struct thud_error *err)
{
    struct thud_sweep_best *best;
    enum { width = 20, wide = 16 };
    long n = thud_sweep_best(table, axis, &best);
    if (n < 0)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    if (csv) {
        put_best_csv(plan, axis, NULL, out);
    } else {
        struct thud_text words = {0};
        thud_text_append(&words, "best %s (least of the larger mean acceleration ratio; flat: within %d %% of it)",
                         plan->axis[axis].key, THUD_SWEEP_BEST_PER_CENT);
        thud_table_words(out, "\n", &words, 2);
        thud_text_append(out, "  %-*s %-8s %-*s %-10s %6s %6s %6s\n", width, "record", "case", wide, "at", "best",
                         "ratio", "drift", "worst");
    }
    for (long i = 0; i < n; i++) {
        if (csv)
            put_best_csv(plan, axis, &best[i], out);
        else
            put_best(plan, table, axis, &best[i], width, wide, out);
    }
    free(best);
    return THUD_OK;
}
