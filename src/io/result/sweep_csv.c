#include "io/result/sweep_csv.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "io/record/csv_lines.h"
#include "study/scene/level.h"

const char *thud_sweep_csv_name(enum thud_sweep_csv which)
{
    static const char *const name[] = {"sweep.csv", "contacts.csv", "needed-gaps.csv"};
    return name[which];
}

/* Suffix of a column by what it holds. */
static const char *suffix(const struct thud_param *param)
{
    static const char *const by_dimension[THUD_DIMENSIONS] = {
        [THUD_LENGTH] = "_m", [THUD_AREA] = "_m2",       [THUD_MASS] = "_kg",
        [THUD_FORCE] = "_n",  [THUD_STIFFNESS] = "_npm", [THUD_PRESSURE] = "_pa",
        [THUD_TIME] = "_s",   [THUD_VELOCITY] = "_mps",  [THUD_ACCELERATION] = "_mps2"};
    const char *s = param->kind == THUD_PARAM_QUANTITY ? by_dimension[param->dimension] : NULL;
    return s ? s : "";
}

static bool is_gap(const char *key)
{
    return strcmp(key, "gap") == 0 || strcmp(key, "interfaces.1.gap") == 0;
}

/* Varied keys that no other column shows. `outer`: only those that change the motion without pounding. */
static bool shown(const struct thud_sweep_plan *plan, int axis, bool outer)
{
    return outer ? axis < plan->nouter : !is_gap(plan->axis[axis].key);
}

static void put_number(struct thud_text *out, double value)
{
    thud_text_bytes(out, ",", 1);
    if (!isnan(value))
        thud_text_number(out, value);
}

static void put_numbers(struct thud_text *out, const double *value, size_t n)
{
    for (size_t i = 0; i < n; i++)
        put_number(out, value[i]);
}

static void put_axes(const struct thud_sweep_plan *plan, long point, bool outer, struct thud_text *out)
{
    int at[THUD_VARY_MAX];
    thud_sweep_place(plan, point, at);
    for (int i = 0; i < plan->naxes; i++) {
        const struct thud_sweep_axis *axis = &plan->axis[i];
        if (!shown(plan, i, outer))
            continue;
        if (!axis->words) {
            put_number(out, axis->value[at[i]]);
        } else {
            thud_text_append(out, ",");
            thud_text_csv(out, axis->text[at[i]]);
        }
    }
}

static void put_record(const struct thud_sweep_plan *plan, int record, struct thud_text *out)
{
    if (record < plan->nrecords && plan->record[record])
        thud_text_csv(out, plan->record[record]->file);
}

/* Name and unit of every measure. */
static const char *const measures[THUD_SWEEP_MEASURES][2] = {
    [THUD_SWEEP_ACCELERATION] = {"acceleration", "_mps2"},
    [THUD_SWEEP_DRIFT] = {"drift", "_m"},
    [THUD_SWEEP_DISPLACEMENT] = {"displacement", "_m"},
    [THUD_SWEEP_ACCELERATION_RATIO] = {"acceleration_ratio", ""},
    [THUD_SWEEP_DRIFT_RATIO] = {"drift_ratio", ""},
    [THUD_SWEEP_DISPLACEMENT_RATIO] = {"displacement_ratio", ""},
    [THUD_SWEEP_ACCELERATION_FREE_RATIO] = {"acceleration_free_ratio", ""},
    [THUD_SWEEP_DRIFT_FREE_RATIO] = {"drift_free_ratio", ""},
    [THUD_SWEEP_DISPLACEMENT_FREE_RATIO] = {"displacement_free_ratio", ""},
    [THUD_SWEEP_DUCTILITY] = {"ductility", ""},
    [THUD_SWEEP_PERMANENT] = {"permanent", "_m"},
    [THUD_SWEEP_EXCURSIONS] = {"excursions", ""},
    [THUD_SWEEP_HYSTERETIC] = {"hysteretic", "_j"},
};
/* From here on they are of storeys that yield, and stand at the end of a line where there are any. */
enum { YIELDING = THUD_SWEEP_DUCTILITY };

static void put_ends_header(int from, int to, struct thud_text *out)
{
    for (int q = from; q < to; q++)
        thud_text_append(out, ",%s_low%s,%s_high%s", measures[q][0], measures[q][1], measures[q][0], measures[q][1]);
}

static void put_ends(const struct thud_sweep_row *row, int from, int to, struct thud_text *out)
{
    for (int q = from; q < to; q++)
        put_numbers(out, (const double[]){row->low[q], row->high[q]}, 2);
}

void thud_sweep_csv_header(const struct thud_sweep_plan *plan, enum thud_sweep_csv which, struct thud_text *out)
{
    static const char *const columns[] = {
        "record,case,gap_m,structure,floor,acceleration_mps2,drift_m,displacement_m,acceleration_ratio,drift_ratio,"
        "displacement_ratio,acceleration_free_ratio,drift_free_ratio,displacement_free_ratio",
        "record,case,gap_m,interface,left_floor,right_floor,impacts,force_n,indentation_m,impulse_ns,contact_time_s,"
        "residual_m,residual_gap_m,struck_columns,shear_lower_n,shear_upper_n,shear_over_capacity",
        "record,interface,left_floor,right_floor,left_displacement_m,right_displacement_m,closing_m,abs_m,srss_m,ddc_m,"
        "correlation,en1998_m,asce7_m,struck_columns"};
    thud_text_append(out, "%s", columns[which]);
    if (plan->sensitivity > 0 && which == THUD_SWEEP_CSV_FLOORS)
        put_ends_header(0, YIELDING, out);
    if (plan->sensitivity > 0 && which == THUD_SWEEP_CSV_CONTACTS)
        thud_text_append(out, ",force_low_n,force_high_n,indentation_low_m,indentation_high_m");
    for (int i = 0; i < plan->naxes; i++)
        if (shown(plan, i, which == THUD_SWEEP_CSV_NEEDS))
            thud_text_append(out, ",%s%s", plan->axis[i].key, suffix(plan->axis[i].param));
    if (which == THUD_SWEEP_CSV_FLOORS && thud_sweep_yields(plan)) {
        for (int q = YIELDING; q < THUD_SWEEP_MEASURES; q++)
            thud_text_append(out, ",%s%s", measures[q][0], measures[q][1]);
        if (plan->sensitivity > 0)
            put_ends_header(YIELDING, THUD_SWEEP_MEASURES, out);
    }
    if (which == THUD_SWEEP_CSV_CONTACTS)
        thud_text_append(out, ",moment_lower_nm,moment_upper_nm");
    thud_text_append(out, "\n");
}

static void put_floor(const struct thud_sweep_plan *plan, long point, const struct thud_sweep_row *row,
                      struct thud_text *out)
{
    put_record(plan, row->record, out);
    thud_text_append(out, ",%s", thud_case_name(row->which));
    put_number(out, row->gap_m);
    thud_text_append(out, ",");
    thud_text_csv(out, plan->scene.structure[row->structure].name);
    thud_text_append(out, ",%d", row->floor);
    const double x[] = {row->acceleration_mps2,       row->drift_m,          row->displacement_m,
                        row->acceleration_ratio,      row->drift_ratio,      row->displacement_ratio,
                        row->acceleration_free_ratio, row->drift_free_ratio, row->displacement_free_ratio};
    put_numbers(out, x, sizeof x / sizeof *x);
    if (plan->sensitivity > 0)
        put_ends(row, 0, YIELDING, out);
    put_axes(plan, point, false, out);
    if (thud_sweep_yields(plan)) {
        const double y[] = {row->ductility, row->permanent_m, row->excursions, row->hysteretic_j};
        put_numbers(out, y, sizeof y / sizeof *y);
        if (plan->sensitivity > 0)
            put_ends(row, YIELDING, THUD_SWEEP_MEASURES, out);
    }
    thud_text_append(out, "\n");
}

static void put_contact(const struct thud_sweep_plan *plan, long point, const struct thud_sweep_contact_row *row,
                        struct thud_text *out)
{
    put_record(plan, row->record, out);
    thud_text_append(out, ",%s", thud_case_name(row->which));
    put_number(out, row->gap_m);
    thud_text_append(out, ",%d,%d,%d,%d", row->interface, row->left_floor, row->right_floor, row->impacts);
    const double x[] = {row->force_n,        row->indentation_m, row->impulse_ns,
                        row->contact_time_s, row->residual_m,    row->residual_gap_m};
    const double spread[] = {row->force_low_n, row->force_high_n, row->indentation_low_m, row->indentation_high_m};
    const double columns[] = {row->shear_lower_n, row->shear_upper_n, row->capacity_ratio};
    put_numbers(out, x, sizeof x / sizeof *x);
    thud_text_append(out, ",%s", thud_struck_name(row->struck));
    put_numbers(out, columns, sizeof columns / sizeof *columns);
    if (plan->sensitivity > 0)
        put_numbers(out, spread, sizeof spread / sizeof *spread);
    put_axes(plan, point, false, out);
    put_numbers(out, (const double[]){row->moment_lower_nm, row->moment_upper_nm}, 2);
    thud_text_append(out, "\n");
}

static void put_need(const struct thud_sweep_plan *plan, long point, const struct thud_sweep_need_row *row,
                     struct thud_text *out)
{
    put_record(plan, row->record, out);
    thud_text_append(out, ",%d,%d,%d", row->interface, row->left_floor, row->right_floor);
    const double x[] = {row->left_m, row->right_m,     row->closing_m, row->abs_m,  row->srss_m,
                        row->ddc_m,  row->correlation, row->en1998_m,  row->asce7_m};
    put_numbers(out, x, sizeof x / sizeof *x);
    thud_text_append(out, ",%s", thud_struck_name(row->struck));
    put_axes(plan, point, true, out);
    thud_text_append(out, "\n");
}

enum thud_status thud_sweep_csv_rows(const struct thud_sweep_plan *plan, enum thud_sweep_csv which,
                                     const struct thud_sweep_point *point, struct thud_text *out,
                                     struct thud_error *err)
{
    size_t count;
    void *rows;
    if (which == THUD_SWEEP_CSV_FLOORS) {
        count = (size_t)thud_sweep_rows(plan, point, NULL);
        struct thud_sweep_row *row = rows = malloc((count + 1) * sizeof *row);
        if (row)
            thud_sweep_rows(plan, point, row);
        for (size_t i = 0; row && i < count; i++)
            put_floor(plan, point->index, &row[i], out);
    } else if (which == THUD_SWEEP_CSV_CONTACTS) {
        count = (size_t)thud_sweep_contact_rows(plan, point, NULL);
        struct thud_sweep_contact_row *row = rows = malloc((count + 1) * sizeof *row);
        if (row)
            thud_sweep_contact_rows(plan, point, row);
        for (size_t i = 0; row && i < count; i++)
            put_contact(plan, point->index, &row[i], out);
    } else {
        count = (size_t)thud_sweep_need_rows(plan, point, NULL);
        struct thud_sweep_need_row *row = rows = malloc((count + 1) * sizeof *row);
        if (row)
            thud_sweep_need_rows(plan, point, row);
        for (size_t i = 0; row && i < count; i++)
            put_need(plan, point->index, &row[i], out);
    }
    if (!rows)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    free(rows);
    return THUD_OK;
}
