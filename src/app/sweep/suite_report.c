/* Fractiles of every measure over the ground motions of a study, as table, CSV and JSON. */
#include "app/sweep/fragility_report.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/run/result_table.h"
#include "io/result/sweep_csv.h"

enum {
    MOTIONS,
    POUNDING,
    AMPLIFIED,
    COUNTS,
    FRACTILES = 3,
    ENDS = 6
}; /* of a row: these, then 16 %, median and 84 % of each measure, of a ratio also under how many it is less, 1, more */
struct suite_row {
    double count[COUNTS], of[THUD_MEASURES][ENDS];
    double collapsed; /* 1: a run of theirs did */
    int n;
    enum thud_measure told[THUD_MEASURES]; /* (n) */
};

static int ends_of(enum thud_measure measure)
{
    return thud_measure_info(measure)->ratio_of ? ENDS : FRACTILES;
}

/* One setting, case and structure: how many motions, how many of them pound and are amplified, fractiles of every
 * measure. */
static void suite_values(const struct thud_suite *suite, long setting, int k, int s, double *room,
                         struct suite_row *row)
{
    struct thud_fractiles f = thud_suite_fractiles(suite, setting, k, THUD_MEASURE_IMPACTS, -1, 0, room);
    row->count[MOTIONS] = (double)f.n;
    row->count[POUNDING] = (double)f.above;
    row->count[AMPLIFIED] =
        (double)thud_suite_fractiles(suite, setting, k, THUD_MEASURE_ACCELERATION_RATIO, s, 1, room).above;
    row->collapsed = thud_suite_fractiles(suite, setting, k, THUD_MEASURE_COLLAPSED, -1, 0, room).share > 0;
    for (int i = 0; i < row->n; i++) {
        f = thud_suite_fractiles(suite, setting, k, row->told[i], s, 1, room);
        const double of[ENDS] = {f.p16,          f.median, f.p84, (double)f.below, (double)(f.n - f.below - f.above),
                                 (double)f.above};
        memcpy(row->of[row->told[i]], of, sizeof of);
    }
}

/* A row of statistics: case, varied keys, structure, and what there is of the measures. */
static void name_suite(const struct thud_suite *suite, const struct suite_row *row, struct thud_made_columns *out)
{
    static const char *const counts[] = {"motions", "pounding", "amplified"}, *const end[] = {"p16",   "median",
                                                                                              "p84",   "lower",
                                                                                              "equal", "higher"};
    thud_column_add(out, true, "case");
    thud_axis_columns(suite->plan, NULL, out);
    thud_column_add(out, true, "structure");
    for (int c = 0; c < COUNTS; c++)
        thud_column_add(out, false, "%s", counts[c]);
    for (int i = 0; i < row->n; i++)
        for (int c = 0; c < ends_of(row->told[i]); c++)
            thud_column_add(out, false, "%s_%s", thud_measure_info(row->told[i])->column, end[c]);
    thud_column_add(out, false, "%s", thud_measure_info(THUD_MEASURE_COLLAPSED)->column);
}

static void put_data_row(const struct thud_suite *suite, const int *at, int k, int s, const struct suite_row *row,
                         struct thud_made_columns *columns)
{
    union thud_column_value *cell = columns->cell;
    cell++->text = thud_case_name(suite->plan->cases[k]);
    thud_axis_cells(suite->plan, NULL, at, cell);
    cell += suite->plan->naxes;
    cell++->text = suite->plan->scene.structure[s].name;
    for (int c = 0; c < COUNTS; c++)
        cell++->number = row->count[c];
    for (int i = 0; i < row->n; i++)
        for (int c = 0; c < ends_of(row->told[i]); c++)
            cell++->number = row->of[row->told[i]][c];
    cell->number = row->collapsed;
}

enum { NAME = 8 }; /* columns of a structure's name, at least */

static void put_table_row(const struct thud_suite *suite, const int *at, int k, int s, const struct suite_row *row,
                          struct thud_text *out)
{
    const struct thud_sweep_plan *plan = suite->plan;
    const double *ratio = row->of[THUD_MEASURE_ACCELERATION_RATIO];
    const double *const force[] = {row->of[THUD_MEASURE_FORCE], row->of[THUD_MEASURE_LINK]};
    char name[160];
    if (!thud_sweep_is_spread(plan, at, -1))
        return;
    thud_text_append(out, "  %-8s ", thud_case_name(plan->cases[k]));
    thud_text_padded(out, plan->scene.structure[s].name, thud_scene_names_width(&plan->scene, NAME));
    if (row->count[MOTIONS] > 0)
        thud_text_append(out, " %4.0f %4.0f", row->count[POUNDING], row->count[AMPLIFIED]);
    else /* there the scene is not possible */
        thud_text_append(out, " %4s %4s", "-", "-");
    for (int q = 0; q < FRACTILES; q++)
        thud_text_append(out, isnan(ratio[q]) ? "      -" : " %6.3f", ratio[q]);
    for (int f = 0; f < (suite->features & THUD_HAS_LINK_FORCES ? 2 : 1); f++)
        for (int q = 1; q < FRACTILES; q++)
            thud_text_append(out, isnan(force[f][q]) ? "      -" : " %6.3g", 1e-6 * force[f][q]);
    thud_sweep_setting(plan, plan->naxes, at, -1, false, name, sizeof name);
    thud_table_whole(out, name, 11);
    thud_text_append(out, "\n");
}

enum thud_status thud_suite_report(const struct thud_suite *suite, enum thud_written as, struct thud_text *out,
                                   struct thud_error *err)
{
    const int width = thud_scene_names_width(&suite->plan->scene, NAME);
    const bool links = suite->features & THUD_HAS_LINK_FORCES;
    const struct thud_sweep_plan *plan = suite->plan;
    double *room = malloc(((size_t)suite->nrecords + 1) * sizeof *room);
    const char *before = "";
    int at[THUD_VARY_MAX];
    struct thud_made_columns columns = {0};
    struct suite_row row = {.n = 0};
    if (!room)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    row.n = thud_measures_told(THUD_TOLD_BY_SUITE, suite->features, row.told);
    name_suite(suite, &row, &columns);
    const struct thud_part part = {&columns.schema, 0, columns.cell};
    if (as == THUD_AS_CSV)
        thud_parts_names(&part, 1, out);
    else if (as == THUD_AS_JSON)
        thud_text_append(out, "[\n  ");
    else
        thud_text_append(out,
                         "over %d ground motions: how many pound, and under how many accelerations grow\n"
                         "%*s            mean acc. ratio (geometric) force (MN)%s\n"
                         "  case     %-*spound grow   16 %% median   84 %% median   84 %%%s\n",
                         suite->nrecords, 1 + width, "", links ? "    of a link" : "", width, "of",
                         links ? " median   84 %" : " at");
    for (long i = 0; i < suite->settings; i++) {
        thud_sweep_place(plan, i, at);
        for (int k = 0; k < plan->ncases; k++)
            for (int s = 0; s < suite->nstructures; s++) {
                if (plan->scene.structure[s].kind == THUD_WALL)
                    continue;
                suite_values(suite, i, k, s, room, &row);
                put_data_row(suite, at, k, s, &row, &columns);
                if (as == THUD_AS_TEXT)
                    put_table_row(suite, at, k, s, &row, out);
                else if (as == THUD_AS_CSV)
                    thud_parts_csv(&part, 1, out);
                else {
                    thud_text_append(out, "%s{", before);
                    thud_parts_json(&part, 1, out);
                    thud_text_append(out, "}");
                    before = ",\n  ";
                }
            }
    }
    thud_text_append(out, as == THUD_AS_JSON ? "\n]" : "");
    free(room);
    return THUD_OK;
}
