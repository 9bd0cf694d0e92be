#include "io/result/sweep_csv.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "study/scene/level.h"
#include "study/sweep/measure.h"

/* ---- varied keys ---- */

static bool is_gap(const char *key)
{
    return strcmp(key, "gap") == 0 || strcmp(key, "interfaces.1.gap") == 0;
}

void thud_axis_columns(const struct thud_sweep_plan *plan, const bool *shown, struct thud_made_columns *out)
{
    for (int a = 0; a < plan->naxes; a++) {
        const struct thud_sweep_axis *axis = &plan->axis[a];
        if (!shown || shown[a])
            thud_column_add(out, axis->words, "%s%s", axis->key, axis->words ? "" : thud_si_suffix(axis->param));
    }
}

void thud_axis_cells(const struct thud_sweep_plan *plan, const bool *shown, const int *at,
                     union thud_column_value *cell)
{
    for (int a = 0; a < plan->naxes; a++) {
        const struct thud_sweep_axis *axis = &plan->axis[a];
        if (shown && !shown[a])
            continue;
        if (axis->words)
            cell++->text = axis->text[at[a]];
        else
            cell++->number = axis->value[at[a]];
    }
}

/* ---- floors ---- */

struct floor_row {
    const char *record, *which, *structure;
    struct thud_sweep_row own;
};
enum { SPREAD = 1 };

#define FLOOR(member, key, text) THUD_FIELD(struct floor_row, member, key, text)
#define OF(measure, key, text)   FLOOR(own.of[THUD_MEASURE_##measure], key, text)
#define ENDS(measure, key, unit, of)                                                                                   \
    THUD_FIELD_WITH(struct floor_row, own.low[THUD_MEASURE_##measure], key "_low" unit,                                \
                    "Smallest value within the spread of --sensitivity" of ".", .only = SPREAD),                       \
        THUD_FIELD_WITH(struct floor_row, own.high[THUD_MEASURE_##measure], key "_high" unit,                          \
                        "Largest value within the spread of --sensitivity" of ".", .only = SPREAD)

static const struct thud_column floors[] = {
    FLOOR(record, "record", "Ground motion, as specified; empty for none."),
    FLOOR(which, "case", "Case: none, bumper, cavity or as-written."),
    FLOOR(own.gap_m, "gap_m", "Gap of the first interface, m."),
    FLOOR(structure, "structure", "Name of the structure."),
    FLOOR(own.floor, "floor",
          "Floor from 1; 0 for the mean over the floors, of drifts over the storeys (isolators are none)."),
    OF(ACCELERATION, "acceleration_mps2",
       "Peak total acceleration, m/s2; empty on a floor struck by impulses, as is the mean over its structure."),
    OF(DRIFT, "drift_m",
       "Peak drift, m; of floor 1 of an isolated building that of its isolators, of a wall its displacement. "
       "Means over walls and rigid bodies are empty."),
    OF(DISPLACEMENT, "displacement_m", "Peak displacement relative to the ground, m."),
    OF(ACCELERATION_RATIO, "acceleration_ratio", "Acceleration over that of case none at the same values."),
    OF(DRIFT_RATIO, "drift_ratio", "Drift over that of case none at the same values; empty where the drift is."),
    OF(DISPLACEMENT_RATIO, "displacement_ratio", "Displacement over that of case none at the same values."),
    OF(ACCELERATION_FREE_RATIO, "acceleration_free_ratio",
       "Acceleration over that without pounding; there links act if all cases of the study have them."),
    OF(DRIFT_FREE_RATIO, "drift_free_ratio", "Drift over that without pounding; empty where the drift is."),
    OF(DISPLACEMENT_FREE_RATIO, "displacement_free_ratio", "Displacement over that without pounding."),
    ENDS(ACCELERATION, "acceleration", "_mps2", ", m/s2"),
    ENDS(DRIFT, "drift", "_m", ", m; may be empty"),
    ENDS(DISPLACEMENT, "displacement", "_m", ", m"),
    ENDS(ACCELERATION_RATIO, "acceleration_ratio", "", ""),
    ENDS(DRIFT_RATIO, "drift_ratio", "", "; may be empty"),
    ENDS(DISPLACEMENT_RATIO, "displacement_ratio", "", ""),
    ENDS(ACCELERATION_FREE_RATIO, "acceleration_free_ratio", "", ""),
    ENDS(DRIFT_FREE_RATIO, "drift_free_ratio", "", "; may be empty"),
    ENDS(DISPLACEMENT_FREE_RATIO, "displacement_free_ratio", "", ""),
    THUD_STANDS_FOR("KEY",
                    "Value of a varied key except the gap, with its unit as in bumper.thickness_m, in SI units.")};
const struct thud_schema thud_sweep_floor_schema = THUD_SCHEMA(
    "sweep.csv",
    "Written by\n.Cm sweep ,\nalso to standard output with\n.Fl -csv\nor, as objects,\n.Fl -json :\n"
    "a row for each run and floor; where storeys or isolators of the scene\nyield, with\n.Sx sweep.csv of storeys .\n",
    floors);

static const struct thud_column storeys[] = {
    OF(DUCTILITY, "ductility",
       "Peak drift of the storey below the floor over its yield drift. This and the following are empty for an elastic "
       "storey, and means over the yielding storeys for floor 0. Its ratio to another run equals that of the drifts."),
    OF(PERMANENT, "permanent_m",
       "Permanent drift at the end (drift at zero force), m; for floor 0 the mean of the absolute values."),
    OF(EXCURSIONS, "excursions", "Number of yield excursions."),
    OF(HYSTERETIC, "hysteretic_j", "Hysteretic energy dissipated in the storey, J."),
    ENDS(DUCTILITY, "ductility", "", ""),
    ENDS(PERMANENT, "permanent", "_m", ", m"),
    ENDS(EXCURSIONS, "excursions", "", ""),
    ENDS(HYSTERETIC, "hysteretic", "_j", ", J"),
    FLOOR(own.collapsed, "collapsed",
          "Last column of every row: 1 if a storey collapses in the run (with P-Delta), else 0. The peaks are then "
          "those up to the collapse, and there are no ratios.")};
const struct thud_schema thud_sweep_storey_schema = THUD_SCHEMA(
    "sweep.csv of storeys",
    "At the end of each row: the last one;\nbefore it, if storeys or isolators of the scene yield, the others.\n",
    storeys);

/* ---- contacts ---- */

struct contact_row {
    const char *record, *which, *struck;
    struct thud_sweep_contact_row own;
};
#define CONTACT(member, key, text) THUD_FIELD(struct contact_row, member, key, text)

static const struct thud_column contacts[] = {
    CONTACT(record, "record", "Ground motion, as specified."),
    CONTACT(which, "case", "Case."),
    CONTACT(own.gap_m, "gap_m", "Gap of the first interface, m."),
    CONTACT(own.level.interface, "interface", "Number of the interface."),
    CONTACT(own.level.left_floor, "left_floor", "Floor on the left of the interface."),
    CONTACT(own.level.right_floor, "right_floor", "Floor on the right of the interface."),
    CONTACT(own.of.impacts, "impacts", "Number of impacts."),
    CONTACT(own.of.force_n, "force_n", "Peak force, N; empty where impulses have none."),
    CONTACT(own.of.indentation_m, "indentation_m", "Peak indentation, m; empty where the force is empty."),
    CONTACT(own.of.impulse_ns, "impulse_ns", "Total impulse of all impacts, N s."),
    CONTACT(own.of.contact_time_s, "contact_time_s",
            "Total duration with a compressive force, s, as in the contacts of a run."),
    CONTACT(own.of.residual_m, "residual_m", "Residual indentation from plastic deformation, m."),
    CONTACT(own.of.residual_gap_m, "residual_gap_m", "Sum of clearance and residual indentation at the end, m."),
    CONTACT(struck, "struck_columns",
            "Side of the columns that a slab strikes (left or right), below the floor named; otherwise empty."),
    CONTACT(own.of.shear_lower_n, "shear_lower_n", "Peak shear at the lower end of those columns, N."),
    CONTACT(own.of.shear_upper_n, "shear_upper_n", "Peak shear at the upper end of those columns, N."),
    CONTACT(own.of.capacity_ratio, "shear_over_capacity", "Larger peak shear over the capacity of those columns."),
    THUD_FIELD_WITH(struct contact_row, own.force_low_n, "force_low_n",
                    "Smallest peak force within the spread of --sensitivity, N.", .only = SPREAD),
    THUD_FIELD_WITH(struct contact_row, own.force_high_n, "force_high_n",
                    "Largest peak force within the spread of --sensitivity, N.", .only = SPREAD),
    THUD_FIELD_WITH(struct contact_row, own.indentation_low_m, "indentation_low_m",
                    "Smallest peak indentation within the spread of --sensitivity, m.", .only = SPREAD),
    THUD_FIELD_WITH(struct contact_row, own.indentation_high_m, "indentation_high_m",
                    "Largest peak indentation within the spread of --sensitivity, m.", .only = SPREAD),
    THUD_STANDS_FOR("KEY", "Value of a varied key other than the gap, in SI units."),
    CONTACT(own.of.moment_lower_nm, "moment_lower_nm",
            "Peak bending moment at the lower end of struck columns, N m; empty where floors meet."),
    CONTACT(own.of.moment_upper_nm, "moment_upper_nm", "Peak bending moment at the upper end of struck columns, N m.")};
const struct thud_schema thud_sweep_contact_schema =
    THUD_SCHEMA("contacts.csv", "Written by\n.Cm sweep Fl o :\na row for each run and contact.\n", contacts);
enum { MOMENTS = 2 }; /* behind the varied keys */

/* ---- needed gaps ---- */

#define NEED(member, key, text) THUD_COLUMN(struct thud_need_fields, member, key, text)
#define RULE(id, key, text)     THUD_COLUMN(struct thud_need_fields, rule[(id) + 1], key, text)

static const struct thud_column needs[] = {
    {NEED(record, "record", "Ground motion, as specified."), .only = THUD_NEED_RECORD},
    {NEED(level.interface, "interface", "Number of the interface.")},
    {NEED(level.left_floor, "left_floor", "Floor on the left of the interface.")},
    {NEED(level.right_floor, "right_floor", "Floor on the right of the interface.")},
    {NEED(level.left_m, "left_displacement_m", "Peak displacement of the left floor without pounding, m.")},
    {NEED(level.right_m, "right_displacement_m", "Peak displacement of the right floor without pounding, m.")},
    {RULE(THUD_GAP_EXACT, "relative_displacement_m", "Required gap: peak relative displacement of the two floors, m.")},
#define THUD_RULE(id, name, column, clause, edition, title, source, formula, numbers, lacks, text, value)              \
    {RULE(id, column, text)},
#include "study/scene/gap_rule_list.h"
    {NEED(level.correlation, "correlation", "Correlation coefficient of DDC; no value where storeys yield.")},
    {NEED(struck, "struck_columns",
          "Side of the columns that a slab faces between two floors (left or right); otherwise empty.")},
#define THUD_RULE_CODE(id, name, column, clause, edition, title, source, formula, numbers, lacks, text, value)         \
    {RULE(id, column, text), .only = THUD_NEED_CODES},
#include "study/scene/gap_rule_list.h"
};
const struct thud_schema thud_need_schema = THUD_SCHEMA(
    "needed-gaps.csv",
    "Written by\n.Cm sweep Fl o\nand\n.Cm gap Fl o ,\nthe latter also with\n.Fl -csv :\nthe smallest gap at which two "
    "floors do not touch, and the gaps of the\ncombination rules: one row for each ground motion and pair of "
    "floors.\nLinks act there unless no case of the study has them.\nFor a sweep, the varied keys that change the "
    "motion without pounding follow.\n",
    needs);

struct thud_need_fields thud_need_fields_of(const struct thud_gap_level *level, const char *record)
{
    struct thud_need_fields row = {.record = record, .struck = thud_struck_name(level->struck), .level = *level};
    for (int rule = THUD_GAP_EXACT; rule < THUD_GAP_RULES; rule++)
        row.rule[rule + 1] = thud_gap_value(level, rule);
    return row;
}

/* ---- of a plan ---- */

/* What the rows of a plan have besides their own values. */
struct form {
    const struct thud_sweep_plan *plan;
    enum thud_sweep_csv which;
    unsigned marks;
    const struct thud_sweep_point *point; /* whose rows they are */
    const char *record;                   /* its ground motion; "" without */
    bool shown[THUD_VARY_MAX]; /* varied keys that no other column shows; of needs only those that change the motion */
    struct thud_made_columns axes;
    struct thud_schema first, last; /* before and behind the varied keys; last.n 0: nothing */
};

static const struct thud_schema *const schemas[THUD_SWEEP_CSVS] = {&thud_sweep_floor_schema, &thud_sweep_contact_schema,
                                                                   &thud_need_schema};

const char *thud_sweep_csv_name(enum thud_sweep_csv which)
{
    return schemas[which]->name;
}

static void make_form(const struct thud_sweep_plan *plan, enum thud_sweep_csv which, struct form *out)
{
    *out = (struct form){.plan = plan,
                         .which = which,
                         .marks = which == THUD_SWEEP_CSV_NEEDS ? (unsigned)THUD_NEED_RECORD
                                  : plan->sensitivity > 0       ? (unsigned)SPREAD
                                                                : 0u,
                         .first = *schemas[which]};
    for (int a = 0; a < plan->naxes; a++)
        out->shown[a] = which == THUD_SWEEP_CSV_NEEDS ? a < plan->nouter : !is_gap(plan->axis[a].key);
    thud_axis_columns(plan, out->shown, &out->axes);
    if (which == THUD_SWEEP_CSV_FLOORS) {
        out->last = thud_sweep_storey_schema;
        if (!(plan->has & (THUD_HAS_YIELDING | THUD_HAS_SLIDING))) { /* the last column alone */
            out->last.column += out->last.n - 1;
            out->last.n = 1;
        }
    } else if (which == THUD_SWEEP_CSV_CONTACTS) {
        out->first.n -= MOMENTS;
        out->last = (struct thud_schema){.column = out->first.column + out->first.n, .n = MOMENTS};
    }
}

static void parts_of(const struct form *form, const void *row, struct thud_part part[3])
{
    part[0] = (struct thud_part){&form->first, form->marks, row};
    part[1] = (struct thud_part){&form->axes.schema, 0, form->axes.cell};
    part[2] = (struct thud_part){&form->last, form->marks, row};
}

void thud_sweep_csv_header(const struct thud_sweep_plan *plan, enum thud_sweep_csv which, struct thud_text *out)
{
    struct form form;
    struct thud_part part[3];
    make_form(plan, which, &form);
    parts_of(&form, NULL, part);
    thud_parts_names(part, 3, out);
}

static void make_floor(const struct form *form, int i, void *out)
{
    struct floor_row *row = out;
    thud_sweep_row_at(form->point, i, &row->own);
    row->record = form->record;
    row->which = thud_case_name(row->own.which);
    row->structure = form->plan->scene.structure[row->own.structure].name;
}

static void make_contact(const struct form *form, int i, void *out)
{
    struct contact_row *row = out;
    thud_sweep_contact_row_at(form->point, i, &row->own);
    row->record = form->record;
    row->which = thud_case_name(row->own.which);
    row->struck = thud_struck_name(row->own.level.struck);
}

static void make_need(const struct form *form, int i, void *out)
{
    *(struct thud_need_fields *)out = thud_need_fields_of(
        &thud_sweep_levels(form->point, thud_sweep_need_case(form->plan->cases, form->plan->ncases))[i], form->record);
}

static int count_rows(const struct form *form)
{
    if (form->which == THUD_SWEEP_CSV_FLOORS)
        return thud_sweep_row_count(form->point);
    if (form->which == THUD_SWEEP_CSV_CONTACTS)
        return thud_sweep_contact_row_count(form->point);
    return thud_sweep_is_first(form->plan, form->point) ? form->point->ncontacts : 0;
}

/* As CSV; or as objects, `any`: one was written before. */
static void put_rows(struct form *form, const struct thud_sweep_point *point, bool *any, struct thud_text *out)
{
    static void (*const make[THUD_SWEEP_CSVS])(const struct form *form, int i, void *out) = {make_floor, make_contact,
                                                                                             make_need};
    int at[THUD_VARY_MAX];
    const int record = thud_sweep_place(form->plan, point->index, at);
    form->point = point;
    form->record = record < form->plan->nrecords && form->plan->record[record] ? form->plan->record[record]->file : "";
    thud_axis_cells(form->plan, form->shown, at, form->axes.cell);
    for (int i = 0; i < count_rows(form); i++) {
        struct thud_row_room row;
        struct thud_part part[3];
        make[form->which](form, i, row.bytes);
        parts_of(form, row.bytes, part);
        if (!any) {
            thud_parts_csv(part, 3, out);
            continue;
        }
        thud_text_append(out, *any ? ",\n  {" : "\n  {");
        thud_parts_json(part, 3, out);
        thud_text_append(out, "}");
        *any = true;
    }
}

void thud_sweep_csv_rows(const struct thud_sweep_plan *plan, enum thud_sweep_csv which,
                         const struct thud_sweep_point *point, struct thud_text *out)
{
    struct form form;
    make_form(plan, which, &form);
    put_rows(&form, point, NULL, out);
}

void thud_sweep_json_rows(const struct thud_sweep_plan *plan, const struct thud_sweep_point *point, bool *any,
                          struct thud_text *out)
{
    struct form form;
    make_form(plan, THUD_SWEEP_CSV_FLOORS, &form);
    put_rows(&form, point, any, out);
}
