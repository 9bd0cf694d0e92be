/* Fractiles of every measure over the ground motions of a study, as table, CSV and JSON. */
#include "app/sweep/fragility_report.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/result/sweep_csv.h"

enum { SUITE_FIRST = THUD_SUITE_FORCE, SUITE_COLUMNS = 3 + 3 * (THUD_SUITE_MEASURES - SUITE_FIRST) };

/* Of storeys that yield and of columns only where there are any. */
static bool has_column(const struct thud_suite *suite, int column)
{
    return column < 3 || thud_suite_has(suite, (enum thud_suite_measure)(SUITE_FIRST + column / 3 - 1));
}

/* One setting, case and structure: how many motions, how many of them pound and are amplified, fractiles of every
 * measure. */
static void suite_values(const struct thud_suite *suite, long setting, int k, int s, double *room,
                         double value[SUITE_COLUMNS])
{
    struct thud_fractiles f = thud_suite_fractiles(suite, setting, k, THUD_SUITE_IMPACTS, -1, 0, room);
    value[0] = (double)f.n;
    value[1] = f.n ? round(f.share * (double)f.n) : 0;
    f = thud_suite_fractiles(suite, setting, k, THUD_SUITE_ACCELERATION_RATIO, s, 1 + 1e-9, room);
    value[2] = f.n ? round(f.share * (double)f.n) : 0;
    for (int m = SUITE_FIRST; m < THUD_SUITE_MEASURES; m++) {
        double *to = value + 3 + 3 * (m - SUITE_FIRST);
        f = thud_suite_fractiles(suite, setting, k, (enum thud_suite_measure)m, s, 0, room);
        to[0] = f.p16;
        to[1] = f.median;
        to[2] = f.p84;
    }
}

/* A row of statistics: case, varied keys, structure, and what there is of the measures. */
static void name_suite(const struct thud_suite *suite, struct thud_made_columns *out)
{
    static const char *const counts[] = {"motions", "pounding", "amplified"}, *const end[] = {"p16", "median", "p84"};
    thud_column_add(out, true, "case");
    thud_axis_columns(suite->plan, NULL, out);
    thud_column_add(out, true, "structure");
    for (int c = 0; c < SUITE_COLUMNS; c++)
        if (c < 3)
            thud_column_add(out, false, "%s", counts[c]);
        else if (has_column(suite, c))
            thud_column_add(out, false, "%s_%s", thud_suite_column((enum thud_suite_measure)(SUITE_FIRST + c / 3 - 1)),
                            end[c % 3]);
}

static void put_data_row(const struct thud_suite *suite, const int *at, int k, int s, const double value[SUITE_COLUMNS],
                         struct thud_made_columns *columns)
{
    union thud_column_value *cell = columns->cell;
    cell++->text = thud_case_name(suite->plan->cases[k]);
    thud_axis_cells(suite->plan, NULL, at, cell);
    cell += suite->plan->naxes;
    cell++->text = suite->plan->scene.structure[s].name;
    for (int c = 0; c < SUITE_COLUMNS; c++)
        if (has_column(suite, c))
            cell++->number = value[c];
}

static void put_table_row(const struct thud_suite *suite, const int *at, int k, int s,
                          const double value[SUITE_COLUMNS], struct thud_text *out)
{
    const struct thud_sweep_plan *plan = suite->plan;
    const double *ratio = value + 3 + 3 * (THUD_SUITE_ACCELERATION_RATIO - SUITE_FIRST);
    const double *force = value + 3 + 3 * (THUD_SUITE_FORCE - SUITE_FIRST);
    char name[160];
    if (!thud_sweep_is_spread(plan, at, -1))
        return;
    thud_text_append(out, "  %-8s %-8.8s %4.0f %4.0f", thud_case_name(plan->cases[k]), plan->scene.structure[s].name,
                     value[1], value[2]);
    for (int q = 0; q < 3; q++)
        thud_text_append(out, isnan(ratio[q]) ? "      -" : " %6.3f", ratio[q]);
    for (int q = 1; q < 3; q++)
        thud_text_append(out, isnan(force[q]) ? "       -" : " %7.3g", 1e-6 * force[q]);
    thud_text_append(out, "  %-.17s\n", thud_sweep_setting(plan, plan->naxes, at, -1, false, name, sizeof name));
}

enum thud_status thud_suite_report(const struct thud_suite *suite, enum thud_written as, struct thud_text *out,
                                   struct thud_error *err)
{
    const struct thud_sweep_plan *plan = suite->plan;
    double value[SUITE_COLUMNS], *room = malloc(((size_t)suite->nrecords + 1) * sizeof *room);
    const char *before = "";
    int at[THUD_VARY_MAX];
    struct thud_made_columns columns = {0};
    if (!room)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    name_suite(suite, &columns);
    const struct thud_part part = {&columns.schema, 0, columns.cell};
    if (as == THUD_AS_CSV)
        thud_parts_names(&part, 1, out);
    else if (as == THUD_AS_JSON)
        thud_text_append(out, "[\n  ");
    else
        thud_text_append(out,
                         "over %d ground motions: how many pound, and under how many accelerations grow\n"
                         "                              mean acc. ratio      force (MN)\n"
                         "  case     of      pound grow   16 %% median   84 %%  median    84 %%  at\n",
                         suite->nrecords);
    for (long i = 0; i < suite->settings; i++) {
        thud_sweep_place(plan, i, at);
        for (int k = 0; k < plan->ncases; k++)
            for (int s = 0; s < suite->nstructures; s++) {
                if (plan->scene.structure[s].kind == THUD_WALL)
                    continue;
                suite_values(suite, i, k, s, room, value);
                put_data_row(suite, at, k, s, value, &columns);
                if (as == THUD_AS_TEXT)
                    put_table_row(suite, at, k, s, value, out);
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
