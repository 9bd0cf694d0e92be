/* Fractiles of every measure over the ground motions of a study, as table, CSV and JSON. */
#include "app/sweep/fragility_report.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/result/sweep_csv.h"

bool thud_is_spread(int n, int i)
{
    enum { MOST = 5 };
    bool shown = n <= MOST;
    for (int j = 0; j < MOST && !shown; j++)
        shown = i == (j * (n - 1) + (MOST - 1) / 2) / (MOST - 1);
    return shown;
}

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

static void suite_column(int column, char name[48])
{
    static const char *const counts[] = {"motions", "pounding", "amplified"}, *const end[] = {"p16", "median", "p84"};
    if (column < 3)
        snprintf(name, 48, "%s", counts[column]);
    else
        snprintf(name, 48, "%s_%s", thud_suite_column((enum thud_suite_measure)(SUITE_FIRST + column / 3 - 1)),
                 end[column % 3]);
}

/* A row of statistics: case, varied keys, structure, and what there is of the measures. */
struct suite_columns {
    struct thud_axis_columns axes;
    struct thud_schema which, structure, values;
    struct thud_column column[SUITE_COLUMNS];
    char name[SUITE_COLUMNS][48];
};
static const struct thud_column text_column[] = {{.name = "case", .kind = THUD_COLUMN_TEXT},
                                                 {.name = "structure", .kind = THUD_COLUMN_TEXT}};

static void name_suite(const struct thud_suite *suite, struct suite_columns *out)
{
    *out = (struct suite_columns){.which = {"", "", text_column, 1},
                                  .structure = {"", "", text_column + 1, 1},
                                  .values = {"", "", out->column, 0}};
    thud_axis_columns_make(suite->plan, NULL, &out->axes);
    for (int c = 0; c < SUITE_COLUMNS; c++) {
        if (!has_column(suite, c))
            continue;
        suite_column(c, out->name[c]);
        out->column[out->values.n++] = (struct thud_column){.name = out->name[c], .at = (size_t)c * sizeof(double)};
    }
}

static void put_suite_data(const struct thud_suite *suite, const int *at, int k, int s,
                           const double value[SUITE_COLUMNS], bool json, struct thud_text *out)
{
    const char *which = k < 0 ? NULL : thud_case_name(suite->plan->cases[k]);
    const char *structure = k < 0 ? NULL : suite->plan->scene.structure[s].name;
    struct suite_columns columns;
    name_suite(suite, &columns);
    const struct thud_part part[] = {{&columns.which, 0, &which},
                                     {&columns.axes.schema, 0, columns.axes.value},
                                     {&columns.structure, 0, &structure},
                                     {&columns.values, 0, value}};
    if (k < 0) {
        thud_parts_names(part, 4, out);
        return;
    }
    thud_axis_columns_put(suite->plan, NULL, at, &columns.axes);
    if (!json) {
        thud_parts_csv(part, 4, out);
        return;
    }
    thud_text_append(out, "%s{", out->size > 0 ? ",\n  " : "");
    thud_parts_json(part, 4, out);
    thud_text_append(out, "}");
}

static void put_suite_csv_row(const struct thud_suite *suite, const int *at, int k, int s,
                              const double value[SUITE_COLUMNS], struct thud_text *out)
{
    put_suite_data(suite, at, k, s, value, false, out);
}

static void put_suite_json_row(const struct thud_suite *suite, const int *at, int k, int s,
                               const double value[SUITE_COLUMNS], struct thud_text *out)
{
    put_suite_data(suite, at, k, s, value, true, out);
}

/* At most five settings, evenly spread, are shown of a key. */
static bool is_shown_setting(const struct thud_sweep_plan *plan, const int *at)
{
    for (int a = 0; a < plan->naxes; a++)
        if (!thud_is_spread(plan->axis[a].n, at[a]))
            return false;
    return true;
}

static void put_suite_table_row(const struct thud_suite *suite, const int *at, int k, int s,
                                const double value[SUITE_COLUMNS], struct thud_text *out)
{
    const struct thud_sweep_plan *plan = suite->plan;
    const double *ratio = value + 3 + 3 * (THUD_SUITE_ACCELERATION_RATIO - SUITE_FIRST);
    const double *force = value + 3 + 3 * (THUD_SUITE_FORCE - SUITE_FIRST);
    char name[160];
    size_t used = 0;
    if (!is_shown_setting(plan, at))
        return;
    snprintf(name, sizeof name, "%s", plan->naxes > 0 ? "" : "nominal");
    for (int a = 0; a < plan->naxes && used < sizeof name; a++)
        used += (size_t)snprintf(name + used, sizeof name - used, "%s%s", a ? ", " : "", plan->axis[a].text[at[a]]);
    thud_text_append(out, "  %-8s %-8.8s %4.0f %4.0f", thud_case_name(plan->cases[k]), plan->scene.structure[s].name,
                     value[1], value[2]);
    for (int q = 0; q < 3; q++)
        thud_text_append(out, isnan(ratio[q]) ? "      -" : " %6.3f", ratio[q]);
    for (int q = 1; q < 3; q++)
        thud_text_append(out, isnan(force[q]) ? "       -" : " %7.3g", 1e-6 * force[q]);
    thud_text_append(out, "  %-.17s\n", name);
}

typedef void put_suite_row(const struct thud_suite *suite, const int *at, int k, int s,
                           const double value[SUITE_COLUMNS], struct thud_text *out);

static enum thud_status put_suite(const struct thud_suite *suite, put_suite_row *put, struct thud_text *out,
                                  struct thud_error *err)
{
    const struct thud_sweep_plan *plan = suite->plan;
    double value[SUITE_COLUMNS], *room = malloc(((size_t)suite->nrecords + 1) * sizeof *room);
    int at[THUD_VARY_MAX];
    if (!room)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    for (long i = 0; i < suite->settings; i++) {
        thud_suite_place(plan, i, at);
        for (int k = 0; k < plan->ncases; k++)
            for (int s = 0; s < suite->nstructures; s++) {
                if (plan->scene.structure[s].kind == THUD_WALL)
                    continue;
                suite_values(suite, i, k, s, room, value);
                put(suite, at, k, s, value, out);
            }
    }
    free(room);
    return THUD_OK;
}

enum thud_status thud_suite_csv(const struct thud_suite *suite, struct thud_text *out, struct thud_error *err)
{
    put_suite_data(suite, NULL, -1, 0, NULL, false, out);
    return put_suite(suite, put_suite_csv_row, out, err);
}

enum thud_status thud_suite_json(const struct thud_suite *suite, struct thud_text *out, struct thud_error *err)
{
    struct thud_text rows = {0};
    enum thud_status status = put_suite(suite, put_suite_json_row, &rows, err);
    thud_text_append(out, "[\n  ");
    if (rows.data)
        thud_text_bytes(out, rows.data, rows.size);
    thud_text_append(out, "\n]");
    out->failed |= rows.failed;
    thud_text_clear(&rows);
    return status;
}

enum thud_status thud_suite_table(const struct thud_suite *suite, struct thud_text *out, struct thud_error *err)
{
    thud_text_append(out, "over %d ground motions: how many pound, and under how many accelerations grow\n",
                     suite->nrecords);
    thud_text_append(out, "                              mean acc. ratio      force (MN)\n"
                          "  case     of      pound grow   16 %% median   84 %%  median    84 %%  at\n");
    return put_suite(suite, put_suite_table_row, out, err);
}
